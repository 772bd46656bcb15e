//! `pinhole import`: a scene with the camera of a glTF, or of literal numbers.

use std::io::Write as _;

use pinhole_core::Camera;
use pinhole_exchange::document::Document;
use pinhole_exchange::format::Input;
use pinhole_exchange::programs::{Importer, file_text};
use pinhole_exchange::{atomic, limits, scene_file};

use super::console::{CommandError, is_standard, read, to_stdout, warn};
use super::load::apart;
use crate::cli::arguments::ImportArguments;

pub(super) fn run(arguments: &ImportArguments) -> Result<(), CommandError> {
    let output = arguments.output.as_deref().filter(|output| !is_standard(output));
    apart(std::slice::from_ref(&arguments.file), output.map(|output| ("-o", output)))?;
    let (path, bytes) = read(&arguments.file, limits::TEXT)?;
    let (text, note) = file_text(path, bytes)?;
    let text = Input { path, text: &text };
    let importer = Importer::of_file(&text)?;
    let taken = importer.read(&text, &Camera::CANONICAL)?;
    let document = Document {
        note: format!("From {}.", importer.label()),
        camera: taken.camera,
        ..Document::default()
    };
    let scene = scene_file::to_text(&document, None);
    match output {
        None => to_stdout(|out| out.write_all(scene.as_bytes()))?,
        Some(output) => atomic::write(output, |file| file.write_all(scene.as_bytes()))?,
    }
    note.iter().chain(&taken.notes).for_each(|note| warn(note));
    Ok(())
}
