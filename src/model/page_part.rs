//! The part of a page: how a scene or a lesson goes into a page that shows the program in a browser.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use pinhole_exchange::document::Document;
use pinhole_exchange::host::host;
use pinhole_exchange::page::{self, PagePart};
use pinhole_exchange::{FileError, limits, scene_file};
use toml_edit::Table;

use super::lessons::{OpenLesson, Which, load};

/// The name of a scene in a page.
const SCENE: &str = "scene.toml";

/// Returns the part of a page that opens a scene.
///
/// # Errors
/// Returns an error if the scene cannot be written, or if its table of spheres cannot be read.
pub fn of_scene(document: &Document) -> Result<PagePart, FileError> {
    let mut part = PagePart { scene: Some(SCENE.to_owned()), ..PagePart::default() };
    let mut document = document.clone();
    let mut path = PathBuf::from(SCENE);
    if let Some(csv) = &mut document.csv_spheres {
        // In the folder of its table, the scene names the table alone.
        path = csv.file.with_file_name(SCENE);
        csv.path = csv.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let text = limits::read_text_of(&csv.file, limits::FOREIGN).map_err(|error| {
            let problem = "the scene's spheres are in this table: put it back, then save the page";
            FileError { problem: format!("{}; {problem}", error.problem), ..error }
        })?;
        part.files.insert(csv.path.clone(), text);
    }
    let text = scene_file::prepare(&document, &path, None, false)?.text;
    part.files.insert(SCENE.to_owned(), text);
    Ok(part)
}

/// Returns the part of a page that opens the step of a lesson.
///
/// # Errors
/// Returns an error if the lesson's file or a scene that it names cannot be read, or if the lesson's file
/// has changed since it was opened.
pub fn of_step(open: &OpenLesson) -> Result<PagePart, FileError> {
    let (id, step) = (open.id(), open.id().step + 1);
    match (id.lesson, &open.lesson().file) {
        (Which::Builtin(index), _) => {
            let lesson = Some(format!("{}.{step}", index + 1));
            Ok(PagePart { lesson, ..PagePart::default() })
        }
        (Which::File, Some(path)) => of_lesson_file(path, open),
        (Which::File, None) => Ok(PagePart::default()),
    }
}

fn of_lesson_file(path: &Path, open: &OpenLesson) -> Result<PagePart, FileError> {
    if load(path)? != *open.lesson() {
        let problem = "has changed since the lesson was opened: open it again, then save the page";
        return Err(FileError::of_file(path, problem));
    }
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    let mut part = PagePart { lesson: name, step: Some(open.id().step + 1), ..PagePart::default() };
    for (name, file) in named_files(path)? {
        add(&mut part, &name, &file)?;
    }
    Ok(part)
}

/// Returns the files from which a lesson is read; none if it is built in.
///
/// # Errors
/// Returns an error if a file cannot be read.
pub fn files_of(open: &OpenLesson) -> Result<Vec<PathBuf>, FileError> {
    let files =
        open.lesson().file.as_ref().map_or_else(|| Ok(Vec::new()), |path| named_files(path))?;
    Ok(files.into_iter().map(|(_, file)| file).collect())
}

/// Returns the files from which a lesson's file is read, itself included: their paths from its folder, and their
/// paths.
fn named_files(lesson: &Path) -> Result<Vec<(PathBuf, PathBuf)>, FileError> {
    let own = lesson.file_name().unwrap_or_default();
    let mut files = vec![(own.into(), lesson.to_owned())];
    for scene in scenes_of(&limits::read_text(lesson)?) {
        let (name, file) = (PathBuf::from(&scene), lesson.with_file_name(&scene));
        let table = scene_file::load(&file)?.csv_spheres;
        files.extend(table.map(|table| (name.with_file_name(&table.path), table.file)));
        files.push((name, file));
    }
    Ok(files)
}

/// Returns a note for each of the files in a page that lies outside of the folder of the first one, the scene or the
/// lesson.
pub fn notes(files: &[PathBuf]) -> Vec<String> {
    let Some((own, others)) = files.split_first() else { return Vec::new() };
    let folder = host().resolved(&own.with_file_name("."));
    let is_outside = |file: &&PathBuf| {
        let place = host().resolved(file).zip(folder.as_ref());
        place.is_some_and(|(file, folder)| !file.starts_with(folder))
    };
    let outside = others.iter().filter(is_outside).map(|file| file.display());
    let own = own.display();
    let note = |file| format!("{file} is in the page, too: it is outside of the folder of {own}");
    outside.map(note).collect::<BTreeSet<_>>().into_iter().collect()
}

/// Returns the paths of the scene files that a lesson's text names.
fn scenes_of(text: &str) -> BTreeSet<String> {
    let Ok(lesson) = text.parse::<toml_edit::DocumentMut>() else { return BTreeSet::new() };
    let steps = lesson.get("step").and_then(|steps| steps.as_array_of_tables());
    let named = |step: &Table| {
        let names = ["scene", "ghost"].map(|key| step.get(key)?.as_str().map(str::to_owned));
        names.into_iter().flatten().collect::<Vec<_>>()
    };
    let names = steps.into_iter().flatten().flat_map(named);
    names.filter(|name| name.ends_with(".toml")).collect()
}

/// Adds a file. In a page, no folder is above the lesson's own.
fn add(part: &mut PagePart, name: &Path, file: &Path) -> Result<(), FileError> {
    let text = limits::read_text_of(file, limits::FOREIGN)?;
    let name = page::plain(name).to_string_lossy().into_owned();
    match part.files.insert(name.clone(), text.clone()) {
        Some(other) if other != text => {
            let problem =
                format!("would be {name} in the page, as another file: rename one of them");
            Err(FileError::of_file(file, problem))
        }
        _ => Ok(()),
    }
}
