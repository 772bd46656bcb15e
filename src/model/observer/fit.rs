//! Finds observers from which everything important is in sight.

use pinhole_core::{
    Camera, DVec2, DVec3, ExactRay, Object, Orientation, Ray, ResolvedCamera, Root, Scene, Sphere,
    extent_of_fov,
};

use crate::model::observer::{FOV, Observer};
use crate::model::overlay_items::{Item, OverlayItems};

/// Ratio of sizes above which a sphere is out of scale: its radius exceeds this many times the extent of
/// the camera and of all smaller spheres together. Such a sphere need not be in sight.
const OUT_OF_SCALE: f64 = 50.0;

/// Ratio of a sphere's radius to its distance from the camera below which the sphere counts as a speck.
const SPECK: f64 = 2e-3;

/// Margins at the picture's border that are kept free, as fractions of half the picture: in general, and at
/// the tips of arrows.
const MARGIN: f64 = 0.1;
const MARGIN_AT_TIPS: f64 = 0.02;

/// Maximum number of spheres and of planes that are considered.
const ASKED_SPHERES: usize = 2048;
const ASKED_PLANES: usize = 64;

/// Candidate directions of the observer, in degrees: angles to the side of the line straight behind the
/// camera, and angles above that line.
const TO_THE_SIDE: [f64; 7] = [56.0, 48.0, 40.0, 32.0, 25.0, 18.0, 12.0];
const ABOVE: [f64; 4] = [22.0, 19.0, 14.0, 9.0];

/// The part of the frustum that should be in sight. It ends at the first number times the distance of the
/// farthest sphere, but at most at the second number times the distance of the viewport.
const FRUSTUM_PART: f64 = 0.6;
const LONGEST_FRUSTUM: f64 = 3.2;

/// Size of the camera in the picture, as a fraction of the picture's shorter side, beyond which an
/// observer's score no longer rises with the size.
const LARGE_ENOUGH: f64 = 0.15;

/// Maximum distance of the observer's target from the camera's eye, as a multiple of `Subject::near_size`.
/// An observer that turned around a more distant target would lose sight of the camera.
const FARTHEST_MIDDLE: f64 = 15.0;

/// Height in the picture, as a fraction of half of it, above which the sky must be seen over a sphere that is
/// out of scale, such as a planet on which the camera stands.
const HORIZON: f64 = 0.75;

/// Number of iterations when an observer is fitted. The arrows have a fixed size on the screen, so their
/// size in the world depends on the observer and is measured again in each iteration.
const ROUNDS: usize = 6;

/// Ratio of width to height of the view for which lesson files specify their observers.
const ORDINARY_ASPECT: f64 = 1.25;

/// Minimum ratio of the new to the old distance from the camera's eye when an observer is fitted to a view
/// of another size.
const NEAREST_REFIT: f64 = 0.45;

/// Maximum distance from the camera's eye at which an observer is kept when the view's size changes, as a
/// multiple of the fitted observer's distance.
const FARTHEST_KEPT: f64 = 1.2;

/// The size of the world view on the screen, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewSize {
    /// The width.
    pub width: f64,
    /// The height.
    pub height: f64,
}

impl ViewSize {
    /// Returns the size of a view that has the usual height and this aspect ratio (width to height).
    pub fn of_aspect(aspect: f64) -> ViewSize {
        ViewSize { width: 480.0 * tame_aspect(aspect), height: 480.0 }
    }

    /// Returns the ratio of width to height, clamped to a sensible range.
    pub fn aspect(self) -> f64 {
        tame_aspect(self.width / self.height)
    }

    /// Returns the minimum and maximum length of the basis arrows in this view, in points. Normals are
    /// drawn with the minimum length.
    pub fn arrow_points(self) -> (f64, f64) {
        let (least, most) = ARROW_POINTS;
        (least.min(ARROW_SHARE * self.width.min(self.height)).max(1.0), most)
    }

    /// Returns the length in the world that one point of the screen covers at this depth in front of the
    /// observer.
    fn world_per_point(self, depth: f64) -> f64 {
        extent_of_fov(FOV, depth) / self.height.max(1.0)
    }
}

/// A ball that must be in sight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    pub(super) center: DVec3,
    pub(super) radius: f64,
}

