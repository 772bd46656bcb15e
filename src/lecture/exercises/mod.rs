//! The lecture's exercises, and similar ones with random numbers: the given numbers, the right answers,
//! the wrong answers to which classic mistakes lead, and the verdict on a student's answer.

mod judge;
mod pick;
mod question;
mod solve;
mod texts;

use pinhole_core::{Camera, DVec2, Pixel, Plane, Sphere};

use crate::mistakes::Mistake;

pub use judge::Verdict;
pub use question::{Answer, Asked, Exercise, Given, Question, QuestionPart};
pub use texts::{follows, question};

/// Maximum seed of a question or a vote, far below 2^53, up to which the seed's `f64` number field is
/// exact.
pub const LARGEST_SEED: u64 = 1_000_000_000;

/// Returns the next seed. The maximum is followed by 0.
pub fn next_seed(seed: u64) -> u64 {
    if seed < LARGEST_SEED { seed + 1 } else { 0 }
}

impl Question {
    /// Creates the lecture's own question or, if there is a seed, a similar one. The same seed gives
    /// the same question on every machine.
    pub fn new(exercise: Exercise, seed: Option<u64>) -> Question {
        let given = match seed {
            None => pick::lecture(exercise),
            Some(seed) => pick::seeded(exercise, seed),
        };
        // The chosen numbers always have a solution: every basis exists, and every sphere is hit.
        Question { exercise, given, parts: solve::parts(&given).unwrap_or_default() }
    }

    /// Judges the answers to all parts of the question, which are given in order, and returns a verdict
    /// on each. A part without an answer has `None` in place of an answer and of a verdict.
    pub fn judge(&self, answers: &[Option<Answer>]) -> Vec<Option<Verdict>> {
        judge::judge(&self.parts, answers)
    }

    /// Returns the quantity of the part whose verdict already names all mistakes that the verdict on part
    /// `k` names, so that they need not be named again: the part where they were
    /// [made](Asked::is_about_mistake) or, if several could be or none is, an earlier one. Returns `None`
    /// if there is no such part.
    pub fn source_of(&self, k: usize, verdicts: &[Option<Verdict>]) -> Option<Asked> {
        let Some(Verdict::Mistakes(mistakes)) = &verdicts[k] else { return None };
        let is_about = |j: usize, mistake: &Mistake| self.parts[j].asked.is_about_mistake(*mistake);
        let is_made_here = mistakes.iter().any(|mistake| is_about(k, mistake));
        let names_all = |j: &usize| match &verdicts[*j] {
            Some(Verdict::Mistakes(named)) => mistakes.iter().all(|made| named.contains(made)),
            _ => false,
        };
        let is_made = |j: &usize| mistakes.iter().all(|mistake| is_about(*j, mistake));
        let others = (0..self.parts.len()).filter(|j| *j < k || *j > k && !is_made_here);
        let source = others.filter(names_all).find(is_made);
        let source = source.or_else(|| (0..k).filter(|_| !is_made_here).find(names_all));
        source.map(|j| self.parts[j].asked)
    }

    /// Returns the camera that the question describes; `None` if it has none.
    pub fn camera(&self) -> Option<Camera> {
        solve::camera(&self.given)
    }

    /// Returns the point of the viewport through which the question's ray passes; `None` if there is
    /// none.
    pub fn uv(&self) -> Option<DVec2> {
        match self.given {
            Given::Uv(uv)
            | Given::UvAndWall { uv, .. }
            | Given::Distance { uv, .. }
            | Given::Turned { uv, .. }
            | Given::PointAt { uv, .. } => Some(uv),
            Given::Sphere { .. } | Given::Coefficients { .. } => Some(DVec2::ZERO),
            _ => None,
        }
    }

    /// Returns the pixel of the question, and whether the question counts rows and columns from 1;
    /// `None` if it has none.
    pub fn pixel(&self) -> Option<(Pixel, bool)> {
        match self.given {
            Given::Pixel { pixel, from_one, .. } => Some((pixel, from_one)),
            _ => None,
        }
    }

    /// Returns the sphere of the question; `None` if it has none.
    pub fn sphere(&self) -> Option<Sphere> {
        match self.given {
            Given::Sphere { sphere, .. } | Given::Coefficients { sphere, .. } => Some(sphere),
            _ => None,
        }
    }

    /// Returns the wall of the question; `None` if it has none.
    pub fn plane(&self) -> Option<Plane> {
        match self.given {
            Given::UvAndWall { z, .. } | Given::Distance { z, .. } | Given::Turned { z, .. } => {
                Some(solve::wall(z))
            }
            _ => None,
        }
    }
}
