//! Grades: which answers are right, how far off the worst one is, and what explains it.

use std::fmt;

use pinhole_core::{
    Camera, CameraError, DVec3, ImageSize, Pixel, Ray, Rgb, Scene, Shade, shortest,
};

use super::answers::AnswerKind;
use super::diagnosis::Diagnosis;

/// Largest error of a number, as a share, unless another tolerance is given: twice what a number of
/// six significant digits is off at most, which is what `%g` and C++ streams print; and 80 times
/// the spacing of `f32`, of which a ray tracer loses some tenfold. The smallest of the known
/// mistakes, half a pixel of 1000, is fifty times as large.
pub const RELATIVE_TOLERANCE: f64 = 1e-5;

/// Largest error of a picture's channels, in levels of 255, unless another tolerance is given: one
/// for truncation in place of rounding, one for light that is computed in other steps.
pub const LEVELS_TOLERANCE: f64 = 2.0;

/// The truth that answers are graded against.
#[derive(Clone, Copy)]
pub struct Truth<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// The scene that it looks at.
    pub scene: &'a Scene,
    /// Each object's own colour, for pictures.
    pub color_of: &'a (dyn Fn(u32) -> Rgb + Sync),
}

/// The grade of some answers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grade {
    /// The kind of answers.
    pub kind: AnswerKind,
    /// The tolerance: a share, or levels of 255 for a picture.
    pub tolerance: f64,
    /// The verdict on each answer, in their order.
    pub is_right: Vec<bool>,
    /// The answer that is farthest off; `None` where there is no answer.
    pub worst: Option<Worst>,
    /// The shading that a picture is taken to have.
    pub shade: Option<Shade>,
    /// The mistakes that explain the wrong ones.
    pub diagnosis: Diagnosis,
    /// The digits to which the answers are written, where these are fewer than
    /// [`Grade::digits_wanted`] and the answers are right as far as they go, but for the mistake
    /// that is named, if any.
    pub right_digits: Option<u32>,
    /// The one t that most answers have where a miss would be right, and that no hit has: it stands
    /// for a miss, and what is found is found with it taken as one.
    pub sentinel: Option<f64>,
    /// Pixels without an answer, where each of them counts as a wrong one.
    pub unanswered: usize,
}

/// The answer that is farthest off: a wrong one, where there is any.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Worst {
    /// The answer's index, counted from 0.
    pub index: usize,
    /// The error, in the terms of the tolerance. Infinite where a hit is taken for a miss, or for
    /// one of another object.
    pub error: f64,
    /// The right answer.
    pub right: Right,
}

/// The right answer.
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
    /// There is no such pixel.
    NoPixel,
}

/// A first hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The position on the ray, in units of the direction's length.
    pub t: f64,
    /// The position in the world.
    pub point: DVec3,
    /// The object's index.
    pub object: u32,
}

/// The verdict on one answer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Judged {
    pub(super) is_right: bool,
    pub(super) error: f64,
}

impl Grade {
    /// The count of answers that there are, or should be.
    pub fn answers(&self) -> usize {
        self.is_right.len() + self.unanswered
    }

    /// The count of right answers.
    pub fn agree(&self) -> usize {
        self.is_right.iter().filter(|is_right| **is_right).count()
    }

    /// Returns whether all are right.
    pub fn all_agree(&self) -> bool {
        self.agree() == self.answers()
    }

    /// The significant digits that an answer should have: six, or more for a stricter tolerance.
    pub fn digits_wanted(&self) -> u32 {
        digits_wanted(self.tolerance)
    }

    /// The advice: a sentence for each mistake; that there are too few digits, or that no known
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

    /// Remarks beside each mistake's own sentence: what else gives the same answers, how
    /// many of them were looked at, that their digits are too few.
    pub fn remarks(&self) -> Vec<String> {
        let Diagnosis { mistakes, of_every, .. } = &self.diagnosis;
        let is_named = !mistakes.is_empty();
        let other = self.diagnosis.other.filter(|_| is_named);
        let other = other.map(|other| format!("Another explanation: {}", other.advice()));
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

    /// Returns whether it is known what is wrong.
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

/// The fewest digits of which half a unit of the last one is within the tolerance.
pub(super) fn digits_wanted(tolerance: f64) -> u32 {
    let digits = (1.0 - tolerance.max(f64::EPSILON).log10() - 1e-9).ceil();
    digits.clamp(6.0, 17.0) as u32
}

/// Reason why answers cannot be graded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum GradeError {
    /// The camera sees nothing.
    Camera(CameraError),
    /// There is no answer.
    NoAnswer,
    /// A picture has so many pixels, and the camera's image is of another size.
    PictureSize {
        /// Pixels of the picture.
        pixels: usize,
        /// The camera's image.
        image: ImageSize,
    },
    /// The tolerance is no number of at least 0.
    Tolerance(f64),
    /// The true t of this pixel's hit is too large or too small for all digits of an `f64`, which answers
    /// are graded in.
    BeyondRange(Pixel),
}

impl fmt::Display for GradeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GradeError::Camera(error) => error.fmt(f),
            GradeError::NoAnswer => f.write_str("there is no answer to grade"),
            GradeError::PictureSize { pixels, image } => {
                let (w, h) = (image.width(), image.height());
                write!(f, "the picture has {pixels} pixels: it must have {w} x {h}, as the image")
            }
            GradeError::Tolerance(tolerance) => {
                write!(f, "the tolerance is {tolerance}: it must be a number of at least 0")
            }
            GradeError::BeyondRange(Pixel { row, column }) => write!(
                f,
                "the true t of row {row}, column {column} (counted from 0) is beyond the range of f64, \
                 in which answers are graded: scale width, height and distance of the viewport"
            ),
        }
    }
}

impl std::error::Error for GradeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            GradeError::Camera(error) => Some(error),
            _ => None,
        }
    }
}

impl From<CameraError> for GradeError {
    fn from(error: CameraError) -> GradeError {
        GradeError::Camera(error)
    }
}
