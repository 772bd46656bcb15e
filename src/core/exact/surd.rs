//! Exact numbers that contain two square roots. The coordinates of a view ray's direction have this
//! form.

use std::cmp::Ordering;
use std::ops::{Add, Neg, Sub};

use num_bigint::BigInt;

use crate::exact::dyadic::Dyadic;

/// The two numbers under the square roots of a [`Surd`]: A and B, which are positive. For a camera's
/// view rays, `A = |view|^2` and `B = |view x up|^2`.
#[derive(Clone, Debug)]
pub(crate) struct Radicands {
    pub(crate) a: Dyadic,
    pub(crate) b: Dyadic,
    ab: Dyadic,
}

impl Radicands {
    pub(crate) fn new(a: Dyadic, b: Dyadic) -> Radicands {
        let ab = &a * &b;
        Radicands { a, b, ab }
    }

    /// Returns the radicands of numbers without roots.
    pub(crate) fn none() -> Radicands {
        Radicands::new(Dyadic::from(1.0), Dyadic::from(1.0))
    }

    /// Returns `sqrt(A B)`.
    pub(crate) fn root_of_product() -> Surd {
        let zero = Dyadic::zero;
        Surd([zero(), zero(), zero(), Dyadic::from(1.0)])
    }
}

/// The number `x0 + x1 sqrt A + x2 sqrt B + x3 sqrt(A B)`. The [`Radicands`] A and B are stored
/// separately.
#[derive(Clone, Debug)]
pub(crate) struct Surd(pub(crate) [Dyadic; 4]);

impl From<Dyadic> for Surd {
    fn from(x: Dyadic) -> Surd {
        let zero = Dyadic::zero;
        Surd([x, zero(), zero(), zero()])
    }
}

impl Surd {
    pub(crate) fn zero() -> Surd {
        Surd::from(Dyadic::zero())
    }

    /// Returns the product, using `sqrt A sqrt A = A` and `sqrt B sqrt B = B`; coefficients of 0 are
    /// skipped.
    pub(crate) fn times(&self, other: &Surd, radicands: &Radicands) -> Surd {
        /// Returns the radicand by which the product of coefficients i and j is multiplied: the product
        /// of the numbers whose roots both terms contain. Bit 0 of an index stands for `sqrt A`, bit 1
        /// for `sqrt B`. Returns `None` if the terms share no root.
        fn factor(i: usize, j: usize, radicands: &Radicands) -> Option<&Dyadic> {
            match i & j {
                0 => None,
                1 => Some(&radicands.a),
                2 => Some(&radicands.b),
                _ => Some(&radicands.ab),
            }
        }
        let mut product = Surd::zero();
        for i in 0..4 {
            for j in 0..4 {
                let (x, y) = (&self.0[i], &other.0[j]);
                if x.is_zero() || y.is_zero() {
                    continue;
                }
                let term = x * y;
                let term = match factor(i, j, radicands) {
                    Some(radicand) => &term * radicand,
                    None => term,
                };
                product.0[i ^ j] = &product.0[i ^ j] + &term;
            }
        }
        product
    }

    /// Returns `x^2`.
    pub(crate) fn square(&self, radicands: &Radicands) -> Surd {
        self.times(self, radicands)
    }

