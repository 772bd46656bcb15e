//! Reads the text of a lesson file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use pinhole_core::{DVec2, ImageSize, Pixel, Selection};
use pinhole_exchange::fields::{Section, TomlField, TomlSource};
use pinhole_exchange::scene_file::{TABLES, tables, toml};
use pinhole_exchange::{BuiltinScene, Document, FileError, SceneSource, limits};
use pinhole_figure::{Concept, Observer, OverlayItems};
use pinhole_lecture::{Exercise, LARGEST_SEED, Vote};

use super::keys::{KEYS, choice, is_in_scene, items};
use super::lesson::{AskedExercise, Lesson, Step, StepQuestion};
use crate::features::play::state::Kind;
use crate::model::{Ghost, Shown};

/// The version of the lesson format that this program reads.
pub const VERSION: i64 = 1;

/// The keys at the top of a file.
const TOP: [&str; 3] = ["pinhole_lesson", "title", "step"];

/// The keys that a step may have in addition to those of [`KEYS`] and the tables of a scene.
const STEP: &str =
    "title text ask answer choices hide scene pixel uv keep_observer play ghost exercise seed";

/// Reads a lesson file.
///
/// # Errors
/// Returns the first error in the file, or in a scene that it names.
pub fn load(path: &Path) -> Result<Lesson, FileError> {
    let text = limits::read_text(path)?;
    let lesson = parse(&text, path, Some(path.parent().unwrap_or(Path::new(""))))?;
    Ok(Lesson { file: Some(path.to_owned()), ..lesson })
}

/// Returns true if a file has the key that marks a lesson, even if the lesson is invalid.
pub fn is_lesson(path: &Path) -> bool {
    let text = limits::read_text(path).unwrap_or_default();
    toml(&TomlSource { text: &text, path, is_draft: false })
        .is_ok_and(|toml| toml.as_table().contains_key(TOP[0]))
}

/// Parses the text of a lesson file. `path` is used in error messages. The paths of scenes are relative
/// to the folder `base`; if it is `None`, only built-in scenes are allowed.
///
/// # Errors
/// Returns the same errors as [`load`].
pub fn parse(text: &str, path: &Path, base: Option<&Path>) -> Result<Lesson, FileError> {
    let source = TomlSource { text, path, is_draft: false };
    let toml = toml(&source)?;
    let root = Section::root(&source, toml.as_table());
    root.version(TOP[0], "lesson", VERSION)?;
    root.only(&TOP, &[])?;
    let title = line(&root.need("title", "title = \"What the lesson is about\"")?, LONGEST_TITLE)?;
    let sections = root.need("step", "[[step]] with title, text and scene")?.sections_from_one()?;
    let mut steps: Vec<Step> = Vec::new();
    let mut known = Known::new();
    for section in &sections {
        steps.push(step(section, &steps, base, &mut known)?);
    }
    if steps.is_empty() {
        return Err(root.missing("step", "[[step]] with title, text and scene"));
    }
    Ok(Lesson { title, steps, file: None })
}

/// Maximum numbers of characters: of a title, of a step's text, of a question or an answer, and of a choice. They
/// must fit beside the figure.
const LONGEST_TITLE: usize = 120;
const LONGEST_TEXT: usize = 800;
const LONGEST_ANSWER: usize = 300;
const LONGEST_CHOICE: usize = 60;

/// Reads a text field and joins its lines. The text must not be empty or longer than `longest` characters.
fn line(field: &TomlField, longest: usize) -> Result<String, FileError> {
    let words = field.text()?.split([' ', '\n', '\t', '\r']).filter(|word| !word.is_empty());
    // A no-break space stays: it keeps a formula in one line.
    let text = words.collect::<Vec<_>>().join(" ");
    match text.chars().count() {
        0 => Err(field.error("it must say something")),
        letters if letters > longest => Err(field.fault(format!(
            "{letters} letters are too many above the views: at most {longest} fit; part the step"
        ))),
        _ => Ok(text),
    }
}

