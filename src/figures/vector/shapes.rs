//! Shapes that egui was told to draw, as parts of a figure.

use std::borrow::Cow;

use egui::epaint::{CircleShape, ClippedShape, ColorMode, PathShape, RectShape, TextShape};
use egui::{Color32, Pos2, Rect, Shape, Stroke, StrokeKind};

use super::primitive::{Primitive, Text};
use super::text;
use crate::view::overlay::{Ink, Outline, Path};
use crate::view::typesetting::label_text::HaloText;

/// Shapes in points as parts in dots, `scale` to a point.
pub(in crate::figures) fn primitives(shapes: &[ClippedShape], scale: f32) -> Vec<Primitive> {
    let mut maker = Maker { scale, primitives: Vec::new() };
    for clipped in shapes {
        maker.shape(&clipped.shape);
    }
    maker.primitives
}

struct Maker {
    scale: f32,
    primitives: Vec<Primitive>,
}

impl Maker {
    fn shape(&mut self, shape: &Shape) {
        if let Some(HaloText { text, halo }) = HaloText::from_shape(shape) {
            return self.text(&text, Some(halo));
        }
        match shape {
            Shape::Noop => {}
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| self.shape(shape)),
            Shape::Text(text) => self.text(text, None),
            Shape::LineSegment { points, stroke } => {
                let outline = self.chain(points, false);
                self.stroke(outline, *stroke);
            }
            Shape::Path(path) => self.path(path),
            Shape::Circle(CircleShape { center, radius, fill, stroke }) => {
                let (center, radius) = (self.to_page(*center), radius * self.scale);
                self.fill(Outline::Circle { center, radius }, *fill);
                // egui draws a circle's stroke around it.
                let radius = radius + 0.5 * stroke.width * self.scale;
                self.stroke(Outline::Circle { center, radius }, *stroke);
            }
            Shape::Rect(rect) => self.rectangle(rect),
            other => debug_assert!(false, "figures have no {other:?}"),
        }
    }

    fn text(&mut self, shape: &TextShape, halo: Option<Color32>) {
        let runs = text::runs(shape, self.scale);
        if !runs.is_empty() {
            let halo = halo.map(|halo| (halo, HaloText::REACH * self.scale));
            self.primitives.push(Primitive::Text(Text { runs, halo }));
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
            self.primitives.push(Primitive::Path(Path { outline, color, ink: Ink::Fill }));
        }
    }

    fn stroke(&mut self, outline: Outline<'static>, Stroke { width, color }: Stroke) {
        if width > 0.0 && color.a() > 0 {
            let ink = Ink::Stroke { width: width * self.scale, round: false, dash: None };
            self.primitives.push(Primitive::Path(Path { outline, color, ink }));
        }
    }

    fn to_page(&self, at: Pos2) -> [f32; 2] {
        [at.x * self.scale, at.y * self.scale]
    }

    fn chain(&self, points: &[Pos2], closed: bool) -> Outline<'static> {
        let points = points.iter().map(|point| self.to_page(*point)).collect();
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

#[cfg(test)]
mod tests {
    use egui::{Align2, Context, FontFamily, FontId, Painter, Vec2, pos2};

    use super::super::primitive::Primitive;
    use super::*;
    use crate::view::headless::UiPass;
    use crate::view::typesetting::{fonts, theme};

    fn drawn(scale: f32, draw: impl Fn(&Painter)) -> Vec<Primitive> {
        let ctx = Context::default();
        theme::install_base(&ctx);
        let drawn = UiPass::draw(&ctx, [400, 300], scale, |ui| draw(ui.painter()));
        primitives(drawn.shapes(), scale)
    }

    fn text(primitive: &Primitive) -> Option<(String, Option<(Color32, f32)>)> {
        let Primitive::Text(text) = primitive else { return None };
        Some((text.runs.iter().map(|run| run.text.as_str()).collect(), text.halo))
    }

