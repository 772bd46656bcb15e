//! Exact arithmetic with numbers of the form `p + q sqrt(A) + r sqrt(B) + s sqrt(A B)`, where p, q, r,
//! s are exact binary numbers, and how their signs are found.
//!
//! A camera's basis contains the square roots of two numbers, `A = |up x w|^2` and `B = |view|^2` (see
//! [`crate::Camera`]). Sums, differences and products of numbers of this form have the same form, and
//! are exact. For a ray that is given directly by its origin and direction, no roots occur: all numbers
//! are just `p`, and A = B = 1.
//!
//! # Signs
//! [`Field::sign`] first evaluates the number in interval arithmetic with increasing precision. An
//! interval that does not contain 0 proves the sign.
//!
//! If this does not decide the sign, which it never does for an exact zero, algebra does. Let the
//! number be `x + y sqrt(B)`, where x and y contain no root but `sqrt(A)`. If x and y have the same
//! sign, so has the number. If they have opposite signs, the sign of `x + y sqrt(B)` is that of x if
//! `x^2 > y^2 B`, that of y if `x^2 < y^2 B`, and 0 if `x^2 = y^2 B`; and `x^2 - y^2 B` contains one
//! root less, so that its sign is found in the same way. This requires no bound on how close to 0 a
//! number can be. (Root separation gives such bounds: see Yap, *Fundamental Problems of Algorithmic
//! Algebra*, 2000, ch. 6. For signs by repeated squaring, see Boissonnat and Snoeyink, *Efficient
//! algorithms for line and curve segment intersection using restricted predicates*, 1999.)

use std::cmp::Ordering;
use std::sync::OnceLock;

use crate::dyadic::{Dyadic, Vector};
use crate::interval::Interval;

/// The number `p + q sqrt(A) + r sqrt(B) + s sqrt(A B)`, stored as p, q, r, s.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Surd(pub(crate) [Dyadic; 4]);

impl Surd {
    pub(crate) const ZERO: Surd = Surd([const { Dyadic::ZERO }; 4]);

    pub(crate) fn rational(p: Dyadic) -> Surd {
        Surd([p, Dyadic::ZERO, Dyadic::ZERO, Dyadic::ZERO])
    }

    /// Returns `p` times the root with this index in [`Surd`].
    pub(crate) fn with_root(p: Dyadic, index: usize) -> Surd {
        let mut surd = Surd::ZERO;
        surd.0[index] = p;
        surd
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.iter().all(Dyadic::is_zero)
    }

    pub(crate) fn plus(&self, other: &Surd) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] + &other.0[i]))
    }

    pub(crate) fn minus(&self, other: &Surd) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] - &other.0[i]))
    }

    pub(crate) fn negated(&self) -> Surd {
        Surd(std::array::from_fn(|i| -&self.0[i]))
    }

    pub(crate) fn scaled(&self, factor: &Dyadic) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] * factor))
    }

    pub(crate) fn dot(vector: &[Surd; 3], other: &Vector) -> Surd {
        let [x, y, z] = std::array::from_fn(|i| vector[i].scaled(&other[i]));
        x.plus(&y).plus(&z)
    }
}

/// Returns the number of significant bits that interval arithmetic uses at a level of precision,
/// counted from 0. Each level has four times the bits of the one before.
pub(crate) fn bits_of_level(level: usize) -> usize {
    160 << (2 * level)
}

/// Number of levels of precision that interval arithmetic tries to find a sign before algebra decides
/// it.
const SIGN_LEVELS: usize = 3;

/// Number of levels of precision. The square roots of A, B and A B are cached for each of them. The
/// last level uses about 1.7e11 bits, which is more than is ever needed.
const LEVELS: usize = 16;

/// The numbers A and B of [`Surd`], which are positive.
#[derive(Debug)]
pub(crate) struct Field {
    a: Dyadic,
    b: Dyadic,
    ab: Dyadic,
    roots: [OnceLock<[Interval; 3]>; LEVELS],
}

impl Field {
    pub(crate) fn new(a: Dyadic, b: Dyadic) -> Field {
        let ab = &a * &b;
        Field { a, b, ab, roots: Default::default() }
    }

