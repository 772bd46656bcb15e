//! Writes what the window shows as the last step of a lesson file.

use std::path::Path;

use pinhole_core::Selection;
use pinhole_exchange::scene_file::{TABLES, path_from, to_text, with_table};
use pinhole_exchange::{BuiltinScene, Document, SceneSource};
use pinhole_figure::Concept;
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item as TomlItem, Table, Value, value};

use super::keys::{KEYS, StepKey, is_in_scene};
use super::lesson::Lesson;
use super::read::{VERSION, parse};
use crate::model::files::{OpenDocument, Origin};
use crate::model::{Shown, ViewLayout};

/// Returns the text of a lesson file to whose end a step is added that shows what the window shows, and the
/// lesson that it is read as. The `text` of the file so far is kept as it is; `None` begins a lesson.
///
/// # Errors
/// Returns the reason, as a sentence, if `text` is not a lesson, or if no step can show this scene.
pub fn with_step(
    text: Option<&str>,
    path: &Path,
    open: &OpenDocument,
    shown: &Shown,
) -> Result<(String, Lesson), String> {
    let shown = of_step(&open.document, shown);
    if shown.setup.layout.name().is_none() {
        return Err("A step cannot show this page: open another one first.".to_owned());
    }
    let read = |text: &str| parse(text, path, path.parent());
    let before = text.map(read).transpose().map_err(|error| error.to_string())?;
    let steps = before.map_or(Vec::new(), |lesson| lesson.steps);
    let plain = |one: &Document| Document { note: String::new(), observer: None, ..one.clone() };
    // A step that goes on with a scene cannot take back what the step before it says of t and the formulas.
    let goes_on = steps.last().is_some_and(|last| {
        plain(&last.document) == plain(&open.document)
            && (last.shown.ray_point_t.is_none() || shown.ray_point_t.is_some())
            && (last.shown.formulas.is_none() || shown.formulas.is_some())
    });
    let title = Value::from(&*path.file_stem().unwrap_or_default().to_string_lossy());
    let begun = format!("pinhole_lesson = {VERSION}\ntitle = {title}\n");
    let text = text.unwrap_or(&begun);
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let missing = if text.ends_with('\n') { "" } else { end };
    let (scene, tables) = match scene_of(open, path.parent().unwrap_or(Path::new(""))) {
        _ if goes_on => (String::new(), String::new()),
        (name, scene) => {
            (format!("scene = {}\n", Value::from(name)), tables(&open.document, &scene))
        }
    };
    let step = format!(
        "[[step]]\ntitle = \"Step {}\"\ntext = \"Write here what to look at, or what to drag.\"\n{scene}{}{tables}",
        steps.len() + 1,
        view(&shown)
    );
    let whole = format!("{text}{missing}{end}{}", step.replace('\n', end));
    let lesson =
        read(&whole).map_err(|error| format!("No step can be added: {}.", error.problem))?;
    let last = lesson.steps.last().and_then(|step| with_table(&step.document, &open.document).ok());
    if last.as_ref().map(plain) != Some(plain(&open.document)) {
        return Err("Save the scene first: only its file can name its table of spheres.".into());
    }
    Ok((whole, Lesson { file: Some(path.to_owned()), ..lesson }))
}

/// Returns the name by which a lesson in this folder names the open scene or, if it has none, another one, and
/// the scene with this name.
fn scene_of(open: &OpenDocument, folder: &Path) -> (String, Document) {
    let named = match open.origin() {
        Origin::Scene(source @ SceneSource::File(path)) => {
            path_from(folder, "", path).zip(source.load().ok())
        }
        Origin::Scene(SceneSource::Builtin(scene)) => {
            Some(scene.name.into()).zip(scene.load().ok())
        }
        Origin::Step(_) => None,
    };
    let first = &BuiltinScene::all()[0];
    named.unwrap_or_else(|| (first.name.to_owned(), first.load().unwrap_or_default()))
}

/// Returns what a step shows of what is shown now.
fn of_step(document: &Document, shown: &Shown) -> Shown {
    let mut of_step = shown.clone();
    let is_there = |one: &Concept| is_in_scene(Some(*one), document.object_count());
    of_step.highlighted = shown.highlighted.filter(is_there);
    of_step.subject.retain(is_there);
    of_step.selection = shown.selection.inside(document.camera.image);
    of_step.setup.layout = match shown.setup.layout {
        ViewLayout::DerivationAlone => ViewLayout::Derivation,
        // A step's ghost is a scene.
        ViewLayout::Compare => ViewLayout::Both,
        other => other,
    };
    of_step
}

/// Returns the keys of a step that set what is shown, a line each.
fn view(shown: &Shown) -> String {
    let ray = match shown.selection {
        Selection::Pixel(pixel) => format!("pixel = [{}, {}]", pixel.row, pixel.column),
        Selection::Uv(uv) => format!("uv = {:?}", uv.to_array()),
    };
    let is_of_page = |key: &&StepKey| match key.name {
        "lines" => shown.setup.layout == ViewLayout::Lines,
        "mistake" => shown.setup.layout == ViewLayout::Mistakes,
        _ => true,
    };
    let line = |key: &StepKey| Some(format!("{} = {}\n", key.name, (key.write)(shown)?));
    let keys: String = KEYS.iter().filter(is_of_page).filter_map(line).collect();
    format!("{ray}\nkeep_observer = true\n{keys}")
}

/// Returns the tables of a scene that differ from those of another one, as they stand in a step.
fn tables(document: &Document, base: &Document) -> String {
    let [own, base] = [document, base]
        .map(|document| to_text(document, None).parse::<DocumentMut>().unwrap_or_default());
    let mut step = Table::new();
    for key in TABLES {
        let [own, base] = [own.get(key), base.get(key)];
        if own.map(TomlItem::to_string) != base.map(TomlItem::to_string) {
            step.insert(key, own.cloned().unwrap_or_else(|| value(Array::new())));
        }
    }
    let steps = TomlItem::ArrayOfTables(ArrayOfTables::from_iter([step]));
    let text = DocumentMut::from(Table::from_iter([("step", steps)])).to_string();
    text.strip_prefix("[[step]]\n").unwrap_or_default().to_owned()
}