    /// Returns the product with an exact number.
    pub(crate) fn scaled(&self, y: &Dyadic) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] * y))
    }

    /// Returns the sign, decided exactly.
    ///
    /// The number is `x + y sqrt B`, where x and y are numbers `p + q sqrt A`. If x and y have the same
    /// sign, that is the result. Otherwise the result is the sign of x if `x^2 > y^2 B`, and that of y
    /// if not. The signs of x and y follow in the same way from exact numbers.
    pub(crate) fn sign(&self, radicands: &Radicands) -> Ordering {
        let [x0, x1, y0, y1] = &self.0;
        let (x, y) = (sign_with_root(x0, x1, &radicands.a), sign_with_root(y0, y1, &radicands.a));
        larger_of(x, y, || {
            // x^2 - y^2 B, again p + q sqrt A.
            let square = |p: &Dyadic, q: &Dyadic| {
                let pq = p * q;
                (&p.square() + &(&q.square() * &radicands.a), &pq + &pq)
            };
            let ((xp, xq), (yp, yq)) = (square(x0, x1), square(y0, y1));
            sign_with_root(
                &(&xp - &(&yp * &radicands.b)),
                &(&xq - &(&yq * &radicands.b)),
                &radicands.a,
            )
        })
    }

    /// Returns the number times `2^places`, as an integer with an error of less than 4.
    pub(crate) fn fixed(&self, places: i32, radicands: &Radicands) -> BigInt {
        let mut sum = self.0[0].fixed(places);
        for (coefficient, radicand) in
            self.0[1..].iter().zip([&radicands.a, &radicands.b, &radicands.ab])
        {
            if coefficient.is_zero() {
                continue;
            }
            let root = (&coefficient.square() * radicand).fixed_root(places);
            match coefficient.sign() {
                Ordering::Less => sum -= root,
                _ => sum += root,
            }
        }
        sum
    }

    /// Returns an upper bound of `log2 |x|`.
    pub(crate) fn log2_bound(&self, radicands: &Radicands) -> i32 {
        let one = Dyadic::from(1.0);
        let terms = self.0.iter().zip([&one, &radicands.a, &radicands.b, &radicands.ab]);
        let largest = terms.map(|(x, radicand)| {
            if x.is_zero() { i32::MIN / 4 } else { x.log2() + 1 + (radicand.log2() + 2) / 2 + 1 }
        });
        largest.max().unwrap_or_default() + 2
    }
}

/// Returns the sign of `x + y`, given the signs of x and y. If they differ, the result is the sign
/// of x if `x^2 > y^2`, otherwise that of y; `squares` compares the two squares.
pub(crate) fn larger_of(x: Ordering, y: Ordering, squares: impl FnOnce() -> Ordering) -> Ordering {
    match (x, y) {
        (Ordering::Equal, y) => y,
        (x, Ordering::Equal) => x,
        (x, y) if x == y => x,
        (Ordering::Greater, _) => squares(),
        _ => squares().reverse(),
    }
}

/// Returns the sign of `p + q sqrt a`.
fn sign_with_root(p: &Dyadic, q: &Dyadic, a: &Dyadic) -> Ordering {
    larger_of(p.sign(), q.sign(), || (&p.square() - &(&q.square() * a)).sign())
}

/// Returns the sign of `x + s sqrt p + t sqrt q`, where s and t stand for -1, 0 or 1, and p and q are
/// not negative. It is decided exactly, by squaring once for each root.
pub(crate) fn sign_with_roots(
    x: &Surd,
    (s, p): (Ordering, &Surd),
    (t, q): (Ordering, &Surd),
    radicands: &Radicands,
) -> Ordering {
    let root_sign = |sign: Ordering, radicand: &Surd| match radicand.sign(radicands) {
        Ordering::Greater => sign,
        _ => Ordering::Equal,
    };
    let (s, t) = (root_sign(s, p), root_sign(t, q));
    let roots = larger_of(s, t, || (p - q).sign(radicands));
    larger_of(x.sign(radicands), roots, || {
        // x^2 - p - q - 2 s t sqrt(p q)
        let y = &(&x.square(radicands) - p) - q;
        let product = p.times(q, radicands);
        let cross = match (s, t) {
            (Ordering::Equal, _) | (_, Ordering::Equal) => Ordering::Equal,
            (s, t) if s == t => Ordering::Less,
            _ => Ordering::Greater,
        };
        larger_of(y.sign(radicands), cross, || {
            let four = Dyadic::from(4.0);
            (&y.square(radicands) - &product.scaled(&four)).sign(radicands)
        })
    })
}

impl Add for &Surd {
    type Output = Surd;

    fn add(self, other: &Surd) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] + &other.0[i]))
    }
}

impl Sub for &Surd {
    type Output = Surd;

    fn sub(self, other: &Surd) -> Surd {
        Surd(std::array::from_fn(|i| &self.0[i] - &other.0[i]))
    }
}

impl Neg for &Surd {
    type Output = Surd;

    fn neg(self) -> Surd {
        Surd(std::array::from_fn(|i| -&self.0[i]))
    }
}
