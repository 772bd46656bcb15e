//! Text with a halo, the same in the window and in files: one primitive for the overlay's labels and for
//! the words in drawings.

use std::sync::Arc;

use egui::epaint::TextShape;
use egui::{Color32, FontFamily, FontId, Galley, Painter, Pos2, Shape, Vec2, vec2};

use crate::view::overlay::Label;

/// Laid-out text with a halo around its letters, which keeps it legible over anything.
///
/// egui has no such shape. It is given to egui as a [`Shape::Vec`]: the text in the halo's colour eight
/// times around its position, and then the text. Figures [read it back](HaloText::from_shape) as one
/// text.
pub(crate) struct HaloText {
    pub(crate) text: TextShape,
    pub(crate) halo: Color32,
}

impl HaloText {
    /// Width of the halo, in points.
    pub(crate) const REACH: f32 = 1.3;

    /// Creates text whose left top corner is at `at`.
    pub(crate) fn new(at: Pos2, galley: Arc<Galley>, color: Color32, halo: Color32) -> HaloText {
        HaloText { text: TextShape::new(at, galley, color), halo }
    }

    /// Returns the shape that egui paints.
    pub(crate) fn into_shape(self) -> Shape {
        let copy = |k: u8| {
            let away = Vec2::angled(f32::from(k) * std::f32::consts::FRAC_PI_4);
            let mut copy = self.text.clone();
            copy.pos += HaloText::REACH * away;
            copy.override_text_color = Some(self.halo);
            Shape::Text(copy)
        };
        let mut shapes: Vec<Shape> = (0..8).map(copy).collect();
        shapes.push(Shape::Text(self.text));
        Shape::Vec(shapes)
    }

    /// Reads back what [`HaloText::into_shape`] made; `None` for every other shape.
    #[cfg(feature = "figures")]
    pub(crate) fn from_shape(shape: &Shape) -> Option<HaloText> {
        let Shape::Vec(shapes) = shape else { return None };
        let [Shape::Text(copy), .., Shape::Text(text)] = shapes.as_slice() else { return None };
        let halo = copy.override_text_color?;
        Arc::ptr_eq(&copy.galley, &text.galley).then(|| HaloText { text: text.clone(), halo })
    }
}

/// Writes a label of a picture whose upper left corner is at `origin`.
pub(crate) fn write(painter: &Painter, origin: Pos2, per_point: f32, label: &Label) {
    let center = origin + vec2(label.position[0], label.position[1]) / per_point;
    let family =
        if label.bold { FontFamily::Name("bold".into()) } else { FontFamily::Proportional };
    let font = FontId::new(label.size, family);
    let galley = painter.layout_no_wrap(label.text.clone(), font, label.color);
    let min = center - 0.5 * galley.size();
    painter.add(HaloText::new(min, galley, label.color, label.halo).into_shape());
}
