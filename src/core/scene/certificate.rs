//! How certainly a ray's first hit is decided: the step of the ladder that was needed, and the margin
//! in bits.
//!
//! Every decision is the sign of a number that is known within an error bound. A pixel's answer rests on
//! one statement for each object: the first object *is hit*, and each other object is *not hit before
//! it*. A statement that needs several decisions is as certain as the least certain of them; a statement
//! that can be shown in several ways is as certain as the most certain of them. A sphere is hit if the
//! line meets it and it is ahead of the eye; it is not hit before the first object if the line misses
//! it, if it is behind the eye, or if its root comes later. A pixel's answer is as certain as its least
//! certain statement.

use std::borrow::Cow;
use std::cmp::Ordering;

use rayon::prelude::*;

use crate::camera::ray::ExactRay;
use crate::camera::resolved::ResolvedCamera;
use crate::camera::viewport::Pixel;
use crate::exact::bounded::{Number, SECOND_ORDER, UNIT};
use crate::exact::quadratic::{DirectionTerms, LARGEST_SHARE, Quadratic, SphereTerms};
use crate::exact::scale::ldexp;
use crate::exact::steps::{Step, Steps};
use crate::scene::Scene;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin};
use crate::scene::objects_from_origin::ObjectsFromOrigin;
use crate::scene::plane_predicates::PlaneFromOrigin;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_predicates::{FINE_SHARE, ROUGH_SHARE, SphereFromOrigin};

/// How certainly a ray's first hit or, if it hits nothing, its miss is decided: the step of [the
/// ladder](crate#the-ladder) that was needed, and the margin by which this step decided.
///
/// A decision is the sign of a value that a step of the ladder computed with an error bound. Its
/// margin is
///
/// ```text
/// margin = log2(|value| / bound)      so that     |exact value| >= (2^margin - 1) * bound
/// ```
///
/// in bits: an error larger by this many bits would not have changed the decision. It is never below 0.
/// A decision for which double-double does not suffice, and which is made in integers, has a margin of
/// 0.
///
/// A certificate describes the decisions for a single ray. Tracing a whole frame may need only lower
/// steps: for example, it can tell nearly equal spheres apart in `f64`, by the difference between the
/// spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// The highest step that any of the decisions needed.
    pub step: Step,
    /// The least margin of the decisions made at that step, in bits: 0 at [`Step::Exact`], and at most
    /// [`Certificate::MOST`].
    pub margin: f64,
    /// The decision with the least margin; `None` if the margin is [`Certificate::MOST`].
    pub hardest: Option<Hardest>,
}

/// The decision about a ray that has the smallest margin.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Hardest {
    /// The question that was decided.
    pub question: Question,
    /// The index of the object that the question is about.
    pub object: u32,
    /// The error bound of the value that decides, divided by the denominator that [`Question`] gives; at
    /// [`Step::Exact`], the bound of double-double, which did not suffice.
    pub bound: f64,
}

/// A question about a ray and an object. The sign of a value is the answer. Each case gives this
/// value, divided by a denominator that makes it dimensionless.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Question {
    /// On which side of the object the eye is: outside or inside a sphere, by the sign of
    /// `(|q|^2 - r^2) / (|q|^2 + r^2)`, where q is the vector from the eye to the sphere's centre and
    /// r its radius; or on which side of a plane, by the sign of `n.p / (|n| |p|)`, where n is the
    /// plane's normal and p the vector from the eye to the plane's point.
    Side,
    /// Whether the ray's line meets a sphere, by the sign of `D / (|d|^2 |q|^2)`, where d is the ray's
    /// direction, q the vector from the eye to the sphere's centre, r its radius, and
    /// `D = (q.d)^2 - |d|^2 (|q|^2 - r^2)` the discriminant. This quotient is the squared sine of the
    /// sphere's angular radius minus the squared sine of the angle between d and q.
    Meets,
    /// Whether a sphere's centre is ahead of the eye, by the sign of `q.d / (|q| |d|)`, where d is the
    /// ray's direction and q the vector from the eye to the centre; or whether the ray goes along a
    /// plane's normal n or against it, by the sign of `n.d / (|n| |d|)`.
    Ahead,
    /// Whether the object, hit at t, comes after the first hit, at t_first, by the sign of
    /// `(t - t_first) / (|t| + |t_first|)`.
    Order,
}

