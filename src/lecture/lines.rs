//! Lines in two dimensions: the implicit `ax + by + c = 0`, the parametric `p + t d`, and the
//! substitution of the parametric line into the implicit one.
//!
//! Every decision that depends on a sign, or on whether a number is 0 (parallel, coincident, before or
//! behind `p`, which side of a line), is made exactly for the given numbers. A value for display is
//! rounded once.

use std::cmp::Ordering;

use pinhole_core::arithmetic::{Dyadic, rounded_quotient};
use pinhole_core::{DVec2, shortest};

/// The line `a x + b y + c = 0`: all points at which `f(x, y) = a x + b y + c` is 0.
///
/// The numbers may have any values; [`ImplicitLine::check`] checks whether they define a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitLine {
    /// The factor of x.
    pub a: f64,
    /// The factor of y.
    pub b: f64,
    /// The constant.
    pub c: f64,
}

/// The line `p + t d`, with one point for each `t`. Points with `t > 0` are ahead of `p`.
///
/// The numbers may have any values; [`ParametricLine::check`] checks whether they define a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParametricLine {
    /// The point at `t = 0`.
    pub p: DVec2,
    /// The step from the point at `t = 0` to the point at `t = 1`, of any length.
    pub d: DVec2,
}

/// A parametric line substituted into an implicit one: `a (px + t dx) + b (py + t dy) + c = (a dx +
/// b dy) t + (a px + b py + c)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Substitution {
    /// The implicit line.
    pub line: ImplicitLine,
    /// The parametric line.
    pub ray: ParametricLine,
    /// `a dx + b dy`, rounded once: the change of `f = a x + b y + c` when t grows by 1.
    pub rate: f64,
    /// `a px + b py + c`, rounded once: f at `t = 0`.
    pub offset: f64,
    /// Whether and where the two lines meet.
    pub meeting: Meeting,
}

/// How a parametric line meets an implicit one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting {
    /// The lines do not meet: `a x + b y + c` is the same nonzero number at every t.
    Parallel,
    /// The lines meet at every t: they are the same line.
    Coincident,
    /// The lines meet at one t.
    At(Crossing),
    /// The lines meet at one t, but t, x or y is outside the range of `f64`.
    TooFar {
        /// True if `t > 0`.
        ray_hits: bool,
    },
}

/// The only point that two lines have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// `-(a px + b py + c) / (a dx + b dy)`, rounded to the nearest `f64`.
    pub t: f64,
    /// `p + t d` for the t before rounding, with each coordinate rounded to the nearest `f64`.
    pub point: DVec2,
    /// True if `t > 0`, so that the ray from p along d hits. Otherwise only the whole line does.
    pub ray_hits: bool,
}

impl ImplicitLine {
    /// Returns the slope m and the intercept q of `y = m x + q`: `m = -a / b`, `q = -c / b`. Returns
    /// `None` for a vertical line, which has no such form, and if m or q is outside the range of `f64`.
    pub fn slope_form(&self) -> Option<(f64, f64)> {
        let (m, q) = (-self.a / self.b, -self.c / self.b);
        (m.is_finite() && q.is_finite()).then_some((m + 0.0, q + 0.0))
    }

    /// Checks that the numbers define a line.
    ///
    /// # Errors
    /// Returns the reason if they do not.
    pub fn check(&self) -> Result<(), String> {
        for (field, value) in [("a", self.a), ("b", self.b), ("c", self.c)] {
            finite(field, value)?;
        }
        if self.a == 0.0 && self.b == 0.0 {
            let c = shortest(self.c);
            return Err(format!(
                "a and b are both 0: f is {c} at every point, and no line is left"
            ));
        }
        Ok(())
    }

    /// Returns `f(x, y) = a x + b y + c`, rounded once. The numbers must be finite; the result is
    /// infinite if it overflows.
    pub fn f(&self, point: DVec2) -> f64 {
        self.exact_f(point).rounded_times(0)
    }

    /// Returns the exact sign of [`f`](ImplicitLine::f) at a point: `Greater` on the left of
    /// [`direction`](ImplicitLine::direction). The numbers must be finite.
    pub fn side(&self, point: DVec2) -> Ordering {
        self.exact_f(point).sign()
    }

    fn exact_f(&self, point: DVec2) -> Dyadic {
        let ([a, b, c], [x, y]) = (self.exact(), point.to_array().map(Dyadic::from));
        &(&(&a * &x) + &(&b * &y)) + &c
    }

    fn exact(&self) -> [Dyadic; 3] {
        [self.a, self.b, self.c].map(Dyadic::from)
    }

    /// Returns `(b, -a)`, the direction along the line for which [`f`](ImplicitLine::f) is positive on
    /// the left.
    pub fn direction(&self) -> DVec2 {
        DVec2::new(self.b, -self.a)
    }

    /// Returns the line through a point that has this [direction](ImplicitLine::direction). Its a and b
    /// are exact, and c is rounded once.
    pub fn along(direction: DVec2, point: DVec2) -> ImplicitLine {
        let line = ImplicitLine { a: -direction.y + 0.0, b: direction.x, c: 0.0 };
        ImplicitLine { c: -line.f(point) + 0.0, ..line }
    }

