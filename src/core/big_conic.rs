//! The coefficients of a sphere's outline from exact numbers.

use num_bigint::BigInt;

use crate::conic::{Conic, Patch};
use crate::double_double::DoubleDouble;
use crate::exact::{Dyadic, Exact3, big_of, dot, ratio};
use crate::scale::ldexp;
use crate::sphere::Sphere;
use crate::surd::{Radicands, Surd};

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

    /// The polynomials of a sphere around the patch's middle, each coefficient rounded once; q and
    /// c in units of `2^scale`, directions of `2^ray_scale`.
    pub(crate) fn conic(
        &self,
        sphere: &Sphere,
        patch: &Patch,
        scale: i32,
        ray_scale: i32,
    ) -> Conic<DoubleDouble> {
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
        Conic::of_coefficients(
            array(near(&a, &squared_scale, -2 * ray_scale)),
            array(near(&b, &self.scale, -ray_scale - scale)),
            array(near(&discriminant, &squared_scale, -2 * (ray_scale + scale))),
            patch,
        )
    }

    /// Each `x / by * 2^k`, off by at most `2^-105` of itself and `2^-150` of the largest.
    fn rounded(&self, x: &[Surd], by: &Surd, k: i32) -> Vec<DoubleDouble> {
        const DIGITS: i32 = 320;
        let bound = |x: &Surd| x.log2_bound(&self.of);
        let places = DIGITS - x.iter().map(bound).max().unwrap_or_default();
        let by_places = DIGITS - bound(by);
        let by = by.fixed(by_places, &self.of);
        let round = |x: &Surd| {
            let numerator: BigInt = x.fixed(places, &self.of);
            let (value, exponent) = ratio(&numerator, &by, by_places - places + k);
            DoubleDouble { hi: ldexp(value.hi, exponent), lo: ldexp(value.lo, exponent) }
        };
        x.iter().map(round).collect()
    }
}

fn array<const N: usize>(x: Vec<DoubleDouble>) -> [DoubleDouble; N] {
    std::array::from_fn(|i| x.get(i).copied().unwrap_or_default())
}

/// Direction parts from their exact factors.
pub(crate) fn surds(parts: &Exact3, root: usize) -> [Surd; 3] {
    std::array::from_fn(|i| {
        let mut surd = Surd::zero();
        surd.0[root] = parts[i].clone();
        surd
    })
}

/// The exact number of a product of two `f64`.
pub(crate) fn product(a: f64, b: f64) -> Dyadic {
    &big_of(a) * &big_of(b)
}
