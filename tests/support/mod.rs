//! What several tests of the program need.

pub(crate) mod naive;
pub(crate) mod whole_window;

use egui::epaint::textures::TexturesDelta;
use egui::{Color32, Vec2};
use egui_kittest::{HarnessBuilder, SnapshotOptions, TestRenderer};
use image::RgbaImage;
use pinhole::view::painter::Painter;

/// Draws egui_kittest's pictures with the program's own painter: no driver, no display, and the
/// same bytes on every machine.
#[derive(Default)]
pub(crate) struct PainterRenderer {
    painter: Painter,
}

impl TestRenderer for PainterRenderer {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        self.painter.set_textures(delta);
        self.painter.free_textures(delta);
    }

    fn render(
        &mut self,
        ctx: &egui::Context,
        output: &egui::FullOutput,
    ) -> Result<RgbaImage, String> {
        let pixels_per_point = ctx.pixels_per_point();
        let points: Vec2 = ctx.content_rect().size() * pixels_per_point;
        let size = [points.x.round() as usize, points.y.round() as usize];
        let ground = ctx.global_style().visuals.panel_fill.to_opaque();
        let mut pixels = vec![ground; size[0] * size[1]];
        let primitives = ctx.tessellate(output.shapes.clone(), pixels_per_point);
        self.painter.paint(&mut pixels, size, pixels_per_point, &primitives);
        image(&pixels, size).ok_or_else(|| "the picture has another size than said".to_owned())
    }
}

/// A harness whose pictures come from the program's painter.
///
/// A picture that differs in one pixel fails (per pixel 0.6 of dify's scale is let pass, which
/// is less than anyone can see).
pub(crate) fn harness<State>() -> HarnessBuilder<State> {
    HarnessBuilder::default()
        .renderer(PainterRenderer::default())
        .with_options(SnapshotOptions::new().threshold(0.6).max_failed_pixels(0))
}

/// Pixels as a picture of the `image` crate.
pub(crate) fn image(pixels: &[Color32], size: [usize; 2]) -> Option<RgbaImage> {
    let bytes = pixels.iter().flat_map(|pixel| pixel.to_array()).collect();
    RgbaImage::from_raw(size[0] as u32, size[1] as u32, bytes)
}
