//! From a lesson file's text to a lesson.

use std::fs;
use std::path::Path;

use pinhole_core::lecture::exercises::Exercise;
use pinhole_core::lecture::lines::{ImplicitLine, ParametricLine};
use pinhole_core::lecture::mistakes::Mistake;
use pinhole_core::{DVec2, ImageSize, Pixel, Shade};
use toml_edit::Document as Toml;

use super::lesson::{AskedExercise, Lesson, Looks, Step};
use crate::document::Document;
use crate::exercises::LARGEST_SEED;
use crate::formats::fields::{Field, Section, Source};
use crate::formats::scene_argument::SceneSource;
use crate::formats::scene_file::{TABLES, not_toml, tables};
use crate::formats::{FileError, builtin, molecule};
use crate::model::concept::Thing;
use crate::model::derivation_sections::{LedgerSection, LedgerSections};
use crate::model::lines::LinesLab;
use crate::model::observer::Observer;
use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::play::Kind;
use crate::model::session::{DIGITS, Selection, Session, ShadeName, ViewLayout};

/// The format version that this program reads.
pub const VERSION: i64 = 1;

/// Those that stand at the top of a file.
const TOP: [&str; 3] = ["pinhole_lesson", "title", "step"];

/// What a step may say, beside the tables of a scene.
const STEP: [&str; 21] = [
    "title",
    "text",
    "scene",
    "pixel",
    "uv",
    "observer",
    "layout",
    "show",
    "shade",
    "count_from_one",
    "digits",
    "keep_picture",
    "teaching",
    "ledger",
    "lit",
    "mistake",
    "t",
    "play",
    "lines",
    "exercise",
    "seed",
];

/// Reads a lesson file.
///
/// # Errors
/// The first thing that is wrong with it, or with a scene that it names.
pub fn load(path: &Path) -> Result<Lesson, FileError> {
    let text = fs::read_to_string(path).map_err(|error| FileError::unreadable(path, &error))?;
    parse(&text, path, Some(path.parent().unwrap_or(Path::new(""))))
}

/// Whether a file calls itself a lesson, be it a right one or not.
pub fn is_lesson(path: &Path) -> bool {
    let text = fs::read_to_string(path).unwrap_or_default();
    Toml::parse(&text).is_ok_and(|toml| toml.as_table().contains_key(TOP[0]))
}

/// Reads a lesson file's text. `path` is for the messages; `base` is the folder that the paths of
/// scenes are relative to, and `None` where only built-in ones can be meant.
///
/// # Errors
/// As [`load`].
pub fn parse(text: &str, path: &Path, base: Option<&Path>) -> Result<Lesson, FileError> {
    let source = Source { text, path };
    let toml = Toml::parse(text).map_err(|error| not_toml(&source, &error))?;
    let root = Section::root(&source, toml.as_table());
    version(&root)?;
    root.only(&TOP, &[])?;
    let title = line(&root.need("title", "title = \"What the lesson is about\"")?, LONGEST_TITLE)?;
    let sections = root.need("step", "[[step]] with title, text and scene")?.sections_from_one()?;
    let mut steps: Vec<Step> = Vec::new();
    for section in &sections {
        steps.push(step(section, &steps, base)?);
    }
    if steps.is_empty() {
        return Err(root.missing("step", "[[step]] with title, text and scene"));
    }
    Ok(Lesson { title, steps })
}

fn version(root: &Section) -> Result<(), FileError> {
    let field =
        root.need("pinhole_lesson", "pinhole_lesson = 1 (the format version) at the top")?;
    match field.integer() {
        Some(VERSION) => Ok(()),
        Some(newer) if newer > VERSION => Err(field.error(&format!(
            "this lesson format is newer than this program, which reads {VERSION}: get a newer Pinhole"
        ))),
        _ => Err(field.error(&format!("the format version must be {VERSION}"))),
    }
}

/// How many letters a title and a step's text may have: the strip above the views leaves them room.
const LONGEST_TITLE: usize = 120;
const LONGEST_TEXT: usize = 800;

