//! The derivation of every number of the camera and of the selected ray, line by line in the lecture's
//! order. A line is an equation: the symbols, the numbers substituted for them, and the result. The
//! derivation can be exported as LaTeX, or as Markdown with `$formulas$`.
//!
//! This module is pure: it turns the document, the view settings and the derived values into
//! [`DerivedSection`]s of [`DerivedLine`]s. All arithmetic is in [`pinhole_lecture`].
//!
//! - `camera`: the lines of the basis and of the view ray;
//! - `objects`: the lines of the intersection with one object;
//! - `numbers`: formulas for numbers, vectors and the lecture's names.
//! - `sections`: the parts of the derivation that can be shown apart.

use std::fmt::{self, Write as _};

use pinhole_core::{ExactRay, Ray, ResolvedCamera, Scene, SceneError, Selection};
use pinhole_exchange::{Document, is_hidden};
use pinhole_lecture::numbers::grouped;
use pinhole_lecture::{ObjectDerivation, RayDerivation};

use crate::concept::{Concepts, Directed};
use crate::derivation::numbers::equation;
use crate::formula::{Formula, latex, norm, number, row, word};
use crate::{Concept, DerivationSection, DerivationSections, Fault, Inspection, symbols};

pub use numbers::NumberFormat;

mod camera;
mod numbers;
mod objects;
pub mod sections;

/// Maximum number of objects that the derivation lists. In a larger scene, these are the ones hit first.
pub const LISTED: usize = 6;

/// The whole derivation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derivation {
    /// The sections from top to bottom.
    pub sections: Vec<DerivedSection>,
    /// Number of objects that are not listed.
    pub left_out: usize,
}

/// The lines under one title.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedSection {
    /// The kind of section.
    pub section: DerivationSection,
    /// The index of the object that the section is about, if any.
    pub object: Option<u32>,
    /// The title above it.
    pub title: String,
    /// The lines in the lecture's order.
    pub lines: Vec<DerivedLine>,
}

/// One step: the symbols, the substituted numbers, and the result.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedLine {
    /// The formula.
    pub formula: Formula,
    /// The concept that the line is about, if any.
    pub concept: Option<Concept>,
    /// Other concepts for which the line is highlighted.
    pub also: &'static [Concept],
    /// What the line directs the figure to, if that is not its own concept.
    pub directs_to: Option<Concept>,
    /// The note after the formula; may be empty.
    pub note: String,
    /// True if the derivation fails here; the note then says why.
    pub is_fault: bool,
    /// True if the line only says what is given.
    pub is_given: bool,
}

impl DerivedLine {
    fn new(concept: impl Into<Option<Concept>>, formula: Formula) -> DerivedLine {
        DerivedLine {
            formula,
            concept: concept.into(),
            also: &[],
            directs_to: None,
            note: String::new(),
            is_fault: false,
            is_given: false,
        }
    }

    /// Creates a line of the derivation from the sides of an equation, such as `a = b = c`. The last side
    /// is the result.
    fn chain<const N: usize>(concept: Concept, sides: [Formula; N]) -> DerivedLine {
        let formula = sides.into_iter().reduce(equation).unwrap_or_else(|| row([]));
        DerivedLine::new(concept, formula)
    }

    fn also(self, also: &'static [Concept]) -> DerivedLine {
        DerivedLine { also, ..self }
    }

    fn given(self) -> DerivedLine {
        DerivedLine { is_given: true, ..self }
    }

    fn noted(self, note: impl Into<String>) -> DerivedLine {
        DerivedLine { note: note.into(), ..self }
    }

    /// Leaves out the numbers between the symbols and the result.
    fn abridged(self) -> DerivedLine {
        match <[Formula; 4]>::try_from(self.formula.sides()) {
            Ok([name, symbols, _, result]) => {
                DerivedLine { formula: equation(equation(name, symbols), result), ..self }
            }
            Err(_) => self,
        }
    }

    /// Leaves out the result. A vector of the basis that is given without symbols has its length instead.
    fn without_result(self) -> DerivedLine {
        let mut sides = self.formula.sides();
        let _ = sides.pop();
        let Some(name) = sides.first().cloned() else { return self };
        let is_of_basis = matches!(self.concept, Some(Concept::U | Concept::V | Concept::W));
        let formula = match sides.len() {
            1 if is_of_basis => equation(norm(name), number("1")),
            _ => sides.into_iter().reduce(equation).unwrap_or(name),
        };
        let note = if self.concept == Some(Concept::Ray) { "𝐩 = eye" } else { "" };
        DerivedLine { formula, note: note.to_owned(), ..self }
    }