/// Everything that must be in sight, and the camera.
struct Subject {
    balls: Vec<Bound>,
    arrows: Arrows,
    eye: DVec3,
    /// Direction from the scene to the camera: the camera's w, or +z for an invalid camera.
    back: DVec3,
    /// The camera's right.
    right: DVec3,
    /// The largest of the viewport's width, height and distance.
    near_size: f64,
    /// The points of planes that the camera sees.
    walls: Vec<Root>,
    /// The spheres that are out of scale. They need not be in sight, but their horizon should be.
    planets: Vec<Bound>,
    /// The point around which the observer turns, halfway between the camera's eye and the objects.
    middle: DVec3,
}

impl Observer {
    /// Returns an observer behind the camera's shoulder that sees the eye, the viewport, the basis arrows,
    /// at, and all spheres that are not out of scale. It stands as far to the side as it can without the
    /// camera becoming too small in the picture.
    ///
    /// Perspective makes this possible: an observer close behind a small camera also sees the distant
    /// objects that the camera looks at. They appear small, as in a sketch on a whiteboard.
    pub fn frame_all(camera: &Camera, scene: &Scene, size: ViewSize) -> Observer {
        let subject = Subject::new(camera, scene, OverlayItems::default());
        let behind = match (subject.back.x, subject.back.z) {
            (x, z) if x.hypot(z) > 1e-6 => x.atan2(z),
            // The camera looks straight up or down, so the direction behind it is right x up.
            _ => (-subject.right.z).atan2(subject.right.x),
        };
        let mut best: Option<(f64, Observer)> = None;
        // The observer on the right side is preferred: from there, the camera looks to the right in the
        // picture.
        for side in [1.0, -1.0] {
            for (beside, above) in TO_THE_SIDE.iter().flat_map(|b| ABOVE.map(|a| (b, a))) {
                let azimuth = behind + side * beside.to_radians();
                let from = Observer::new(DVec3::ZERO, azimuth, above.to_radians(), 1.0);
                let observer = subject.fit(&from, size);
                let score = subject.score(&observer, size.aspect()) + 0.1 * side;
                if best.is_none_or(|(most, _)| score > most) {
                    best = Some((score, observer));
                }
            }
        }
        best.map_or_else(|| Observer::new(DVec3::ZERO, 0.9, 0.4, 10.0), |(_, observer)| observer)
    }

    /// Returns the observer in the same direction that has everything in sight in a view of this size.
    pub fn refitted(&self, camera: &Camera, scene: &Scene, size: ViewSize) -> Observer {
        Subject::new(camera, scene, OverlayItems::default()).fit(self, size)
    }

    /// Returns an observer in the same direction for a view of this size. It sees the whole camera, those
    /// of its arrows that are among the `items`, with their labels, and everything else that this observer
    /// sees in a view of ordinary shape. Returns this observer unchanged in two cases: if all of that
    /// already fills the view, or if it is so near that the eye or the viewport is meant to be out of
    /// sight.
    pub fn framing_the_same(
        &self,
        camera: &Camera,
        scene: &Scene,
        size: ViewSize,
        items: OverlayItems,
    ) -> Observer {
        if self.distance_for(camera, ORDINARY_ASPECT) > self.distance {
            return *self;
        }
        let mut subject = Subject::new(camera, scene, items);
        // Spheres that contain the eye are drawn cut away.
        let eye = subject.eye;
        let around = |ball: &Bound| ball.center.distance(eye) <= ball.radius;
        subject.balls.extend(balls_of(scene).filter(around));
        subject.balls.retain(|ball| self.sees(ball, ORDINARY_ASPECT, 0.0));
        let depth = |observer: &Observer| {
            (observer.target - subject.eye).dot(observer.back()) + observer.distance
        };
        let mut fitted = subject.fit(self, size);
        let nearest = NEAREST_REFIT * depth(self);
        fitted.distance += (nearest - depth(&fitted)).max(0.0);
        let fills = depth(self) <= FARTHEST_KEPT * depth(&fitted);
        let tips = subject.arrows.tips(subject.eye, depth(self), size);
        let is_whole = subject.balls.iter().all(|ball| self.sees(ball, size.aspect(), 0.0))
            && tips.into_iter().all(|tip| self.sees(&tip, size.aspect(), MARGIN_AT_TIPS));
        if fills && is_whole { *self } else { fitted.in_range() }
    }

    /// Returns true if a view of this size shows the camera's eye and, if the camera is given by at, that
    /// point too.
    pub fn sees_eye_and_at(&self, camera: &Camera, size: ViewSize) -> bool {
        let mut points = [camera.eye].into_iter().chain(given_at(camera));
        points.all(|center| self.sees(&Bound { center, radius: 0.0 }, size.aspect(), 0.0))
    }

