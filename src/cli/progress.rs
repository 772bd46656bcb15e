//! Shows the progress of long work on a terminal.

use std::io::{self, IsTerminal, Write as _};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::model::recovery::in_words;

/// A progress line on standard error. The line appears if standard error is a terminal and the work
/// takes longer than [`PATIENCE`].
pub(super) struct Progress {
    since: Instant,
    done: AtomicUsize,
    /// The unit that is counted, such as `row`.
    unit: &'static str,
    /// The total number of units.
    all: usize,
    /// Time from the start after which the line is written next; `None` if standard error is no
    /// terminal.
    due: Option<Mutex<Duration>>,
}

/// Time after which the progress line appears.
const PATIENCE: Duration = Duration::from_secs(1);

/// Time from one line to the next.
const TICK: Duration = Duration::from_millis(100);

impl Progress {
    /// Creates the progress line for work that consists of `all` units, such as rows.
    pub(super) fn new(unit: &'static str, all: usize) -> Progress {
        let due = io::stderr().is_terminal().then(|| Mutex::new(PATIENCE));
        Progress { since: Instant::now(), done: AtomicUsize::new(0), unit, all, due }
    }

    /// Adds `count` finished units, and writes the line if it is due.
    pub(super) fn add(&self, count: usize) {
        let done = self.done.fetch_add(count, Ordering::Relaxed) + count;
        // If the lock is held, another thread is writing the line.
        let Some(Ok(mut due)) = self.due.as_ref().map(Mutex::try_lock) else { return };
        let elapsed = self.since.elapsed();
        let is_last = done == self.all && *due > PATIENCE;
        if elapsed >= *due || is_last {
            *due = elapsed + TICK;
            write_line(&self.line(done, elapsed));
        }
    }

    fn line(&self, done: usize, elapsed: Duration) -> String {
        let Progress { unit, all, .. } = self;
        match done {
            0 => format!("{unit} 0 of {all}"),
            done if done == *all => "writing".to_owned(),
            done => {
                let to_come = all.saturating_sub(done) as f64 / done as f64;
                let left = in_words(elapsed.mul_f64(to_come));
                format!("{unit} {done} of {all}, {left} left")
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
        let due = self.due.take().and_then(|due| due.into_inner().ok());
        if due.is_some_and(|due| due > PATIENCE) {
            write_line("");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_far_it_is_and_how_long_it_takes() {
        let progress = Progress::new("row", 200);
        let line = |done| progress.line(done, Duration::from_secs(20));
        assert_eq!(line(0), "row 0 of 200");
        assert_eq!(line(50), "row 50 of 200, 60 seconds left");
        assert_eq!(line(200), "writing");
    }
}
