//! The quadratic equation of a sphere and a view ray, as polynomials in the pixel's row and column.

use std::cmp::Ordering;

use crate::exact::bounded::{Number, SECOND_ORDER, UNDERFLOW, Vector, cross, dot, length};
use crate::exact::quadratic::{Form, SphereTerms};
use crate::render::polynomial::frame_rays::{Patch, Steppers};

/// A sphere's quadratic as polynomials in a pixel's position (m, k), relative to the middle of a
/// rectangle of pixels, a [`Patch`]. m and k are differences of the whole numbers n and l of
/// [`FrameRays`](crate::render::polynomial::frame_rays::FrameRays), so the pixel's direction is
/// `s + m e + k g`, with the direction s of the middle. The polynomials are the coefficients a and b and
/// the discriminant D of the quadratic, each as its coefficients of 1, m, k, m^2, mk, k^2. The middle of
/// the patch is near that of the outline, where `r^2 a` and `|q x d|^2` are small, so that nothing
/// cancels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Conic {
    a: [f64; 6],
    b: [f64; 3],
    discriminant: [f64; 6],
    /// Error bound of D in the patch.
    discriminant_doubt: f64,
    /// Error bound of b.
    b_doubt: f64,
    /// Relative error of a.
    a_doubt: f64,
}

/// One row of a [`Conic`], at a fixed k: polynomials in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConicRow {
    pub(crate) a: [f64; 3],
    pub(crate) b: [f64; 2],
    pub(crate) discriminant: [f64; 3],
}

/// Thresholds of D and b beyond which a pixel is certainly a hit or a miss.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Thresholds {
    /// If D is at least this value, the pixel is a hit, whose `t` is accurate enough.
    pub(crate) hit: f64,
    /// If D is below this value, the pixel is a miss.
    pub(crate) miss: f64,
    /// If b is above this value, the hit is in front of the eye; if b is below its negative, behind
    /// the eye.
    pub(crate) ahead: f64,
}

/// Returns the six coefficients of `x . x` for `x = x0 + m x1 + k x2`.
fn square([x0, x1, x2]: [Vector<f64>; 3]) -> [f64; 6] {
    let twice = |a, b| {
        let product = dot(a, b);
        product + product
    };
    [dot(x0, x0), twice(x0, x1), twice(x0, x2), dot(x1, x1), twice(x1, x2), dot(x2, x2)]
}

impl Conic {
    /// Computes the coefficients, and bounds of their errors anywhere in the patch.
    ///
    /// Let S be the value of `|s| + m |e| + k |g|` at the patch's corner, where it is largest, and let N
    /// and B be the bounds of `|q x direction|` and `|b|` formed in the same way. P and Q are the
    /// relative errors of direction and q, and STEP is the rounding error of a product with a whole
    /// number and a sum. A coefficient is made of dot products of vectors that are off by P. Evaluating
    /// a quadratic polynomial takes two such steps for each of its two variables. A linear one takes one
    /// for each; three in all are allowed for it. So, with the bounds B' and M of the errors of b and
    /// `q x direction`, and the two forms of D:
    ///
    /// ```text
    /// b:           B' = |q| S (DOT + P + Q) + 3 STEP B
    /// q x direction:  M = |q| S (CROSS + P + Q)
    /// D, far:   2 r S M + M^2 + r^2 S^2 (2 PRODUCT + DOT + 2 P) + DOT N^2 + F (r^2 S^2 + N^2)
    /// D, near:  2 B B' + B'^2 + DOT B^2 + |c| S^2 (PRODUCT + DOT + 2 P + error of c)
    ///           + F (B^2 + |c| S^2)          with F = SUM + 4 STEP
    /// ```
    ///
    /// In `D = r^2 a - |p|^2` with `p = q x direction`, the first term of the bound, `2 r S M`, is right
    /// where `D >= 0`, since `|p| <= r S` there. It suffices elsewhere: with `|p| <= r S + sqrt |D|` the
    /// error is at most `2 r S M + 2 sqrt |D| M + M^2`, and `-|D| + 2 sqrt |D| M <= M^2`. So if the
    /// computed D is above the bound (with `2 M^2`), the exact D is not negative.
    pub(crate) fn new(sphere: &SphereTerms<f64>, rays: &Steppers, patch: &Patch) -> Conic {
        let q = sphere.q;
        let vectors = [rays.direction(patch.n, patch.l), rays.e, rays.g];
        let corner = |x| patch.corner(x);
        let reach_of = |v: [Vector<f64>; 3]| corner(v.map(length));
        let p = rays.doubt();
        let step = f64::PRODUCT + f64::SUM;
        let reach = reach_of(vectors);
        let b = vectors.map(|v| dot(q, v));
        let b_reach = corner(b.map(|x| x.abs()));
        let moved = sphere.distance * reach * (f64::DOT + p + sphere.q_doubt);
        let b_doubt = moved + 3.0 * step * b_reach;
        let a = square(vectors);
        let evaluated = f64::SUM + 4.0 * step;
        let (discriminant, doubt) = match sphere.form {
            Form::Far => {
                let moments = vectors.map(|v| cross(q, v));
                let moment = reach_of(moments);
                let rr = sphere.radius * sphere.radius;
                let squares = square(moments);
                let extent = sphere.radius * reach;
                let moved = sphere.distance * reach * (f64::CROSS + p + sphere.q_doubt);
                let doubt = 2.0 * (extent + moved) * moved
                    + (2.0 * f64::PRODUCT + f64::DOT + 2.0 * p + evaluated) * extent * extent
                    + (f64::DOT + evaluated) * moment * moment;
                (std::array::from_fn(|i| rr * a[i] - squares[i]), doubt)
            }
            Form::Near => {
                let squares = square(b.map(|x| [x, 0.0, 0.0]));
                let c_share = f64::PRODUCT + f64::DOT + 2.0 * p + sphere.c_doubt + evaluated;
                let doubt = (2.0 * b_reach + b_doubt) * b_doubt
                    + (f64::DOT + evaluated) * b_reach * b_reach
                    + c_share * sphere.c.abs() * reach * reach;
                (std::array::from_fn(|i| squares[i] - a[i] * sphere.c), doubt)
            }
        };
        let longest = reach / rays.least_length;
        Conic {
            a,
            b,
            discriminant,
            discriminant_doubt: SECOND_ORDER * doubt + UNDERFLOW,
            b_doubt: SECOND_ORDER * b_doubt + UNDERFLOW,
            a_doubt: SECOND_ORDER * (f64::DOT + 2.0 * p + 4.0 * step) * longest * longest,
        }
    }