    /// Returns the observer in the same direction that sees the eye, the arrows and the viewport as large
    /// as possible.
    pub fn framing_camera(&self, camera: &Camera, size: ViewSize) -> Observer {
        let orientation = match camera.orientation {
            // The point at need not be in the picture, so it is replaced by a direction.
            Orientation::At { up, .. } => Orientation::View { view: camera.view(), up },
            given => given,
        };
        let alone = Camera { orientation, ..*camera };
        Subject::new(&alone, &Scene::default(), OverlayItems::default()).fit(self, size)
    }

    /// Returns the observer moved straight back until it sees the eyes and viewports of all cameras in
    /// `others`. Returns it unchanged if it already sees them, or if it does not even see those of
    /// `camera`.
    pub fn following(&self, camera: &Camera, others: &[Camera], aspect: f64) -> Observer {
        let needed = |camera: &Camera| self.distance_for(camera, tame_aspect(aspect));
        if needed(camera) > self.distance {
            return *self;
        }
        let distance = others.iter().map(needed).fold(self.distance, f64::max);
        Observer { distance, ..*self }.in_range()
    }

    /// Returns the smallest distance from the target at which the observer sees a camera's eye and
    /// viewport, with a small margin.
    fn distance_for(&self, camera: &Camera, aspect: f64) -> f64 {
        let corners =
            camera.resolve().map_or(Vec::new(), |resolved| frustum_corners(&resolved, 1.0).into());
        let balls = corners.into_iter().chain([Bound { center: camera.eye, radius: 0.0 }]);
        let distances = balls.map(|ball| self.distance_for_ball(&ball, aspect, 0.5 * MARGIN));
        distances.filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }

    /// Returns true if the whole ball is in sight.
    fn sees(&self, ball: &Bound, aspect: f64, margin: f64) -> bool {
        self.distance_for_ball(ball, aspect, margin) <= self.distance
    }

    /// Returns the smallest distance from the target at which the observer sees a ball. In coordinates with
    /// the target as the origin and z towards the observer, it sees a point (x, y, z) from the distance
    /// `z + |x| / k` on, where k is the tangent of half the horizontal field of view without the margin;
    /// and similarly for y.
    fn distance_for_ball(&self, ball: &Bound, aspect: f64, margin: f64) -> f64 {
        let (back, (right, up)) = (self.back(), self.right_and_up());
        let slope = 0.5 * extent_of_fov(FOV, 1.0) * (1.0 - margin);
        let q = ball.center - self.target();
        let reach = |axis: DVec3| q.dot(axis).abs() + ball.radius;
        q.dot(back) + (reach(right) / (slope * aspect)).max(reach(up) / slope)
    }
}

fn tame_aspect(aspect: f64) -> f64 {
    if aspect.is_finite() { aspect.clamp(0.1, 10.0) } else { 1.0 }
}

impl Subject {
    fn new(camera: &Camera, scene: &Scene, items: OverlayItems) -> Subject {
        let tame = |p: DVec3| p.is_finite() && p.abs().max_element() < 1e12;
        let eye = if tame(camera.eye) { camera.eye } else { DVec3::ZERO };
        let mut balls = Vec::new();
        let mut walls = Vec::new();
        let resolved = camera.resolve().ok();
        let near_size = resolved.map_or(1.0, |resolved| near_size(&resolved).clamp(1e-9, 1e12));
        let (back, right) = resolved
            .map_or((DVec3::Z, DVec3::X), |resolved| (resolved.basis().w, resolved.basis().u));
        balls.extend(resolved.iter().flat_map(|resolved| frustum_corners(resolved, 1.0)));
        balls.extend(given_at(camera).map(|at| Bound { center: at, radius: 0.0 }));
        let (spheres, planets) = spheres_in_scale(scene, eye, near_size);
        let farthest = spheres.iter().map(|ball| ball.center.distance(eye)).fold(0.0, f64::max);
        if let Some(resolved) = resolved {
            let t = (FRUSTUM_PART * farthest / resolved.viewport().distance).min(LONGEST_FRUSTUM);
            if items.shows(Item::Frustum) {
                balls.extend(frustum_corners(&resolved, t));
            }
            walls = walls_seen(&resolved, scene, 2.0 * farthest.max(10.0 * near_size));
            balls.extend(walls.iter().map(|hit| Bound { center: hit.point, radius: 0.0 }));
        }
        balls.push(Bound { center: eye, radius: 0.0 });
        balls.retain(|ball| tame(ball.center));
        let camera_balls = balls.len();
        balls.extend(spheres);
        let seen = &balls[if balls.len() > camera_balls { camera_balls } else { 0 }..];
        let sum: DVec3 = seen.iter().map(|ball| ball.center).sum();
        let toward_middle = 0.5 * (sum / seen.len() as f64 - eye);
        let middle = eye + toward_middle.clamp_length_max(FARTHEST_MIDDLE * near_size);
        let arrows = Arrows::new(camera, items);
        Subject { balls, arrows, eye, back, right, near_size, walls, planets, middle }
    }

