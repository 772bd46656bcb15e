//! How long the window's frames took, written to a file for those who measure.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use crate::present::FrameTimes;

/// The environment variable that names the file: a CSV with a row a frame, in milliseconds.
pub(crate) const FRAME_TIMES: &str = "PINHOLE_FRAME_TIMES";

/// The frames presented so far.
pub(crate) struct FrameLog {
    pub(crate) path: PathBuf,
    pub(crate) frames: Vec<FrameTimes>,
}

impl FrameLog {
    pub(crate) fn to(path: OsString) -> FrameLog {
        FrameLog { path: path.into(), frames: Vec::new() }
    }

    /// Writes the file. `since_input` is empty for a frame that answers no input.
    pub(crate) fn save(&self) -> std::io::Result<()> {
        let ms = |time: Duration| format!("{:.3}", 1e3 * time.as_secs_f64());
        let mut text = "since_input,frame,ui,upload,paint,wait\n".to_owned();
        for FrameTimes { since_input, frame, ui, upload, paint, wait } in &self.frames {
            let since = since_input.map(ms).unwrap_or_default();
            let times = [*frame, *ui, *upload, *paint, *wait].map(ms).join(",");
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{since},{times}");
        }
        std::fs::write(&self.path, text)
    }
}
