//! Converts lines, arrows and points of the world into the marks of a [`Drawing`]: they are projected,
//! clipped, and split into visible and hidden parts.

use pinhole_core::{DVec2, DVec3};

use crate::overlay::{
    Colors, CutLine, Drawing, Head, LabelFont, Layers, LineStyle, Mark, Request, Screen, Shape,
    Spot, WorldView, dot,
};

/// A drawing while it is built.
pub(crate) struct Sketch<'a> {
    pub(crate) view: &'a WorldView,
    pub(crate) screen: Screen,
    pub(crate) layers: &'a Layers<'a>,
    /// True if labels are written.
    pub(crate) has_labels: bool,
    pub(crate) colors: &'static Colors,
    pub(crate) drawing: Drawing,
    pub(crate) requests: Vec<Request>,
    /// True while what is drawn is faded, because a concept is highlighted.
    pub(crate) fades: bool,
}

/// Distance, in screen pixels, between two points of a line at which it is tested whether an object hides
/// them. Where the results differ, bisection locates the change to within a quarter of a pixel.
const SAMPLE_SPACING: f64 = 3.0;
/// Number of steps of this bisection.
const HALVINGS: u32 = 3;

/// Length, in points, below which a visible or hidden part of a line is drawn like the part before it.
const SHORTEST_RUN: f64 = 3.0;

/// A part of a line that is either entirely visible or entirely hidden. Its ends are fractions of the
/// line's length on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
struct LinePart {
    from: f64,
    to: f64,
    hidden: bool,
}

