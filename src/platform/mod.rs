//! The window on the screen, drawn by the graphics driver, or by our own painter if there is none.
//!
//! [`run`] opens the window and shows a [`Program`] in it. It is drawn by:
//!
//! - a graphics adapter, through wgpu, if there is one that is hardware;
//! - otherwise [`painter`](crate::view::painter), on the CPU: if there is no adapter, if the adapter fails to start, and
//!   if it is itself software, because software drivers take many times as long for the same
//!   picture.
//!
//! Both use the same event loop (`window.rs`, `open.rs`), so everything else about the window is
//! the same. Only `gpu.rs` uses wgpu.
//!
//! egui's own framework for windows cannot fall back to another renderer in the same process, so one
//! event loop of ours drives both.

mod cpu;
mod display;
pub mod frame_log;
#[cfg(feature = "wgpu")]
mod gpu;
mod open;
pub mod program;
mod start;
mod window;

use std::fmt;

use crate::cli::arguments::Renderer;
use crate::model::window_geometry::WindowGeometry;
use crate::ui::program::Program;

/// The renderer of the window, as its driver describes itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RendererInfo {
    /// The renderer.
    pub renderer: Renderer,
    /// The adapter and its driver, or the reason why the CPU draws.
    pub detail: String,
}

impl fmt::Display for RendererInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.renderer, self.detail)
    }
}

/// The options for opening the window. Lengths are in points of the system, without egui's zoom.
#[derive(Clone, Debug, Default)]
pub struct WindowOptions {
    /// The text in the title bar.
    pub title: String,
    /// The name by which the desktop knows the program.
    pub app_id: String,
    /// The window's place and size.
    pub geometry: WindowGeometry,
    /// The picture in the title bar and the list of windows.
    pub icon: Option<egui::IconData>,
}

/// A reason why there is no window, or no longer one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PresentError {
    /// There is no display to open a window on.
    NoDisplay(String),
    /// The display refused the window.
    NoWindow(String),
    /// `--renderer wgpu` was requested and no adapter works.
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
/// `choice` is the renderer that the user requested; `None` takes the best that works.
/// `make_program` is called once the window exists and its scale is known, before the first frame.
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
