//! Judges answers to exercises, and defines the conditions that a right answer meets.

use pinhole_core::{Basis, DVec2, DVec3, Ray, Sphere, shortest};

use super::question::{Answer, Asked, QuestionPart};
use crate::mistakes::Mistake;
use crate::numbers::{equated_tuple, exact_if_short as short};

/// The verdict on an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It is right.
    Right,
    /// The answer is right: it is a positive multiple of the right one, which is allowed for this part.
    Multiple {
        /// The factor, which is greater than 0.
        times: f64,
    },
    /// The answer is the right one, rounded.
    Rounded {
        /// The number of significant digits that are right.
        digits: usize,
    },
    /// The answer has the opposite direction of the right one.
    Backwards {
        /// The negative factor by which the right answer is multiplied.
        times: f64,
    },
    /// The answer has the right direction but a different length, which is not allowed for this part.
    OtherLength {
        /// The positive factor by which the right answer is multiplied.
        times: f64,
    },
    /// The answer is wrong, and each of these mistakes leads to it and is consistent with the answers
    /// to the question's other parts.
    Mistakes(Vec<Mistake>),
    /// The answer is wrong, but no known mistake leads to it. The phrases say what is wrong, without a
    /// full stop at the end.
    Wrong(Vec<String>),
}

/// Minimum number of significant digits for an answer to count as right. For a number without a short
/// exact form, the program displays at least as many.
pub(super) const ENOUGH_DIGITS: usize = 4;

impl Verdict {
    /// Returns true if the answer counts as right.
    pub fn is_right(&self) -> bool {
        match self {
            Verdict::Right | Verdict::Multiple { .. } => true,
            Verdict::Rounded { digits } => *digits >= ENOUGH_DIGITS,
            _ => false,
        }
    }
}

/// Judges the answers to all parts of a question together. A mistake that would have led to a wrong
/// answer where the student's is right was not made. Of the other mistakes that lead to a wrong answer,
/// the verdict names those that explain the most wrong answers. If one of them includes another, only
/// the smaller one is named.
pub(super) fn judge(parts: &[QuestionPart], answers: &[Option<Answer>]) -> Vec<Option<Verdict>> {
    let answer = |k: usize| answers.get(k).and_then(Option::as_ref);
    let plain: Vec<Option<Verdict>> =
        (0..parts.len()).map(|k| Some(without_mistakes(&parts[k], answer(k)?))).collect();
    let right: Vec<&QuestionPart> = parts
        .iter()
        .zip(&plain)
        .filter(|(_, plain)| plain.as_ref().is_some_and(is_the_truth))
        .map(|(part, _)| part)
        .collect();
    let named: Vec<Vec<Mistake>> = (0..parts.len())
        .map(|k| match (answer(k), &plain[k]) {
            (Some(answer), Some(plain)) if !is_settled(plain, &parts[k]) => {
                fitting(&parts[k], answer, &right)
            }
            _ => Vec::new(),
        })
        .collect();
    let explains =
        |mistake: &Mistake| named.iter().filter(|mistakes| mistakes.contains(mistake)).count();
    let most = |mistakes: &[Mistake]| {
        let most = mistakes.iter().map(explains).max().unwrap_or_default();
        let mut best: Vec<Mistake> =
            mistakes.iter().copied().filter(|s| explains(s) == most).collect();
        let all = best.clone();
        best.retain(|mistake| !all.iter().any(|other| other.is_part_of(*mistake)));
        best
    };
    let verdict = |(plain, mistakes): (_, &Vec<Mistake>)| match &mistakes[..] {
        [] => plain,
        mistakes => Some(Verdict::Mistakes(most(mistakes))),
    };
    plain.into_iter().zip(&named).map(verdict).collect()
}

/// Returns true if the verdict shows that the student understood this part: the answer is right, or the
/// right one rounded to any number of digits.
fn is_the_truth(verdict: &Verdict) -> bool {
    verdict.is_right() || matches!(verdict, Verdict::Rounded { .. })
}

/// Returns true if the verdict already says what is right or wrong, so that no mistake need be looked
/// for that leads to the answer.
fn is_settled(verdict: &Verdict, part: &QuestionPart) -> bool {
    // If multiples are allowed, only the sign can be wrong, and the verdict already says so.
    is_the_truth(verdict) || part.may_be_scaled && matches!(verdict, Verdict::Backwards { .. })
}

