//! Marks as a sequence of fills and strokes, both for painting pixels and for writing files.

use std::borrow::Cow;

use egui::Color32;
use tiny_skia::PathBuilder;

use crate::view::overlay::drawing::{Drawing, Mark, Shape};

/// Width of a mark's casing on each side, in points; and its greatest share of a line's width.
const HALO_WIDTH: f32 = 1.25;
const HALO_SHARE: f32 = 0.5;

/// Dash and gap of a hidden line, in points.
const DASH: [f32; 2] = [5.0, 4.5];

/// A shape to fill or to stroke, in the unit of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<'a> {
    /// The outline.
    pub outline: Outline<'a>,
    /// The colour.
    pub color: Color32,
    /// Fill or stroke.
    pub ink: Ink,
}

/// The outline of a path.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline<'a> {
    /// A chain of straight lines.
    Chain {
        /// The corners.
        points: Cow<'a, [[f32; 2]]>,
        /// True if the last corner is joined to the first.
        closed: bool,
    },
    /// A circle.
    Circle {
        /// The centre.
        center: [f32; 2],
        /// The radius.
        radius: f32,
    },
}

/// The way in which an outline is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// A fill.
    Fill,
    /// A stroke with round joins.
    Stroke {
        /// The pen's width.
        width: f32,
        /// True if the ends are round; otherwise they are cut off.
        round: bool,
        /// Dash and gap, if the stroke is dashed.
        dash: Option<[f32; 2]>,
    },
}

impl Outline<'_> {
    /// Returns the outline as the rasteriser and PDF take it; `None` if there is nothing of it.
    pub(crate) fn to_path(&self) -> Option<tiny_skia::Path> {
        let (points, closed) = match self {
            Outline::Circle { center: [x, y], radius } => {
                return PathBuilder::from_circle(*x, *y, *radius);
            }
            Outline::Chain { points, closed } => (points, *closed),
        };
        let mut path = PathBuilder::new();
        let (first, rest) = points.split_first()?;
        path.move_to(first[0], first[1]);
        for [x, y] in rest {
            path.line_to(*x, *y);
        }
        if closed {
            path.close();
        }
        path.finish()
    }
}

impl Path<'_> {
    /// Returns the path with every length multiplied, dashes and pens too.
    pub fn scaled(&self, scale: f32) -> Path<'static> {
        let outline = match &self.outline {
            Outline::Chain { points, closed } => Outline::Chain {
                points: points.iter().map(|point| point.map(|x| scale * x)).collect(),
                closed: *closed,
            },
            Outline::Circle { center, radius } => {
                Outline::Circle { center: center.map(|x| scale * x), radius: scale * radius }
            }
        };
        let ink = match self.ink {
            Ink::Fill => Ink::Fill,
            Ink::Stroke { width, round, dash } => Ink::Stroke {
                width: scale * width,
                round,
                dash: dash.map(|dash| dash.map(|length| scale * length)),
            },
        };
        Path { outline, color: self.color, ink }
    }
}

impl Drawing {
    /// Returns everything that is painted, in the order of painting.
    pub fn paths(&self) -> impl Iterator<Item = Path<'_>> {
        self.marks.iter().flat_map(|mark| {
            let (halo, own) = paths_of(mark, self.scale);
            halo.into_iter().chain([own])
        })
    }
}

/// Returns a mark's casing, if it has one, and its own path.
fn paths_of(mark: &Mark, scale: f32) -> (Option<Path<'_>>, Path<'_>) {
    let full = HALO_WIDTH * scale;
    let (width, casing) = match mark.shape {
        Shape::Line { width, .. } => (width, full.min(HALO_SHARE * width)),
        Shape::Polygon { .. } | Shape::Disc { .. } => (0.0, full),
    };
    let around = Ink::Stroke { width: width + 2.0 * casing, round: true, dash: None };
    let ink = match mark.shape {
        Shape::Line { .. } => {
            let dash = if mark.hidden { Some(DASH) } else { mark.pattern };
            let dash = dash.map(|dash| dash.map(|length| length * scale));
            Ink::Stroke { width, round: dash.is_none(), dash }
        }
        Shape::Polygon { .. } | Shape::Disc { .. } => Ink::Fill,
    };
    let path = |color, ink| Path { outline: outline_of(&mark.shape), color, ink };
    (mark.halo.map(|halo| path(halo, around)), path(mark.color, ink))
}

fn outline_of(shape: &Shape) -> Outline<'_> {
    let chain = |points, closed| Outline::Chain { points: Cow::Borrowed(points), closed };
    match shape {
        Shape::Line { points, .. } => {
            chain(points.as_slice(), points.len() > 2 && points.first() == points.last())
        }
        Shape::Polygon { points } => chain(points.as_slice(), true),
        Shape::Disc { center, radius } => Outline::Circle { center: *center, radius: *radius },
    }
}
