//! The interface of the window's renderers, the frames that they draw, and a record of what the graphics
//! adapter's textures contain. With this record, the CPU's renderer can take over if the adapter fails.

use std::collections::HashMap;
use std::sync::Arc;
use std::time::Duration;

use egui::epaint::textures::TexturesDelta;
use egui::epaint::{ClippedPrimitive, ImageDelta, TextureAtlas};
use egui::{ScreenshotCallback, TextureId};
use winit::window::Window;

/// Maximum side of egui's textures of glyphs and pictures, on the CPU and on an adapter. The app's first
/// pass must use the same value; otherwise the first frame would draw the glyphs again.
pub(super) const MAX_TEXTURE_SIDE: usize = 8192;

/// Number of consecutive frames that may fail to reach the display before the renderer counts as
/// failed.
pub(super) const PATIENCE: u32 = 5;

/// A renderer of the window.
pub(super) trait WindowSurface {
    /// Returns the maximum side of a texture, if it is known.
    fn max_texture_side(&self) -> Option<usize>;

    /// Returns true if the display keeps the presented picture, or reports its loss with certainty. If not,
    /// the window must present the whole picture again from time to time.
    fn keeps_picture(&self) -> bool {
        true
    }

    /// Draws a frame and presents it. Returns the time that it waited for the display.
    ///
    /// # Errors
    /// Returns the reason as a sentence if the renderer has failed.
    fn paint(&mut self, frame: WindowFrame<'_>) -> Result<Duration, String>;
}

/// A frame to draw.
pub(super) struct WindowFrame<'a> {
    pub(super) window: &'a Arc<Window>,
    /// The window's size in pixels, not zero.
    pub(super) size: [u32; 2],
    pub(super) pixels_per_point: f32,
    /// The background colour.
    pub(super) ground: egui::Color32,
    pub(super) primitives: Vec<ClippedPrimitive>,
    /// Changes of textures, which the renderer consumes.
    pub(super) delta: &'a mut TexturesDelta,
    /// The requests for a copy of the drawn picture.
    pub(super) screenshots: Vec<ScreenshotCallback>,
    /// True if the display may have lost its picture.
    pub(super) exposed: bool,
}

/// A record of the contents of egui's textures, except for the glyph texture. It is needed because egui sends
/// each change only once.
///
/// The images are shared with the app, not copied.
#[derive(Default)]
pub(super) struct Textures(HashMap<TextureId, Vec<ImageDelta>>);

/// The texture of the glyphs, which egui keeps itself.
const GLYPHS: TextureId = TextureId::Managed(0);

impl Textures {
    /// Records changes of textures before the surface consumes them.
    pub(super) fn note(&mut self, delta: &TexturesDelta) {
        let others = delta.set.iter().filter(|(id, _)| **id != GLYPHS);
        for (id, changes) in others {
            let sent = self.0.entry(*id).or_default();
            for change in changes {
                let size = sent.first().map(|first| first.image.size());
                let mut change = change.clone();
                if change.pos == Some([0, 0]) && size == Some(change.image.size()) {
                    change.pos = None;
                }
                if change.is_whole() {
                    sent.clear();
                }
                sent.push(change);
            }
        }
        for id in &delta.free {
            self.0.remove(id);
        }
    }

    /// Returns the contents of all textures, for a new renderer.
    pub(super) fn all(&self, ctx: &egui::Context) -> TexturesDelta {
        let mut all = TexturesDelta::default();
        let glyphs = ctx.fonts(|fonts| fonts.image());
        all.push(GLYPHS, ImageDelta::full(glyphs, TextureAtlas::texture_options()));
        for (id, sent) in &self.0 {
            for change in sent {
                all.push(*id, change.clone());
            }
        }
        all
    }
}
