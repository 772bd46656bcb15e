//! Answers to an exercise, a student's and the right ones, as marks in the world view.

use pinhole_core::{DVec3, Ray};

/// A student's answer or the right answer, as a labelled mark in the world view.
#[derive(Clone, Debug, PartialEq)]
pub struct AnswerMark {
    /// The shape that is drawn.
    pub shape: MarkShape,
    /// The label next to it.
    pub label: String,
    /// True for a student's answer, which is drawn dashed; false for the right answer.
    pub is_dashed: bool,
}

/// The shape of a mark in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MarkShape {
    /// A vector of the basis, drawn as an arrow from the eye. The index 0, 1 or 2 stands for u, v or w.
    BasisVector(usize, DVec3),
    /// A ray's direction, drawn from the ray's origin as an arrow of the direction's own length.
    Direction(Ray),
    /// A ray, drawn up to this t or, if it is `None`, up to the object that the ray hits.
    Ray(Ray, Option<f64>),
    /// The point of a ray at this t.
    OnRay(Ray, f64),
    /// A hit point.
    Point(DVec3),
    /// A point and the normal there.
    Normal(DVec3, DVec3),
}

impl AnswerMark {
    /// Creates the mark of a right answer.
    pub fn right(shape: MarkShape, label: impl Into<String>) -> AnswerMark {
        AnswerMark { shape, label: label.into(), is_dashed: false }
    }

    /// Creates the mark of a student's answer.
    pub fn yours(shape: MarkShape, label: impl Into<String>) -> AnswerMark {
        AnswerMark { shape, label: label.into(), is_dashed: true }
    }
}
