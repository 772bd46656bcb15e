//! The lecture's exercises, and similar ones with random numbers: the given numbers, the right answers,
//! the wrong answers to which classic mistakes lead, and the verdict on a student's answer.

mod judge;
mod pick;
mod question;
mod solve;
mod texts;

use pinhole_core::{Camera, DVec2, Plane, Sphere};

pub use judge::Verdict;
pub use question::{Answer, Asked, Exercise, Given, Question, QuestionPart};
pub use texts::{follows, question};

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

    /// Returns the quantity of the part from which the wrong answer to part `k` follows: the verdict on
    /// it names all mistakes that the verdict on part `k` names, and they are
    /// [about](Asked::is_about_mistake) that quantity. Returns `None` if there is no such part, or if
    /// any of the mistakes is about part `k` itself.
    pub fn source_of(&self, k: usize, verdicts: &[Option<Verdict>]) -> Option<Asked> {
        let Some(Verdict::Mistakes(mistakes)) = &verdicts[k] else { return None };
        if mistakes.iter().any(|mistake| self.parts[k].asked.is_about_mistake(*mistake)) {
            return None;
        }
        let explains = |asked: Asked, verdict: &Option<Verdict>| match verdict {
            Some(Verdict::Mistakes(named)) => mistakes
                .iter()
                .all(|mistake| asked.is_about_mistake(*mistake) && named.contains(mistake)),
            _ => false,
        };
        let mut parts = self.parts.iter().zip(verdicts);
        parts.find(|(part, verdict)| explains(part.asked, verdict)).map(|(part, _)| part.asked)
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
            | Given::Turned { uv, .. } => Some(uv),
            Given::Sphere { .. } => Some(DVec2::ZERO),
            _ => None,
        }
    }

    /// Returns the sphere of the question; `None` if it has none.
    pub fn sphere(&self) -> Option<Sphere> {
        match self.given {
            Given::Sphere { sphere, .. } => Some(sphere),
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
