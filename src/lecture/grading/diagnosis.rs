//! The mistakes that explain the answers.

use rayon::prelude::*;

use super::grade::AnswerValue;
use crate::mistakes::{GivenCamera, Mistake, Pipeline, PipelineCamera, Way};

/// The mistakes that explain wrong answers.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The smallest set of known mistakes with which a program gives all of these answers,
    /// including the right ones. It contains one mistake, or two of [`Mistake::GRADED`]. Of several
    /// such sets, it is the first in the order of [`Mistake::GRADED`] and [`Mistake::ALONE`]. In
    /// that order, `v = u x w` is the last graded mistake unless a basis is answered, because rays
    /// cannot distinguish it from rows that count from the bottom. The set is empty if there is
    /// none, and if nothing is wrong.
    pub mistakes: Vec<Mistake>,
    /// Other sets of the same size that give the same answers, in the same order.
    pub alternatives: Vec<Vec<Mistake>>,
    /// A slip that gives these answers, if no other single mistake does.
    pub other: Option<Mistake>,
    /// True if all answers would be right if rows and columns counted from 1.
    pub counted_from_one: bool,
    /// True if the answers were read as counting from 1, and all would be right if they counted
    /// from 0.
    pub counted_from_zero: bool,
    /// Objects are counted from 1.
    pub objects_from_one: bool,
    /// True if there are mistakes, and every wrong answer is a miss or a hit of an object behind
    /// the right one. A program that does not see the nearer object gives such answers, for
    /// whatever reason.
    pub may_be_unseen: bool,
    /// The step between the answers that were compared with the named pipeline. It is 1, for all of
    /// them, unless there are so many answers and spheres that the comparison would take minutes; 0 if
    /// nothing was compared.
    pub of_every: usize,
}

/// What the answers of a kind are compared with, and how exactly.
#[derive(Clone, Copy)]
pub(super) struct GradingContext<'a> {
    pub(super) given: &'a GivenCamera,
    /// The camera without any mistake.
    pub(super) right: PipelineCamera,
    /// The maximum relative error, or levels of 255 for a picture.
    pub(super) tolerance: f64,
    /// The share of the unwritten digits' uncertainty that is allowed.
    pub(super) digits: f64,
}

/// Answers of one kind, compared with the truth and with pipelines.
pub(super) trait Fits: Sync {
    /// Returns the number of answers.
    fn len(&self) -> usize;

    /// Returns true if the answers are u, v and w themselves.
    fn shows_basis(&self) -> bool {
        false
    }

    /// Calculates everything that must be known before the first answer is compared.
    fn prepare(&self, _camera: &mut PipelineCamera) {}

    /// Returns the approximate number of spheres that each answer is tested against.
    fn work(&self, _pipeline: &Pipeline) -> usize {
        1
    }

    /// Returns true if the pipeline may have given this answer.
    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool;

    /// Returns true if a program that does not see the first object hit may have given this answer.
    fn may_be_unseen(&self, _index: usize) -> bool {
        false
    }

    /// Returns what the answers are compared with.
    fn context(&self) -> &GradingContext<'_>;

    /// Returns this answer's distance from the truth, in the units of the tolerance.
    fn error(&self, index: usize) -> f64;

    /// Returns the right answer in place of this one.
    fn right(&self, index: usize) -> AnswerValue;
}

/// Number of wrong answers, and of right answers, that are compared before all others.
const FIRST_LOOKS: usize = 64;

/// Maximum number of sphere tests for a pipeline's rays, which take some seconds.
const MOST_WORK: usize = 50_000_000;

