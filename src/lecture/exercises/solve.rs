//! Calculates the right answers to every question, and the answers to which classic mistakes lead.

use pinhole_core::{
    Basis, Camera, DVec2, DVec3, Orientation, Pixel, Plane, Ray, Roots, Sphere, Viewport,
};

use crate::exercises::judge::{Condition, Surface, is_near};
use crate::exercises::question::{Answer, Asked, Given, QuestionPart};
use crate::mistakes::{GivenCamera, Mistake, PipelineCamera};

/// Returns the parts of a question, each with its right answer and the wrong ones to which mistakes
/// lead; `None` if a basis does not exist or the ray misses the sphere. A mistake that gives the right
/// answer is left out.
pub(super) fn parts(given: &Given) -> Option<Vec<QuestionPart>> {
    let (mut parts, wrongs) = match *given {
        Given::Uv(uv) => ray_through(uv),
        Given::UvAndWall { uv, z } => ray_and_wall(uv, z),
        Given::Distance { uv, distance, z } => wall_at_distance(uv, distance, z),
        Given::Turned { right, uv, z } => basis_by_hand(right, uv, z),
        Given::ViewUp { .. } | Given::EyeAtUp { .. } => basis_from_up(given)?,
        Given::Sphere { ray, sphere } => ray_and_sphere(&ray, &sphere)?,
        Given::Lines { line, origin, direction } => two_lines(line, origin, direction),
        Given::Pixel { pixel, from_one, .. } => uv_of_pixel(&camera(given)?, pixel, from_one)?,
        Given::PointAt { eye, uv, t } => point_at(eye, uv, t),
        Given::Coefficients { ray, sphere } => coefficients(&ray, &sphere),
    };
    for (mistake, asked, answer) in wrongs {
        let part = parts.iter_mut().find(|part| part.asked == asked);
        if let Some(part) = part.filter(|part| is_another(&part.truth, &answer)) {
            part.mistakes.push((mistake, answer));
        }
    }
    Some(parts)
}

fn is_another(truth: &Answer, answer: &Answer) -> bool {
    match (truth, answer) {
        (Answer::Numbers(truth), Answer::Numbers(answer)) => {
            answer.iter().all(|x| x.is_finite()) && !is_near(answer, truth)
        }
        (truth, answer) => truth != answer,
    }
}

/// A mistake, a quantity, and the wrong answer for that quantity that results from the mistake.
type Wrong = (Mistake, Asked, Answer);

/// The parts of a question, and the wrong answers that result from mistakes.
type Parts = (Vec<QuestionPart>, Vec<Wrong>);

/// Returns the camera of a question; `None` if it has none. The question's ray is this camera's ray
/// through the question's (u, v), or through the viewport's centre.
pub(super) fn camera(given: &Given) -> Option<Camera> {
    let looking = |view| Orientation::View { view, up: DVec3::Y };
    Some(match *given {
        Given::Uv(_) | Given::UvAndWall { .. } => Camera::CANONICAL,
        Given::Distance { distance, .. } => camera_at(DVec3::ZERO, looking(DVec3::NEG_Z), distance),
        Given::Turned { right, .. } => {
            camera_at(DVec3::ZERO, Orientation::Basis(turned(right)), 1.0)
        }
        Given::ViewUp { view, up } => camera_at(DVec3::ZERO, Orientation::View { view, up }, 1.0),
        Given::EyeAtUp { eye, at, up } => camera_at(eye, Orientation::At { at, up }, 1.0),
        Given::Pixel { image, .. } => Camera { image, ..Camera::CANONICAL },
        Given::PointAt { eye, .. } => camera_at(eye, looking(DVec3::NEG_Z), 1.0),
        Given::Sphere { ray: Ray { origin, direction }, .. }
        | Given::Coefficients { ray: Ray { origin, direction }, .. } => {
            let up = if direction.x == 0.0 && direction.z == 0.0 { DVec3::Z } else { DVec3::Y };
            let orientation = Orientation::View { view: direction, up };
            camera_at(origin, orientation, direction.length())
        }
        Given::Lines { .. } => return None,
    })
}

