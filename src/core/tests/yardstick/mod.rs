//! The bench rig: its scenes and its rivals.

mod contestants;
mod scenes;