/// Text that is not empty, as one line however it is broken in the file, of so many letters at most.
fn line(field: &Field, longest: usize) -> Result<String, FileError> {
    let text = field.text()?.split_whitespace().collect::<Vec<_>>().join(" ");
    match text.chars().count() {
        0 => Err(field.error("it must say something")),
        letters if letters > longest => Err(field.fault(format!(
            "{letters} letters are too many above the views: at most {longest} fit; part the step"
        ))),
        _ => Ok(text),
    }
}

/// A step: what it says, and for the rest what the steps before it say.
fn step(section: &Section, before: &[Step], base: Option<&Path>) -> Result<Step, FileError> {
    let known: Vec<&str> = STEP.into_iter().chain(TABLES).collect();
    section.only(&known, &TOP[..1])?;
    let title = section.need("title", "title = \"What the step is about\"")?;
    let title = line(&title, LONGEST_TITLE)?;
    let text = section.need("text", "text = \"What to look at, or what to drag.\"")?;
    let text = line(&text, LONGEST_TEXT)?;
    let named = section.get("scene").map(|field| scene(&field, base)).transpose()?;
    let last = before.last();
    let is_new = named.is_some() || last.is_none();
    let mut document = match (named, last) {
        (Some(document), _) => document,
        (None, Some(step)) => step.document.clone(),
        (None, None) => {
            section
                .need("camera", "scene = \"canonical\", or [step.camera] with eye, at and up")?;
            Document::default()
        }
    };
    // The step's own text says what to look for.
    document.note.clear();
    tables(section, &mut document)?;
    let mut looks = last.map(|step| step.looks.clone()).unwrap_or_default();
    if is_new {
        // These mean something in one scene alone.
        (looks.observer, looks.t) = (None, None);
    }
    let selection = match last.filter(|_| !is_new) {
        Some(step) => step.selection,
        None => Session::default().selection,
    };
    let image = document.camera.image;
    let selection = selected(section, image)?.unwrap_or(selection.inside(image));
    let objects = document.object_count();
    if !is_in_scene(looks.lit.flatten(), objects) {
        // It was in the scene of the step before.
        looks.lit = Some(None);
    }
    read_looks(section, &mut looks, objects)?;
    let scene_from = last.filter(|_| !is_new).map_or(before.len(), |step| step.scene_from);
    Ok(Step { title, text, document, scene_from, selection, looks })
}

fn scene(field: &Field, base: Option<&Path>) -> Result<Document, FileError> {
    let name = field.text().map_err(|_| field.error("it must be a scene's name in quotes"))?;
    let source = match (builtin::find(name), base) {
        (Some(scene), _) => SceneSource::Builtin(scene),
        (None, Some(base)) if name.ends_with(".toml") || molecule::is_molecule(name.as_ref()) => {
            SceneSource::File(base.join(name))
        }
        (None, _) => {
            let near = builtin::nearest(name);
            let hint = near.first().map_or_else(
                || "it must be a built-in scene, or the path of a .toml file".to_owned(),
                |near| format!("did you mean \"{near}\"?"),
            );
            return Err(field.error(&hint));
        }
    };
    if let SceneSource::File(path) = &source
        && is_lesson(path)
    {
        return Err(field.error("it is a lesson: name a scene file, or a built-in scene"));
    }
    source.load().map_err(|error| match error.place {
        Some(_) => error,
        // The path is at fault, and it stands in the lesson.
        None => field.error(&error.to_string()),
    })
}

fn selected(section: &Section, image: ImageSize) -> Result<Option<Selection>, FileError> {
    let uv = section.get("uv");
    if let (Some(_), Some(pixel)) = (&uv, section.get("pixel")) {
        return Err(pixel.refuse("beside uv: keep exactly one of them"));
    }
    if let Some(uv) = uv {
        let uv = uv.numbers("two numbers, such as [0.2, -0.1]")?;
        return Ok(Some(Selection::Uv(DVec2::from_array(uv))));
    }
    let Some(field) = section.get("pixel") else { return Ok(None) };
    let right = "row and column, counted from 0, such as [99, 199]";
    let [row, column] = field
        .elements()
        .and_then(|elements| <[Field; 2]>::try_from(elements).ok())
        .ok_or_else(|| field.error(&format!("it must be {right}")))?;
    let row = row.whole(0..=i64::from(image.height()) - 1, "a row of the image")?;
    let column = column.whole(0..=i64::from(image.width()) - 1, "a column of the image")?;
    Ok(Some(Selection::Pixel(Pixel { row: row as u32, column: column as u32 })))
}

