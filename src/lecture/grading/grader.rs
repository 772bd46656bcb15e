//! Grades answers of every kind.

use std::cmp::Reverse;

use pinhole_core::{Pixel, Rgb, Shade};
use rayon::prelude::*;

use super::answers::{AnswerKind, Answers, HitAnswer, Precision};
use super::certainty::Certainty;
use super::diagnosis::{Diagnosis, Fits, GradingContext, diagnose};
use super::grade::{
    Grade, Hit, Judged, LEVELS_TOLERANCE, RELATIVE_TOLERANCE, Truth, Worst, digits_wanted,
};
use super::graded::Cell;
use super::hits::{Hits, Rays, Vectors, truth_of};
use super::picture::{Picture, brightest, contrast, off, right_pictures};
use crate::mistakes::{GivenCamera, Mistake, Pipeline, PipelineCamera};

/// Minimum number of digits with which a mistake is diagnosed in answers that have fewer digits than
/// they should.
const ENOUGH_FOR_MISTAKES: u32 = 3;

/// The answers, and everything needed to grade them.
pub(super) struct Grader<'a> {
    truth: &'a Truth<'a>,
    answers: &'a Answers,
    given: GivenCamera,
    tolerance: f64,
    /// The fraction, 0 to 1, of [`Written::rounding`](super::Written::rounding) that is allowed as an
    /// additional error.
    digits: f64,
    /// True if the answers may come from a program that computes in `f32`.
    may_be_single: bool,
}

