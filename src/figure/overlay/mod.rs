//! The overlay: marks and labels drawn over the traced pictures, such as the camera in its scene and the
//! selected ray.
//!
//! Pure functions build a [`Drawing`]: marks and labels with positions in screen pixels. [`world`] and
//! [`camera`] also paint the marks into the picture, on the CPU. The caller draws the text, since it has
//! the fonts. The window and exported figures use the same drawing; in vector formats it stays separate
//! from the picture. In names, *dots* are pixels of the screen, and *pixels* usually those of an image.
//!
//! - `parts`: the one list of what is drawn of the camera, its ray and what is compared with them; each part says
//!   where it is in space, which concept it stands for, its item and its label. `parts/emphasis`: how strongly a
//!   part is drawn; `parts/sight`: what of the parts must be in sight, for the observer's fit.
//! - `world_view`, `camera_view`: the contents of the two views; in each, `lens` draws parts as they are seen there.
//! - `drawing`: marks and labels, and marks as fills and strokes; `paint`: paints these as pixels; `style`:
//!   colours and text sizes.
//! - `screen`: projection and clipping; `flat`: the inverse, from a screen pixel to a point of a plane.
//! - `world_view/ground`: the panes that stand for planes, the floor's grid, and the drop lines to it.
//! - `world_view/sketch`: turns lines and arrows of the world into marks, visible or hidden.
//! - `line_style`: how lines are drawn; `labels`: places labels.
//! - `pixel_numbers`: the numbers of rows and columns along the pixel grid.
//! - `layers`: occlusion, and areas filled pixel by pixel (planes, the picture on the viewport).

use std::ops::Deref;
use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Rgb, Scene};

mod camera_view;
mod drawing;
mod flat;
mod labels;
mod layers;
mod line_style;
mod paint;
mod parts;
mod pixel_numbers;
mod screen;
mod style;
mod world_view;

pub use camera_view::loupe::{Loupe, loupe_window};
pub use camera_view::{CameraView, camera};
pub use drawing::{Drawing, Ink, Label, Mark, Path, PathOutline, Shape, concept_at};
pub use layers::Backdrop;
pub use paint::{Picture, paint_paths};
pub use parts::Figure;
pub use parts::camera::UP_LENGTH;
pub use parts::compared::GhostCamera;
pub use parts::emphasis::Highlighted;
pub use parts::sight::{drawn, drawn_of, observer_of, subject};
pub use screen::{arrow_length, camera_uv_at, length_of_points, world_position_of};
pub use style::{Colors, Style, contrast_ratio};
pub use world_view::handles::{HandleMark, Handles, Knob, KnobState};
pub use world_view::lens::SMALL_VIEWPORT;
pub use world_view::under_pointer::{PointShown, Under, point_at};
pub use world_view::{Below, WorldView, pick, t_towards, world};

use camera_view::CameraSketch;
use drawing::{LABEL_DIGITS, circle, dot, equals, wide};
use flat::{Flat, FlatRow, FlatSpot, Grid};
use labels::{Request, place_labels};
use layers::{BAND, Bowl, Layers, PlanePatch, ViewportLayer, mix, opposing_grey};
use line_style::{Head, LineStyle};
use paint::{Fills, StretchedPicture};
use parts::camera::corners;
use parts::emphasis::{ACCOMPANYING, BUD, Emphasis, STRONG, dim, first};
use parts::ray::{UvLeg, uv_legs};
use parts::{ASKED_SPHERES, DrawnPart, Form, Part, Toward, When};
use pixel_numbers::{half_extent, numbers};
use screen::{CutLine, Screen, Spot, position_of, tangents, unit};
use style::{
    BOLD_POINT, DIMMED, FINE, LEGIBLE, LabelFont, MARK, MEDIUM, POINT, THICK, THIN, VECTOR, VISIBLE,
};
use world_view::lens::{cased, silhouette};
use world_view::sketch::Sketch;

/// A shared value that is compared by identity: two are equal only if they share the same allocation.
#[derive(Debug)]
pub struct Same<T>(pub Arc<T>);

impl<T> Clone for Same<T> {
    fn clone(&self) -> Same<T> {
        Same(Arc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Same<T>) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<T> Deref for Same<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

/// A scene with the colour of each of its objects.
///
/// Views borrow it only while they are drawn. If a view kept a reference to the scene, an edit would have
/// to copy all objects instead of replacing one in place.
#[derive(Clone, Copy)]
pub struct ColoredScene<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The colours, in the order of the objects.
    pub colors: &'a [Rgb],
}

/// Returns an opaque colour.
pub fn opaque([r, g, b]: Rgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

impl ColoredScene<'_> {
    fn color_of(&self, index: u32) -> Rgb {
        self.colors.get(index as usize).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests;
