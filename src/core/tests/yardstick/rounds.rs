//! Times are taken in turn.

use std::time::Duration;

use super::bench::rounds::{Times, interleaved};

fn ms(x: u64) -> Duration {
    Duration::from_millis(x)
}

#[test]
fn the_middle_and_the_least() {
    // The first time is that of the run that is not counted.
    let times = |all: &[u64]| {
        let mut left = all.iter().copied().map(ms);
        let most = all.len() - 1;
        interleaved(1, Duration::from_secs(600), most, |_, frames| {
            left.by_ref().take(frames.len()).collect()
        })
    };
    assert_eq!(times(&[30, 50, 30, 90]), [Times { median: 0.05, min: 0.03, count: 3 }]);
    assert_eq!(times(&[30, 40, 60]), [Times { median: 0.05, min: 0.04, count: 2 }]);
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
