//! What an observer must have in sight: the camera and its arrows, the objects around it, and what else is
//! drawn.

use pinhole_core::{
    Camera, DVec2, DVec3, ExactRay, Object, Orientation, Ray, ResolvedCamera, Root, Scene, Sphere,
};

use crate::model::observer::ViewSize;
use crate::model::overlay_items::{Item, OverlayItems};

/// Ratio of sizes above which a sphere is out of scale: its radius exceeds this many times the extent of
/// the camera and of all smaller spheres together. Such a sphere need not be in sight.
const OUT_OF_SCALE: f64 = 50.0;

/// Ratio of a sphere's radius to its distance from the camera below which the sphere counts as a speck.
const SPECK: f64 = 2e-3;

/// Maximum number of spheres and of planes that are considered.
const ASKED_SPHERES: usize = 2048;
const ASKED_PLANES: usize = 64;

/// The part of the frustum that should be in sight. It ends at the first number times the distance of the
/// farthest sphere, but at most at the second number times the distance of the viewport.
const FRUSTUM_PART: f64 = 0.6;
const LONGEST_FRUSTUM: f64 = 3.2;

/// Maximum distance of the observer's target from the camera's eye, as a multiple of
/// [`Surroundings::near_size`]. An observer that turned around a more distant target would lose sight of the
/// camera.
const FARTHEST_MIDDLE: f64 = 15.0;

/// A ball that must be in sight.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The centre.
    pub center: DVec3,
    /// The radius; 0 for a point.
    pub radius: f64,
}

impl Bound {
    pub(super) fn point(center: DVec3) -> Bound {
        Bound { center, radius: 0.0 }
    }

    pub(super) fn contains(&self, point: DVec3) -> bool {
        self.center.distance(point) <= self.radius
    }
}

/// What is drawn besides the camera and the objects.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The overlay items, which decide what of the camera is drawn.
    pub items: OverlayItems,
    /// Points of rays and of a camera that is compared with the edited one.
    pub points: Vec<DVec3>,
    /// Other arrows at the eye: unit vectors, and their lengths as multiples of the basis arrows' length.
    pub arrows: Vec<(DVec3, f64)>,
}

impl From<OverlayItems> for Drawn {
    fn from(items: OverlayItems) -> Drawn {
        Drawn { items, points: Vec::new(), arrows: Vec::new() }
    }
}

/// The camera's eye and the objects around it that are neither out of scale nor too small to be seen.
#[derive(Clone, Debug)]
pub struct Surroundings {
    /// The camera's eye.
    pub eye: DVec3,
    /// The centres and radii of the spheres. One may contain the eye.
    pub spheres: Vec<Bound>,
    /// The spheres that are out of scale, such as a planet on which the camera stands.
    pub planets: Vec<Bound>,
    /// The point halfway between the eye and the spheres.
    pub middle: DVec3,
    /// The distance from the eye to the far side of the spheres, or to the planes that the camera sees.
    pub extent: f64,
    /// The largest of the viewport's width, height and distance.
    near_size: f64,
    /// The points of planes that the camera sees.
    walls: Vec<Root>,
}

impl Surroundings {
    /// Finds the surroundings of a camera.
    pub fn new(camera: &Camera, scene: &Scene) -> Surroundings {
        let eye = if is_tame(camera.eye) { camera.eye } else { DVec3::ZERO };
        let resolved = camera.resolve().ok();
        let near_size = resolved.map_or(1.0, |resolved| near_size(&resolved).clamp(1e-9, 1e12));
        let (spheres, planets) = spheres_in_scale(scene, eye, near_size);
        let around = |ball: &&Bound| !ball.contains(eye);
        let farthest = spheres.iter().filter(around).map(|ball| ball.center.distance(eye));
        let farthest = farthest.fold(0.0, f64::max);
        let walls = resolved.map_or(Vec::new(), |resolved| {
            walls_seen(&resolved, scene, 2.0 * farthest.max(10.0 * near_size))
        });
        let sides = spheres.iter().map(|ball| ball.center.distance(eye) + ball.radius);
        let hits = walls.iter().map(|hit| hit.point.distance(eye));
        let extent = sides.chain(hits).fold(near_size, f64::max);
        let seen: Vec<DVec3> = spheres.iter().filter(around).map(|ball| ball.center).collect();
        let seen = if seen.is_empty() { walls.iter().map(|hit| hit.point).collect() } else { seen };
        let sum: DVec3 = seen.iter().sum();
        let mean = if seen.is_empty() { eye } else { sum / seen.len() as f64 };
        let middle = eye + (0.5 * (mean - eye)).clamp_length_max(FARTHEST_MIDDLE * near_size);
        Surroundings { eye, spheres, planets, middle, extent, near_size, walls }
    }
}

