//! Grading answers of every kind.

use std::cmp::Reverse;

use super::answers::{Answers, HitAnswer, Kind, Measured, RayAnswer};
use super::diagnosis::{Diagnosis, Fits, diagnose};
use super::digits::Precision;
use super::given::Given;
use super::hits::{Hits, truth_of};
use super::picture::{Picture, brightest, off, right_pictures};
use super::vectors::{Rays, Vectors};
use super::{
    Digits, Grade, Hit, Judged, KnownMistake, LEVELS_TOLERANCE, RELATIVE_TOLERANCE, Right, Truth,
    Worst, digits_wanted,
};
use crate::camera::CameraError;
use crate::image::Pixel;
use crate::shade::{Rgb, Shade};

/// Answers, and what they are graded by.
pub(super) struct Grader<'a> {
    truth: &'a Truth<'a>,
    answers: &'a Answers,
    given: Given,
    tolerance: f64,
    digits: Digits,
    /// The answers may be those of a program in `f32`.
    may_be_single: bool,
}

impl<'a> Grader<'a> {
    pub(super) fn new(
        truth: &'a Truth<'a>,
        answers: &'a Answers,
        tolerance: Option<f64>,
    ) -> Result<Grader<'a>, CameraError> {
        let given = Given::new(truth.camera)?;
        // Made here, and not within the parallel work that asks for it.
        let _ = truth.scene.index();
        let usual = match answers.kind() {
            Kind::Picture => LEVELS_TOLERANCE,
            _ => RELATIVE_TOLERANCE,
        };
        let tolerance = tolerance.unwrap_or(usual);
        let digits = Digits::for_tolerance(tolerance);
        let may_be_single = answers.may_be_single();
        Ok(Grader { truth, answers, given, tolerance, digits, may_be_single })
    }

    pub(super) fn grade(&self) -> Grade {
        let grade = match self.answers {
            Answers::Basis(vectors) => self.basis(vectors),
            Answers::Rays(rays) => self.rays(rays),
            Answers::Hits(hits) => self.hits(hits),
            Answers::Picture(pixels) => self.picture(pixels),
        };
        // Few digits fit pairs of mistakes by chance, and say nothing of `f32`.
        let least = match grade.diagnosis.mistakes[..] {
            _ if grade.all_agree() => return grade,
            [] => 1,
            [mistake] if mistake != KnownMistake::SinglePrecision => return grade,
            _ => 3,
        };
        match self.right_digits().filter(|digits| *digits >= least) {
            None => grade,
            right_digits => Grade { right_digits, diagnosis: Diagnosis::default(), ..grade },
        }
    }

    /// To how many digits the answers are right, if they all are as far as they are written, and these
    /// are too few.
    fn right_digits(&self) -> Option<u32> {
        let (answers, digits) = Precision::of(self.answers)?.allowed(self.answers);
        let too_few = 1..digits_wanted(self.tolerance) as i32;
        if !too_few.contains(&digits) {
            return None;
        }
        let Grader { tolerance, .. } = *self;
        let written = Digits::as_written();
        let judged = match &answers {
            Answers::Basis(answers) => {
                Vectors { answers, tolerance, digits: written }.judged(&self.given)
            }
            Answers::Rays(rays) => self.of_rays(rays, written).judged(&self.given),
            Answers::Hits(hits) => {
                let fits =
                    Hits { answers: hits, scene: self.truth.scene, tolerance, digits: written };
                fits.judged(&self.given, &self.first_of(hits))
            }
            Answers::Picture(_) => return None,
        };
        judged.iter().all(|judged| judged.is_right).then_some(digits as u32)
    }

    fn of_rays<'b>(&self, answers: &'b [RayAnswer], digits: Digits) -> Rays<'b> {
        let posed = &self.given.posed;
        let (size, image) = (posed.viewport().distance, posed.image());
        Rays { answers, tolerance: self.tolerance, digits, size, image }
    }

    /// What the rays of these answers hit first.
    fn first_of(&self, hits: &[HitAnswer]) -> Vec<Option<Hit>> {
        let pixels: Vec<Pixel> = hits.iter().map(|hit| hit.pixel).collect();
        truth_of(self.truth, &self.given.posed, &pixels)
    }

    fn basis(&self, vectors: &[Measured; 3]) -> Grade {
        let Grader { tolerance, digits, .. } = *self;
        let fits = Vectors { answers: vectors, tolerance, digits };
        let basis = self.given.posed.basis();
        let right = |index: usize| Right::Vector([basis.u, basis.v, basis.w][index]);
        self.graded(&fits.judged(&self.given), &fits, &right)
    }

    fn rays(&self, rays: &[RayAnswer]) -> Grade {
        let posed = &self.given.posed;
        let image = posed.image();
        let fits = self.of_rays(rays, self.digits);
        let right = |index: usize| match rays[index].pixel {
            pixel if image.contains(pixel) => Right::Ray(posed.ray_of_pixel(pixel)),
            _ => Right::NoPixel,
        };
        self.graded(&fits.judged(&self.given), &fits, &right)
    }

    fn hits(&self, hits: &[HitAnswer]) -> Grade {
        let Grader { tolerance, digits, .. } = *self;
        let image = self.given.posed.image();
        let fits = Hits { answers: hits, scene: self.truth.scene, tolerance, digits };
        let first = self.first_of(hits);
        let right = |index: usize| match hits[index].pixel {
            pixel if image.contains(pixel) => Right::Hit(first[index]),
            _ => Right::NoPixel,
        };
        self.graded(&fits.judged(&self.given, &first), &fits, &right)
    }

    /// A picture in the shading that fits best: that in which most pixels agree, or, where no mistake
    /// explains it in that, the one in which the fewest do.
    fn picture(&self, pixels: &[Rgb]) -> Grade {
        let (pictures, nearest) = right_pictures(self.truth, &self.given);
        let brightest = brightest(pixels);
        let agree = |right: &[Rgb]| {
            pixels.iter().zip(right).filter(|(a, b)| off(**a, **b) <= self.tolerance).count()
        };
        let mut order: Vec<usize> = (0..Shade::ALL.len()).collect();
        order.sort_by_key(|place| Reverse(agree(&pictures[*place])));
        let grade = |place: usize| {
            let fits = Picture {
                pixels,
                image: self.given.posed.image(),
                scene: self.truth.scene,
                color_of: self.truth.color_of,
                shade: Shade::ALL[place],
                tolerance: self.tolerance,
                brightest,
            };
            let right = &pictures[place];
            let judged = fits.judged(&self.given, right, nearest);
            let grade = self.graded(&judged, &fits, &|index| Right::Color(right[index]));
            Grade { shade: Some(fits.shade), ..grade }
        };
        let mut best = grade(order[0]);
        for place in &order[1..] {
            if best.all_agree() || best.diagnosis.mistakes.len() == 1 {
                break;
            }
            let other = grade(*place);
            let fewer = other.diagnosis.mistakes.len() < best.diagnosis.mistakes.len()
                || best.diagnosis.mistakes.is_empty();
            if other.all_agree() || fewer && !other.diagnosis.mistakes.is_empty() {
                best = other;
            }
        }
        best
    }

    fn graded(&self, judged: &[Judged], fits: &dyn Fits, right: &dyn Fn(usize) -> Right) -> Grade {
        let is_right: Vec<bool> = judged.iter().map(|judged| judged.is_right).collect();
        let diagnosis = if is_right.iter().all(|is_right| *is_right) {
            Diagnosis::default()
        } else {
            diagnose(&self.given, fits, &is_right, self.may_be_single)
        };
        let worst =
            worst_of(judged).map(|(index, error)| Worst { index, error, right: right(index) });
        let (kind, tolerance) = (self.answers.kind(), self.tolerance);
        let (shade, right_digits, unanswered) = (None, None, 0);
        Grade { kind, tolerance, is_right, worst, shade, diagnosis, right_digits, unanswered }
    }
}

/// The wrong answer that is farthest off, the first among equals; the right one where none is wrong.
fn worst_of(judged: &[Judged]) -> Option<(usize, f64)> {
    let any_wrong = judged.iter().any(|judged| !judged.is_right);
    let mut worst: Option<(usize, f64)> = None;
    for (index, judged) in judged.iter().enumerate() {
        if judged.is_right == any_wrong {
            continue;
        }
        if worst.is_none_or(|(_, error)| judged.error > error) {
            worst = Some((index, judged.error));
        }
    }
    worst
}
