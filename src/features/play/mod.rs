//! Animations of the camera, the ray's t and the pixels.

mod player;
pub mod state;
#[cfg(test)]
mod tests;
pub mod ui;

pub use player::Player;
