//! Draws the window with our own painter, in an image in memory that is copied to the display.

use std::num::NonZeroU32;
use std::sync::Arc;
use std::time::Duration;

use egui::{Color32, ColorImage};
use pinhole_figure::painter::{Canvas, PixelRect, SoftwarePainter};
use rayon::prelude::*;
use winit::event_loop::{ActiveEventLoop, OwnedDisplayHandle};
use winit::raw_window_handle::{HasWindowHandle as _, RawWindowHandle};
use winit::window::Window;

use super::surface::{MAX_TEXTURE_SIDE, PATIENCE, WindowFrame, WindowSurface};

type Context = softbuffer::Context<OwnedDisplayHandle>;
type DisplayBuffers = softbuffer::Surface<OwnedDisplayHandle, Arc<Window>>;

/// A window's surface in memory.
pub(super) struct Cpu {
    context: Context,
    buffers: Option<DisplayBuffers>,
    /// Size of the buffers.
    size: [u32; 2],
    painter: SoftwarePainter,
    canvas: Canvas,
    /// True if the display's buffers may differ from the canvas, so that the next frame must be copied as a
    /// whole.
    stale: bool,
    keeps_picture: bool,
    failures: u32,
}

impl Cpu {
    /// Creates a surface for the window.
    pub(super) fn new(
        event_loop: &ActiveEventLoop,
        window: &Arc<Window>,
    ) -> Result<Self, softbuffer::SoftBufferError> {
        let context = Context::new(event_loop.owned_display_handle())?;
        let buffers = DisplayBuffers::new(&context, Arc::clone(window))?;
        Ok(Self {
            context,
            buffers: Some(buffers),
            size: [0, 0],
            painter: SoftwarePainter::default(),
            canvas: Canvas::default(),
            stale: true,
            keeps_picture: window
                .window_handle()
                .is_ok_and(|handle| matches!(handle.as_raw(), RawWindowHandle::Wayland(_))),
            failures: 0,
        })
    }

    /// Presents the canvas, of which only `rects` have changed since the last frame. If the window was
    /// `exposed`, the display needs the whole canvas.
    fn present(
        &mut self,
        window: &Arc<Window>,
        size: [u32; 2],
        rects: &[PixelRect],
        exposed: bool,
    ) -> Result<(), softbuffer::SoftBufferError> {
        let [Some(width), Some(height)] = size.map(NonZeroU32::new) else { return Ok(()) };
        let buffers = match &mut self.buffers {
            Some(buffers) => buffers,
            empty => empty.insert(DisplayBuffers::new(&self.context, Arc::clone(window))?),
        };
        if self.size != size {
            buffers.resize(width, height)?;
            self.size = size;
            self.stale = true;
        }
        let whole = [PixelRect::whole(self.canvas.size())];
        let shown = if self.stale || exposed { &whole } else { rects };
        if shown.is_empty() {
            return Ok(());
        }
        let mut buffer = buffers.buffer_mut()?;
        // If the display swaps two buffers, this buffer holds the frame before the last one.
        let copied = if buffer.age() == 1 && !self.stale { rects } else { &whole };
        for &rect in copied {
            copy(self.canvas.pixels(), self.canvas.size()[0], &mut buffer, rect);
        }
        let damage: Vec<_> = shown.iter().filter_map(|&rect| damage(rect)).collect();
        self.stale = true;
        window.pre_present_notify();
        buffer.present_with_damage(&damage)?;
        self.stale = false;
        Ok(())
    }
}

impl WindowSurface for Cpu {
    fn max_texture_side(&self) -> Option<usize> {
        Some(MAX_TEXTURE_SIDE)
    }

    fn keeps_picture(&self) -> bool {
        self.keeps_picture
    }

    fn paint(&mut self, frame: WindowFrame<'_>) -> Result<Duration, String> {
        let changed = self.painter.set_textures(frame.delta);
        let size = frame.size.map(|n| n as usize);
        let rects = self.canvas.show(
            &self.painter,
            &changed,
            size,
            frame.pixels_per_point,
            frame.ground,
            frame.primitives,
        );
        self.painter.free_textures(frame.delta);
        if !frame.screenshots.is_empty() {
            let image = Arc::new(ColorImage::new(size, self.canvas.pixels().to_vec()));
            for screenshot in frame.screenshots {
                screenshot.complete(Arc::clone(&image));
            }
        }
        match self.present(frame.window, frame.size, &rects, frame.exposed) {
            Ok(()) => self.failures = 0,
            Err(error) => {
                // New buffers are enough after a brief failure of the connection. A lost connection ends
                // the window.
                self.buffers = None;
                self.size = [0, 0];
                self.failures += 1;
                if self.failures >= PATIENCE {
                    return Err(error.to_string());
                }
                frame.window.request_redraw();
            }
        }
        Ok(Duration::ZERO)
    }
}

/// Copies a rectangle of the canvas into a buffer of the same size, and converts the pixels to the
/// display's format.
fn copy(pixels: &[Color32], width: usize, buffer: &mut [u32], rect: PixelRect) {
    // The sizes differ if the window was resized in the meantime. The next frame will fit.
    let rows = |height: usize| rect.top.min(height) * width..rect.bottom.min(height) * width;
    if width == 0 || rect.right > width || rect.left > rect.right {
        return;
    }
    let height = buffer.len().min(pixels.len()) / width;
    let (to, from) = (&mut buffer[rows(height)], &pixels[rows(height)]);
    let rows = to.par_chunks_exact_mut(width).zip(from.par_chunks_exact(width));
    rows.with_min_len(32).for_each(|(to, from)| {
        let run = rect.left..rect.right;
        let from: &[u32] = bytemuck::cast_slice(&from[run.clone()]);
        for (to, from) in to[run].iter_mut().zip(from) {
            // Converts red, green, blue in memory order to blue, green, red. Working on whole
            // integers lets the compiler convert several pixels at a time.
            let rgb = u32::from_le(*from);
            *to = (rgb & 0xff) << 16 | rgb & 0xff00 | rgb >> 16 & 0xff;
        }
    });
}

fn damage(rect: PixelRect) -> Option<softbuffer::Rect> {
    Some(softbuffer::Rect {
        x: rect.left as u32,
        y: rect.top as u32,
        width: NonZeroU32::new(rect.right.saturating_sub(rect.left) as u32)?,
        height: NonZeroU32::new(rect.bottom.saturating_sub(rect.top) as u32)?,
    })
}