/// Returns the plane with this z, with its normal towards the origin.
pub(super) fn wall(z: f64) -> Plane {
    Plane { point: DVec3::new(0.0, 0.0, z), normal: DVec3::new(0.0, 0.0, -z.signum()) }
}

fn part(asked: Asked, truth: Answer) -> QuestionPart {
    QuestionPart {
        asked,
        truth,
        may_be_scaled: false,
        mistakes: Vec::new(),
        orthogonal_to: Vec::new(),
        conditions: Vec::new(),
    }
}

/// Returns a part whose answer must meet these conditions.
fn part_with(asked: Asked, truth: Answer, conditions: Vec<Condition>) -> QuestionPart {
    QuestionPart { conditions, ..part(asked, truth) }
}

fn number(x: f64) -> Answer {
    Answer::Numbers(vec![x])
}

fn vector(v: DVec3) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

fn pair(v: DVec2) -> Answer {
    Answer::Numbers(v.to_array().to_vec())
}

/// Returns the ray from the origin through a point of the viewport, with the direction
/// `u U + v V - distance W`.
fn view_ray(basis: Basis, distance: f64, uv: DVec2) -> Ray {
    let Basis { u, v, w } = basis;
    Ray { origin: DVec3::ZERO, direction: uv.x * u + uv.y * v - distance * w }
}

/// Returns the t at which a ray from the origin meets the plane with this z. No question has a ray that
/// is parallel to the plane: |u| is below 1, so `-distance W` outweighs `u U` in z.
fn t_of_wall(ray: &Ray, z: f64) -> f64 {
    z / ray.direction.z
}

/// Returns the two wrong answers of a mistake in t: t itself, and the point that is calculated from it.
fn wrong_t(mistake: Mistake, t: f64, point: Answer) -> [Wrong; 2] {
    [(mistake, Asked::T, number(t)), (mistake, Asked::Point, point)]
}

/// Returns the two wrong answers of a mistake in the direction: the direction itself, and the t at
/// which the ray in this direction meets the wall with this z.
fn wrong_direction(mistake: Mistake, d: DVec3, z: f64) -> [Wrong; 2] {
    [(mistake, Asked::Direction, vector(d)), (mistake, Asked::T, number(z / d.z))]
}

/// Returns the canonical camera with a different eye, orientation and distance.
fn camera_at(eye: DVec3, orientation: Orientation, distance: f64) -> Camera {
    let viewport = Viewport { distance, ..Viewport::CANONICAL };
    Camera { eye, orientation, viewport, ..Camera::CANONICAL }
}

/// Returns a basis that is turned about the y axis: u is `right`, v is the y axis, and w is their cross
/// product.
fn turned(right: DVec3) -> Basis {
    Basis { u: right, v: DVec3::Y, w: right.cross(DVec3::Y) }
}

/// Returns the part of a question about the centre of a pixel of a canonical camera; `None` if the camera
/// has no basis.
fn uv_of_pixel(camera: &Camera, pixel: Pixel, from_one: bool) -> Option<Parts> {
    let DVec2 { x: u, y: v } = camera.resolve().ok()?.uv_of_pixel(pixel);
    let size = DVec2::new(camera.image.width().into(), camera.image.height().into());
    // The same formula for any place of the image, counted from 0: whole numbers are corners.
    let at = |column, row| (DVec2::new(column, row) / size - 0.5) * DVec2::new(1.0, -1.0);
    let (i, j) = (f64::from(pixel.row), f64::from(pixel.column));
    let other = if from_one { 1.5 } else { -0.5 };
    let corner = at(0.0, 0.0);
    let wrongs = [
        (Mistake::CountedFromOther, at(j + other, i + other)),
        (Mistake::PixelCorner, at(j, i)),
        (Mistake::PixelCorner, at(j + 1.0, i + 1.0)),
        (Mistake::RowsColumnsSwapped, at(i + 0.5, j + 0.5)),
        (Mistake::VDown, DVec2::new(u, -v)),
        (Mistake::ULeft, DVec2::new(-u, v)),
        (Mistake::UvSwapped, DVec2::new(v, u)),
        (Mistake::UvFromCorner, DVec2::new(u - corner.x, v - corner.y)),
        (Mistake::UvFromCorner, DVec2::new(u - corner.x, corner.y - v)),
    ];
    let from = if from_one { 1.0 } else { 0.0 };
    let condition = Condition::Pixel { size, place: DVec2::new(j, i) + from, first: from - 0.5 };
    Some((
        vec![part_with(Asked::Uv, pair(DVec2::new(u, v)), vec![condition])],
        wrongs.map(|(mistake, uv)| (mistake, Asked::Uv, pair(uv))).to_vec(),
    ))
}