/// Returns the verdict on an answer without looking for mistakes that lead to it.
fn without_mistakes(part: &QuestionPart, answer: &Answer) -> Verdict {
    let (Answer::Numbers(truth), Answer::Numbers(given)) = (&part.truth, answer) else {
        return if part.truth == *answer { Verdict::Right } else { Verdict::Wrong(another(part)) };
    };
    if truth.len() != given.len() || !given.iter().all(|x| x.is_finite()) {
        return Verdict::Wrong(another(part));
    }
    if is_near(given, truth) {
        return Verdict::Right;
    }
    let times = multiple(given, truth);
    if let Some(times) = times.filter(|times| part.may_be_scaled && *times > 0.0) {
        return Verdict::Multiple { times };
    }
    if let Some(digits) = rounded(given, truth, part.may_be_scaled) {
        return Verdict::Rounded { digits };
    }
    match times.filter(|_| part.asked.is_vector()) {
        Some(times) if times > 0.0 => Verdict::OtherLength { times },
        Some(times) => Verdict::Backwards { times },
        None => Verdict::Wrong(findings(part, truth, given)),
    }
}

/// Returns the mistakes that lead to the answer and would not have changed the answers to the parts
/// `right`, which are right. If there are none, returns those mistakes that lead to the answer and are
/// [about](Asked::is_about_mistake) this part itself.
fn fitting(part: &QuestionPart, answer: &Answer, right: &[&QuestionPart]) -> Vec<Mistake> {
    let all = giving(part, answer);
    let spoils = |mistake: &Mistake, part: &&QuestionPart| {
        part.mistakes.iter().any(|(other, _)| other == mistake)
    };
    let agrees = |mistake: &Mistake| !right.iter().any(|part| spoils(mistake, part));
    let agreeing: Vec<Mistake> = all.iter().copied().filter(agrees).collect();
    if agreeing.is_empty() {
        return all.into_iter().filter(|mistake| part.asked.is_about_mistake(*mistake)).collect();
    }
    agreeing
}

/// Returns the mistakes each of which, made alone, leads to the answer.
fn giving(part: &QuestionPart, answer: &Answer) -> Vec<Mistake> {
    let gives = |wrong: &Answer| match (wrong, answer) {
        (Answer::Numbers(wrong), Answer::Numbers(given)) => {
            wrong.len() == given.len()
                && given.iter().all(|x| x.is_finite())
                && (is_near(given, wrong)
                    || (part.may_be_scaled && multiple(given, wrong).is_some_and(|n| n > 0.0))
                    || rounded(given, wrong, part.may_be_scaled).is_some())
        }
        (wrong, answer) => wrong == answer,
    };
    let mut mistakes: Vec<Mistake> = Vec::new();
    for (mistake, wrong) in &part.mistakes {
        if gives(wrong) && !mistakes.contains(mistake) {
            mistakes.push(*mistake);
        }
    }
    mistakes
}

/// Returns the phrase that says that every number of the answer is wrong.
fn another(part: &QuestionPart) -> Vec<String> {
    let what = if part.count() == 1 { "it" } else { "every coordinate" };
    vec![format!("{what} should be another number")]
}

/// Returns phrases that say what is wrong with an answer that no known mistake explains.
fn findings(part: &QuestionPart, truth: &[f64], given: &[f64]) -> Vec<String> {
    if part.asked.is_vector() && given.iter().all(|x| *x == 0.0) {
        return vec!["a direction cannot be (0, 0, 0)".to_owned()];
    }
    let size = size(truth);
    let is_off = |k: &usize| (given[*k] - truth[*k]).abs() > TOLERANCE * size;
    let off: Vec<usize> = (0..truth.len()).filter(is_off).collect();
    let mut findings = Vec::new();
    if off.len() < truth.len() {
        let symbols = part.asked.coordinates().map(|(_, symbol)| symbol);
        let coordinate = |k: usize| format!("{} should be another number", symbols[k]);
        findings.extend(off.into_iter().map(coordinate));
    }
    findings.extend(part.conditions.iter().filter_map(|condition| condition.missed_by(given)));
    findings.extend(of_direction(part, truth, given));
    if findings.is_empty() { another(part) } else { findings }
}

/// Returns phrases that say what is wrong with the length and the direction of a vector that should
/// have length 1.
fn of_direction(part: &QuestionPart, truth: &[f64], given: &[f64]) -> Vec<String> {
    let vector = |numbers: &[f64]| <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array);
    let (Some(truth), Some(given), true) = (vector(truth), vector(given), part.asked.is_unit())
    else {
        return Vec::new();
    };
    let length = given.length();
    let mut findings = Vec::new();
    if (length - 1.0).abs() > TOLERANCE {
        findings.push(format!("its length is {}, not 1", short(length)));
    }
    let count = findings.len();
    findings.extend(part.orthogonal_to.iter().filter_map(|(to, vector)| {
        let dot = given.dot(*vector);
        let is_off = dot.abs() > TOLERANCE * length * vector.length();
        let dot = short(dot);
        is_off.then(|| format!("it is not perpendicular to {to}: the dot product is {dot}"))
    }));
    // If the vector is not perpendicular to another one, a finding already says so. Otherwise, give at
    // least the size of the error.
    if findings.len() == count {
        let degrees = truth.cross(given).length().atan2(truth.dot(given)).to_degrees();
        let from = match part.asked {
            Asked::U => "right in the image",
            Asked::V => "up in the image",
            Asked::W => "straight backwards",
            _ => "the direction from the centre to the hit",
        };
        findings.push(format!("it is {}° off {from}", short(degrees)));
    }
    findings
}

