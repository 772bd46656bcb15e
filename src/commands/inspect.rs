//! `pinhole inspect`: one ray, its camera, and everything it meets.

mod json;
mod text;

use pinhole_core::{DVec2, Pixel, PosedCamera, UpAngle};

use super::{CommandError, load, of_scene, pose, to_stdout};
use crate::arguments::InspectArguments;
use crate::document::Document;
use crate::inspection::Inspection;

/// A ray that is looked at, with all that is said of it.
struct Readout<'a> {
    document: &'a Document,
    camera: PosedCamera,
    up_angle: UpAngle,
    inspection: Inspection,
}

pub(super) fn run(arguments: &InspectArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    let at_fault = |error: &dyn std::fmt::Display| of_scene(&arguments.scene, error);
    let camera = pose(&arguments.scene, &document)?;
    let up_angle = document.camera.up_angle().map_err(|e| at_fault(&e))?;
    let scene = document.scene().map_err(|e| at_fault(&e))?;
    let uv = match (arguments.ray.pixel, arguments.ray.uv) {
        (Some(pixel), _) => uv_of_pixel(&camera, pixel).map_err(|e| at_fault(&e))?,
        (None, uv) => uv.unwrap_or_default(),
    };
    if !camera.ray(uv).direction.is_finite() {
        let problem = "the ray's direction is beyond the range of numbers: make the viewport, its \
                       distance or (u, v) smaller";
        return Err(at_fault(&problem));
    }
    let inspection = Inspection::of_uv(&camera, &scene, uv);
    let readout = Readout { document: &document, camera, up_angle, inspection };
    let text = if arguments.json { readout.to_json()? } else { readout.to_text() };
    to_stdout(|out| out.write_all(text.as_bytes()))
}

fn uv_of_pixel(camera: &PosedCamera, pixel: Pixel) -> Result<DVec2, String> {
    let image = camera.image();
    if image.contains(pixel) {
        return Ok(camera.uv_of_pixel(pixel));
    }
    let Pixel { row, column } = pixel;
    let (width, height) = (image.width(), image.height());
    Err(format!(
        "pixel {row},{column} is outside the image of {height} rows and {width} columns: rows are \
         0 to {}, columns 0 to {}",
        height - 1,
        width - 1
    ))
}
