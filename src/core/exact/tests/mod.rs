//! Tests the arithmetic on which the ladder is based with random bit patterns, compared with big
//! integers: error-free sums and products are exact to the bit, double-double stays within its bounds,
//! and every SIMD level gives the same results.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test prints and fails by panicking"
)]

use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch};

use crate::exact::double_double::DoubleDouble;
use crate::exact::double_double::{Lane, dekker_product, fast_two_sum, two_sum};
use crate::exact::dyadic::Dyadic;
use crate::exact::lanes::Lanes;
use crate::exact::scale::{exponent, ldexp};
use crate::test_levels::levels;
use crate::test_seed::seed;

/// Number of random patterns with which each operation is tested.
const COUNT: usize = 100_000;

/// Random bits (Steele, Lea, Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014).
struct Bits(u64);

impl Bits {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// Returns a whole number in `from..=to`.
    fn within(&mut self, from: i32, to: i32) -> i32 {
        from + (self.next() % (to - from + 1) as u64) as i32
    }

    /// Returns a number with this exponent, of either sign. Its bits are random, or only one is set, or
    /// they form long runs of ones and zeros, which make carries and ties likely.
    fn number(&mut self, exponent: i32) -> f64 {
        let (random, shift) = (self.next(), self.within(0, 52));
        let fraction = match self.next() % 5 {
            0 | 1 => random,
            2 => 1 << shift,
            3 => (1 << shift) - 1,
            _ => !((1 << shift) - 1) ^ (random & 1),
        };
        let sign = self.next() & 1 << 63;
        let mantissa = f64::from_bits(1023 << 52 | (fraction & ((1 << 52) - 1)) | sign);
        ldexp(mantissa, exponent)
    }

    /// Returns two numbers to add: with independent exponents down to the subnormal ones, with close
    /// exponents, or nearly opposite.
    fn summands(&mut self) -> (f64, f64) {
        let top = self.within(-1074, 1022);
        let a = self.number(top);
        let b = match self.next() % 4 {
            0 => {
                let other = self.within(-1074, 1022);
                self.number(other)
            }
            1 | 2 => {
                let down = self.within(0, 110);
                self.number((top - down).max(-1074))
            }
            _ => {
                let off = self.within(-3, 3);
                opposite(a, off)
            }
        };
        (a, b)
    }

    /// Returns two factors in the range in which [`dekker_product`] is exact.
    fn factors(&mut self) -> (f64, f64) {
        let product = self.within(-969, 1021);
        let first = self.within((product - 995).max(-1022), (product + 1022).min(995));
        (self.number(first), self.number(product - first))
    }

    /// Returns a double-double whose high part is about `2^exponent`.
    fn double(&mut self, exponent: i32) -> DoubleDouble {
        let hi = self.number(exponent);
        let down = match self.next() % 4 {
            0 => return DoubleDouble::from(hi),
            1 => self.within(54, 200),
            _ => 54,
        };
        let (hi, lo) = two_sum(hi, self.number(exponent - down));
        DoubleDouble { hi, lo }
    }

    /// Returns two double-doubles: with independent exponents, with close exponents, or nearly opposite.
    fn doubles(&mut self) -> (DoubleDouble, DoubleDouble) {
        let top = self.within(-200, 200);
        let a = self.double(top);
        let b = match self.next() % 4 {
            0 => {
                let other = self.within(-200, 200);
                self.double(other)
            }
            1 | 2 => {
                let down = self.within(0, 110);
                self.double(top - down)
            }
            _ => {
                let (off, down) = (self.within(-2, 2), self.within(53, 120));
                let hi = opposite(a.hi, off);
                let (hi, lo) = two_sum(hi, self.number(top - down));
                DoubleDouble { hi, lo }
            }
        };
        (a, b)
    }
}

/// Returns `-x` with its magnitude changed by this many units in the last place.
fn opposite(x: f64, ulps: i32) -> f64 {
    let magnitude = x.abs().to_bits().saturating_add_signed(i64::from(ulps));
    f64::from_bits(magnitude).copysign(-x)
}