    /// Returns the row that is `k` steps from the patch's middle.
    #[inline(always)]
    pub(crate) fn row(&self, k: f64) -> ConicRow {
        let of_row = |c: &[f64; 6]| {
            let constant = c[0] + (c[2] + c[5] * k) * k;
            [constant, c[1] + c[4] * k, c[3]]
        };
        ConicRow {
            a: of_row(&self.a),
            b: [self.b[0] + self.b[2] * k, self.b[1]],
            discriminant: of_row(&self.discriminant),
        }
    }

    /// Finds the thresholds beyond which decisions are certain and the relative error of `t` is at most
    /// `t_doubt`.
    ///
    /// With `z = |b| + sqrt D`, t is `c / z` or `z / a`. z is at least `sqrt(|c| a)`, since
    /// `b^2 - D = a c`, and off by `b_doubt + D_doubt / sqrt D`. If the eye lies on the sphere,
    /// `t = 2 b / a`.
    pub(crate) fn thresholds(
        &self,
        sphere: &SphereTerms<f64>,
        side: Ordering,
        least_length: f64,
        t_doubt: f64,
    ) -> Thresholds {
        let (doubt, b_doubt) = (self.discriminant_doubt, self.b_doubt);
        // The operations of the kernels themselves are half a dozen roundings.
        let operations = 5.0 * f64::QUOTIENT + 2.0 * f64::PRODUCT;
        if side == Ordering::Equal {
            let left = t_doubt - self.a_doubt - operations;
            let ahead = if left > 0.0 { b_doubt / left } else { f64::INFINITY };
            return Thresholds { hit: 0.0, miss: -b_doubt, ahead: ahead.max(b_doubt) };
        }
        let z = 0.99 * sphere.c.abs().sqrt() * least_length;
        let other = if side == Ordering::Less { self.a_doubt } else { 0.0 };
        let left = t_doubt - sphere.c_doubt - other - operations - b_doubt / z;
        // If D is large compared with its error bound `doubt`, its root is off by little more than half
        // of doubt / sqrt D.
        let root = 0.52 * doubt / (z * left);
        let hit = if left > 0.0 && root.is_finite() {
            (32.0 * doubt).max(root * root)
        } else {
            // `t` cannot be accurate enough: the ladder decides every pixel.
            f64::INFINITY
        };
        Thresholds { hit, miss: -doubt, ahead: b_doubt }
    }
}
