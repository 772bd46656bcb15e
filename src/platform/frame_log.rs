//! The log of the window's frame times, written to a file for measurements.
//!
//! `PINHOLE_FRAME_TIMES=times.csv pinhole` writes, when the window is closed, the time of each frame,
//! input to presented, in milliseconds. The first frame is without the pass that ran while the window
//! opened. `tests/drag-latency.sh` takes the medians of it.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use crate::ui::frame_times::WorkTimes;

/// The environment variable that names the file: a CSV with one row per frame, in milliseconds.
const FRAME_TIMES: &str = "PINHOLE_FRAME_TIMES";

/// The times of a frame.
pub(super) struct FrameTimes {
    /// Time from the first input event that the frame answers until it was presented; `None` for a
    /// frame without input, such as one of an animation.
    pub(super) since_input: Option<Duration>,
    /// Time from the start of the app's pass until the frame was presented. The others are parts of
    /// it.
    pub(super) frame: Duration,
    /// The app's pass with egui's work around it.
    pub(super) ui: Duration,
    /// Uploading new pictures and glyphs.
    pub(super) upload: Duration,
    /// Tessellating and drawing; for wgpu, issuing the draw commands.
    pub(super) paint: Duration,
    /// Waiting until the display accepts another frame.
    pub(super) wait: Duration,
}

/// The frames presented so far.
pub(super) struct FrameLog {
    pub(super) path: PathBuf,
    frames: Vec<(FrameTimes, Option<WorkTimes>)>,
}

impl FrameLog {
    /// Creates the log that the environment asks for, if it asks for one.
    pub(super) fn from_environment() -> Option<FrameLog> {
        let path = std::env::var_os(FRAME_TIMES)?.into();
        Some(FrameLog { path, frames: Vec::new() })
    }

    /// Records a presented frame, with the work for it if it showed a new picture.
    pub(super) fn push(&mut self, times: FrameTimes, work: Option<WorkTimes>) {
        self.frames.push((times, work));
    }

    /// Writes the file. `since_input` is empty for a frame that answers no input. The columns of
    /// the work, of which `own` is the sum, are part of `ui` and empty for a frame without a new
    /// picture.
    pub(super) fn save(&self) -> std::io::Result<()> {
        let ms = |time: Duration| format!("{:.3}", 1e3 * time.as_secs_f64());
        let mut text =
            "since_input,frame,ui,upload,paint,wait,trace,overlay,readouts,own\n".to_owned();
        for (FrameTimes { since_input, frame, ui, upload, paint, wait }, work) in &self.frames {
            let since = since_input.map(ms).unwrap_or_default();
            let times = [*frame, *ui, *upload, *paint, *wait].map(ms).join(",");
            let work = work.map_or(",,,".to_owned(), |work| {
                let own = work.trace + work.overlay + work.readouts;
                [work.trace, work.overlay, work.readouts, own].map(ms).join(",")
            });
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{since},{times},{work}");
        }
        std::fs::write(&self.path, text)
    }
}
