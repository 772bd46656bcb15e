//! The quadratic equation of a ray and a sphere, with error bounds. The same code is used for `f64` and
//! double-double, the first two steps of the ladder.

use crate::exact::bounded::{Number, SECOND_ORDER, UNDERFLOW, Vector, cross, dot};

/// Maximum relative error of a usable root. Up to this error, the factor [`SECOND_ORDER`] covers the
/// square of the error, which the bounds omit.
pub(crate) const LARGEST_SHARE: f64 = 1.0 / 64.0;

/// A formula for the discriminant D of the quadratic of a ray and a sphere ([`Quadratic`]). Which
/// formula loses fewer digits depends on the distance of the ray's origin from the sphere's centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// `b^2 - a c`, for origins inside the sphere, where `-a c` is positive, too, and just outside,
    /// where both terms are small.
    Near,
    /// `r^2 a - |q x d|^2`, by Lagrange's identity `a |q|^2 - (d.q)^2 = |q x d|^2`, for grazing rays and
    /// distant spheres.
    Far,
}

/// The values of a sphere that all rays from one origin share, scaled: `q = center - origin`, the radius
/// r, and `c = |q|^2 - r^2`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereTerms<T> {
    pub(crate) q: Vector<T>,
    pub(crate) radius: T,
    pub(crate) c: T,
    /// Relative error of c.
    pub(crate) c_doubt: f64,
    /// `|q|`, rounded.
    pub(crate) distance: f64,
    /// Error of q, relative to `|q|`.
    pub(crate) q_doubt: f64,
    pub(crate) form: Form,
}

/// A ray's direction d, scaled, with its length and its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DirectionTerms<T> {
    pub(crate) d: Vector<T>,
    /// `|d|`, rounded.
    pub(crate) length: f64,
    /// Error of d, relative to `|d|`.
    pub(crate) doubt: f64,
}

/// The quadratic `a t^2 - 2 b t + c = 0` of a ray and a sphere, with the discriminant `D = b^2 - a c`.
/// `a = d.d`, and `b = q.d` is positive if the sphere's centre lies ahead of the ray's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadratic<T> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) discriminant: T,
    /// Error bound of b.
    pub(crate) b_doubt: f64,
    /// Error bound of D.
    pub(crate) discriminant_doubt: f64,
    /// Relative error of a.
    pub(crate) a_doubt: f64,
}

/// A root of the quadratic that is certainly accurate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SureRoot<T> {
    pub(crate) t: T,
    /// The relative error of t.
    pub(crate) share: f64,
    /// A lower bound of `sqrt D = |b - a t|`, half the chord's length times `|d|`.
    pub(crate) swing: f64,
}

impl<T: Number> SphereTerms<T> {
    /// Returns `b = q.d` and the bound of its error, see [`Quadratic::new`].
    #[inline(always)]
    pub(crate) fn ahead(&self, direction: &DirectionTerms<T>) -> (T, f64) {
        let share = T::DOT + self.q_doubt + direction.doubt;
        let reach = self.distance * direction.length;
        (dot(self.q, direction.d), SECOND_ORDER * share * reach + UNDERFLOW)
    }
}

