//! The interface between the platform's window and the program in it.

use std::time::Duration;

/// A program in a window.
pub trait Program {
    /// Shows the program for one frame and takes its input.
    ///
    /// A program that keeps the window open when the user closes it
    /// (`ui.input(|i| i.viewport().close_requested())`) sends `ViewportCommand::CancelClose` in the
    /// same frame; `ViewportCommand::Close` closes it later.
    fn ui(&mut self, ui: &mut egui::Ui);

    /// Returns true if the time of texture uploads should be measured apart from drawing.
    fn wants_upload_time(&self) -> bool {
        false
    }

    /// Called after a frame has been handed to the display.
    fn presented(&mut self, _times: &FrameTimes) {}

    /// Called once, when the window is about to go away: the last chance to save.
    fn on_exit(&mut self);
}

/// The times of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameTimes {
    /// Time from the first input event that the frame answers until it was presented; `None` for a
    /// frame without input, such as one of an animation.
    pub since_input: Option<Duration>,
    /// Time from the start of [`Program::ui`] until the frame was presented.
    pub frame: Duration,
    /// Part of `frame`: [`Program::ui`] with egui's work around it.
    pub ui: Duration,
    /// Part of `frame`: uploading new pictures and glyphs; included in `paint` unless
    /// [requested](Program::wants_upload_time).
    pub upload: Duration,
    /// Part of `frame`: tessellating and drawing; for wgpu, issuing the draw commands.
    pub paint: Duration,
    /// Part of `frame`: waiting until the display accepts another frame.
    pub wait: Duration,
}
