//! `pinhole import`: a scene from another program's file.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use pinhole_core::Camera;

use super::{CommandError, to_stdout, warn};
use crate::arguments::ImportArguments;
use crate::document::Document;
use crate::exchange::{Text, recognised_file};
use crate::formats::{FileError, atomic, scene_file};

pub(super) fn run(arguments: &ImportArguments) -> Result<(), CommandError> {
    let path = &arguments.file;
    let text = read(path)?;
    let text = Text { path, text: &text };
    let format = match arguments.from {
        Some(format) => format,
        None => recognised_file(&text)?,
    };
    let taken = format.read(&text, &Camera::CANONICAL)?;
    let document = Document {
        note: format!("From {}.", format.label),
        camera: taken.camera,
        spheres: taken.spheres.into(),
        csv_spheres: None,
        planes: taken.planes.into(),
    };
    document.scene().map_err(|error| FileError::of_file(path, error.to_string()))?;
    let scene = scene_file::to_text(&document, None);
    match &arguments.output {
        None => to_stdout(|out| out.write_all(scene.as_bytes()))?,
        Some(output) => atomic::write(output, |file| io::Write::write_all(file, scene.as_bytes()))?,
    }
    taken.notes.iter().for_each(|note| warn(note));
    Ok(())
}

/// The file's text; of COLMAP, which has its camera and its pose in two files of a folder, both.
fn read(path: &Path) -> Result<String, FileError> {
    if path == Path::new("-") {
        let mut text = String::new();
        let read = io::stdin().lock().read_to_string(&mut text);
        return read
            .map(|_| text)
            .map_err(|error| FileError::unreadable(Path::new("standard input"), &error));
    }
    let pair = ["cameras.txt", "images.txt"];
    let folder = match path.file_name().and_then(|name| name.to_str()) {
        _ if path.is_dir() => Some(path),
        Some(name) if pair.contains(&name) => path.parent(),
        _ => None,
    };
    let Some(folder) = folder else { return read_text(path) };
    let texts: Result<Vec<String>, FileError> =
        pair.iter().map(|name| read_text(&folder.join(name))).collect();
    Ok(texts?.join("\n"))
}

fn read_text(path: &Path) -> Result<String, FileError> {
    let bytes = fs::read(path).map_err(|error| FileError::unreadable(path, &error))?;
    String::from_utf8(bytes)
        .map_err(|_| FileError::of_file(path, "not UTF-8 text: a camera is read from text"))
}
