//! The state of the page *Lines*, the lines lab (an implicit and a parametric line in the plane), and the
//! dragging of its handles. The arithmetic of the lines is in [`pinhole_lecture::lines`].

use pinhole_core::DVec2;
use pinhole_lecture::lines::{ImplicitLine, ParametricLine};

/// Maximum magnitude of the numbers in the lines lab's fields, chosen so that all results are finite.
pub(crate) const LARGEST: f64 = 1e6;

/// The state of the lines lab: an implicit line, a parametric line, and the parameter t of a point marked
/// on it. It is plain data, which a lesson's step sets as a whole.
#[derive(Clone, Debug, PartialEq)]
pub struct LinesLab {
    line: ImplicitLine,
    /// The parametric line.
    pub ray: ParametricLine,
    /// The parameter t of the marked point.
    pub t: f64,
    /// The trail of points that the marked point has visited.
    pub trail: Trail,
    /// The lines that are drawn.
    pub shown: ShownLines,
    /// The visible part of the plane.
    pub window: Window,
    /// The point of the implicit line that carries its handle for moving; the line turns about it.
    grip: DVec2,
    /// Offset from the grip to the handle that turns the line, as a multiple of the line's direction
    /// vector.
    reach: f64,
}

/// The trail of the marked point: points of the parametric line at equal steps of t, over the whole range
/// of t that it has visited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trail {
    /// Step in t from one point to the next.
    pub step: f64,
    /// The smallest visited t.
    pub first: f64,
    /// The largest visited t.
    pub last: f64,
}

/// The square part of the plane that is visible in any case. A drawing that is not square shows more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The point in the middle of the drawing.
    pub center: DVec2,
    /// Distance from the middle of the drawing to each of its two nearer edges.
    pub half_extent: f64,
}

/// The lines that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShownLines {
    /// Both lines, and where they meet.
    Both,
    /// The implicit line alone.
    Implicit,
    /// The parametric line alone.
    Parametric,
}

pinhole_core::texts! {
    /// A handle in the lab. The variants are in their order from back to front.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum LineHandle[1];
    {
        /// Returns the handle's name for screen readers and for its tooltip.
        name,
    }
    /// Moves the implicit line without turning it.
    Move: "move the implicit line";
    /// Turns the implicit line about its grip.
    Turn: "turn the implicit line";
    /// The parametric line's p.
    P: "move p";
    /// The tip of d.
    Tip: "move the tip of d";
    /// The marked point p + t d, which can only move along its line.
    T: "slide t";
}

impl Default for LinesLab {
    /// Returns an example like the lecture's, in which the two lines meet at t = 1.
    fn default() -> Self {
        let [(_, lab), ..] = LinesLab::examples();
        lab
    }
}

