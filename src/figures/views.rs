//! Figures of the two views.

use std::sync::Arc;

use egui::{Color32, Context, Pos2};
use pinhole_core::ImageSize;
use pinhole_exchange::document::Document;

use super::figure::{Figure, Look};
use crate::model::fault::Fault;
use crate::model::session::Session;
use crate::view::derive::{Deriver, Purpose, ViewSizes};
use crate::view::headless::UiPass;
use crate::view::overlay::Drawing;
use crate::view::typesetting::{label_text, theme};

/// One of the two views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The edited camera's picture.
    Camera,
    /// The scene with the camera in it, as the observer sees it.
    World,
}

impl View {
    /// Returns its name in one word, as the command line has it.
    pub fn name(self) -> &'static str {
        match self {
            View::Camera => "camera",
            View::World => "world",
        }
    }
}

/// A view, `size` large, of the document as the session looks at it: its ray, items, colours and
/// observer.
///
/// # Errors
/// Returns the reason, as the window gives it, if there is nothing to see.
pub fn of_view(
    document: &Document,
    session: &Session,
    view: View,
    size: ImageSize,
    look: Look,
) -> Result<Figure, Fault> {
    let Look { scale, style, transparent } = look;
    let dots = [size.width(), size.height()];
    let is_world = view == View::World;
    let sizes = ViewSizes {
        world: is_world.then_some(dots),
        camera: (!is_world).then_some(dots),
        scale,
        style,
        purpose: Purpose::Figure { clear: transparent },
        ..ViewSizes::default()
    };
    let derived = Deriver::default().derive(document, session, &sizes);
    // A camera without a basis still stands in the world.
    if let Some(fault) = derived.fault.filter(|f| !is_world || matches!(f, Fault::Scene(_))) {
        return Err(fault);
    }
    let shown = if is_world { derived.world_view } else { derived.camera_view };
    let drawing = shown.as_ref().map_or_else(Drawing::default, |shown| Drawing {
        scale,
        marks: shown.marks.to_vec(),
        labels: shown.labels.to_vec(),
    });
    let paths = drawing.paths().map(|path| path.scaled(1.0)).collect();
    let ctx = Context::default();
    theme::install_base(&ctx);
    let size = dots.map(|n| n as usize);
    let drawn = UiPass::draw(&ctx, size, scale, |ui| {
        for label in &drawing.labels {
            label_text::write(ui.painter(), Pos2::ZERO, scale, label);
        }
    });
    let background = style.colors().background;
    Ok(Figure {
        title: if is_world { "World view" } else { "Camera view" }.to_owned(),
        size,
        ground: (!transparent).then_some(background),
        picture: shown.map(|shown| Arc::unwrap_or_clone(shown.image)).filter(has_dots),
        paths,
        drawn,
    })
}

/// Dots per point where no window says: as in a window of 720 points, and never less than one.
pub fn scale_of([width, height]: [u32; 2]) -> f32 {
    (width.min(height) as f32 / 720.0).max(1.0)
}

/// Returns whether there is anything in a picture at all.
fn has_dots(image: &egui::ColorImage) -> bool {
    image.pixels.iter().any(|dot| *dot != Color32::TRANSPARENT)
}
