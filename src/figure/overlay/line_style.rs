//! The style of a line, and the shapes of arrowheads.

use egui::Color32;

use crate::overlay::{Mark, Shape};
use crate::{Concept, Item};

/// The style of a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineStyle {
    pub(crate) item: Item,
    pub(crate) concept: Option<Concept>,
    pub(crate) color: Color32,
    /// Width in points.
    pub(crate) width: f32,
    pub(crate) halo: bool,
    /// True if the line lies on the viewport, which then does not hide it.
    pub(crate) on_viewport: bool,
    /// True if the line is drawn solid even where an object hides it.
    pub(crate) on_top: bool,
    /// True if the line is dashed even where it is visible. (Hidden parts are always dashed.)
    pub(crate) dashed: bool,
    /// True if hidden parts are left out.
    pub(crate) where_visible: bool,
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

impl LineStyle {
    pub(crate) fn new(item: Item, color: Color32, width: f32) -> LineStyle {
        LineStyle {
            item,
            concept: None,
            color,
            width,
            halo: true,
            on_viewport: false,
            on_top: false,
            dashed: false,
            where_visible: false,
            pattern: None,
        }
    }

    /// Sets the dash and gap, in points, of visible parts.
    pub(crate) fn patterned(self, pattern: Option<[f32; 2]>) -> LineStyle {
        LineStyle { pattern, ..self }
    }

    /// Sets the concept that becomes hovered when the pointer is on the line.
    pub(crate) fn about(self, concept: Concept) -> LineStyle {
        LineStyle { concept: Some(concept), ..self }
    }

    pub(crate) fn on_top(self) -> LineStyle {
        LineStyle { on_top: true, ..self }
    }

    pub(crate) fn dashed(self) -> LineStyle {
        LineStyle { dashed: true, ..self }
    }

    pub(crate) fn where_visible(self) -> LineStyle {
        LineStyle { where_visible: true, ..self }
    }

    pub(crate) fn without_halo(self) -> LineStyle {
        LineStyle { halo: false, ..self }
    }

    pub(crate) fn on_viewport(self) -> LineStyle {
        LineStyle { on_viewport: true, ..self }
    }

    /// Returns the mark of a shape that is visible. If the style asks for a casing, `halo` is the casing's
    /// colour.
    pub(crate) fn mark(self, shape: Shape, halo: Color32) -> Mark {
        let LineStyle { item, concept, color, .. } = self;
        let halo = self.halo.then_some(halo);
        Mark { item, concept, shape, color, halo, hidden: false, pattern: None }
    }
}
