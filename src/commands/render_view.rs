//! The picture of either view, for `pinhole render`.

use pinhole_core::{Frame, Outputs, Raster, Shade, shade, trace_reporting};

use super::CommandError;
use crate::arguments::View;
use crate::document::Document;

/// What to draw, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderOptions {
    /// Which of the two views.
    pub view: View,
    /// Whether the basis, the viewport and the rays are drawn over it.
    pub overlay: bool,
    /// How a hit becomes a colour.
    pub shade: Shade,
    /// Whether normals are computed even if the shading does not need them.
    pub normals: bool,
}

/// A finished picture.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// Opaque sRGB pixels with alpha 255, row by row from the top.
    pub pixels: Vec<[u8; 4]>,
    /// What was traced for it, pixel by pixel.
    pub frame: Frame,
}

/// Draws a view of the document at its image size. `done` hears of finished rows.
///
/// # Errors
/// A camera that sees nothing, an object that is none, or a view that this program cannot draw.
pub fn render_view(
    document: &Document,
    options: RenderOptions,
    done: impl Fn(usize) + Sync,
) -> Result<Rendering, CommandError> {
    let input = |error: &dyn std::fmt::Display| CommandError::Input(error.to_string());
    if options.view == View::World {
        return Err(input(&"--view world cannot be drawn yet"));
    }
    if options.overlay {
        return Err(input(&"--overlay cannot be drawn yet"));
    }
    let camera = document.camera.posed().map_err(|error| input(&error))?;
    let scene = document.scene().map_err(|error| input(&error))?;
    let raster = Raster::full(camera.image());
    let outputs = Outputs { normal: options.normals };
    let frame = trace_reporting(&scene, &camera, &raster, outputs, done);
    let color_of = |object| document.color_of(object);
    let pixels = shade(&frame, &scene, options.shade, color_of, |[r, g, b]| [r, g, b, 255]);
    Ok(Rendering { pixels, frame })
}
