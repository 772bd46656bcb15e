//! A student's answer and the right one, as the world view draws them beside each other.

use pinhole_core::{DVec3, Ray};

/// One of two answers to the same question, with its label.
#[derive(Clone, Debug, PartialEq)]
pub struct Twin {
    /// What is drawn.
    pub shape: TwinShape,
    /// The label beside it.
    pub label: String,
    /// True for a student's answer, which is dashed; the right one is not.
    pub is_dashed: bool,
}

/// The shape of an answer in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TwinShape {
    /// u, v or w (0, 1 or 2), as an arrow from the eye.
    BasisVector(usize, DVec3),
    /// A direction from a point, as an arrow of its own length.
    Direction(Ray),
    /// A ray up to this t; without one, up to what it hits.
    Ray(Ray, Option<f64>),
    /// The point of a ray at this t.
    OnRay(Ray, f64),
    /// A point that is hit.
    Point(DVec3),
    /// A normal at a point.
    Normal(DVec3, DVec3),
}

impl Twin {
    /// Returns a right answer.
    pub fn right(shape: TwinShape, label: impl Into<String>) -> Twin {
        Twin { shape, label: label.into(), is_dashed: false }
    }

    /// Returns a student's answer.
    pub fn yours(shape: TwinShape, label: impl Into<String>) -> Twin {
        Twin { shape, label: label.into(), is_dashed: true }
    }
}

/// Returns what is drawn in words, for screen readers: `drawn: u, your u (dashed)`.
pub fn spoken(twins: &[Twin]) -> String {
    let word = |twin: &Twin| match twin.is_dashed {
        true => format!("{} (dashed)", twin.label),
        false => twin.label.clone(),
    };
    match twins {
        [] => "no answer is drawn".to_owned(),
        _ => format!("drawn: {}", twins.iter().map(word).collect::<Vec<_>>().join(", ")),
    }
}
