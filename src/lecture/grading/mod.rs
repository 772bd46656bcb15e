//! A student's answers against the truth, and the mistakes that explain what is wrong with them.
//!
//! [`grade`] takes what a student's ray tracer says of a scene ([`Answers`]: a basis, rays, hits, or a
//! whole picture), says of each answer whether it is right, and looks for the smallest set of classic
//! mistakes ([`Mistake`](crate::mistakes::Mistake)) with which a program gives *all* of them: each mistake in each of the
//! ways in which it is made, alone, then in pairs.
//!
//! # What is right
//!
//! Answers are rounded, and each program rounds in its own way. What is right within the tolerance
//! ([`RELATIVE_TOLERANCE`] unless another one is given) counts:
//!
//! - a basis's vector: each coordinate, as a share of the vector's length;
//! - a ray: its direction *up to a positive factor*, as each coordinate of the unit vector; its origin
//!   as a share of the eye's distance from the world's origin, or of the viewport's distance where that
//!   is larger;
//! - a hit: as the right one for objects that are larger or smaller by the tolerance times their
//!   distance from the eye. Head-on, that is the tolerance as a share of t. Where a ray grazes an
//!   object, t may be off by more, and at a sphere's very edge hit, miss, and what lies behind are all
//!   right. What rounding in `f64` does to the textbook's formulas is allowed in addition, so that no
//!   right program is called wrong, far out either;
//! - a picture's pixel: each channel within [`LEVELS_TOLERANCE`] of 255, compared with the shading that
//!   fits best; at an edge, the colours of both sides.
//!
//! Numbers that were written to fewer digits are given half a unit of their last digit in addition
//! ([`Written::rounding`]). With a tolerance below the usual one, less in proportion: who asks for
//! more digits wants them to be there.

mod answers;
mod diagnosis;
mod digits;
mod error;
mod graded;
mod grader;
mod hits;
mod meetings;
mod picture;
mod vectors;

use pinhole_core::{Camera, DVec3, Ray, Rgb, Scene, Shade, shortest};

pub use self::answers::{Answers, GivenHit, HitAnswer, Kind, Measured, RayAnswer, Written};
pub use self::diagnosis::Diagnosis;
pub use self::error::GradeError;
pub use self::graded::{Cell, Graded};
use self::grader::Grader;

/// How far numbers may be off, as a share, unless another tolerance is given: twice what a number of
/// six significant digits is off at most, which is what `%g` and C++ streams print; and 80 times the
/// spacing of `f32`, of which a ray tracer loses some tenfold. The smallest of the known mistakes, half
/// a pixel of 1000, is fifty times as large.
pub const RELATIVE_TOLERANCE: f64 = 1e-5;

/// How far a picture's channels may be off, in levels of 255, unless another tolerance is given: one
/// for truncation in place of rounding, one for light that is computed in other steps.
pub const LEVELS_TOLERANCE: f64 = 2.0;

/// What answers are graded against.
#[derive(Clone, Copy)]
pub struct Truth<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// What it looks at.
    pub scene: &'a Scene,
    /// Each object's own colour, for pictures.
    pub color_of: &'a (dyn Fn(u32) -> Rgb + Sync),
}

/// How right answers are.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grade {
    /// What kind of answers they are.
    pub kind: Kind,
    /// Within which tolerance: a share, or levels of 255 for a picture.
    pub tolerance: f64,
    /// Whether each answer is right, in their order.
    pub is_right: Vec<bool>,
    /// The answer that is farthest off; `None` where there is no answer.
    pub worst: Option<Worst>,
    /// How a picture is taken to be shaded.
    pub shade: Option<Shade>,
    /// What explains the wrong ones.
    pub diagnosis: Diagnosis,
    /// To how many digits the answers are written, where these are fewer than [`Grade::digits_wanted`]
    /// and the answers are right as far as they go, but for the mistake that is named, if any.
    pub right_digits: Option<u32>,
    /// The one t that most answers have where a miss would be right, and that no hit has: it stands for
    /// a miss, and what is found is found with it taken as one.
    pub sentinel: Option<f64>,
    /// Pixels without an answer, where each of them counts as a wrong one:
    /// [`Grade::counting_unanswered`].
    pub unanswered: usize,
}

/// The answer that is farthest off: a wrong one, where there is any.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Worst {
    /// Which answer it is, counted from 0.
    pub index: usize,
    /// By how much, in the terms of the tolerance. Infinite where a hit is taken for a miss, or for
    /// one of another object.
    pub error: f64,
    /// What would be right.
    pub right: Right,
}

/// What would be right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Right {
    /// This vector of the basis.
    Vector(DVec3),
    /// This ray.
    Ray(Ray),
    /// This hit, or a miss.
    Hit(Option<Hit>),
    /// This colour.
    Color(Rgb),
    /// Nothing: there is no such pixel.
    NoPixel,
}