/// Calls a check [`COUNT`] times with one generator of random bits.
fn on_all(mut check: impl FnMut(&mut Bits)) {
    let mut bits = Bits(seed());
    for _ in 0..COUNT {
        check(&mut bits);
    }
}

fn is_equal(x: &Dyadic, y: &Dyadic) -> bool {
    (x - y).is_zero()
}

#[test]
fn sums_and_their_errors_are_exact() {
    let mut cancelled = 0;
    on_all(|bits| {
        let (a, b) = bits.summands();
        let exact = &Dyadic::from(a) + &Dyadic::from(b);
        let (sum, error) = two_sum(a, b);
        assert_eq!(sum, a + b);
        assert!(is_equal(&exact, &(&Dyadic::from(sum) + &Dyadic::from(error))), "{a:e} + {b:e}");
        let (larger, smaller) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
        assert_eq!(fast_two_sum(larger, smaller), (sum, error), "{larger:e} + {smaller:e}");
        // The condition is on exponents: if they are equal, either number may come first.
        if a != 0.0 && b != 0.0 && exponent(a) == exponent(b) {
            assert_eq!(fast_two_sum(smaller, larger), (sum, error), "{smaller:e} + {larger:e}");
        }
        cancelled += usize::from(sum.abs() < 1e-10 * larger.abs());
    });
    assert!(cancelled > COUNT / 10, "{cancelled}");
}

#[test]
fn products_and_their_errors_are_exact() {
    on_all(|bits| {
        let (a, b) = bits.factors();
        let (product, error) = dekker_product(a, b);
        assert_eq!(product, a * b);
        let exact = &Dyadic::from(a) * &Dyadic::from(b);
        assert!(
            is_equal(&exact, &(&Dyadic::from(product) + &Dyadic::from(error))),
            "{a:e} * {b:e}"
        );
        assert_eq!(a.two_product(b), (product, error), "{a:e} * {b:e}");
    });
}

fn value(x: DoubleDouble) -> Dyadic {
    &Dyadic::from(x.hi) + &Dyadic::from(x.lo)
}

/// Asserts `|found - exact| <= bound u^2 |size|`, with `u^2 = 2^-106`.
#[track_caller]
fn assert_within(
    bound: f64,
    found: &Dyadic,
    exact: &Dyadic,
    size: &Dyadic,
    case: &dyn Fn() -> String,
) {
    let off = &(found - exact) * &Dyadic::from(2_f64.powi(106));
    let most = size * &Dyadic::from(bound);
    assert!((&most.square() - &off.square()).sign().is_ge(), "{} is off", case());
}

#[track_caller]
fn assert_normal(x: DoubleDouble, case: &dyn Fn() -> String) {
    assert_eq!(x.hi + x.lo, x.hi, "{} overlaps: {x:?}", case());
}

/// Bound of a sum's relative error in units of `u^2`: `3 / (1 - 4u)`, rounded up.
const SUM_BOUND: f64 = 3.0 + 8.0 * f64::EPSILON;

#[test]
fn double_double_sums_are_within_their_bound() {
    on_all(|bits| {
        let (a, b) = bits.doubles();
        let case = || format!("{a:?} + {b:?}");
        let exact = &value(a) + &value(b);
        let sum = a + b;
        assert_within(SUM_BOUND, &value(sum), &exact, &exact, &case);
        assert_normal(sum, &case);
        let exact = &value(a) - &value(b);
        assert_within(SUM_BOUND, &value(a - b), &exact, &exact, &case);
    });
}

#[test]
fn double_double_products_are_within_their_bounds() {
    on_all(|bits| {
        let (a, b) = bits.doubles();
        let case = || format!("{a:?} * {b:?}");
        let exact = &value(a) * &value(b);
        let product = a * b;
        assert_within(7.0, &value(product), &exact, &exact, &case);
        assert_normal(product, &case);
        let exact = &value(a) * &Dyadic::from(b.hi);
        let product = a.times(b.hi);
        assert_within(3.0, &value(product), &exact, &exact, &case);
        assert_normal(product, &case);
    });
}

