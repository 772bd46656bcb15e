//! Internal errors of the program (panics), which are reported as messages instead of ending the program.

use std::any::Any;
use std::cell::RefCell;
use std::io::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};

thread_local! {
    /// The message of this thread's last panic, with its location in the source code.
    static LAST: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Installs a panic hook that passes a message about each panic to `tell`, and stores it for [`caught`].
pub fn watch(tell: impl Fn(&str) + Send + Sync + 'static) {
    std::panic::set_hook(Box::new(move |panic| {
        let place = panic.location().map(|place| format!(", at {place}")).unwrap_or_default();
        let text = format!("{}{place}", text_of(panic.payload()));
        tell(&text);
        LAST.set(Some(text));
    }));
}

/// Prints the message of a panic to standard error.
pub fn print(text: &str) {
    // If standard error is closed, the message is lost.
    let _ = writeln!(
        std::io::stderr(),
        "pinhole: a fault of the program itself: {text}\n\
         Please report it, with what was done and the files that were read."
    );
}

/// Runs a function and catches its panic, which is an internal error of the program.
///
/// # Errors
/// Returns the message of the panic.
pub fn caught<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    LAST.take();
    catch_unwind(AssertUnwindSafe(run))
        .map_err(|payload| LAST.take().unwrap_or_else(|| text_of(&*payload)))
}

/// Returns the message of a panic.
pub fn text_of(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<String>().cloned();
    text.or_else(|| payload.downcast_ref::<&str>().map(|text| (*text).to_owned()))
        .unwrap_or_else(|| "an unknown failure".to_owned())
}