    /// Returns the point of the line that is nearest to `point`, up to rounding.
    pub fn nearest_to(&self, point: DVec2) -> DVec2 {
        // Scale the numbers so that no square overflows or underflows.
        let size = self.a.abs().max(self.b.abs());
        let normal = DVec2::new(self.a / size, self.b / size);
        point - (self.f(point) / size) / normal.length_squared() * normal
    }
}

impl ParametricLine {
    /// Checks that the numbers define a line.
    ///
    /// # Errors
    /// Returns the reason if they do not.
    pub fn check(&self) -> Result<(), String> {
        let ParametricLine { p, d } = *self;
        for (field, value) in [("p x", p.x), ("p y", p.y), ("d x", d.x), ("d y", d.y)] {
            finite(field, value)?;
        }
        if d == DVec2::ZERO {
            let (x, y) = (shortest(p.x), shortest(p.y));
            return Err(format!("d is (0, 0): every t gives the one point ({x}, {y})"));
        }
        Ok(())
    }

    /// Returns `p + t d`.
    pub fn at(&self, t: f64) -> DVec2 {
        self.p + t * self.d
    }

    /// Returns the t of the line's point that is nearest to `point`, up to rounding:
    /// `((point - p) . d) / (d . d)`.
    pub fn nearest_t(&self, point: DVec2) -> f64 {
        let size = self.d.abs().max_element();
        let d = self.d / size;
        (point - self.p).dot(d) / d.length_squared() / size
    }

    /// Returns points of the line, each with its t, which is a multiple of `step` between `first` and
    /// `last`. At most `most` points are returned.
    pub fn generated(
        &self,
        step: f64,
        first: f64,
        last: f64,
        most: usize,
    ) -> impl Iterator<Item = (f64, DVec2)> {
        let line = *self;
        let (from, to) = ((first / step).ceil(), (last / step).floor());
        let count = if to >= from { (to - from).min(most as f64) as usize + 1 } else { 0 };
        (0..count.min(most)).map(move |k| {
            let t = (from + k as f64) * step;
            (t, line.at(t))
        })
    }
}

impl Substitution {
    /// Substitutes the parametric line into the implicit one.
    ///
    /// # Errors
    /// Returns an error if either of them is not a line.
    ///
    /// ```
    /// use pinhole_core::DVec2;
    /// use pinhole_lecture::lines::*;
    /// let line = ImplicitLine { a: 2.0, b: -1.0, c: 1.0 };
    /// let ray = ParametricLine { p: DVec2::ZERO, d: DVec2::ONE };
    /// let Meeting::At(crossing) = Substitution::new(line, ray)?.meeting else { panic!() };
    /// assert_eq!((crossing.t, crossing.ray_hits), (-1.0, false));
    /// # Ok::<(), String>(())
    /// ```
    pub fn new(line: ImplicitLine, ray: ParametricLine) -> Result<Substitution, String> {
        line.check()?;
        ray.check()?;
        let (rate, offset) = terms(&line, &ray);
        Ok(Substitution {
            line,
            ray,
            rate: rate.rounded_times(0),
            offset: offset.rounded_times(0),
            meeting: Meeting::new(&ray, &rate, &offset),
        })
    }

    /// Returns the value of `a x + b y + c` at the point `p + t d`, rounded once, and its exact sign.
    pub fn f(&self, t: f64) -> (f64, Ordering) {
        let (rate, offset) = terms(&self.line, &self.ray);
        let f = &(&rate * &Dyadic::from(t)) + &offset;
        (f.rounded_times(0), f.sign())
    }
}

impl Meeting {
    fn new(ray: &ParametricLine, rate: &Dyadic, offset: &Dyadic) -> Meeting {
        if rate.is_zero() {
            return if offset.is_zero() { Meeting::Coincident } else { Meeting::Parallel };
        }
        // t = -offset / rate, and p + t d = (p rate - offset d) / rate.
        let numerator = -offset;
        let ray_hits = numerator.sign() != Ordering::Equal && numerator.sign() == rate.sign();
        let coordinate = |p: f64, d: f64| {
            let on_line = &(&Dyadic::from(p) * rate) + &(&numerator * &Dyadic::from(d));
            rounded_quotient(&on_line, rate)
        };
        let t = rounded_quotient(&numerator, rate);
        let point = DVec2::new(coordinate(ray.p.x, ray.d.x), coordinate(ray.p.y, ray.d.y));
        if !t.is_finite() || !point.is_finite() {
            return Meeting::TooFar { ray_hits };
        }
        Meeting::At(Crossing { t, point, ray_hits })
    }
}

/// Returns the exact terms of [`Substitution`]: `(a dx + b dy, a px + b py + c)`.
fn terms(line: &ImplicitLine, ray: &ParametricLine) -> (Dyadic, Dyadic) {
    let [a, b, _] = line.exact();
    let [x, y] = ray.d.to_array().map(Dyadic::from);
    (&(&a * &x) + &(&b * &y), line.exact_f(ray.p))
}

fn finite(field: &str, value: f64) -> Result<(), String> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(format!("{field} is {value}: it must be a finite number")),
    }
}
