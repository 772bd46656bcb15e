//! Headless drawing: draws with egui into a picture, without a window.

use egui::epaint::{ClippedPrimitive, ClippedShape};
use egui::{Color32, LayerId, RawInput, Rect, Vec2, ViewportId};

use super::painter::Painter;
use crate::view::typesetting::fonts;

/// Draws with egui's painter over pixels; text has the same fonts and glyphs as in the window.
///
/// Positions are in points from the top left corner; `pixels_per_point` pixels make up one point.
/// `pixels` are rows of length `size[0]` from the top.
///
/// ```
/// use egui::{Align2, Color32, FontId, pos2};
/// let size = [80, 20];
/// let mut pixels = vec![Color32::BLACK; size[0] * size[1]];
/// pinhole::view::headless::draw_text(&mut pixels, size, 1.0, |painter| {
///     let font = FontId::proportional(14.0);
///     painter.text(pos2(2.0, 2.0), Align2::LEFT_TOP, "θ = 45°", font, Color32::WHITE);
/// });
/// assert!(pixels.contains(&Color32::WHITE));
/// ```
pub fn draw_text(
    pixels: &mut [Color32],
    size: [usize; 2],
    pixels_per_point: f32,
    draw: impl FnOnce(&egui::Painter),
) {
    let mut draw = Some(draw);
    draw_ui(pixels, size, pixels_per_point, |ui| {
        // A pass may run twice; what the first one drew is then dropped. Nothing here requests a
        // second pass.
        if let Some(draw) = draw.take() {
            draw(&egui::Painter::new(ui.clone(), LayerId::background(), ui.max_rect()));
        }
    });
}

/// Draws one pass of a user interface over pixels.
pub fn draw_ui(
    pixels: &mut [Color32],
    size: [usize; 2],
    pixels_per_point: f32,
    ui: impl FnMut(&mut egui::Ui),
) {
    let ctx = egui::Context::default();
    fonts::install(&ctx);
    UiPass::draw(&ctx, size, pixels_per_point, ui).paint(pixels, size);
}

/// One pass of a user interface: the shapes it drew, and the data to paint them into pixels.
#[derive(Debug)]
pub struct UiPass {
    shapes: Vec<ClippedShape>,
    primitives: Vec<ClippedPrimitive>,
    painter: Painter,
    pixels_per_point: f32,
}

impl UiPass {
    /// Runs the first pass of a context, on a screen of `size` pixels with `pixels_per_point`
    /// pixels per point. Later passes would lack the glyphs that the first one uploads.
    pub fn draw(
        ctx: &egui::Context,
        size: [usize; 2],
        pixels_per_point: f32,
        ui: impl FnMut(&mut egui::Ui),
    ) -> UiPass {
        let output = ctx.run_ui(input(size, pixels_per_point), ui);
        let (mut delta, pixels_per_point) = (output.textures_delta, output.pixels_per_point);
        let primitives = ctx.tessellate(output.shapes.clone(), pixels_per_point);
        let mut painter = Painter::new();
        painter.set_textures(&mut delta);
        delta.clear();
        UiPass { shapes: output.shapes, primitives, painter, pixels_per_point }
    }

    /// Dots to a point.
    pub fn pixels_per_point(&self) -> f32 {
        self.pixels_per_point
    }

    /// Returns the drawn shapes, in points.
    pub fn shapes(&self) -> &[ClippedShape] {
        &self.shapes
    }

    /// Draws it over pixels.
    pub fn paint(&self, pixels: &mut [Color32], size: [usize; 2]) {
        self.painter.paint(pixels, size, self.pixels_per_point, &self.primitives);
    }
}

/// Returns input without events for a screen of `size` pixels.
fn input(size: [usize; 2], pixels_per_point: f32) -> RawInput {
    let points = Vec2::new(size[0] as f32, size[1] as f32) / pixels_per_point;
    let mut input = RawInput {
        screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, points)),
        ..RawInput::default()
    };
    if let Some(viewport) = input.viewports.get_mut(&ViewportId::ROOT) {
        viewport.native_pixels_per_point = Some(pixels_per_point);
    }
    input
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn shapes_are_in_points() {
        let size = [8, 4];
        let mut pixels = vec![Color32::BLACK; 32];
        draw_text(&mut pixels, size, 2.0, |painter| {
            let rect = Rect::from_min_max(pos2(1.0, 0.0), pos2(2.0, 1.0));
            painter.rect_filled(rect, 0.0, Color32::RED);
        });
        for (index, &pixel) in pixels.iter().enumerate() {
            let inside = (2..4).contains(&(index % 8)) && index / 8 < 2;
            let expected = if inside { Color32::RED } else { Color32::BLACK };
            assert_eq!(pixel, expected, "at {}, {}", index % 8, index / 8);
        }
    }
}
