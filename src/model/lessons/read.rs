//! Reads the text of a lesson file.

use std::collections::BTreeMap;
use std::path::Path;

use pinhole_core::{DVec2, ImageSize, Pixel, Selection, Shade};
use pinhole_exchange::fields::{Section, TomlField, TomlSource};
use pinhole_exchange::scene_file::{TABLES, observer, tables, toml};
use pinhole_exchange::{BuiltinScene, Document, FileError, SceneSource, limits};
use pinhole_lecture::{Exercise, ImplicitLine, Mistake, ParametricLine};

use super::lesson::{AskedExercise, Lesson, Step, StepQuestion, StepView};
use crate::model::lines::{ShownLines, Trail};
use crate::model::play::Kind;
use crate::model::practice::LARGEST_SEED;
use crate::model::session::{DIGITS, ViewLayout};
use crate::model::{
    Concept, DerivationSection, DerivationSections, Formulas, Ghost, Item, LinesLab, Observer,
    OverlayItems,
};

/// The version of the lesson format that this program reads.
pub const VERSION: i64 = 1;

/// The keys at the top of a file.
const TOP: [&str; 3] = ["pinhole_lesson", "title", "step"];

/// The keys that a step may have in addition to the tables of a scene.
const STEP: &str = "title text ask answer hide scene pixel uv observer keep_observer layout show \
                    shade count_from_one digits keep_picture teaching derivation formulas highlight mistake t \
                    play ghost lines exercise seed";

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

/// Maximum numbers of characters: of a title, of a step's text, and of a question or an answer. They must
/// fit into the strip above the views.
const LONGEST_TITLE: usize = 120;
const LONGEST_TEXT: usize = 800;
const LONGEST_ANSWER: usize = 300;

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
    let fields: Vec<&str> = STEP.split(' ').chain(TABLES).collect();
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
    let mut view = last.map(|step| step.view.clone()).unwrap_or_default();
    if is_new {
        // The observer and t belonged to the previous scene.
        let observer = document.observer.map(Observer::from);
        (view.observer, view.t, view.formulas) = (observer, None, None);
    }
    let selection = match last.filter(|_| !is_new) {
        Some(step) => step.selection,
        None => Selection::default(),
    };
    let image = document.camera.image;
    let selection = selected(section, image)?.unwrap_or(selection.inside(image));
    let objects = document.object_count();
    if !is_in_scene(view.highlighted.flatten(), objects) {
        // The highlighted concept belonged to an object of the previous step's scene.
        view.highlighted = Some(None);
    }
    read_view(section, &mut view, objects)?;
    let other = section.get("ghost").map(|field| scene(&field, base, known)).transpose()?;
    view.ghost = other.map(|other| Ghost { camera: other.camera, shows_differences: false });
    let scene_from = last.filter(|_| !is_new).map_or(before.len(), |step| step.scene_from);
    Ok(Step { title, text, question, document, scene_from, selection, view })
}