    /// Returns true if the line is highlighted together with this concept.
    pub fn is_about(&self, concept: Concept) -> bool {
        let own = [self.concept, self.concept.map(Concept::in_views)];
        own.contains(&Some(concept)) || self.also.contains(&concept)
    }
}

impl fmt::Display for DerivedLine {
    /// Writes the formula and the note, separated by a semicolon, because a note may itself contain
    /// parentheses.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DerivedLine { formula, note, .. } = self;
        match note.is_empty() {
            true => formula.fmt(f),
            false => write!(f, "{formula}; {}", symbols::plain_scalars(note)),
        }
    }
}

impl Derivation {
    /// Keeps only the lines about these concepts, without numbers that are read beside them, as is why the
    /// derivation fails. If there are several objects, the first line about each names it.
    #[must_use]
    pub fn reduced_to(mut self, concepts: &[Concept]) -> Derivation {
        let are_objects =
            self.sections.iter().filter(|section| section.object.is_some()).count() > 1;
        let is_of_root = |line: &DerivedLine| matches!(line.concept, Some(Concept::Root { .. }));
        // The figure's label has the area.
        let is_area = |line: &DerivedLine| {
            line.concept == Some(Concept::UpCrossW)
                && matches!(line.formula.sides().first(), Some(Formula::Norm(_)))
        };
        let is_kept = |line: &DerivedLine| {
            line.concept.is_some_and(|of| concepts.contains(&of)) && !is_area(line)
        };
        // Of several objects, only t counts.
        let is_hit = |line: &DerivedLine| {
            let name = line.formula.sides().into_iter().next();
            is_of_root(line) && !matches!(name, Some(Formula::Scalar(_) | Formula::Index(..)))
        };
        for DerivedSection { lines, .. } in &mut self.sections {
            lines.retain(|line| is_kept(line) && !(are_objects && is_hit(line)));
            // The figure's labels have what a root is.
            lines.iter_mut().filter(|line| is_of_root(line)).for_each(|line| line.note.clear());
            // The lines of u and v have the pixel's numbers.
            let is_pixel = |line: &DerivedLine| line.concept == Some(Concept::Pixel);
            if lines.iter().any(|line| is_pixel(line) && !line.is_given) {
                lines.retain(|line| !(is_pixel(line) && line.is_given));
            }
        }
        self.sections.retain(|section| !section.lines.is_empty());
        for DerivedSection { object, title, lines, .. } in &mut self.sections {
            if are_objects && object.is_some() {
                let note = format!("{title}: {}", lines[0].note);
                lines[0].note = note.trim_end_matches(": ").to_owned();
            }
        }
        self.left_out = 0;
        self
    }

    /// Keeps as many of the first lines about each of these concepts as it is named times. Only the lines about
    /// objects keep their notes, and the numbers between symbols and result.
    #[must_use]
    pub fn solution(mut self, concepts: &[Concept]) -> Derivation {
        let mut left = concepts.to_vec();
        for section in &mut self.sections {
            let is_of_object = section.object.is_some();
            let lines = std::mem::take(&mut section.lines).into_iter().filter(|line| {
                let found = left.iter().position(|concept| line.concept == Some(*concept));
                found.map(|found| left.swap_remove(found)).is_some()
            });
            let shortened = |line: DerivedLine| match is_of_object {
                true if line.concept != Some(Concept::Normal) => line,
                _ => DerivedLine { note: String::new(), ..line.abridged() },
            };
            section.lines = lines.map(shortened).collect();
        }
        self.reduced_to(concepts)
    }

    /// Keeps, of a solution, the lines that lead to what is left, each concept with whether it is.
    #[must_use]
    pub fn left(mut self, mut concepts: Vec<(bool, Concept)>) -> Derivation {
        for section in &mut self.sections {
            section.lines.retain(|line| {
                let found = concepts.iter().position(|(_, of)| line.concept == Some(*of));
                let is_left = found.is_some_and(|found| concepts.remove(found).0);
                // The question gives the pixel.
                is_left && !(line.is_given && line.concept == Some(Concept::Pixel))
            });
        }
        self
    }

