//! Molecules as scenes: the atoms of `.xyz` and `.pdb` or `.ent` files as spheres in the colours of their
//! elements, as large as their van der Waals radii; one unit is one ångström.
//!
//! A molecule has no camera of its own: it gets one that frames it (`framing.rs`). Nothing is
//! ever saved as a molecule; what was opened as one is saved as a scene file.

mod atoms;
pub mod elements;
mod framing;
mod pdb;
mod xyz;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use pinhole_core::Sphere;

use super::FileError;
use super::Place;
use crate::document::{CsvSpheres, Document, Item};
use atoms::Molecule;

/// The endings of molecules' files.
pub const ENDINGS: [&str; 3] = ["xyz", "pdb", "ent"];

/// More atoms than this are no objects to edit one by one: the scene names the molecule's file for
/// them, as it names a file of spheres.
const EDITABLE: usize = 500;

/// Whether the path's ending is a molecule's.
pub fn is_molecule(path: &Path) -> bool {
    kind(path).is_some()
}

fn kind(path: &Path) -> Option<&'static str> {
    let ending = path.extension()?.to_str()?;
    ENDINGS.into_iter().find(|known| known.eq_ignore_ascii_case(ending))
}

/// Opens a molecule as a scene.
///
/// # Errors
/// A file that cannot be read, or the first line at fault with its field and value.
pub fn load(path: &Path) -> Result<Document, FileError> {
    let mut document = parse(&text_of(path)?, path)?;
    if document.spheres.len() > EDITABLE
        && let Some(name) = path.file_name().and_then(|name| name.to_str())
    {
        document.csv_spheres = Some(CsvSpheres {
            path: name.to_owned(),
            file: path.to_owned(),
            items: Arc::new(std::mem::take(&mut document.spheres)),
        });
    }
    Ok(document)
}

/// Opens a molecule's text as a scene, every atom an object of its own. The ending of `path` says
/// which format it is; `path` is for the messages, too.
///
/// # Errors
/// As [`load`].
pub fn parse(text: &str, path: &Path) -> Result<Document, FileError> {
    let molecule = read(text, path)?;
    let spheres: Vec<Item<Sphere>> = molecule.atoms.iter().map(|atom| atom.item()).collect();
    Ok(Document {
        note: molecule.note(),
        camera: framing::camera(spheres.iter().map(|item| item.shape)),
        spheres: spheres.into(),
        ..Document::default()
    })
}

/// The spheres alone, as a scene file's `spheres = "molecule.pdb"` has them.
///
/// # Errors
/// As [`load`].
pub(super) fn spheres(path: &Path) -> Result<Vec<Item<Sphere>>, FileError> {
    Ok(read(&text_of(path)?, path)?.atoms.iter().map(|atom| atom.item()).collect())
}

/// What the file holds and the scene does not: other frames, models or locations; a sentence.
///
/// # Errors
/// As [`load`].
pub fn left_out(path: &Path) -> Result<Option<String>, FileError> {
    Ok(read(&text_of(path)?, path)?.left_out)
}

fn read(text: &str, path: &Path) -> Result<Molecule, FileError> {
    let text = text.trim_start_matches('\u{feff}');
    let molecule = match kind(path) {
        Some("pdb" | "ent") => pdb::read(text, path)?,
        _ => xyz::read(text, path)?,
    };
    if molecule.atoms.is_empty() {
        let right = "there must be one at least";
        return Err(FileError::of_file(path, format!("there is no atom in it: {right}")));
    }
    Ok(molecule)
}

fn text_of(path: &Path) -> Result<String, FileError> {
    let bytes = fs::read(path).map_err(|error| FileError::unreadable(path, &error))?;
    String::from_utf8(bytes).map_err(|error| FileError {
        place: Some(Place::of_byte(error.as_bytes(), error.utf8_error().valid_up_to())),
        ..FileError::of_file(path, "not UTF-8 text: a molecule's file is text")
    })
}
