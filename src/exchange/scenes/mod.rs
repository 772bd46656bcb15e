//! Scenes by their argument on the command line: a file, or one of those that come with the program.

pub mod builtin;
mod source;

pub use source::SceneSource;
