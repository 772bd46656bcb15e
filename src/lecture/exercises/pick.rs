//! Chooses the values given in the questions: the lecture's own, and random ones whose answers are as
//! simple.

use std::f64::consts::FRAC_1_SQRT_2;

use pinhole_core::{Camera, DVec2, DVec3, ImageSize, Pixel, Ray, Sphere};

use super::question::{Exercise, Given};
use crate::mistakes::SplitMix64;

/// Returns the values given in a question, as in the lecture. Only the view and up vectors of
/// [`Exercise::ViewUp`] are twice as long as in the lecture, which changes no right answer, but
/// reveals who forgets to normalize.
pub(super) fn lecture(exercise: Exercise) -> Given {
    let uv = DVec2::new(0.2, -0.1);
    let z = -6.0;
    let eye = DVec3::new(20.0, 4.0, 10.0);
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
    let sphere = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    match exercise {
        Exercise::WarmUpRay => Given::Uv(uv),
        Exercise::WarmUpPlane => Given::UvAndWall { uv, z },
        Exercise::Distance => Given::Distance { uv, distance: 2.0, z },
        Exercise::Turned => Given::Turned { right: midway(1.0, -1.0), uv, z },
        Exercise::ViewUp => {
            Given::ViewUp { view: 2.0 * DVec3::NEG_Y, up: DVec3::new(2.0, 2.0, 0.0) }
        }
        Exercise::EyeAtUp => Given::EyeAtUp { eye, at: DVec3::new(-1.0, 0.0, -5.0), up: DVec3::Y },
        Exercise::Sphere => Given::Sphere { ray, sphere },
        Exercise::Coefficients => Given::Coefficients { ray, sphere },
        Exercise::PixelUv => Given::Pixel {
            image: Camera::CANONICAL.image,
            pixel: Pixel { row: 240, column: 280 },
            from_one: true,
        },
        Exercise::PointAt => Given::PointAt { eye, uv, t: 6.0 },
        Exercise::Lines => Given::Lines {
            line: DVec3::new(1.0, 1.0, -2.0),
            origin: DVec2::ZERO,
            direction: DVec2::ONE,
        },
    }
}

/// Returns random values for a question. The same seed gives the same values.
pub(super) fn seeded(exercise: Exercise, seed: u64) -> Given {
    // In different exercises, the same seed gives unrelated numbers.
    let mut dice = Dice(SplitMix64(seed ^ ((exercise as u64) << 56)));
    match exercise {
        Exercise::WarmUpRay => Given::Uv(dice.uv()),
        Exercise::WarmUpPlane => Given::UvAndWall { uv: dice.uv(), z: -dice.whole(2, 9) },
        Exercise::Distance => {
            let distance = dice.one_of(&[0.5, 1.5, 2.0, 2.5, 3.0, 4.0]);
            Given::Distance { uv: dice.uv(), distance, z: -distance * dice.whole(2, 6) }
        }
        Exercise::Turned => {
            let (x, z) = (dice.sign(), dice.sign());
            Given::Turned { right: midway(x, z), uv: dice.uv(), z: -x * dice.whole(2, 9) }
        }
        Exercise::ViewUp => dice.view_up(),
        Exercise::EyeAtUp => dice.eye_at_up(),
        Exercise::Sphere => {
            let (ray, sphere) = dice.sphere();
            Given::Sphere { ray, sphere }
        }
        Exercise::Coefficients => {
            let (ray, sphere) = dice.sphere();
            Given::Coefficients { ray, sphere }
        }
        Exercise::Lines => dice.lines(),
        Exercise::PixelUv => dice.pixel(),
        Exercise::PointAt => {
            let eye =
                DVec3::new(dice.whole(-4, 4), dice.sign() * dice.whole(1, 5), dice.whole(1, 9));
            Given::PointAt { eye, uv: dice.uv(), t: dice.whole(2, 9) }
        }
    }
}

/// Returns the unit vector midway between the x axis and the z axis; each axis is reversed if its
/// argument is -1 rather than 1.
fn midway(x: f64, z: f64) -> DVec3 {
    FRAC_1_SQRT_2 * DVec3::new(x, 0.0, z)
}