/// A first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Where on the ray, in units of the direction's length.
    pub t: f64,
    /// Where in the world.
    pub point: DVec3,
    /// Which object.
    pub object: u32,
}

/// What is found of one answer.
#[derive(Clone, Copy, Debug)]
struct Judged {
    is_right: bool,
    error: f64,
}

/// How much of what the written digits leave open is allowed.
#[derive(Clone, Copy, Debug)]
struct Digits(f64);

impl Digits {
    fn for_tolerance(tolerance: f64) -> Digits {
        Digits((tolerance / RELATIVE_TOLERANCE).min(1.0))
    }

    /// All of it.
    fn as_written() -> Digits {
        Digits(1.0)
    }

    fn of(self, rounding: f64) -> f64 {
        self.0 * rounding
    }
}

impl Grade {
    /// The grade with so many pixels counted as wrong answers, as they have none.
    pub fn counting_unanswered(self, unanswered: usize) -> Grade {
        Grade { unanswered, ..self }
    }

    /// How many answers there are, or should be.
    pub fn answers(&self) -> usize {
        self.is_right.len() + self.unanswered
    }

    /// How many of them are right.
    pub fn agree(&self) -> usize {
        self.is_right.iter().filter(|is_right| **is_right).count()
    }

    /// Whether all are.
    pub fn all_agree(&self) -> bool {
        self.agree() == self.answers()
    }

    /// How many significant digits an answer should have: six, or more for a stricter tolerance.
    pub fn digits_wanted(&self) -> u32 {
        digits_wanted(self.tolerance)
    }

    /// What to look at, a sentence for each mistake; that there are too few digits, or that no known
    /// mistake explains the answers; or that all of them agree.
    pub fn advice(&self) -> String {
        let all_given_agree = self.agree() == self.is_right.len();
        match (self.right_digits, &self.diagnosis.mistakes[..]) {
            _ if self.all_agree() => "All answers agree.".to_owned(),
            _ if all_given_agree => "All answers that are given agree.".to_owned(),
            (Some(digits), []) if self.sentinel.is_none() => {
                let wanted = self.digits_in_words();
                let plural = if digits == 1 { "" } else { "s" };
                format!("The answers are right to {digits} digit{plural}; write at least {wanted}.")
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

    /// What is to be said beside each mistake's own sentence: what else gives the same answers, how
    /// many of them were looked at, that their digits are too few.
    pub fn remarks(&self) -> Vec<String> {
        let Diagnosis { mistakes, of_every, .. } = &self.diagnosis;
        let is_named = !mistakes.is_empty();
        let other = self.diagnosis.other.filter(|_| is_named);
        let other = other.map(|other| format!("Or: {}", other.advice()));
        let sampled = (*of_every > 1).then(|| format!("One of {of_every} answers was looked at."));
        let is_beside = is_named || self.sentinel.is_some();
        let digits = self.right_digits.filter(|_| is_beside).map(|digits| {
            let wanted = self.digits_in_words();
            format!("They are written to {digits} digits: write at least {wanted}.")
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

    /// Whether it is known what is wrong.
    fn is_explained(&self) -> bool {
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

/// So many digits that half a unit of the last one is within the tolerance.
fn digits_wanted(tolerance: f64) -> u32 {
    let digits = (1.0 - tolerance.max(f64::EPSILON).log10() - 1e-9).ceil();
    digits.clamp(6.0, 17.0) as u32
}

/// Grades answers, within a tolerance: a share, or levels of 255 for a picture; the usual one of
/// their kind where none is given.
///
/// ```
/// use pinhole_lecture::grading::*;
/// use pinhole_lecture::mistakes::Mistake;
/// use pinhole_core::*;
/// let camera = Camera::CANONICAL;
/// let scene = Scene::new(vec![Sphere::new([0.0, 0.0, -5.0], 1.0)?], vec![])?;
/// let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [255; 3] };
/// // The lecture's line w = normalize(view): looking along -z, w is not (0, 0, 1).
/// let basis = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
/// let basis = Answers::Basis(basis.map(|v| Written::exactly(DVec3::from(v))));
/// let grade = grade(&truth, &basis, None)?;
/// assert_eq!((grade.answers(), grade.agree()), (3, 1));
/// assert_eq!(grade.diagnosis.mistakes, [Mistake::WAsPrinted]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Where the camera sees nothing, there is no answer, a picture has not as many pixels as the camera's
/// image, or the tolerance is negative or no number.
pub fn grade(
    truth: &Truth,
    answers: &Answers,
    tolerance: Option<f64>,
) -> Result<Grade, GradeError> {
    Ok(Grader::new(truth, answers, tolerance)?.grade())
}