impl<'a> Grader<'a> {
    pub(super) fn new(
        truth: &'a Truth<'a>,
        answers: &'a Answers,
        tolerance: Option<f64>,
    ) -> Result<Grader<'a>, String> {
        let given = GivenCamera::new(truth.camera).map_err(|error| error.to_string())?;
        let image = given.resolved.image();
        if answers.is_empty() && answers.kind() != AnswerKind::Picture {
            return Err("there is no answer to grade".to_owned());
        }
        if answers.kind() == AnswerKind::Picture && answers.len() as u64 != image.pixel_count() {
            let (pixels, w, h) = (answers.len(), image.width(), image.height());
            return Err(format!(
                "the picture has {pixels} pixels: it must have {w} x {h}, as the image"
            ));
        }
        // Build the scene's index here rather than within the parallel work that uses it.
        truth.scene.make_index();
        let usual = match answers.kind() {
            AnswerKind::Picture => LEVELS_TOLERANCE,
            _ => RELATIVE_TOLERANCE,
        };
        let tolerance = tolerance.unwrap_or(usual);
        if tolerance.is_nan() || tolerance < 0.0 {
            return Err(format!("the tolerance is {tolerance}: it must be a number of at least 0"));
        }
        let digits = (tolerance / RELATIVE_TOLERANCE).min(1.0);
        let may_be_single = answers.may_be_single();
        let grader = Grader { truth, answers, given, tolerance, digits, may_be_single };
        if let Answers::Hits(hits) = answers {
            let first = grader.first_of(hits);
            let is_beyond = |hit: &Option<Hit>| hit.is_some_and(|hit| !hit.t.is_normal());
            if let Some(index) = first.iter().position(is_beyond) {
                let Pixel { row, column } = hits[index].pixel;
                return Err(format!(
                    "the true t of row {row}, column {column} (counted from 0) is beyond the range of f64, \
                     in which answers are graded: scale width, height and distance of the viewport"
                ));
            }
        }
        Ok(grader)
    }

    pub(super) fn grade(&self) -> Grade {
        let grade = self.graded_as_given();
        match self.answers {
            Answers::Hits(hits) if grade.wrong() > 0 && !grade.is_explained() => {
                self.with_sentinel(hits, grade)
            }
            _ => grade,
        }
    }

    /// Returns the grade, with a new diagnosis if the student seems to write a certain number, such as
    /// -1, as t for a miss. That number is then treated as a miss.
    fn with_sentinel(&self, hits: &[HitAnswer], grade: Grade) -> Grade {
        let Some(sentinel) = sentinel(hits, &self.first_of(hits)) else { return grade };
        let taken = hits.iter().map(|answer| {
            let stands = answer.hit.and_then(|hit| hit.t).is_some_and(|t| t.value == sentinel);
            HitAnswer { hit: answer.hit.filter(|_| !stands), ..*answer }
        });
        let answers = Answers::Hits(taken.collect());
        let found = Grader { answers: &answers, ..*self }.graded_as_given();
        if found.wrong() > 0 && !found.is_explained() {
            return grade;
        }
        let Grade { diagnosis, right_digits, .. } = found;
        Grade { diagnosis, right_digits, sentinel: Some(sentinel), ..grade }
    }

    fn graded_as_given(&self) -> Grade {
        let right = self.given.camera_of(Pipeline::RIGHT);
        let grade = match self.held(self.answers, right, self.digits) {
            Ok(held) => self.graded(&*held, &right),
            Err(pixels) => return self.picture(pixels),
        };
        // With few digits, pairs of mistakes may fit by chance, and `f32` cannot be recognised.
        let least = match grade.diagnosis.mistakes[..] {
            _ if grade.wrong() == 0 => return grade,
            [] => 1,
            [mistake] if mistake != Mistake::SinglePrecision => return grade,
            _ => 3,
        };
        let Some((answers, digits)) = self.few_digits() else { return grade };
        let Ok(held) = self.held(&answers, right, 1.0) else { return grade };
        let right_digits = Some(digits);
        if digits >= least && self.judged(&*held, &right).iter().all(|judged| judged.is_right) {
            return Grade { right_digits, diagnosis: Diagnosis::default(), ..grade };
        }
        if digits >= ENOUGH_FOR_MISTAKES {
            // Computation in `f32` is not considered as the reason for missing digits.
            let accepted: Vec<bool> =
                (0..grade.is_right.len()).map(|index| grade.cell(index) != Cell::Wrong).collect();
            let diagnosis = diagnose(&self.given, &*held, &accepted, false);
            if diagnosis.mistakes.len() == 1 {
                return Grade { right_digits, diagnosis, ..grade };
            }
        }
        grade
    }

    /// Returns, for answers that are written with fewer digits than they should be, the answers with
    /// the rounding errors that this implies, and the least number of significant digits of any
    /// answer; otherwise `None`.
    fn few_digits(&self) -> Option<(Answers, u32)> {
        let (answers, digits) = Precision::of_answers(self.answers)?.allowed(self.answers);
        let too_few = 1..digits_wanted(self.tolerance) as i32;
        too_few.contains(&digits).then_some((answers, digits as u32))
    }

    /// Returns the answers together with the data that is needed to compare them.
    ///
    /// # Errors
    /// If the answers are a picture, returns its pixels as an error, because its shading must be found
    /// first.
    fn held<'b>(
        &'b self,
        answers: &'b Answers,
        right: PipelineCamera,
        digits: f64,
    ) -> Result<Box<dyn Fits + 'b>, &'b [Rgb]> {
        let context = self.context(right, digits);
        Ok(match answers {
            Answers::Basis(answers) => Box::new(Vectors { answers, context }),
            Answers::Rays(answers) => Box::new(Rays { answers, context }),
            Answers::Hits(answers) => {
                let (first, scene) = (self.first_of(answers), self.truth.scene);
                Box::new(Hits { answers, first, scene, context })
            }
            Answers::Picture(pixels) => return Err(pixels),
        })
    }

    fn context(&self, right: PipelineCamera, digits: f64) -> GradingContext<'_> {
        let around = [[0.5, 0.0], [-0.5, 0.0], [0.0, 0.5], [0.0, -0.5]].map(|[across, down]| {
            let mut moved = Pipeline::RIGHT;
            moved.move_in_pixel(across, down);
            self.given.camera_of(moved)
        });
        GradingContext { given: &self.given, right, around, tolerance: self.tolerance, digits }
    }

    /// Returns the true first hits for the pixels of these answers.
    fn first_of(&self, hits: &[HitAnswer]) -> Vec<Option<Hit>> {
        let pixels: Vec<Pixel> = hits.iter().map(|hit| hit.pixel).collect();
        truth_of(self.truth, &self.given.resolved, &pixels)
    }

    /// Grades a picture, whose shading is not known, by comparing it with the right picture in the
    /// shading that fits best. This is the one with which most pixels agree or, if no single mistake
    /// explains the picture so, the one with which the fewest mistakes explain it.
    fn picture(&self, pixels: &[Rgb]) -> Grade {
        let (pictures, objects, right) = right_pictures(self.truth, &self.given);
        let context = self.context(right, self.digits);
        let brightest = brightest(pixels);
        let agree = |right: &[Rgb]| {
            pixels.iter().zip(right).filter(|(a, b)| off(**a, **b) <= self.tolerance).count()
        };
        let mut order: Vec<usize> = (0..Shade::ALL.len()).collect();
        order.sort_by_key(|k| Reverse(agree(&pictures[*k])));
        let grade = |k: usize| {
            let fits = Picture {
                pixels,
                scene: self.truth.scene,
                color_of: self.truth.color_of,
                shade: Shade::ALL[k],
                brightest,
                right: &pictures[k],
                objects: &objects,
                contrast: contrast(&pictures[k], &objects),
                context,
            };
            Grade { shade: Some(fits.shade), ..self.graded(&fits, &right) }
        };
        let mut best = grade(order[0]);
        for k in &order[1..] {
            if best.wrong() == 0 || best.diagnosis.mistakes.len() == 1 {
                break;
            }
            let other = grade(*k);
            let fewer = other.diagnosis.mistakes.len() < best.diagnosis.mistakes.len()
                || best.diagnosis.mistakes.is_empty();
            if other.wrong() == 0 || fewer && !other.diagnosis.mistakes.is_empty() {
                best = other;
            }
        }
        best
    }

    /// Returns, for each answer, its error and whether it is right. An answer is right if its error is
    /// within the tolerance, or if a program without mistakes could give it, such as a miss of a
    /// sphere that the ray grazes.
    fn judged(&self, answers: &dyn Fits, right: &PipelineCamera) -> Vec<Judged> {
        let judged = |index| {
            let error = answers.error(index);
            let is_right = error <= self.tolerance || answers.fits(right, index);
            Judged { is_right, error }
        };
        (0..self.answers.len()).into_par_iter().map(judged).collect()
    }

    fn graded(&self, answers: &dyn Fits, right: &PipelineCamera) -> Grade {
        let judged = self.judged(answers, right);
        let mut is_right: Vec<bool> = judged.iter().map(|judged| judged.is_right).collect();
        let diagnosis = if is_right.iter().all(|is_right| *is_right) {
            Diagnosis::default()
        } else {
            diagnose(&self.given, answers, &is_right, self.may_be_single)
        };
        let certainty = |index: usize| match is_right[index] {
            true => answers.certainty(index),
            false => Certainty::Sure,
        };
        let found: Vec<_> = (0..judged.len()).into_par_iter().map(certainty).collect();
        let doubtful = (0..found.len()).filter(|index| found[*index] == Certainty::Doubtful);
        let not_judged: Vec<usize> = doubtful.collect();
        not_judged.iter().for_each(|index| is_right[*index] = false);
        let worst = worst_of(&judged, &not_judged);
        let tie = |found| if let Certainty::Tie(objects) = found { Some(objects) } else { None };
        let ties = found.into_iter().filter_map(tie).collect();
        Grade {
            kind: self.answers.kind(),
            tolerance: self.tolerance,
            is_right,
            not_judged,
            ties,
            worst: worst.map(|(index, error)| Worst { index, error, right: answers.right(index) }),
            shade: None,
            diagnosis,
            right_digits: None,
            sentinel: None,
            unanswered: 0,
        }
    }
}

