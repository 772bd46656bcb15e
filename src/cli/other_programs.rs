//! Writes scenes in other programs' formats, and reads cameras from them.

use pinhole_core::Camera;
use pinhole_exchange::format::{ExportScene, Include, Input};
use pinhole_exchange::programs::{Importer, file_text};
use pinhole_exchange::{Document, limits, scene_file};

use super::console::{CommandError, read, scene_fault, warn};
use crate::cli::arguments::{ExportArguments, ImportArguments};
use crate::cli::load::{deliver, files_of, load, pose, refuse_overwriting};

/// `pinhole export`: writes the camera and the scene in another program's format.
pub(super) fn export(arguments: &ExportArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    // Reports an invalid camera with its position in the scene file.
    pose(&arguments.scene, &document)?;
    let with = match (arguments.camera_only, arguments.meshes) {
        (true, _) => Include::CameraAlone,
        (false, true) => Include::Meshes,
        (false, false) => Include::Objects,
    };
    let written =
        ExportScene::new(&document, with).and_then(|subject| arguments.to.write(&subject));
    let written = written.map_err(|error| scene_fault(&arguments.scene, error))?;
    let text = written.text.text.as_bytes();
    let inputs = files_of(&arguments.scene, &document);
    deliver(arguments.output.as_deref(), &inputs, |out| out.write_all(text))?;
    written.notes.iter().for_each(|note| warn(note));
    Ok(())
}

/// `pinhole import`: writes a scene with the camera of a glTF, or of literal numbers.
pub(super) fn import(arguments: &ImportArguments) -> Result<(), CommandError> {
    let (inputs, output) = (std::slice::from_ref(&arguments.file), arguments.output.as_deref());
    refuse_overwriting(inputs, output.map(|output| ("-o", output)))?;
    let (path, bytes) = read(&arguments.file, limits::FOREIGN)?;
    let text = file_text(path, bytes)?;
    let text = Input { path, text: &text };
    let importer = Importer::of_file(&text)?;
    let taken = importer.read(&text, &Camera::CANONICAL)?;
    let document = Document {
        note: format!("From {}.", importer.label()),
        camera: taken.camera,
        ..Document::default()
    };
    let scene = scene_file::to_text(&document, None);
    deliver(output, inputs, |out| out.write_all(scene.as_bytes()))?;
    taken.notes.iter().for_each(|note| warn(note));
    Ok(())
}
