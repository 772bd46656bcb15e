//! Figures and animations as files.

pub mod animation;
pub mod order;
pub mod ui;
