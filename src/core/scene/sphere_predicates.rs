//! A sphere with the values precomputed for all rays from one origin: decides exactly whether a ray hits
//! it, and computes `t`, normals, and the power of the origin, `|center - origin|^2 - r^2`, with its
//! exact sign.

use std::cmp::Ordering;

use glam::DVec3;

use crate::camera::ray::ExactRay;
use crate::exact::big_ray::{BigQuadratic, BigRay, BigRoot};
use crate::exact::bounded::{Number, PLAIN, UNIT, dot, length, near, scaled};
use crate::exact::double_double::{DoubleDouble, U2, difference_with_rest};
use crate::exact::dyadic::exact3;
use crate::exact::precise::{Precise, T_DOUBT, is_noise};
use crate::exact::quadratic::{Form, Quadratic, SphereTerms, SureRoot, sphere_normal};
use crate::exact::scale::ldexp;
use crate::exact::steps::{Step, Steps, sign_by_steps, sign_of};
use crate::exact::surd::Surd;
use crate::scene::big_roots::big_c;
use crate::scene::sphere::{Sphere, SphereQuadratic};

/// One of the two roots of a line and a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RootSide {
    /// The root with the smaller t.
    Near,
    /// The root with the larger t.
    Far,
}

impl RootSide {
    /// Returns the sign of the square root in `t = (b -+ sqrt D) / a`.
    fn sign(self) -> Ordering {
        match self {
            RootSide::Near => Ordering::Less,
            RootSide::Far => Ordering::Greater,
        }
    }
}

/// A sphere with the values precomputed for all rays from one origin. Lengths are in units of `2^scale`.
#[derive(Clone, Debug)]
pub(crate) struct SphereFromOrigin {
    pub(crate) sphere: Sphere,
    pub(crate) fine: SphereTerms<DoubleDouble>,
    pub(crate) rough: SphereTerms<f64>,
    /// The coefficient c in units of `2^(2 scale)`, see [`PointPower::tiny`].
    tiny_c: Option<Precise>,
    pub(crate) scale: i32,
    /// The side on which the origin is: `Less` inside, `Equal` on the sphere, `Greater` outside.
    pub(crate) side: Ordering,
    /// The step that decided the side.
    pub(crate) side_step: Step,
}

impl SphereFromOrigin {
    pub(crate) fn new(sphere: &Sphere, origin: DVec3) -> SphereFromOrigin {
        let (q, rest, quartered) = difference_with_rest(sphere.center, origin);
        let parts: [DoubleDouble; 3] =
            std::array::from_fn(|i| DoubleDouble { hi: q[i], lo: rest[i] });
        let radius = ldexp(sphere.radius, -quartered);
        let (q, radius, scale) = together(parts, radius);
        let rounded = near(q);
        let distance = length(rounded);
        let form = if distance * distance < 2.0 * radius * radius { Form::Near } else { Form::Far };
        let c = PointPower::new(sphere, origin, q, radius, scale + quartered);
        let fine = SphereTerms {
            q,
            radius: DoubleDouble::from(radius),
            c: c.value,
            c_doubt: c.doubt,
            distance,
            q_doubt: 0.0,
            form,
        };
        let rounding = UNIT;
        let rough = SphereTerms {
            q: rounded,
            radius,
            c: c.value.hi,
            c_doubt: c.doubt + rounding,
            distance,
            q_doubt: rounding,
            form,
        };
        let (side, side_step, scale) = (c.sign, c.step, scale + quartered);
        SphereFromOrigin { sphere: *sphere, fine, rough, tiny_c: c.tiny, scale, side, side_step }
    }

