//! Draws the handles, on top of everything else and at a constant size on the screen. A hovered or held
//! handle is larger.

use pinhole_core::{DVec2, DVec3};

use crate::overlay::{LineStyle, Shape, Sketch, dot};
use crate::overlay_items::Item;

/// The handles to draw, and data that is only needed while one of them is hovered or dragged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Handles {
    /// The handles.
    pub marks: Vec<HandleMark>,
    /// Length in the world of the up arrow while its tip is dragged; `None` at other times.
    pub up: Option<f64>,
}

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleMark {
    /// The position in the world.
    pub at: DVec3,
    /// The shape.
    pub knob: Knob,
    /// The state: plain, hovered or held.
    pub state: KnobState,
}

/// The shape of a handle, which shows how the handle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Moves freely.
    Round,
    /// Moves in the viewport's plane.
    Square,
    /// Changes a single number, such as a radius.
    Diamond,
}

/// The state of a handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnobState {
    /// Small, with an empty middle.
    Plain,
    /// Hovered: large, with an empty middle.
    Over,
    /// Held: large and filled, with a ring around it.
    Held,
}

impl KnobState {
    /// Distance from the middle to the edge, in points.
    fn radius(self) -> f64 {
        if self == KnobState::Plain { PLAIN } else { LARGE }
    }
}

/// Distance from the middle of a plain handle to its edge, in points.
const PLAIN: f64 = 6.0;
/// Distance from the middle of a hovered or held handle to its edge, in points.
const LARGE: f64 = 10.0;

/// Width of the rim around the empty middle, in points.
const RIM: f64 = 2.4;

impl Sketch<'_> {
    /// Draws all handles; the hovered or held one is drawn last.
    pub(crate) fn handles(&mut self) {
        if !self.view.figure.items.shows(Item::Handles) {
            return;
        }
        for (mark, spot) in self.without_overlaps(&self.view.handles).into_iter().rev() {
            self.knob(mark, spot);
        }
    }

    /// Returns the handles to draw, with hovered or held ones first. Leaves out each handle that would
    /// overlap an earlier one.
    fn without_overlaps<'h>(&self, marks: &'h [HandleMark]) -> Vec<(&'h HandleMark, DVec2)> {
        let (plain, others): (Vec<&HandleMark>, Vec<&HandleMark>) =
            marks.iter().partition(|mark| mark.state == KnobState::Plain);
        let mut shown: Vec<(&HandleMark, DVec2)> = Vec::new();
        for mark in others.into_iter().chain(plain) {
            let Some(spot) = self.screen.spot(mark.at) else { continue };
            let is_free = shown.iter().all(|(other, at)| {
                at.distance(spot.at)
                    >= self.screen.scale * (mark.state.radius() + other.state.radius())
            });
            if is_free {
                shown.push((mark, spot.at));
            }
        }
        shown
    }

    fn knob(&mut self, mark: &HandleMark, at: DVec2) {
        let (ink, halo, scale) = (self.colors.hit, self.colors.background, self.screen.scale);
        let radius = scale * mark.state.radius();
        let mut add = |shape: Shape, color, cased: bool| {
            let pen = LineStyle { halo: cased, ..LineStyle::new(Item::Handles, color, 0.0) };
            self.drawing.marks.push(pen.mark(shape, halo));
        };
        if mark.state == KnobState::Held {
            add(Shape::ring(at, 1.7 * radius, 48, 2.4 * scale as f32), ink, true);
        }
        add(filled(mark.knob, at, radius), ink, true);
        if mark.state != KnobState::Held {
            add(filled(mark.knob, at, radius - RIM * scale), halo, false);
        }
    }
}

fn filled(knob: Knob, at: DVec2, radius: f64) -> Shape {
    let corners = |spokes: [[f64; 2]; 4], size: f64| {
        Shape::polygon(&spokes.map(|[x, y]| at + size * DVec2::new(x, y)))
    };
    match knob {
        Knob::Round => Shape::Disc { center: dot(at), radius: radius as f32 },
        Knob::Square => {
            corners([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.88 * radius)
        }
        Knob::Diamond => corners([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]], 1.25 * radius),
    }
}
