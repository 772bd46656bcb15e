//! A drawing: marks and labels with positions in screen pixels, before they are painted. The window,
//! exported figures and tests read it. [`Drawing::paths`] returns the marks as a sequence of fills and
//! strokes, for painting pixels as well as for writing files.

use egui::Color32;
use pinhole_core::{DVec2, Ellipse};
use pinhole_lecture::Rounding;
use tiny_skia::PathBuilder;

use crate::{Concept, Item};

/// A shape. Positions are in screen pixels from the top left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A polyline. It is closed if its last point equals its first.
    Line {
        /// The corners.
        points: Vec<[f32; 2]>,
        /// Width in screen pixels.
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
        /// Radius in screen pixels.
        radius: f32,
    },
}

/// One shape of the overlay, with its colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The overlay item to which the mark belongs.
    pub item: Item,
    /// The concept that becomes hovered when the pointer is on this mark.
    pub concept: Option<Concept>,
    /// The shape and position.
    pub shape: Shape,
    /// The colour.
    pub color: Color32,
    /// The colour of the casing, a wider outline below the mark that separates it from the lines that it
    /// crosses; `None` for a mark without a casing.
    pub halo: Option<Color32>,
    /// True if the mark is drawn dashed, because an object hides it or because it belongs to the ghost (the
    /// camera that is compared with the edited one).
    pub hidden: bool,
    /// Dash and gap, in points, of a visible line; set if the colour alone does not distinguish the line.
    pub pattern: Option<[f32; 2]>,
}

/// A text in the picture. The caller of the overlay draws it, since only the caller has the fonts.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The overlay item to which the label belongs.
    pub item: Item,
    /// The middle of the text, in screen pixels.
    pub position: [f32; 2],
    /// The text.
    pub text: String,
    /// The colour.
    pub color: Color32,
    /// The colour of the halo around the letters.
    pub halo: Color32,
    /// Height of the font in points.
    pub size: f32,
    /// True if the text is bold, as the names of vectors are.
    pub bold: bool,
}

/// All marks of a picture, in painting order, and its labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Screen pixels per point.
    pub scale: f32,
    /// The marks. Later ones are painted over earlier ones.
    pub marks: Vec<Mark>,
    /// The labels. They do not overlap.
    pub labels: Vec<Label>,
    /// In the world view of a figure, the outlines of the spheres that nothing covers or cuts.
    pub spheres: Vec<Ellipse>,
}

/// Returns the concept of the mark nearest to a position, or `None` if no such mark lies within the
/// distance `within`. Both arguments are in screen pixels. Of equally near marks, the topmost is chosen.
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

    /// Creates a circle as a closed polyline with `sides` sides.
    pub(super) fn ring(center: DVec2, radius: f64, sides: u32, width: f32) -> Shape {
        let points = circle(sides).map(|point| dot(center + radius * point)).collect();
        Shape::Line { points, width }
    }

    /// Returns the distance from a point to the shape, in screen pixels; 0 if the point lies on it.
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
    /// Returns half the width and half the height, in screen pixels, of a box that is large enough for the
    /// text in any font of ordinary width.
    pub fn half_extent(&self, scale: f32) -> [f32; 2] {
        half_extent(&self.text, f64::from(self.size * scale)).map(|half| half as f32)
    }
}

/// Characters that are at most half as wide as others, in any font of ordinary width.
const NARROW: &str = " |.,;:′'()[]iljtfr·/";

/// Returns half the width and half the height of a box that is large enough for a text of this size.
pub(super) fn half_extent(text: &str, size: f64) -> [f64; 2] {
    let width = |letter: char| if NARROW.contains(letter) { 0.36 } else { 0.62 };
    [size * (0.5 * text.chars().map(width).sum::<f64>() + 0.15), 0.62 * size]
}

/// Maximum number of significant digits of a number in a label. A longer label would cover what it names.
pub(super) const LABEL_DIGITS: usize = 4;

/// The rounding of a number in a label, as on the card while presenting.
const ROUNDING: Rounding = Rounding::Decimals(3);

/// Formats a number for a label as the right side of an equation: `= 0.5`, `≈ 0.333`.
pub(super) fn equals(x: f64) -> String {
    format!("{} {}", ROUNDING.relation(&[x]), ROUNDING.text(x).replace('-', "−"))
}

/// Returns the points of a unit circle around the origin. The last point repeats the first.
pub(super) fn circle(sides: u32) -> impl Iterator<Item = DVec2> {
    let angle = move |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(sides);
    (0..=sides).map(move |k| DVec2::from_angle(angle(k)))
}

/// Converts a position from the rasterizer's type.
pub(super) fn wide([x, y]: [f32; 2]) -> DVec2 {
    DVec2::new(x.into(), y.into())
}

/// Converts a position in screen pixels to the rasterizer's type.
pub(super) fn dot(at: DVec2) -> [f32; 2] {
    [at.x as f32, at.y as f32]
}

/// Width of a mark's casing on each side, in points.
const HALO_WIDTH: f32 = 1.25;
/// Maximum width of a line's casing on each side, as a fraction of the line's own width.
const HALO_SHARE: f32 = 0.5;

/// Dash and gap of a hidden mark's line, in points.
const DASH: [f32; 2] = [5.0, 4.5];

/// An outline to fill or to stroke, in the units of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The outline.
    pub outline: PathOutline,
    /// The colour.
    pub color: Color32,
    /// Whether the outline is filled or stroked.
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

/// How an outline is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// A fill.
    Fill,
    /// A stroke with round joins.
    Stroke {
        /// The width.
        width: f32,
        /// True if the ends of the stroke are round, false if they are flat.
        round: bool,
        /// Dash and gap; `None` if the stroke is solid.
        dash: Option<[f32; 2]>,
    },
}

impl PathOutline {
    /// Converts the outline to a tiny-skia path, a type from which PDF files are written, too. Returns
    /// `None` if the outline is empty.
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
    /// Returns everything that is painted, in painting order.
    pub fn paths(&self) -> impl Iterator<Item = Path> {
        self.marks.iter().flat_map(|mark| {
            let (halo, path) = paths_of(mark, self.scale);
            halo.into_iter().chain([path])
        })
    }
}

/// Returns the path of a mark's casing, or `None` if it has no casing, and the path of the mark itself.
fn paths_of(mark: &Mark, scale: f32) -> (Option<Path>, Path) {
    let full = HALO_WIDTH * scale;
    let (ink, around) = match mark.shape {
        Shape::Line { width, .. } => {
            let dash = if mark.hidden { Some(DASH) } else { mark.pattern };
            let dash = dash.map(|dash| dash.map(|length| length * scale));
            let ink = Ink::Stroke { width, round: dash.is_none(), dash };
            let around = width + 2.0 * full.min(HALO_SHARE * width);
            (ink, Ink::Stroke { width: around, round: dash.is_none(), dash })
        }
        Shape::Polygon { .. } | Shape::Disc { .. } => {
            (Ink::Fill, Ink::Stroke { width: 2.0 * full, round: true, dash: None })
        }
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