/// Returns the factor if a vector is a nonzero multiple of the right one; `None` if it is not.
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

/// Returns the number of significant digits of `given`, if it is the right answer rounded or truncated
/// to at least two of them; otherwise `None`. If `may_be_scaled` is true, a positive multiple of the
/// right answer may be rounded instead.
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
        let (digits, place) = precision(*x);
        // The factor is only as precise as the number from which it comes.
        let slack = if may_be_scaled {
            0.5 * unit(precision(given[largest]).1) * (y / given[largest]).abs()
        } else {
            0.0
        };
        let is_rounded = (x - y).abs() <= 0.5 * unit(place) * (1.0 + TOLERANCE) + slack;
        let is_cut_off = x * y > 0.0 && cut_off(y, place) == Some(x.abs());
        if digits < 2 || !(is_rounded || is_cut_off) {
            return None;
        }
        least = Some(least.map_or(digits, |least: usize| least.min(digits)));
    }
    least
}

/// Returns the number of significant digits in the shortest decimal form of a number, and the power of
/// ten of the last one.
fn precision(x: f64) -> (usize, i32) {
    let text = shortest(x.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let digits = mantissa.chars().filter(char::is_ascii_digit).skip_while(|c| *c == '0').count();
    let exponent: i32 = exponent.parse().unwrap_or_default();
    (digits, exponent - decimals as i32)
}

fn unit(place: i32) -> f64 {
    10f64.powi(place)
}

/// Returns |y| truncated after the digit with this power of ten. It works on decimal digits, because in
/// binary 4 - 3.99 is less than 0.01 due to rounding, and 3.99 would pass for 4 truncated.
fn cut_off(y: f64, place: i32) -> Option<f64> {
    // Round to as many digits as are reliable: a value that should be 6 may be 5.999999999999999.
    let text = format!("{:.11e}", y.abs());
    let (mantissa, exponent) = text.split_once('e')?;
    let first: i32 = exponent.parse().ok()?;
    let kept = usize::try_from(first - place + 1).ok().filter(|kept| *kept > 0)?;
    // The decimal point follows the first digit.
    let cut: String = mantissa.chars().take(if kept == 1 { 1 } else { kept + 1 }).collect();
    format!("{cut}e{exponent}").parse().ok()
}

/// Maximum relative difference between an answer and the right one that counts as rounding error.
const TOLERANCE: f64 = 1e-9;

/// A condition that an answer must meet.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Condition {
    /// At this t, the ray is on the surface.
    Meets(Ray, Surface),
    /// The point is on the surface.
    On(Surface),
    /// The point is on the ray's line.
    OnRay(Ray),
    /// The ray begins at this point.
    Eye(DVec3),
    /// The direction leads from the eye through this point of the viewport.
    Through {
        /// The camera's basis.
        basis: Basis,
        /// The viewport's distance from the eye.
        distance: f64,
        /// The point (u, v).
        uv: DVec2,
    },
    /// The point of the canonical viewport is the centre of a pixel.
    Pixel {
        /// W and H.
        size: DVec2,
        /// The pixel's column and row, counted as in the question.
        place: DVec2,
        /// The column and the row of the image's upper left corner, counted likewise. Pixels' centres
        /// are at whole numbers.
        first: f64,
    },
    /// The point is the ray's at this t. Nothing is said of points that are not on the ray.
    At(Ray, f64),
    /// The number results from this formula.
    Formula(&'static str),
}

/// A surface, or a line in two dimensions, on which an answer must lie. In two dimensions, z is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    /// The plane with this z.
    Wall(f64),
    /// A sphere.
    Sphere(Sphere),
    /// The line `a x + b y + c = 0`, stored as (a, b, c).
    Line(DVec3),
}