/// A value whose sign answers a question, its error bound, and the denominator by which both are divided
/// in a report (see [`Question`]).
struct Bounded {
    question: Question,
    value: f64,
    bound: f64,
    unit: f64,
}

impl Certificate {
    /// The largest margin reported, in bits; also the margin if there is nothing to decide. With this
    /// margin, even an error ten trillion times as large would change no decision.
    pub const MOST: f64 = 44.0;

    const SURE: Certificate =
        Certificate { step: Step::F64, margin: Certificate::MOST, hardest: None };

    /// Returns the certificate of a decision made by a value's sign, or `None` if the value is within
    /// its error bound.
    fn decided(step: Step, object: u32, bounded: &Bounded) -> Option<Certificate> {
        let Bounded { question, value, bound, unit } = *bounded;
        (value.abs() > bound).then(|| {
            let margin = (value.abs() / bound).log2();
            if margin >= Certificate::MOST {
                return Certificate { step, ..Certificate::SURE };
            }
            let hardest = Some(Hardest { question, object, bound: bound / unit });
            Certificate { step, margin, hardest }
        })
    }

    /// Returns the certificate of a decision for which exact integers are needed.
    fn exact(question: Question, object: u32, bound: f64) -> Certificate {
        let hardest = Some(Hardest { question, object, bound });
        Certificate { step: Step::Exact, margin: 0.0, hardest }
    }

    /// Compares two certificates: the less certain one is `Greater`. A higher step is less certain; at
    /// equal steps, a smaller margin is.
    fn compare(&self, other: &Certificate) -> Ordering {
        self.step.cmp(&other.step).then(other.margin.total_cmp(&self.margin))
    }

    /// Returns the weaker of two certificates, for a conclusion that needs both statements.
    fn and(self, other: Certificate) -> Certificate {
        if other.compare(&self) == Ordering::Greater { other } else { self }
    }

    /// Returns the stronger of two certificates, for a conclusion for which one of the statements
    /// suffices.
    fn or(self, other: Certificate) -> Certificate {
        if other.compare(&self) == Ordering::Less { other } else { self }
    }
}

/// Returns the strongest of the given certificates, or `None` if all are `None`.
fn surest<const N: usize>(ways: [Option<Certificate>; N]) -> Option<Certificate> {
    ways.into_iter().flatten().reduce(Certificate::or)
}

/// Pairs `(s, bits)`: a ray's line misses each sphere that is not among [`Scene::spheres_near`] with
/// `share = s`, with a margin of at least that many bits.
///
/// Let d be the ray's direction, q the vector from its origin to the sphere's centre, r the radius, and
/// m the line's distance from the centre. For these spheres `m - r > 2 s |q|`, so the discriminant has
/// `|D| = |d|^2 (m - r) (m + r) > 2 s |d|^2 |q| m`. The error bound of D is below `26 u |d|^2 |q| m`
/// with either formula for D, if the relative error of d is little more than the unit roundoff u.
const PASSED: [(f64, f64); 2] = [(1.0 / 512.0, 40.0), (1.0 / 32.0, Certificate::MOST)];

impl Scene {
    /// Returns the certificate of the ray's first hit, or of its miss, as [`Scene::first_hit_of`]
    /// decides it. The certificate does not depend on the order in which objects are examined.
    ///
    /// ```
    /// use pinhole_core::*;
    /// let ball = Sphere::new([0.0, 1.0, -5.0], 1.0)?;
    /// let scene = Scene::new(vec![ball], vec![])?;
    /// let along = |direction| Ray::new([0.0; 3], direction);
    /// let certificate = scene.certificate_of(&ExactRay::from_ray(&along([0.0, 0.2, -1.0])?)?);
    /// assert_eq!(certificate.step, Step::F64);
    /// assert!(certificate.margin > 20.0);
    /// // A tangent.
    /// let certificate = scene.certificate_of(&ExactRay::from_ray(&along([0.0, 0.0, -1.0])?)?);
    /// assert_eq!((certificate.step, certificate.margin), (Step::Exact, 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn certificate_of(&self, ray: &ExactRay) -> Certificate {
        certificate(&ObjectsFromOrigin::for_one_ray(self, ray), ray)
    }

    /// Returns the [certificates](Scene::certificate_of) of a camera's view rays for the pixels in
    /// these rows and columns, row by row. The rows are computed in parallel; `done` is called with
    /// the number of rows just finished.
    pub fn certificates(
        &self,
        camera: &ResolvedCamera,
        rows: &[u32],
        columns: &[u32],
        done: impl Fn(usize) + Sync,
    ) -> Vec<Certificate> {
        self.make_index();
        let objects = ObjectsFromOrigin::for_many_rays(self, camera.eye());
        let of_row = |row: &u32| {
            let of_pixel = |column: &u32| {
                let pixel = Pixel { row: *row, column: *column };
                certificate(&objects, &camera.exact_ray(pixel))
            };
            let found = columns.iter().map(of_pixel).collect::<Vec<_>>();
            done(1);
            found
        };
        rows.par_iter().flat_map_iter(of_row).collect()
    }
}

