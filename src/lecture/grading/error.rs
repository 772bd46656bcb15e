//! Errors of answers that cannot be graded.

use std::fmt;

use pinhole_core::{CameraError, ImageSize, Pixel};

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
