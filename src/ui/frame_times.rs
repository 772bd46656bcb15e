//! Measures how long the work of each frame takes.

use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use web_time::Instant;

use crate::view::derive::WorkKind;

/// The time for each [`WorkKind`], in the order of its variants.
pub type WorkTimes = [Duration; 3];

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
        times[work as usize] += now - *since;
        *since = now;
    }

    /// Adds the time since the last call to the total of all other work, and returns the times of all kinds.
    pub(crate) fn stop(self) -> WorkTimes {
        self.record(WorkKind::Rest);
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner).1
    }
}

/// The times of the last frame's work before it was painted, summed over the frame's egui passes.
#[derive(Debug, Default)]
pub(crate) struct FrameWork {
    /// The context's number for the frame.
    frame: u64,
    times: WorkTimes,
}

impl FrameWork {
    /// Adds the times of an egui pass of the frame with this number.
    pub(crate) fn add(&mut self, frame: u64, pass: WorkTimes) {
        if self.frame != frame {
            *self = FrameWork { frame, ..FrameWork::default() };
        }
        self.times.iter_mut().zip(pass).for_each(|(sum, time)| *sum += time);
    }

    /// Returns the times of the last frame's work; `None` if the frame showed no new picture.
    pub(crate) fn work(&self) -> Option<WorkTimes> {
        let [trace, overlay, _] = self.times;
        (trace + overlay > Duration::ZERO).then_some(self.times)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_of_a_frame_are_one_work_and_a_frame_without_a_picture_has_none() {
        let ms = |times: [u64; 3]| times.map(Duration::from_millis);
        let mut frame = FrameWork::default();
        frame.add(7, ms([0, 0, 2]));
        assert_eq!(frame.work(), None);
        frame.add(7, ms([5, 0, 0]));
        frame.add(7, ms([0, 0, 2]));
        assert_eq!(frame.work(), Some(ms([5, 0, 4])));
        frame.add(8, ms([0, 0, 2]));
        assert_eq!(frame.work(), None);
    }

    #[test]
    fn time_is_counted_for_the_work_that_was_recorded() {
        let stopwatch = Stopwatch::start();
        stopwatch.record(WorkKind::Overlay);
        let [trace, overlay, _] = stopwatch.stop();
        assert!(trace.is_zero() && !overlay.is_zero());
    }
}
