//! A camera's basis in double-double, with an error bound, and in exact numbers.

use glam::DVec3;

use crate::camera::basis::{Basis, BasisError, check_finite};
use crate::exact::bounded::{self, Number, Vector, scaled};
use crate::exact::double_double::{DoubleDouble, U2, difference_with_rest};
use crate::exact::dyadic::{Dyadic, Exact3, cross, dot, exact3, minus, ratio};
use crate::exact::scale::ldexp;
use crate::exact::surd::Radicands;

/// The vectors u, v, w in double-double.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FineBasis {
    pub(crate) u: Vector<DoubleDouble>,
    pub(crate) v: Vector<DoubleDouble>,
    pub(crate) w: Vector<DoubleDouble>,
    /// Error bound of each vector.
    pub(crate) doubt: f64,
}

/// A view direction in the form in which it was given, because the exact `at - eye` may have more digits
/// than `f64` can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ViewGiven {
    /// The direction `to - from`.
    Between { from: DVec3, to: DVec3 },
    /// The direction itself.
    Along(DVec3),
}

impl ViewGiven {
    /// Returns the direction in double-double, in units of `2^k`, and k.
    fn fine(&self) -> (Vector<DoubleDouble>, i32) {
        let (view, rest, k) = match *self {
            ViewGiven::Between { from, to } => difference_with_rest(to, from),
            ViewGiven::Along(view) => (view, DVec3::ZERO, 0),
        };
        (std::array::from_fn(|i| DoubleDouble { hi: view[i], lo: rest[i] }), k)
    }

    /// Returns the direction rounded to `f64`, or a quarter of it if the whole would overflow.
    pub(crate) fn rounded(&self) -> DVec3 {
        DVec3::from_array(self.fine().0.map(DoubleDouble::near))
    }

    pub(crate) fn big(&self) -> Exact3 {
        match *self {
            ViewGiven::Between { from, to } => minus(&exact3(to), &exact3(from)),
            ViewGiven::Along(view) => exact3(view),
        }
    }
}

/// The exact, unnormalized vectors of a basis computed from view and up. With the view `f` and
/// `R = f x up`, `w = -f / sqrt A`, `u = R / sqrt B` and `v = w x u = (R x f) / sqrt(A B)`, where
/// `A = |f|^2` and `B = |R|^2`.
#[derive(Clone, Debug)]
pub(crate) struct BigBasis {
    pub(crate) view: Exact3,
    pub(crate) right: Exact3,
    /// `R x f`
    pub(crate) upward: Exact3,
    pub(crate) radicands: Radicands,
}

impl BigBasis {
    pub(crate) fn new(view: &ViewGiven, up: DVec3) -> BigBasis {
        let view = view.big();
        let right = cross(&view, &exact3(up));
        let upward = cross(&right, &view);
        let radicands = Radicands::new(dot(&view, &view), dot(&right, &right));
        BigBasis { view, right, upward, radicands }
    }
}

/// The sine of the smallest angle between view and up for which double-double suffices: 2^-20, about
/// 1e-6 rad. At that angle, `R = f x up` still has 9 digits more than are needed to round it to `f64`.
/// Below it, exact numbers are used, which takes microseconds.
const LEAST_SINE: f64 = 1.0 / (1 << 20) as f64;

