//! `pinhole export`: the camera and the scene in another program's words.

use std::fs;
use std::io::Write;
use std::path::Path;

use super::{CommandError, load, of_scene, pose, to_stdout, warn};
use crate::arguments::{ExportArguments, Target};
use crate::exchange::{Subject, With, Written};
use crate::formats::{FileError, atomic};

pub(super) fn run(arguments: &ExportArguments) -> Result<(), CommandError> {
    let document = load(&arguments.scene)?;
    // What is wrong with the camera is told at its place in the file.
    let posed = pose(&arguments.scene, &document)?;
    let format = match arguments.to {
        Target::Format(format) => format,
        Target::Code(language) => {
            let code = language.code(&posed).map_err(|error| of_scene(&arguments.scene, error))?;
            return put(arguments.output.as_deref(), &code);
        }
    };
    let with = match (arguments.camera_only, arguments.meshes) {
        (true, _) => With::CameraAlone,
        (false, true) => With::Meshes,
        (false, false) => With::Objects,
    };
    let written = Subject::new(&document, with).and_then(|subject| format.write(&subject));
    let written = written.map_err(|error| of_scene(&arguments.scene, error))?;
    match &arguments.output {
        Some(path) if written.files.len() > 1 => to_folder(path, &written)?,
        output => put(output.as_deref(), &written.joined().text)?,
    }
    written.notes.iter().for_each(|note| warn(note));
    Ok(())
}

fn put(output: Option<&Path>, text: &str) -> Result<(), CommandError> {
    match output {
        None => to_stdout(|out| out.write_all(text.as_bytes())),
        Some(path) => Ok(atomic::write(path, |file| file.write_all(text.as_bytes()))?),
    }
}

/// A format of several files is a folder of them.
fn to_folder(folder: &Path, written: &Written) -> Result<(), FileError> {
    fs::create_dir_all(folder).map_err(|error| FileError::unwritable(folder, &error))?;
    for (name, sheet) in &written.files {
        atomic::write(&folder.join(name), |file| file.write_all(sheet.text.as_bytes()))?;
    }
    Ok(())
}
