//! `pinhole inspect`: one ray, its camera, and everything it meets.

mod json;
mod text;

use pinhole_core::{ResolvedCamera, UpAngle};
use pinhole_exchange::document::Document;

use super::console::{to_json, to_stdout};
use super::error::{CommandError, scene_fault};
use super::load::{load, pose, selection_of};
use crate::cli::arguments::{InspectArguments, RayArguments};
use crate::model::inspection::Inspection;

/// A ray that is looked at, with all that is said of it.
struct Readout<'a> {
    document: &'a Document,
    camera: ResolvedCamera,
    up_angle: UpAngle,
    inspection: Inspection,
}

pub(super) fn run(arguments: &InspectArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    let at_fault = |error: &dyn std::fmt::Display| scene_fault(&arguments.scene, error);
    let camera = pose(&arguments.scene, &document)?;
    let up_angle = document.camera.up_angle().map_err(|e| at_fault(&e))?;
    let scene = document.scene().map_err(|e| at_fault(&e))?;
    let RayArguments { pixel, uv } = arguments.ray;
    let selection = selection_of(&camera, pixel, uv).map_err(|e| at_fault(&e))?;
    let inspection = Inspection::new(&camera, &scene, selection);
    let readout = Readout { document: &document, camera, up_angle, inspection };
    let text = if arguments.json { to_json(&readout.json())? } else { readout.to_text() };
    to_stdout(|out| out.write_all(text.as_bytes()))
}