    /// Returns the field with A = B = 1, which contains no irrational numbers.
    pub(crate) fn rational() -> Field {
        Field::new(Dyadic::power_of_two(0), Dyadic::power_of_two(0))
    }

    pub(crate) fn times(&self, x: &Surd, y: &Surd) -> Surd {
        let (x, y) = (&x.0, &y.0);
        let pair = |i: usize, j: usize| {
            let product = &x[i] * &y[j];
            if i == j { product } else { &product + &(&x[j] * &y[i]) }
        };
        let Field { a, b, ab, .. } = self;
        Surd([
            &(&pair(0, 0) + &(a * &pair(1, 1))) + &(&(b * &pair(2, 2)) + &(ab * &pair(3, 3))),
            &pair(0, 1) + &(b * &pair(2, 3)),
            &pair(0, 2) + &(a * &pair(1, 3)),
            &pair(0, 3) + &pair(1, 2),
        ])
    }

    pub(crate) fn square(&self, x: &Surd) -> Surd {
        self.times(x, x)
    }

    pub(crate) fn dot(&self, x: &[Surd; 3], y: &[Surd; 3]) -> Surd {
        let [a, b, c] = std::array::from_fn(|i| self.times(&x[i], &y[i]));
        a.plus(&b).plus(&c)
    }

    /// Returns an interval around `x`, computed with the number of bits of this level (see
    /// [`bits_of_level`]).
    pub(crate) fn interval(&self, x: &Surd, level: usize) -> Interval {
        let bits = bits_of_level(level);
        let mut sum = Interval::exactly(&x.0[0], bits);
        if x.0[1..].iter().all(Dyadic::is_zero) {
            return sum;
        }
        let roots = self.roots[level].get_or_init(|| {
            let sqrt = |x: &Dyadic| Interval { low: x.clone(), high: x.clone() }.sqrt(bits);
            [&self.a, &self.b, &self.ab].map(sqrt)
        });
        for (factor, root) in x.0[1..].iter().zip(roots) {
            if !factor.is_zero() {
                sum = sum.plus(&Interval::exactly(factor, bits).times(root, bits), bits);
            }
        }
        sum
    }

    /// Returns the proven sign of `x`; see the [module's documentation](self).
    pub(crate) fn sign(&self, x: &Surd) -> Ordering {
        if x.0[1..].iter().all(Dyadic::is_zero) {
            return x.0[0].sign();
        }
        let found = (0..SIGN_LEVELS).find_map(|level| self.interval(x, level).sign());
        found.unwrap_or_else(|| self.sign_by_algebra(x))
    }

    /// Returns the sign of `(p + q sqrt A) + (r + s sqrt A) sqrt B`, which is found by squaring alone.
    pub(crate) fn sign_by_algebra(&self, x: &Surd) -> Ordering {
        let [p, q, r, s] = &x.0;
        let (a, b) = (&self.a, &self.b);
        sign_of_sum(sign_with_root(p, q, a), sign_with_root(r, s, a), || {
            let square =
                &(&p.square() + &(a * &q.square())) - &(b * &(&r.square() + &(a * &s.square())));
            let root = (&(p * q) - &(b * &(r * s))).shifted(1);
            sign_with_root(&square, &root, a)
        })
    }
}

/// Returns the sign of `x + y` from the signs of x and y. `squares` returns the sign of `x^2 - y^2`,
/// which is needed if the signs are opposite.
pub(crate) fn sign_of_sum(
    x: Ordering,
    y: Ordering,
    squares: impl FnOnce() -> Ordering,
) -> Ordering {
    if x == y || y == Ordering::Equal {
        x
    } else if x == Ordering::Equal {
        y
    } else {
        product(x, squares())
    }
}

/// Returns the sign of `p + q sqrt(a)`. `a` must be positive.
fn sign_with_root(p: &Dyadic, q: &Dyadic, a: &Dyadic) -> Ordering {
    sign_of_sum(p.sign(), q.sign(), || (&p.square() - &(a * &q.square())).sign())
}

/// Returns the sign of a product from the signs of its factors.
pub(crate) fn product(x: Ordering, y: Ordering) -> Ordering {
    match x {
        Ordering::Greater => y,
        Ordering::Equal => x,
        Ordering::Less => y.reverse(),
    }
}