impl FineBasis {
    /// Computes the basis from a view direction and up, neither of which is zero. Returns `None` if
    /// up is exactly parallel to the view.
    ///
    /// With f the view, `R = f x up` in double-double has an error of up to `CROSS |f| |up|` (see
    /// [`Number::CROSS`]). If R is much shorter than `|f| |up|`, exact numbers are used instead, so that
    /// the result is equally accurate at every angle.
    pub(crate) fn from_view_up(view: &ViewGiven, up: DVec3) -> Option<FineBasis> {
        let (f, _) = scaled(view.fine().0);
        let (up_scaled, _) = scaled(up.to_array().map(DoubleDouble::from));
        let right = bounded::cross(f, up_scaled);
        let length = |v: Vector<DoubleDouble>| bounded::length(bounded::near(v));
        let sine = length(right) / (length(f) * length(up_scaled));
        if sine.is_nan() || sine < LEAST_SINE {
            return FineBasis::from_exact(view, up);
        }
        let fine_unit = |v: Vector<DoubleDouble>| {
            let length = bounded::dot(v, v).square_root();
            v.map(|x| x / length)
        };
        let (u, w) = (fine_unit(right), fine_unit(f).map(|x| -x));
        // u and w each have half the error of a dot product and those of a square root and a quotient; u
        // also has the error of R; v has the errors of u and w, and that of a cross product.
        type T = DoubleDouble;
        let unit_doubt = 0.5 * T::DOT + T::ROOT + T::QUOTIENT;
        let doubt = 1.05 * (2.0 * unit_doubt + T::CROSS / sine + T::CROSS);
        let basis = FineBasis { u, v: bounded::cross(w, u), w, doubt };
        let zeros_of_view = view.fine().0.map(|x| x.hi == 0.0);
        let zeros_of_right = zeros_of_cross(zeros_of_view, up.to_array().map(|x| x == 0.0));
        let zeros_of_upward = zeros_of_cross(zeros_of_right, zeros_of_view);
        let zeros = [zeros_of_right, zeros_of_upward, zeros_of_view];
        let mut coordinates =
            [u, basis.v, w].into_iter().flatten().zip(zeros.into_iter().flatten());
        let is_sure = coordinates.all(|(x, is_zero)| is_zero || x.rounds_surely(doubt));
        if is_sure { Some(basis) } else { FineBasis::from_exact(view, up) }
    }

    /// Computes the basis from exact numbers. The error of each coordinate is at most `3 u^2` with
    /// `u = 2^-53`. Returns `None` if up is parallel to the view.
    pub(crate) fn from_exact(view: &ViewGiven, up: DVec3) -> Option<FineBasis> {
        let BigBasis { view, right, upward, radicands } = BigBasis::new(view, up);
        if radicands.b.is_zero() {
            return None;
        }
        let ab = &radicands.a * &radicands.b;
        let u = over_root(&right, &radicands.b);
        let v = over_root(&upward, &ab);
        let w = over_root(&view, &radicands.a).map(|x| -x);
        Some(FineBasis { u, v, w, doubt: 3.0 * U2 })
    }

    /// Returns the given basis in double-double.
    pub(crate) fn given(basis: &Basis) -> FineBasis {
        let exactly = |v: DVec3| v.to_array().map(DoubleDouble::from);
        let Basis { u, v, w } = *basis;
        FineBasis { u: exactly(u), v: exactly(v), w: exactly(w), doubt: 0.0 }
    }

    /// Returns the basis in `f64`. Each coordinate is rounded once, so the error of a vector is at
    /// most 1e-16.
    pub(crate) fn rounded(&self) -> Basis {
        // Adding 0 turns a negative zero into 0, which readers expect to see.
        let near = |v: Vector<DoubleDouble>| DVec3::from_array(v.map(|x| x.hi + 0.0));
        Basis { u: near(self.u), v: near(self.v), w: near(self.w) }
    }

    /// Returns an error bound of a direction `x u + y v + z w`, relative to its length. Since
    /// `|x| + |y| + |z|` is at most `sqrt 3` times the length, the bound is `sqrt 3` times the sum of a
    /// vector's error and that of a dot product.
    pub(crate) fn direction_doubt(&self) -> f64 {
        // A basis given by hand is orthonormal only within 1e-9, for which 1.74 leaves room.
        1.74 * (self.doubt + DoubleDouble::DOT)
    }

    /// Returns `x u + y v - z w`.
    pub(crate) fn direction(&self, [x, y, z]: Vector<DoubleDouble>) -> Vector<DoubleDouble> {
        std::array::from_fn(|i| x * self.u[i] + y * self.v[i] - z * self.w[i])
    }
}

/// Returns which coordinates of `a x b` are exactly 0 because both of their products are 0, given which
/// coordinates of a and b are 0. Level cameras have such coordinates. A rounded value of 0 would not
/// prove that a coordinate is exactly 0.
fn zeros_of_cross(a: [bool; 3], b: [bool; 3]) -> [bool; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[j, k]| (a[j] || b[k]) && (a[k] || b[j]))
}

