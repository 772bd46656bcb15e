//! Answers that are right as far as they are written, to too few digits.

use super::answers::{Answers, GivenHit, WrittenVector};

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
        for_each(&mut answers.clone(), |numbers, _| {
            for (digits, decimals) in numbers.iter().filter_map(|x| written(x.abs())) {
                let before = longest.unwrap_or(Precision { digits, decimals });
                let (digits, decimals) = (before.digits.max(digits), before.decimals.max(decimals));
                longest = Some(Precision { digits, decimals });
            }
            // The first number with all its digits tells enough.
            longest.is_none_or(|longest| longest.digits <= MANY)
        });
        longest.filter(|longest| longest.digits <= MANY)
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
        for_each(&mut allowed, |numbers, rounding| {
            let size = numbers.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            *rounding = rounding.max(self.half_unit(size));
            if let Some(exponent) = exponent(size) {
                fewest = fewest.min(exponent + 1 + self.decimals);
            }
            true
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

/// Calls with each number, or each vector's numbers, and their rounding, while that returns true.
fn for_each(answers: &mut Answers, mut each: impl FnMut(&[f64], &mut f64) -> bool) {
    let mut vector =
        |vector: &mut WrittenVector| each(&vector.value.to_array(), &mut vector.rounding);
    match answers {
        Answers::Basis(vectors) => drop(vectors.iter_mut().all(vector)),
        Answers::Rays(rays) => {
            rays.iter_mut().all(|ray| vector(&mut ray.origin) && vector(&mut ray.direction));
        }
        Answers::Hits(hits) => {
            hits.iter_mut().filter_map(|answer| answer.hit.as_mut()).all(
                |GivenHit { t, point, .. }| {
                    point.as_mut().is_none_or(|v| each(&v.value.to_array(), &mut v.rounding))
                        && t.as_mut().is_none_or(|t| each(&[t.value], &mut t.rounding))
                },
            );
        }
        Answers::Picture(_) => {}
    }
}
