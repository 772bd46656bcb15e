//! A student's answers against the truth, and the mistakes that explain what is wrong with them.
//!
//! [`grade`] takes what a student's ray tracer says of a scene ([`Answers`]: a basis, rays, hits,
//! or a whole picture), says of each answer whether it is right, and looks for the smallest set of
//! classic mistakes ([`Mistake`](crate::mistakes::Mistake)) with which a program gives *all* of
//! them: each mistake in each of the ways in which it is made, alone, then those of
//! [`Mistake::GRADED`](crate::mistakes::Mistake::GRADED) in pairs.
//!
//! # What is right
//!
//! Answers are rounded, and each program rounds in its own way. What is right within the tolerance
//! ([`RELATIVE_TOLERANCE`] unless another one is given) counts:
//!
//! - a basis's vector: each coordinate, as a share of the vector's length;
//! - a ray: its direction *up to a positive factor*, as each coordinate of the unit vector; its
//!   origin as a share of the eye's distance from the world's origin, or of the viewport's distance
//!   where that is larger;
//! - a hit: as the right one for objects that are larger or smaller by the tolerance times their
//!   distance from the eye. Head-on, that is the tolerance as a share of t. Where a ray grazes an
//!   object, t may be off by more, and at a sphere's very edge hit, miss, and what lies behind are
//!   all right. What rounding in `f64` does to the textbook's formulas is allowed in addition, so
//!   that no right program is called wrong, far out either;
//! - a picture's pixel: each channel within [`LEVELS_TOLERANCE`] of 255, compared with the shading
//!   that fits best; at an edge, the colours of both sides.
//!
//! Numbers that were written to fewer digits are given half a unit of their last digit in addition
//! ([`Written::rounding`]). With a tolerance below the usual one, less in proportion: who asks for
//! more digits wants them to be there.

mod answers;
mod diagnosis;
mod first_hits;
mod grade;
mod graded;
mod grader;
mod hits;
mod picture;

pub use self::answers::{
    AnswerKind, Answers, GivenHit, HitAnswer, RayAnswer, Written, WrittenVector,
};
pub use self::diagnosis::Diagnosis;
pub use self::grade::{
    Grade, GradeError, Hit, LEVELS_TOLERANCE, RELATIVE_TOLERANCE, Right, Truth, Worst,
};
pub use self::graded::{Cell, Graded};
use self::grader::Grader;

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
/// Returns an error if the camera sees nothing, there is no answer, a picture has not as many
/// pixels as the camera's image, or the tolerance is negative or no number.
pub fn grade(
    truth: &Truth,
    answers: &Answers,
    tolerance: Option<f64>,
) -> Result<Grade, GradeError> {
    Ok(Grader::new(truth, answers, tolerance)?.grade())
}
