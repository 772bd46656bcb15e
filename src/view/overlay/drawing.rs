//! A drawing: marks and labels in dots, before they are painted. Tests, the window and exported figures all
//! read it. [`Drawing::paths`] returns the marks as a sequence of fills and strokes, used both for painting
//! pixels and for writing files.

use egui::Color32;
use pinhole_core::DVec2;
use tiny_skia::PathBuilder;

use crate::model::{Concept, Item};

/// A shape in dots from the top left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A polyline; it is closed if its last point equals its first.
    Line {
        /// The corners.
        points: Vec<[f32; 2]>,
        /// Width in dots.
        width: f32,
    },
    /// A filled polygon.
    Polygon {
        /// The corners.
        points: Vec<[f32; 2]>,
    },
    /// A filled disc.
    Disc {
        /// The centre.
        center: [f32; 2],
        /// Radius in dots.
        radius: f32,
    },
}

/// One stroke of the overlay.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The overlay item that it belongs to.
    pub item: Item,
    /// The concept that becomes hovered when the pointer is on this mark.
    pub concept: Option<Concept>,
    /// The shape and position.
    pub shape: Shape,
    /// The colour.
    pub color: Color32,
    /// The colour of a casing around the mark, which separates it from the lines that it crosses.
    pub halo: Option<Color32>,
    /// True if an object hides the mark, or if it belongs to the ghost; its line is then dashed.
    pub hidden: bool,
    /// Dash and gap, in points, for a line that its colour alone does not distinguish.
    pub pattern: Option<[f32; 2]>,
}

/// A text in the picture. The caller draws it, because only the caller has the fonts.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The overlay item that it belongs to.
    pub item: Item,
    /// The middle of the text, in dots.
    pub position: [f32; 2],
    /// The text.
    pub text: String,
    /// The colour.
    pub color: Color32,
    /// The colour of a soft edge around the letters.
    pub halo: Color32,
    /// Height of the font in points.
    pub size: f32,
    /// True for bold text: the name of a vector.
    pub bold: bool,
}

/// All marks of one picture, in the order of painting, and its labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Dots per point.
    pub scale: f32,
    /// The marks; later ones lie over earlier ones.
    pub marks: Vec<Mark>,
    /// The labels; none overlaps another.
    pub labels: Vec<Label>,
}

/// Returns the concept of the mark nearest to a position, at most `within` away; both are in dots. If several are equally
/// near, the topmost one wins.
pub fn concept_at<'a>(
    marks: impl IntoIterator<Item = &'a Mark>,
    position: [f32; 2],
    within: f32,
) -> Option<Concept> {
    let at = wide(position);
    let mut nearest = (f64::from(within), None);
    for mark in marks.into_iter().filter(|mark| mark.concept.is_some()) {
        let distance = mark.shape.distance(at);
        if distance <= nearest.0 {
            nearest = (distance, mark.concept);
        }
    }
    nearest.1
}

impl Shape {
    /// Creates a filled polygon.
    pub(super) fn polygon(corners: &[DVec2]) -> Shape {
        Shape::Polygon { points: corners.iter().copied().map(dot).collect() }
    }

    /// Creates a circle, drawn as a polyline of so many `sides`.
    pub(super) fn ring(center: DVec2, radius: f64, sides: u32, width: f32) -> Shape {
        let points = circle(sides).map(|point| dot(center + radius * point)).collect();
        Shape::Line { points, width }
    }

    /// Returns the distance from a point to the shape, in dots; 0 on the shape.
    fn distance(&self, at: DVec2) -> f64 {
        let to_chain = |points: &[[f32; 2]]| {
            let sides = points.windows(2).map(|pair| (wide(pair[0]), wide(pair[1])));
            sides.map(|(a, b)| distance_to_side(at, a, b)).fold(f64::INFINITY, f64::min)
        };
        match self {
            Shape::Line { points, width } => (to_chain(points) - 0.5 * f64::from(*width)).max(0.0),
            Shape::Polygon { points } => {
                let closed: Vec<_> = points.iter().chain(points.first()).copied().collect();
                let crossings = closed.windows(2).filter(|pair| {
                    let (a, b) = (wide(pair[0]), wide(pair[1]));
                    (a.y > at.y) != (b.y > at.y)
                        && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)
                });
                if crossings.count() % 2 == 1 { 0.0 } else { to_chain(&closed) }
            }
            Shape::Disc { center, radius } => {
                (wide(*center).distance(at) - f64::from(*radius)).max(0.0)
            }
        }
    }
}

