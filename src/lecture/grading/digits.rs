//! Answers that are right as far as they are written, to too few digits.

use pinhole_core::DVec3;

use super::answers::{Answers, Written, WrittenVector};

/// The digits to which the numbers of some answers are written. Zeros at the end do not show, so
/// the longest of them tell for all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Precision {
    /// Significant digits.
    digits: i32,
    /// Digits behind the point.
    decimals: i32,
}

impl Precision {
    /// The precision of these answers; `None` where they have all digits, or no numbers.
    pub(super) fn of_answers(answers: &Answers) -> Option<Precision> {
        /// More than a number is ever said to lack.
        const MANY: i32 = 12;
        let mut longest: Option<Precision> = None;
        let mut is_long = false;
        for_each(answers, |size| {
            if let Some((digits, decimals)) = written(size).filter(|_| !is_long) {
                let before = longest.unwrap_or(Precision { digits, decimals });
                let (digits, decimals) = (before.digits.max(digits), before.decimals.max(decimals));
                longest = Some(Precision { digits, decimals });
                is_long = digits > MANY;
            }
        });
        longest.filter(|_| !is_long)
    }

    /// Half a unit of the last digit of a number of this size.
    fn half_unit(self, size: f64) -> f64 {
        let of_decimals = 10f64.powi(-self.decimals);
        let of_digits = exponent(size).map_or(0.0, |e| 10f64.powi(e + 1 - self.digits));
        // A little more, as both sides are rounded.
        (0.5 + 1e-9) * of_decimals.max(of_digits)
    }

    /// The answers, each allowed half a unit of its last digit; and the fewest digits that one has.
    pub(super) fn allowed(self, answers: &Answers) -> (Answers, i32) {
        let mut fewest = self.digits;
        let mut allowed = answers.clone();
        for_each_mut(&mut allowed, |size, rounding| {
            *rounding = rounding.max(self.half_unit(size));
            if let Some(exponent) = exponent(size) {
                fewest = fewest.min(exponent + 1 + self.decimals);
            }
        });
        (allowed, fewest)
    }
}

/// The power of ten of a number's first digit; 0 has none.
fn exponent(size: f64) -> Option<i32> {
    (size > 0.0 && size.is_finite()).then(|| size.log10().floor() as i32)
}

/// Significant digits, and digits behind the point, in the shortest decimal; 0 has none.
fn written(size: f64) -> Option<(i32, i32)> {
    exponent(size)?;
    let text = format!("{size:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count() as i32;
    Some((digits, digits - 1 - exponent.parse::<i32>().ok()?))
}

/// Calls with the size of each number, and of each coordinate.
fn for_each(answers: &Answers, mut each: impl FnMut(f64)) {
    let mut vector = |vector: &WrittenVector| {
        vector.value.to_array().into_iter().for_each(|coordinate| each(coordinate.abs()));
    };
    match answers {
        Answers::Basis(vectors) => vectors.iter().for_each(vector),
        Answers::Rays(rays) => rays.iter().for_each(|ray| {
            vector(&ray.origin);
            vector(&ray.direction);
        }),
        Answers::Hits(hits) => {
            for hit in hits.iter().filter_map(|answer| answer.hit) {
                if let Some(t) = hit.t {
                    vector(&Written::exactly(DVec3::splat(t.value)));
                }
                if let Some(point) = &hit.point {
                    vector(point);
                }
            }
        }
        Answers::Picture(_) => {}
    }
}

/// Calls with the size of each number, and of each vector's largest coordinate; and its rounding.
fn for_each_mut(answers: &mut Answers, mut each: impl FnMut(f64, &mut f64)) {
    let mut vector = |vector: &mut WrittenVector| {
        each(vector.value.abs().max_element(), &mut vector.rounding);
    };
    match answers {
        Answers::Basis(vectors) => vectors.iter_mut().for_each(vector),
        Answers::Rays(rays) => rays.iter_mut().for_each(|ray| {
            vector(&mut ray.origin);
            vector(&mut ray.direction);
        }),
        Answers::Hits(hits) => {
            for hit in hits.iter_mut().filter_map(|answer| answer.hit.as_mut()) {
                if let Some(point) = &mut hit.point {
                    vector(point);
                }
                if let Some(t) = &mut hit.t {
                    let mut along =
                        WrittenVector { value: t.value * DVec3::X, rounding: t.rounding };
                    vector(&mut along);
                    t.rounding = along.rounding;
                }
            }
        }
        Answers::Picture(_) => {}
    }
}
