//! Measures how busy other processes kept the machine while times were measured.

use std::fs;
use std::time::Instant;

/// The processors' busy times at one moment, with which later ones are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    start: Instant,
    /// Two times in clock ticks: the time for which the processors were not idle, summed over all of
    /// them, and the time used by this process and its ended children.
    ticks: Option<[f64; 2]>,
}

/// Length of a tick in seconds, `1 / USER_HZ`. `USER_HZ` is 100 on every Linux that Rust supports.
const TICK: f64 = 0.01;

impl Watch {
    /// Starts now.
    pub(crate) fn start() -> Watch {
        Watch { start: Instant::now(), ticks: ticks() }
    }

    /// Returns the average number of processors that other processes have kept busy since
    /// [`Watch::start`]: the processors' busy time minus the time used by this process and its ended
    /// children. Returns `None` if the system does not provide these times.
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
    // After the name: the state, ten more fields, then user and system time of the process and of its
    // children.
    let own = own.rsplit(')').next()?.split_whitespace().skip(11).take(4);
    Some([busy, own.filter_map(number).sum()])
}