    /// Keeps only the first lines, without their results, which are for the reader to compute.
    #[must_use]
    pub fn hint(mut self, count: usize) -> Derivation {
        let mut left = count;
        for section in &mut self.sections {
            section.lines.truncate(left);
            left -= section.lines.len();
            let lines = std::mem::take(&mut section.lines).into_iter();
            section.lines = lines.map(DerivedLine::without_result).collect();
        }
        self
    }

    /// Keeps only the lines that compute view, w, u, v, d and the ray, each as its symbols and its result. If one
    /// of them cannot be computed, its line says why.
    #[must_use]
    pub fn recap(self) -> Derivation {
        use Concept::{Direction, Ray, U, V, View, W, WCrossU};
        let lines: Vec<DerivedLine> = self.sections.into_iter().flat_map(|s| s.lines).collect();
        // v is given by hand, or it is the product w x u.
        let recap = [[View; 2], [W; 2], [U; 2], [V, WCrossU], [Direction; 2], [Ray; 2]];
        let line_of = |concepts: [Concept; 2]| {
            let is_of = |line: &&DerivedLine| line.concept.is_some_and(|c| concepts.contains(&c));
            lines.iter().find(is_of).cloned().map(DerivedLine::abridged)
        };
        let lines = recap.into_iter().filter_map(line_of).collect();
        let (section, title) = (DerivationSection::Basis, "Recap".to_owned());
        let section = DerivedSection { section, object: None, title, lines };
        Derivation { sections: vec![section], left_out: 0 }
    }

    fn lines(&self) -> impl Iterator<Item = &DerivedLine> {
        self.sections.iter().flat_map(|section| &section.lines)
    }

    /// Returns the number of lines.
    pub fn line_count(&self) -> usize {
        self.sections.iter().map(|section| section.lines.len()).sum()
    }

    /// Returns true if lines make vectors out of others.
    pub fn makes_vectors(&self) -> bool {
        let mut lines = self.lines();
        lines.any(|line| line.concept.is_some_and(|concept| !concept.grows_from().is_empty()))
    }

    /// Returns the number of lines up to and including the last one about this concept. For a step towards a
    /// basis vector, such as up x w, the lines about that vector count. Returns the number of all lines if
    /// there is no concept or no such line.
    pub fn lines_through(&self, concept: Option<Concept>) -> usize {
        let concept = concept.map(|concept| match concept {
            Concept::View | Concept::Backwards => Concept::W,
            Concept::UpCrossW => Concept::U,
            Concept::WCrossU => Concept::V,
            other => other,
        });
        let lines = self.lines();
        let about = lines.enumerate().filter(|(_, line)| concept.is_some_and(|c| line.is_about(c)));
        about.last().map_or(self.line_count(), |(k, _)| k + 1)
    }

    /// Returns what the last of the first `count` lines that is about a concept directs to; `None` if none is.
    pub fn directed(&self, count: usize) -> Option<Directed> {
        let lines = self.lines().take(count);
        let directing = lines.filter_map(|line| Some((line, line.directs_to.or(line.concept)?)));
        directing.fold(None, |before: Option<Directed>, (line, concept)| {
            let spoken = before.map_or(Concepts::default(), |before| before.spoken);
            let object = line.concept.and_then(Concept::object);
            let object = object.or(before.and_then(|before| before.object));
            // An equation for t is that of the ray and an object.
            let ray =
                matches!(line.concept, Some(Concept::Equation { .. })).then_some(Concept::Ray);
            let about = [Some(concept), line.concept, ray].into_iter().flatten();
            let spoken = about.fold(spoken, Concepts::with);
            Some(Directed { concept, object, spoken, is_of_step: false })
        })
    }

    /// Returns the number of lines up to and including the first derived one after these, so that given
    /// numbers come together with what follows from them. Returns `all` if no derived line is among those.
    pub fn lines_after(&self, shown: usize, all: usize) -> usize {
        let lines = self.lines();
        let mut rest = lines.take(all).skip(shown);
        rest.position(|line| !line.is_given).map_or(all, |k| shown + k + 1)
    }
}

