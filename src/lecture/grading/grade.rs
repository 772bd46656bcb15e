//! The grade of a student's answers: which answers are right, how large the greatest error is, and
//! which mistakes explain the wrong ones.

use pinhole_core::{Camera, DVec3, Ray, Rgb, Scene, Shade, shortest};

use super::answers::AnswerKind;
use super::diagnosis::Diagnosis;
use super::graded::Cell;
use crate::numbers::grouped;

/// Default maximum relative error of a number in an answer. It is twice the maximum rounding error of a
/// number with six significant digits, which is what `%g` and C++ streams print. It is about 80 times
/// the relative spacing of `f32`, while the errors of a ray tracer in `f32` are about ten times that
/// spacing. The smallest error due to a known mistake, half a pixel of 1000, is fifty times as large.
pub const RELATIVE_TOLERANCE: f64 = 1e-5;

/// Default maximum error of each channel of a picture, in levels (steps of an 8-bit channel). One level
/// allows for truncation instead of rounding, and one for shading that is computed in a different
/// order.
pub const LEVELS_TOLERANCE: f64 = 2.0;

/// The camera and the scene for which answers are graded.
#[derive(Clone, Copy)]
pub struct Truth<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// The scene at which the camera looks.
    pub scene: &'a Scene,
    /// Returns an object's own colour, for pictures.
    pub color_of: &'a (dyn Fn(u32) -> Rgb + Sync),
}

/// The grade of a student's answers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grade {
    /// The kind of answers.
    pub kind: AnswerKind,
    /// The tolerance: a maximum relative error or, for a picture, a maximum error in levels (steps of
    /// an 8-bit channel).
    pub tolerance: f64,
    /// For each answer, in order, true if it is judged and right.
    pub is_right: Vec<bool>,
    /// The indices, in ascending order, of the answers that are accepted where a wrong answer would be,
    /// too. They are among [`Grade::answers`], but neither right nor wrong, and do not keep a grade from
    /// [passing](Grade::passes) if others are judged.
    pub not_judged: Vec<usize>,
    /// For each answer that names one of several objects that are hit at exactly the same t, two of them.
    pub ties: Vec<[u32; 2]>,
    /// The answer with the largest error; `None` if no answer is judged.
    pub worst: Option<Worst>,
    /// The shading that a graded picture is assumed to have; `None` for other kinds of answers.
    pub shade: Option<Shade>,
    /// The mistakes that explain the wrong answers.
    pub diagnosis: Diagnosis,
    /// The number of digits with which the answers are written, if it is below [`Grade::digits_wanted`]
    /// and the answers are right to these digits. If a mistake is named, they are what a program that
    /// makes this mistake gives, to these digits.
    pub right_digits: Option<u32>,
    /// A number, such as -1, that the student seems to write as t for a miss; `None` if there is none.
    /// The diagnosis then treats this t as a miss.
    pub sentinel: Option<f64>,
    /// The number of pixels without an answer, if these count as wrong; otherwise 0.
    pub unanswered: usize,
}

/// The answer with the largest error: of the wrong answers if there are any, otherwise of the right
/// ones.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Worst {
    /// The answer's index, counted from 0.
    pub index: usize,
    /// The error, relative or in levels, as the tolerance. It is infinite if one of the given and the
    /// right answer is a hit and the other is a miss, or if they hit different objects.
    pub error: f64,
    /// The right answer.
    pub right: AnswerValue,
}

/// The value of an answer, whether a student's or the right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnswerValue {
    /// A vector of the basis.
    Vector(DVec3),
    /// A ray.
    Ray(Ray),
    /// A first hit.
    Hit {
        /// The position on the ray, in multiples of the direction's length; `None` if it was not given.
        t: Option<f64>,
        /// The position in the world; `None` if it was not given.
        point: Option<DVec3>,
        /// The object's index; `None` if it was not given.
        object: Option<u32>,
    },
    /// A miss.
    Miss,
    /// A colour.
    Color(Rgb),
    /// The image has no such pixel.
    NoPixel,
}

/// A first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hit {
    /// The position on the ray, in multiples of the direction's length.
    pub(super) t: f64,
    /// The position in the world.
    pub(super) point: DVec3,
    /// The object's index.
    pub(super) object: u32,
}

impl From<Option<Hit>> for AnswerValue {
    fn from(hit: Option<Hit>) -> AnswerValue {
        hit.map_or(AnswerValue::Miss, |Hit { t, point, object }| AnswerValue::Hit {
            t: Some(t),
            point: Some(point),
            object: Some(object),
        })
    }
}

/// The verdict on one answer, with its error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Judged {
    pub(super) is_right: bool,
    pub(super) error: f64,
}

impl Grade {
    /// Returns the number of answers, including those that are missing but required.
    pub fn answers(&self) -> usize {
        self.is_right.len() + self.unanswered
    }

    /// Returns the number of right answers.
    pub fn agree(&self) -> usize {
        self.is_right.iter().filter(|is_right| **is_right).count()
    }