fn point_at(eye: DVec3, uv: DVec2, t: f64) -> Parts {
    let ray = Ray { origin: eye, ..view_ray(Basis::CANONICAL, 1.0, uv) };
    let Ray { origin: p, direction: d } = ray;
    let wrongs = [
        (Mistake::OriginLeftOut, t * d),
        (Mistake::TAlongUnit, p + t * d.normalize()),
        (Mistake::TOnAll, t * (p + d)),
        (Mistake::PAndDSwapped, d + t * p),
    ];
    let conditions = vec![Condition::OnRay(ray), Condition::At(ray, t)];
    (
        vec![part_with(Asked::Point, vector(ray.at(t)), conditions)],
        wrongs.map(|(mistake, point)| (mistake, Asked::Point, vector(point))).to_vec(),
    )
}

fn ray_through(uv: DVec2) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let parts = vec![
        part_with(Asked::Origin, vector(ray.origin), vec![Condition::Eye(ray.origin)]),
        QuestionPart {
            may_be_scaled: true,
            ..part_with(Asked::Direction, vector(ray.direction), vec![through(1.0, uv)])
        },
    ];
    let p = |x, y, z| (Mistake::ViewportForEye, Asked::Origin, vector(DVec3::new(x, y, z)));
    let mut wrongs = vec![p(0.0, 0.0, -1.0), p(uv.x, uv.y, -1.0), p(uv.x, uv.y, 0.0)];
    let d = |(mistake, d)| (mistake, Asked::Direction, vector(d));
    wrongs.extend(wrong_directions(uv, 1.0).map(d));
    (parts, wrongs)
}

fn through(distance: f64, uv: DVec2) -> Condition {
    Condition::Through { basis: Basis::CANONICAL, distance, uv }
}

/// Returns common wrong answers for the direction of a canonical camera's ray.
fn wrong_directions(uv: DVec2, distance: f64) -> impl Iterator<Item = (Mistake, DVec3)> {
    let DVec2 { x: u, y: v } = uv;
    let flat = Mistake::FlatDirection;
    [
        (Mistake::SignOfZ, DVec3::new(u, v, distance)),
        (flat, flat.usual().direction(DVec3::AXES, distance, uv)),
        (Mistake::UvSwapped, DVec3::new(v, u, -distance)),
        (Mistake::VDown, DVec3::new(u, -v, -distance)),
        (Mistake::ULeft, DVec3::new(-u, v, -distance)),
        (Mistake::UvLeftOut, DVec3::new(0.0, 0.0, -distance)),
    ]
    .into_iter()
}

/// Returns common wrong answers for the t at which a ray meets a wall, each with the point at that t.
fn wrong_t_of_wall(ray: &Ray, t: f64, z: f64) -> Vec<Wrong> {
    [
        (Mistake::SignOfT, -t),
        (Mistake::CoordinateForT, z),
        (Mistake::CoordinateForT, -z),
        (Mistake::TForDistance, ray.distance_along(t)),
        (Mistake::TInverted, 1.0 / t),
        (Mistake::FromViewport, t - 1.0),
    ]
    .into_iter()
    .flat_map(|(mistake, t)| wrong_t(mistake, t, vector(ray.at(t))))
    .collect()
}

