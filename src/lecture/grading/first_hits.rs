//! Finds all first hits that are acceptable as the answer of a pipeline (a program that may make
//! mistakes) for a ray, given the tolerance and the rounding errors of its numbers.
//!
//! An answer is right if it is the exact answer for objects whose size is changed by no more than the
//! tolerance times their distance. At a sphere's edge, where the slightest change decides between hit
//! and miss, a hit and a miss are therefore both right, and so is a hit of the object behind. If a ray
//! grazes an object, the error of t may be larger than for a head-on hit. With these rules, a program
//! without mistakes is never called wrong because of rounding, however it rounds.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{DVec3, ExactRay, Object, Plane, Ray, Scene, Sphere};

use crate::mistakes::{Pipeline, PipelineCamera, Quadratic, Sign, SquareRoot, WhichRoot};

/// A range of t in which an answer may place the first hit, on one object.
#[derive(Clone, Copy, Debug)]
pub(super) struct PossibleHit {
    pub(super) object: u32,
    /// The t that the pipeline calculates, without rounding errors.
    pub(super) t: f64,
    /// The smallest and the largest acceptable t.
    pub(super) least: f64,
    pub(super) most: f64,
    /// True if the object must be hit, because a miss cannot be due to rounding.
    is_sure: bool,
}

/// An acceptable hit or, as `None`, an acceptable miss.
pub(super) type Finding<'a> = Option<&'a PossibleHit>;

/// All hits that are acceptable as the first hit of a ray (see the module's documentation).
#[derive(Clone, Debug, Default)]
pub(super) struct FirstHits {
    pub(super) hits: Vec<PossibleHit>,
    /// True if a miss is acceptable, too.
    pub(super) may_miss: bool,
}

/// Returns true if the pipeline may report hits of spheres that are far from the ray, so that each ray
/// must be tested against every sphere. This is the case if its discriminant is wrong, or if it
/// computes in `f32`.
fn meets_far_off(pipeline: &Pipeline) -> bool {
    !pipeline.quadratic.meets_what_is_met() || pipeline.single
}

/// Returns the approximate number of spheres against which each ray of a pipeline is tested: all
/// spheres or, if the scene's spatial index can find those near the ray, a small number.
pub(super) fn work(scene: &Scene, pipeline: &Pipeline) -> usize {
    if meets_far_off(pipeline) { scene.spheres().len() } else { 1 }
}

/// A ray of a pipeline's camera, with the tolerance for answers.
struct Sight<'a> {
    camera: &'a PipelineCamera,
    tolerance: f64,
    direction: DVec3,
    length: f64,
}

impl FirstHits {
    /// Finds all hits that a program with this camera and its pipeline may report as the first hit of
    /// the ray in this direction, given the tolerance and rounding errors.
    pub(super) fn find(
        scene: &Scene,
        camera: &PipelineCamera,
        direction: DVec3,
        tolerance: f64,
    ) -> FirstHits {
        match Sight::new(camera, direction, tolerance) {
            Some(sight) => sight.first_of(sight.hits_of_all(scene)),
            None => FirstHits::default(),
        }
    }

    /// Returns all that is acceptable.
    pub(super) fn outcomes(&self) -> impl Iterator<Item = Finding<'_>> {
        self.hits.iter().map(Some).chain(self.may_miss.then_some(None))
    }

    /// Returns true if a hit of this object is acceptable or, for `None`, a miss.
    pub(super) fn may_be(&self, object: Option<u32>) -> bool {
        self.outcomes().any(|outcome| outcome.map(|hit| hit.object) == object)
    }
}

/// Finds, for each object as if it were the only one, the hits that a program with this camera and its
/// pipeline may report for the ray in this direction.
pub(super) fn hits_of_each(
    scene: &Scene,
    camera: &PipelineCamera,
    direction: DVec3,
    tolerance: f64,
) -> Vec<PossibleHit> {
    let sight = Sight::new(camera, direction, tolerance);
    sight.map(|sight| sight.hits_of_all(scene)).unwrap_or_default()
}

