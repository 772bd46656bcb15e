//! Times of several pieces of work, taken in turn.

use std::ops::Range;
use std::time::{Duration, Instant};

/// Times that a piece of work took, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The middle one of all measurements.
    pub median: f64,
    /// The shortest one.
    pub min: f64,
    /// Number of times.
    pub count: usize,
}

/// Work that is quicker than this is repeated about so long in each turn, the first time untimed: a
/// frame is followed by frames, not by what another contestant leaves in the caches, and threads have
/// had the time to wake up.
const TURN: Duration = Duration::from_millis(25);

/// Times `count` pieces of work in turn, until each has spent its `share` or was timed `most` times.
///
/// `run(index, frames)` does the work of these frames and returns how long each took; the frames are
/// counted through, so that no two are alike. The first run of each is not timed, but where it alone
/// uses up half of the share.
pub fn interleaved(
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
pub fn each<T>(frames: &[T], mut work: impl FnMut(&T)) -> Vec<Duration> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn ms(x: u64) -> Duration {
        Duration::from_millis(x)
    }

    #[test]
    fn the_middle_and_the_least() {
        let times = |nanoseconds: &[u64]| {
            let times = nanoseconds.iter().copied().map(ms).collect();
            Runner { times, spent: ms(0), last: ms(0) }.times()
        };
        assert_eq!(times(&[5, 1, 9]), Times { median: 0.005, min: 0.001, count: 3 });
        assert_eq!(times(&[4, 2]), Times { median: 0.003, min: 0.002, count: 2 });
    }

    #[test]
    fn everything_is_timed_in_turn_and_every_frame_is_new() {
        let mut seen = Vec::new();
        let times = interleaved(3, Duration::from_secs(600), 6, |index, frames| {
            assert_eq!(frames.start, seen.len());
            seen.extend(frames.clone().map(|_| index));
            frames.map(|_| ms(6)).collect()
        });
        assert!(times.iter().all(|times| times.count == 6), "{times:?}");
        // One each, then in turn four timed after one that is not, then the other two.
        let (four, two) = ([1 + 4, 1 + 2], [0, 1, 2]);
        let turns = four.iter().flat_map(|n| two.iter().flat_map(|index| vec![*index; *n]));
        assert_eq!(seen, [0, 1, 2].into_iter().chain(turns).collect::<Vec<_>>());
    }

    #[test]
    fn slow_work_counts_from_its_first_run() {
        let mut runs = 0;
        let times = interleaved(1, ms(2), 100, |_, frames| {
            runs += 1;
            vec![ms(3); frames.len()]
        });
        assert_eq!((runs, times[0].count), (1, 1));
        assert_eq!(times[0].min, 0.003);
    }
}
