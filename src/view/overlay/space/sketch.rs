//! Converts lines, arrows and points of the world into the marks of a [`Drawing`]: projects them,
//! clips them, and splits them into visible and hidden parts.

use egui::Color32;
use pinhole_core::{DVec2, DVec3};

use crate::model::concept::Concept;
use crate::model::overlay_items::{Item, OverlayItems};
use crate::view::overlay::drawing::{Drawing, Mark, Shape, circle, dot};
use crate::view::overlay::space::labels::Request;
use crate::view::overlay::space::layers::Layers;
use crate::view::overlay::space::screen::{CutLine, Screen, Spot};
use crate::view::overlay::style::Colors;

/// The style of a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pen {
    pub(crate) item: Item,
    pub(crate) concept: Option<Concept>,
    pub(crate) color: Color32,
    /// Width in points.
    pub(crate) width: f32,
    pub(crate) halo: bool,
    /// True if it is drawn on the viewport's rectangle, which then does not hide it.
    pub(crate) on_viewport: bool,
    /// True if nothing hides it.
    pub(crate) on_top: bool,
    /// True if it is dashed even where nothing hides it.
    pub(crate) dashed: bool,
    /// Dash and gap; see [`Mark::pattern`].
    pub(crate) pattern: Option<[f32; 2]>,
}

/// The shape of an arrow's head.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Head {
    /// A filled triangle.
    Filled,
    /// Two strokes.
    Open,
    /// Two filled triangles, one behind the other.
    Double,
}

/// A drawing while it is built.
pub(crate) struct Sketch<'a> {
    pub(crate) screen: Screen,
    pub(crate) layers: &'a Layers<'a>,
    pub(crate) items: OverlayItems,
    /// True if everything has its name: see [`WorldView::names_all`](crate::view::overlay::WorldView).
    pub(crate) names_all: bool,
    pub(crate) colors: &'static Colors,
    pub(crate) drawing: Drawing,
    pub(crate) requests: Vec<Request>,
}

/// Distance, in dots, between two occlusion tests along a line; where they differ, the spot between them
/// is sought by halving, to a quarter of a dot.
const SAMPLE_SPACING: f64 = 3.0;
const HALVINGS: u32 = 3;

/// Length, in points, below which a run is drawn like its neighbour.
const SHORTEST_RUN: f64 = 3.0;

/// A part of a line that is visible, or hidden, as a whole; in shares of its length on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    from: f64,
    to: f64,
    hidden: bool,
}

impl Pen {
    pub(crate) fn new(item: Item, color: Color32, width: f32) -> Pen {
        let (concept, on_viewport, on_top, dashed) = (None, false, false, false);
        let pattern = None;
        Pen { item, concept, color, width, halo: true, on_viewport, on_top, dashed, pattern }
    }

    /// Sets dash and gap, in points, of the visible parts.
    pub(crate) fn patterned(self, pattern: Option<[f32; 2]>) -> Pen {
        Pen { pattern, ..self }
    }

    /// Sets the concept that is hovered when the pointer is on the line.
    pub(crate) fn about(self, concept: Concept) -> Pen {
        Pen { concept: Some(concept), ..self }
    }

    pub(crate) fn on_top(self) -> Pen {
        Pen { on_top: true, ..self }
    }

    pub(crate) fn dashed(self) -> Pen {
        Pen { dashed: true, ..self }
    }

    pub(crate) fn without_halo(self) -> Pen {
        Pen { halo: false, ..self }
    }

    pub(crate) fn on_viewport(self) -> Pen {
        Pen { on_viewport: true, ..self }
    }

    /// Returns the mark of a visible shape, in a casing of the colour `halo` if the pen has one.
    pub(crate) fn mark(self, shape: Shape, halo: Color32) -> Mark {
        Mark {
            item: self.item,
            concept: self.concept,
            shape,
            color: self.color,
            halo: self.halo.then_some(halo),
            hidden: false,
            pattern: None,
        }
    }
}