fn read_looks(section: &Section, looks: &mut Looks, objects: usize) -> Result<(), FileError> {
    /// What the field says takes the place of what a step before it said.
    fn say<'a, T>(
        section: &Section<'a>,
        key: &str,
        said: &mut Option<T>,
        read: impl Fn(&Field<'a>) -> Result<T, FileError>,
    ) -> Result<(), FileError> {
        if let Some(field) = section.get(key) {
            *said = Some(read(&field)?);
        }
        Ok(())
    }
    say(section, "observer", &mut looks.observer, |field| observer(&field.section()?))?;
    say(section, "layout", &mut looks.layout, |field| {
        let layouts = ViewLayout::ALL;
        let names: Vec<&str> = layouts.iter().filter_map(|layout| layout.name()).collect();
        let name = field.one_of(&names)?;
        let layout = layouts.iter().copied().find(|layout| layout.name() == Some(name));
        Ok(layout.unwrap_or(ViewLayout::Both))
    })?;
    say(section, "show", &mut looks.items, items)?;
    say(section, "shade", &mut looks.shade, shade)?;
    say(section, "count_from_one", &mut looks.count_from_one, Field::boolean)?;
    say(section, "digits", &mut looks.digits, |field| {
        let range = DIGITS.0 as i64..=DIGITS.1 as i64;
        Ok(field.whole(range, "a number of significant digits")? as usize)
    })?;
    say(section, "keep_picture", &mut looks.keep_picture, Field::boolean)?;
    say(section, "teaching", &mut looks.teaching, Field::boolean)?;
    say(section, "ledger", &mut looks.ledger, ledger)?;
    say(section, "lit", &mut looks.lit, |field| lit(field, objects))?;
    say(section, "mistake", &mut looks.mistake, |field| {
        let ids: Vec<_> = Mistake::ALL.iter().map(|mistake| mistake.id()).collect();
        let id = field.one_of(&ids)?;
        Mistake::from_id(id).ok_or_else(|| field.error("it must be a mistake of the gallery"))
    })?;
    say(section, "t", &mut looks.t, Field::number)?;
    // Another step has another camera.
    looks.play = None;
    say(section, "play", &mut looks.play, |field| {
        let name = field.one_of(&Kind::ALL.map(Kind::name))?;
        Kind::from_name(name).ok_or_else(|| field.error("it must be something that plays"))
    })?;
    say(section, "lines", &mut looks.lines, |field| lines(&field.section()?))?;
    looks.exercise = exercise(section)?.or(looks.exercise);
    Ok(())
}

/// The question that is asked. A seed goes with the kind that stands beside it: that of another step
/// would ask for other numbers.
fn exercise(section: &Section) -> Result<Option<AskedExercise>, FileError> {
    let seed = section.get("seed");
    let Some(field) = section.get("exercise") else {
        return match seed {
            Some(seed) => Err(seed.refuse("without exercise: say which, or leave the seed out")),
            None => Ok(None),
        };
    };
    let ids: Vec<_> = Exercise::ALL.iter().map(|exercise| exercise.id()).collect();
    let id = field.one_of(&ids)?;
    let exercise = Exercise::from_id(id)
        .ok_or_else(|| field.error("it must be an exercise of the exercises layout"))?;
    let largest = i64::try_from(LARGEST_SEED).unwrap_or(i64::MAX);
    let seed = seed.map(|seed| seed.whole(0..=largest, "a whole number")).transpose()?;
    Ok(Some(AskedExercise { exercise, seed: seed.map(i64::unsigned_abs) }))
}