fn distance_to_side(at: DVec2, a: DVec2, b: DVec2) -> f64 {
    let side = b - a;
    let share = ((at - a).dot(side) / side.length_squared()).clamp(0.0, 1.0);
    // A side of length 0 is a point.
    at.distance(if share.is_nan() { a } else { a + share * side })
}

impl Label {
    /// Returns half the width and half the height, in dots, of a box that holds the text in any font of usual
    /// width.
    pub fn half_extent(&self, scale: f32) -> [f32; 2] {
        let size = self.size * scale;
        [size * (0.3 * self.text.chars().count() as f32 + 0.15), 0.62 * size]
    }
}

/// Returns the points of a circle of radius 1 around the origin; the last point repeats the first.
pub(super) fn circle(sides: u32) -> impl Iterator<Item = DVec2> {
    let angle = move |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(sides);
    (0..=sides).map(move |k| DVec2::from_angle(angle(k)))
}

/// Converts a position from the rasteriser's type.
pub(super) fn wide([x, y]: [f32; 2]) -> DVec2 {
    DVec2::new(x.into(), y.into())
}

/// Converts a position in dots to the rasteriser's type.
pub(super) fn dot(at: DVec2) -> [f32; 2] {
    [at.x as f32, at.y as f32]
}

/// Width of a mark's casing on each side, in points, and its maximum as a share of the line's width.
const HALO_WIDTH: f32 = 1.25;
const HALO_SHARE: f32 = 0.5;

/// Dash and gap of a hidden line, in points.
const DASH: [f32; 2] = [5.0, 4.5];

/// A shape to fill or to stroke, in the units of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The outline.
    pub outline: PathOutline,
    /// The colour.
    pub color: Color32,
    /// Fill or stroke.
    pub ink: Ink,
}

/// The outline of a path.
#[derive(Clone, Debug, PartialEq)]
pub enum PathOutline {
    /// A polyline.
    Chain {
        /// The corners.
        points: Vec<[f32; 2]>,
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
        /// The width.
        width: f32,
        /// True if the ends are round; otherwise they are flat.
        round: bool,
        /// Dash and gap, if the stroke is dashed.
        dash: Option<[f32; 2]>,
    },
}

impl PathOutline {
    /// Returns the outline in tiny-skia's form, which PDF files use as well; `None` if the outline is empty.
    pub(crate) fn to_path(&self) -> Option<tiny_skia::Path> {
        let (points, closed) = match self {
            PathOutline::Circle { center: [x, y], radius } => {
                return PathBuilder::from_circle(*x, *y, *radius);
            }
            PathOutline::Chain { points, closed } => (points, *closed),
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

impl Drawing {
    /// Returns everything that is painted, in the order of painting.
    pub fn paths(&self) -> impl Iterator<Item = Path> {
        self.marks.iter().flat_map(|mark| {
            let (halo, path) = paths_of(mark, self.scale);
            halo.into_iter().chain([path])
        })
    }
}

/// Returns the path of a mark's casing, if it has one, and the path of the mark itself.
fn paths_of(mark: &Mark, scale: f32) -> (Option<Path>, Path) {
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

fn outline_of(shape: &Shape) -> PathOutline {
    match shape {
        Shape::Line { points, .. } => {
            let closed = points.len() > 2 && points.first() == points.last();
            PathOutline::Chain { points: points.clone(), closed }
        }
        Shape::Polygon { points } => PathOutline::Chain { points: points.clone(), closed: true },
        Shape::Disc { center, radius } => PathOutline::Circle { center: *center, radius: *radius },
    }
}