impl Sketch<'_> {
    pub(crate) fn scale(&self) -> f64 {
        f64::from(self.drawing.scale)
    }

    /// Draws a straight line of the world.
    pub(crate) fn line(&mut self, from: DVec3, to: DVec3, pen: Pen) {
        if self.items.shows(pen.item)
            && let Some(cut) = self.screen.line(from, to)
        {
            self.cut_line(cut.from, cut.to, pen);
        }
    }

    /// Draws an arrow whose head keeps its size on the screen; returns its tip, if that is visible.
    pub(crate) fn arrow(&mut self, from: DVec3, to: DVec3, head: Head, pen: Pen) -> Option<Tip> {
        if !self.items.shows(pen.item) {
            return None;
        }
        let CutLine { from, to, whole_to, .. } = self.screen.line(from, to)?;
        if !whole_to {
            self.cut_line(from, to, pen);
            return None;
        }
        let along = to.at - from.at;
        let length = along.length();
        let full = self.scale() * (4.0 + 3.0 * f64::from(pen.width));
        let Some(direction) = along.try_normalize().filter(|_| length > 0.3 * full) else {
            // It points at the observer, or away: only its end is seen.
            self.disc(to, pen.width + 1.5, pen);
            return Some(Tip { spot: to, direction: DVec2::ZERO });
        };
        let size = full.min(0.8 * length);
        let neck = match head {
            Head::Open => 0.1,
            Head::Filled => 0.7,
            Head::Double => 1.2,
        };
        self.cut_line(from, from.toward(to, 1.0 - (neck * size / length).min(1.0)), pen);
        self.head(to, direction, size, head, pen);
        Some(Tip { spot: to, direction })
    }

    fn head(&mut self, tip: Spot, direction: DVec2, size: f64, head: Head, pen: Pen) {
        let side = direction.perp() * (0.42 * size);
        let triangle = |tip: DVec2| {
            let back = tip - direction * size;
            [tip, back + side, back - side]
        };
        let hidden = self.is_hidden(tip, pen);
        let mut add = |corners: &[DVec2], filled: bool| {
            let mut points: Vec<[f32; 2]> = corners.iter().copied().map(dot).collect();
            let shape = if filled && !hidden {
                Shape::Polygon { points }
            } else {
                if filled {
                    points.push(points[0]);
                }
                let thin = if hidden { 0.6 } else { 1.0 };
                Shape::Line { points, width: thin * pen.width * self.drawing.scale }
            };
            // The head is never dashed, or its shape would be lost.
            let pen = Pen { halo: pen.halo && !hidden, ..pen };
            self.drawing.marks.push(pen.mark(shape, self.colors.halo));
        };
        match head {
            Head::Filled => add(&triangle(tip.at), true),
            Head::Open => {
                let [tip, left, right] = triangle(tip.at);
                add(&[left, tip, right], false);
            }
            Head::Double => {
                add(&triangle(tip.at - direction * (0.7 * size)), true);
                add(&triangle(tip.at), true);
            }
        }
    }

    /// Draws a point of the world as a disc of `radius` points; returns its spot, if that is
    /// visible.
    pub(crate) fn point(&mut self, at: DVec3, radius: f32, pen: Pen) -> Option<Spot> {
        if !self.items.shows(pen.item) {
            return None;
        }
        let spot = self.screen.spot(at)?;
        self.disc(spot, radius, pen);
        Some(spot)
    }

    /// Draws a point of the world as a ring of `radius` points.
    pub(crate) fn ring(&mut self, at: DVec3, radius: f32, pen: Pen) {
        if self.items.shows(pen.item)
            && let Some(spot) = self.screen.spot(at)
        {
            let radius = f64::from(radius * self.drawing.scale);
            let ring = circle(24).map(|point| dot(spot.at + point * radius));
            let shape = Shape::Line { points: ring.collect(), width: 2.4 * self.drawing.scale };
            self.drawing.marks.push(pen.mark(shape, self.colors.halo));
        }
    }

    /// Draws a disc, or a ring if it is hidden.
    fn disc(&mut self, spot: Spot, radius: f32, pen: Pen) {
        let hidden = self.is_hidden(spot, pen);
        let radius = radius * self.drawing.scale;
        let shape = if hidden {
            let ring = circle(24).map(|point| dot(spot.at + point * f64::from(radius)));
            Shape::Line { points: ring.collect(), width: 1.2 * self.drawing.scale }
        } else {
            Shape::Disc { center: dot(spot.at), radius }
        };
        self.drawing.marks.push(pen.mark(shape, self.colors.halo));
    }

    /// Draws the sides of a polygon of the world.
    pub(crate) fn sides<const N: usize>(&mut self, corners: [DVec3; N], pen: Pen) {
        for k in 0..N {
            self.line(corners[k], corners[(k + 1) % N], pen);
        }
    }

    /// Draws what is in the picture of a flat convex polygon, if one of its corners is not hidden.
    pub(crate) fn polygon(&mut self, corners: &[DVec3], pen: Pen) {
        if !self.items.shows(pen.item) {
            return;
        }
        let spots = self.screen.polygon(corners);
        let seen = spots.iter().any(|spot| !self.is_hidden(*spot, pen));
        if seen {
            let shape = Shape::Polygon { points: spots.iter().map(|s| dot(s.at)).collect() };
            self.drawing.marks.push(pen.mark(shape, self.colors.halo));
        }
    }

    /// Requests a label.
    pub(crate) fn label(
        &mut self,
        pen: Pen,
        text: impl Into<String>,
        anchor: DVec2,
        toward: DVec2,
        font: (Color32, f32, bool),
    ) {
        let inside = anchor.cmpge(DVec2::ZERO).all() && anchor.cmple(self.screen.size).all();
        if self.items.shows(Item::Labels) && self.items.shows(pen.item) && inside {
            let anchors = (anchor, toward);
            self.requests.push(Request::new(pen, text.into(), anchors, font, self.colors.halo));
        }
    }

    fn is_hidden(&self, spot: Spot, pen: Pen) -> bool {
        !pen.on_top && self.layers.hides(spot.at, 1.0 / spot.inverse_t, pen.on_viewport)
    }

    fn cut_line(&mut self, from: Spot, to: Spot, pen: Pen) {
        let scale = self.drawing.scale;
        for run in self.runs(from, to, pen) {
            let points = [run.from, run.to].map(|s| dot(from.toward(to, s).at)).to_vec();
            let thin = if run.hidden { 0.65 } else { 1.0 };
            let dashed = run.hidden || pen.dashed;
            let shape = Shape::Line { points, width: thin * pen.width * scale };
            let pen = Pen { halo: pen.halo && !dashed, ..pen };
            let mark = pen.mark(shape, self.colors.halo);
            self.drawing.marks.push(Mark { hidden: dashed, pattern: pen.pattern, ..mark });
        }
    }

    fn runs(&self, from: Spot, to: Spot, pen: Pen) -> Vec<Run> {
        let length = (to.at - from.at).length();
        let count = (length / SAMPLE_SPACING).ceil().clamp(1.0, 16_384.0);
        let shortest = SHORTEST_RUN * self.scale() / length.max(1e-9);
        let is_hidden = |share: f64| self.is_hidden(from.toward(to, share), pen);
        let mut runs: Vec<Run> = Vec::new();
        for k in 0..count as u32 {
            let share = (f64::from(k) + 0.5) / count;
            let hidden = is_hidden(share);
            match runs.last_mut() {
                Some(last) if last.hidden == hidden => last.to = share,
                Some(last) => {
                    let (mut before, mut after) = (last.to, share);
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (before + after);
                        let side =
                            if is_hidden(middle) == hidden { &mut after } else { &mut before };
                        *side = middle;
                    }
                    last.to = 0.5 * (before + after);
                    let from = last.to;
                    runs.push(Run { from, to: share, hidden });
                }
                None => runs.push(Run { from: 0.0, to: share, hidden }),
            }
        }
        if let Some(last) = runs.last_mut() {
            last.to = 1.0;
        }
        merged(&runs, shortest)
    }
}

/// Merges runs shorter than `shortest` into the run before them.
fn merged(runs: &[Run], shortest: f64) -> Vec<Run> {
    let mut merged: Vec<Run> = Vec::new();
    for run in runs {
        match merged.last_mut() {
            Some(last) if last.hidden == run.hidden || run.to - run.from < shortest => {
                last.to = run.to;
            }
            // The first run of a line has no run before it.
            Some(last) if last.to - last.from < shortest => {
                *last = Run { from: last.from, ..*run };
            }
            _ => merged.push(*run),
        }
    }
    merged
}

/// The tip of an arrow on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tip {
    pub(crate) spot: Spot,
    /// Direction of length 1, or zero for an arrow that points at the observer.
    pub(crate) direction: DVec2,
}
