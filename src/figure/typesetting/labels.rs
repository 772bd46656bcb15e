//! Labels in pictures and drawings: text with a halo that keeps it legible over lines, and a layout that
//! keeps labels from overlapping. The window and the figures use the same shapes.

use std::sync::Arc;

use egui::epaint::TextShape;
use egui::{Align2, Color32, FontFamily, FontId, Galley, Painter, Pos2, Rect, Shape, Vec2, vec2};

use crate::overlay::Label;
use crate::typesetting::notation::formula;
use crate::typesetting::theme;

/// The look of a label.
#[derive(Clone, Copy)]
pub struct Font {
    /// Size in points.
    pub size: f32,
    /// The colour of its letters.
    pub color: Color32,
    /// True if it is bold.
    pub bold: bool,
}

/// Places labels in a drawing so that they do not overlap.
pub struct LabelLayout {
    painter: Painter,
    halo: Color32,
    within: Rect,
    taken: Vec<Rect>,
}

impl LabelLayout {
    /// Creates a layout for an area of a drawing; halos have the colour `halo`.
    pub fn new(painter: Painter, halo: Color32, within: Rect) -> LabelLayout {
        LabelLayout { painter, halo, within, taken: Vec::new() }
    }

    /// Reserves a rectangle, over which no label will be written.
    pub fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Writes a label at the first of `anchors` at which it fits into the area and overlaps nothing.
    /// Returns its rectangle, or `None` if it fits nowhere. Text that is not bold is typeset as a formula.
    pub fn write(
        &mut self,
        text: &str,
        font: Font,
        anchors: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        self.write_clear_of(&[], text, font, anchors)
    }

    /// Like [`LabelLayout::write`], but the label must also cover none of `points`.
    pub fn write_clear_of(
        &mut self,
        points: &[Pos2],
        text: &str,
        font: Font,
        anchors: impl IntoIterator<Item = (Pos2, Align2)>,
    ) -> Option<Rect> {
        let galley = if font.bold {
            let id = FontId::new(font.size, theme::bold());
            self.painter.layout_no_wrap(text.to_owned(), id, font.color)
        } else {
            self.painter.layout_job(formula(text, font.size, font.color))
        };
        for (at, align) in anchors {
            let rect = align.anchor_size(at, galley.size());
            // Without a gap, two adjacent numbers would look like one.
            let room = rect.expand2(Vec2::new(3.0, 0.0));
            let free = self.taken.iter().all(|taken| !taken.intersects(room));
            let clear = !points.iter().any(|point| rect.contains(*point));
            if free && clear && self.within.contains_rect(rect) {
                let text = HaloText::new(rect.min, galley, font.color, self.halo);
                self.painter.add(text.into_shape());
                self.taken.push(rect);
                return Some(rect);
            }
        }
        None
    }
}

/// Returns positions to try for a label around a point: first in the direction `toward`, then in other
/// directions, at the distance `reach`; then the same farther away.
pub fn around(at: Pos2, toward: Vec2, reach: f32) -> impl Iterator<Item = (Pos2, Align2)> {
    let first = if toward == Vec2::ZERO { 0.0 } else { toward.angle() };
    let turns = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];
    [1.0, 2.2].into_iter().flat_map(move |ring| {
        turns.into_iter().map(move |turn: f32| {
            let away = Vec2::angled(first + turn * std::f32::consts::FRAC_PI_4);
            (at + ring * reach * away, Align2([side(away.x), side(away.y)]))
        })
    })
}

/// Returns, for one axis, which side of a label faces its point. `away` is the coordinate of the unit
/// vector from the point to the label.
fn side(away: f32) -> egui::Align {
    if away > 0.38 {
        egui::Align::Min
    } else if away < -0.38 {
        egui::Align::Max
    } else {
        egui::Align::Center
    }
}

/// Text with a halo around its letters, which keeps it legible over any background.
///
/// egui has no such shape, so it is composed in a [`Shape::Vec`]: eight copies of the text around its
/// position, in the halo's colour, and then the text itself. Figures [convert](HaloText::from_shape) it
/// back to a single text.
pub struct HaloText {
    /// The text.
    pub text: TextShape,
    /// The colour of the halo.
    pub halo: Color32,
}

impl HaloText {
    /// Width of the halo, in points.
    pub const REACH: f32 = 1.3;

    /// Creates text whose upper left corner is at `at`.
    pub fn new(at: Pos2, galley: Arc<Galley>, color: Color32, halo: Color32) -> HaloText {
        HaloText { text: TextShape::new(at, galley, color), halo }
    }

    /// Returns the shape that egui paints.
    pub fn into_shape(self) -> Shape {
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

    /// Inverts [`HaloText::into_shape`]; returns `None` for any other shape.
    #[cfg(feature = "vector")]
    pub fn from_shape(shape: &Shape) -> Option<HaloText> {
        let Shape::Vec(shapes) = shape else { return None };
        let [Shape::Text(copy), .., Shape::Text(text)] = shapes.as_slice() else { return None };
        let halo = copy.override_text_color?;
        Arc::ptr_eq(&copy.galley, &text.galley).then(|| HaloText { text: text.clone(), halo })
    }
}

/// Writes a label of a picture whose upper left corner is at `origin`. `per_point` is the number of screen
/// pixels per point.
pub fn write_label(painter: &Painter, origin: Pos2, per_point: f32, label: &Label) {
    let center = origin + vec2(label.position[0], label.position[1]) / per_point;
    let family = if label.bold { theme::bold() } else { FontFamily::Proportional };
    let font = FontId::new(label.size, family);
    let galley = painter.layout_no_wrap(label.text.clone(), font, label.color);
    let min = center - 0.5 * galley.size();
    painter.add(HaloText::new(min, galley, label.color, label.halo).into_shape());
}
