//! Where a ray's line meets a surface.

/// Where a ray's line meets a surface, ascending. A `t` beyond the range of `f64` (a direction of
/// 1e-300 and a sphere at 1e10) is left out; one too small for it is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// Not at all.
    None,
    /// Once: a tangent, or a plane.
    One(f64),
    /// Twice.
    Two(f64, f64),
}

impl Roots {
    /// The roots in ascending order.
    pub fn iter(self) -> impl Iterator<Item = f64> {
        let (first, second) = match self {
            Roots::None => (None, None),
            Roots::One(t) => (Some(t), None),
            Roots::Two(t0, t1) => (Some(t0), Some(t1)),
        };
        first.into_iter().chain(second)
    }

    /// The smallest root greater than 0.
    pub fn first_positive(self) -> Option<f64> {
        self.iter().find(|t| *t > 0.0)
    }

    /// Each root as `f` has it, in the same order; `f` must be increasing.
    pub(crate) fn map(self, f: impl Fn(f64) -> f64) -> Roots {
        let roots = match self {
            Roots::None => Roots::None,
            Roots::One(t) => Roots::One(f(t)),
            Roots::Two(t0, t1) => Roots::Two(f(t0), f(t1)),
        };
        roots.in_range()
    }

    /// Without the roots that are not finite.
    pub(crate) fn in_range(self) -> Roots {
        match self {
            Roots::One(t) if !t.is_finite() => Roots::None,
            Roots::Two(t0, t1) => match (t0.is_finite(), t1.is_finite()) {
                (true, true) => self,
                (true, false) => Roots::One(t0),
                (false, true) => Roots::One(t1),
                (false, false) => Roots::None,
            },
            _ => self,
        }
    }
}
