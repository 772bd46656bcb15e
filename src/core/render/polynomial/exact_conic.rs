//! The coefficients of a sphere's outline from exact numbers.

use std::cmp::Ordering;

use glam::DVec3;
use num_bigint::{BigInt, Sign};

use crate::camera::fine_basis::BigBasis;
use crate::camera::resolved::{AimGiven, PosedCamera};
use crate::camera::viewport::Viewport;
use crate::exact::double_double::DoubleDouble;
use crate::exact::dyadic::{Dyadic, Exact3, big_of, dot, exact3, ratio, times};
use crate::exact::precise::Precise;
use crate::exact::surd::{Radicands, Surd};
use crate::render::polynomial::conic::Conic;
use crate::render::polynomial::frame_rays::Patch;
use crate::scene::sphere::Sphere;

/// A frame's view rays in exact numbers: with whole numbers n and l, the direction times `scale` is
/// `n e + l g + z`.
#[derive(Clone, Debug)]
pub(crate) struct BigSteppers {
    pub(crate) eye: Exact3,
    pub(crate) e: [Surd; 3],
    pub(crate) g: [Surd; 3],
    pub(crate) z: [Surd; 3],
    pub(crate) scale: Surd,
    pub(crate) of: Radicands,
}

impl BigSteppers {
    fn dot(&self, a: &[Surd; 3], b: &[Surd; 3]) -> Surd {
        let terms: [Surd; 3] = std::array::from_fn(|i| a[i].times(&b[i], &self.of));
        &(&terms[0] + &terms[1]) + &terms[2]
    }

    /// The polynomials of a sphere around the patch's middle, each coefficient rounded once (q and
    /// c in units of `2^scale`, directions of `2^ray_scale`), and its nearer root in fixed point.
    pub(crate) fn conic(
        &self,
        sphere: &Sphere,
        patch: &Patch,
        scale: i32,
        ray_scale: i32,
    ) -> (Conic<DoubleDouble>, BigNearRoot) {
        let q: Exact3 = std::array::from_fn(|i| &big_of(sphere.center[i]) - &self.eye[i]);
        let c = &dot(&q, &q) - &big_of(sphere.radius).square();
        let (n, l) = (big_of(patch.n), big_of(patch.l));
        let middle: [Surd; 3] =
            std::array::from_fn(|i| &(&self.e[i].scaled(&n) + &self.g[i].scaled(&l)) + &self.z[i]);
        let vectors = [&middle, &self.e, &self.g];
        let along = |v: &[Surd; 3]| {
            let terms: [Surd; 3] = std::array::from_fn(|i| v[i].scaled(&q[i]));
            &(&terms[0] + &terms[1]) + &terms[2]
        };
        let b = vectors.map(along);
        let two = big_of(2.0);
        let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
        let doubled = |x: Surd, (i, j): (usize, usize)| if i == j { x } else { x.scaled(&two) };
        let a = pairs.map(|(i, j)| doubled(self.dot(vectors[i], vectors[j]), (i, j)));
        let discriminant: [Surd; 6] = std::array::from_fn(|k| {
            let (i, j) = pairs[k];
            &doubled(b[i].times(&b[j], &self.of), (i, j)) - &a[k].scaled(&c)
        });
        let squared_scale = self.scale.square(&self.of);
        let near = |x: &[Surd], by: &Surd, k: i32| self.rounded(x, by, k);
        let conic = Conic::of_coefficients(
            array(near(&a, &squared_scale, -2 * ray_scale)),
            array(near(&b, &self.scale, -ray_scale - scale)),
            array(near(&discriminant, &squared_scale, -2 * (ray_scale + scale))),
            patch,
        );
        // D in twice the places of b, so that its root has b's.
        let (_, d_places) = self.fixed(&discriminant);
        let places = d_places.div_euclid(2);
        let whole = |x: &[Surd], places| x.iter().map(|x| x.fixed(places, &self.of)).collect();
        let (scale, scale_places) = self.fixed(std::slice::from_ref(&self.scale));
        let root = BigNearRoot {
            b: whole(&b, places),
            discriminant: whole(&discriminant, 2 * places),
            c: c.parts().0 * &scale[0],
            c_exponent: c.parts().1 - scale_places + places,
        };
        (conic, root)
    }

    /// Fixed-point numbers, each off by less than 4, and their places: the largest has at least 280
    /// bits, so that no cancellation takes away what it is good for.
    fn fixed(&self, x: &[Surd]) -> (Vec<BigInt>, i32) {
        const LEAST: i32 = 280;
        let bound = x.iter().map(|x| x.log2_bound(&self.of)).max().unwrap_or_default();
        let mut places = LEAST + 40 - bound;
        // A bound can be far above what cancels; numbers that are all 0 have no digits to find.
        for _ in 0..64 {
            let found: Vec<BigInt> = x.iter().map(|x| x.fixed(places, &self.of)).collect();
            let bits = found.iter().map(BigInt::bits).max().unwrap_or_default() as i32;
            if bits >= LEAST {
                return (found, places);
            }
            places += LEAST + 40 - bits;
        }
        (vec![BigInt::ZERO; x.len()], places)
    }

