//! When the program's own files are written: some time after a change, and on another thread, because a slow disk
//! must not delay a frame.

use std::sync::Arc;
use std::thread::{self, JoinHandle};

use egui::Context;

use super::window::complain;

/// Time from the last change until changes are written, in seconds.
const REST: f64 = 1.0;
/// Maximum time from the first unwritten change until changes are written, in seconds.
const LONGEST: f64 = 4.0;

/// Time until the next attempt if the last write is still in progress, in seconds.
const BUSY: f64 = 0.1;

/// The changes that a file does not have yet, and the write in progress.
#[derive(Default)]
pub(super) struct Writing {
    /// What is told before the reason if changes could not be written.
    failure: &'static str,
    /// Time of the last change, in seconds.
    last_change: f64,
    /// Time of the first change that is not written yet, in seconds; `None` if there is none.
    pub(super) first_change: Option<f64>,
    thread: Option<JoinHandle<Result<(), String>>>,
    /// The last reason why changes could not be written.
    pub(super) fault: Option<String>,
}

impl Drop for Writing {
    /// Waits for the last write, so that nothing is written any more when the window is gone.
    fn drop(&mut self) {
        self.finish();
    }
}

impl Writing {
    pub(super) fn new(failure: &'static str) -> Writing {
        Writing { failure, last_change: 0.0, first_change: None, thread: None, fault: None }
    }

    /// Notes a change.
    pub(super) fn note(&mut self, ctx: &Context) {
        self.last_change = ctx.input(|i| i.time);
        self.first_change.get_or_insert(self.last_change);
    }

    /// Returns true if changes must be written now: the user pauses, or [`LONGEST`] has passed. Otherwise asks for a
    /// frame when they must.
    pub(super) fn is_due(&mut self, ctx: &Context) -> bool {
        let is_busy = self.thread.as_ref().is_some_and(|thread| !thread.is_finished());
        if !is_busy {
            self.finish();
        }
        let Some(first) = self.first_change else { return false };
        let rest = (self.last_change + REST).min(first + LONGEST) - ctx.input(|i| i.time);
        if rest > 0.0 || is_busy {
            ctx.request_repaint_after_secs(if rest > 0.0 { rest } else { BUSY } as f32);
        }
        rest <= 0.0 && !is_busy
    }

    /// Starts to write all changes, once the last write is finished.
    pub(super) fn start(&mut self, write: impl Fn() -> Result<(), String> + Send + Sync + 'static) {
        self.finish();
        self.first_change = None;
        let write = Arc::new(write);
        let on_thread = Arc::clone(&write);
        // There may be no thread to have: a browser has none.
        match thread::Builder::new().spawn(move || on_thread()) {
            Ok(thread) => self.thread = Some(thread),
            Err(_) => self.tell(write()),
        }
    }

    /// Waits until the last write is finished, so that it cannot overwrite a later one.
    pub(super) fn finish(&mut self) {
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has written nothing.
            self.tell(thread.join().unwrap_or_else(|_| Err("it failed".to_owned())));
        }
    }

    /// Tells why changes could not be written, each reason once.
    pub(super) fn tell(&mut self, written: Result<(), String>) {
        if let Err(reason) = written
            && self.fault.as_ref() != Some(&reason)
        {
            complain(&format!("{}: {reason}", self.failure));
            self.fault = Some(reason);
        }
    }
}