/// Everything that must be in sight, and the camera.
pub(super) struct Subject {
    pub(super) balls: Vec<Bound>,
    pub(super) arrows: Arrows,
    pub(super) eye: DVec3,
    /// Direction from the scene to the camera: the camera's w, or +z for an invalid camera.
    pub(super) back: DVec3,
    /// The camera's right.
    pub(super) right: DVec3,
    /// The largest of the viewport's width, height and distance.
    pub(super) near_size: f64,
    /// The points of planes that the camera sees.
    pub(super) walls: Vec<Root>,
    /// The spheres that are out of scale. They need not be in sight, but their horizon should be.
    pub(super) planets: Vec<Bound>,
    /// The point around which the observer turns, halfway between the camera's eye and the objects.
    pub(super) middle: DVec3,
}

impl Subject {
    pub(super) fn new(camera: &Camera, scene: &Scene, items: OverlayItems) -> Subject {
        let Surroundings { eye, mut spheres, planets, middle, near_size, walls, .. } =
            Surroundings::new(camera, scene);
        let resolved = camera.resolve().ok();
        let (back, right) = resolved
            .map_or((DVec3::Z, DVec3::X), |resolved| (resolved.basis().w, resolved.basis().u));
        // A sphere that contains the eye cannot be wholly in sight of an observer near the camera.
        spheres.retain(|ball| !ball.contains(eye));
        let farthest = spheres.iter().map(|ball| ball.center.distance(eye)).fold(0.0, f64::max);
        let mut points = vec![eye];
        points.extend(given_at(camera));
        if let Some(resolved) = resolved {
            points.extend(frustum_corners(&resolved, 1.0));
            if items.shows(Item::Frustum) {
                let t =
                    (FRUSTUM_PART * farthest / resolved.viewport().distance).min(LONGEST_FRUSTUM);
                points.extend(frustum_corners(&resolved, t));
            }
        }
        points.extend(walls.iter().map(|hit| hit.point));
        points.retain(|point| is_tame(*point));
        let balls = points.into_iter().map(Bound::point).chain(spheres).collect();
        let arrows = Arrows::new(camera, items);
        Subject { balls, arrows, eye, back, right, near_size, walls, planets, middle }
    }
}

fn is_tame(point: DVec3) -> bool {
    point.is_finite() && point.abs().max_element() < 1e12
}

/// Returns the point at; `None` if the camera is given by a view direction or a basis instead.
pub(super) fn given_at(camera: &Camera) -> Option<DVec3> {
    match camera.orientation {
        Orientation::At { at, .. } => Some(at),
        Orientation::View { .. } | Orientation::Basis(_) => None,
    }
}

/// Returns the largest of the viewport's width, height and distance.
fn near_size(resolved: &ResolvedCamera) -> f64 {
    let viewport = resolved.viewport();
    viewport.width.max(viewport.height).max(viewport.distance)
}

/// Returns the points at parameter `t` on the four edges of the frustum, where t = 1 is on the viewport.
pub(super) fn frustum_corners(resolved: &ResolvedCamera, t: f64) -> [DVec3; 4] {
    rays_around(resolved, 1.0).map(|ray| ray.at(t))
}

/// Returns the first hits with planes, nearer than `farthest`, of the four rays through the points halfway
/// from the viewport's middle to its corners.
fn walls_seen(resolved: &ResolvedCamera, scene: &Scene, farthest: f64) -> Vec<Root> {
    let first_wall = |ray: &Ray| {
        let planes = (0..).zip(scene.planes()).take(ASKED_PLANES);
        let hits = planes.filter_map(|(index, plane)| {
            Object::Plane(*plane).first_hit(index, &ExactRay::from_ray(ray).ok()?)
        });
        hits.min_by(|a, b| a.t.total_cmp(&b.t)).filter(|hit| ray.distance_along(hit.t) < farthest)
    };
    rays_around(resolved, 0.5).iter().filter_map(first_wall).collect()
}