/// Reads the question to the class. Unlike other fields, it is not inherited by the next step.
fn question(section: &Section) -> Result<Option<StepQuestion>, FileError> {
    let [ask, answer, hide] = ["ask", "answer", "hide"].map(|key| section.get(key));
    match (ask, answer) {
        (Some(ask), Some(answer)) => Ok(Some(StepQuestion {
            ask: line(&ask, LONGEST_ANSWER)?,
            answer: line(&answer, LONGEST_ANSWER)?,
            hidden: hide.map_or(Ok(OverlayItems::NONE), |hide| items(&hide))?,
        })),
        (Some(ask), None) => Err(ask.refuse("without answer: say what comes after the question")),
        (None, Some(answer)) => Err(answer.refuse("without ask: say the question, or write text")),
        (None, None) => match hide {
            Some(hide) => Err(hide.refuse("without ask and answer: what is shown stands in show")),
            None => Ok(None),
        },
    }
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

fn read_view(section: &Section, view: &mut StepView, objects: usize) -> Result<(), FileError> {
    /// Replaces the inherited value if the field is present.
    fn say<'a, T>(
        section: &Section<'a>,
        key: &str,
        said: &mut Option<T>,
        read: impl Fn(&TomlField<'a>) -> Result<T, FileError>,
    ) -> Result<(), FileError> {
        if let Some(field) = section.get(key) {
            *said = Some(read(&field)?);
        }
        Ok(())
    }
    say(section, "observer", &mut view.observer, |field| observer(field).map(Observer::from))?;
    say(section, "keep_observer", &mut view.keep_observer, TomlField::boolean)?;
    say(section, "layout", &mut view.layout, |field| {
        let layouts = ViewLayout::LISTED.into_iter().filter_map(|one| Some((one.name()?, one)));
        choice(field, layouts)
    })?;
    say(section, "show", &mut view.items, items)?;
    say(section, "shade", &mut view.shade, |field| {
        choice(field, Shade::ALL.map(|one| (one.name(), one)))
    })?;
    say(section, "count_from_one", &mut view.count_from_one, TomlField::boolean)?;
    say(section, "digits", &mut view.digits, |field| {
        let range = DIGITS.0 as i64..=DIGITS.1 as i64;
        Ok(field.whole(range, "a number of significant digits")? as usize)
    })?;
    say(section, "keep_picture", &mut view.keep_picture, TomlField::boolean)?;
    say(section, "teaching", &mut view.teaching, TomlField::boolean)?;
    say(section, "derivation", &mut view.derivation, derivation)?;
    say(section, "formulas", &mut view.formulas, |field| {
        if field.text() == Ok("recap") {
            return Ok(Formulas::Recap);
        }
        let concepts = elements(field, "[\"view\", \"w\"], or \"recap\"")?;
        Ok(Formulas::About(
            concepts.iter().map(|one| concept(one, objects)).collect::<Result<_, _>>()?,
        ))
    })?;
    say(section, "highlight", &mut view.highlighted, |field| highlighted(field, objects))?;
    say(section, "mistake", &mut view.mistake, |field| {
        choice(field, Mistake::GALLERY.iter().map(|one| (one.id(), *one)))
    })?;
    say(section, "t", &mut view.t, TomlField::number)?;
    // The camera may have changed, so the previous step's animation is not inherited.
    view.play = None;
    say(section, "play", &mut view.play, |field| {
        choice(field, Kind::ALL.map(|one| (one.name(), one)))
    })?;
    say(section, "lines", &mut view.lines, |field| lines(&field.section()?))?;
    view.exercise = exercise(section)?.or(view.exercise);
    Ok(())
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

/// Reads a name and returns the value that `known` lists with it.
fn choice<T>(
    field: &TomlField,
    known: impl IntoIterator<Item = (&'static str, T)>,
) -> Result<T, FileError> {
    let (names, mut values): (Vec<&str>, Vec<T>) = known.into_iter().unzip();
    let name = field.one_of(&names)?;
    let index = names.iter().position(|known| *known == name);
    index.map(|k| values.swap_remove(k)).ok_or_else(|| field.error("it has no such value"))
}

fn items(field: &TomlField) -> Result<OverlayItems, FileError> {
    let elements = elements(field, "[\"eye\", \"basis\", \"ray\"]")?;
    elements.iter().try_fold(OverlayItems::NONE, |shown, element| {
        // Both areas had one name once.
        let areas: &[Item] = &[Item::UpCrossW, Item::WCrossU];
        let items = Item::ALL.iter().map(|item| (item.name(), std::slice::from_ref(item)));
        let chosen = choice(element, items.chain([("areas", areas)]))?;
        Ok(chosen.iter().fold(shown, |shown, item| shown.with(*item, true)))
    })
}

fn elements<'a>(field: &TomlField<'a>, such_as: &str) -> Result<Vec<TomlField<'a>>, FileError> {
    field.elements().ok_or_else(|| field.error(&format!("it must be a list, such as {such_as}")))
}

fn derivation(field: &TomlField) -> Result<DerivationSections, FileError> {
    let known = DerivationSection::ALL.map(|section| (section.name(), section));
    let mut shown = DerivationSections([false; 3]);
    for element in elements(field, "[\"basis\"]")? {
        shown.set(choice(&element, known)?, true);
    }
    Ok(shown)
}

/// Returns true if the concept exists in a scene with `objects` objects.
pub(super) fn is_in_scene(concept: Option<Concept>, objects: usize) -> bool {
    match concept {
        Some(
            Concept::Object(object)
            | Concept::Root { object, .. }
            | Concept::Equation { object, .. },
        ) => (object as usize) < objects,
        _ => true,
    }
}

/// Reads the name of a concept in a scene with `objects` objects, or the word `nothing` for no concept.
fn highlighted(field: &TomlField, objects: usize) -> Result<Option<Concept>, FileError> {
    match field.text() {
        Ok(NOTHING) => Ok(None),
        _ => concept(field, objects).map(Some),
    }
}

/// Reads the name of a concept in a scene with `objects` objects.
fn concept(field: &TomlField, objects: usize) -> Result<Concept, FileError> {
    let numbered = field.text().ok().filter(|name| name.contains(' ')).and_then(Concept::from_name);
    match numbered {
        Some(concept) if is_in_scene(numbered, objects) => return Ok(concept),
        Some(_) if objects == 0 => return Err(field.error("the scene has no objects")),
        Some(_) => {
            let right = format!("the scene's objects are 0 to {}", objects - 1);
            return Err(field.error(&right));
        }
        None => {}
    }
    let numbered = [
        "object 0",
        "root 0 1",
        "substitution 0",
        "coefficients 0",
        "solution 0",
        "discriminant 0",
    ];
    let known: Vec<&str> = [NOTHING].into_iter().chain(Concept::names()).chain(numbered).collect();
    Concept::from_name(field.one_of(&known)?).ok_or_else(|| field.error("it must be a concept"))
}

/// The name that stands for no highlighted concept.
pub(super) const NOTHING: &str = "nothing";

/// Reads the lines lab's two lines, or one of them; then only that one is drawn.
fn lines(section: &Section) -> Result<LinesLab, FileError> {
    section.only(&["implicit", "p", "d", "t", "trail"], &[])?;
    let pair = |field: &TomlField| -> Result<DVec2, FileError> {
        Ok(DVec2::from_array(field.numbers("two numbers, such as [1.0, 1.0]")?))
    };
    let (implicit, example) = (section.get("implicit"), LinesLab::default());
    let has_ray = ["p", "d"].into_iter().any(|key| section.get(key).is_some());
    let line = if implicit.is_some() || !has_ray {
        let field = section.need("implicit", "implicit = [1.0, 1.0, -2.0] (a, b and c)")?;
        let [a, b, c] = field.numbers("a, b and c, such as [1.0, 1.0, -2.0]")?;
        let line = ImplicitLine { a, b, c };
        line.check().map_err(|error| field.fault(error))?;
        line
    } else {
        example.line()
    };
    let ray = if has_ray {
        let p = pair(&section.need("p", "p = [0.0, 0.0]")?)?;
        let field = section.need("d", "d = [1.0, 1.0]")?;
        let ray = ParametricLine { p, d: pair(&field)? };
        ray.check().map_err(|error| field.fault(error))?;
        ray
    } else {
        example.ray
    };
    if let Some(field) =
        ["t", "trail"].into_iter().find_map(|key| section.get(key)).filter(|_| !has_ray)
    {
        return Err(field.error("it needs p and d beside it"));
    }
    let t = section.get("t").map_or(Ok(0.0), |field| field.number())?;
    let mut lab = LinesLab::new(line, ray, t);
    if !has_ray {
        lab.shown = ShownLines::Implicit;
    } else if implicit.is_none() {
        lab.shown = ShownLines::Parametric;
    }
    if let Some(trail) = section.get("trail") {
        let [first, last] = pair(&trail)?.to_array();
        if first > last {
            return Err(trail.error("its first t must not be above its last, as in [-1.0, 3.0]"));
        }
        lab.trail = Trail { step: 1.0, first, last };
    }
    Ok(lab)
}
