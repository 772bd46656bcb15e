//! From egui to a window: with the graphics driver, or with our own painter where there is none.
//!
//! [`run`] opens the window and shows a [`Program`] in it. What draws it:
//!
//! - a graphics adapter, by way of wgpu, where there is one made of hardware;
//! - else [`painter`], on the CPU: with no adapter at all, with one that fails to start, and with
//!   one that is itself software, because the drivers made for that take many times as long for
//!   the same picture.
//!
//! Both are driven by the same event loop (`window.rs`, `open.rs`), so everything else about the
//! window is the same. `gpu.rs` is the only file that knows wgpu.

mod cpu;
mod display;
pub mod fonts;
#[cfg(feature = "wgpu")]
mod gpu;
pub mod headless;
pub(crate) mod look;
pub(crate) mod motion;
mod open;
pub mod painter;
mod start;
mod window;

use std::fmt;
use std::time::Duration;

/// What the window shows.
pub trait Program {
    /// Shows the program for one frame and takes its input.
    ///
    /// To keep the window open when the user closes it (`ui.input(|i|
    /// i.viewport().close_requested())`), send `ViewportCommand::CancelClose` in the same frame;
    /// `ViewportCommand::Close` closes it later.
    fn ui(&mut self, ui: &mut egui::Ui);

    /// Whether what textures take is to be told apart from what drawing takes.
    fn wants_upload_time(&self) -> bool {
        false
    }

    /// Called after a frame has been handed to the display.
    fn presented(&mut self, _times: &FrameTimes) {}

    /// Called once, when the window is about to go away: the last chance to save.
    fn on_exit(&mut self);
}

/// What draws the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Renderer {
    /// A graphics adapter, through wgpu.
    Wgpu,
    /// Our own painter.
    Cpu,
}

impl fmt::Display for Renderer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wgpu => "wgpu",
            Self::Cpu => "cpu",
        })
    }
}

/// What draws the window, in the words of whoever wrote its driver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RendererInfo {
    /// Which one.
    pub renderer: Renderer,
    /// The adapter and its driver, or why the CPU draws.
    pub detail: String,
}

impl fmt::Display for RendererInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.renderer, self.detail)
    }
}

/// How long one frame took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameTimes {
    /// From the first input event that the frame answers until it was handed to the display; none
    /// for a frame without input, such as one of an animation.
    pub since_input: Option<Duration>,
    /// From the start of [`Program::ui`] until the frame was handed to the display.
    pub frame: Duration,
    /// Of this, [`Program::ui`] with what egui does around it.
    pub ui: Duration,
    /// Of this, taking over new pictures and glyphs; counted as `paint` unless
    /// [asked for](Program::wants_upload_time).
    pub upload: Duration,
    /// Of this, tessellating and drawing; for wgpu, giving the orders to draw.
    pub paint: Duration,
    /// Of this, waiting until the display takes another frame.
    pub wait: Duration,
}

/// The window as it is opened. Lengths are in points of the system, without egui's zoom.
#[derive(Clone, Debug, Default)]
pub struct WindowOptions {
    /// Text in the title bar.
    pub title: String,
    /// The name that the desktop knows the program by.
    pub app_id: String,
    /// Place and size.
    pub geometry: WindowGeometry,
    /// The picture in the title bar and the list of windows.
    pub icon: Option<egui::IconData>,
}

/// Place and size of the window.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct WindowGeometry {
    /// Size of its content.
    pub inner_size: [f32; 2],
    /// Left top corner of its frame; `None` lets the desktop choose.
    pub position: Option<[f32; 2]>,
    /// Whether it fills the screen.
    pub maximized: bool,
}

impl Default for WindowGeometry {
    fn default() -> Self {
        Self { inner_size: [1280.0, 800.0], position: None, maximized: false }
    }
}

impl WindowGeometry {
    /// Takes over where the window is now. Called each frame, it has the geometry to save on exit:
    /// size and place of a maximised, minimised or full-screen window are not taken over, so that
    /// the ones to go back to are kept.
    pub fn update(&mut self, ctx: &egui::Context) {
        let zoom = ctx.zoom_factor();
        ctx.input(|input| {
            let viewport = input.viewport();
            if viewport.minimized == Some(true) || viewport.fullscreen == Some(true) {
                return;
            }
            self.maximized = viewport.maximized == Some(true);
            if self.maximized {
                return;
            }
            // Wayland tells no position, and then neither rectangle.
            let size = viewport.inner_rect.map_or(input.viewport_rect().size(), |r| r.size());
            if size.x >= 1.0 && size.y >= 1.0 {
                self.inner_size = [size.x * zoom, size.y * zoom];
            }
            self.position = viewport.outer_rect.map(|r| [r.min.x * zoom, r.min.y * zoom]);
        });
    }
}

/// Why there is no window, or no longer one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PresentError {
    /// No display to open a window on.
    NoDisplay(String),
    /// The display refused the window.
    NoWindow(String),
    /// `--renderer wgpu` was asked for and no adapter works.
    NoAdapter(String),
    /// Drawing began to fail while the window was open.
    Lost(String),
}

impl fmt::Display for PresentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDisplay(cause) => write!(
                f,
                "there is no display to open a window on: {cause}\n\
                 These commands need none: pinhole render, pinhole inspect, pinhole trace, \
                 pinhole scenes"
            ),
            Self::NoWindow(cause) => write!(f, "the display refused to open a window: {cause}"),
            Self::NoAdapter(cause) => {
                write!(f, "no graphics adapter works: {cause}\nWithout one: pinhole --renderer cpu")
            }
            Self::Lost(cause) => write!(
                f,
                "the window can no longer be drawn: {cause}\nIf this comes again: pinhole \
                 --renderer cpu"
            ),
        }
    }
}

impl std::error::Error for PresentError {}

/// Opens the window and returns when it is closed.
///
/// `choice` is the renderer asked for by hand; without, the best that works is taken.
/// `make_program` is called when the window exists and its scale is known, before the first frame.
pub fn run(
    choice: Option<Renderer>,
    options: WindowOptions,
    make_program: impl FnOnce(&egui::Context, &RendererInfo) -> Box<dyn Program>,
) -> Result<(), PresentError> {
    let event_loop = display::event_loop()?;
    window::run(event_loop, choice, options, make_program)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_what_to_do_instead() {
        let message = PresentError::NoDisplay("none is set".into()).to_string();
        for command in ["render", "inspect", "trace", "scenes"] {
            assert!(message.contains(&format!("pinhole {command}")), "{message}");
        }
        for error in [PresentError::NoAdapter(String::new()), PresentError::Lost(String::new())] {
            assert!(error.to_string().contains("--renderer cpu"), "{error}");
        }
    }
}
