//! The ledger: how every number comes about, line by line in the lecture's order, each with its
//! symbols, the numbers put in, and the result.
//!
//! Pure: from the document, how it is looked at and what was derived of it to [`Section`]s of
//! [`Line`]s. All that is calculated here comes from [`pinhole_lecture`].

mod basis;
mod export;
mod names;
mod numbers;
mod objects;
mod ray;
mod sections;

#[cfg(test)]
mod tests;

use std::fmt;

use pinhole_core::{ExactRay, PosedCamera, Scene};
use pinhole_lecture::{ObjectDerivation, RayDerivation};

use self::numbers::Numbers;
use crate::derive::Fault;
use crate::document::Document;
use crate::formula::{Formula, word};
use crate::inspection::Inspection;
use crate::letters;
use crate::session::Selection;
use crate::thing::Thing;

pub use export::Markup;
pub use sections::{LedgerSection, LedgerSections};

/// Of so many objects, all are listed; of more, as many: those that the ray hits first.
pub const LISTED: usize = 6;

/// All that is shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ledger {
    /// From top to bottom.
    pub sections: Vec<Section>,
    /// How many objects are not listed.
    pub left_out: usize,
}

/// Lines under one title.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Which one.
    pub section: LedgerSection,
    /// Of the objects' sections, whose it is.
    pub object: Option<u32>,
    /// What stands above it.
    pub title: String,
    /// In the lecture's order.
    pub lines: Vec<Line>,
}

/// One step: symbols, the numbers put in, the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The formula.
    pub formula: Formula,
    /// What it is about.
    pub thing: Option<Thing>,
    /// What else lights it.
    pub also: &'static [Thing],
    /// What is said behind it; may be empty.
    pub note: String,
    /// The derivation fails here, and the note says why.
    pub is_fault: bool,
}

impl Line {
    fn of(thing: Thing, formula: Formula) -> Line {
        Line { formula, thing: Some(thing), also: &[], note: String::new(), is_fault: false }
    }

    fn also(self, also: &'static [Thing]) -> Line {
        Line { also, ..self }
    }

    fn noted(self, note: impl Into<String>) -> Line {
        Line { note: note.into(), ..self }
    }

    /// Whether it is lit with this thing.
    pub fn is_about(&self, thing: Thing) -> bool {
        self.thing == Some(thing) || self.also.contains(&thing)
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Line { formula, note, .. } = self;
        match note.is_empty() {
            true => formula.fmt(f),
            false => write!(f, "{formula}   ({})", letters::plain_scalars(note)),
        }
    }
}

impl fmt::Display for Ledger {
    /// As plain text, a line each.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, section) in self.sections.iter().enumerate() {
            writeln!(f, "{}{}", if k == 0 { "" } else { "\n" }, section.title)?;
            for line in &section.lines {
                writeln!(f, "  {line}")?;
            }
        }
        match self.left_out {
            0 => Ok(()),
            n => writeln!(f, "\n{}", left_out(n)),
        }
    }
}

/// What is said of objects that are not listed.
pub fn left_out(count: usize) -> String {
    match count {
        1 => "1 more object is not listed".to_owned(),
        n => format!("{} more objects are not listed", crate::number::grouped(n as u64)),
    }
}

/// What the ledger is made of.
#[derive(Clone, Copy, Debug)]
pub struct Sources<'a> {
    /// The document.
    pub document: &'a Document,
    /// The camera with its basis.
    pub posed: Option<&'a PosedCamera>,
    /// The scene, if every object is one.
    pub scene: Option<&'a Scene>,
    /// The selected ray.
    pub inspection: Option<&'a Inspection>,
    /// Why there is no new picture, if there is none.
    pub fault: Option<Fault>,
    /// Which ray is selected.
    pub selection: Selection,
    /// Which sections there are.
    pub sections: LedgerSections,
    /// Significant digits.
    pub digits: usize,
    /// Rows and columns are counted from 1.
    pub from_one: bool,
}

/// Makes the ledger.
pub fn ledger(of: &Sources) -> Ledger {
    let numbers = Numbers { digits: of.digits, from_one: of.from_one };
    let mut ledger = Ledger::default();
    let mut add = |section: LedgerSection, lines: Vec<Line>| {
        let title = section.label().to_owned();
        ledger.sections.push(Section { section, object: None, title, lines });
    };
    if of.sections.shows(LedgerSection::Basis) {
        add(LedgerSection::Basis, basis::lines(&of.document.camera, numbers));
    }
    let exact = of.posed.and_then(|posed| exact_ray(posed, of.selection));
    let derived =
        exact.as_ref().and_then(|(_, derived)| Some((of.posed?, derived, of.inspection?)));
    if of.sections.shows(LedgerSection::PixelToRay) {
        let lines = match (derived, of.fault) {
            (Some((posed, derived, inspection)), _) => {
                ray::lines(posed, derived, inspection, numbers)
            }
            (None, Some(fault)) => vec![fault_line(&fault)],
            (None, None) => Vec::new(),
        };
        add(LedgerSection::PixelToRay, lines);
    }
    if of.sections.shows(LedgerSection::Objects) {
        match (exact, of.scene, of.inspection, of.fault) {
            (Some((exact, derived)), Some(scene), Some(inspection), _) => {
                add_objects(&mut ledger, of, (&exact, &derived), (scene, inspection), numbers);
            }
            (.., Some(fault @ Fault::Scene(_))) => {
                add(LedgerSection::Objects, vec![fault_line(&fault)]);
            }
            _ => {}
        }
    }
    ledger
}

/// The selected ray, and how it comes about.
fn exact_ray(posed: &PosedCamera, selection: Selection) -> Option<(ExactRay<'_>, RayDerivation)> {
    let selection = selection.inside(posed.image());
    let derived = match selection {
        Selection::Pixel(pixel) => RayDerivation::of_pixel(posed, pixel),
        Selection::Uv(uv) => RayDerivation::of_uv(posed, uv).ok()?,
    };
    Some((selection.exact_ray(posed).ok()?, derived))
}

fn fault_line(fault: &Fault) -> Line {
    Line {
        formula: word("no ray"),
        thing: None,
        also: &[],
        note: letters::told(fault),
        is_fault: true,
    }
}

fn add_objects(
    ledger: &mut Ledger,
    of: &Sources,
    (exact, derived): (&ExactRay, &RayDerivation),
    (scene, inspection): (&Scene, &Inspection),
    numbers: Numbers,
) {
    let listed = listed(scene, inspection);
    ledger.left_out = scene.len() - listed.len();
    for object in listed {
        let Some(shape) = scene.object(object) else { continue };
        let Ok(derivation) = ObjectDerivation::new(&shape, object, exact) else { continue };
        let lines = objects::lines(object, &derivation, derived.ray(), inspection, numbers);
        ledger.sections.push(Section {
            section: LedgerSection::Objects,
            object: Some(object),
            title: of.document.title_of(object as usize),
            lines,
        });
    }
}

/// All objects where they are few, else those that the ray hits first and then the first ones.
fn listed(scene: &Scene, inspection: &Inspection) -> Vec<u32> {
    let count = scene.len() as u32;
    if scene.len() <= LISTED {
        return (0..count).collect();
    }
    let ahead = inspection.roots.iter().filter(|root| root.t > 0.0);
    let mut listed: Vec<u32> = Vec::with_capacity(LISTED);
    for object in ahead.map(|root| root.object).chain(0..count) {
        if listed.len() == LISTED {
            break;
        }
        if !listed.contains(&object) {
            listed.push(object);
        }
    }
    listed
}
