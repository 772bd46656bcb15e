//! Whether the machine was one's own while times were taken.

use std::fs;
use std::time::Instant;

/// A moment from which on the use of the machine's processors is watched.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    start: Instant,
    /// Ticks of all processors that were not idle, and those of this process and its ended children.
    ticks: Option<[f64; 2]>,
}

/// Length of a tick in seconds: `USER_HZ`, which is 100 wherever Linux has Rust.
const TICK: f64 = 0.01;

impl Watch {
    /// Starts now.
    pub(crate) fn start() -> Watch {
        Watch { start: Instant::now(), ticks: ticks() }
    }

    /// Number of processors that others kept busy since, on average: what this process and its ended
    /// children did not use of their time. `None` where the system does not tell.
    pub(crate) fn others(&self) -> Option<f64> {
        let ([busy, own], [busy_then, own_then]) = (ticks()?, self.ticks?);
        let others = (busy - busy_then) - (own - own_then);
        Some((TICK * others / self.start.elapsed().as_secs_f64()).max(0.0))
    }
}

fn ticks() -> Option<[f64; 2]> {
    let number = |word: &str| word.parse::<f64>().ok();
    let all = fs::read_to_string("/proc/stat").ok()?;
    // cpu user nice system idle iowait irq softirq steal
    let all: Vec<f64> = all.lines().next()?.split_whitespace().filter_map(number).collect();
    let busy = all.get(..8)?.iter().sum::<f64>() - all[3] - all[4];
    let own = fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name: state, ten more, then user and system of the process and of its children.
    let own = own.rsplit(')').next()?.split_whitespace().skip(11).take(4);
    Some([busy, own.filter_map(number).sum()])
}
