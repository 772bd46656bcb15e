//! What the plot of f(p + t d) shows: which objects, over which t, each in its own unit, and what is
//! said of each.

use std::ops::RangeInclusive;

use egui::Color32;
use pinhole_core::lecture::{AlongRay, ObjectDerivation, PlaneMeeting, SphereMeeting};
use pinhole_core::{ExactRay, Object, Root, Scene};

use crate::document::Document;
use crate::inspection::Inspection;
use crate::panels::lines::number;

/// More curves than this cannot be told apart.
pub(super) const MOST: usize = 8;

/// Zeros farther out than so many times the first hit are said in words only.
const FAR: f64 = 8.0;

/// Values at this many times from one end of the plot to the other.
const SAMPLES: usize = 160;

/// One object's f along the ray.
pub(super) struct Curve<'a> {
    /// Which object.
    pub(super) object: u32,
    /// Its place among the curves, which decides its dashes.
    pub(super) place: usize,
    /// What lists call it.
    pub(super) title: String,
    /// What stands at the curve.
    pub(super) name: String,
    pub(super) color: Color32,
    /// f, as a function of t.
    pub(super) along: AlongRay<'a>,
    pub(super) derivation: ObjectDerivation,
    /// f is drawn in multiples of this.
    pub(super) unit: f64,
}

/// The objects to show, and how many are left out: all where they are few, otherwise those that the
/// ray meets first, then those behind the eye.
pub(super) fn curves<'a>(
    scene: &Scene,
    ray: &ExactRay<'a>,
    inspection: &Inspection,
    document: &Document,
) -> (Vec<Curve<'a>>, usize) {
    let mut shown: Vec<u32> = Vec::new();
    if scene.len() <= MOST {
        shown.extend(0..scene.len() as u32);
    } else {
        let (behind, ahead): (Vec<&Root>, Vec<&Root>) =
            inspection.roots.iter().partition(|root| root.t <= 0.0);
        for root in ahead.into_iter().chain(behind.into_iter().rev()) {
            if shown.len() < MOST && !shown.contains(&root.object) {
                shown.push(root.object);
            }
        }
        shown.sort_unstable();
    }
    let of = |(place, &object): (usize, &u32)| {
        let shape = scene.object(object)?;
        let along = AlongRay::new(&shape, *ray).ok()?;
        let derivation = ObjectDerivation::of(&shape, object, ray).ok()?;
        let [r, g, b] = document.color_of(object);
        let title = document.title_of(object as usize);
        let name = document.name_of(object).map_or_else(|| title.clone(), str::to_owned);
        let unit = unit_of(&shape, &along);
        let color = Color32::from_rgb(r, g, b);
        Some(Curve { object, place, title, name, color, along, derivation, unit })
    };
    let curves: Vec<Curve> = shown.iter().enumerate().filter_map(of).collect();
    let left_out = scene.len() - curves.len();
    (curves, left_out)
}

/// A sphere's f is −r² at its centre; a plane's is measured against that at the eye, or, where that
/// is 0, at t = 1.
fn unit_of(object: &Object, along: &AlongRay) -> f64 {
    let unit = match object {
        Object::Sphere(sphere) => sphere.radius * sphere.radius,
        Object::Plane(_) => match along.value(0.0).abs() {
            0.0 => along.value(1.0).abs(),
            at_eye => at_eye,
        },
    };
    if unit.is_normal() { unit } else { 1.0 }
}

/// Even up to 1, compressed beyond: 1 more is 2.7 times as much. Smooth, and it keeps the sign.
pub(super) fn compressed(y: f64) -> f64 {
    let size = y.abs();
    if size <= 1.0 { y } else { (1.0 + size.ln()).copysign(y) }
}

/// Which t the plot shows: all zeros that are not far, the eye, the viewport, and where one walks.
pub(super) fn range(curves: &[Curve], walked: Option<f64>) -> RangeInclusive<f64> {
    let mut ts: Vec<f64> = curves.iter().flat_map(Curve::landmarks).collect();
    ts.retain(|t| t.is_finite());
    let hits = curves.iter().filter_map(|curve| curve.derivation.hit());
    let first = hits.map(|root| root.t).fold(f64::INFINITY, f64::min);
    let limit = FAR * if first.is_finite() { first.max(1.0) } else { 4.0 };
    let right = ts.iter().copied().filter(|t| *t <= limit).fold(1.3, f64::max) * 1.2;
    let left = ts.iter().copied().filter(|t| *t >= -right).fold(0.0, f64::min);
    let left = (1.15 * left).min(-0.2 * right);
    let walked = walked.unwrap_or(0.0);
    left.min(walked)..=right.max(walked)
}