/// Finds the smallest set of mistakes. `is_right` is true for the answers that need none; at least
/// one answer is wrong.
pub(super) fn diagnose(
    given: &GivenCamera,
    answers: &dyn Fits,
    is_right: &[bool],
    may_be_single: bool,
) -> Diagnosis {
    let looks = first_looks(is_right);
    let named = |found: Vec<_>| {
        let may_be_unseen = !found.is_empty()
            && (0..is_right.len())
                .into_par_iter()
                .all(|index| is_right[index] || answers.may_be_unseen(index));
        Diagnosis { may_be_unseen, ..Diagnosis::new(found) }
    };
    let mut known = Mistake::GRADED.to_vec();
    known.retain(|mistake| may_be_single || *mistake != Mistake::SinglePrecision);
    if !answers.shows_basis() {
        // Both mistakes turn the picture upside down, so rays cannot distinguish them, but a basis
        // can.
        known.sort_by_key(|mistake| *mistake == Mistake::VIsUCrossW);
    }
    let alone = known.iter().chain(Mistake::ALONE);
    let mut sets: Vec<(Vec<Mistake>, Vec<Pipeline>)> =
        alone.map(|mistake| (vec![*mistake], mistake.pipelines().collect())).collect();
    let found = explaining(given, answers, &looks, &sets);
    if !found.is_empty() {
        let is_found = |way: Way| {
            found[0].0 == [Mistake::CountedFromOne]
                && explains(given, answers, &looks, &Pipeline::RIGHT.with(way))
        };
        let counted_from_one = is_found(Pipeline::count_pixels_from_one);
        let objects_from_one = !counted_from_one
            && (is_found(Pipeline::count_objects_from_one)
                || is_found(Pipeline::count_all_from_one));
        let counted_from_zero = is_found(|pipeline| pipeline.move_in_pixel(1.0, 1.0));
        return Diagnosis { counted_from_one, counted_from_zero, objects_from_one, ..named(found) };
    }
    sets.clear();
    for (k, first) in known.iter().enumerate() {
        for second in &known[k + 1..] {
            let pipelines = first.pipelines().flat_map(|pipeline| second.pipelines_from(pipeline));
            let mut both = vec![*first, *second];
            both.sort_unstable();
            sets.push((both, pipelines.collect()));
        }
    }
    let explains_all = |mistake: &&Mistake| {
        mistake.pipelines().any(|pipeline| explains(given, answers, &looks, &pipeline))
    };
    let other = OTHERS.iter().find(explains_all).copied();
    Diagnosis { other, ..named(explaining(given, answers, &looks, &sets)) }
}

/// Mistakes that appear in rays as two of [`Mistake::GRADED`].
const OTHERS: [Mistake; 2] = [Mistake::RayReversed, Mistake::DistanceAdded];

impl Diagnosis {
    fn new(found: Vec<(Vec<Mistake>, usize)>) -> Diagnosis {
        let of_every = found.first().map_or(0, |(_, of_every)| *of_every);
        let mut sets = found.into_iter().map(|(mistakes, _)| mistakes);
        let mistakes = sets.next().unwrap_or_default();
        Diagnosis { mistakes, alternatives: sets.collect(), of_every, ..Diagnosis::default() }
    }
}

/// Returns the sets of mistakes with a pipeline that gives all the answers, and for each the step
/// between the compared answers.
fn explaining(
    given: &GivenCamera,
    answers: &dyn Fits,
    looks: &[usize],
    sets: &[(Vec<Mistake>, Vec<Pipeline>)],
) -> Vec<(Vec<Mistake>, usize)> {
    let explains = |pipeline: &&Pipeline| explains(given, answers, looks, pipeline);
    let found = sets.iter().filter_map(|(mistakes, pipelines)| {
        let pipeline = pipelines.iter().find(explains)?;
        Some((mistakes.clone(), stride(answers, pipeline)))
    });
    found.collect()
}

/// Returns true if the pipeline gives all the answers.
fn explains(given: &GivenCamera, answers: &dyn Fits, looks: &[usize], pipeline: &Pipeline) -> bool {
    let mut camera = given.camera_of(*pipeline);
    answers.prepare(&mut camera);
    let stride = stride(answers, pipeline);
    looks.iter().all(|index| answers.fits(&camera, *index))
        && (0..answers.len()).into_par_iter().step_by(stride).all(|k| answers.fits(&camera, k))
}

/// Returns the step between the answers that are compared with a pipeline.
fn stride(answers: &dyn Fits, pipeline: &Pipeline) -> usize {
    answers.len().saturating_mul(answers.work(pipeline)).div_ceil(MOST_WORK).max(1)
}

/// Returns the indices of some wrong answers and some right ones, spread evenly. They quickly rule
/// out a pipeline that did not give the answers.
fn first_looks(is_right: &[bool]) -> Vec<usize> {
    let some = |wanted: bool| {
        let all: Vec<usize> =
            (0..is_right.len()).filter(|index| is_right[*index] == wanted).collect();
        let step = (all.len() / FIRST_LOOKS).max(1);
        all.into_iter().step_by(step).take(FIRST_LOOKS).collect::<Vec<_>>()
    };
    [some(false), some(true)].concat()
}
