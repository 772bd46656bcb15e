//! How far a long render is, for those who watch.

use std::io::{self, IsTerminal};
use std::sync::Once;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar on standard error, which appears only where that is a terminal and the work takes longer
/// than [`PATIENCE`].
pub(super) struct Progress {
    bar: ProgressBar,
    start: Instant,
    shown: Once,
}

/// How long nobody needs to be told that something is going on.
const PATIENCE: Duration = Duration::from_secs(1);

impl Progress {
    /// Of a number of rows.
    pub(super) fn of_rows(rows: u32) -> Progress {
        let bar = ProgressBar::with_draw_target(Some(rows.into()), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{wide_bar} row {pos} of {len}, {eta} left")
        {
            bar.set_style(style);
        }
        Progress { bar, start: Instant::now(), shown: Once::new() }
    }

    /// More rows are done.
    pub(super) fn add(&self, rows: usize) {
        self.bar.inc(rows as u64);
        if self.start.elapsed() > PATIENCE && io::stderr().is_terminal() {
            self.shown.call_once(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
