//! Draws a user interface made with egui into a picture, without a window.

use egui::epaint::{ClippedPrimitive, ClippedShape};
use egui::{Color32, RawInput, Rect, Vec2, ViewportId};

use super::painter::SoftwarePainter;

/// One pass of a user interface: the drawn shapes, and the data needed to rasterize them.
#[derive(Debug)]
pub struct UiPass {
    /// The drawn shapes, in points.
    pub shapes: Vec<ClippedShape>,
    /// The number of pixels per point.
    pub pixels_per_point: f32,
    primitives: Vec<ClippedPrimitive>,
    painter: SoftwarePainter,
}

impl UiPass {
    /// Runs the first pass of `ctx` on a screen of `size` pixels, with `pixels_per_point` pixels per point.
    /// `ctx` must be new, because only its first pass uploads all the glyphs.
    pub fn draw(
        ctx: &egui::Context,
        size: [usize; 2],
        pixels_per_point: f32,
        ui: impl FnMut(&mut egui::Ui),
    ) -> UiPass {
        let output = ctx.run_ui(input(size, pixels_per_point), ui);
        let (mut delta, pixels_per_point) = (output.textures_delta, output.pixels_per_point);
        let primitives = ctx.tessellate(output.shapes.clone(), pixels_per_point);
        let mut painter = SoftwarePainter::default();
        painter.set_textures(&mut delta);
        delta.clear();
        UiPass { shapes: output.shapes, primitives, painter, pixels_per_point }
    }

    /// Paints the user interface over the existing pixels.
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
