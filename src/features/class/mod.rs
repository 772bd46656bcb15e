//! The mistakes of a class, from the codes of its answers.

pub mod code;
pub mod state;
pub mod ui;