/// Returns the number, such as -1, that the student writes as t for a miss; `None` if there is none.
/// Only numbers of at most 0 and numbers larger than the true t of all hits are considered. The number
/// must be the t of more than half of the answers that have such a t where a miss would be right.
fn sentinel(hits: &[HitAnswer], first: &[Option<Hit>]) -> Option<f64> {
    let farthest = first.iter().flatten().map(|hit| hit.t).fold(0.0, f64::max);
    let misses = hits.iter().zip(first).filter(|(_, first)| first.is_none());
    let t = misses.filter_map(|(answer, _)| Some(answer.hit?.t?.value));
    let mut given: Vec<f64> = t.filter(|t| *t <= 0.0 || *t > farthest).collect();
    given.sort_unstable_by(f64::total_cmp);
    let known = *given.get(given.len() / 2)?;
    let count = given.iter().filter(|t| **t == known).count();
    (2 * count > given.len()).then_some(known)
}

/// Returns the index and the error of the wrong answer with the largest error or, if no answer is
/// wrong, of the right answer with the largest error. If several errors are equal, the first answer is
/// returned. Returns `None` if no answer is judged.
fn worst_of(judged: &[Judged], not_judged: &[usize]) -> Option<(usize, f64)> {
    let any_wrong = judged.iter().any(|judged| !judged.is_right);
    let candidates = judged.iter().enumerate().filter(|(index, judged)| {
        judged.is_right != any_wrong && not_judged.binary_search(index).is_err()
    });
    let worst = candidates.rev().max_by(|(_, a), (_, b)| a.error.total_cmp(&b.error));
    worst.map(|(index, judged)| (index, judged.error))
}