fn ray_and_wall(uv: DVec2, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let point = ray.at(t);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
        part_with(
            Asked::Point,
            vector(point),
            vec![Condition::On(Surface::Wall(z)), Condition::OnRay(ray)],
        ),
    ];
    let mut wrongs = wrong_t_of_wall(&ray, t, z);
    // The t and the point of each wrong ray.
    wrongs.extend(wrong_directions(uv, 1.0).flat_map(|(mistake, d)| {
        let t = z / d.z;
        wrong_t(mistake, t, vector(t * d))
    }));
    // In the one, the z of t d has the wrong sign; in the other, only z is multiplied by t.
    let mirrored = DVec3::new(point.x, point.y, -z);
    wrongs.push((Mistake::SignOfZ, Asked::Point, vector(mirrored)));
    wrongs.push((Mistake::UvUnscaled, Asked::Point, vector(uv.extend(z))));
    (parts, wrongs)
}

fn wall_at_distance(uv: DVec2, distance: f64, z: f64) -> Parts {
    let ray = view_ray(Basis::CANONICAL, distance, uv);
    let t = t_of_wall(&ray, z);
    let parts = vec![
        part_with(Asked::Direction, vector(ray.direction), vec![through(distance, uv)]),
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
    ];
    let scaled = distance * uv;
    let dropped = Mistake::DistanceDropped;
    let of_distance = [
        (dropped, dropped.usual().direction(DVec3::AXES, distance, uv)),
        (Mistake::DistanceOnAll, scaled.extend(-distance)),
        (Mistake::DistanceOnUv, scaled.extend(-1.0)),
        (Mistake::ViewportAtOne, (uv / distance).extend(-1.0)),
    ];
    let directions = of_distance.into_iter().chain(wrong_directions(uv, distance));
    let mut wrongs: Vec<Wrong> =
        directions.flat_map(|(mistake, d)| wrong_direction(mistake, d, z)).collect();
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    wrongs.push((Mistake::FromViewport, Asked::T, number(-z - distance)));
    (parts, wrongs)
}

fn basis_by_hand(right: DVec3, uv: DVec2, z: f64) -> Parts {
    let Basis { u, v, w } = turned(right);
    let ray = view_ray(Basis { u, v, w }, 1.0, uv);
    let t = t_of_wall(&ray, z);
    let through = Condition::Through { basis: Basis { u, v, w }, distance: 1.0, uv };
    let parts = vec![
        QuestionPart { orthogonal_to: vec![("𝐰", w)], ..part(Asked::U, vector(u)) },
        QuestionPart { orthogonal_to: vec![("𝐮", u), ("𝐰", w)], ..part(Asked::V, vector(v)) },
        QuestionPart { orthogonal_to: vec![("𝐮", u)], ..part(Asked::W, vector(w)) },
        part_with(Asked::Direction, vector(ray.direction), vec![through]),
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, Surface::Wall(z))]),
    ];
    let direction = |mistake, d: DVec3| wrong_direction(mistake, d, z).to_vec();
    let basis = |mistake, u: DVec3, v: DVec3, w: DVec3| {
        let mut wrongs = direction(mistake, uv.x * u + uv.y * v - w);
        wrongs.extend(wrong_basis(mistake, u, v, w));
        wrongs
    };
    // Right without normalization, with length √2 or √½: the sum of the two axes, or their mean.
    let sum = |v: DVec3| v.signum() * v.abs().ceil();
    let other_way = turned(DVec3::new(right.x, right.y, -right.z));
    let mut wrongs = [
        basis(Mistake::WForwards, u, v, -w),
        basis(Mistake::ULeftwards, -u, v, w),
        basis(Mistake::VIsUCrossW, u, -v, w),
        basis(Mistake::UAndWSwapped, w, v, u),
        basis(Mistake::TurnedOtherWay, other_way.u, other_way.v, other_way.w),
        basis(Mistake::BasisUnnormalized, sum(u), v, sum(w)),
        basis(Mistake::BasisUnnormalized, 0.5 * sum(u), v, 0.5 * sum(w)),
        direction(
            Mistake::DistanceAdded,
            Mistake::DistanceAdded.usual().direction([u, v, w], 1.0, uv),
        ),
        direction(Mistake::BasisForgotten, uv.extend(-1.0)),
        direction(Mistake::ZIsMinusDistance, DVec3 { z: -1.0, ..ray.direction }),
        direction(Mistake::UvSwapped, uv.y * u + uv.x * v - w),
        direction(Mistake::VDown, uv.x * u - uv.y * v - w),
        direction(Mistake::ULeft, -uv.x * u + uv.y * v - w),
        direction(Mistake::FlatDirection, uv.x * u + uv.y * v),
        direction(Mistake::UvLeftOut, -w),
    ]
    .concat();
    wrongs.extend(wrong_t_of_wall(&ray, t, z));
    (parts, wrongs)
}

