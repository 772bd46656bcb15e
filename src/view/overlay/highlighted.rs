//! Highlighting of a concept: it is drawn again, thicker and on top, even if its overlay item is
//! switched off. Where it is spoken of, and not only pointed at, everything else is dimmed.
//!
//! `highlighted_world` does so in the world view, `highlighted_camera` in the camera view.

use egui::Color32;
use pinhole_core::{Camera, DVec3, Scene, Sphere};
use pinhole_lecture::numbers::written;

use crate::model::concept::Concept;
use crate::view::overlay::drawing::{Drawing, circle};
use crate::view::overlay::space::labels::Request;
use crate::view::overlay::space::screen::tangents;
use crate::view::overlay::space::sketch::Pen;

/// The highlighted concept, and what is needed to draw it.
#[derive(Clone, Copy, Debug)]
pub struct Highlighted<'a> {
    /// The concept.
    pub concept: Concept,
    /// The edited camera as given.
    pub camera: &'a Camera,
    /// The scene of the camera.
    pub scene: &'a Scene,
    /// Significant digits of numbers.
    pub digits: usize,
    /// True if everything else is dimmed.
    pub dims: bool,
}

impl Highlighted<'_> {
    /// Formats a number for a label.
    pub(super) fn number(&self, x: f64) -> String {
        written(x, self.digits.min(LABEL_DIGITS))
    }

    /// Returns `=` if a label shows all of these numbers exactly, or else `≈`.
    pub(super) fn relation(&self, shown: &[f64]) -> char {
        let is_exact = |x: &f64| self.number(*x).parse() == Ok(*x);
        if shown.iter().all(is_exact) { '=' } else { '≈' }
    }

    /// Formats an angle, given in radians, in degrees for a label.
    pub(super) fn degrees(&self, angle: f64) -> String {
        format!("{}°", self.number(angle.to_degrees()))
    }
}

/// Maximum number of significant digits of a label: it must not cover what it is about.
const LABEL_DIGITS: usize = 4;

/// Opacity of the other marks.
const DIMMED: f32 = 0.42;

/// Labels of the parts of a view ray's direction.
pub(super) const ALONG: [(Concept, &str); 3] =
    [(Concept::AlongW, "−distance 𝐰"), (Concept::AlongU, "𝑢 𝐮"), (Concept::AlongV, "𝑣 𝐯")];

/// Widths of highlighted lines and of those beside them, in points.
pub(super) const STRONG: f32 = 5.0;
pub(super) const BESIDE: f32 = 3.0;

/// Removes the concept's own marks and labels, which are drawn again, and dims the others if it does.
pub(super) fn dim(drawing: &mut Drawing, requests: &mut Vec<Request>, highlighted: Highlighted) {
    let concept = highlighted.concept;
    drawing.marks.retain(|mark| mark.concept != Some(concept));
    requests.retain(|request| request.concept != Some(concept));
    if !highlighted.dims {
        return;
    }
    for mark in &mut drawing.marks {
        mark.color = mark.color.gamma_multiply(DIMMED);
        mark.halo = mark.halo.map(|halo| halo.gamma_multiply(DIMMED));
    }
    for request in requests {
        request.label.color = request.label.color.gamma_multiply(DIMMED);
    }
}

/// Puts the concept's own labels first, so that they get the best places, and removes repeated
/// names.
pub(super) fn first(mut own: Vec<Request>, mut others: Vec<Request>) -> Vec<Request> {
    own.iter_mut().for_each(|request| request.rank = 0);
    others.retain(|other| own.iter().all(|request| request.label.text != other.label.text));
    own.into_iter().chain(others).collect()
}

/// Returns a pen's casing and the pen. A chain of short lines needs one casing as a whole, below
/// all of it.
pub(super) fn cased(pen: Pen, halo: Color32) -> [Pen; 2] {
    let pen = pen.without_halo();
    [Pen { color: halo, width: pen.width + 2.5, ..pen }, pen]
}

/// Returns the silhouette circle of a sphere as seen from a point; `None` from inside.
pub(super) fn silhouette(sphere: &Sphere, from: DVec3) -> Option<Vec<DVec3>> {
    let out = from - sphere.center;
    let distance = out.length();
    let share = sphere.radius / distance;
    if share.is_nan() || share >= 1.0 {
        return None;
    }
    let axis = out / distance;
    let (a, b) = tangents(axis);
    let center = sphere.center + sphere.radius * share * axis;
    let radius = sphere.radius * (1.0 - share * share).sqrt();
    Some(circle(96).map(|p| center + radius * (p.x * a + p.y * b)).collect())
}
