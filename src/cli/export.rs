//! `pinhole export`: the camera and the scene in another program's words.

use std::io::Write as _;

use pinhole_exchange::atomic;
use pinhole_exchange::export_scene::{ExportScene, Include};

use super::console::{CommandError, is_standard, scene_fault, to_stdout, warn};
use super::load::{apart, files_of, load, pose};
use crate::cli::arguments::ExportArguments;

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
    let text = written.text.text.as_bytes();
    match arguments.output.as_deref().filter(|output| !is_standard(output)) {
        None => to_stdout(|out| out.write_all(text))?,
        Some(path) => {
            apart(&files_of(&arguments.scene, &document), [("-o", path)])?;
            atomic::write(path, |file| file.write_all(text))?;
        }
    }
    written.notes.iter().for_each(|note| warn(note));
    Ok(())
}