impl<T: Number> Quadratic<T> {
    /// Computes the coefficients and their error bounds, in which k is the sum of the relative errors of
    /// q and d, B the bound of b's error, and M that of the error of the vector `m = q x d`:
    ///
    /// ```text
    /// b:  B = |q||d| (DOT + k)                 a:  a (DOT + 2 k)
    /// m = q x d:  M = |q||d| (CROSS + k)
    /// far,  r^2 a - m.m:  2 |m| M + M^2 + r^2 a (2 PRODUCT + DOT + 2 k) + DOT m.m
    /// near, b^2 - a c:    2 |b| B + B^2 + PRODUCT b^2 + a |c| (PRODUCT + DOT + 2 k + error of c)
    /// ```
    ///
    /// To the bound of D, the rounding of the difference adds SUM times each of its two terms.
    #[inline(always)]
    pub(crate) fn new(sphere: &SphereTerms<T>, direction: &DirectionTerms<T>) -> Quadratic<T> {
        let (q, d) = (sphere.q, direction.d);
        let k = sphere.q_doubt + direction.doubt;
        let a = dot(d, d);
        let (b, b_doubt) = sphere.ahead(direction);
        let reach = sphere.distance * direction.length;
        let (discriminant, doubt) = match sphere.form {
            Form::Far => {
                let m = cross(q, d);
                let (mm, rra) = (dot(m, m), sphere.radius * sphere.radius * a);
                let (m_squared, m_doubt) = (mm.near(), (T::CROSS + k) * reach);
                let doubt = (2.0 * m_squared.sqrt() + m_doubt) * m_doubt
                    + (2.0 * T::PRODUCT + T::DOT + 2.0 * k + T::SUM) * rra.near()
                    + (T::DOT + T::SUM) * m_squared;
                (rra - mm, doubt)
            }
            Form::Near => {
                let (b_near, ac) = (b.near().abs(), a * sphere.c);
                let doubt = (2.0 * b_near + b_doubt) * b_doubt
                    + (T::PRODUCT + T::SUM) * b_near * b_near
                    + (T::PRODUCT + T::DOT + T::SUM + 2.0 * k + sphere.c_doubt) * ac.near().abs();
                (b * b - ac, doubt)
            }
        };
        let discriminant_doubt = SECOND_ORDER * doubt + UNDERFLOW;
        let a_doubt = SECOND_ORDER * (T::DOT + 2.0 * k);
        Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt }
    }

    /// Returns the nearer or, if `far` is true, the farther root, with a bound of its relative error.
    /// Returns `None` if the discriminant D may be 0.
    ///
    /// With `z = b + sign(b) sqrt D`, free of cancellation, the roots are `z / a` and `c / z` (Press et
    /// al., *Numerical Recipes*, 3rd ed., section 5.6). If D is off by at most its bound, `sqrt D` is
    /// off by at most `bound / sqrt D`, or by little more than half of that if D is large compared with
    /// its bound. The error of z is the sum of the errors of `sqrt D` and b, and of the rounding of a
    /// square root and a sum.
    #[inline(always)]
    pub(crate) fn root(&self, sphere: &SphereTerms<T>, far: bool) -> Option<(T, f64)> {
        let Quadratic { a, b, discriminant, b_doubt, discriminant_doubt, a_doubt } = *self;
        if discriminant.near() <= discriminant_doubt {
            return None;
        }
        let root = discriminant.root();
        let share = if discriminant.near() > 32.0 * discriminant_doubt { 0.51 } else { 1.0 };
        let z = if b.near() >= 0.0 { b + root } else { b - root };
        let z_doubt = (b_doubt + share * discriminant_doubt / root.near()) / z.near().abs();
        let (t, other_doubt) =
            if self.is_of_c(far) { (sphere.c / z, sphere.c_doubt) } else { (z / a, a_doubt) };
        // One more product, because callers multiply t by the ray's `stretch`, a whole number.
        let operations = T::ROOT + T::SUM + T::QUOTIENT + T::PRODUCT;
        Some((t, SECOND_ORDER * (z_doubt + other_doubt + operations)))
    }

    /// Returns the root like [`Quadratic::root`], if its relative error is at most [`LARGEST_SHARE`].
    #[inline(always)]
    pub(crate) fn sure_root(&self, sphere: &SphereTerms<T>, far: bool) -> Option<SureRoot<T>> {
        let (t, share) = self.root(sphere, far)?;
        let least = 0.99 * (self.discriminant.near() - self.discriminant_doubt);
        (share < LARGEST_SHARE).then_some(SureRoot { t, share, swing: least.sqrt() })
    }

    /// Returns whether [`Quadratic::root`] computes a root as `c / z`, not as `z / a`.
    #[inline(always)]
    pub(crate) fn is_of_c(&self, far: bool) -> bool {
        far != (self.b.near() >= 0.0)
    }
}

/// Returns the outward unit normal of a sphere at a ray's point t: `t d - q`, scaled to length 1. It is
/// the zero vector if the square of the length of `t d - q` is computed as 0 or overflows.
pub(crate) fn sphere_normal<T: Number>(
    q: Vector<T>,
    direction: &DirectionTerms<T>,
    t: T,
) -> Vector<f64> {
    let offset: Vector<T> = std::array::from_fn(|i| direction.d[i] * t - q[i]);
    let square = dot(offset, offset);
    if !(square.near() > 0.0 && square.near().is_finite()) {
        return [0.0; 3];
    }
    let length = square.root();
    offset.map(|x| (x / length).near())
}
