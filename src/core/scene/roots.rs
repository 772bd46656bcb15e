//! Roots: the points at which a ray's line meets a surface.

/// The roots of a ray's line and a surface, ascending. A `t` beyond the range of `f64` (a direction of
/// 1e-300 and a sphere at 1e10) is infinite, with its sign; one too small for it is the smallest
/// number there is, with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// The line misses the surface.
    None,
    /// One root: a tangent, or a plane.
    One(f64),
    /// Two roots.
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
}