    /// Each `x / by * 2^k`, off by at most `2^-105` of itself: each has its own places, because what
    /// is small beside the others may be all that a patch of one row or column has.
    fn rounded(&self, x: &[Surd], by: &Surd, k: i32) -> Vec<DoubleDouble> {
        let (by, by_places) = self.fixed(std::slice::from_ref(by));
        let round = |x: &Surd| {
            if x.sign(&self.of) == Ordering::Equal {
                return DoubleDouble::default();
            }
            let (numerator, places) = self.fixed(std::slice::from_ref(x));
            let (value, exponent) = ratio(&numerator[0], &by[0], by_places - places + k);
            value.scaled(exponent)
        };
        x.iter().map(round).collect()
    }
}

/// A sphere's nearer root as a polynomial over the patch's pixels, in fixed point: what a pixel in
/// doubt about its `t` alone costs a microsecond by.
#[derive(Clone, Debug)]
pub(crate) struct BigNearRoot {
    b: Vec<BigInt>,
    discriminant: Vec<BigInt>,
    /// `c` times the directions' scale, in units of `2^c_exponent / 2^places`.
    c: BigInt,
    c_exponent: i32,
}

impl BigNearRoot {
    /// `t` per stretch, m columns and k rows from the middle: `c / (b + sqrt D)` with a relative
    /// error of at most `2^-100`; `None` where D or b has too few digits left, or is not positive.
    pub(crate) fn t(&self, m: f64, k: f64) -> Option<Precise> {
        // Coefficients are off by 4, and m and k below 2^16: b is off by less than 2^20, D by 2^37.
        const DIGITS: u64 = 104;
        let (m, k) = (m as i64, k as i64);
        let [b0, b1, b2] = &self.b[..] else { return None };
        let [d0, d1, d2, d11, d12, d22] = &self.discriminant[..] else { return None };
        let b = b0 + b1 * m + b2 * k;
        let discriminant = d0 + (d1 + d11 * m + d12 * k) * m + (d2 + d22 * k) * k;
        let is_enough = b.sign() == Sign::Plus
            && discriminant.sign() == Sign::Plus
            && discriminant.bits() >= 37 + DIGITS;
        if !is_enough {
            return None;
        }
        let z = b + discriminant.sqrt();
        (z.bits() >= 21 + DIGITS).then(|| {
            let (value, exponent) = ratio(&self.c, &z, self.c_exponent);
            Precise::new(value, exponent)
        })
    }
}

fn array<const N: usize>(x: Vec<DoubleDouble>) -> [DoubleDouble; N] {
    std::array::from_fn(|i| x.get(i).copied().unwrap_or_default())
}

/// Direction parts from their exact factors.
fn surds(parts: &Exact3, root: usize) -> [Surd; 3] {
    std::array::from_fn(|i| {
        let mut surd = Surd::zero();
        surd.0[root] = parts[i].clone();
        surd
    })
}

/// The exact number of a product of two `f64`.
fn product(a: f64, b: f64) -> Dyadic {
    &big_of(a) * &big_of(b)
}

impl PosedCamera {
    /// All of a frame's view rays in exact numbers.
    pub(crate) fn big_steppers(&self) -> BigSteppers {
        let Viewport { width, height, distance } = *self.viewport();
        let (w, h) = (f64::from(self.image().width()), f64::from(self.image().height()));
        let (x, y, z) = (product(width, h), product(height, w), product(distance, 2.0 * w * h));
        let eye = exact3(self.eye());
        match self.aim() {
            AimGiven::ViewUp(view, up) => {
                let BigBasis { view, right, upward, of } = BigBasis::new(&view, up);
                let (e, g) = (surds(&times(&right, &x), 1), surds(&times(&upward, &y), 0));
                let z = surds(&times(&view, &z), 2);
                BigSteppers { eye, e, g, z, scale: Radicands::root_of_product(), of }
            }
            AimGiven::Basis => {
                let along = |v: DVec3, x: &Dyadic| surds(&times(&exact3(v), x), 0);
                let (e, g) = (along(self.basis().u, &x), along(self.basis().v, &y));
                let z = along(-self.basis().w, &z);
                let (scale, of) = (Surd::from(Dyadic::from(1.0)), Radicands::none());
                BigSteppers { eye, e, g, z, scale, of }
            }
        }
    }
}
