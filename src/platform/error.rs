//! The reasons why there is no window.

use std::fmt;

/// A reason why there is no window, or no longer one.
#[derive(Debug)]
pub(super) enum PresentError {
    /// There is no display to open a window on.
    NoDisplay(String),
    /// The display refused the window.
    NoWindow(String),
    /// `--renderer wgpu` was requested and no adapter works.
    NoAdapter(String),
    /// Drawing began to fail while the window was open, on the CPU too.
    Lost(String),
}

impl fmt::Display for PresentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDisplay(cause) => write!(
                f,
                "there is no display to open a window on: {cause}; pinhole render, inspect and the \
                 other commands need none: see pinhole --help"
            ),
            Self::NoWindow(cause) => write!(f, "the display refused to open a window: {cause}"),
            Self::NoAdapter(cause) => {
                write!(f, "no graphics adapter works: {cause}; without one: pinhole --renderer cpu")
            }
            Self::Lost(cause) => write!(f, "the window can no longer be drawn: {cause}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_what_to_do_instead() {
        let message = PresentError::NoDisplay("none is set".into()).to_string();
        assert!(message.contains("pinhole --help"), "{message}");
        let message = PresentError::NoAdapter("none".into()).to_string();
        assert!(message.contains("--renderer cpu"), "{message}");
    }
}
