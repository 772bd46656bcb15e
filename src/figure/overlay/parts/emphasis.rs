//! How strongly a part is drawn. A highlighted concept is drawn thicker and on top, even if its overlay item is
//! switched off, together with what it is made from. If the derivation or a lesson refers to the concept, everything
//! else is faded. If the pointer only hovers over it in a view, nothing is.

use egui::Color32;
use pinhole_core::Camera;
use pinhole_lecture::numbers::equated;

use super::{Form, Part, When};
use crate::concept::Concepts;
use crate::overlay::{Colors, DIMMED, Drawing, LABEL_DIGITS, LEGIBLE, Label, Request, VISIBLE};
use crate::{Concept, Item, OverlayItems};

/// The highlighted concept, and the inputs for drawing it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highlighted {
    /// The concept.
    pub concept: Concept,
    /// The edited camera as the user gives it.
    pub camera: Camera,
    /// Number of significant digits.
    pub digits: usize,
    /// True if everything else is faded.
    pub dims: bool,
    /// The concepts that are not faded, since the lines of the derivation have spoken of them.
    pub spoken: Concepts,
    /// True if the concept is one of several that a lesson's step names, of which none is more than the others.
    pub is_of_step: bool,
    /// The share of its growth that is over: below 1 while its arrows, lines and areas grow.
    pub growth: f64,
}

impl Highlighted {
    /// Returns true if another concept is drawn with the highlighted one because that is made from it. While lines are
    /// revealed, only the legs of a chain that they have spoken of are.
    fn is_made_from(&self, other: Concept) -> bool {
        match self.spoken == Concepts::default() {
            true => self.concept.made_from().contains(&other),
            false => {
                let is_told = !other.is_leg() || self.spoken.contains(other);
                is_told && self.concept.grows_from().contains(&other)
            }
        }
    }

    /// Returns true if a later line makes this concept from the highlighted one.
    fn leads_to(&self, other: Concept) -> bool {
        let is_of_line = self.spoken != Concepts::default() && !self.is_of_step;
        is_of_line && !self.spoken.contains(other) && other.grows_from().contains(&self.concept)
    }

    /// Returns true if what stands for this concept, or for none, is faded.
    pub(crate) fn fades(&self, concept: Option<Concept>) -> bool {
        self.dims && !concept.is_some_and(|concept| self.spoken.contains(concept))
    }

    /// Returns true if the objects of the scene are faded: if the lines of the derivation have spoken of none of them.
    pub(crate) fn fades_scenery(&self) -> bool {
        self.dims && self.spoken != Concepts::default() && !self.speaks_of_objects()
    }

    /// Returns true if the lines of the derivation have spoken of an object, or of a point on one.
    fn speaks_of_objects(&self) -> bool {
        let of_objects =
            [Concept::Object(0), Concept::Root { object: 0, number: 0 }, Concept::Normal];
        of_objects.into_iter().any(|concept| self.spoken.contains(concept))
    }

    /// Formats a number for a label as the right side of an equation: `= 0.5`, `≈ 0.3333`.
    pub(crate) fn equated(&self, x: f64) -> String {
        equated(x, self.digits.min(LABEL_DIGITS))
    }
}

/// Width of highlighted lines, in points.
pub(crate) const STRONG: f32 = 5.0;
/// Minimum width of the lines from which a highlighted one is made, in points.
pub(crate) const ACCOMPANYING: f32 = 3.0;
/// The share of its length with which an arrow begins to grow, unless it grows out of another one.
pub(crate) const BUD: f64 = 0.05;
/// Radius of highlighted points, in points.
const STRONG_POINT: f32 = 8.0;

/// How strongly a part is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Emphasis {
    /// Thick and on top, because its concept is highlighted.
    Strong,
    /// On top, because the highlighted concept is made from it.
    Accompanying,
    /// Without emphasis.
    Plain,
    /// Close to the background, because another concept is highlighted.
    Faded,
}

