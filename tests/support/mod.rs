//! What several tests of the program need.

pub(crate) mod naive;
pub(crate) mod whole_window;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use egui::epaint::textures::TexturesDelta;
use egui::{Color32, Vec2};
use egui_kittest::{HarnessBuilder, SnapshotOptions, TestRenderer};
use image::RgbaImage;
use pinhole_figure::painter::SoftwarePainter;

/// Draws egui_kittest's pictures with the program's own painter: no driver, no display, and the
/// same bytes on every machine.
#[derive(Default)]
pub(crate) struct PainterRenderer {
    painter: SoftwarePainter,
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

/// An animation as it is shown.
pub(crate) struct Gif {
    pub(crate) frames: Vec<Vec<[u8; 3]>>,
    /// How long each frame is shown, in hundredths of a second.
    pub(crate) delays: Vec<u16>,
    pub(crate) repeats: gif::Repeat,
}

impl Gif {
    pub(crate) fn read(path: &Path) -> Gif {
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(BufReader::new(File::open(path).unwrap())).unwrap();
        let size = [decoder.width(), decoder.height()].map(usize::from);
        let mut screen = vec![[0; 3]; size[0] * size[1]];
        let (mut frames, mut delays) = (Vec::new(), Vec::new());
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            for (shown, pixel) in screen.iter_mut().zip(frame.buffer.chunks_exact(4)) {
                if pixel[3] == 255 {
                    *shown = [pixel[0], pixel[1], pixel[2]];
                }
            }
            frames.push(screen.clone());
            delays.push(frame.delay);
        }
        Gif { frames, delays, repeats: decoder.repeat() }
    }

    /// Mean difference of two frames' channels.
    pub(crate) fn difference(a: &[[u8; 3]], b: &[[u8; 3]]) -> f64 {
        assert_eq!(a.len(), b.len());
        let channels = a.as_flattened().iter().zip(b.as_flattened());
        let sum: u64 = channels.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        sum as f64 / (3 * a.len()) as f64
    }
}
