//! The plot of f(p + t d), the implicit function of each object along the ray: which objects have a curve,
//! the range of t, and the unit and a description of each curve. This module is pure; the arithmetic is in
//! [`pinhole_lecture`].

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use egui::Color32;
use pinhole_core::{AlongRay, ExactRay, ParabolaVertex, Root, Scene};
use pinhole_figure::inspection::Inspection;
use pinhole_lecture::numbers::{equated, written as number};
use pinhole_lecture::{ImplicitUnit, ObjectDerivation, PlaneMeeting, SphereMeeting};

/// Maximum number of curves in the plot: more dash patterns could not be told apart.
pub const MOST: usize = 8;

/// Zeros of f beyond this multiple of the first hit's t are described in words, but lie outside the plot.
const FAR: f64 = 8.0;

/// Height of the plot's lower and upper edge, in the unit of each curve.
const HEIGHTS: [f64; 2] = [-2.4, 4.4];
/// The same if there is only a straight line.
const HEIGHTS_OF_LINE: [f64; 2] = [-0.7, 1.5];

/// Number of intervals between the samples of a curve.
const SAMPLES: usize = 160;

/// Everything that the plot shows.
#[derive(Clone, Debug)]
pub struct Plot {
    /// The objects' functions.
    pub curves: Vec<Curve>,
    /// Number of objects without a curve.
    pub left_out: usize,
    /// The range of t.
    pub range: RangeInclusive<f64>,
    /// The t of the point marked on the ray.
    pub ray_point_t: Option<f64>,
}

/// The function f of one object along the ray.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The object, with its names and its colour.
    pub named: Named,
    /// Index among the curves, which selects the dash pattern.
    pub index: usize,
    /// The derivation of its zeros.
    pub derivation: ObjectDerivation,
    /// The sampled points (t, height) within the plot's range, in ascending order of t.
    pub samples: Vec<(f64, f64)>,
    /// The value of f at the point marked on the ray; NaN without such a point.
    pub at_point: f64,
    /// The unit of f in the plot.
    unit: ImplicitUnit,
    /// The value of f at the eye, where the ray starts.
    at_eye: f64,
    /// For a sphere, whose curve is a parabola: its vertex, and the coefficient a of t^2.
    vertex: Option<(ParabolaVertex, f64)>,
}

/// An object with a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// Index of the object.
    pub object: u32,
    /// The title in lists.
    pub title: String,
    /// The label at the curve.
    pub name: String,
    /// The colour in the views.
    pub color: Color32,
}

/// Returns the objects that have a curve. With at most [`MOST`] objects, these are all of them; otherwise,
/// first the objects that the ray hits, then those that its line meets behind the eye.
pub fn shown(scene: &Scene, inspection: &Inspection) -> Vec<u32> {
    if scene.len() <= MOST {
        return (0..scene.len() as u32).collect();
    }
    let (behind, ahead): (Vec<&Root>, Vec<&Root>) =
        inspection.roots.iter().partition(|root| root.t <= 0.0);
    let mut shown: Vec<u32> = Vec::new();
    for root in ahead.into_iter().chain(behind.into_iter().rev()) {
        if shown.len() < MOST && !shown.contains(&root.object) {
            shown.push(root.object);
        }
    }
    shown.sort_unstable();
    shown
}

/// Returns the plot's range of t. It includes the eye, the viewport, the point marked on the ray, and all
/// zeros of f that are not too far away.
fn range(curves: &[Curve], ray_point_t: Option<f64>) -> RangeInclusive<f64> {
    let mut ts: Vec<f64> = curves.iter().flat_map(Curve::landmarks).collect();
    ts.retain(|t| t.is_finite());
    let hits = curves.iter().filter_map(|curve| curve.derivation.hit());
    let first = hits.map(|root| root.t).fold(f64::INFINITY, f64::min);
    let limit = FAR * if first.is_finite() { first.max(1.0) } else { 4.0 };
    let right = ts.iter().copied().filter(|t| *t <= limit).fold(1.3, f64::max) * 1.2;
    let left = ts.iter().copied().filter(|t| *t >= -right).fold(0.0, f64::min);
    let left = (1.15 * left).min(-0.2 * right);
    let ray_point_t = ray_point_t.unwrap_or(0.0);
    left.min(ray_point_t)..=right.max(ray_point_t)
}

