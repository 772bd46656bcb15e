//! `pinhole export`: the camera and the scene in another program's words.

use pinhole_exchange::format::{ExportScene, Include};

use super::console::{to_stdout, warn};
use super::error::{CommandError, scene_fault};
use super::load::{self, apart, load, pose};
use super::standard::is_standard;
use crate::cli::arguments::ExportArguments;
use crate::model::files::{files_of, save_written};

pub(super) fn run(arguments: &ExportArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    // What is wrong with the camera is told at its position in the file.
    pose(&arguments.scene, &document)?;
    let with = match (arguments.camera_only, arguments.meshes) {
        (true, _) => Include::CameraAlone,
        (false, true) => Include::Meshes,
        (false, false) => Include::Objects,
    };
    let written =
        ExportScene::new(&document, with).and_then(|subject| arguments.to.write(&subject));
    let written = written.map_err(|error| scene_fault(&arguments.scene, error))?;
    match arguments.output.as_deref().filter(|output| !is_standard(output)) {
        None => to_stdout(|out| out.write_all(written.joined().text.as_bytes()))?,
        Some(path) => {
            let files = files_of(&written, path);
            let outputs = files.iter().map(|(path, _)| ("-o", path.as_path()));
            apart(&load::files_of(&arguments.scene, &document), outputs)?;
            save_written(&written, path)?;
        }
    }
    written.notes.iter().for_each(|note| warn(note));
    Ok(())
}