    #[test]
    fn letters_are_where_egui_put_them() {
        let font = FontId::proportional(20.0);
        // With a kerned pair, two fonts, and what some fonts have ligatures for.
        let written = "AV floor 𝑡 = ffi";
        let primitives = drawn(2.0, |painter| {
            painter.text(pos2(10.0, 5.0), Align2::LEFT_TOP, written, font.clone(), Color32::RED);
        });
        let [Primitive::Text(text)] = primitives.as_slice() else { panic!("{primitives:?}") };
        assert_eq!(text.runs.iter().map(|run| run.text.as_str()).collect::<String>(), written);
        assert!(text.runs.len() > 1 && text.halo.is_none());
        assert_eq!(text.runs[0].at[0], 20.0);
        let ctx = Context::default();
        theme::install_base(&ctx);
        let mut width = 0.0;
        UiPass::draw(&ctx, [400, 300], 2.0, |ui| {
            let galley =
                ui.painter().layout_no_wrap(written.to_owned(), font.clone(), Color32::RED);
            width = 2.0 * galley.size().x;
        });
        let last = text.runs.last().expect("a run");
        assert!((last.at[0] + last.width() - 20.0 - width).abs() < 1.0, "{text:?} {width}");
        for run in &text.runs {
            assert_eq!((run.size, run.color), (40.0, Color32::RED));
            let own = run.text.chars().map(|c| run.size * run.face.advance(c));
            let near = |(laid, own): (&f32, f32)| (laid - own).abs() < 0.15 * own + 1.0;
            assert!(run.advances.iter().zip(own).all(near), "{run:?}");
        }
    }

    #[test]
    fn text_with_a_halo_is_one_text() {
        let primitives = drawn(1.5, |painter| {
            let font = FontId::new(14.0, fonts::bold());
            let galley = painter.layout_no_wrap("cased".to_owned(), font, Color32::BLACK);
            let text = HaloText::new(pos2(20.0, 20.0), galley, Color32::BLACK, Color32::WHITE);
            painter.add(text.into_shape());
            let font = FontId::new(14.0, FontFamily::Proportional);
            let galley =
                painter.layout_no_wrap("in another colour".to_owned(), font, Color32::BLACK);
            painter.galley_with_override_text_color(pos2(9.0, 9.0), galley, Color32::BLUE);
        });
        let texts: Vec<_> = primitives.iter().filter_map(text).collect();
        let [(cased, Some((color, reach))), (other, None)] = texts.as_slice() else {
            panic!("{texts:?}")
        };
        assert_eq!((cased.as_str(), *color), ("cased", Color32::WHITE));
        assert!((reach - 1.95).abs() < 0.01);
        assert_eq!(other, "in another colour");
        let Some(Primitive::Text(last)) = primitives.last() else { panic!("{primitives:?}") };
        assert_eq!(last.runs[0].color, Color32::BLUE);
    }

    #[test]
    fn shapes_are_fills_and_strokes_in_dots() {
        let stroke = Stroke::new(2.0, Color32::GREEN);
        let primitives = drawn(2.0, |painter| {
            painter.circle(pos2(10.0, 20.0), 5.0, Color32::RED, stroke);
            painter.line_segment([pos2(0.0, 0.0), pos2(3.0, 4.0)], stroke);
            let square = Rect::from_min_size(pos2(1.0, 1.0), Vec2::splat(4.0));
            painter.rect_filled(square, 0.0, Color32::BLUE);
        });
        let path = |outline, color, ink| Path { outline, color, ink };
        let circle = |radius| Outline::Circle { center: [20.0, 40.0], radius };
        let chain = |points: &[[f32; 2]], closed| Outline::Chain {
            points: Cow::Owned(points.to_vec()),
            closed,
        };
        let pen = Ink::Stroke { width: 4.0, round: false, dash: None };
        let corners = [[2.0, 2.0], [10.0, 2.0], [10.0, 10.0], [2.0, 10.0]];
        let paths: Vec<Path> = primitives
            .into_iter()
            .map(|primitive| match primitive {
                Primitive::Path(path) => path,
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(
            paths,
            [
                path(circle(10.0), Color32::RED, Ink::Fill),
                path(circle(12.0), Color32::GREEN, pen),
                path(chain(&[[0.0, 0.0], [6.0, 8.0]], false), Color32::GREEN, pen),
                path(chain(&corners, true), Color32::BLUE, Ink::Fill),
            ]
        );
    }
}