    /// Returns whether the answer with this index is right.
    pub(super) fn cell(&self, index: usize) -> Cell {
        match self.is_right[index] {
            true => Cell::Right,
            false if self.not_judged.binary_search(&index).is_ok() => Cell::NotJudged,
            false => Cell::Wrong,
        }
    }

    /// Returns the number of wrong answers among those that are given.
    pub fn wrong(&self) -> usize {
        self.is_right.len() - self.agree() - self.not_judged.len()
    }

    /// Returns the number of answers that are not judged as text, such as `, 3 not judged`; empty if there
    /// are none.
    pub fn not_judged_in_words(&self) -> String {
        match self.not_judged.len() {
            0 => String::new(),
            count => format!(", {} not judged", grouped(count as u64)),
        }
    }

    /// Returns true if not all answers are [`Grade::not_judged`].
    pub fn is_judged(&self) -> bool {
        self.not_judged.len() < self.answers()
    }

    /// Returns true if all answers that can be judged are right, and none is missing.
    pub fn passes(&self) -> bool {
        self.is_judged() && self.wrong() + self.unanswered == 0
    }

    /// Returns true if all answers are right.
    pub fn all_agree(&self) -> bool {
        self.agree() == self.answers()
    }

    /// Returns the number of significant digits that an answer should have: six, or more for a stricter
    /// tolerance.
    pub fn digits_wanted(&self) -> u32 {
        digits_wanted(self.tolerance)
    }

    /// Returns the advice for the student: a sentence for each mistake that was found or, if none was,
    /// a sentence that says that all answers agree, that they have too few digits, or that no known
    /// mistake explains them.
    pub fn advice(&self) -> String {
        match (self.right_digits, &self.diagnosis.mistakes[..]) {
            _ if self.all_agree() => "All answers agree.".to_owned(),
            _ if !self.is_judged() => "No answer can be judged.".to_owned(),
            _ if self.passes() => "All answers that can be judged agree.".to_owned(),
            _ if self.wrong() == 0 => "All answers that are given agree.".to_owned(),
            (Some(digits), []) if self.sentinel.is_none() => {
                let (digits, wanted) = (counted(digits), self.digits_in_words());
                format!("The answers are right to {digits}; write at least {wanted}.")
            }
            (None, []) => match (self.diagnosis.other, self.sentinel) {
                (Some(other), _) => [other.advice().to_owned()].into_iter().chain(self.remarks()),
                (None, Some(_)) => return self.remarks().join(" "),
                (None, None) => return "No known mistake explains this.".to_owned(),
            }
            .collect::<Vec<_>>()
            .join(" "),
            (_, mistakes) => {
                let sentences = mistakes.iter().map(|mistake| mistake.advice().to_owned());
                sentences.chain(self.remarks()).collect::<Vec<_>>().join(" ")
            }
        }
    }

    /// Returns remarks in addition to the sentence for each mistake: other explanations of the same
    /// answers, the number of answers that were compared, or that there are too few digits.
    pub fn remarks(&self) -> Vec<String> {
        let Diagnosis { mistakes, of_every, .. } = &self.diagnosis;
        let is_named = !mistakes.is_empty();
        let other = self.diagnosis.other.filter(|_| is_named);
        let other = other.map(|other| format!("Another explanation: {}", other.advice()));
        let sampled = (*of_every > 1)
            .then(|| format!("One of {} answers was looked at.", grouped(*of_every as u64)));
        let is_in_addition = is_named || self.sentinel.is_some();
        let digits = self.right_digits.filter(|_| is_in_addition).map(|digits| {
            let (digits, wanted) = (counted(digits), self.digits_in_words());
            format!("They are written to {digits}: write at least {wanted}.")
        });
        let objects = self.diagnosis.objects_from_one.then(|| {
            "Objects are counted from 1, and they count from 0: spheres, then planes.".to_owned()
        });
        let sentinel = self.sentinel.map(|t| {
            let t = shortest(t);
            format!("t = {t} seems to stand for a miss: a miss leaves its cells empty, or is inf.")
        });
        [other, sampled, digits, objects, sentinel].into_iter().flatten().collect()
    }

    /// Returns true if the cause of the wrong answers has been found.
    pub(super) fn is_explained(&self) -> bool {
        let Diagnosis { mistakes, other, .. } = &self.diagnosis;
        !mistakes.is_empty() || other.is_some() || self.right_digits.is_some()
    }

    fn digits_in_words(&self) -> String {
        match self.digits_wanted() {
            6 => "six".to_owned(),
            wanted => wanted.to_string(),
        }
    }
}

/// Returns a number of digits as text: `1 digit`, `3 digits`.
fn counted(digits: u32) -> String {
    format!("{digits} digit{}", if digits == 1 { "" } else { "s" })
}

/// Returns the number of significant digits that an answer should have for this relative tolerance:
/// enough for half a unit in the last digit to be within it, but at least six and at most 17.
pub(super) fn digits_wanted(tolerance: f64) -> u32 {
    let digits = (1.0 - tolerance.max(f64::EPSILON).log10() - 1e-9).ceil();
    digits.clamp(6.0, 17.0) as u32
}