/// Returns `(|view x up|, view . up, |view| |up|)`, from which the angle between view and up follows.
/// All three are in units of the same power of two. `|view x up|` is accurate even if it is tiny.
pub(crate) fn angle_terms(view: &ViewGiven, up: DVec3) -> (f64, f64, f64) {
    let (f, quartered) = view.fine();
    let ((f, view_scale), (g, up_scale)) =
        (scaled(f), scaled(up.to_array().map(DoubleDouble::from)));
    let right = bounded::length(bounded::near(bounded::cross(f, g)));
    let lengths = bounded::length(bounded::near(f)) * bounded::length(bounded::near(g));
    let along = bounded::dot(f, g).hi;
    if right > LEAST_SINE * lengths {
        return (right, along, lengths);
    }
    let (square, k) = BigBasis::new(view, up).radicands.b.to_double_double();
    // The root of an even power of two is exact.
    let odd = k.rem_euclid(2);
    let right =
        ldexp(ldexp(square.hi, odd).sqrt(), (k - odd) / 2 - quartered - view_scale - up_scale);
    (right, along, lengths)
}

/// Returns `v / sqrt square`, each coordinate in double-double.
pub(crate) fn over_root(v: &Exact3, square: &Dyadic) -> Vector<DoubleDouble> {
    const DIGITS: i32 = 130;
    let places = DIGITS - square.log2().div_euclid(2);
    let root = square.fixed_root(places);
    v.each_ref().map(|x| {
        let (numerator, exponent) = x.parts();
        let (quotient, k) = ratio(numerator, &root, exponent + places);
        quotient.scaled(k)
    })
}

/// Returns `v / sqrt square`, each coordinate rounded once.
pub fn over_root_rounded(v: &Exact3, square: &Dyadic) -> DVec3 {
    // Adding 0 turns a negative zero into 0.
    DVec3::from_array(over_root(v, square).map(|x| x.hi + 0.0))
}

/// A checked view direction and up vector, neither of which is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Aim {
    pub(crate) view: ViewGiven,
    pub(crate) up: DVec3,
}

impl Aim {
    pub(crate) fn along(view: DVec3, up: DVec3) -> Result<Aim, BasisError> {
        check_finite("view", view)?;
        check_finite("up", up)?;
        if view == DVec3::ZERO {
            return Err(BasisError::ViewIsZero);
        }
        Aim { view: ViewGiven::Along(view), up }.with_up()
    }

    pub(crate) fn from_to(eye: DVec3, at: DVec3, up: DVec3) -> Result<Aim, BasisError> {
        for (field, value) in [("eye", eye), ("at", at), ("up", up)] {
            check_finite(field, value)?;
        }
        if eye == at {
            return Err(BasisError::EyeIsAt { point: eye });
        }
        Aim { view: ViewGiven::Between { from: eye, to: at }, up }.with_up()
    }

    fn with_up(self) -> Result<Aim, BasisError> {
        if self.up == DVec3::ZERO { Err(BasisError::UpIsZero) } else { Ok(self) }
    }

    pub(crate) fn fine_basis(&self) -> Result<FineBasis, BasisError> {
        let Aim { view, up } = *self;
        let parallel = || BasisError::UpParallelToView { up, view: view.rounded() };
        FineBasis::from_view_up(&view, up).ok_or_else(parallel)
    }
}

impl Basis {
    /// Returns the basis of a camera that looks along `view`, level with respect to `up`:
    ///
    /// ```text
    /// w = -view / |view|     u = up x w / |up x w|     v = w x u
    /// ```
    ///
    /// (Marschner, Shirley, *Fundamentals of Computer Graphics*, 4th ed., section 4.3.) `view` and `up`
    /// may have any length without overflow or underflow. Each coordinate of u, v and w is the exact
    /// one, rounded, however small the angle between `view` and `up`. Whether up is parallel to view is
    /// decided exactly.
    ///
    /// # Errors
    /// Returns an error if a value is not finite, a vector is zero, or up is parallel to view.
    pub fn from_view_up(view: DVec3, up: DVec3) -> Result<Basis, BasisError> {
        Ok(Aim::along(view, up)?.fine_basis()?.rounded())
    }

    /// Returns the basis of a camera at `eye` that looks at the point `at`: [`Basis::from_view_up`] with
    /// `view = at - eye`, which is not rounded.
    ///
    /// # Errors
    /// Returns an error if a value is not finite, `eye` is `at`, `up` is zero, or up is parallel to
    /// `at - eye`.
    pub fn from_eye_at_up(eye: DVec3, at: DVec3, up: DVec3) -> Result<Basis, BasisError> {
        Ok(Aim::from_to(eye, at, up)?.fine_basis()?.rounded())
    }
}
