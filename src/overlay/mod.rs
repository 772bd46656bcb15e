//! What is drawn over the traced pictures: the camera in its scene, and the selected ray.
//!
//! Pure functions from what is to be shown to a [`Drawing`]: marks and labels in dots (physical
//! pixels). [`world`] and [`camera`] also paint it, on the CPU, straight into the picture; text is
//! left to the caller, who has fonts. The window and exported figures use the same drawing; those
//! that are not pixels get it apart from the picture.
//!
//! - `world_view`: what the world view shows; `camera_view`: what the camera view shows.
//! - `ghost`: the camera that is compared with, in the world view.
//! - `lit`, `lit_world`, `lit_camera`: what is pointed at, over all else.
//! - `handles`: what can be taken in the hand.
//! - `screen`: projection and clipping; `flat`: the way back, from a dot to a place on a plane.
//! - `layers`: what is filled dot by dot (planes, the picture on the viewport), and what hides what.
//! - `sketch`: lines and arrows of the world into marks; `labels`: places for text;
//!   `path`: marks into fills and strokes; `paint`: those into pixels.

mod camera_in_space;
mod camera_view;
mod drawing;
mod flat;
mod ghost;
mod handles;
mod items;
mod labels;
mod layers;
mod lit;
mod lit_camera;
mod lit_world;
mod loupe;
mod objects;
mod paint;
mod path;
mod picture;
mod screen;
mod sketch;
mod style;
mod world_view;

pub use camera_in_space::UP_LENGTH;
pub use camera_view::{CameraView, camera, camera_apart, camera_position_of_uv, camera_uv_at};
pub use drawing::{Drawing, Label, Mark, Shape, Target, thing_at};
pub use handles::{
    Guide, HandleMark, Handles, Knob, KnobState, arrow_length, length_of_points, normal_length,
};
pub use items::{Item, OverlayItems};
pub use lit::Lit;
pub use loupe::{Loupe, loupe_window};
pub use paint::paint_paths;
pub use path::{Ink, Outline, Path};
pub use picture::Picture;
pub use style::{Colors, Scheme, Style};
pub use world_view::{Backdrop, WorldView, pick, t_towards, world, world_apart, world_position_of};

#[cfg(test)]
mod tests;
