//! A sphere's outline in the image: its quadratic as a polynomial in whole steps of rows and
//! columns.

use std::cmp::Ordering;

use crate::frame_rays::Steppers;
use crate::terms::{Form, Number, SphereParts, Vector, cross, dot, length, near};

/// A rectangle of pixels in whole steps: around `(n, l)`, up to `columns` and `rows` away from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(crate) n: f64,
    pub(crate) l: f64,
    pub(crate) columns: f64,
    pub(crate) rows: f64,
}

/// With the direction `s + m e + k g`, m columns and k rows from the middle of a [`Patch`], the
/// parts a, b and D of a sphere's quadratic, whose coefficients stand in the order 1, m, k, m^2, mk,
/// k^2. The middle is near the outline's, where `r^2 a` and `|q x d|^2` are small, so that nothing
/// cancels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Conic<T> {
    a: [T; 6],
    b: [T; 3],
    discriminant: [T; 6],
    /// How far D may be off, in the patch.
    discriminant_doubt: f64,
    /// How far b may be off.
    b_doubt: f64,
    /// Relative error of a.
    a_doubt: f64,
}

/// One row of a [`Conic`]: polynomials in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConicRow<T> {
    pub(crate) a: [T; 3],
    pub(crate) b: [T; 2],
    pub(crate) discriminant: [T; 3],
}

/// Where a pixel is beyond doubt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Thresholds {
    /// D at least this is a hit, and `t` exact enough.
    pub(crate) hit: f64,
    /// D below this is a miss.
    pub(crate) miss: f64,
    /// b above this is ahead, below its negative behind.
    pub(crate) ahead: f64,
}

/// The six coefficients of `x . y` for `x = x0 + m x1 + k x2` with itself.
fn square<T: Number>([x0, x1, x2]: [Vector<T>; 3]) -> [T; 6] {
    let twice = |a, b| {
        let product = dot(a, b);
        product + product
    };
    [dot(x0, x0), twice(x0, x1), twice(x0, x2), dot(x1, x1), twice(x1, x2), dot(x2, x2)]
}

impl<T: Number> Conic<T> {
    /// The coefficients and bounds of their error anywhere in the patch. With
    /// `S = |s| + m |e| + k |g|` at the patch's corner, likewise `N` of `q x direction` and `B` of b,
    /// `K` the doubts of q and the direction together and `e` the rounding of one operation:
    ///
    /// ```text
    /// b:  B' = |q| S (3 e + K) + 4 e B
    /// q x direction:  M = |q| S (3 e + K)
    /// D, far:   (2 N + M) M + (16 e + 4 K) r^2 S^2 + 16 e N^2
    /// D, near:  (2 B + B') B' + 16 e B^2 + (16 e + 4 K + doubt of c) |c| S^2
    /// ```
    ///
    /// A coefficient has at most 6 roundings of the terms that these lengths bound, and evaluating
    /// the polynomial, column within row, 8 more.
    pub(crate) fn new(sphere: &SphereParts<T>, rays: &Steppers<T>, patch: &Patch) -> Conic<T> {
        let (q, e) = (sphere.q, T::ROUNDING);
        let vectors = [rays.direction(patch.n, patch.l), rays.e, rays.g];
        let corner = |[x0, x1, x2]: [f64; 3]| x0 + patch.columns * x1 + patch.rows * x2;
        let reach_of = |v: [Vector<T>; 3]| corner(v.map(|x| length(near(x))));
        let k = sphere.q_doubt + rays.doubt;
        let reach = reach_of(vectors);
        let moved = sphere.distance * reach * (3.0 * e + k);
        let b = vectors.map(|v| dot(q, v));
        let b_reach = corner(b.map(|x| x.near().abs()));
        let b_doubt = moved + 4.0 * e * b_reach;
        let a = square(vectors);
        let (discriminant, doubt) = match sphere.form {
            Form::Far => {
                let moments = vectors.map(|v| cross(q, v));
                let moment = reach_of(moments);
                let rr = sphere.radius * sphere.radius;
                let squares = square(moments);
                let extent = sphere.radius.near() * reach;
                let doubt = (2.0 * moment + moved) * moved
                    + (16.0 * e + 4.0 * k) * extent * extent
                    + 16.0 * e * moment * moment;
                (std::array::from_fn(|i| rr * a[i] - squares[i]), doubt)
            }
            Form::Near => {
                let squares = square(b.map(|x| [x, T::from(0.0), T::from(0.0)]));
                let doubt = (2.0 * b_reach + b_doubt) * b_doubt
                    + 16.0 * e * b_reach * b_reach
                    + (16.0 * e + 4.0 * k + sphere.c_doubt) * sphere.c.near().abs() * reach * reach;
                (std::array::from_fn(|i| squares[i] - a[i] * sphere.c), doubt)
            }
        };
        Conic {
            a,
            b,
            discriminant,
            discriminant_doubt: 1.1 * doubt + 1e-190,
            b_doubt: 1.1 * b_doubt + 1e-190,
            a_doubt: 1.1 * (16.0 * e + 4.0 * k),
        }
    }

    /// The row that is `k` steps from the middle.
    #[inline(always)]
    pub(crate) fn row(&self, k: f64) -> ConicRow<T> {
        let k = T::from(k);
        let of = |c: &[T; 6]| [c[0] + k * (c[2] + k * c[5]), c[1] + k * c[4], c[3]];
        ConicRow {
            a: of(&self.a),
            b: [self.b[0] + k * self.b[2], self.b[1]],
            discriminant: of(&self.discriminant),
        }
    }

    /// Where decisions are beyond doubt and the relative error of `t` is at most `t_doubt`.
    ///
    /// With `z = |b| + sqrt D`, t is `c / z` or `z / a`. z is at least `sqrt(|c| a)`, since
    /// `b^2 - D = a c`, and off by `b_doubt + D_doubt / sqrt D`. On the sphere itself
    /// `t = 2 b / a`.
    pub(crate) fn thresholds(
        &self,
        sphere: &SphereParts<T>,
        side: Ordering,
        least_length: f64,
        t_doubt: f64,
    ) -> Thresholds {
        let e = T::ROUNDING;
        let (doubt, b_doubt) = (self.discriminant_doubt, self.b_doubt);
        if side == Ordering::Equal {
            let left = t_doubt - self.a_doubt - 12.0 * e;
            let ahead = if left > 0.0 { b_doubt / left } else { f64::INFINITY };
            return Thresholds { hit: 0.0, miss: 0.0, ahead: ahead.max(b_doubt) };
        }
        let z = 0.99 * sphere.c.near().abs().sqrt() * least_length;
        let left = t_doubt - sphere.c_doubt - self.a_doubt - 12.0 * e - b_doubt / z;
        let root = doubt / (z * left);
        // Where nothing is left, every pixel goes up the ladder by itself.
        let hit =
            if left > 0.0 && root.is_finite() { doubt.max(root * root) } else { f64::INFINITY };
        Thresholds { hit, miss: -doubt, ahead: b_doubt }
    }

    /// How far b may be off.
    pub(crate) fn b_doubt(&self) -> f64 {
        self.b_doubt
    }
}
