//! Pinhole: what a pinhole camera sees, and why. The program behind `src/main.rs`, as a library so
//! that its tests can drive it.
//!
//! The way of one edit: a panel changes the [`document::Document`] in place; [`app`] runs inputs,
//! apply, derive, outputs, once; [`mod@derive`] is pure; overlay, readouts and upload get what it made
//! and nothing else.

pub mod accuracy;
pub mod action;
pub mod app;
pub mod arguments;
pub mod coarseness;
pub mod code;
mod columns;
pub mod commands;
pub mod derive;
pub mod document;
pub mod exchange;
pub mod exercises;
pub mod expression;
pub mod figures;
pub mod files;
pub mod formats;
pub mod formula;
mod frame_log;
mod frame_times;
pub mod ghost;
pub mod grades;
pub mod handles;
pub mod history;
pub mod inspection;
mod label_text;
pub mod ledger;
pub mod lessons;
mod letters;
pub mod lines;
#[cfg(feature = "report")]
mod machine;
mod measuring;
pub mod mistakes;
mod number;
pub mod observer;
pub mod overlay;
pub mod panels;
pub mod play;
pub mod plot;
pub mod present;
pub mod presenter;
pub mod report;
pub mod session;
pub mod store;
mod symbols;
pub mod thing;
pub mod translator;
pub mod verbs;
mod view_texture;
pub mod window;