    /// Returns the nearest observer in this direction that sees all balls and the tips of all arrows.
    fn fit(&self, direction: &Observer, size: ViewSize) -> Observer {
        let mut observer = self.fit_around(direction, size.aspect(), &[]);
        for _ in 0..ROUNDS {
            let stand = observer.target() + observer.distance() * observer.back();
            let depth = (stand - self.eye).dot(observer.back());
            let tips: Vec<Bound> = self.arrows.tips(self.eye, depth, size).collect();
            observer = self.fit_around(direction, size.aspect(), &tips);
        }
        observer
    }

    /// Returns the nearest observer in this direction that sees all balls and these tips.
    ///
    /// Let x point to the observer's right and z towards the observer, let (ex, ez) be the observer's
    /// position, and let k be the tangent of half the horizontal field of view without the margin. A ball
    /// with centre (x, z) and radius r is to the right of the picture's left border if
    /// `x - ex >= -k (ez - z) + r'`, where `r' = r sqrt(1 + k^2)`, and similarly for the right border. With
    /// the maxima over all balls `A = max(x + k z + r')` and `B = max(-x + k z + r')`, the nearest position
    /// is `ez = (A + B) / 2k`, `ex = (A - B) / 2`. The same is done for y and the vertical field of view.
    fn fit_around(&self, direction: &Observer, aspect: f64, tips: &[Bound]) -> Observer {
        let back = direction.back();
        let (right, up) = direction.right_and_up();
        let slope = 0.5 * extent_of_fov(FOV, 1.0) * (1.0 - MARGIN);
        let reach = |axis: DVec3, k: f64| {
            let widen = (1.0 + k * k).sqrt();
            let most = |sign: f64| {
                let balls = self.balls.iter().chain(tips);
                balls
                    .filter(|ball| ball.center.is_finite() && ball.radius.is_finite())
                    .map(|ball| {
                        let q = ball.center - self.eye;
                        sign * q.dot(axis) + k * q.dot(back) + ball.radius * widen
                    })
                    .fold(f64::NEG_INFINITY, f64::max)
            };
            let (a, b) = (most(1.0), most(-1.0));
            (0.5 * (a - b), 0.5 * (a + b) / k)
        };
        let (x, z_across) = reach(right, slope * aspect);
        let (y, z_upwards) = reach(up, slope);
        let stand = self.eye + x * right + y * up + z_across.max(z_upwards) * back;
        let distance = (stand - self.middle).dot(back).max(0.5 * self.near_size);
        let target = stand - distance * back;
        Observer { target, distance, ..*direction }.in_range()
    }

    /// Returns the score of an observer. It is higher if the camera is large enough in the picture, if its
    /// view direction is seen from the side, if the picture on its viewport and the planes are seen from
    /// the front, if no ball hides the camera, and if the horizon of a planet is in sight.
    fn score(&self, observer: &Observer, aspect: f64) -> f64 {
        let back = observer.back();
        let stand = observer.target() + observer.distance() * back;
        let to_eye = stand - self.eye;
        let depth = to_eye.dot(back).max(1e-12);
        let size = self.near_size / (aspect.min(1.0) * extent_of_fov(FOV, depth));
        let along = back.dot(self.back);
        let sideways = (1.0 - along * along).max(0.0).sqrt();
        // The camera's picture on its viewport is hard to read if it is foreshortened to less than half its
        // width.
        let from_front = along.clamp(-0.5, 0.62);
        let hidden = self.balls.iter().any(|ball| lies_between(ball, self.eye, stand));
        let facing: f64 = self.walls.iter().map(|hit| hit.normal.dot(back).max(0.0)).sum();
        let facing = facing / self.walls.len().max(1) as f64;
        (size / LARGE_ENOUGH).min(1.0) + 1.2 * sideways + from_front + 0.2 * facing
            - if hidden { 0.6 } else { 0.0 }
            - if self.loses_horizon(observer) { 1.0 } else { 0.0 }
    }

