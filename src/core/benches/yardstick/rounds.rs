//! Times several programs' frames in turn.

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

/// Minimum length of a turn. A contestant whose frame is quicker makes several in each turn, of which
/// the first is not timed. Timed frames therefore start with the contestant's own data in the caches,
/// and with its threads awake.
const TURN: Duration = Duration::from_millis(25);

/// Times `count` contestants in turn, until each has used up the time `share` or was timed `most`
/// times.
///
/// `run(index, frames)` makes the contestant `index` draw the frames with these numbers, and returns
/// how long each took. No number occurs twice. Each contestant's first frame is not counted, unless it
/// alone takes more than half of `share`.
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

/// Calls `work` for each of the frames, and returns how long each call took.
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