impl Plot {
    /// Creates the plot of these objects along a ray. Leaves out objects without a valid f.
    pub fn new(
        scene: &Scene,
        ray: &ExactRay,
        named: impl Iterator<Item = Named>,
        ray_point_t: Option<f64>,
    ) -> Plot {
        let curve = |(index, named)| Curve::new(index, named, scene, ray);
        let (mut curves, functions): (Vec<Curve>, Vec<AlongRay>) =
            named.enumerate().filter_map(curve).unzip();
        let range = range(&curves, ray_point_t);
        for (curve, along) in curves.iter_mut().zip(&functions) {
            curve.samples = curve.samples(along, &range);
            curve.at_point = ray_point_t.map_or(f64::NAN, |t| along.value(t));
        }
        Plot { left_out: scene.len() - curves.len(), curves, range, ray_point_t }
    }

    /// Returns the heights of the plot's lower and upper edge.
    pub(crate) fn heights(&self) -> [f64; 2] {
        match self.curves.as_slice() {
            [only] if only.is_straight() => HEIGHTS_OF_LINE,
            _ => HEIGHTS,
        }
    }

    /// Returns the value of f at height 1 where the heights are numbered by f itself: if there is a single curve.
    pub fn unit(&self) -> Option<f64> {
        match self.curves.as_slice() {
            [only] => Some(only.unit.value),
            _ => None,
        }
    }

    /// Describes the heights of the curves: the left side of an object's implicit equation with the ray in
    /// it, and its unit if that is not 1. Several objects have f in common, which is 0 on the surface of each.
    pub(crate) fn height_words(&self) -> String {
        if let [only] = self.curves.as_slice() {
            return only.f_words().to_owned();
        }
        let each: BTreeSet<String> = self.curves.iter().map(Curve::height_words).collect();
        match Vec::from_iter(each).as_slice() {
            [one] => one.clone(),
            _ => "f(p + t d), where f = 0 is the surface, each in its own unit".to_owned(),
        }
    }
}

