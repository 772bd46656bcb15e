//! The stand-in for systems without signals that end a program: there is nothing to wait for.

/// Nothing ends the window by this.
pub(super) fn end_window_by(_end: impl FnOnce() + Send + 'static) {}

/// Waits for nothing.
pub fn watch() {}

/// Does nothing: there is no signal to pass on.
pub fn pass_on() {}
