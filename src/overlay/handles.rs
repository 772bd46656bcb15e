//! Handles over all else, always of one size on the screen: what is pointed at and what is held are
//! larger and have another middle, and show along what they go.

use pinhole_core::{DVec2, DVec3, ResolvedCamera};

use crate::overlay::camera_in_space::{ARROW_POINTS, NORMAL_POINTS, POINT_TEXT, VECTOR_TEXT};
use crate::overlay::drawing::{Mark, Shape, dot};
use crate::overlay::items::Item;
use crate::overlay::screen::Screen;
use crate::overlay::sketch::{Head, Pen, Sketch};

/// What there is to take in the hand, and how it is drawn while it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Handles {
    /// Later ones lie over earlier ones.
    pub marks: Vec<HandleMark>,
    /// Arrows that are there for their handles alone: the normals of planes.
    pub stems: Vec<[DVec3; 2]>,
    /// Along what the one that is pointed at goes.
    pub guides: Vec<Guide>,
    /// The length in the world of the basis arrows, where a hand holds one.
    pub arrow: Option<f64>,
    /// The length in the world of the arrow of up, where a hand holds its tip.
    pub up: Option<f64>,
}

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleMark {
    /// Where in the world.
    pub at: DVec3,
    /// Its form.
    pub knob: Knob,
    /// Whether it is pointed at or held.
    pub state: KnobState,
}

/// What a handle looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// It goes where it is dragged.
    Round,
    /// It stays on the viewport's plane.
    Square,
    /// It goes along one line.
    Diamond,
}

/// How a handle stands out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnobState {
    /// Small, with an empty middle.
    Plain,
    /// Large, with an empty middle.
    Over,
    /// Large and full, with a ring around it.
    Held,
}

/// Along what a handle goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guide {
    /// Along an axis.
    Line {
        /// One end.
        from: DVec3,
        /// The other: where the axis points.
        to: DVec3,
        /// 0 to 2: x, y, z; 3 to 5: u, v, w.
        axis: usize,
        /// It goes across the whole picture: its name stands in the middle.
        is_long: bool,
    },
    /// Round a point: `center + cos(angle) a + sin(angle) b`.
    Ring {
        /// The point.
        center: DVec3,
        /// From there to the ring.
        a: DVec3,
        /// Likewise, at right angles to it.
        b: DVec3,
    },
}

const AXES: [&str; 6] = ["x", "y", "z", "u", "v", "w"];

/// How large handles are from middle to edge, in points: plain ones, and others.
const PLAIN: f64 = 6.0;
const LARGE: f64 = 10.0;

/// From the edge to the empty middle, in points.
const RIM: f64 = 2.4;

/// The length in the world of what is so many points long at a place; 0 where it is not seen.
pub fn length_of_points(observer: &ResolvedCamera, at: DVec3, points: f64, scale: f32) -> f64 {
    of_points(observer, at, (points, points), scale)
}

/// The length in the world of the arrows at a camera's eye, as the world view draws them.
pub fn arrow_length(observer: &ResolvedCamera, eye: DVec3, scale: f32) -> f64 {
    of_points(observer, eye, ARROW_POINTS, scale)
}

/// The length in the world of a plane's normal at its point.
pub fn normal_length(observer: &ResolvedCamera, point: DVec3, scale: f32) -> f64 {
    length_of_points(observer, point, NORMAL_POINTS, scale)
}

fn of_points(observer: &ResolvedCamera, at: DVec3, (least, most): (f64, f64), scale: f32) -> f64 {
    let screen = Screen::new(observer, at.distance(observer.eye()));
    let Some(dots) = screen.dots_per_unit(at) else { return 0.0 };
    let points = dots / f64::from(scale);
    points.clamp(least, most) / points
}

impl Sketch<'_> {
    /// All of them, those that stand out last.
    pub(crate) fn handles(&mut self, handles: &Handles) {
        if !self.items.shows(Item::Handles) {
            return;
        }
        for [from, to] in &handles.stems {
            let pen = Pen::new(Item::Handles, self.colors.hit, 2.2).on_top();
            let tip = self.arrow(*from, *to, Head::Filled, pen);
            self.label_tip(pen, "normal", tip, (self.colors.hit, POINT_TEXT, false));
        }
        for guide in &handles.guides {
            self.guide(*guide);
        }
        let (plain, others): (Vec<_>, Vec<_>) =
            handles.marks.iter().rev().partition(|mark| mark.state == KnobState::Plain);
        for mark in plain.into_iter().chain(others) {
            self.knob(mark);
        }
    }

    fn knob(&mut self, mark: &HandleMark) {
        let Some(spot) = self.screen.spot(mark.at) else { return };
        let (ink, halo, scale) = (self.colors.hit, self.colors.halo, self.scale());
        let radius = scale * if mark.state == KnobState::Plain { PLAIN } else { LARGE };
        let mut add = |shape: Shape, color, cased: bool| {
            let halo = cased.then_some(halo);
            let (item, thing, hidden, pattern) = (Item::Handles, None, false, None);
            let mark = Mark { item, thing, shape, color, halo, hidden, pattern };
            self.drawing.marks.push(mark);
        };
        if mark.state == KnobState::Held {
            let ring = (0..=48).map(|k| {
                let angle = f64::from(k) * std::f64::consts::TAU / 48.0;
                dot(spot.at + 1.7 * radius * DVec2::from_angle(angle))
            });
            let width = 2.4 * scale as f32;
            add(Shape::Line { points: ring.collect(), width }, ink, true);
        }
        add(filled(mark.knob, spot.at, radius), ink, true);
        if mark.state != KnobState::Held {
            add(filled(mark.knob, spot.at, radius - RIM * scale), halo, false);
        }
    }

    fn guide(&mut self, guide: Guide) {
        match guide {
            Guide::Line { from, to, axis, is_long } => {
                let of_camera = axis >= 3;
                let colors = if of_camera { self.colors.basis } else { self.colors.axes };
                let color = colors[axis % 3];
                let pen = Pen::new(Item::Handles, color, 2.2).on_top();
                self.line(from, to, pen);
                let named = if is_long { from.midpoint(to) } else { to };
                let size = if of_camera { VECTOR_TEXT } else { POINT_TEXT };
                if let Some(spot) = self.screen.spot(named) {
                    let toward = self.screen.spot(from).map_or(DVec2::X, |f| spot.at - f.at);
                    self.label(pen, AXES[axis % 6], spot.at, toward, (color, size, of_camera));
                }
            }
            Guide::Ring { center, a, b } => {
                const SIDES: u32 = 72;
                let pen = Pen::new(Item::Handles, self.colors.hit, 2.0).on_top();
                let at = |k: u32| {
                    let angle = f64::from(k) * std::f64::consts::TAU / f64::from(SIDES);
                    center + angle.cos() * a + angle.sin() * b
                };
                // The casing of each line would cut the one before it.
                for k in 0..SIDES {
                    self.line(at(k), at(k + 1), pen.without_halo());
                }
            }
        }
    }
}

fn filled(knob: Knob, at: DVec2, radius: f64) -> Shape {
    let corners = |spokes: [[f64; 2]; 4], size: f64| Shape::Polygon {
        points: spokes.map(|[x, y]| dot(at + size * DVec2::new(x, y))).to_vec(),
    };
    match knob {
        Knob::Round => Shape::Disc { center: dot(at), radius: radius as f32 },
        Knob::Square => {
            corners([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.88 * radius)
        }
        Knob::Diamond => corners([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]], 1.25 * radius),
    }
}