    /// Returns the sphere's terms in `f64`. Returns `None` unless the origin is well outside the sphere
    /// and all lengths are far from overflow and underflow.
    pub(crate) fn rough_terms(sphere: &Sphere, origin: DVec3) -> Option<SphereTerms<f64>> {
        let (q, radius) = (sphere.center - origin, sphere.radius);
        let (qq, rr) = (q.length_squared(), radius * radius);
        // If the sphere were nearer, c would lose more than three digits.
        let is_plain = qq > 2.0 * rr && PLAIN.contains(&radius) && qq < PLAIN.end * PLAIN.end;
        is_plain.then(|| SphereTerms {
            q: q.to_array(),
            radius,
            c: qq - rr,
            c_doubt: 8.0 * UNIT * (qq + rr) / (qq - rr),
            distance: qq.sqrt(),
            q_doubt: UNIT,
            form: Form::Far,
        })
    }

    /// Returns whether `f64` alone decides that the ray misses the sphere or hits it after `nearest`.
    /// This settles most spheres for most rays, at a tenth of the cost of a full decision.
    pub(crate) fn is_passed(sphere: &Sphere, ray: &ExactRay, nearest: f64) -> bool {
        /// Maximum relative error of a `t` that may be compared with `nearest`.
        const SHARE: f64 = 1e-6;
        let Some(parts) = SphereFromOrigin::rough_terms(sphere, ray.origin()) else {
            return false;
        };
        let quadratic = Quadratic::new(&parts, &ray.rough);
        let Quadratic { b, discriminant, b_doubt, discriminant_doubt, .. } = quadratic;
        if discriminant < -discriminant_doubt || b < -b_doubt {
            return true;
        }
        let is_behind =
            |(t, off): (f64, f64)| off < SHARE && t * ray.stretch * (1.0 - 4.0 * SHARE) > nearest;
        ray.scale == 0 && b > b_doubt && quadratic.root(&parts, false).is_some_and(is_behind)
    }

    /// Returns the sign of the discriminant D: `Less` if the ray's line misses the sphere, `Equal` if it
    /// touches it, `Greater` if it crosses it.
    pub(crate) fn meets(&self, ray: &ExactRay, steps: &mut Steps) -> Ordering {
        if self.side == Ordering::Less {
            steps.count(Step::F64);
            return Ordering::Greater;
        }
        let (sign, step) = sign_by_steps(
            discriminant_of(&Quadratic::new(&self.rough, &ray.rough)),
            || discriminant_of(&Quadratic::new(&self.fine, &ray.fine)),
            || self.exact_sign(ray, |quadratic| quadratic.discriminant),
        );
        steps.count(step);
        sign
    }

    /// Returns the sign of `b = q.d`, for a line that meets the sphere: `Greater` if the centre lies
    /// ahead of the origin.
    fn ahead(&self, ray: &ExactRay, steps: &mut Steps) -> Ordering {
        let (sign, step) = sign_by_steps(
            self.rough.ahead(&ray.rough),
            || self.fine.ahead(&ray.fine),
            || self.exact_sign(ray, |quadratic| quadratic.b),
        );
        if step > Step::F64 {
            steps.count(step);
        }
        sign
    }

    /// Returns the sign of a coefficient, in exact numbers.
    fn exact_sign(&self, ray: &ExactRay, of: fn(BigQuadratic) -> Surd) -> Ordering {
        let big = ray.big();
        of(big.quadratic(&self.sphere)).sign(&big.radicands)
    }

    /// Finds the ray's first hit, the root with the smallest `t > 0`. Returns `None` if there is none.
    pub(crate) fn first_root(&self, ray: &ExactRay, steps: &mut Steps) -> Option<RootSide> {
        if self.side == Ordering::Less {
            steps.count(Step::F64);
            return Some(RootSide::Far);
        }
        if self.side == Ordering::Equal {
            // Every line through a point of the sphere meets it.
            steps.count(Step::F64);
        } else if self.meets(ray, steps) == Ordering::Less {
            return None;
        }
        (self.ahead(ray, steps) == Ordering::Greater).then(|| self.root_of_hit())
    }

    /// Returns the root at which any ray that hits the sphere hits it first: the far one if the origin
    /// is inside or on the sphere, otherwise the near one.
    pub(crate) fn root_of_hit(&self) -> RootSide {
        if self.side == Ordering::Greater { RootSide::Near } else { RootSide::Far }
    }