impl Curve {
    /// Creates the curve of an object, without its samples. Returns also the object's f.
    fn new<'a>(
        index: usize,
        named: Named,
        scene: &Scene,
        ray: &ExactRay<'a>,
    ) -> Option<(Curve, AlongRay<'a>)> {
        let object = scene.object(named.object)?;
        let along = AlongRay::new(&object, *ray).ok()?;
        let curve = Curve {
            index,
            derivation: ObjectDerivation::new(&object, named.object, ray).ok()?,
            named,
            samples: Vec::new(),
            at_point: f64::NAN,
            unit: ImplicitUnit::new(&object, &along),
            at_eye: along.value(0.0),
            vertex: along.vertex().map(|v| (v, (along.slope(v.t + 1.0) / 2.0).abs())),
        };
        Some((curve, along))
    }

    /// Returns true if the curve is a straight line, which is the case for a plane.
    pub(crate) fn is_straight(&self) -> bool {
        self.vertex.is_none()
    }

    /// Returns the t of each zero of f or, if a sphere is missed, a t beyond the parabola's vertex.
    fn landmarks(&self) -> Vec<f64> {
        let zeros: Vec<f64> = self.derivation.roots().map(|root| root.t).collect();
        let beyond = |(v, a): (ParabolaVertex, f64)| v.t + (self.unit.value / a).sqrt();
        if zeros.is_empty() { self.vertex.map(beyond).into_iter().collect() } else { zeros }
    }

    /// Returns the left side of the object's implicit equation with the ray in it.
    fn f_words(&self) -> &'static str {
        match self.is_straight() {
            true => "n · (p + t d − point)",
            false => "|p + t d − centre|² − r²",
        }
    }

    fn height_words(&self) -> String {
        format!("{}{}", self.f_words(), self.unit.origin.words())
    }

    /// Describes the unit of f in words.
    pub(crate) fn unit_words(&self, digits: usize) -> String {
        format!("unit {} {}", self.unit.origin.symbol(), equated(self.unit.value, digits))
    }

    /// Returns the height in the plot at which a value of f is drawn.
    pub(crate) fn height(&self, f: f64) -> f64 {
        f / self.unit.value
    }

    /// Returns samples of the curve in ascending order of t: evenly spaced, with additional ones around a
    /// parabola's vertex.
    fn samples(&self, along: &AlongRay, range: &RangeInclusive<f64>) -> Vec<(f64, f64)> {
        let (from, to) = (*range.start(), *range.end());
        let mut ts: Vec<f64> =
            (0..=SAMPLES).map(|k| from + (to - from) * k as f64 / SAMPLES as f64).collect();
        if let Some((vertex, curvature)) = self.vertex {
            let landmarks = self.derivation.roots().map(|root| (root.t - vertex.t).abs());
            let width = landmarks.fold((self.unit.value / curvature).sqrt(), f64::max);
            ts.extend((-24..=24).map(|k| vertex.t + width * f64::from(k) / 8.0));
        }
        ts.extend(self.derivation.roots().map(|root| root.t));
        ts.retain(|t| range.contains(t));
        ts.sort_by(f64::total_cmp);
        let height = |t: f64| (t, self.height(along.value(t)));
        ts.into_iter().map(height).filter(|(_, y)| y.is_finite()).collect()
    }

    /// Describes the curve in words.
    pub(crate) fn description(&self, digits: usize) -> String {
        let zeros: Vec<String> =
            self.derivation.roots().map(|root| equated(root.t, digits)).collect();
        let zero = |k: usize| zeros.get(k).cloned().unwrap_or_else(|| "beyond f64".to_owned());
        match &self.derivation {
            ObjectDerivation::Sphere(sphere) => match sphere.meeting {
                SphereMeeting::Missed => "D < 0: f is never 0: missed".to_owned(),
                SphereMeeting::Tangent => {
                    format!("D = 0: f touches 0 once, at t {}: tangent, so it hits", zero(0))
                }
                SphereMeeting::Through => {
                    format!("D > 0: in at t {}, out at t {}", zero(0), zero(1))
                }
                SphereMeeting::FromInside => format!(
                    "f < 0 at t = 0: the eye is inside; t {} is behind, t {} is its first root ahead",
                    zero(0),
                    zero(1)
                ),
                SphereMeeting::FromSurface => format!(
                    "f = 0 at t = 0, which is no hit; the hit is at t {}",
                    zero(usize::from(sphere.first == Some(1)))
                ),
                SphereMeeting::Behind => {
                    format!("0 only at t {}, not ahead of the eye: no hit", zeros.join(" and t "))
                }
            },
            ObjectDerivation::Plane(plane) => match plane.meeting {
                PlaneMeeting::Ahead => format!("straight line, 0 at t {}", zero(0)),
                PlaneMeeting::Behind => {
                    format!("0 only at t {}, behind the eye: no hit", zero(0))
                }
                PlaneMeeting::AtOrigin => "0 at t = 0, which is no hit".to_owned(),
                PlaneMeeting::Parallel => {
                    format!("n·d = 0: f stays {}, never 0: parallel", number(self.at_eye, digits))
                }
                PlaneMeeting::Within => {
                    "f is 0 at every t: the ray runs in the plane: no hit".to_owned()
                }
            },
        }
    }

    /// Returns true if a point with this value of f is inside the curve's sphere; false for a plane.
    pub(crate) fn is_inside(&self, f: f64) -> bool {
        !self.is_straight() && f < 0.0
    }

    /// Formats a value of f with its meaning.
    pub(crate) fn reading(&self, f: f64, digits: usize) -> String {
        let meaning = match (f.partial_cmp(&0.0), self.is_straight()) {
            (Some(std::cmp::Ordering::Less), false) => "< 0: inside",
            (Some(std::cmp::Ordering::Less), true) => "< 0: on the side that n points away from",
            (Some(std::cmp::Ordering::Greater), false) => "> 0: outside",
            (Some(std::cmp::Ordering::Greater), true) => "> 0: on the side that n points to",
            _ => ": on it",
        };
        format!("f {} {meaning}", equated(f, digits))
    }
}