    /// Returns true if a sphere that is out of scale fills the picture up to [`HORIZON`].
    fn loses_horizon(&self, observer: &Observer) -> bool {
        let (back, (_, up)) = (observer.back(), observer.right_and_up());
        let stand = observer.target() + observer.distance() * back;
        let upwards = HORIZON * 0.5 * extent_of_fov(FOV, 1.0) * up - back;
        self.planets.iter().any(|ball| {
            let from_center = stand - ball.center;
            let outside = from_center.length_squared() - ball.radius * ball.radius;
            let b = from_center.dot(upwards);
            outside > 0.0 && b < 0.0 && b * b > upwards.length_squared() * outside
        })
    }
}

/// Returns the point at; `None` if the camera is given by a view direction or a basis instead.
fn given_at(camera: &Camera) -> Option<DVec3> {
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
fn frustum_corners(resolved: &ResolvedCamera, t: f64) -> [Bound; 4] {
    rays_around(resolved, 1.0).map(|ray| Bound { center: ray.at(t), radius: 0.0 })
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
fn balls_of(scene: &Scene) -> impl Iterator<Item = Bound> {
    let ball = |sphere: &Sphere| Bound { center: sphere.center, radius: sphere.radius };
    scene.spheres().iter().take(ASKED_SPHERES).map(ball)
}

/// Returns the spheres by ascending radius, up to the first one that is out of scale with the smaller ones;
/// and the remaining ones.
fn spheres_in_scale(scene: &Scene, eye: DVec3, near_size: f64) -> (Vec<Bound>, Vec<Bound>) {
    let is_tame = |ball: &Bound| ball.center.abs().max_element() < 1e12;
    let mut balls: Vec<Bound> = balls_of(scene).filter(is_tame).collect();
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
    // A sphere that contains the eye cannot be wholly in sight of an observer near the camera.
    balls.retain(|ball| (ball.center - eye).length() > ball.radius);
    // A distant speck must not move the observer so far away that everything else becomes a speck.
    let can_be_seen = |ball: &Bound| ball.radius >= SPECK * (ball.center - eye).length();
    if balls.iter().any(can_be_seen) {
        balls.retain(can_be_seen);
    }
    (balls, planets)
}

fn lies_between(ball: &Bound, a: DVec3, b: DVec3) -> bool {
    let along = b - a;
    let share = ((ball.center - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
    ball.radius > 0.0 && (a + share * along).distance(ball.center) < ball.radius
}

/// Minimum and maximum length of the basis arrows on the screen, in points. Between these limits, the
/// arrows are one world unit long.
const ARROW_POINTS: (f64, f64) = (62.0, 125.0);

/// Minimum length of the basis arrows in a small view, as a fraction of the smaller of its height and
/// width.
const ARROW_SHARE: f64 = 0.28;

/// Length of the up arrow, as a multiple of the basis arrows' length.
pub const UP_LENGTH: f64 = 1.35;

/// Length of the view arrow, as a multiple of the basis arrows' length. It differs from the up arrow's, so
/// that arrows with the same direction do not hide each other.
pub const VIEW_LENGTH: f64 = 1.6;

/// Length of the arrows of the world's axes, as a multiple of the basis arrows' length.
pub const AXIS_LENGTH: f64 = 1.6;

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
    at_eye: Vec<(DVec3, f64)>,
    has_axes: bool,
}

impl Arrows {
    pub(super) fn new(camera: &Camera, items: OverlayItems) -> Arrows {
        let mut at_eye = Vec::new();
        let mut has_axes = false;
        if let Ok(resolved) = camera.resolve() {
            let basis = resolved.basis();
            if items.shows(Item::Basis) {
                at_eye.extend([basis.u, basis.v, basis.w].map(|axis| (axis, 1.0)));
            }
            has_axes = items.shows(Item::Axes) && camera.eye.length() <= near_size(&resolved);
        }
        if items.shows(Item::ViewAndUp) && camera.orientation.has_up() {
            let given = [(camera.view(), VIEW_LENGTH), (camera.up(), UP_LENGTH)];
            at_eye.extend(given.into_iter().filter_map(|(vector, times)| {
                let scaled = vector / vector.abs().max_element();
                scaled.is_finite().then(|| (scaled.normalize(), times))
            }));
        }
        if let (true, true, Ok(resolved)) =
            (items.shows(Item::Areas), camera.orientation.has_up(), camera.resolve())
        {
            let basis = resolved.basis();
            let up = camera.up();
            let corners = [side_length(up.length()) * up.normalize_or_zero(), basis.u];
            let corners = corners.map(|side| side + basis.w);
            at_eye.extend(corners.map(|corner| (corner.normalize_or_zero(), corner.length())));
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
