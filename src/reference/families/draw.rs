//! Random numbers for the families of difficult cases. They are the same on every machine and in every
//! version.
//!
//! They are computed with `+ - * /` and `sqrt` alone, whose results IEEE 754 defines to the last bit.

use crate::camera::Orientation;

/// A generator of random numbers from a seed, by SplitMix64 (Steele, Lea, Flood, *Fast splittable
/// pseudorandom number generators*, 2014). It is implemented here because recorded results depend on
/// its numbers, and those of a library may change with its version.
pub struct Draw {
    state: u64,
}

/// Upper limits of the random integers from which a case is built in which objects touch each other, or
/// a ray touches an object, exactly. Coordinates computed from them fit in the 24 bits of `f32` or the
/// 53 bits of `f64`, but their products do not.
pub(crate) struct Sizes {
    pub(crate) quaternion: i64,
    pub(crate) extent: i64,
    pub(crate) steps: i64,
}

impl Draw {
    /// Returns the generators for `count` cases of a family.
    pub fn cases(seed: u64, family: &str, knob: f64, count: usize) -> impl Iterator<Item = Draw> {
        (0..count).map(move |index| Draw::new(seed, family, knob, index))
    }

    pub(crate) fn new(seed: u64, family: &str, knob: f64, index: usize) -> Draw {
        let mut draw = Draw { state: seed };
        let name = family.bytes().fold(0, |sum: u64, byte| sum.wrapping_mul(257) + u64::from(byte));
        for part in [name, knob.to_bits(), index as u64] {
            draw.state = draw.next() ^ part;
        }
        draw
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns an orientation that looks along `view`. At random, it is given as this vector or as the
    /// point `at = eye + view`. `eye` and `view` must have integer coordinates, so that `at - eye` is
    /// exactly `view`.
    pub fn aimed(&mut self, eye: [f64; 3], view: [f64; 3], up: [f64; 3]) -> Orientation {
        if self.once_in(3) {
            Orientation::View { view, up }
        } else {
            Orientation::At { at: plus(eye, 1.0, view), up }
        }
    }

    /// Returns a number from 0 to 1, excluding 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a random number that is at least `low` and less than `high`; rounding may make it equal
    /// to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Returns a whole number from `low` to `high`, inclusive.
    pub fn whole(&mut self, low: i64, high: i64) -> f64 {
        (low + (self.next() % (high - low + 1) as u64) as i64) as f64
    }

    /// Returns true with the probability `1 / n`.
    pub fn once_in(&mut self, n: u64) -> bool {
        self.next().is_multiple_of(n)
    }

    /// Returns 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.once_in(2) { 1.0 } else { -1.0 }
    }

    /// Returns a random number from `low` to `high`. Each binade (the numbers with the same binary
    /// exponent) has the same probability.
    pub fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        let binades = ((high / low).to_bits() >> 52) as i64 - 1023;
        let size = low * self.power_of_two(0, binades);
        (size * self.between(1.0, 2.0)).min(high)
    }

    /// Returns `2^k` for a random integer k from `low` to `high`, inclusive.
    pub fn power_of_two(&mut self, low: i64, high: i64) -> f64 {
        let exponent = self.whole(low, high) as i64;
        f64::from_bits(((1023 + exponent) as u64) << 52)
    }

    /// Returns a random power of two, by which all lengths of a case are multiplied.
    pub(crate) fn binary_scale(&mut self) -> f64 {
        self.power_of_two(-20, 20)
    }

    pub(crate) fn sizes(&mut self) -> Sizes {
        if self.once_in(2) {
            Sizes { quaternion: 3, extent: 1 << 10, steps: 1 << 8 }
        } else {
            Sizes { quaternion: 100, extent: 1 << 40, steps: 1 << 20 }
        }
    }

    /// Returns a random point in the cube whose coordinates range from `-half` to `half`.
    pub fn in_box(&mut self, half: f64) -> [f64; 3] {
        [0; 3].map(|_| self.between(-half, half))
    }

    /// Returns a random vector of integers with magnitudes up to `largest`, at least one of which is
    /// not 0.
    pub fn whole_vector(&mut self, largest: i64) -> [f64; 3] {
        loop {
            let vector = [0; 3].map(|_| self.whole(-largest, largest));
            if vector != [0.0; 3] {
                return vector;
            }
        }
    }

    /// Returns a unit vector, up to rounding, in any direction.
    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = self.in_box(1.0);
            let square = dot(v, v);
            if (0.01..=1.0).contains(&square) {
                return scaled(v, 1.0 / square.sqrt());
            }
        }
    }

    /// Returns a random unit vector that is perpendicular to `v`, up to rounding.
    pub fn across(&mut self, v: [f64; 3]) -> [f64; 3] {
        let v = scaled(v, 1.0 / dot(v, v).sqrt());
        loop {
            let across = cross(v, self.direction());
            let square = dot(across, across);
            if square > 0.01 {
                return scaled(across, 1.0 / square.sqrt());
            }
        }
    }

    /// Returns three mutually perpendicular vectors with integer coordinates and the same integer
    /// length, and this length. They are the columns of the rotation matrix of a random quaternion `a +
    /// bi + cj + dk` with integer coefficients, times the quaternion's squared length, which clears the
    /// denominators (the Euler-Rodrigues formula).
    pub fn whole_frame(&mut self, largest: i64) -> ([[f64; 3]; 3], f64) {
        let [b, c, d] = self.whole_vector(largest);
        let a = self.whole(-largest, largest);
        let columns = [
            [a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)],
            [2.0 * (b * c - a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d + a * b)],
            [2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a - b * b - c * c + d * d],
        ];
        (columns, a * a + b * b + c * c + d * d)
    }
}

/// Returns `x` moved away from 0 by `ulps` units in the last place (towards 0 if `ulps` is negative).
pub fn moved_by_ulps(x: f64, ulps: f64) -> f64 {
    // The bits of consecutive floats are consecutive integers.
    let moved = f64::from_bits(x.to_bits().wrapping_add_signed(ulps as i64));
    assert!(moved.is_finite() && x != 0.0, "{x} has no neighbour");
    moved
}

/// Returns `10^k` for an integer k, correctly rounded, including subnormals.
pub fn decade(k: f64) -> f64 {
    format!("1e{k:.0}").parse().unwrap_or(f64::NAN)
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn scaled(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|x| x * s)
}

/// Returns `a + s b`.
pub(crate) fn plus(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}
