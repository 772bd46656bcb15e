//! The window on the screen, drawn by the graphics driver, or by our own painter if there is none.
//!
//! [`program::run`] opens the window and shows the app in it. It is drawn by:
//!
//! - a hardware graphics adapter, through wgpu, if there is one;
//! - otherwise [`painter`](crate::view::painter), on the CPU: if there is no adapter, if the adapter fails
//!   to start, and if it is itself software, because software drivers take many times as long for the
//!   same picture. It also takes over the open window if the adapter fails later.
//!
//! Both use the same event loop (`window.rs`, `open.rs`), so everything else about the window is
//! the same. Only `gpu.rs` uses wgpu. Files are asked for by the desktop's own dialog, where there is
//! one (`file_dialog`).
//!
//! eframe, egui's own framework for windows, has no renderer on the CPU and cannot hand an open window
//! to another renderer when the adapter fails, so the event loop is our own.

mod cpu;
mod display;
mod file_dialog;
mod frames;
#[cfg(feature = "wgpu")]
mod gpu;
mod open;
pub mod program;
#[cfg_attr(not(unix), path = "no_signals.rs")]
pub mod signals;
mod start;
mod surface;
mod window;
