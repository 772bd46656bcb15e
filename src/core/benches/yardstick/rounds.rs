//! Measures the times of several pieces of work in turn.

use std::ops::Range;
use std::time::{Duration, Instant};

/// The times that a piece of work took, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Times {
    /// The median of all measurements.
    pub(crate) median: f64,
    /// The shortest of all measurements.
    pub(crate) min: f64,
    /// Number of times.
    pub(crate) count: usize,
}

/// Work that is quicker than this is repeated for about this long in each turn, the first time without
/// timing. So a timed frame follows a frame of the same contestant, not the cache contents of another
/// one, and threads have had time to wake up.
const TURN: Duration = Duration::from_millis(25);

/// Times `count` pieces of work in turn, until each has spent its `share` or was timed `most` times.
///
/// `run(index, frames)` does the work of these frames and returns how long each took. Frames are
/// numbered consecutively, so that no two are equal. The first run of each piece of work is not counted,
/// unless it alone takes half of the share.
pub(crate) fn interleaved(
    count: usize,
    share: Duration,
    most: usize,
    mut run: impl FnMut(usize, Range<usize>) -> Vec<Duration>,
) -> Vec<Times> {
    let mut frame = 0;
    let mut timed = |index: usize, count: usize| {
        frame += count;
        run(index, frame - count..frame)
    };
    let mut runners: Vec<Runner> =
        (0..count).map(|index| Runner::new(timed(index, 1)[0], share)).collect();
    while runners.iter().any(|runner| runner.goes_on(share, most)) {
        for (index, runner) in runners.iter_mut().enumerate() {
            if runner.goes_on(share, most) {
                runner.take_turn(most, |count| timed(index, count));
            }
        }
    }
    runners.iter().map(Runner::times).collect()
}

/// Does the work of each frame. Returns how long each took.
pub(crate) fn each<T>(frames: &[T], mut work: impl FnMut(&T)) -> Vec<Duration> {
    let timed = |frame: &T| {
        let start = Instant::now();
        work(frame);
        start.elapsed()
    };
    frames.iter().map(timed).collect()
}

struct Runner {
    times: Vec<Duration>,
    spent: Duration,
    last: Duration,
}

impl Runner {
    fn new(first: Duration, share: Duration) -> Runner {
        let times = if first > share / 2 { vec![first] } else { Vec::new() };
        Runner { times, spent: first, last: first }
    }

    fn goes_on(&self, share: Duration, most: usize) -> bool {
        self.times.is_empty() || (self.spent < share && self.times.len() < most)
    }

    fn take_turn(&mut self, most: usize, timed: impl FnOnce(usize) -> Vec<Duration>) {
        let is_quick = self.last < TURN;
        let fitting = TURN.div_duration_f64(self.last) as usize;
        let count = fitting.clamp(1, most.max(1) - self.times.len());
        let times = timed(count + usize::from(is_quick));
        self.spent += times.iter().sum::<Duration>();
        self.last = times[times.len() - 1];
        self.times.extend(&times[usize::from(is_quick)..]);
    }

    fn times(&self) -> Times {
        let mut seconds: Vec<f64> = self.times.iter().map(Duration::as_secs_f64).collect();
        seconds.sort_by(f64::total_cmp);
        let middle = seconds.len() / 2;
        let median = match seconds.len() % 2 {
            0 => 0.5 * (seconds[middle - 1] + seconds[middle]),
            _ => seconds[middle],
        };
        Times { median, min: seconds[0], count: seconds.len() }
    }
}
