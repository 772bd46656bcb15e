//! Shows the progress of long work on a terminal.

use std::io::{self, IsTerminal, Write as _};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::model::recovery::in_words;

/// A progress line on standard error. The line appears if standard error is a terminal and the work
/// takes longer than [`PATIENCE`].
pub(super) struct Progress {
    work: Arc<ProgressState>,
    /// The thread that rewrites the line at intervals. It ends when the sender is dropped.
    clock: Option<(Sender<()>, JoinHandle<()>)>,
}

/// Time after which the progress line appears.
const PATIENCE: Duration = Duration::from_secs(1);

/// Time from one line to the next.
const TICK: Duration = Duration::from_millis(100);

struct ProgressState {
    since: Instant,
    done: AtomicUsize,
    /// The unit that is counted, such as `row`, with the total number of units. If the total is unknown, the
    /// name of the work instead of the unit, with `None`.
    what: (&'static str, Option<usize>),
}

impl Progress {
    /// Adds `count` finished units.
    pub(super) fn add(&self, count: usize) {
        self.work.done.fetch_add(count, Ordering::Relaxed);
    }

    /// Creates the progress line for some work. If the total number of units is known, `what` is the
    /// unit, such as `row`; otherwise `what` is the name of the work. A separate thread watches the
    /// clock, because the work may report nothing for a long time.
    pub(super) fn new(what: &'static str, all: Option<usize>) -> Progress {
        let what = (what, all);
        let work =
            Arc::new(ProgressState { since: Instant::now(), done: AtomicUsize::new(0), what });
        if !io::stderr().is_terminal() {
            return Progress { work, clock: None };
        }
        let (end, ended) = mpsc::channel::<()>();
        let shown = Arc::clone(&work);
        let clock = thread::spawn(move || {
            let mut wait = PATIENCE;
            while ended.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                write_line(&shown.line());
                wait = TICK;
            }
            if wait == TICK {
                write_line("");
            }
        });
        Progress { work, clock: Some((end, clock)) }
    }
}

impl ProgressState {
    fn line(&self) -> String {
        let (done, elapsed) = (self.done.load(Ordering::Relaxed), self.since.elapsed());
        match self.what {
            (work, None) => format!("{work}, {}", in_words(elapsed)),
            (_, Some(all)) if done == all => "writing".to_owned(),
            (what, Some(all)) if done == 0 => format!("{what} 0 of {all}"),
            (what, Some(all)) => {
                let to_come = all.saturating_sub(done) as f64 / done as f64;
                let left = in_words(elapsed.mul_f64(to_come));
                format!("{what} {done} of {all}, {left} left")
            }
        }
    }
}

/// Writes a line over the previous one.
fn write_line(line: &str) {
    let mut out = io::stderr().lock();
    // If standard error is closed, the text is lost.
    let _ = write!(out, "\r\x1b[K{line}").and_then(|()| out.flush());
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((end, clock)) = self.clock.take() {
            drop(end);
            // Even if the thread has panicked, it no longer writes, which is all that matters here.
            let _ = clock.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_far_it_is_and_how_long_it_takes() {
        let progress = Progress::new("row", Some(200));
        assert_eq!(progress.work.line(), "row 0 of 200");
        progress.add(50);
        assert_eq!(progress.work.line(), "row 50 of 200, 0 seconds left");
        progress.add(150);
        assert_eq!(progress.work.line(), "writing");
    }
}