impl<'a> Sight<'a> {
    /// Creates the ray from the camera's eye in this direction; returns `None` if a number is not
    /// finite or the direction is 0.
    fn new(camera: &'a PipelineCamera, direction: DVec3, tolerance: f64) -> Option<Sight<'a>> {
        let length = length(direction);
        let is_ray = direction.is_finite() && length > 0.0 && camera.eye.is_finite();
        is_ray.then_some(Sight { camera, tolerance, direction, length })
    }

    fn hits_of_all(&self, scene: &Scene) -> Vec<PossibleHit> {
        let mut all = Vec::new();
        self.for_each_sphere(scene, |index, sphere| self.sphere(index, sphere, &mut all));
        for (index, plane) in (scene.spheres().len() as u32..).zip(scene.planes()) {
            self.plane(index, plane, &mut all);
        }
        all
    }

    /// Calls `each` for every sphere that the ray's line may hit within the tolerance, and possibly for
    /// others.
    fn for_each_sphere(&self, scene: &Scene, mut each: impl FnMut(u32, &Sphere)) {
        let ray = Ray { origin: self.camera.eye, direction: self.direction };
        match ExactRay::from_ray(&ray) {
            Ok(ray) if !meets_far_off(&self.camera.pipeline) => {
                let share = self.tolerance + self.camera.off + 64.0 * self.camera.epsilon;
                for index in scene.spheres_near(&ray, share) {
                    each(index, &scene.spheres()[index as usize]);
                }
            }
            _ => (0..).zip(scene.spheres()).for_each(|(index, sphere)| each(index, sphere)),
        }
    }

    /// Returns the maximum change of an object's size, in world units, that is allowed at the distance
    /// `reach` from the eye.
    fn slack(&self, reach: f64) -> f64 {
        (self.tolerance + self.camera.off) * reach
    }

    fn sphere(&self, index: u32, sphere: &Sphere, all: &mut Vec<PossibleHit>) {
        let Sphere { center, radius } = *sphere;
        let offset = self.camera.pipeline.quadratic.offset(self.camera.eye, center);
        let away = length(offset);
        // Allow for rounding errors of the given numbers, and of |p - center|^2 - r^2, whose terms
        // partly cancel.
        let rounding = self.camera.epsilon
            * (16.0 * (length(self.camera.eye) + length(center) + radius + away)
                + 8.0 * away * (away / radius));
        let quadratic = Terms::new(self.camera.pipeline.quadratic, self.direction, offset);
        let exact = quadratic.roots(radius);
        let at = |end: usize| {
            let t = exact.map_or(quadratic.vertex, |roots| roots[end]);
            let slack = self.slack(t.abs() * self.length) + rounding;
            let wide = quadratic.roots(radius + slack)?;
            let narrow = (radius > slack).then(|| quadratic.roots(radius - slack)).flatten();
            // If the ray misses the smaller sphere, it counts as touching it: both roots coincide, up
            // to the rounding of t itself.
            let touched = quadratic.vertex;
            let along = self.slack(touched.abs());
            let inner = narrow.map_or([touched - along, touched + along], |roots| [roots[end]; 2]);
            // Without the square root, t depends less on the sphere's size than on its distance, or not
            // at all.
            let extra = match quadratic.quadratic.square_root {
                SquareRoot::Right => 0.0,
                SquareRoot::LeftOut | SquareRoot::NotTaken => slack / self.length,
            };
            let (least, most) = (wide[end].min(inner[0]) - extra, wide[end].max(inner[1]) + extra);
            Some(PossibleHit { object: index, t, least, most, is_sure: narrow.is_some() })
        };
        let (Some(near), Some(far)) = (at(0), at(1)) else { return };
        match (self.camera.pipeline.sign, self.camera.pipeline.root) {
            (Sign::Positive, WhichRoot::Far) => all.extend(far.in_front()),
            (Sign::Positive, WhichRoot::Farthest) => {
                all.extend([near, far].into_iter().filter_map(PossibleHit::in_front));
            }
            (Sign::Positive, _) if near.least > 0.0 => all.push(near),
            (Sign::Positive, _) => {
                all.extend([near, far].into_iter().filter_map(PossibleHit::in_front));
            }
            (_, WhichRoot::Far) => all.push(far),
            (_, WhichRoot::Farthest) => all.extend([near, far]),
            (_, _) => all.push(near),
        }
    }

    fn plane(&self, index: u32, plane: &Plane, all: &mut Vec<PossibleHit>) {
        let normal = unit(plane.normal);
        let (rate, offset) =
            (normal.dot(self.direction), normal.dot(plane.point - self.camera.eye));
        let t = offset / rate;
        if !t.is_finite() {
            return;
        }
        let reach = t.abs() * self.length;
        let rounding = 16.0
            * self.camera.epsilon
            * (length(self.camera.eye) + length(plane.point) + offset.abs());
        let off = (self.slack(reach) + rounding) / rate.abs();
        // If the ray is nearly parallel to the plane, it meets the plane far away or behind the eye.
        let is_sure = (self.tolerance + self.camera.off) * self.length < 0.5 * rate.abs();
        let most = if is_sure { t + off } else { f64::INFINITY };
        let least = if is_sure { t - off } else { (t.abs() - off).min(t) };
        let hit = PossibleHit { object: index, t, least, most, is_sure };
        match self.camera.pipeline.sign {
            Sign::Positive => all.extend(hit.in_front()),
            Sign::Any | Sign::Nearest => all.push(hit),
        }
    }

    /// Returns those hits that may be the first one: all up to the nearest one that the program
    /// certainly finds.
    fn first_of(&self, mut all: Vec<PossibleHit>) -> FirstHits {
        let pipeline = &self.camera.pipeline;
        // The interval in which a hit lies, in the order by which the program chooses.
        let order = |hit: &PossibleHit| {
            let PossibleHit { least, most, .. } = *hit;
            match (pipeline.root, pipeline.sign) {
                (WhichRoot::Farthest | WhichRoot::FarthestObject, _) => (-most, -least),
                (WhichRoot::Last, _) => (-f64::from(hit.object), -f64::from(hit.object)),
                (_, Sign::Nearest) if most < 0.0 => (-most, -least),
                (_, Sign::Nearest) if least < 0.0 => (0.0, most.max(-least)),
                _ => (least, most),
            }
        };
        let sure = all.iter().filter(|hit| hit.is_sure);
        let end = sure.map(|hit| order(hit).1).fold(f64::INFINITY, f64::min);
        let may_miss = end == f64::INFINITY;
        all.retain(|hit| order(hit).0 <= end);
        FirstHits { hits: all, may_miss }
    }
}

impl PossibleHit {
    /// Returns the hit if a part of its range of t is in front of the eye (`t > 0`); otherwise `None`.
    /// If another part is not in front of the eye, `is_sure` becomes false, because the program may
    /// miss the object.
    fn in_front(self) -> Option<PossibleHit> {
        let is_sure = self.is_sure && self.least > 0.0;
        (self.most > 0.0).then_some(PossibleHit { is_sure, ..self })
    }
}

/// A sphere's quadratic equation, without the radius.
struct Terms {
    quadratic: Quadratic,
    a: f64,
    b: f64,
    /// `|p - center|^2`
    away_squared: f64,
    /// The distance from the centre to the ray's line.
    distance: f64,
    /// The t of both roots if they coincided.
    vertex: f64,
}

impl Terms {
    fn new(quadratic: Quadratic, direction: DVec3, offset: DVec3) -> Terms {
        let a = quadratic.a(direction.length_squared());
        let b = direction.dot(offset);
        let middle = -b / direction.length_squared();
        Terms {
            quadratic,
            a,
            b,
            away_squared: offset.length_squared(),
            distance: (offset + middle * direction).length(),
            vertex: quadratic.vertex(a, b),
        }
    }

    fn roots(&self, radius: f64) -> Option<[f64; 2]> {
        if self.quadratic.is_right() {
            // Calculated from half the chord, so that nothing cancels unless the ray grazes the sphere.
            let squared = (radius - self.distance) * (radius + self.distance);
            let half = (squared / self.a).sqrt();
            return (squared >= 0.0).then_some([self.vertex - half, self.vertex + half]);
        }
        self.quadratic.roots(self.a, self.b, self.quadratic.c(self.away_squared, radius))
    }
}

/// Returns the outward unit normal that a program calculates at a point of an object; `None` if there
/// is no such object.
pub(super) fn normal_at(scene: &Scene, object: u32, point: DVec3) -> Option<DVec3> {
    Some(match scene.object(object)? {
        Object::Sphere(sphere) => unit(point - sphere.center),
        Object::Plane(plane) => unit(plane.normal),
    })
}