impl fmt::Display for Derivation {
    /// Writes plain text, one line for each step.
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

/// Returns the note about objects that are not listed.
pub fn left_out(count: usize) -> String {
    match count {
        1 => "1 more object is not listed".to_owned(),
        n => format!("{} more objects are not listed", grouped(n as u64)),
    }
}

/// The inputs of the derivation.
#[derive(Clone, Copy, Debug)]
pub struct DerivationInputs<'a> {
    /// The document.
    pub document: &'a Document,
    /// The camera with its basis; `None` if it has no basis.
    pub resolved: Option<&'a ResolvedCamera>,
    /// The scene, if all objects are valid.
    pub scene: Option<&'a Scene>,
    /// The selected ray and its hits; `None` if there is no ray.
    pub inspection: Option<&'a Inspection>,
    /// The selection, the sections, the number format, and the fault.
    pub settings: DerivationSettings,
}

/// The user's choices for the derivation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivationSettings {
    /// The selected pixel or position.
    pub selection: Selection,
    /// The sections to show.
    pub sections: DerivationSections,
    /// The format of numbers.
    pub numbers: NumberFormat,
    /// The reason why there is no picture of the current document; `None` if there is one.
    pub fault: Option<Fault>,
    /// The t whose point on the ray is computed; `None` if only the ray is.
    pub t: Option<f64>,
    /// True if the t of a plane is computed from one coordinate where its normal is along an axis.
    pub by_coordinate: bool,
}

/// Computes the derivation.
pub fn derivation(inputs: &DerivationInputs) -> Derivation {
    let DerivationSettings { selection, sections, numbers, fault, t, .. } = inputs.settings;
    let camera = &inputs.document.camera;
    let mut derivation = Derivation::default();
    let mut add = |section: DerivationSection, lines: Vec<DerivedLine>| {
        let title = section.label().to_owned();
        derivation.sections.push(DerivedSection { section, object: None, title, lines });
    };
    let mut fails = false;
    if sections.shows(DerivationSection::Basis) {
        let lines = camera::basis_lines(camera, numbers);
        fails = lines.iter().any(|line| line.is_fault);
        add(DerivationSection::Basis, lines);
    }
    let selected = inputs.resolved.zip(inputs.inspection).and_then(|(resolved, inspection)| {
        let (exact, derived) = exact_ray(resolved, selection)?;
        Some((resolved, inspection, exact, derived))
    });
    if sections.shows(DerivationSection::PixelToRay) {
        let lines = match &selected {
            Some((resolved, inspection, _, derived)) => {
                let lines = camera::ray_lines(camera, resolved, derived, inspection, numbers);
                let point = t.map(|t| camera::point_line(derived.ray, t, numbers));
                lines.into_iter().chain(point).collect()
            }
            None => {
                let selection = selection.inside(camera.image);
                let mut lines = camera::ray_givens(camera, selection, None, numbers);
                // The line of the basis that fails gives the reason.
                let without_reason = |line| DerivedLine { note: String::new(), ..line };
                let no_ray = fault.map(|fault| failed(None, word("no ray"), Some(fault)));
                lines.extend(if fails { no_ray.map(without_reason) } else { no_ray });
                lines
            }
        };
        add(DerivationSection::PixelToRay, lines);
    }
    if sections.shows(DerivationSection::Objects) {
        match (selected, inputs.scene) {
            (Some((_, inspection, exact, derived)), Some(scene)) => {
                let ray = (&exact, derived.ray);
                add_objects(&mut derivation, inputs, ray, (scene, inspection));
            }
            _ => add_given_objects(&mut derivation, inputs),
        }
    }
    derivation
}

/// Returns the selected ray and its derivation; `None` if there is no valid ray.
fn exact_ray(resolved: &ResolvedCamera, at: Selection) -> Option<(ExactRay<'_>, RayDerivation)> {
    let at = at.inside(resolved.image());
    let derived = RayDerivation::new(resolved, at).ok()?;
    Some((at.exact_ray(resolved).ok()?, derived))
}

/// Creates the line at which the derivation fails. Its note gives the reason.
fn failed(
    concept: impl Into<Option<Concept>>,
    formula: Formula,
    why: Option<impl fmt::Display>,
) -> DerivedLine {
    let why = why.map_or_else(String::new, symbols::typeset_message);
    DerivedLine { is_fault: true, ..DerivedLine::new(concept, formula).noted(why) }
}