fn wrong_basis(mistake: Mistake, u: DVec3, v: DVec3, w: DVec3) -> [Wrong; 3] {
    [(Asked::U, u), (Asked::V, v), (Asked::W, w)].map(|(asked, v)| (mistake, asked, vector(v)))
}

/// Returns the parts of a question about a basis that is found from view or at, and up; `None` if up
/// does not determine a basis.
fn basis_from_up(given: &Given) -> Option<Parts> {
    let camera = camera(given)?;
    let Basis { u, v, w } = camera.basis().ok()?;
    // The parts are in the order in which a student calculates them.
    let parts = vec![
        part(Asked::W, vector(w)),
        QuestionPart {
            orthogonal_to: vec![("up", camera.up()), ("𝐰", w)],
            ..part(Asked::U, vector(u))
        },
        QuestionPart { orthogonal_to: vec![("𝐰", w), ("𝐮", u)], ..part(Asked::V, vector(v)) },
    ];
    // Mistakes that can be seen in the answer come before those that may have caused them.
    let mut wrongs = wrong_basis(Mistake::ULeftwards, -u, v, w).to_vec();
    for (mistake, made) in wrong_cameras(&camera) {
        wrongs.extend(wrong_basis(mistake, made.u, made.v, made.w));
    }
    wrongs.extend(wrong_basis(Mistake::UAndVSwapped, v, u, w));
    for (mistake, back) in wrong_points(&camera) {
        if let Ok(Basis { u, v, w }) = Basis::from_view_up(-back, camera.up()) {
            wrongs.extend(wrong_basis(mistake, u, v, w));
        }
    }
    Some((parts, wrongs))
}

/// Returns the wrong cameras that are common in answers, each with the mistake that leads to it.
fn wrong_cameras(camera: &Camera) -> impl Iterator<Item = (Mistake, PipelineCamera)> {
    const USUAL: usize = 1;
    let is_at = camera.orientation.has_at();
    // If the camera is given by points, the common wrong w is made from at - eye.
    let w_forwards = if is_at { Mistake::WIsAtMinusEye } else { Mistake::WAsPrinted };
    let mistakes = [
        (w_forwards, USUAL),
        (Mistake::VIsUCrossW, USUAL),
        (Mistake::UIsWCrossUp, USUAL),
        (Mistake::LeftHanded, USUAL),
        (Mistake::NotNormalized, USUAL),
        (Mistake::WNotNormalized, USUAL),
        (Mistake::UpAsV, usize::MAX),
        (Mistake::NothingNormalized, usize::MAX),
        (Mistake::WIsView, usize::MAX),
    ];
    let given = GivenCamera::new(camera).ok();
    given.into_iter().flat_map(move |given| {
        mistakes.into_iter().flat_map(move |(mistake, ways)| {
            let pipelines = mistake.pipelines().take(ways);
            pipelines.map(move |pipeline| (mistake, given.camera_of(pipeline)))
        })
    })
}