impl Sketch<'_> {
    /// Adds a visible mark.
    pub(crate) fn add(&mut self, pen: LineStyle, shape: Shape) {
        self.push(pen.mark(shape, self.colors.background));
    }

    fn push(&mut self, mut mark: Mark) {
        if self.fades {
            mark.color = self.colors.faded(mark.color);
        }
        self.drawing.marks.push(mark);
    }

    /// Draws a straight line in the world.
    pub(crate) fn line(&mut self, from: DVec3, to: DVec3, pen: LineStyle) {
        if let Some(cut) = self.screen.line(from, to) {
            self.cut_line(cut.from, cut.to, pen);
        }
    }

    /// Draws an arrow whose head has a constant size on the screen. Returns the position of the tip and the
    /// arrow's direction on the screen, or `None` if the tip is not in the picture. The direction is a unit
    /// vector, or zero if the arrow points along the line of sight.
    pub(crate) fn arrow(
        &mut self,
        ends: [DVec3; 2],
        head: Head,
        pen: LineStyle,
    ) -> Option<[DVec2; 2]> {
        let CutLine { from, to, whole_to, .. } = self.screen.line(ends[0], ends[1])?;
        if !whole_to {
            self.cut_line(from, to, pen);
            return None;
        }
        let along = to.at - from.at;
        let length = along.length();
        let full = self.screen.scale * (4.0 + 3.0 * f64::from(pen.width));
        let Some(direction) = along.try_normalize().filter(|_| length > 0.3 * full) else {
            // The arrow points almost along the line of sight, so only its tip is visible.
            self.disc(to, pen.width + 1.5, pen);
            return Some([to.at, DVec2::ZERO]);
        };
        let size = full.min(0.8 * length);
        let neck = match head {
            Head::Open => 0.1,
            Head::Filled => 0.7,
            Head::Double => 1.2,
        };
        self.cut_line(from, from.toward(to, 1.0 - (neck * size / length).min(1.0)), pen);
        self.head(to, direction, size, head, pen);
        Some([to.at, direction])
    }

    fn head(&mut self, tip: Spot, direction: DVec2, size: f64, head: Head, pen: LineStyle) {
        let side = direction.perp() * (0.42 * size);
        let triangle = |tip: DVec2| {
            let back = tip - direction * size;
            [tip, back + side, back - side]
        };
        let hidden = self.is_hidden(tip, pen);
        let scale = self.drawing.scale;
        let mut add = |corners: &[DVec2], filled: bool| {
            let mut points: Vec<[f32; 2]> = corners.iter().copied().map(dot).collect();
            let shape = if filled && !hidden {
                Shape::Polygon { points }
            } else {
                if filled {
                    points.push(points[0]);
                }
                let thin = if hidden { 0.6 } else { 1.0 };
                Shape::Line { points, width: thin * pen.width * scale }
            };
            // The head is never dashed, because dashes would hide its shape.
            self.add(pen, shape);
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

    /// Draws a point in the world as a disc of `radius` points. Returns its position on the screen, or
    /// `None` if it is not in the picture.
    pub(crate) fn point(&mut self, at: DVec3, radius: f32, pen: LineStyle) -> Option<Spot> {
        let spot = self.screen.spot(at)?;
        self.disc(spot, radius, pen);
        Some(spot)
    }

    /// Draws a disc, or a ring if an object hides it.
    fn disc(&mut self, spot: Spot, radius: f32, pen: LineStyle) {
        let hidden = self.is_hidden(spot, pen);
        if hidden && pen.where_visible {
            return;
        }
        let radius = radius * self.drawing.scale;
        let shape = if hidden {
            Shape::ring(spot.at, radius.into(), 24, 1.2 * self.drawing.scale)
        } else {
            Shape::Disc { center: dot(spot.at), radius }
        };
        self.add(pen, shape);
    }

    /// Draws the sides of a polygon in the world.
    pub(crate) fn sides(&mut self, corners: &[DVec3], pen: LineStyle) {
        for (k, corner) in corners.iter().enumerate() {
            self.line(*corner, corners[(k + 1) % corners.len()], pen);
        }
    }

    /// Draws the part inside the picture of a flat convex polygon. Draws nothing if objects hide all of its
    /// corners.
    pub(crate) fn polygon(&mut self, corners: &[DVec3], pen: LineStyle) {
        let spots = self.screen.polygon(corners);
        let is_visible = spots.iter().any(|spot| !self.is_hidden(*spot, pen));
        if is_visible {
            let shape = Shape::polygon(&spots.iter().map(|spot| spot.at).collect::<Vec<_>>());
            self.add(pen, shape);
        }
    }

    /// Requests a label, which is placed later. `at` is the anchor (the point that the label names) and the
    /// preferred direction from there. Ignores the request if the anchor is outside the picture.
    pub(crate) fn label(&mut self, pen: LineStyle, text: &str, at: [DVec2; 2], font: LabelFont) {
        let inside = at[0].cmpge(DVec2::ZERO).all() && at[0].cmple(self.screen.size).all();
        if self.has_labels && inside {
            self.request(Request::new(pen, text.to_owned(), at, font, self.colors.background));
        }
    }

    pub(crate) fn request(&mut self, mut request: Request) {
        if self.fades {
            self.colors.fade(&mut request.label);
        }
        self.requests.push(request);
    }

    fn is_hidden(&self, spot: Spot, pen: LineStyle) -> bool {
        !pen.on_top && self.layers.hides(spot.at, 1.0 / spot.inverse_t, pen.on_viewport)
    }

    fn cut_line(&mut self, from: Spot, to: Spot, pen: LineStyle) {
        let scale = self.drawing.scale;
        let runs = self.runs(from, to, pen).into_iter();
        for run in runs.filter(|run| !(run.hidden && pen.where_visible)) {
            let points = [run.from, run.to].map(|s| dot(from.toward(to, s).at)).to_vec();
            let thin = if run.hidden { 0.65 } else { 1.0 };
            let dashed = run.hidden || pen.dashed;
            let shape = Shape::Line { points, width: thin * pen.width * scale };
            let mark = pen.mark(shape, self.colors.background);
            self.push(Mark { hidden: dashed, pattern: pen.pattern, ..mark });
        }
    }

    fn runs(&self, from: Spot, to: Spot, pen: LineStyle) -> Vec<LinePart> {
        let length = (to.at - from.at).length();
        let count = (length / SAMPLE_SPACING).ceil().clamp(1.0, 16_384.0);
        let shortest = SHORTEST_RUN * self.screen.scale / length.max(1e-9);
        let is_hidden = |share: f64| self.is_hidden(from.toward(to, share), pen);
        let mut runs: Vec<LinePart> = Vec::new();
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
                    runs.push(LinePart { from, to: share, hidden });
                }
                None => runs.push(LinePart { from: 0.0, to: share, hidden }),
            }
        }
        if let Some(last) = runs.last_mut() {
            last.to = 1.0;
        }
        merged(&runs, shortest)
    }
}

/// Merges parts shorter than `shortest` with the part before them.
fn merged(runs: &[LinePart], shortest: f64) -> Vec<LinePart> {
    let mut merged: Vec<LinePart> = Vec::new();
    for run in runs {
        match merged.last_mut() {
            Some(last) if last.hidden == run.hidden || run.to - run.from < shortest => {
                last.to = run.to;
            }
            // A short first part has no part before it, so it joins the next one.
            Some(last) if last.to - last.from < shortest => {
                *last = LinePart { from: last.from, ..*run };
            }
            _ => merged.push(*run),
        }
    }
    merged
}
