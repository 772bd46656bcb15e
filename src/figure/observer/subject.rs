//! What an observer must have in sight: the camera and its arrows, the objects around it, and what else is
//! drawn.

use pinhole_core::{
    Camera, DVec2, DVec3, ExactRay, Object, Orientation, Ray, ResolvedCamera, Root, Scene, Sphere,
};

use crate::observer::{Observer, ViewSize};

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
    /// Returns a point as a ball.
    pub fn point(center: DVec3) -> Bound {
        Bound { center, radius: 0.0 }
    }

    pub(super) fn contains(&self, point: DVec3) -> bool {
        self.center.distance(point) <= self.radius
    }
}

/// A position in the world: a point or, if `along` is not zero, the tip of an arrow from that point. Arrows have a
/// nearly constant size on the screen, so where their tips are in the world depends on the observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The point.
    pub at: DVec3,
    /// The arrow's vector, in units of `length`.
    pub along: DVec3,
    /// The unit.
    pub length: Length,
}

/// The length at which a unit vector is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// That of the basis arrows.
    Arrow,
    /// That of normals.
    Normal,
}

impl Place {
    /// Returns the place at this share of the way to another one, in the unit of that.
    pub(crate) fn toward(&self, to: &Place, share: f64) -> Place {
        let (at, along) = (self.at.lerp(to.at, share), self.along.lerp(to.along, share));
        Place { at, along, length: to.length }
    }
}

impl From<DVec3> for Place {
    fn from(at: DVec3) -> Place {
        Place { at, along: DVec3::ZERO, length: Length::Arrow }
    }
}

/// What is drawn and must be in sight.
#[derive(Clone, Debug)]
pub struct Drawn<'a> {
    /// The edited camera.
    pub camera: &'a Camera,
    /// The objects.
    pub scene: &'a Scene,
    /// True if the frustum is drawn.
    pub has_frustum: bool,
    /// Points, and the tips of arrows, each with whether it has a label.
    pub places: Vec<(Place, bool)>,
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
    /// The point halfway between the eye and the spheres, around which an observer turns.
    pub middle: DVec3,
    /// The distance from the eye to the far side of the spheres, or to the planes that the camera sees.
    pub extent: f64,
    /// The largest of the viewport's width, height and distance.
    pub(super) near_size: f64,
    /// The points of planes that the camera sees.
    pub(super) walls: Vec<Root>,
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
    /// What is drawn; see [`Drawn::places`].
    pub(super) places: Vec<(Place, bool)>,
    /// Its spheres are among the `balls`. Those out of scale need not be in sight, but their horizon should be.
    pub(super) around: Surroundings,
    /// Direction from the scene to the camera: the camera's w, or +z for an invalid camera.
    pub(super) back: DVec3,
    /// The camera's right.
    pub(super) right: DVec3,
    /// View and up; zero for a camera that is not given by them.
    pub(super) given: [DVec3; 2],
}

impl Subject {
    pub(super) fn new(drawn: &Drawn<'_>) -> Subject {
        let (camera, scene) = (drawn.camera, drawn.scene);
        let mut around = Surroundings::new(camera, scene);
        let (eye, mut spheres) = (around.eye, std::mem::take(&mut around.spheres));
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
            if drawn.has_frustum {
                let t =
                    (FRUSTUM_PART * farthest / resolved.viewport().distance).min(LONGEST_FRUSTUM);
                points.extend(frustum_corners(&resolved, t));
            }
        }
        points.extend(around.walls.iter().map(|hit| hit.point));
        points.retain(|point| is_tame(*point));
        let balls = points.into_iter().map(Bound::point).chain(spheres).collect();
        let tame = |(place, _): &&(Place, bool)| is_tame(place.at) && place.along.is_finite();
        let places = drawn.places.iter().filter(tame).copied().collect();
        let given = match camera.orientation {
            Orientation::At { up, .. } | Orientation::View { up, .. } => [camera.view(), up],
            Orientation::Basis(_) => [DVec3::ZERO; 2],
        };
        Subject { balls, places, around, back, right, given }
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

/// Space that is kept free around a place for its handle and its label: the radius in points, and its maximum as a
/// fraction of the view's height.
const TIP_ROOM: f64 = 26.0;
const TIP_ROOM_SHARE: f64 = 0.08;

impl Subject {
    /// Returns a ball around each place that is drawn, with space for its label.
    pub(super) fn shown_to(&self, observer: &Observer, size: ViewSize) -> Vec<Bound> {
        let (least, most) = size.arrow_points();
        let room = TIP_ROOM.min(TIP_ROOM_SHARE * size.height);
        let ball = |(Place { at, along, length }, has_label): &(Place, bool)| {
            let per_point = size.world_per_point(observer.depth_of(*at).max(1e-12));
            let length = match length {
                Length::Arrow => 1.0_f64.clamp(least * per_point, most * per_point),
                Length::Normal => least * per_point,
            };
            let radius = if *has_label { room * per_point } else { 0.0 };
            Bound { center: at + length * along, radius }
        };
        self.places.iter().map(ball).collect()
    }
}
