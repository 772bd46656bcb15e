//! What the platform shows in its window, and tells of each frame.

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
