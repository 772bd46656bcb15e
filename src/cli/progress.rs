//! How far long work is, for those who watch.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar or spinner on standard error, which appears only where that is a terminal and the work
/// takes longer than [`PATIENCE`].
pub(super) struct Progress {
    bar: ProgressBar,
    /// Shows the bar when it is time, until the other end of the channel goes away.
    clock: Option<(Sender<()>, JoinHandle<()>)>,
}

/// How long nobody needs to be told that something is going on.
const PATIENCE: Duration = Duration::from_secs(1);

/// How often the bar shows that something is going on.
const TICK: Duration = Duration::from_millis(100);

impl Progress {
    /// Of a number of rows.
    pub(super) fn of_rows(rows: u32) -> Progress {
        let bar = ProgressBar::with_draw_target(Some(rows.into()), ProgressDrawTarget::hidden());
        set_style(&bar, "{wide_bar} row {pos} of {len}, {eta} left");
        Progress::shown_later(bar)
    }

    /// Of so many frames of an animation.
    pub(super) fn of_frames(frames: u32) -> Progress {
        let bar = ProgressBar::with_draw_target(Some(frames.into()), ProgressDrawTarget::hidden());
        set_style(&bar, "{wide_bar} frame {pos} of {len}, {eta} left");
        Progress::shown_later(bar)
    }

    /// Of measuring so many parts.
    pub(super) fn of_parts(parts: usize) -> Progress {
        let target = ProgressDrawTarget::hidden();
        let bar = ProgressBar::with_draw_target(Some(parts as u64), target);
        set_style(&bar, "{wide_bar} measured {percent} %, {eta} left");
        Progress::shown_later(bar)
    }

    /// Of work that does not tell how far it is.
    pub(super) fn of(work: &'static str) -> Progress {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let progress = Progress::shown_later(bar);
        progress.go_on(work);
        progress
    }

    /// Goes on with work that does not tell how far it is.
    pub(super) fn go_on(&self, work: &'static str) {
        set_style(&self.bar, "{spinner} {msg}, {elapsed}");
        self.bar.set_message(work);
    }

    /// More rows are done.
    pub(super) fn add(&self, rows: usize) {
        self.bar.inc(rows as u64);
    }

    /// So many parts are done in all.
    pub(super) fn reach(&self, parts: usize) {
        self.bar.set_position(parts as u64);
    }

    /// The work may be silent for long, so another thread looks at the clock.
    fn shown_later(bar: ProgressBar) -> Progress {
        if !io::stderr().is_terminal() {
            return Progress { bar, clock: None };
        }
        let (end, ended) = mpsc::channel::<()>();
        let shown = bar.clone();
        let clock = thread::spawn(move || {
            if ended.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(TICK);
            }
        });
        Progress { bar, clock: Some((end, clock)) }
    }
}

fn set_style(bar: &ProgressBar, template: &str) {
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((end, clock)) = self.clock.take() {
            drop(end);
            // A clock that has failed has shown nothing, which is all that is wanted here.
            let _ = clock.join();
        }
        self.bar.finish_and_clear();
    }
}