/// Returns the certificate of the ray's first hit, or of its miss: the highest step of the ladder that
/// any decision needed, and the least margin at that step. Spheres that are far from the ray's line
/// are left out where [`PASSED`] shows that they do not matter.
fn certificate(objects: &ObjectsFromOrigin, ray: &ExactRay) -> Certificate {
    let scene = objects.scene;
    let first = objects.first_hit(ray, &mut Steps::default());
    let is_known = ray.rough.doubt < 1.5 * UNIT;
    if scene.index().is_none() || !is_known {
        return certificate_among(objects, ray, first.as_ref(), 0..scene.spheres().len() as u32);
    }
    let mut found = Certificate::SURE;
    for (share, spared) in PASSED {
        let near = scene.spheres_near(ray, share);
        found = certificate_among(objects, ray, first.as_ref(), near);
        if found.step > Step::F64 || found.margin <= spared {
            break;
        }
    }
    found
}

/// Returns the certificate of the statement that `first` is the first hit among the given spheres and
/// all planes or, if it is `None`, that the ray hits none of them.
pub(crate) fn certificate_among(
    objects: &ObjectsFromOrigin,
    ray: &ExactRay,
    first: Option<&Hit>,
    spheres: impl IntoIterator<Item = u32>,
) -> Certificate {
    let scene = objects.scene;
    let count = scene.spheres().len() as u32;
    let mut all = first.map_or(Certificate::SURE, |hit| is_hit(hit, ray));
    for index in spheres.into_iter().chain(count..scene.len() as u32) {
        if first.is_some_and(|hit| hit.index == index) {
            continue;
        }
        if let Some(Object::Sphere(sphere)) = scene.object(index)
            && is_missed(&sphere, ray, &all)
        {
            continue;
        }
        let Some(object) = objects.get(index) else { continue };
        all = all.and(is_not_first(index, object, first, ray));
    }
    all
}

/// Returns whether `f64` alone decides, at least as certainly as `than`, that the ray misses the sphere.
/// This settles most spheres for most rays, at a tenth of the cost of a full decision.
fn is_missed(sphere: &Sphere, ray: &ExactRay, than: &Certificate) -> bool {
    let Some(parts) = SphereFromOrigin::rough_terms(sphere, ray.origin()) else { return false };
    let Quadratic { b, discriminant, b_doubt, discriminant_doubt, .. } =
        Quadratic::new(&parts, &ray.rough);
    let factor = if than.step > Step::F64 { 1.0 } else { than.margin.exp2() };
    // An eye this far away is certainly outside, by more than the largest margin reported.
    discriminant < -factor * discriminant_doubt || b < -factor * b_doubt
}

/// Returns the certificate of the statement that the ray hits the object.
fn is_hit(hit: &Hit, ray: &ExactRay) -> Certificate {
    let index = hit.index;
    let side = side_of(index, &hit.object);
    match hit.object.as_ref() {
        // If the eye is inside, every ray hits the sphere. If the eye is on the sphere, its side is the
        // hardest decision.
        ObjectFromOrigin::Sphere(sphere) if sphere.side != Ordering::Greater => side,
        ObjectFromOrigin::Sphere(sphere) => {
            let rough = Signs::new(&Quadratic::new(&sphere.rough, &ray.rough), &sphere.rough);
            let fine = || Signs::new(&Quadratic::new(&sphere.fine, &ray.fine), &sphere.fine);
            let meets = by_ladder(index, &rough.meets, || fine().meets).0;
            side.and(meets).and(by_ladder(index, &rough.ahead, || fine().ahead).0)
        }
        ObjectFromOrigin::Plane(plane) => side.and(rate_of(index, plane, ray).0),
    }
}