/// Returns common wrong values of `eye - at`, each with the mistake that leads to it.
fn wrong_points(camera: &Camera) -> impl Iterator<Item = (Mistake, DVec3)> {
    let eye = camera.eye;
    let wrong = move |at: DVec3| {
        [(Mistake::EyeForgotten, -at), (Mistake::AtForgotten, eye), (Mistake::EyePlusAt, eye + at)]
    };
    let at = match camera.orientation {
        Orientation::At { at, .. } => Some(at),
        _ => None,
    };
    at.into_iter().flat_map(wrong)
}

/// Returns the parts of a question about a ray and a sphere; `None` if the ray's line misses the
/// sphere.
fn ray_and_sphere(ray: &Ray, sphere: &Sphere) -> Option<Parts> {
    let roots = sphere.roots(ray);
    let t = roots.iter().next()?;
    let normal = |point: DVec3| (point - sphere.center) / sphere.radius;
    let point = ray.at(t);
    let n = normal(point);
    let surface = Surface::Sphere(*sphere);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(*ray, surface)]),
        part_with(
            Asked::Point,
            vector(point),
            vec![Condition::On(surface), Condition::OnRay(*ray)],
        ),
        part(Asked::Normal, vector(n)),
    ];
    let mut wrongs: Vec<Wrong> = Vec::new();
    if let Roots::Two(_, far) = roots {
        wrongs.extend(wrong_t(Mistake::FarRoot, far, vector(ray.at(far))));
        wrongs.push((Mistake::FarRoot, Asked::Normal, vector(normal(ray.at(far)))));
    }
    let ts = wrong_roots(ray, sphere)
        .into_iter()
        .chain([(Mistake::TForDistance, ray.distance_along(t)), (Mistake::SignOfT, -t)]);
    wrongs.extend(ts.flat_map(|(mistake, t)| wrong_t(mistake, t, vector(ray.at(t)))));
    let normals = [
        (Mistake::NormalInwards, -n),
        (Mistake::NormalInwards, -sphere.radius * n),
        (Mistake::Unnormalized, sphere.radius * n),
        (Mistake::NormalAgainstRay, -ray.direction.normalize()),
        (Mistake::NormalFromOrigin, point.normalize_or_zero()),
    ];
    wrongs.extend(normals.map(|(mistake, n)| (mistake, Asked::Normal, vector(n))));
    Some((parts, wrongs))
}

/// Returns wrong values of t for a ray and a sphere, each with the mistake in solving `a t^2 + 2 b t +
/// c = 0` that leads to it. A value is NaN if its discriminant is negative.
fn wrong_roots(ray: &Ray, sphere: &Sphere) -> [(Mistake, f64); 8] {
    let oc = ray.origin - sphere.center;
    let (a, b) = (ray.direction.length_squared(), ray.direction.dot(oc));
    let c = oc.length_squared() - sphere.radius * sphere.radius;
    let unsquared = oc.length_squared() - sphere.radius;
    let by_formula = |mistake: Mistake| {
        let quadratic = mistake.usual().quadratic;
        let roots = quadratic.roots(quadratic.a(a), b, c);
        (mistake, roots.map_or(f64::NAN, |[near, _]| near))
    };
    [
        by_formula(Mistake::SignOfB),
        by_formula(Mistake::BForHalfB),
        by_formula(Mistake::HalfBForB),
        (Mistake::RadiusNotSquared, (-b - (b * b - a * unsquared).sqrt()) / a),
        by_formula(Mistake::ALeftOut),
        (Mistake::RootLeftOut, -b / a),
        by_formula(Mistake::DividedBy2A),
        by_formula(Mistake::DividedByA),
    ]
}

