//! Students' answers to be graded, and the number of digits with which they are written.

use pinhole_core::{DVec3, Pixel, Rgb};

/// A student's answers, all of one kind.
///
/// Rows and columns are counted from 0 here. Row H and column W, which lie outside an image of H rows
/// and W columns, occur if a student counts from 1 without saying so.
#[derive(Clone, Debug, PartialEq)]
pub enum Answers {
    /// u, v and w.
    Basis([WrittenVector; 3]),
    /// The view rays of pixels.
    Rays(Vec<RayAnswer>),
    /// The first hits of the view rays of pixels.
    Hits(Vec<HitAnswer>),
    /// The whole picture, row by row from the top.
    Picture(Vec<Rgb>),
}

pinhole_core::texts! {
    /// A kind of answers.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum AnswerKind[2];
    {
        /// Returns the kind's name in files.
        name,
        /// Returns what is counted.
        plural,
    }
    /// u, v and w.
    Basis: "basis", "vectors";
    /// The view rays of pixels.
    Rays: "rays", "rays";
    /// The first hits of the view rays of pixels.
    Hits: "hits", "hits";
    /// The whole picture.
    Picture: "picture", "pixels";
}

/// A number or vector as the student wrote it, possibly rounded.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Written<T> {
    /// The value that was read.
    pub value: T,
    /// Maximum error of each coordinate due to rounding: half a unit in the last written digit. It is 0
    /// for numbers written with all their digits.
    pub rounding: f64,
}

/// A vector as the student wrote it.
pub type WrittenVector = Written<DVec3>;

/// A student's answer to the question what a pixel's view ray is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayAnswer {
    /// The pixel.
    pub pixel: Pixel,
    /// The ray's origin.
    pub origin: WrittenVector,
    /// The direction, of any length greater than 0.
    pub direction: WrittenVector,
}

/// A student's answer to the question what a pixel's view ray hits first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitAnswer {
    /// The pixel.
    pub pixel: Pixel,
    /// The hit; `None` for a miss.
    pub hit: Option<GivenHit>,
}

/// A hit as the student gave it. The parts that are missing are `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenHit {
    /// The parameter t of the ray.
    pub t: Option<Written<f64>>,
    /// The hit point in the world.
    pub point: Option<WrittenVector>,
    /// The object's index.
    pub object: Option<u32>,
}

impl<T> Written<T> {
    /// Creates a number or vector that was written with all its digits, and so has a rounding error of
    /// 0.
    pub fn exactly(value: T) -> Written<T> {
        Written { value, rounding: 0.0 }
    }
}

impl Answers {
    /// Returns the kind of the answers.
    pub fn kind(&self) -> AnswerKind {
        match self {
            Answers::Basis(_) => AnswerKind::Basis,
            Answers::Rays(_) => AnswerKind::Rays,
            Answers::Hits(_) => AnswerKind::Hits,
            Answers::Picture(_) => AnswerKind::Picture,
        }
    }

    /// Returns the number of vectors, rays, hits or pixels.
    pub fn len(&self) -> usize {
        match self {
            Answers::Basis(vectors) => vectors.len(),
            Answers::Rays(rays) => rays.len(),
            Answers::Hits(hits) => hits.len(),
            Answers::Picture(pixels) => pixels.len(),
        }
    }

    /// Returns true if there are no answers.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns true if the answers may come from a program that computes in `f32`: each examined number
    /// equals an `f32` to the digits with which it was written.
    pub(super) fn may_be_single(&self) -> bool {
        /// Maximum number of answers that are examined, spread evenly. One number in full double
        /// precision is enough to rule out `f32`.
        const LOOKED_AT: usize = 2000;
        let step = self.len().div_ceil(LOOKED_AT).max(1);
        let is_single =
            |numbers: &[f64], rounding: &mut f64| numbers.iter().all(|x| is_single(*x, *rounding));
        // The eight bits of a picture's channels are too few to decide.
        self.kind() != AnswerKind::Picture && for_each(&mut self.clone(), step, is_single)
    }
}