/// Generates random numbers of the kinds that the questions need.
struct Dice(SplitMix64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.0.bits()) * count as u128) >> 64) as usize
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// Returns a whole number from `low` to `high`, inclusive.
    fn whole(&mut self, low: i32, high: i32) -> f64 {
        f64::from(low) + self.below((high - low + 1) as usize) as f64
    }

    fn sign(&mut self) -> f64 {
        self.one_of(&[-1.0, 1.0])
    }

    /// Returns a point (u, v) inside the canonical viewport. Its coordinates are multiples of 0.1 that
    /// differ in magnitude, and neither is 0.
    fn uv(&mut self) -> DVec2 {
        const TENTHS: [f64; 4] = [0.1, 0.2, 0.3, 0.4];
        let u = self.below(4);
        let v = (u + 1 + self.below(3)) % 4;
        DVec2::new(self.sign() * TENTHS[u], self.sign() * TENTHS[v])
    }

    /// Returns the coordinate axes in random order and with random signs.
    fn axes(&mut self) -> [DVec3; 3] {
        let [a, b, c] = self.one_of(&[
            [DVec3::X, DVec3::Y, DVec3::Z],
            [DVec3::Y, DVec3::Z, DVec3::X],
            [DVec3::Z, DVec3::X, DVec3::Y],
            [DVec3::X, DVec3::Z, DVec3::Y],
        ]);
        [self.sign() * a, self.sign() * b, self.sign() * c]
    }

    fn view_up(&mut self) -> Given {
        let [along, across, other] = self.axes();
        let view = self.one_of(&[1.0, 2.0, 3.0]) * along;
        let (a, b) = self.one_of(&[(1.0, 0.0), (2.0, 0.0), (1.0, 1.0), (3.0, 4.0), (4.0, 3.0)]);
        let leaning = self.sign() * self.whole(1, 2);
        Given::ViewUp { view, up: a * across + b * other + leaning * along }
    }

    fn eye_at_up(&mut self) -> Given {
        const SIDES: [(f64, f64); 7] =
            [(3.0, 4.0), (4.0, 3.0), (6.0, 8.0), (8.0, 6.0), (1.0, 1.0), (1.0, 2.0), (2.0, 1.0)];
        let (x, z) = self.one_of(&SIDES);
        let back = DVec3::new(
            self.sign() * x,
            self.sign() * self.one_of(&[1.0, 2.0, 3.0, 5.0]),
            self.sign() * z,
        );
        let at = DVec3::new(self.whole(-3, 3), self.whole(1, 3), self.whole(-5, -1));
        Given::EyeAtUp { eye: at + back, at, up: DVec3::Y }
    }

    /// Returns a ray and a sphere. The ray's distance from the centre, half the chord, and the radius
    /// are the sides of a right triangle, and all three are integers.
    fn sphere(&mut self) -> (Ray, Sphere) {
        const TRIANGLES: [(f64, f64, f64); 6] = [
            (3.0, 4.0, 5.0),
            (4.0, 3.0, 5.0),
            (0.0, 2.0, 2.0),
            (0.0, 3.0, 3.0),
            (6.0, 8.0, 10.0),
            (5.0, 12.0, 13.0),
        ];
        let (aside, half, radius) = self.one_of(&TRIANGLES);
        let [along, across, _] = self.axes();
        let origin = DVec3::new(self.whole(-2, 2), self.whole(-2, 2), self.whole(-2, 2));
        let (t, length) = (self.whole(2, 6), self.one_of(&[1.0, 2.0, 2.0]));
        let center = origin + (t * length + half) * along + aside * across;
        (Ray { origin, direction: length * along }, Sphere { center, radius })
    }

    /// Returns a pixel of a square image of so many pixels that the decimals of (u, v) are few. Its row
    /// and column differ.
    fn pixel(&mut self) -> Given {
        let size = self.one_of(&[4, 5, 8, 10, 20, 40]);
        let row = self.below(size);
        let column = (row + 1 + self.below(size - 1)) % size;
        let [size, row, column] = [size, row, column].map(|k| k as u32);
        Given::Pixel {
            image: ImageSize::new(size, size).unwrap_or(Camera::CANONICAL.image),
            pixel: Pixel { row, column },
            from_one: self.sign() > 0.0,
        }
    }

    fn lines(&mut self) -> Given {
        loop {
            let normal = DVec2::new(self.whole(-3, 3), self.whole(-3, 3));
            let direction = DVec2::new(self.whole(-3, 3), self.whole(-3, 3));
            let origin = DVec2::new(self.whole(-4, 4), self.whole(-4, 4));
            let t = self.one_of(&[-3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 0.5, 1.5]);
            if normal.dot(direction) != 0.0 && normal.x * normal.y != 0.0 {
                let c = -normal.dot(origin + t * direction);
                return Given::Lines { line: normal.extend(c), origin, direction };
            }
        }
    }
}
