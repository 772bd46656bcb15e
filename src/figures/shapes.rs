//! What egui was told to draw, as parts of a figure.

use std::borrow::Cow;
use std::sync::Arc;

use egui::epaint::{CircleShape, ClippedShape, ColorMode, PathShape, RectShape, TextShape};
use egui::{Color32, Galley, Pos2, Rect, Shape, Stroke, StrokeKind};

use super::part::{Part, Text};
use super::text;
use crate::overlay::{Ink, Outline, Path};

/// Shapes in points as parts in dots, `scale` to a point.
pub(super) fn parts(shapes: &[ClippedShape], scale: f32) -> Vec<Part<'static>> {
    let mut maker = Maker { scale, parts: Vec::new(), casing: None };
    for clipped in shapes {
        maker.shape(&clipped.shape);
    }
    maker.casing_alone();
    maker.parts
}

struct Maker {
    scale: f32,
    parts: Vec<Part<'static>>,
    /// A text in another colour than its own, which may be drawn all around itself as its casing.
    casing: Option<TextShape>,
}

impl Maker {
    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Noop => {}
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| self.shape(shape)),
            Shape::Text(text) => self.text(text),
            Shape::LineSegment { points, stroke } => {
                let outline = self.chain(points, false);
                self.stroke(outline, *stroke);
            }
            Shape::Path(path) => self.path(path),
            Shape::Circle(CircleShape { center, radius, fill, stroke }) => {
                let (center, radius) = (self.place(*center), radius * self.scale);
                self.fill(Outline::Circle { center, radius }, *fill);
                // egui draws a circle's stroke around it.
                let radius = radius + 0.5 * stroke.width * self.scale;
                self.stroke(Outline::Circle { center, radius }, *stroke);
            }
            Shape::Rect(rect) => self.rectangle(rect),
            other => debug_assert!(false, "figures have no {other:?}"),
        }
    }

    /// The window cases letters by drawing them eight times around their place; a figure strokes them.
    fn text(&mut self, shape: &TextShape) {
        let same = |other: &TextShape| Arc::<Galley>::ptr_eq(&other.galley, &shape.galley);
        let known = self.casing.as_ref().is_some_and(same);
        if shape.override_text_color.is_some() {
            if !known {
                self.casing_alone();
                self.casing = Some(shape.clone());
            }
            return;
        }
        if !known {
            self.casing_alone();
        }
        let halo = self.casing.take().and_then(|casing| {
            let reach = (casing.pos - shape.pos).length() * self.scale;
            Some((casing.override_text_color?, reach))
        });
        self.write(shape, halo);
    }

    fn write(&mut self, shape: &TextShape, halo: Option<(Color32, f32)>) {
        let runs = text::runs(shape, self.scale);
        if !runs.is_empty() {
            self.parts.push(Part::Text(Text { runs, halo }));
        }
    }

    /// It was no casing.
    fn casing_alone(&mut self) {
        if let Some(shape) = self.casing.take() {
            self.write(&shape, None);
        }
    }

    fn path(&mut self, path: &PathShape) {
        let outline = self.chain(&path.points, path.closed);
        self.fill(outline.clone(), path.fill);
        if let ColorMode::Solid(color) = path.stroke.color {
            self.stroke(outline, Stroke::new(path.stroke.width, color));
        }
    }

    fn rectangle(&mut self, shape: &RectShape) {
        let radius = f32::from(shape.corner_radius.nw);
        let outline = self.chain(&rounded(shape.rect, radius), true);
        self.fill(outline, shape.fill);
        let out = match shape.stroke_kind {
            StrokeKind::Inside => -0.5,
            StrokeKind::Middle => 0.0,
            StrokeKind::Outside => 0.5,
        } * shape.stroke.width;
        let edge = self.chain(&rounded(shape.rect.expand(out), (radius + out).max(0.0)), true);
        self.stroke(edge, shape.stroke);
    }

    fn fill(&mut self, outline: Outline<'static>, color: Color32) {
        if color.a() > 0 {
            self.parts.push(Part::Path(Path { outline, color, ink: Ink::Fill }));
        }
    }

    fn stroke(&mut self, outline: Outline<'static>, Stroke { width, color }: Stroke) {
        if width > 0.0 && color.a() > 0 {
            let ink = Ink::Stroke { width: width * self.scale, round: false, dash: None };
            self.parts.push(Part::Path(Path { outline, color, ink }));
        }
    }

    fn place(&self, at: Pos2) -> [f32; 2] {
        [at.x * self.scale, at.y * self.scale]
    }

    fn chain(&self, points: &[Pos2], closed: bool) -> Outline<'static> {
        let points = points.iter().map(|point| self.place(*point)).collect();
        Outline::Chain { points: Cow::Owned(points), closed }
    }
}

/// The corners of a rectangle, each a quarter of a circle in four steps if there is a radius.
fn rounded(rect: Rect, radius: f32) -> Vec<Pos2> {
    if radius == 0.0 {
        return [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()].into();
    }
    let inner = rect.shrink(radius);
    let corners = [inner.right_bottom(), inner.left_bottom(), inner.left_top(), inner.right_top()];
    let quarter = |(k, corner): (usize, Pos2)| {
        (0..=4).map(move |step| {
            let angle = (k as f32 + 0.25 * step as f32) * std::f32::consts::FRAC_PI_2;
            corner + radius * egui::Vec2::angled(angle)
        })
    };
    corners.into_iter().enumerate().flat_map(quarter).collect()
}
