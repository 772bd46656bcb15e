//! Pinhole: what a pinhole camera sees, and why. The program behind `src/main.rs`, as a library so
//! that its tests can drive it.
//!
//! The way of one edit: a panel changes the [`document::Document`] in place; `app` runs inputs,
//! apply, derive, outputs, once; `derive` is pure; overlay, readouts and upload get what it made
//! and nothing else.

pub mod document;
pub mod inspection;
pub mod present;
