//! Measures how long the work of each frame takes.

use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use web_time::Instant;

use crate::view::derive::WorkKind;

/// The time that a frame spent on each kind of work before it was painted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorkTimes {
    pub(crate) trace: Duration,
    pub(crate) overlay: Duration,
    /// Time for everything else that is derived from the document.
    pub(crate) readouts: Duration,
    /// True if the frame made a new picture.
    pub(crate) is_new: bool,
}

/// A stopwatch that measures the time for each kind of work separately.
pub(crate) struct Stopwatch(Mutex<(Instant, WorkTimes)>);

impl Stopwatch {
    pub(crate) fn start() -> Stopwatch {
        Stopwatch(Mutex::new((Instant::now(), WorkTimes::default())))
    }

    /// Adds the time since the last call to the total of this kind of work.
    pub(crate) fn record(&self, work: WorkKind) {
        let now = Instant::now();
        let (since, times) = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let time = match work {
            WorkKind::Trace => &mut times.trace,
            WorkKind::Overlay => &mut times.overlay,
            WorkKind::Rest => &mut times.readouts,
        };
        *time += now - *since;
        *since = now;
        times.is_new |= work != WorkKind::Rest;
    }

    /// Adds the time since the last call to the total of all other work, and returns the times of all kinds.
    pub(crate) fn stop(self) -> WorkTimes {
        self.record(WorkKind::Rest);
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner).1
    }
}

impl WorkTimes {
    /// Returns the time spent on tracing; `None` if nothing was traced.
    pub(crate) fn traced(&self) -> Option<Duration> {
        Some(self.trace).filter(|trace| !trace.is_zero())
    }
}

/// The times of the last frame's work, summed over the frame's egui passes.
#[derive(Debug, Default)]
pub(crate) struct FrameWork {
    /// The context's number for the frame.
    frame: u64,
    work: Option<WorkTimes>,
}

impl FrameWork {
    /// Adds the times of an egui pass of the frame with this number. Ignores passes of the frame before the
    /// first one that makes a new picture.
    pub(crate) fn add(&mut self, frame: u64, pass: WorkTimes) {
        if self.frame != frame {
            *self = FrameWork { frame, work: None };
        }
        match &mut self.work {
            Some(work) => {
                work.trace += pass.trace;
                work.overlay += pass.overlay;
                work.readouts += pass.readouts;
            }
            None => self.work = Some(pass).filter(|pass| pass.is_new),
        }
    }

    /// Returns the times of the last frame's work; `None` if the frame showed no new picture.
    pub(crate) fn work(&self) -> Option<WorkTimes> {
        self.work
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_of_a_frame_are_one_work_and_a_frame_without_a_picture_has_none() {
        let ms = Duration::from_millis;
        let traced = WorkTimes { trace: ms(5), is_new: true, ..WorkTimes::default() };
        let idle = WorkTimes { readouts: ms(2), ..WorkTimes::default() };
        let mut frame = FrameWork::default();
        frame.add(7, idle);
        assert_eq!(frame.work(), None);
        frame.add(7, traced);
        frame.add(7, idle);
        assert_eq!(frame.work(), Some(WorkTimes { readouts: ms(2), ..traced }));
        frame.add(8, idle);
        assert_eq!(frame.work(), None);
    }

    #[test]
    fn time_is_counted_for_the_work_that_was_recorded() {
        let stopwatch = Stopwatch::start();
        stopwatch.record(WorkKind::Overlay);
        let times = stopwatch.stop();
        assert!(times.is_new && times.traced().is_none() && !times.overlay.is_zero());
        assert!(!Stopwatch::start().stop().is_new);
    }
}