/// Returns the certificate of the statement that the ray does not hit the object before its first
/// hit.
fn is_not_first(
    index: u32,
    object: Cow<'_, ObjectFromOrigin>,
    first: Option<&Hit>,
    ray: &ExactRay,
) -> Certificate {
    if first.is_some_and(|first| first.object.is_same(&object)) {
        return Certificate::SURE;
    }
    let root = object.root_of_hit();
    let hit = Hit { index, object, root };
    let side = side_of(index, &hit.object);
    let later = first.and_then(|first| is_later(&hit, first, ray)).map(|later| side.and(later));
    match hit.object.as_ref() {
        ObjectFromOrigin::Sphere(sphere) => sphere_is_not_first(&hit, sphere, first, later, ray),
        ObjectFromOrigin::Plane(plane) => {
            let (rate, sign) = rate_of(index, plane, ray);
            let is_passed = sign != Some(plane.side) || plane.side == Ordering::Equal;
            let passed = is_passed.then(|| side.and(rate));
            let found = surest([passed, later]);
            found.unwrap_or_else(|| side.and(order_of(&hit, first, ray)))
        }
    }
}

/// Returns the certificate of the statement that a sphere is not hit before the ray's first hit. `later`
/// is the certificate that its hit comes later, or `None` if `f64` cannot decide that.
fn sphere_is_not_first(
    hit: &Hit,
    sphere: &SphereFromOrigin,
    first: Option<&Hit>,
    later: Option<Certificate>,
    ray: &ExactRay,
) -> Certificate {
    let (index, side) = (hit.index, side_of(hit.index, &hit.object));
    if sphere.side == Ordering::Less {
        return later.unwrap_or_else(|| side.and(order_of(hit, first, ray)));
    }
    let passed = |step: Step, signs: &Signs| {
        let missed = Certificate::decided(step, index, &signs.meets);
        let behind = Certificate::decided(step, index, &signs.ahead);
        surest([
            missed.filter(|_| signs.meets.value < 0.0),
            behind.filter(|_| signs.ahead.value < 0.0).map(|behind| side.and(behind)),
        ])
    };
    let rough = Signs::new(&Quadratic::new(&sphere.rough, &ray.rough), &sphere.rough);
    let by_f64 = surest([passed(Step::F64, &rough), later]);
    if let Some(found) = by_f64.filter(|found| found.step == Step::F64) {
        return found;
    }
    let fine = Signs::new(&Quadratic::new(&sphere.fine, &ray.fine), &sphere.fine);
    if let Some(found) = surest([by_f64, passed(Step::DoubleDouble, &fine)]) {
        return found;
    }
    let is_met = fine.meets.value > fine.meets.bound;
    if is_met && first.is_some() && sphere.side == Ordering::Greater {
        return side.and(order_of(hit, first, ray));
    }
    let undecided = if is_met { fine.ahead } else { fine.meets };
    side.and(Certificate::exact(undecided.question, index, undecided.bound / undecided.unit))
}

/// The two values whose signs decide whether a ray hits a sphere: the discriminant and b of the
/// quadratic.
struct Signs {
    meets: Bounded,
    ahead: Bounded,
}

impl Signs {
    fn new<T: Number>(quadratic: &Quadratic<T>, sphere: &SphereTerms<T>) -> Signs {
        let Quadratic { b_doubt, discriminant_doubt, .. } = *quadratic;
        let reach = quadratic.a.near().sqrt() * sphere.distance;
        let (discriminant, b) = (quadratic.discriminant.near(), quadratic.b.near());
        let bounded = |question, value, bound, unit| Bounded { question, value, bound, unit };
        Signs {
            meets: bounded(Question::Meets, discriminant, discriminant_doubt, reach * reach),
            ahead: bounded(Question::Ahead, b, b_doubt, reach),
        }
    }
}

/// Returns the certificate of the decision on which side of the object the eye is.
fn side_of(index: u32, seen: &ObjectFromOrigin) -> Certificate {
    let (value, unit, [rough, fine]) = match seen {
        ObjectFromOrigin::Sphere(sphere) => {
            let SphereTerms { distance, radius, c, .. } = &sphere.fine;
            let squares = distance * distance + radius.hi * radius.hi;
            (c.hi, squares, [ROUGH_SHARE, FINE_SHARE])
        }
        ObjectFromOrigin::Plane(plane) => (plane.offset_share, 1.0, PlaneFromOrigin::SIDE_SHARES),
    };
    let (step, question) = (seen.side_step(), Question::Side);
    let share = if step == Step::F64 { rough } else { fine };
    let bounded = Bounded { question, value, bound: share * unit, unit };
    let decided =
        if step == Step::Exact { None } else { Certificate::decided(step, index, &bounded) };
    decided.unwrap_or_else(|| Certificate::exact(question, index, fine))
}