/// Returns the rays through the four points of the viewport that are this fraction of the way from its
/// middle to its corners.
fn rays_around(resolved: &ResolvedCamera, share: f64) -> [Ray; 4] {
    let half = 0.5 * share * DVec2::new(resolved.viewport().width, resolved.viewport().height);
    [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
        .map(|(x, y)| resolved.ray(half * DVec2::new(x, y)))
}

/// Returns the first `ASKED_SPHERES` spheres of the scene.
pub(super) fn balls_of(scene: &Scene) -> impl Iterator<Item = Bound> {
    let ball = |sphere: &Sphere| Bound { center: sphere.center, radius: sphere.radius };
    scene.spheres().iter().take(ASKED_SPHERES).map(ball)
}

/// Returns the spheres by ascending radius, up to the first one that is out of scale with the smaller ones;
/// and the remaining ones.
fn spheres_in_scale(scene: &Scene, eye: DVec3, near_size: f64) -> (Vec<Bound>, Vec<Bound>) {
    let mut balls: Vec<Bound> = balls_of(scene).filter(|ball| is_tame(ball.center)).collect();
    balls.sort_by(|a, b| a.radius.total_cmp(&b.radius));
    let mut extent = near_size;
    let in_scale = balls.iter().take_while(|ball| {
        let fits = ball.radius <= OUT_OF_SCALE * extent;
        if fits {
            extent = extent.max((ball.center - eye).length() + ball.radius);
        }
        fits
    });
    let planets = balls.split_off(in_scale.count());
    // A distant speck must not move the observer so far away that everything else becomes a speck.
    let can_be_seen = |ball: &Bound| ball.radius >= SPECK * (ball.center - eye).length();
    if balls.iter().any(can_be_seen) {
        balls.retain(can_be_seen);
    }
    (balls, planets)
}

/// Length of the up arrow, as a multiple of the basis arrows' length.
pub const UP_LENGTH: f64 = 1.35;

/// Length of the view arrow, as a multiple of the basis arrows' length. It differs from the up arrow's, so
/// that arrows with the same direction do not hide each other.
pub const VIEW_LENGTH: f64 = 1.6;

/// Length of the arrows of the world's axes, as a multiple of the basis arrows' length.
pub const AXIS_LENGTH: f64 = 1.6;

/// Space that is kept free beyond the corner of an area for its caption, as a multiple of the basis arrows'
/// length.
const CAPTION: f64 = 0.2;

/// Returns the length at which a factor of a cross product is drawn, as a multiple of the basis arrows'
/// length: its own, but 1 if it is much shorter or longer than they are.
pub fn side_length(length: f64) -> f64 {
    if (0.4..=2.0).contains(&length) { length } else { 1.0 }
}

/// Space that is kept free beyond an arrow's tip for its handle and its label: the radius in points, and
/// its maximum as a fraction of the view's height.
const TIP_ROOM: f64 = 26.0;
const TIP_ROOM_SHARE: f64 = 0.08;

/// The arrows that are drawn, and the far corners of the areas between them. Each arrow at the eye is stored
/// as a unit vector and its length, a multiple of the basis arrows' length. The world's axes, which start at
/// the origin, are included if the camera is near them.
pub(super) struct Arrows {
    pub(super) at_eye: Vec<(DVec3, f64)>,
    has_axes: bool,
}

impl Arrows {
    fn new(camera: &Camera, items: OverlayItems) -> Arrows {
        let mut at_eye = Vec::new();
        let mut has_axes = false;
        if let Ok(resolved) = camera.resolve() {
            let basis = resolved.basis();
            let axes = [basis.u, basis.v, basis.w].into_iter().zip(items.of_basis());
            let drawn = axes.filter(|(_, item)| items.shows(*item));
            at_eye.extend(drawn.map(|(axis, _)| (axis, 1.0)));
            has_axes = items.shows(Item::Axes) && camera.eye.length() <= near_size(&resolved);
        }
        if items.shows(Item::ViewAndUp) && camera.orientation.has_up() {
            let given = [(camera.view(), VIEW_LENGTH), (camera.up(), UP_LENGTH)];
            at_eye.extend(given.into_iter().filter_map(|(vector, times)| {
                let scaled = vector / vector.abs().max_element();
                scaled.is_finite().then(|| (scaled.normalize(), times))
            }));
        }
        if let (true, Ok(resolved)) = (camera.orientation.has_up(), camera.resolve()) {
            let (basis, up) = (resolved.basis(), camera.up());
            let up = side_length(up.length()) * up.normalize_or_zero();
            let sides = [(Item::UpCrossW, up), (Item::WCrossU, basis.u)];
            let corners = sides.into_iter().filter(|(item, _)| items.shows(*item));
            let corners = corners.map(|(_, side)| side + basis.w);
            let tips =
                corners.map(|corner| (corner.normalize_or_zero(), CAPTION + corner.length()));
            at_eye.extend(tips);
        }
        let looks = camera.view().normalize_or_zero();
        if items.shows(Item::ViewVector) && !camera.orientation.has_at() {
            at_eye.push((-looks, VIEW_LENGTH));
        }
        if items.shows(Item::Eye) {
            // The eye has no arrow, but a label.
            at_eye.push((DVec3::ZERO, 0.0));
        }
        Arrows { at_eye, has_axes }
    }

    /// Returns a ball around each arrow's tip that leaves space for its label. `depth` is the depth of the
    /// eye in front of the observer.
    pub(super) fn tips(
        &self,
        eye: DVec3,
        depth: f64,
        size: ViewSize,
    ) -> impl Iterator<Item = Bound> + '_ {
        let per_point = size.world_per_point(depth.max(1e-12));
        let (least, most) = size.arrow_points();
        let length = 1.0_f64.clamp(least * per_point, most * per_point);
        let axes = DVec3::AXES.map(|axis| AXIS_LENGTH * length * axis);
        let axes = axes.into_iter().filter(|_| self.has_axes);
        let tips = self.at_eye.iter().map(move |(axis, times)| eye + times * length * *axis);
        let room = TIP_ROOM.min(TIP_ROOM_SHARE * size.height);
        tips.chain(axes).map(move |center| Bound { center, radius: room * per_point })
    }
}
