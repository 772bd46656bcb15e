//! Hints to an exercise: the lines of the derivation that lead to what is not right yet, one after the other.

use pinhole_figure::{Concept, EquationStep};
use pinhole_lecture::exercises::{Asked, Given};

use crate::features::exercises::state::{Exercises, Feedback};

/// The hints that were given.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hint {
    /// The parts of the question that were not right when the first of them was given.
    left: Vec<Asked>,
    /// How many lines are shown, without their results.
    pub(crate) count: usize,
    /// True if no answer was checked since.
    pub(crate) is_new: bool,
}

impl Exercises {
    fn left(&self) -> Vec<Asked> {
        let all = self.question().parts.iter().zip(&self.answers);
        let left = all.filter(|(_, own)| !own.feedback.as_ref().is_some_and(Feedback::is_good));
        left.map(|(part, _)| part.asked).collect()
    }

    /// Returns true if this part of the question is asked for and not right yet.
    pub(crate) fn is_left(&self, asked: Asked) -> bool {
        self.left().contains(&asked)
    }

    /// Returns true if no answer was checked since the last hint.
    pub(crate) fn has_new_hint(&self) -> bool {
        self.hints() > 0 && self.hint.as_ref().is_some_and(|hint| hint.is_new)
    }

    /// Gives the next hint of `lines`. What follows the last one is the solution.
    pub(crate) fn give_hint(&mut self, lines: usize) {
        let left = self.left();
        let last = self.hint.take().filter(|hint| hint.left == left);
        let count = last.map_or(0, |hint| hint.count) + 1;
        if count > lines {
            self.toggle_solution();
        }
        self.hint = Some(Hint { left, count: count.min(lines), is_new: true });
    }

    /// Returns the number of given hints; 0 if another part of the question was answered since.
    pub(crate) fn hints(&self) -> usize {
        self.hint.as_ref().filter(|hint| hint.left == self.left()).map_or(0, |hint| hint.count)
    }

    /// Returns the concepts of the lines of the derivation that lead to the answers, each with whether its part
    /// of the question is not right yet.
    pub(crate) fn concepts(&self) -> Vec<(bool, Concept)> {
        use Concept::{Direction, Normal, Pixel, Ray, U, UpCrossW, V, View, W, WCrossU};
        let (question, left) = (self.question(), self.left());
        let is_sphere = question.sphere().is_some();
        let root = Concept::Root { object: 0, number: 0 };
        let equation = |step| Concept::Equation { object: 0, step };
        let discriminant = equation(EquationStep::Discriminant);
        let has_t = question.parts.iter().any(|part| part.asked == Asked::T);
        let is_view_asked = matches!(question.given, Given::EyeAtUp { .. });
        let of_part = |asked| match asked {
            Asked::W if is_view_asked => vec![View, W],
            Asked::W => vec![W],
            Asked::U => vec![UpCrossW, U],
            Asked::V => vec![V, WCrossU],
            Asked::Origin => vec![Ray],
            Asked::Direction => vec![Direction],
            Asked::T if is_sphere => vec![discriminant, root],
            Asked::Point if !has_t => vec![Ray, Ray],
            Asked::T => vec![equation(EquationStep::Coordinate), root],
            Asked::Point => vec![root],
            Asked::Normal => vec![Normal],
            Asked::Hits => Vec::new(),
            // The pixel, u and v.
            Asked::Uv => vec![Pixel; 3],
            Asked::A | Asked::B | Asked::C => vec![equation(EquationStep::Coefficients)],
            Asked::Discriminant => vec![discriminant],
        };
        let parts = question.parts.iter().map(|part| part.asked);
        let all = parts.flat_map(|asked| of_part(asked).into_iter().map(move |of| (asked, of)));
        all.map(|(asked, concept)| (left.contains(&asked), concept)).collect()
    }
}