/// Returns true if a number, to the digits with which it was written, is an `f32` or the shortest
/// decimal of an `f32`.
fn is_single(value: f64, rounding: f64) -> bool {
    let single = value as f32;
    let off = (f64::from(single) - value).abs();
    // The margin is slightly above half a unit, because C rounds ties to even.
    off <= rounding * (1.0 + 1e-9) || format!("{single:?}").parse() == Ok(value)
}

/// The number of digits with which all of a student's answers are taken to be written. Since programs
/// often omit trailing zeros, the numbers with the most digits determine it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Precision {
    /// The number of significant digits.
    digits: i32,
    /// The number of digits after the decimal point.
    decimals: i32,
}

impl Precision {
    /// Returns the precision of these answers; `None` if they are written with all their digits (more
    /// than 12), or contain no numbers.
    pub(super) fn of_answers(answers: &Answers) -> Option<Precision> {
        /// A number with more significant digits than this counts as written with all its digits.
        const MANY: i32 = 12;
        let mut longest: Option<Precision> = None;
        for_each(&mut answers.clone(), 1, |numbers, _| {
            for (digits, decimals) in numbers.iter().filter_map(|x| written(x.abs())) {
                let before = longest.unwrap_or(Precision { digits, decimals });
                let (digits, decimals) = (before.digits.max(digits), before.decimals.max(decimals));
                longest = Some(Precision { digits, decimals });
            }
            // The first number that is written with all its digits decides, so the search stops there.
            longest.is_none_or(|longest| longest.digits <= MANY)
        });
        longest.filter(|longest| longest.digits <= MANY)
    }

    /// Returns half a unit in the last digit of a number of this size.
    fn half_unit(self, size: f64) -> f64 {
        let of_decimals = 10f64.powi(-self.decimals);
        let of_digits = exponent(size).map_or(0.0, |e| 10f64.powi(e + 1 - self.digits));
        // The result is slightly larger, because both sides of the comparison are rounded.
        (0.5 + 1e-9) * of_decimals.max(of_digits)
    }

    /// Returns the answers with [`Written::rounding`] set to half a unit in their last digit, and the
    /// number of significant digits of the answer that has the fewest.
    pub(super) fn allowed(self, answers: &Answers) -> (Answers, i32) {
        let mut fewest = self.digits;
        let mut allowed = answers.clone();
        for_each(&mut allowed, 1, |numbers, rounding| {
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

/// Returns the power of ten of a number's first digit; `None` for 0 and for numbers that are not
/// finite.
fn exponent(size: f64) -> Option<i32> {
    (size > 0.0 && size.is_finite()).then(|| size.log10().floor() as i32)
}

/// Returns the number of significant digits and the number of decimals of a number's shortest decimal
/// form; `None` for 0.
fn written(size: f64) -> Option<(i32, i32)> {
    exponent(size)?;
    let text = format!("{size:e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count() as i32;
    Some((digits, digits - 1 - exponent.parse::<i32>().ok()?))
}

/// Calls `each` for the numbers of every `step`th answer, until it returns false. Its arguments are a
/// number or the coordinates of a vector, and their [`Written::rounding`], which it may change. Returns
/// true if `each` never returns false.
fn for_each(
    answers: &mut Answers,
    step: usize,
    mut each: impl FnMut(&[f64], &mut f64) -> bool,
) -> bool {
    let mut vector =
        |vector: &mut WrittenVector| each(&vector.value.to_array(), &mut vector.rounding);
    match answers {
        Answers::Basis(vectors) => vectors.iter_mut().all(vector),
        Answers::Rays(rays) => {
            let mut rays = rays.iter_mut().step_by(step);
            rays.all(|ray| vector(&mut ray.origin) && vector(&mut ray.direction))
        }
        Answers::Hits(hits) => {
            let hits = hits.iter_mut().step_by(step);
            hits.filter_map(|answer| answer.hit.as_mut()).all(|GivenHit { t, point, .. }| {
                point.as_mut().is_none_or(|v| each(&v.value.to_array(), &mut v.rounding))
                    && t.as_mut().is_none_or(|t| each(&[t.value], &mut t.rounding))
            })
        }
        Answers::Picture(_) => true,
    }
}