impl Part {
    /// Returns how strongly the part is drawn; `None` if it is not drawn.
    pub(super) fn emphasis(
        &self,
        items: OverlayItems,
        highlighted: Option<Highlighted>,
    ) -> Option<Emphasis> {
        let is_shown = items.shows(self.pen.item);
        let plain = (is_shown && self.when != When::Lit).then_some(Emphasis::Plain);
        let Some(lit) = highlighted else { return plain };
        let is_lit = self.pen.concept == Some(lit.concept);
        let accompanies = self.pen.concept.is_some_and(|own| lit.is_made_from(own));
        if self.pen.concept.is_some_and(|own| lit.leads_to(own)) {
            return None;
        }
        match self.when {
            When::Shown | When::Lit if is_lit && !lit.is_of_step => Some(Emphasis::Strong),
            When::Unlit if is_lit && !lit.is_of_step => None,
            When::Shown if is_lit => plain.map(|_| Emphasis::Accompanying),
            When::Shown | When::Lit if accompanies && !lit.is_of_step => {
                Some(Emphasis::Accompanying)
            }
            // What explains the step's subject stays.
            _ if lit.is_of_step && self.pen.item.is_of_one_topic() => plain,
            // The figure of ray and sphere explains what lines say of either.
            _ if self.pen.item == Item::SphereFigure && lit.speaks_of_objects() => plain,
            _ if lit.fades(self.pen.concept) => plain.map(|_| Emphasis::Faded),
            _ => plain,
        }
    }

    /// Draws the part as it is when this share of its growth is over: a line or an arrow grows from its start, a
    /// parallelogram along its second side.
    fn grow(&mut self, growth: f64) {
        let share = self.bud + (1.0 - self.bud) * growth;
        match (self.form, &mut self.places[..]) {
            (Form::Line | Form::Arrow(_), [start, rest @ ..]) => {
                rest.iter_mut().for_each(|place| *place = start.toward(place, share));
            }
            (Form::Area, [start, first, both, second]) => {
                *both = first.toward(both, share);
                *second = start.toward(second, share);
            }
            _ => {}
        }
    }

    /// Returns the part restyled by its emphasis. A highlighted one is drawn as far as it has grown.
    pub(super) fn emphasized(mut self, emphasis: Emphasis, growth: f64) -> Part {
        match emphasis {
            Emphasis::Strong => {
                if growth < 1.0 {
                    self.grow(growth);
                }
                self.pen = self.pen.on_top();
                self.pen.width = self.strong;
                if let Form::Point(radius) = &mut self.form {
                    *radius = STRONG_POINT;
                }
            }
            Emphasis::Accompanying => {
                self.pen = self.pen.on_top();
                self.pen.width = self.pen.width.max(ACCOMPANYING);
            }
            Emphasis::Plain | Emphasis::Faded => {}
        }
        self
    }
}

impl Emphasis {
    /// Returns true if the part is drawn on top, even if its overlay item is switched off.
    pub(crate) fn is_on_top(self) -> bool {
        matches!(self, Emphasis::Strong | Emphasis::Accompanying)
    }
}

impl Colors {
    /// Returns the colour of a mark that is faded.
    pub(crate) fn faded(&self, color: Color32) -> Color32 {
        match color.is_opaque() {
            true => self.dimmed(color, VISIBLE),
            false => color.gamma_multiply(DIMMED),
        }
    }

    /// Fades a label.
    pub(crate) fn fade(&self, label: &mut Label) {
        label.color = self.dimmed(label.color, LEGIBLE);
    }
}

/// Fades the marks and labels that stand for other concepts than the highlighted one, and removes its own.
pub(crate) fn dim(
    drawing: &mut Drawing,
    requests: &mut Vec<Request>,
    lit: Highlighted,
    colors: &Colors,
) {
    let concept = lit.concept;
    drawing.marks.retain(|mark| mark.concept != Some(concept));
    requests.retain(|request| request.concept != Some(concept));
    for mark in drawing.marks.iter_mut().filter(|mark| lit.fades(mark.concept)) {
        mark.color = colors.faded(mark.color);
    }
    for request in requests.iter_mut().filter(|request| lit.fades(request.concept)) {
        colors.fade(&mut request.label);
    }
}

/// Puts the labels of highlighted parts before the others, so that they get the best positions, and removes others
/// with the same text.
pub(crate) fn first(mut labels: Vec<Request>, mut others: Vec<Request>) -> Vec<Request> {
    labels.iter_mut().for_each(|request| request.rank = 0);
    others.retain(|other| labels.iter().all(|request| request.label.text != other.label.text));
    labels.into_iter().chain(others).collect()
}
