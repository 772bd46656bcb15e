//! Where the program runs: in a window of the desktop, or in a page of a browser. Both show the same
//! [`App`](crate::ui::app::App).

#[cfg(not(target_arch = "wasm32"))]
mod desktop;
#[cfg(target_arch = "wasm32")]
mod web;

#[cfg(not(target_arch = "wasm32"))]
pub use desktop::main;
#[cfg(target_arch = "wasm32")]
pub use web::main;