/// The scenes that a lesson has named, by their names, without their tables.
type Known = BTreeMap<String, Document>;

/// Reads a step. Values that the step does not specify are those of the previous step.
fn step(
    section: &Section,
    before: &[Step],
    base: Option<&Path>,
    known: &mut Known,
) -> Result<Step, FileError> {
    let own = KEYS.iter().map(|key| key.name);
    let fields: Vec<&str> = STEP.split(' ').chain(own).chain(TABLES).collect();
    section.only(&fields, &TOP[..1])?;
    let title = section.need("title", "title = \"What the step is about\"")?;
    let title = line(&title, LONGEST_TITLE)?;
    let text = section.need("text", "text = \"What to look at, or what to drag.\"")?;
    let text = line(&text, LONGEST_TEXT)?;
    let question = question(section)?;
    let named = section.get("scene").map(|field| scene(&field, base, known)).transpose()?;
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
    // The step's own text replaces the scene's note.
    document.note.clear();
    tables(section, &mut document)?;
    let mut shown = inherited(last, is_new, &document);
    shown.selection = selected(section, document.camera.image)?.unwrap_or(shown.selection);
    shown.spoken = Some(spoken_of(&title, &text));
    let mut step = Step {
        title,
        text,
        question,
        document,
        scene_from: last.filter(|_| !is_new).map_or(before.len(), |step| step.scene_from),
        shown,
        // Without them there is no point on the ray, no card of formulas, and no subject.
        said: last.map_or(BTreeSet::from(["t", "formulas", "subject"]), |step| step.said.clone()),
        keep_observer: last.is_some_and(|step| step.keep_observer),
        // The camera may have changed, so the previous step's animation is not inherited.
        play: None,
        exercise: exercise(section)?.or(last.and_then(|step| step.exercise)),
    };
    for key in KEYS {
        if let Some(field) = section.get(key.name) {
            (key.read)(&field, &mut step)?;
            step.said.insert(key.name);
        }
    }
    if let Some(field) = section.get("keep_observer") {
        step.keep_observer = field.boolean()?;
    }
    if let Some(field) = section.get("play") {
        step.play = Some(choice(&field, Kind::ALL.map(|one| (one.name(), one)))?);
    }
    let other = section.get("ghost").map(|field| scene(&field, base, known)).transpose()?;
    step.shown.ghost = other.map(|other| Ghost { camera: other.camera, shows_differences: false });
    Ok(step)
}

/// Returns what the step after `last` shows unless it says otherwise. `is_new` is true if its scene is another one.
fn inherited(last: Option<&Step>, is_new: bool, document: &Document) -> Shown {
    let mut shown = last.map(|step| step.shown.clone()).unwrap_or_default();
    if is_new {
        // These belonged to the previous scene.
        shown.observer = document.observer.map(Observer::from);
        (shown.ray_point_t, shown.formulas) = (None, None);
        shown.selection = Selection::default();
    }
    shown.subject.clear();
    shown.selection = shown.selection.inside(document.camera.image);
    if !is_in_scene(shown.highlighted, document.object_count()) {
        // The highlighted concept belonged to an object of the previous step's scene.
        shown.highlighted = None;
    }
    shown
}

/// Returns which of the viewport's concepts (such as the distance) and the normal a step's title or text
/// names.
fn spoken_of(title: &str, text: &str) -> Vec<Concept> {
    const NAMES: [(&str, Concept); 5] = [
        ("width", Concept::Viewport),
        ("height", Concept::Viewport),
        ("distance", Concept::Distance),
        ("the normal", Concept::Normal),
        ("**n**", Concept::Normal),
    ];
    let text = format!("{title} {text}").to_lowercase();
    let named = NAMES.into_iter().filter(|(name, _)| text.contains(name));
    named.map(|(_, concept)| concept).collect()
}