impl LinesLab {
    /// Returns one example, with its name, for each possible relation of the two lines: the ray hits or
    /// misses, and the lines are parallel or coincide.
    pub fn examples() -> [(&'static str, LinesLab); 4] {
        let lab = |[a, b, c]: [f64; 3], p: [f64; 2], d: [f64; 2]| {
            let ray = ParametricLine { p: p.into(), d: d.into() };
            LinesLab::new(ImplicitLine { a, b, c }, ray, 0.5)
        };
        [
            ("Ray hits", lab([1.0, 1.0, -2.0], [0.0, 0.0], [1.0, 1.0])),
            ("Ray misses", lab([2.0, -1.0, 1.0], [0.0, 0.0], [1.0, 1.0])),
            ("Parallel", lab([1.0, -1.0, 2.0], [0.0, 0.0], [1.0, 1.0])),
            ("Coincident", lab([1.0, -2.0, 2.0], [-2.0, 0.0], [2.0, 1.0])),
        ]
    }

    /// Creates the state with these lines and the marked point at parameter `t` of the parametric line.
    pub fn new(line: ImplicitLine, ray: ParametricLine, t: f64) -> LinesLab {
        let mut lab = LinesLab {
            line,
            ray,
            t,
            trail: Trail { step: 0.5, first: t, last: t },
            shown: ShownLines::Both,
            window: Window { center: DVec2::ZERO, half_extent: 4.0 },
            grip: DVec2::ZERO,
            reach: 1.0,
        };
        lab.set_line(line);
        // Keep the middle of the drawing free, because the lines are likely to meet there.
        lab.grip -= 0.5 * lab.reach * line.direction();
        lab
    }

    /// Returns the implicit line.
    pub fn line(&self) -> ImplicitLine {
        self.line
    }

    /// Sets the implicit line, and moves the grip onto it.
    pub fn set_line(&mut self, line: ImplicitLine) {
        self.line = line;
        if line.check().is_err() {
            return;
        }
        self.grip = line.nearest_to(self.grip);
        // The factor is a power of two, so that dividing by it when the line is turned is exact.
        let wanted = 0.7 * self.window.half_extent / line.direction().length();
        self.reach = wanted.log2().round().clamp(-900.0, 900.0).exp2();
    }

    /// Sets t, and extends the trail to it.
    pub fn set_t(&mut self, t: f64) {
        self.t = t;
        self.trail.first = self.trail.first.min(t);
        self.trail.last = self.trail.last.max(t);
    }

    /// Returns the position of a handle; `None` if its line is invalid or not drawn.
    pub fn position_of(&self, handle: LineHandle) -> Option<DVec2> {
        let hidden = match handle {
            LineHandle::Move | LineHandle::Turn => ShownLines::Parametric,
            LineHandle::P | LineHandle::Tip | LineHandle::T => ShownLines::Implicit,
        };
        let of_line = || self.line.check().ok().map(|()| self.grip);
        let position = match handle {
            LineHandle::Move => of_line()?,
            LineHandle::Turn => of_line()? + self.reach * self.line.direction(),
            LineHandle::P => self.ray.p,
            LineHandle::Tip => self.ray.p + self.ray.d,
            LineHandle::T => self.ray.at(self.t),
        };
        (position.is_finite() && self.shown != hidden).then_some(position)
    }

    /// Moves a handle by a number of steps to the right and upwards, rounded as in [`LinesLab::drag`]. The
    /// marked point p + t d can only move along its line: t changes by steps, in the direction nearer to
    /// that of `steps`.
    pub fn nudge(&mut self, handle: LineHandle, steps: DVec2, fineness: f64) {
        let step = 0.1;
        if handle == LineHandle::T {
            let along = steps.dot(self.ray.d);
            if along != 0.0 {
                let t = self.t + step * steps.abs().max_element().copysign(along);
                let per_step = 1.0 / step;
                let t = (t * per_step).round() / per_step + 0.0;
                self.set_t(t.clamp(-LARGEST, LARGEST));
            }
        } else if let Some(position) = self.position_of(handle) {
            self.drag(handle, position + step * steps, fineness);
        }
    }

    /// Drags a handle to the point `to`, whose coordinates are rounded to multiples of `1 / fineness`, which
    /// have few digits. Ignores a drag that would make the line invalid.
    pub fn drag(&mut self, handle: LineHandle, to: DVec2, fineness: f64) {
        let round = |x: f64| (x * fineness).round() / fineness + 0.0;
        let to = DVec2::new(round(to.x), round(to.y)).clamp(-DVec2::splat(1e5), DVec2::splat(1e5));
        match handle {
            LineHandle::Move => {
                self.line = ImplicitLine::along(self.line.direction(), to);
                self.grip = to;
            }
            LineHandle::Turn => {
                let line = ImplicitLine::along((to - self.grip) / self.reach, self.grip);
                if line.check().is_ok() {
                    self.line = line;
                }
            }
            LineHandle::P => self.ray.p = to,
            LineHandle::Tip => {
                let d = to - self.ray.p;
                let d = DVec2::new(round(d.x), round(d.y));
                if d != DVec2::ZERO {
                    self.ray.d = d;
                }
            }
            LineHandle::T => {
                let t = round(self.ray.nearest_t(to));
                if t.is_finite() {
                    self.set_t(t.clamp(-LARGEST, LARGEST));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pinhole_lecture::lines::{Meeting, Substitution};

    fn meeting(lab: &LinesLab) -> Meeting {
        Substitution::new(lab.line(), lab.ray).expect("two lines").meeting
    }

    #[test]
    fn examples_are_what_they_are_called() {
        let meetings = LinesLab::examples().map(|(_, lab)| meeting(&lab));
        assert!(matches!(meetings[0], Meeting::At(at) if at.t == 1.0 && at.ray_hits));
        assert!(matches!(meetings[1], Meeting::At(at) if at.t == -1.0 && !at.ray_hits));
        assert_eq!(meetings[2..], [Meeting::Parallel, Meeting::Coincident]);
    }

    #[test]
    fn every_handle_goes_where_it_is_dragged() {
        let to = DVec2::new(1.25, -2.5);
        for handle in [LineHandle::Move, LineHandle::Turn, LineHandle::P, LineHandle::Tip] {
            let mut lab = LinesLab::default();
            lab.drag(handle, to, 100.0);
            let there = lab.position_of(handle).expect("a place");
            assert!(there.distance(to) < 1e-12, "{handle:?} {there}");
        }
        let mut lab = LinesLab::default();
        lab.drag(LineHandle::T, DVec2::new(3.0, 1.0), 100.0);
        assert_eq!((lab.t, lab.trail.first, lab.trail.last), (2.0, 0.5, 2.0));
    }

    #[test]
    fn turning_keeps_the_grip_and_moving_keeps_the_direction() {
        let mut lab = LinesLab::default();
        let grip = lab.position_of(LineHandle::Move).expect("a place");
        lab.drag(LineHandle::Turn, DVec2::new(3.0, 3.0), 100.0);
        assert_eq!(lab.position_of(LineHandle::Move), Some(grip));
        assert_eq!(lab.line().f(grip), 0.0);
        let direction = lab.line().direction();
        lab.drag(LineHandle::Move, DVec2::new(-2.0, 0.5), 100.0);
        assert_eq!(lab.line().direction(), direction);
        assert_eq!(lab.line().f(DVec2::new(-2.0, 0.5)), 0.0);
    }

    #[test]
    fn arrow_keys_never_leave_t_where_it_is() {
        for (_, mut lab) in LinesLab::examples() {
            let mut before = lab.t;
            for steps in [DVec2::X, DVec2::X, DVec2::Y] {
                lab.nudge(LineHandle::T, steps, 100.0);
                assert!((lab.t - before - 0.1).abs() < 1e-12, "{before} {}", lab.t);
                before = lab.t;
            }
            lab.nudge(LineHandle::T, DVec2::NEG_X, 100.0);
            assert!(lab.t < before);
        }
    }

    #[test]
    fn no_drag_leaves_no_line() {
        let mut lab = LinesLab::default();
        let (p, grip) = (lab.ray.p, lab.position_of(LineHandle::Move).expect("a place"));
        let before = lab.clone();
        lab.drag(LineHandle::Tip, p, 100.0);
        lab.drag(LineHandle::Turn, grip, 100.0);
        assert_eq!(lab, before);
    }
}
