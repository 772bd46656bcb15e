//! The part of a page: how a scene or a lesson goes into a page that shows the program in a browser.

use std::path::{Component, Path, PathBuf};

use pinhole_exchange::document::Document;
use pinhole_exchange::page::PagePart;
use pinhole_exchange::{FileError, limits, scene_file};
use toml_edit::Table;

use super::lessons::{OpenLesson, Which};

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
        part.files.insert(csv.path.clone(), limits::read_text(&csv.file)?);
    }
    let text = scene_file::prepare(&document, &path, None, false)?.text;
    part.files.insert(SCENE.to_owned(), text);
    Ok(part)
}

/// Returns the part of a page that opens the step of a lesson.
///
/// # Errors
/// Returns an error if the lesson's file or a scene that it names cannot be read.
pub fn of_step(open: &OpenLesson) -> Result<PagePart, FileError> {
    let (id, step) = (open.id(), open.id().step + 1);
    match (id.lesson, &open.lesson().file) {
        (Which::Builtin(index), _) => {
            let lesson = Some(format!("{}.{step}", index + 1));
            Ok(PagePart { lesson, ..PagePart::default() })
        }
        (Which::File, Some(path)) => of_lesson_file(path, step),
        (Which::File, None) => Ok(PagePart::default()),
    }
}

fn of_lesson_file(path: &Path, step: usize) -> Result<PagePart, FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut part = PagePart { lesson: Some(name.clone()), step: Some(step), ..PagePart::default() };
    let text = limits::read_text(path)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for scene in scenes_of(&text) {
        add_scene(&mut part, folder, &scene)?;
    }
    part.files.insert(name, text);
    Ok(part)
}

/// Returns the paths of the scene files that a lesson's text names.
fn scenes_of(text: &str) -> Vec<String> {
    let Ok(lesson) = text.parse::<toml_edit::DocumentMut>() else { return Vec::new() };
    let steps = lesson.get("step").and_then(|steps| steps.as_array_of_tables());
    let named = |step: &Table| {
        let names = ["scene", "ghost"].map(|key| step.get(key)?.as_str().map(str::to_owned));
        names.into_iter().flatten().collect::<Vec<_>>()
    };
    let names = steps.into_iter().flatten().flat_map(named);
    names.filter(|name| name.ends_with(".toml")).collect()
}

/// Adds the files of a scene that a lesson names, relative to the lesson's folder.
fn add_scene(part: &mut PagePart, folder: &Path, scene: &str) -> Result<(), FileError> {
    let path = folder.join(scene);
    let document = scene_file::load(&path)?;
    let below = |file: &Path| {
        let is_plain = |part| matches!(part, Component::Normal(_) | Component::CurDir);
        let inside = file.strip_prefix(folder).ok();
        inside.filter(|file| file.components().all(is_plain)).map(Path::to_path_buf).ok_or_else(
            || {
                FileError::of_file(
                    file,
                    "a page has only files from the lesson's own folder: move it there",
                )
            },
        )
    };
    let mut files = vec![path.clone()];
    files.extend(document.csv_spheres.map(|csv| csv.file));
    for file in files {
        let name = below(&file)?.to_string_lossy().into_owned();
        part.files.insert(name, limits::read_text(&file)?);
    }
    Ok(())
}