/// Reads the question to the class. Unlike other fields, it is not inherited by the next step.
fn question(section: &Section) -> Result<Option<StepQuestion>, FileError> {
    let [ask, answer, choices, hide] =
        ["ask", "answer", "choices", "hide"].map(|key| section.get(key));
    match (ask, answer) {
        (Some(ask), Some(answer)) => Ok(Some(StepQuestion {
            ask: line(&ask, LONGEST_ANSWER)?,
            answer: line(&answer, LONGEST_ANSWER)?,
            choices: choices.map_or(Ok(Vec::new()), |choices| choices_of(&choices))?,
            hidden: hide.map_or(Ok(OverlayItems::NONE), |hide| items(&hide))?,
        })),
        (Some(ask), None) => Err(ask.refuse("without answer: say what comes after the question")),
        (None, Some(answer)) => Err(answer.refuse("without ask: say the question, or write text")),
        (None, None) => match (hide, choices) {
            (Some(hide), _) => {
                Err(hide.refuse("without ask and answer: what is shown stands in show"))
            }
            (None, Some(choices)) => {
                Err(choices.refuse("without ask and answer: a vote is on a question"))
            }
            (None, None) => Ok(None),
        },
    }
}

/// Reads the answers to vote on.
fn choices_of(field: &TomlField) -> Result<Vec<String>, FileError> {
    let right = || field.error("it must be 2 to 4 answers, the right one first");
    let texts = field.elements().ok_or_else(right)?;
    if !(2..=Vote::OPTIONS).contains(&texts.len()) {
        return Err(right());
    }
    let mut choices: Vec<String> = Vec::new();
    for text in &texts {
        let choice = line(text, LONGEST_CHOICE)?;
        if choices.contains(&choice) {
            return Err(text.error("it is there twice: each answer must be another one"));
        }
        choices.push(choice);
    }
    Ok(choices)
}

/// Reads the scene that a field names, unless it is in `known`. Its table is checked, and kept only while a step with
/// it is shown.
fn scene(field: &TomlField, base: Option<&Path>, known: &mut Known) -> Result<Document, FileError> {
    let name = field.text().map_err(|_| field.error("it must be a scene's name in quotes"))?;
    if let Some(known) = known.get(name) {
        return Ok(known.clone());
    }
    let source = match (BuiltinScene::find(name), base) {
        (Some(scene), _) => SceneSource::Builtin(scene),
        (None, Some(base)) if name.ends_with(".toml") => SceneSource::File(base.join(name)),
        (None, _) => {
            let near = BuiltinScene::nearest(name);
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
    let document = source.load().map_err(|error| match error.location {
        Some(_) => error,
        // The path is wrong, so the error points to the lesson's field with the path.
        None => field.error(&error.to_string()),
    })?;
    Ok(known.entry(name.to_owned()).insert_entry(document.without_table()).get().clone())
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
        .and_then(|elements| <[TomlField; 2]>::try_from(elements).ok())
        .ok_or_else(|| field.error(&format!("it must be {right}")))?;
    let row = row.whole(0..=i64::from(image.height()) - 1, "a row of the image")?;
    let column = column.whole(0..=i64::from(image.width()) - 1, "a column of the image")?;
    Ok(Some(Selection::Pixel(Pixel { row: row as u32, column: column as u32 })))
}

/// Reads the step's exercise. A seed requires the kind of question in the same step, because another
/// kind of question would get different numbers from the seed.
fn exercise(section: &Section) -> Result<Option<AskedExercise>, FileError> {
    let seed = section.get("seed");
    let Some(field) = section.get("exercise") else {
        return match seed {
            Some(seed) => Err(seed.refuse("without exercise: say which, or leave the seed out")),
            None => Ok(None),
        };
    };
    let exercise = choice(&field, Exercise::LISTED.iter().map(|one| (one.id(), *one)))?;
    let largest = i64::try_from(LARGEST_SEED).unwrap_or(i64::MAX);
    let seed = seed.map(|seed| seed.whole(0..=largest, "a whole number")).transpose()?;
    Ok(Some(AskedExercise { exercise, seed: seed.map(i64::unsigned_abs) }))
}
