//! What is to be said of an answer.

use super::{Answer, Part, Slip};
use crate::number::shortest;
use glam::DVec3;

/// How far an answer may be from the truth, relative to it.
const TOLERANCE: f64 = 1e-9;

/// What is to be said of an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It is right.
    Right,
    /// It is right: so many times ours, which is allowed here.
    Multiple {
        /// Above 0.
        times: f64,
    },
    /// It is the right one, rounded.
    Rounded {
        /// To so many significant digits.
        digits: usize,
    },
    /// It is on the right line and points backwards.
    Backwards {
        /// Below 0: how many times ours.
        times: f64,
    },
    /// It points where it should, and its length matters here.
    OtherLength {
        /// Above 0: how many times ours.
        times: f64,
    },
    /// These mistakes, each alone, give the answer.
    Slips(Vec<Slip>),
    /// No mistake that is known gives it; what is wrong with it.
    Wrong(Vec<Finding>),
}

/// Something that is wrong with an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// It is (0, 0, 0).
    Zero,
    /// This coordinate, counted from 0, is another; the other coordinates are right.
    Coordinate(usize),
    /// The length should be 1, and is this.
    Length(f64),
    /// It should be at right angles to the named vector; the dot product.
    NotOrthogonal {
        /// `up`, `u`, `w`, ...
        to: &'static str,
        /// Which should be 0.
        dot: f64,
    },
    /// The number is another one.
    Another,
}

impl Verdict {
    /// Whether the answer counts as right.
    pub fn is_right(&self) -> bool {
        matches!(self, Verdict::Right | Verdict::Multiple { .. })
    }
}

/// Judges an answer to a part.
pub(super) fn judge(part: &Part, answer: &Answer) -> Verdict {
    let (Answer::Numbers(truth), Answer::Numbers(given)) = (&part.truth, answer) else {
        return if part.truth == *answer { Verdict::Right } else { named(part, answer) };
    };
    if truth.len() != given.len() || !given.iter().all(|x| x.is_finite()) {
        return Verdict::Wrong(vec![Finding::Another]);
    }
    if is_near(given, truth) {
        return Verdict::Right;
    }
    let times = multiple(given, truth);
    if let Some(times) = times.filter(|_| part.may_be_scaled) {
        return if times > 0.0 {
            Verdict::Multiple { times }
        } else {
            Verdict::Backwards { times }
        };
    }
    if let Some(digits) = rounded(given, truth, part.may_be_scaled) {
        return Verdict::Rounded { digits };
    }
    let named = named(part, answer);
    match times.filter(|_| !matches!(named, Verdict::Slips(_))) {
        Some(_) if !part.asked.is_vector() => named,
        Some(times) if times > 0.0 => Verdict::OtherLength { times },
        Some(times) => Verdict::Backwards { times },
        None => named,
    }
}

/// The mistakes that give the answer, or what is wrong with it.
fn named(part: &Part, answer: &Answer) -> Verdict {
    let gives = |wrong: &Answer| match (wrong, answer) {
        (Answer::Numbers(wrong), Answer::Numbers(given)) => {
            is_near(given, wrong)
                || (part.may_be_scaled && multiple(given, wrong).is_some_and(|times| times > 0.0))
                || rounded(given, wrong, part.may_be_scaled).is_some()
        }
        (wrong, answer) => wrong == answer,
    };
    let mut slips: Vec<Slip> = Vec::new();
    for (slip, wrong) in &part.slips {
        if gives(wrong) && !slips.contains(slip) {
            slips.push(*slip);
        }
    }
    if slips.is_empty() { Verdict::Wrong(findings(part, answer)) } else { Verdict::Slips(slips) }
}

fn findings(part: &Part, answer: &Answer) -> Vec<Finding> {
    let (Answer::Numbers(truth), Answer::Numbers(given)) = (&part.truth, answer) else {
        return vec![Finding::Another];
    };
    if given.len() == 1 {
        return vec![Finding::Another];
    }
    if part.asked.is_vector() && given.iter().all(|x| *x == 0.0) {
        return vec![Finding::Zero];
    }
    let size = size(truth);
    let is_off = |k: &usize| (given[*k] - truth[*k]).abs() > TOLERANCE * size;
    let off: Vec<usize> = (0..truth.len()).filter(is_off).collect();
    let mut findings = Vec::new();
    if off.len() < truth.len() {
        findings.extend(off.into_iter().map(Finding::Coordinate));
    }
    if let ([x, y, z], true) = (given[..].try_into().unwrap_or([0.0; 3]), given.len() == 3) {
        let given = DVec3::new(x, y, z);
        let length = given.length();
        if part.asked.is_unit() && (length - 1.0).abs() > TOLERANCE {
            findings.push(Finding::Length(length));
        }
        for (to, vector) in &part.orthogonal_to {
            let dot = given.dot(*vector);
            if dot.abs() > TOLERANCE * length * vector.length() {
                findings.push(Finding::NotOrthogonal { to, dot });
            }
        }
    }
    if findings.is_empty() { vec![Finding::Another] } else { findings }
}

fn size(numbers: &[f64]) -> f64 {
    let size = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size == 0.0 { 1.0 } else { size }
}

fn is_near(given: &[f64], truth: &[f64]) -> bool {
    let size = size(truth);
    given.iter().zip(truth).all(|(x, y)| (x - y).abs() <= TOLERANCE * size)
}

/// How many times the truth a vector is, if it is a multiple of it at all, but not 0.
fn multiple(given: &[f64], truth: &[f64]) -> Option<f64> {
    if given.len() < 2 {
        return None;
    }
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let times = dot(given, truth) / dot(truth, truth);
    let near =
        given.iter().zip(truth).all(|(x, y)| (x - times * y).abs() <= TOLERANCE * size(given));
    (near && times.is_finite() && times != 0.0).then_some(times)
}

/// To how many significant digits, two at least, these are the true numbers, rounded or cut off; any
/// multiple of them where that is allowed.
fn rounded(given: &[f64], truth: &[f64], may_be_scaled: bool) -> Option<usize> {
    let largest = (0..truth.len()).max_by(|a, b| truth[*a].abs().total_cmp(&truth[*b].abs()))?;
    let times = if may_be_scaled { given[largest] / truth[largest] } else { 1.0 };
    if !(times.is_finite() && times > 0.0) {
        return None;
    }
    let mut least = None;
    for (x, y) in given.iter().zip(truth) {
        let y = times * y;
        if (x - y).abs() <= TOLERANCE * size(truth) * times {
            continue;
        }
        let (digits, unit) = precision(*x);
        // The multiple is known no better than the number that it comes from.
        let slack = if may_be_scaled {
            0.5 * precision(given[largest]).1 * (y / given[largest]).abs()
        } else {
            0.0
        };
        let is_rounded = (x - y).abs() <= 0.5 * unit * (1.0 + TOLERANCE) + slack;
        let is_cut_off = x.abs() < y.abs() && (x - y).abs() < unit && x * y > 0.0;
        if digits < 2 || !(is_rounded || is_cut_off) {
            return None;
        }
        least = Some(least.map_or(digits, |least: usize| least.min(digits)));
    }
    least
}

/// How many significant digits a number is written with, and what 1 in the last place is.
fn precision(x: f64) -> (usize, f64) {
    let text = shortest(x.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let digits = mantissa.chars().filter(char::is_ascii_digit).skip_while(|c| *c == '0').count();
    let exponent: i32 = exponent.parse().unwrap_or_default();
    (digits, 10f64.powi(exponent - decimals as i32))
}
