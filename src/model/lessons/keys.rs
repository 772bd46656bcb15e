//! The keys of a step that set a part of what is shown: how each is read, written and applied.

use std::fmt::Debug;

use pinhole_core::{DVec2, Shade};
use pinhole_exchange::FileError;
use pinhole_exchange::fields::{Section, TomlField};
use pinhole_exchange::scene_file::{observer, observer_fields};
use pinhole_figure::{
    Concept, DerivationSection, DerivationSections, Formulas, Item, Observer, OverlayItems,
};
use pinhole_lecture::{ImplicitLine, Mistake, ParametricLine};

use super::lesson::Step;
use crate::features::lines::LinesLab;
use crate::features::lines::state::{ShownLines, Trail};
use crate::features::mistakes::MistakesView;
use crate::model::Shown;
use crate::model::session::{DIGITS, ViewLayout};

/// A key of a step that sets a part of what is shown.
pub(super) struct StepKey {
    /// The key in the file.
    pub(super) name: &'static str,
    /// Reads the field into the step.
    pub(super) read: fn(&TomlField, &mut Step) -> Result<(), FileError>,
    /// Returns the value with which a step shows what is shown; `None` if it leaves the key out.
    pub(super) write: fn(&Shown) -> Option<String>,
    /// Sets this part of the first to that of the second.
    pub(super) set: fn(&mut Shown, &Shown),
}

/// Reads a field in a scene with this number of objects.
type ReadValue<T> = fn(&TomlField, usize) -> Result<T, FileError>;

/// Expands to the list of keys, of each of which is given: its name, the part of [`Shown`], how it is read, and how
/// it is written.
macro_rules! keys {
    ($($name:literal $($part:ident).+: $read:expr, $write:expr;)+) => {
        &[$(StepKey {
            name: $name,
            read: |field, step| {
                let read: ReadValue<_> = $read;
                step.shown.$($part).+ = read(field, step.document.object_count())?;
                Ok(())
            },
            write: |shown| ($write)(&shown.$($part).+),
            set: |shown, step| shown.$($part).+.clone_from(&step.$($part).+),
        }),+]
    };
}

/// All keys, in the order in which they are written.
pub(super) const KEYS: &[StepKey] = keys! {
    "observer" observer: |field, _| Ok(Some(observer(field)?.into())), observer_text;
    "layout" setup.layout: |field, _| layout(field), |layout: &ViewLayout| written(&layout.name()?);
    "show" setup.items: |field, _| items(field),
        |items: &OverlayItems| list(Item::ALL, |item| items.shows(*item), Item::name);
    "derivation" sections: |field, _| derivation(field),
        |all: &DerivationSections| list(DerivationSection::ALL, |one| all.shows(*one), DerivationSection::name);
    "formulas" formulas: formulas, formulas_text;
    "highlight" highlighted: highlighted,
        |one: &Option<Concept>| written(&one.map_or(NOTHING.into(), Concept::name));
    "subject" subject: |field, objects| concepts(field, objects, "[\"up\", \"w\"]"),
        |all: &Vec<Concept>| list(all.first().map(|_| all.clone())?, |_| true, Concept::name);
    "shade" setup.shade: |field, _| choice(field, Shade::ALL.map(|one| (one.name(), one))),
        |shade: &Shade| written(&shade.name());
    "count_from_one" setup.count_from_one: |field, _| field.boolean(), written;
    "digits" setup.digits: |field, _| digits(field), written;
    "keep_picture" setup.keep_picture: |field, _| field.boolean(), written;
    "teaching" setup.teaching: |field, _| field.boolean(), written;
    "t" ray_point_t: |field, _| field.number().map(Some), |t: &Option<f64>| written(t.as_ref()?);
    "mistake" mistakes_view: |field, _| mistake(field), |view: &MistakesView| written(&view.chosen.id());
    "lines" lines: |field, _| lines(&field.section()?), |lab: &LinesLab| Some(lines_text(lab));
};

fn written(value: &impl Debug) -> Option<String> {
    Some(format!("{value:?}"))
}

fn list<T, N: Debug>(
    all: impl IntoIterator<Item = T>,
    is_in: impl Fn(&T) -> bool,
    name: fn(T) -> N,
) -> Option<String> {
    written(&Vec::from_iter(all.into_iter().filter(is_in).map(name)))
}

fn observer_text(seen_from: &Option<Observer>) -> Option<String> {
    Some(format!("{{ {} }}", observer_fields(&seen_from.as_ref()?.stored()).join(", ")))
}

fn formulas_text(formulas: &Option<Formulas>) -> Option<String> {
    match formulas.as_ref()? {
        Formulas::Recap => written(&RECAP),
        some => list(some.concepts().to_vec(), |_| true, Concept::name),
    }
}

fn layout(field: &TomlField) -> Result<ViewLayout, FileError> {
    choice(field, ViewLayout::LISTED.into_iter().filter_map(|one| Some((one.name()?, one))))
}

fn digits(field: &TomlField) -> Result<usize, FileError> {
    let range = DIGITS.0 as i64..=DIGITS.1 as i64;
    Ok(field.whole(range, "a number of significant digits")? as usize)
}

fn mistake(field: &TomlField) -> Result<MistakesView, FileError> {
    let chosen = choice(field, Mistake::GALLERY.iter().map(|one| (one.id(), *one)))?;
    Ok(MistakesView { chosen, ..MistakesView::default() })
}

/// Reads a name and returns the value that `known` lists with it.
pub(super) fn choice<T>(
    field: &TomlField,
    known: impl IntoIterator<Item = (&'static str, T)>,
) -> Result<T, FileError> {
    let (names, mut values): (Vec<&str>, Vec<T>) = known.into_iter().unzip();
    let name = field.one_of(&names)?;
    let index = names.iter().position(|known| *known == name);
    index.map(|k| values.swap_remove(k)).ok_or_else(|| field.error("it has no such value"))
}

pub(super) fn items(field: &TomlField) -> Result<OverlayItems, FileError> {
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

/// The value of `formulas` that stands for the recap.
const RECAP: &str = "recap";

fn formulas(field: &TomlField, objects: usize) -> Result<Option<Formulas>, FileError> {
    if field.text() == Ok(RECAP) {
        return Ok(Some(Formulas::Recap));
    }
    let about = concepts(field, objects, "[\"view\", \"w\"], or \"recap\"")?;
    Ok(Some(Formulas::About(about.into())))
}

/// Reads the names of concepts in a scene with `objects` objects.
fn concepts(field: &TomlField, objects: usize, such_as: &str) -> Result<Vec<Concept>, FileError> {
    elements(field, such_as)?.iter().map(|one| concept(one, objects)).collect()
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
const NOTHING: &str = "nothing";

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

/// Returns the two lines, or one of them, as [`lines`] reads them.
fn lines_text(lab: &LinesLab) -> String {
    let LinesLab { ray, t, trail, .. } = lab;
    let ImplicitLine { a, b, c } = lab.line();
    let implicit = format!("implicit = [{a:?}, {b:?}, {c:?}]");
    let [p, d] = [ray.p, ray.d].map(|pair| pair.to_array());
    let parametric = format!("p = {p:?}, d = {d:?}, t = {t:?}");
    let trail_text = format!(", trail = [{:?}, {:?}]", trail.first, trail.last);
    let trail = if trail.first < trail.last { trail_text } else { String::new() };
    match lab.shown {
        ShownLines::Both => format!("{{ {implicit}, {parametric}{trail} }}"),
        ShownLines::Implicit => format!("{{ {implicit} }}"),
        ShownLines::Parametric => format!("{{ {parametric}{trail} }}"),
    }
}