    /// Returns `t` at a root of a line that meets the sphere, with a relative error of at most `doubt`,
    /// and the step that computed it.
    pub(crate) fn t(&self, ray: &ExactRay, root: RootSide, doubt: f64) -> (Precise, Step) {
        if self.side == Ordering::Equal && self.is_origin(ray, root) {
            return (Precise::ZERO, Step::DoubleDouble);
        }
        if let Some(Precise { value, scale }) = self.fine_t(ray, root, doubt) {
            let t = Precise::new(value.times(ray.stretch), scale + self.scale - ray.scale);
            return (t, Step::DoubleDouble);
        }
        let big = ray.big();
        (big.t(&self.big_root(&big, root)), Step::Exact)
    }

    /// Returns `t` at a root of a line that meets the sphere, rounded to the nearest `f64`. Returns
    /// `None` if double-double does not suffice to decide which `f64` that is.
    pub(crate) fn rounded_t(&self, ray: &ExactRay, root: RootSide) -> Option<f64> {
        if self.side == Ordering::Equal {
            return None;
        }
        let (Precise { value, scale }, off) = self.fine_root(ray, root)?;
        let off = off * value.hi.abs() * ray.stretch;
        let t = value.times(ray.stretch);
        let rounded = ldexp(t.hi, scale + self.scale - ray.scale);
        let is_normal = rounded.is_finite() && rounded.abs() > f64::MIN_POSITIVE;
        (t.rounds_surely(off) && is_normal).then_some(rounded)
    }

    /// Returns whether a root is the origin itself. For an origin on the sphere, the roots are 0 and
    /// `2 b / a`.
    fn is_origin(&self, ray: &ExactRay, root: RootSide) -> bool {
        match self.ahead(ray, &mut Steps::default()) {
            Ordering::Equal => true,
            Ordering::Greater => root == RootSide::Near,
            Ordering::Less => root == RootSide::Far,
        }
    }

    /// Returns `t` in double-double, in units of `stretch 2^(scale of the sphere - scale of the ray)`,
    /// where `stretch` is the factor of the ray's direction; `None` if the relative error of `t` is
    /// above `doubt`.
    fn fine_t(&self, ray: &ExactRay, root: RootSide, doubt: f64) -> Option<Precise> {
        let (t, off) = self.fine_root(ray, root)?;
        (off <= doubt).then_some(t)
    }

    /// Returns `t` in double-double and its relative error, in the units of
    /// [`SphereFromOrigin::fine_t`]; `None` if the discriminant may be 0, or if t is so small or large
    /// that it loses digits.
    fn fine_root(&self, ray: &ExactRay, root: RootSide) -> Option<(Precise, f64)> {
        let (quadratic, is_far) = (Quadratic::new(&self.fine, &ray.fine), root == RootSide::Far);
        let (t, off, scale) = match self.tiny_c {
            // t = c / z
            Some(Precise { value: c, scale }) if quadratic.is_of_c(is_far) => {
                let fine = SphereTerms { c, c_doubt: 2.0 * U2, ..self.fine };
                let (t, off) = quadratic.root(&fine, is_far)?;
                (t, off, scale)
            }
            _ => {
                let (t, off) = quadratic.root(&self.fine, is_far)?;
                (t, off, 0)
            }
        };
        (1e-250..1e250).contains(&t.hi.abs()).then_some((Precise::new(t, scale), off))
    }

    /// Returns the root at which a ray that hits the sphere hits it first, in double-double, in the units
    /// of [`SphereFromOrigin::fine_t`]; `None` for an origin on the sphere, where no order depends on it.
    pub(crate) fn fine_hit(&self, ray: &ExactRay) -> Option<SureRoot<DoubleDouble>> {
        if self.side == Ordering::Equal {
            return None;
        }
        let is_far = self.root_of_hit() == RootSide::Far;
        Quadratic::new(&self.fine, &ray.fine).sure_root(&self.fine, is_far)
    }