impl Curve<'_> {
    /// Where something is to be seen: zeros, and where a sphere is missed most narrowly.
    fn landmarks(&self) -> Vec<f64> {
        let zeros: Vec<f64> = self.derivation.roots().map(|root| root.t).collect();
        if zeros.is_empty() {
            self.along.vertex().map(|v| v.t).into_iter().collect()
        } else {
            zeros
        }
    }

    /// What f is drawn in multiples of, in words.
    pub(super) fn unit_words(&self, digits: usize) -> String {
        let unit = number(self.unit, digits);
        match self.derivation {
            ObjectDerivation::Sphere(_) => format!("unit r² = {unit}"),
            ObjectDerivation::Plane(_) if self.along.value(0.0) != 0.0 => {
                format!("unit |f(p)| = {unit}")
            }
            ObjectDerivation::Plane(_) => format!("unit |f(p + d)| = {unit}"),
        }
    }

    /// f in its unit, compressed.
    pub(super) fn height(&self, t: f64) -> f64 {
        compressed(self.along.value(t) / self.unit)
    }

    /// t and height, by ascending t: evenly, and closely where a parabola turns.
    pub(super) fn samples(&self, range: &RangeInclusive<f64>) -> Vec<(f64, f64)> {
        let (from, to) = (*range.start(), *range.end());
        let mut ts: Vec<f64> =
            (0..=SAMPLES).map(|k| from + (to - from) * k as f64 / SAMPLES as f64).collect();
        if let Some(vertex) = self.along.vertex() {
            let landmarks = self.derivation.roots().map(|root| (root.t - vertex.t).abs());
            let slope = (self.along.slope(vertex.t + 1.0) / 2.0).abs();
            let width = landmarks.fold((self.unit / slope).sqrt(), f64::max);
            ts.extend((-24..=24).map(|k| vertex.t + width * f64::from(k) / 8.0));
        }
        ts.extend(self.derivation.roots().map(|root| root.t));
        ts.retain(|t| range.contains(t));
        ts.sort_by(f64::total_cmp);
        ts.into_iter().map(|t| (t, self.height(t))).filter(|(_, y)| y.is_finite()).collect()
    }

    /// What the curve says, in words.
    pub(super) fn words(&self, digits: usize) -> String {
        let zeros: Vec<String> =
            self.derivation.roots().map(|root| number(root.t, digits)).collect();
        let zero = |k: usize| zeros.get(k).cloned().unwrap_or_else(|| "beyond f64".to_owned());
        match &self.derivation {
            ObjectDerivation::Sphere(sphere) => match sphere.meeting {
                SphereMeeting::Missed => "D < 0: f is never 0: missed".to_owned(),
                SphereMeeting::Tangent => {
                    format!("D = 0: f touches 0 once, at t = {}: tangent: hit", zero(0))
                }
                SphereMeeting::Through => {
                    format!("D > 0: in at t = {}, out at t = {}", zero(0), zero(1))
                }
                SphereMeeting::FromInside => format!(
                    "f < 0 at t = 0: the eye is inside; {} is behind, {} is its first root ahead",
                    zero(0),
                    zero(1)
                ),
                SphereMeeting::FromSurface => format!(
                    "f = 0 at t = 0, which is no hit; the hit is t = {}",
                    zero(usize::from(sphere.first == Some(1)))
                ),
                SphereMeeting::Behind => {
                    format!("0 only at t = {}, not ahead of the eye: no hit", zeros.join(" and "))
                }
            },
            ObjectDerivation::Plane(plane) => match plane.meeting {
                PlaneMeeting::Ahead => format!("straight line, 0 at t = {}", zero(0)),
                PlaneMeeting::Behind => {
                    format!("0 only at t = {}, behind the eye: no hit", zero(0))
                }
                PlaneMeeting::AtOrigin => "0 at t = 0, which is no hit".to_owned(),
                PlaneMeeting::Parallel => {
                    format!("n·d = 0: f stays {}, never 0: parallel", self.value_text(0.0, digits))
                }
                PlaneMeeting::Within => {
                    "f is 0 at every t: the ray runs in the plane: no hit".to_owned()
                }
            },
        }
    }

    fn value_text(&self, t: f64, digits: usize) -> String {
        number(self.along.value(t), digits)
    }

    /// Whether the point at t is inside of a sphere.
    pub(super) fn is_inside(&self, t: f64) -> bool {
        matches!(self.derivation, ObjectDerivation::Sphere(_)) && self.along.value(t) < 0.0
    }

    /// f at t, and what it means.
    pub(super) fn reading(&self, t: f64, digits: usize) -> String {
        let is_sphere = matches!(self.derivation, ObjectDerivation::Sphere(_));
        let f = self.along.value(t);
        let meaning = match (f.partial_cmp(&0.0), is_sphere) {
            (Some(std::cmp::Ordering::Less), true) => "< 0: inside",
            (Some(std::cmp::Ordering::Less), false) => "< 0: where n points away from",
            (Some(std::cmp::Ordering::Greater), true) => "> 0: outside",
            (Some(std::cmp::Ordering::Greater), false) => "> 0: where n points to",
            _ => ": on it",
        };
        format!("f = {} {meaning}", self.value_text(t, digits))
    }
}

#[cfg(test)]
mod tests {
    use super::compressed;

    #[test]
    fn compression_keeps_sign_and_order() {
        let ys = [-1e9, -3.0, -1.0, -0.2, 0.0, 0.2, 1.0, 3.0, 1e9];
        let heights = ys.map(compressed);
        assert!(heights.windows(2).all(|pair| pair[0] < pair[1]), "{heights:?}");
        assert_eq!(compressed(-0.25), -0.25);
        assert_eq!(compressed(-5.0), -compressed(5.0));
    }
}
