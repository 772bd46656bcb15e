//! Grades a student's answers by comparing them with the exact ones, and finds the mistakes that
//! explain the wrong ones.
//!
//! [`grade`] takes the output of a student's ray tracer for a scene ([`Answers`]: a basis, rays, hits,
//! or a whole picture). It decides for each answer whether it is right, and looks for the smallest set
//! of classic mistakes ([`Mistake`](crate::mistakes::Mistake)) with which a program gives *all* of the
//! answers. It tries each mistake alone, in all of its variants, and then the mistakes of
//! [`Mistake::GRADED`](crate::mistakes::Mistake::GRADED) in pairs.
//!
//! # What is right
//!
//! Answers are rounded, and each program rounds in its own way. An answer is right if it is within the
//! tolerance, which is [`RELATIVE_TOLERANCE`] by default:
//!
//! - a vector of the basis: each coordinate, relative to the vector's length;
//! - a ray: its direction *up to a positive factor*, as each coordinate of the unit vector; its
//!   origin, relative to the eye's distance from the world's origin or, if that is larger, to the
//!   viewport's distance;
//! - a hit: it must be the exact hit for objects that are larger or smaller by at most the tolerance
//!   times their distance from the eye. For a head-on hit, this is the tolerance relative to t. If a
//!   ray grazes an object, the error of t may be larger; at the very edge of a sphere, a hit, a miss,
//!   and the object behind are all right. The rounding errors of the textbook's formulas in `f64` are
//!   also allowed, so that no right program is called wrong, even at large distances;
//! - a pixel of a picture: each channel within [`LEVELS_TOLERANCE`] levels (steps of an 8-bit channel)
//!   of the picture in the shading that fits best; at an edge, the colours of both sides are right.
//!
//! Where a wrong answer would pass as well, because all that is allowed outgrows a pixel, nothing is right:
//! the answer is [not judged](Grade::not_judged).
//!
//! Numbers written with fewer digits are allowed an additional error of half a unit in their last digit
//! ([`Written::rounding`]). With a tolerance below the default, this allowance shrinks in proportion,
//! because a stricter tolerance requires more digits.

mod answers;
mod certainty;
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
pub use self::grade::{AnswerValue, Grade, LEVELS_TOLERANCE, RELATIVE_TOLERANCE, Truth, Worst};
pub use self::graded::{Cell, Graded};
use self::grader::Grader;

/// Grades answers. `tolerance` is the maximum relative error or, for a picture, the maximum error in
/// levels (steps of an 8-bit channel). If it is `None`, the default for the kind of answers is used.
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
/// Returns the reason, as a sentence, if the camera is invalid, if there is no answer, or if the
/// tolerance is negative or NaN. Also returns a reason if a picture does not have as many pixels as the
/// camera's image, or if the t of a true hit is too large or too small to have all digits of an `f64`.
pub fn grade(truth: &Truth, answers: &Answers, tolerance: Option<f64>) -> Result<Grade, String> {
    Ok(Grader::new(truth, answers, tolerance)?.grade())
}