fn observer(section: &Section) -> Result<Observer, FileError> {
    section.only(&["target", "azimuth", "elevation", "distance"], &[])?;
    let number = |key: &str, such_as: &str| section.need(key, such_as)?.number();
    Ok(Observer::new(
        section.need("target", "target = [0.0, 0.0, -3.0]")?.vector()?,
        number("azimuth", "azimuth = 40.0 (degrees, from +z towards +x)")?.to_radians(),
        number("elevation", "elevation = 20.0 (degrees above the target)")?.to_radians(),
        section.need("distance", "distance = 12.0")?.positive()?,
    ))
}

fn items(field: &Field) -> Result<OverlayItems, FileError> {
    let known = Item::ALL.map(Item::name);
    let mut shown = OverlayItems::NONE;
    for element in elements(field, "[\"eye\", \"basis\", \"ray\"]")? {
        let name = element.one_of(&known)?;
        Item::ALL.into_iter().filter(|item| item.name() == name).for_each(|i| shown.set(i, true));
    }
    Ok(shown)
}

fn shade(field: &Field) -> Result<ShadeName, FileError> {
    let name = field.one_of(&Shade::ALL.map(Shade::name))?;
    Ok(Shade::ALL.into_iter().find(|shade| shade.name() == name).unwrap_or_default().into())
}

fn elements<'a>(field: &Field<'a>, such_as: &str) -> Result<Vec<Field<'a>>, FileError> {
    field.elements().ok_or_else(|| field.error(&format!("it must be a list, such as {such_as}")))
}

fn ledger(field: &Field) -> Result<LedgerSections, FileError> {
    let known = LedgerSection::ALL.map(LedgerSection::name);
    let section = |element: &Field| Ok(LedgerSection::from_name(element.one_of(&known)?));
    let sections: Result<Vec<_>, FileError> =
        elements(field, "[\"basis\"]")?.iter().map(section).collect();
    Ok(sections?.into_iter().flatten().collect())
}

/// Whether a scene of so many objects has the thing in it.
fn is_in_scene(thing: Option<Thing>, objects: usize) -> bool {
    match thing {
        Some(Thing::Object(object) | Thing::Root { object, .. }) => (object as usize) < objects,
        _ => true,
    }
}

/// A thing of a scene with so many objects, or nothing.
fn lit(field: &Field, objects: usize) -> Result<Option<Thing>, FileError> {
    let numbered = field.text().ok().filter(|name| name.contains(' ')).and_then(Thing::from_name);
    match numbered {
        Some(_) if is_in_scene(numbered, objects) => return Ok(numbered),
        Some(_) if objects == 0 => return Err(field.error("the scene has no objects")),
        Some(_) => {
            let right = format!("the scene's objects are 0 to {}", objects - 1);
            return Err(field.error(&right));
        }
        None => {}
    }
    let numbered = ["object 0", "root 0 1"];
    let known: Vec<&str> = [NOTHING].into_iter().chain(Thing::names()).chain(numbered).collect();
    Ok(Thing::from_name(field.one_of(&known)?))
}

/// What is said where nothing is lit.
const NOTHING: &str = "nothing";

fn lines(section: &Section) -> Result<LinesLab, FileError> {
    section.only(&["implicit", "p", "d", "t"], &[])?;
    let pair = |field: &Field| -> Result<DVec2, FileError> {
        Ok(DVec2::from_array(field.numbers("two numbers, such as [1.0, 1.0]")?))
    };
    let field = section.need("implicit", "implicit = [1.0, 1.0, -2.0] (a, b and c)")?;
    let [a, b, c] = field.numbers("a, b and c, such as [1.0, 1.0, -2.0]")?;
    let line = ImplicitLine { a, b, c };
    line.check().map_err(|error| field.fault(error))?;
    let p = pair(&section.need("p", "p = [0.0, 0.0]")?)?;
    let field = section.need("d", "d = [1.0, 1.0]")?;
    let ray = ParametricLine { p, d: pair(&field)? };
    ray.check().map_err(|error| field.fault(error))?;
    let t = section.get("t").map_or(Ok(0.0), |field| field.number())?;
    Ok(LinesLab::of(line, ray, t))
}
