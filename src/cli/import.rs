//! `pinhole import`: a scene from another program's file.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use pinhole_core::Camera;
use pinhole_exchange::document::Document;
use pinhole_exchange::format::Input;
use pinhole_exchange::programs::{file_text, importer_of_file};
use pinhole_exchange::{FileError, atomic, limits, scene_file};

use super::console::{read, to_stdout, warn};
use super::error::CommandError;
use super::load::apart;
use super::standard::is_standard;
use crate::cli::arguments::ImportArguments;

pub(super) fn run(arguments: &ImportArguments) -> Result<(), CommandError> {
    let path = &arguments.file;
    let source = read_source(path)?;
    let inputs = match &source.pair {
        Some((folder, _)) => PAIR.map(|name| folder.join(name)).to_vec(),
        None => vec![path.clone()],
    };
    let output = arguments.output.as_deref().filter(|output| !is_standard(output));
    apart(&inputs, output.map(|output| ("-o", output)))?;
    let text = Input { path, text: &source.text };
    let importer = match arguments.from {
        Some(importer) => importer,
        None => importer_of_file(&text)?,
    };
    let taken =
        importer.read(&text, &Camera::CANONICAL).map_err(|error| source.in_its_file(error))?;
    let document = Document {
        note: format!("From {}.", importer.label),
        camera: taken.camera,
        spheres: taken.spheres.into(),
        csv_spheres: None,
        planes: taken.planes.into(),
    };
    document.scene().map_err(|error| FileError::of_file(path, error.to_string()))?;
    let scene = scene_file::to_text(&document, None);
    match output {
        None => to_stdout(|out| out.write_all(scene.as_bytes()))?,
        Some(output) => atomic::write(output, |file| file.write_all(scene.as_bytes()))?,
    }
    source.notes.iter().chain(&taken.notes).for_each(|note| warn(note));
    Ok(())
}

/// Message about a model of COLMAP as it writes it by itself.
const BINARY_MODEL: &str =
    "binary: `colmap model_converter --output_type TXT` writes the model as text";

/// A text with the notes on its bytes, and where it is one of COLMAP's two files after the other: their
/// folder, and how many lines the first one has.
struct Source {
    text: String,
    notes: Vec<String>,
    pair: Option<(PathBuf, usize)>,
}

/// COLMAP's files that make a camera.
const PAIR: [&str; 2] = ["cameras.txt", "images.txt"];

impl Source {
    /// An error at a line of both files, as one at a line of the file that the line is in.
    fn in_its_file(&self, mut error: FileError) -> FileError {
        if let (Some((folder, lines)), Some(location)) = (&self.pair, &mut error.location) {
            let is_second = location.line > *lines;
            location.line -= if is_second { *lines } else { 0 };
            error.file = folder.join(PAIR[usize::from(is_second)]).display().to_string();
        }
        error
    }
}

/// The file's text; of COLMAP, which has its camera and its pose in two files of a folder, both.
fn read_source(path: &Path) -> Result<Source, FileError> {
    let folder = match path.file_name().and_then(|name| name.to_str()) {
        _ if path.is_dir() => Some(path),
        Some(name) if PAIR.contains(&name) => path.parent(),
        _ => None,
    };
    let mut notes = Vec::new();
    let Some(folder) = folder else {
        return Ok(Source { text: read_text(path, &mut notes)?, notes, pair: None });
    };
    let binary = folder.join("cameras.bin");
    if binary.exists() && !folder.join(PAIR[0]).exists() {
        return Err(FileError::of_file(&binary, BINARY_MODEL));
    }
    let cameras = read_text(&folder.join(PAIR[0]), &mut notes)? + "\n";
    let images = read_text(&folder.join(PAIR[1]), &mut notes)?;
    let lines = cameras.matches('\n').count();
    Ok(Source { text: cameras + &images, notes, pair: Some((folder.to_owned(), lines)) })
}

fn read_text(path: &Path, notes: &mut Vec<String>) -> Result<String, FileError> {
    let (path, bytes) = read(path, limits::TEXT)?;
    if ["cameras.bin", "images.bin"].iter().any(|name| path.ends_with(name)) {
        return Err(FileError::of_file(path, BINARY_MODEL));
    }
    let (text, note) = file_text(path, bytes)?;
    notes.extend(note);
    Ok(text)
}