/// Returns the parts of a question about `a t^2 + 2 b t + c = 0`, the equation for t of a ray and a
/// sphere.
fn coefficients(ray: &Ray, sphere: &Sphere) -> Parts {
    let (p, d, r) = (ray.origin, ray.direction, sphere.radius);
    let of = |oc: DVec3| [d.dot(d), d.dot(oc), oc.dot(oc) - r * r];
    let discriminant = |[a, b, c]: [f64; 3]| b * b - a * c;
    let [a, b, c] = of(p - sphere.center);
    let all = |[a, b, c]: [f64; 3], d| {
        [(Asked::A, a), (Asked::B, b), (Asked::C, c), (Asked::Discriminant, d)]
    };
    let formulas = ["𝐝 · 𝐝", "𝐝 · (𝐩 − centre)", "|𝐩 − centre|² − 𝑟²", "𝑏² − 𝑎𝑐"];
    let parts = all([a, b, c], discriminant([a, b, c])).into_iter().zip(formulas);
    let parts = parts.map(|((asked, truth), formula)| {
        part_with(asked, number(truth), vec![Condition::Formula(formula)])
    });
    let full = 4.0 * discriminant([a, b, c]);
    let made = |mistake, abc| (mistake, abc, discriminant(abc));
    let wrongs = [
        made(Mistake::ALeftOut, [1.0, b, c]),
        (Mistake::BForHalfB, [a, 2.0 * b, c], full),
        made(Mistake::BForHalfB, [a, 2.0 * b, c]),
        made(Mistake::CenterMinusP, [a, -b, c]),
        made(Mistake::SignOfC, [a, b, -c]),
        made(Mistake::RadiusNotSquared, [a, b, c + r * r - r]),
        made(Mistake::RadiusLeftOut, [a, b, c + r * r]),
        made(Mistake::CenterLeftOut, of(p)),
        made(Mistake::OriginLeftOut, of(-sphere.center)),
        (Mistake::FullDiscriminant, [a, b, c], full),
    ];
    let wrongs = wrongs
        .into_iter()
        .flat_map(|(mistake, abc, d)| all(abc, d).map(|(asked, x)| (mistake, asked, number(x))));
    (parts.collect(), wrongs.collect())
}

fn two_lines(line: DVec3, origin: DVec2, direction: DVec2) -> Parts {
    let (normal, c) = (line.truncate(), line.z);
    let (gap, step) = (normal.dot(origin) + c, normal.dot(direction));
    let at = |t: f64| pair(origin + t * direction);
    let t = -gap / step;
    let ray = Ray { origin: origin.extend(0.0), direction: direction.extend(0.0) };
    let surface = Surface::Line(line);
    let parts = vec![
        part_with(Asked::T, number(t), vec![Condition::Meets(ray, surface)]),
        part_with(Asked::Point, at(t), vec![Condition::On(surface), Condition::OnRay(ray)]),
        part(Asked::Hits, Answer::Yes(t > 0.0)),
    ];
    let mut wrongs: Vec<Wrong> = [
        (Mistake::SignOfT, -t),
        (Mistake::CLeftOut, -normal.dot(origin) / step),
        (Mistake::SignOfC, (c - normal.dot(origin)) / step),
        (Mistake::OriginLeftOut, -c / step),
        (Mistake::TInverted, 1.0 / t),
        (Mistake::NotDivided, -gap),
        (Mistake::TermLeftOut, -gap / (normal.x * direction.x)),
        (Mistake::TermLeftOut, -gap / (normal.y * direction.y)),
        (Mistake::PAndDSwapped, -(step + c) / normal.dot(origin)),
    ]
    .into_iter()
    .flat_map(|(mistake, t)| wrong_t(mistake, t, at(t)))
    .collect();
    wrongs.push((Mistake::OriginLeftOut, Asked::Point, pair(t * direction)));
    wrongs.push((Mistake::LineForRay, Asked::Hits, Answer::Yes(t <= 0.0)));
    (parts, wrongs)
}
