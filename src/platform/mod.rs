//! The window on the screen, drawn by the graphics driver, or by our own painter if there is none.
//!
//! [`program::run`] opens the window and shows the app in it. It is drawn by:
//!
//! - a graphics adapter, through wgpu, if there is one that is hardware;
//! - otherwise [`painter`](crate::view::painter), on the CPU: if there is no adapter, if the adapter fails to start, and
//!   if it is itself software, because software drivers take many times as long for the same
//!   picture. It also takes over the open window if the adapter fails later.
//!
//! Both use the same event loop (`window.rs`, `open.rs`), so everything else about the window is
//! the same. Only `gpu.rs` uses wgpu.
//!
//! The app's first pass runs while the window opens (`first_pass.rs`).
//!
//! Files are asked for by the desktop's own dialog, where there is one (`file_dialog`).
//!
//! egui's own framework for windows cannot fall back to another renderer in the same process, so one
//! event loop of ours drives both.

mod cpu;
mod display;
mod error;
mod file_dialog;
mod first_pass;
mod frame_log;
#[cfg(feature = "wgpu")]
mod gpu;
mod open;
pub mod program;
mod repeats;
#[cfg_attr(not(unix), path = "no_signals.rs")]
pub mod signals;
mod start;
mod surface;
mod textures;
mod window;
