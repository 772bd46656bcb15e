//! Pinhole: what a pinhole camera sees, and why. The program behind `src/main.rs`, as a library so
//! that its tests can drive it.
//!
//! The way of one edit: a panel changes the [`pinhole_exchange::document::Document`] in place; [`ui::app`] runs inputs,
//! apply, derive, outputs, once; [`view::derive`] is pure; overlay, readouts and upload get what it
//! made and nothing else.

pub mod cli;
pub mod figures;
pub mod model;
pub mod platform;
pub mod report;
pub mod ui;
pub mod view;
