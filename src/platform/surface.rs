//! A renderer of the window, and the frames that it draws.

use std::sync::Arc;
use std::time::{Duration, Instant};

use egui::ScreenshotCallback;
use egui::epaint::{ClippedPrimitive, textures::TexturesDelta};
use winit::window::Window;

/// Maximum side of egui's textures of glyphs and pictures, on the CPU and on an adapter. With another
/// one than in the first pass, the first frame would draw its glyphs again.
pub(super) const MAX_TEXTURE_SIDE: usize = 8192;

/// Number of consecutive frames that may fail to reach the display, after which the renderer has failed.
pub(super) const PATIENCE: u32 = 5;

/// A renderer of the window.
pub(super) trait Surface {
    /// Returns the maximum side of a texture.
    fn max_texture_side(&self) -> Option<usize>;

    /// Draws a frame and presents it.
    fn paint(&mut self, frame: Frame<'_>) -> Result<PaintTimes, String>;
}

/// A frame to draw.
pub(super) struct Frame<'a> {
    pub(super) window: &'a Arc<Window>,
    /// The window's size in pixels, not zero.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    /// The background colour.
    pub(super) ground: egui::Color32,
    pub(super) primitives: Vec<ClippedPrimitive>,
    /// Changes of textures; the renderer takes them out.
    pub(super) delta: &'a mut TexturesDelta,
    /// The requests for a copy of the picture.
    pub(super) screenshots: Vec<ScreenshotCallback>,
    /// True if the display may have lost its picture.
    pub(super) exposed: bool,
    /// True if the time of the upload is requested.
    pub(super) is_timed: bool,
}

/// The parts of the painting time that are not drawing.
pub(super) struct PaintTimes {
    /// Time for uploading textures; zero unless the frame is timed.
    pub(super) upload: Duration,
    /// Time for waiting for the display.
    pub(super) wait: Duration,
}

/// Runs a function and returns its duration, or zero if no time is requested.
pub(super) fn timed(is_asked: bool, run: impl FnOnce()) -> Duration {
    let start = is_asked.then(Instant::now);
    run();
    start.map_or(Duration::ZERO, |start| start.elapsed())
}