    /// Returns the root in exact numbers.
    pub(crate) fn big_root(&self, ray: &BigRay, root: RootSide) -> BigRoot {
        let BigQuadratic { b, discriminant } = ray.quadratic(&self.sphere);
        BigRoot { x: b, sign: root.sign(), radicand: discriminant, y: None }
    }

    /// Returns the outward unit normal where the ray meets the sphere: `(t d - q) / r`, within 3e-16
    /// rad.
    pub(crate) fn normal(&self, ray: &ExactRay, root: RootSide) -> DVec3 {
        // The error of t d is relative to its length, which is about |q|. The smaller the radius is
        // compared with that length, the smaller the error must be.
        let reach = self.fine.distance + self.fine.radius.hi;
        let is_enough =
            (T_DOUBT + ray.fine.doubt + 16.0 * U2) * reach < 1e-17 * self.fine.radius.hi;
        let t = match self.fine_t(ray, root, T_DOUBT) {
            Some(t) if is_enough => t.value.scaled(t.scale),
            _ if self.side == Ordering::Equal && self.is_origin(ray, root) => {
                DoubleDouble::from(0.0)
            }
            _ => {
                let big = ray.big();
                return big.sphere_normal(&self.sphere, &self.big_root(&big, root));
            }
        };
        let normal = sphere_normal(self.fine.q, &ray.fine, t);
        DVec3::from_array(std::array::from_fn(|i| {
            let is_noise = is_noise(normal[i] * self.fine.radius.hi, self.fine.q[i].hi);
            if is_noise { 0.0 } else { normal[i] }
        }))
    }

    /// Returns the quadratic's coefficients, rounded, in units of the ray's and the sphere's scales. D
    /// has its exact sign, and is 0 only if it is exactly 0.
    pub(crate) fn quadratic(&self, ray: &ExactRay) -> (f64, f64, f64, f64) {
        let fine = Quadratic::new(&self.fine, &ray.fine);
        let discriminant = match self.meets(ray, &mut Steps::default()) {
            Ordering::Equal => 0.0,
            Ordering::Greater => fine.discriminant.hi.max(f64::MIN_POSITIVE),
            Ordering::Less => fine.discriminant.hi.min(-f64::MIN_POSITIVE),
        };
        (fine.a.hi, fine.b.hi, self.fine.c.hi, discriminant)
    }
}

/// Returns the discriminant and the bound of its error.
fn discriminant_of<T: Number>(quadratic: &Quadratic<T>) -> (T, f64) {
    (quadratic.discriminant, quadratic.discriminant_doubt)
}

/// Scales q and r by a common power of two. Returns them in units of `2^k`, and k, which is 0 unless the
/// lengths are extreme.
fn together(q: [DoubleDouble; 3], radius: f64) -> ([DoubleDouble; 3], f64, i32) {
    let largest = q.iter().map(|x| x.hi.abs()).fold(radius, f64::max);
    if PLAIN.contains(&largest) {
        return (q, radius, 0);
    }
    let with_radius =
        [DoubleDouble::from(largest), DoubleDouble::default(), DoubleDouble::default()];
    let (_, k) = scaled(with_radius);
    let by = |x: f64| ldexp(x, -k);
    (q.map(|x| DoubleDouble { hi: by(x.hi), lo: by(x.lo) }), by(radius), k)
}

impl Sphere {
    /// Returns the implicit function `f(q) = |q - center|^2 - r^2`: 0 on the sphere, negative inside;
    /// its sign is exact. It is in squared world units. It is infinite if it overflows, and NaN if a
    /// number is not finite or the radius is not positive.
    pub fn implicit(&self, q: DVec3) -> f64 {
        if self.check().is_err() || !q.is_finite() {
            return f64::NAN;
        }
        let seen = SphereFromOrigin::new(self, q);
        ldexp(seen.fine.c.hi, 2 * seen.scale)
    }

