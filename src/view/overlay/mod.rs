//! The overlay: marks and labels drawn over the traced pictures, such as the camera in its scene
//! and the selected ray.
//!
//! Pure functions build a [`Drawing`] from the values to be shown: marks and labels in dots
//! (physical pixels). [`world`] and [`camera`] also paint the marks on the CPU, straight into the
//! picture; text is left to the caller, who has the fonts. The window and exported figures use the
//! same drawing; vector formats take it apart from the picture.
//!
//! - `world_view`: contents of the world view; `camera_view`: contents of the camera view.
//! - `ghost`: the camera to compare with, in the world view.
//! - `highlighted`, `highlighted_world`, `highlighted_camera`: the highlighted concept, on top of everything else.
//! - `handles`: the handles that can be dragged.
//! - `screen`: projection and clipping; `flat`: its inverse, from a dot to a point of a plane.
//! - `layers`: areas filled dot by dot (planes, the picture on the viewport), and occlusion.
//! - `sketch`: lines and arrows of the world as marks; `labels`: label placement; `path`: marks as
//!   fills and strokes; `paint`: fills and strokes as pixels.

mod camera_in_space;
mod camera_view;
mod drawing;
mod flat;
mod ghost;
mod handles;
mod highlighted;
mod highlighted_camera;
mod highlighted_world;
mod labels;
mod layers;
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
pub use highlighted::Highlighted;
pub use loupe::{Loupe, loupe_window};
pub use paint::paint_paths;
pub use path::{Ink, Outline, Path};
pub use picture::Picture;
pub use style::{Colors, Style};
pub use world_view::{Backdrop, WorldView, pick, t_towards, world, world_apart, world_position_of};

#[cfg(test)]
mod tests;
