//! The log of the window's frame times, written to a file for measurements.
//!
//! `PINHOLE_FRAME_TIMES=times.csv pinhole` writes, when the window is closed, the time of each frame,
//! input to presented, in milliseconds. `tests/drag-latency.sh` takes the medians of it.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use crate::ui::frame_times::WorkTimes;
use crate::ui::program::FrameTimes;

/// The environment variable that names the file: a CSV with one row per frame, in milliseconds.
pub(crate) const FRAME_TIMES: &str = "PINHOLE_FRAME_TIMES";

/// The frames presented so far.
pub(crate) struct FrameLog {
    pub(crate) path: PathBuf,
    frames: Vec<(FrameTimes, Option<WorkTimes>)>,
}

impl FrameLog {
    pub(crate) fn to(path: OsString) -> FrameLog {
        FrameLog { path: path.into(), frames: Vec::new() }
    }

    /// Records a presented frame, with the work for it if it showed a new picture.
    pub(crate) fn push(&mut self, times: FrameTimes, work: Option<WorkTimes>) {
        self.frames.push((times, work));
    }

    /// Writes the file. `since_input` is empty for a frame that answers no input. The columns of
    /// the work, of which `own` is the sum, are part of `ui` and empty for a frame without a new
    /// picture.
    pub(crate) fn save(&self) -> std::io::Result<()> {
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