    /// Returns the quadratic's coefficients for display, each rounded once from more digits. They may
    /// overflow or underflow even if the roots do not. For an invalid sphere, they are NaN.
    pub fn quadratic_of(&self, ray: &ExactRay) -> SphereQuadratic {
        if self.check().is_err() {
            let none = f64::NAN;
            return SphereQuadratic { a: none, b: none, c: none, discriminant: none };
        }
        let seen = SphereFromOrigin::new(self, ray.origin());
        let (a, b, c, discriminant) = seen.quadratic(ray);
        let (k, stretch) = (ray.scale, ray.stretch);
        let scaled = ldexp(discriminant / stretch / stretch, 2 * (k + seen.scale));
        // A value that underflows keeps its sign.
        let least = if discriminant == 0.0 { 0.0 } else { f64::from_bits(1) };
        SphereQuadratic {
            a: ldexp(a / stretch / stretch, 2 * k),
            b: 0.0 - ldexp(b / stretch, k + seen.scale),
            c: ldexp(c, 2 * seen.scale),
            discriminant: scaled.abs().max(least).copysign(discriminant),
        }
    }
}

/// Error of `c = |q|^2 - r^2` in `f64`, relative to `|q|^2 + r^2`: 6 roundings, plus twice the rounding
/// of q itself.
pub(crate) const ROUGH_SHARE: f64 = 8.0 * UNIT;

/// Error of `c = |q|^2 - r^2` in double-double, relative to `|q|^2 + r^2`; r^2 is exact.
pub(crate) const FINE_SHARE: f64 = DoubleDouble::DOT + DoubleDouble::SUM;

/// The power of a point with respect to a sphere, with its exact sign: `c = |q|^2 - r^2`, where q is the
/// vector from the point to the sphere's centre.
pub(crate) struct PointPower {
    pub(crate) value: DoubleDouble,
    /// Relative error.
    pub(crate) doubt: f64,
    /// The value with its own exponent, if it is so small that its sums and products would lose
    /// digits to underflow; otherwise `None`.
    pub(crate) tiny: Option<Precise>,
    pub(crate) sign: Ordering,
    /// The step that decided the sign.
    pub(crate) step: Step,
}

impl PointPower {
    /// Computes the power from q and r in units of `2^scale`: in double-double if that keeps enough
    /// digits, otherwise in exact numbers. Close to the sphere, c is a small difference of large
    /// squares.
    pub(crate) fn new(
        sphere: &Sphere,
        origin: DVec3,
        q: [DoubleDouble; 3],
        radius: f64,
        scale: i32,
    ) -> PointPower {
        /// The relative error of c above which t would lose digits.
        const PLENTY: f64 = 256.0 * U2;
        /// The size above which a value loses no digits to underflow.
        const TINY: f64 = 1e-200;
        let fine_radius = DoubleDouble::from(radius);
        let (qq, rr) = (dot(q, q), fine_radius * fine_radius);
        let value = qq - rr;
        let squares = qq.hi + rr.hi;
        let doubt = FINE_SHARE * squares / value.hi.abs();
        let is_sure = value.hi.abs() > ROUGH_SHARE * squares && value.hi.abs() > TINY;
        let step = if is_sure { Step::F64 } else { Step::DoubleDouble };
        if doubt <= PLENTY && value.hi.abs() > TINY {
            return PointPower {
                value,
                doubt: 1.05 * doubt,
                tiny: None,
                sign: sign_of(value.hi),
                step,
            };
        }
        let exact = big_c(sphere, &exact3(origin));
        // The sign may be certain even if c has to be computed exactly.
        let step = if doubt < 0.5 && value.hi.abs() > TINY { step } else { Step::Exact };
        let sign = exact.sign();
        let (mantissa, k) = exact.to_double_double();
        let k = k - 2 * scale;
        let value = mantissa.scaled(k);
        if sign == Ordering::Equal || value.hi.abs() > TINY {
            return PointPower { value, doubt: 2.0 * U2, tiny: None, sign, step };
        }
        // D is accurate enough even with an error in c as large as c itself.
        PointPower { value, doubt: 1.0, tiny: Some(Precise::new(mantissa, k)), sign, step }
    }
}