/// Checks quotients x of a and b without dividing: `|x - a/b| <= k |a/b|` if `|x b - a| <= k |a|`.
#[test]
fn double_double_quotients_are_within_their_bound() {
    on_all(|bits| {
        let (a, b) = bits.doubles();
        let case = || format!("{a:?} / {b:?}");
        let quotient = a / b;
        let back = &value(quotient) * &value(b);
        assert_within(17.0, &back, &value(a), &value(a), &case);
        assert_normal(quotient, &case);
    });
}

/// Checks square roots s of x by squaring: `|s - sqrt x| <= k sqrt x` if
/// `(1 - k)^2 x <= s^2 <= (1 + k)^2 x`.
#[test]
fn double_double_roots_are_within_their_bound() {
    let k = &Dyadic::from(3.125) * &Dyadic::from(2_f64.powi(-106));
    let one = Dyadic::from(1.0);
    let (least, most) = ((&one - &k).square(), (&one + &k).square());
    on_all(|bits| {
        let exponent = bits.within(-200, 200);
        let x = bits.double(exponent);
        let x = if x.hi < 0.0 { -x } else { x };
        let case = || format!("the root of {x:?}");
        let root = x.square_root();
        let (square, x) = (value(root).square(), value(x));
        assert!((&square - &(&x * &least)).sign().is_ge(), "{} is too small", case());
        assert!((&(&x * &most) - &square).sign().is_ge(), "{} is too large", case());
        assert_normal(root, &case);
    });
}

/// Number of values that [`results`] returns.
const RESULTS: usize = 7;

fn results<F: Lane>(a: F, b: F, positive: F) -> [F; RESULTS] {
    let (product, error) = a.two_product(b);
    [product, error, a + b, a - b, a / b, positive.sqrt(), a.half()]
}

type Case = (f64, f64, f64);

#[inline(always)]
fn by_lanes<S: Simd>(simd: S, cases: &[Case]) -> Vec<[f64; RESULTS]> {
    let lanes = |get: fn(&Case) -> f64, chunk: &[Case]| {
        let numbers: Vec<f64> = chunk.iter().map(get).collect();
        Lanes::<S>(S::f64s::from_slice(simd, &numbers))
    };
    let mut all = Vec::new();
    for chunk in cases.chunks_exact(S::f64s::LEN) {
        let [a, b, positive] =
            [lanes(|case| case.0, chunk), lanes(|case| case.1, chunk), lanes(|case| case.2, chunk)];
        let mut numbers = [[0.0; 8]; RESULTS];
        for (result, numbers) in results(a, b, positive).iter().zip(&mut numbers) {
            result.0.store_slice(&mut numbers[..S::f64s::LEN]);
        }
        all.extend((0..chunk.len()).map(|lane| numbers.map(|result| result[lane])));
    }
    all
}

/// Checks that SIMD vectors give the same bits as scalars, which the tests above check. The sign of an
/// error of 0 is ignored: Dekker's product may make it -0, a fused multiply-add makes it +0.
#[test]
fn lanes_give_the_same_bits_on_every_level() {
    let mut cases: Vec<Case> = Vec::new();
    on_all(|bits| {
        let (a, b) = bits.factors();
        cases.push((a, b, a.abs()));
    });
    assert_eq!(cases.len() % 8, 0);
    let expected: Vec<_> =
        cases.iter().map(|(a, b, positive)| results(*a, *b, *positive)).collect();
    for (name, level) in levels() {
        let found = dispatch!(level, simd => by_lanes(simd, &cases));
        assert_eq!(found.len(), cases.len());
        for ((found, expected), case) in found.iter().zip(&expected).zip(&cases) {
            let bits = |x: &[f64; RESULTS]| x.map(|x| (x + 0.0).to_bits());
            assert_eq!(bits(found), bits(expected), "{name}: {case:?}");
        }
    }
}
