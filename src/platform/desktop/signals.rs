//! Handles the signals that end the program. The window saves its changes to a separate file and closes;
//! a command removes its temporary files. A file that may not become larger is an error of writing, not a signal.

use std::sync::atomic::{AtomicI32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A function that ends the window.
type End = Box<dyn FnOnce() + Send>;

/// The function that ends the open window; `None` without a window.
static WINDOW: Mutex<Option<End>> = Mutex::new(None);

/// The signal that ended the window; 0 if none did.
static ENDED_BY: AtomicI32 = AtomicI32::new(0);

/// Time within which several signals count as one. A terminal that closes sends SIGHUP twice, and a session
/// that ends sends SIGTERM and SIGHUP.
const TOGETHER: Duration = Duration::from_secs(2);

/// Arranges that the first signal calls `end`, which closes the window. A later signal ends the program as
/// usual.
pub(super) fn end_window_by(end: impl FnOnce() + Send + 'static) {
    *WINDOW.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(end));
}

/// Starts a thread that waits for signals. Signals that are ignored from the start, as with `nohup`,
/// stay ignored.
pub(super) fn watch() {
    use signal_hook::consts::{
        SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ,
    };
    use signal_hook::iterator::Signals;
    let ignored = ignored();
    // Any handler makes the write that caused the signal fail, instead of ending the program.
    let _ = signal_hook::flag::register(SIGXFSZ, Arc::default());
    let heeded = [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU];
    let heeded = heeded.into_iter().filter(|signal| !is_in(*signal, ignored));
    // If signals cannot be caught, they end the program as usual.
    let Ok(mut signals) = Signals::new(heeded) else { return };
    std::thread::spawn(move || {
        let mut ended: Option<Instant> = None;
        for signal in signals.forever() {
            let end = WINDOW.lock().unwrap_or_else(PoisonError::into_inner).take();
            match end {
                Some(end) => {
                    ENDED_BY.store(signal, Ordering::SeqCst);
                    ended = Some(Instant::now());
                    end();
                }
                None if ended.is_some_and(|ended| ended.elapsed() < TOGETHER) => {}
                None => {
                    pinhole_exchange::atomic::abandon();
                    // This has the signal's default effect, so it does not return.
                    let _ = signal_hook::low_level::emulate_default_handler(signal);
                }
            }
        }
    });
}

/// If a signal closed the window, ends the program with the same signal, so that the parent process sees
/// it.
pub(super) fn pass_on() {
    match ENDED_BY.load(Ordering::SeqCst) {
        0 => {}
        // It does not return.
        signal => drop(signal_hook::low_level::emulate_default_handler(signal)),
    }
}

fn is_in(signal: i32, set: u64) -> bool {
    set >> (signal - 1) & 1 == 1
}

/// Returns the set of signals that this process ignores, with one bit per signal. The set is empty if
/// the system does not report it.
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let set = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    set.and_then(|set| u64::from_str_radix(set.trim(), 16).ok()).unwrap_or_default()
}