/// Adds lines with the given numbers of the objects. After the numbers of a faulty object, adds the reason.
fn add_given_objects(derivation: &mut Derivation, inputs: &DerivationInputs) {
    let DerivationInputs { document, settings, .. } = *inputs;
    let faulty = match settings.fault {
        Some(Fault::Scene(SceneError { index, error, .. })) => Some((index as u32, error)),
        _ => None,
    };
    let count = document.object_count();
    let listed: Vec<u32> = match faulty {
        Some((index, _)) if count > LISTED => vec![index],
        _ => (0..count.min(LISTED) as u32).collect(),
    };
    derivation.left_out = count - listed.len();
    for object in listed {
        let mut lines = objects::givens(document, object, settings.numbers);
        if let Some((_, error)) = faulty.filter(|(index, _)| *index == object) {
            lines.push(failed(None, word("no picture"), Some(error)));
        }
        derivation.sections.push(object_section(document, object, lines));
    }
}

fn object_section(document: &Document, object: u32, lines: Vec<DerivedLine>) -> DerivedSection {
    let title = document.label_of(object as usize);
    DerivedSection { section: DerivationSection::Objects, object: Some(object), title, lines }
}

fn add_objects(
    derivation: &mut Derivation,
    inputs: &DerivationInputs,
    (exact, ray): (&ExactRay, Ray),
    (scene, inspection): (&Scene, &Inspection),
) {
    let listed = listed(scene, inspection);
    derivation.left_out = scene.len() - listed.len();
    for object in listed {
        let Some(shape) = scene.object(object) else { continue };
        let Ok(steps) = ObjectDerivation::new(&shape, object, exact) else { continue };
        let DerivationInputs { document, settings, .. } = *inputs;
        let how = (settings.numbers, settings.by_coordinate);
        let lines = objects::lines(document, object, &steps, ray, inspection, how);
        derivation.sections.push(object_section(document, object, lines));
    }
}

/// Returns the objects to list: all objects if there are at most [`LISTED`]; otherwise the objects that the
/// ray hits first, and then the first objects of the scene.
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

pinhole_core::texts! {
    /// A markup language for an exported derivation.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Markup[1];
    {
        /// Returns the language's name.
        label,
    }
    /// LaTeX with amsmath.
    Latex: "LaTeX";
    /// Markdown with `$formulas$`.
    Markdown: "Markdown";
}

impl Derivation {
    /// Writes the derivation for slides or notes.
    pub fn written_in(&self, markup: Markup) -> String {
        match markup {
            Markup::Latex => self.to_latex(),
            Markup::Markdown => self.to_markdown(),
        }
    }

    /// Writes LaTeX with amsmath: a heading and an `align*` environment for each section.
    fn to_latex(&self) -> String {
        let mut out = String::from("% needs \\usepackage{amsmath}\n");
        // Writing to a string cannot fail.
        for section in &self.sections {
            let _ = writeln!(out, "\\subsection*{{{}}}", latex::text(&section.title));
            if !section.lines.is_empty() {
                let lines = section.lines.iter();
                let lines = latex::aligned(lines.map(|line| (&line.formula, line.note.as_str())));
                let _ = writeln!(out, "\\begin{{align*}}\n{lines}\n\\end{{align*}}");
            }
        }
        if self.left_out > 0 {
            let _ = writeln!(out, "{}", latex::text(&left_out(self.left_out)));
        }
        out
    }

    /// Writes Markdown: a heading and a list for each section.
    fn to_markdown(&self) -> String {
        let mut out = String::new();
        for (k, section) in self.sections.iter().enumerate() {
            let before = if k == 0 { "" } else { "\n" };
            let _ = writeln!(out, "{before}### {}\n", markdown(&section.title));
            for line in &section.lines {
                let _ = write!(out, "- ${}$", latex::math(&line.formula));
                if !line.note.is_empty() {
                    let _ = write!(out, "; {}", markdown(&line.note));
                }
                out.push('\n');
            }
        }
        if self.left_out > 0 {
            let _ = writeln!(out, "\n{}", left_out(self.left_out));
        }
        out
    }
}

/// Escapes the characters that Markdown treats as markup.
fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if r"\`*_[]<>#$|~".contains(c) {
            out.push('\\');
        }
        if !is_hidden(c) {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests;
