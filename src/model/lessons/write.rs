//! Writes what the window shows as the last step of a lesson file.

use std::path::Path;

use pinhole_core::Selection;
use pinhole_exchange::scene_file::{TABLES, observer_fields, path_from, to_text, with_table};
use pinhole_exchange::{BuiltinScene, Document, SceneSource};
use pinhole_lecture::ImplicitLine;
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item as TomlItem, Table, Value, value};

use super::lesson::Lesson;
use super::read::{NOTHING, VERSION, is_in_scene, parse};
use crate::model::files::{OpenDocument, Origin};
use crate::model::lines::{LinesLab, ShownLines};
use crate::model::{Concept, DerivationSection, Formulas, Item, Session, ViewLayout};

/// Returns the text of a lesson file to whose end a step is added that shows what the window shows, and the
/// lesson that it is read as. The `text` of the file so far is kept as it is; `None` begins a lesson.
///
/// # Errors
/// Returns the reason, as a sentence, if `text` is not a lesson, or if no step can show this scene.
pub fn with_step(
    text: Option<&str>,
    path: &Path,
    open: &OpenDocument,
    session: &Session,
) -> Result<(String, Lesson), String> {
    if layout_of_step(session).name().is_none() {
        return Err("A step cannot show this page: open another one first.".to_owned());
    }
    let read = |text: &str| parse(text, path, path.parent());
    let before = text.map(read).transpose().map_err(|error| error.to_string())?;
    let steps = before.map_or(Vec::new(), |lesson| lesson.steps);
    let plain = |one: &Document| Document { note: String::new(), observer: None, ..one.clone() };
    // A step that goes on with a scene cannot take back what the step before it says of t and the formulas.
    let goes_on = steps.last().is_some_and(|last| {
        plain(&last.document) == plain(&open.document)
            && (last.view.t.is_none() || session.shown.ray_point_t.is_some())
            && (last.view.formulas.is_none() || session.shown.formulas.is_some())
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
        view(&open.document, session)
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

/// Returns the layout with which a step shows what is shown now.
fn layout_of_step(session: &Session) -> ViewLayout {
    match session.shown.setup.layout {
        ViewLayout::DerivationAlone => ViewLayout::Derivation,
        // A step's ghost is a scene.
        ViewLayout::Compare => ViewLayout::Both,
        other => other,
    }
}

/// Returns the keys of a step that set the view, a line each.
fn view(document: &Document, session: &Session) -> String {
    let settings = &session.shown.setup;
    let layout = layout_of_step(session);
    let key = |name: &str, value: Option<String>| {
        value.map_or(String::new(), |value| format!("{name} = {value}\n"))
    };
    let ray = match session.shown.selection.inside(document.camera.image) {
        Selection::Pixel(pixel) => format!("pixel = [{}, {}]", pixel.row, pixel.column),
        Selection::Uv(uv) => format!("uv = {:?}", uv.to_array()),
    };
    let observer =
        session.shown.observer.map(|observer| observer_fields(&observer.stored()).join(", "));
    let items = Item::ALL.into_iter().filter(|item| settings.items.shows(*item));
    let sections =
        DerivationSection::ALL.into_iter().filter(|one| session.shown.sections.shows(*one));
    let is_there = |one: &Concept| is_in_scene(Some(*one), document.object_count());
    let highlighted =
        session.shown.highlighted.filter(is_there).map_or(NOTHING.into(), Concept::name);
    let formulas = session.shown.formulas.as_ref().map(|formulas| match formulas {
        Formulas::Recap => "\"recap\"".to_owned(),
        some => format!("{:?}", Vec::from_iter(some.concepts().iter().map(|one| one.name()))),
    });
    let lines = (layout == ViewLayout::Lines).then(|| {
        let LinesLab { ray, t, trail, shown, .. } = &session.shown.lines;
        let ImplicitLine { a, b, c } = session.shown.lines.line();
        let implicit = format!("implicit = [{a:?}, {b:?}, {c:?}]");
        let [p, d] = [ray.p, ray.d].map(|pair| pair.to_array());
        let parametric = format!("p = {p:?}, d = {d:?}, t = {t:?}");
        let trail_text = format!(", trail = [{:?}, {:?}]", trail.first, trail.last);
        let trail = if trail.first < trail.last { trail_text } else { String::new() };
        match shown {
            ShownLines::Both => format!("{{ {implicit}, {parametric}{trail} }}"),
            ShownLines::Implicit => format!("{{ {implicit} }}"),
            ShownLines::Parametric => format!("{{ {parametric}{trail} }}"),
        }
    });
    let mistake = (layout == ViewLayout::Mistakes).then_some(session.shown.mistakes_view.chosen);
    [
        ray + "\n",
        key("observer", observer.map(|fields| format!("{{ {fields} }}"))),
        format!("keep_observer = true\nlayout = {:?}\n", layout.name().unwrap_or_default()),
        format!("show = {:?}\n", Vec::from_iter(items.map(Item::name))),
        format!("derivation = {:?}\n", Vec::from_iter(sections.map(DerivationSection::name))),
        key("formulas", formulas),
        format!("highlight = {highlighted:?}\nshade = {:?}\n", settings.shade.name()),
        format!("count_from_one = {}\ndigits = {}\n", settings.count_from_one, settings.digits),
        format!("keep_picture = {}\nteaching = {}\n", settings.keep_picture, settings.teaching),
        key("t", session.shown.ray_point_t.map(|t| format!("{t:?}"))),
        key("mistake", mistake.map(|mistake| format!("{:?}", mistake.id()))),
        key("lines", lines),
    ]
    .concat()
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