/// Returns the certificate of the decision whether the ray goes along a plane's normal or against it.
/// Also returns the sign, or `None` if only exact numbers decide it.
fn rate_of(index: u32, plane: &PlaneFromOrigin, ray: &ExactRay) -> (Certificate, Option<Ordering>) {
    fn bounded<T: Number>(plane: &PlaneFromOrigin, direction: &DirectionTerms<T>) -> Bounded {
        let (rate, unit) = (plane.rate_of(direction), plane.normal_length * direction.length);
        Bounded { question: Question::Ahead, value: rate.value.near(), bound: rate.doubt, unit }
    }
    by_ladder(index, &bounded(plane, &ray.rough), || bounded(plane, &ray.fine))
}

/// Returns the certificate of a decision by the steps of the ladder, given its value in `f64` and in
/// double-double. Also returns the sign, or `None` if only exact numbers decide it.
fn by_ladder(
    index: u32,
    rough: &Bounded,
    fine: impl FnOnce() -> Bounded,
) -> (Certificate, Option<Ordering>) {
    let decided = |step, bounded: &Bounded| {
        let found = Certificate::decided(step, index, bounded)?;
        Some((found, Some(bounded.value.total_cmp(&0.0))))
    };
    decided(Step::F64, rough).unwrap_or_else(|| {
        let fine = fine();
        let exact = || (Certificate::exact(fine.question, index, fine.bound / fine.unit), None);
        decided(Step::DoubleDouble, &fine).unwrap_or_else(exact)
    })
}

/// Returns the certificate of the statement that the line meets the object after the first hit or not at
/// all. Returns `None` if `f64` cannot decide that.
fn is_later(hit: &Hit, first: &Hit, ray: &ExactRay) -> Option<Certificate> {
    let (t, share) = rough_t(hit, ray)?;
    let (first_t, first_share) = rough_t(first, ray)?;
    let bound = 1.01 * (share * t.abs() + first_share * first_t.abs());
    let (question, unit) = (Question::Order, t.abs() + first_t.abs());
    let bounded = Bounded { question, value: t - first_t, bound, unit };
    Certificate::decided(Step::F64, hit.index, &bounded).filter(|_| t > first_t)
}

/// Returns `t` in `f64` and its relative error, or `None` if it is out of range. If `f64` cannot decide
/// whether the line meets a sphere, t is `b / a` of the sphere's quadratic, because the roots, if there
/// are any, are near this value:
///
/// ```text
/// |t - b / a| <= sqrt(D + bound of D) / a
/// ```
fn rough_t(hit: &Hit, ray: &ExactRay) -> Option<(f64, f64)> {
    if let Some(found) = hit.object.rough_t(ray, hit.root) {
        return Some(found);
    }
    let ObjectFromOrigin::Sphere(sphere) = hit.object.as_ref() else { return None };
    let Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt } =
        Quadratic::new(&sphere.rough, &ray.rough);
    if discriminant.abs() > discriminant_doubt || b <= b_doubt {
        return None;
    }
    let swing = (discriminant.max(0.0) + discriminant_doubt).sqrt();
    let share = SECOND_ORDER * ((b_doubt + swing) / b + a_doubt + 4.0 * UNIT);
    let t = ldexp(b / a * ray.stretch, sphere.scale - ray.scale);
    (t.is_normal() && share < LARGEST_SHARE).then_some((t, share))
}

/// Returns the certificate of the decision which of two hits comes first, if `f64` cannot make it.
fn order_of(hit: &Hit, first: Option<&Hit>, ray: &ExactRay) -> Certificate {
    let Some(first) = first else { return Certificate::SURE };
    let (t, first_t) = (hit.object.t(ray, hit.root), first.object.t(ray, first.root));
    let question = Question::Order;
    let (value, bound, unit) = t.difference(first_t).unwrap_or((f64::INFINITY, 0.0, 1.0));
    let bounded = Bounded { question, value, bound, unit };
    Certificate::decided(Step::DoubleDouble, hit.index, &bounded)
        .unwrap_or_else(|| Certificate::exact(question, hit.index, bound / unit))
}