impl Condition {
    /// Returns a phrase that says how an answer of one, two or three numbers violates the condition;
    /// `None` if it meets the condition.
    fn missed_by(&self, given: &[f64]) -> Option<String> {
        let point = |given: &[f64]| match *given {
            [x, y] => Some(DVec3::new(x, y, 0.0)),
            [x, y, z] => Some(DVec3::new(x, y, z)),
            _ => None,
        };
        match (self, given) {
            (Condition::Meets(ray, surface), [t]) => surface.missed_by(ray.at(*t), true),
            (Condition::Meets(..), _) => None,
            (Condition::On(surface), _) => surface.missed_by(point(given)?, false),
            (Condition::OnRay(ray), _) => {
                let from = point(given)? - ray.origin;
                let distance = from.cross(ray.direction).length() / ray.direction.length();
                is_off(distance, from.length())
                    .then(|| format!("it is not on the ray, but {} away from it", short(distance)))
            }
            (Condition::Eye(eye), _) => {
                let distance = point(given)?.distance(*eye);
                let from = "from the eye, where every view ray starts";
                is_off(distance, eye.length()).then(|| format!("it is {} {from}", short(distance)))
            }
            (Condition::Pixel { size, place, first }, _) => {
                let found =
                    (point(given)?.truncate() * DVec2::new(1.0, -1.0) + 0.5) * *size + *first;
                // Without the rounding errors of (u, v), which would be told as if they were typed.
                let found = (found * 1e9).round() / 1e9;
                let [column, row, wanted_column, wanted_row] =
                    [found.x, found.y, place.x, place.y].map(short);
                Some(format!(
                    "it is in column {column} and row {row}, not {wanted_column} and {wanted_row}"
                ))
            }
            (Condition::At(ray, t), _) => {
                let from = point(given)? - ray.origin;
                let found = from.dot(ray.direction) / ray.direction.length_squared();
                let (found, wanted) = (short(found), short(*t));
                Condition::OnRay(*ray)
                    .missed_by(given)
                    .is_none()
                    .then(|| format!("it is at 𝑡 = {found}, not at 𝑡 = {wanted}"))
            }
            (Condition::Formula(formula), _) => Some(format!("it should be {formula}")),
            (Condition::Through { basis, distance, uv }, _) => {
                let d = basis.to_camera_from_world(point(given)?);
                if d.z >= 0.0 {
                    let along_w = short(d.z);
                    return Some(format!(
                        "it does not point forwards: 𝐝 · 𝐰 is {along_w}, and must be below 0"
                    ));
                }
                let passed = d.truncate() * (distance / -d.z);
                let text = equated_tuple(&passed.to_array(), 5);
                let wanted = format!("({}, {})", short(uv.x), short(uv.y));
                is_off(passed.distance(*uv), passed.length())
                    .then(|| format!("it passes the viewport at (𝑢, 𝑣) {text}, not {wanted}"))
            }
        }
    }
}

impl Surface {
    /// Returns a phrase that says by how much a point misses the surface; `None` if it is on the
    /// surface. `is_of_ray` is true if the answer is a t, and the point is the ray's point at that t.
    fn missed_by(self, point: DVec3, is_of_ray: bool) -> Option<String> {
        let it = if is_of_ray { "the point at this 𝑡" } else { "it" };
        let (off, finding) = match self {
            Surface::Wall(wall) => {
                let its = if is_of_ray { "at this 𝑡, 𝑧" } else { "its 𝑧" };
                let (z, wanted) = (short(point.z), short(wall));
                (point.z - wall, format!("{its} is {z}, not the wall's {wanted}"))
            }
            Surface::Sphere(Sphere { center, radius }) => {
                let away = point.distance(center);
                let (distance, wanted) = (short(away), short(radius));
                let says = format!(
                    "{it} is not on the sphere: it is {distance} from the centre, and the radius is \
                     {wanted}"
                );
                (away - radius, says)
            }
            Surface::Line(DVec3 { x: a, y: b, z: c }) => {
                let value = a * point.x + b * point.y + c;
                let gives = short(value);
                (
                    value,
                    format!(
                        "{it} is not on the line: put into its equation, it gives {gives}, not 0"
                    ),
                )
            }
        };
        is_off(off, point.length()).then_some(finding)
    }
}

/// Returns true if a difference between numbers of magnitude `size` is larger than rounding errors can
/// explain.
fn is_off(difference: f64, size: f64) -> bool {
    difference.abs() > TOLERANCE * size.max(1.0)
}

/// Returns the length of the vector of these numbers; 1 if all of them are zero.
fn size(numbers: &[f64]) -> f64 {
    let size = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size == 0.0 { 1.0 } else { size }
}

/// Returns true if the given numbers are the right ones, up to rounding errors.
pub(super) fn is_near(given: &[f64], truth: &[f64]) -> bool {
    let size = size(truth);
    given.iter().zip(truth).all(|(x, y)| (x - y).abs() <= TOLERANCE * size)
}
