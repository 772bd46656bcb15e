//! The mistakes that explain the answers.

use rayon::prelude::*;

use super::grade::{Judged, Right};
use crate::mistakes::{GivenCamera, Mistake, Pipeline, PipelineCamera, Way};

/// The mistakes that explain wrong answers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The smallest set of known mistakes with which a program gives all of these answers, the
    /// right ones too: one, or two of [`Mistake::GRADED`]. Of several such sets, the first in the
    /// order of [`Mistake::GRADED`] and [`Mistake::ALONE`], in which `v = u x w` is the last that
    /// is graded unless a basis is answered: rays cannot tell it from rows that count from the
    /// bottom. Empty where there is none, and where nothing is wrong.
    pub mistakes: Vec<Mistake>,
    /// Other sets of as many that give the same answers here, in the same order.
    pub alternatives: Vec<Vec<Mistake>>,
    /// One slip that gives these answers, where no other mistake alone does.
    pub other: Option<Mistake>,
    /// All answers would be right if rows and columns counted from 1.
    pub counted_from_one: bool,
    /// All answers would be right if rows and columns began one earlier: at 0, where they were read as
    /// beginning at 1.
    pub counted_from_zero: bool,
    /// Objects are counted from 1.
    pub objects_from_one: bool,
    /// There are mistakes, and every wrong answer is a miss or a hit of what lies behind, as of a program
    /// that does not see the nearer object, for whatever reason.
    pub may_be_unseen: bool,
    /// The step between answers held against the pipeline that is named: 1, all of them, unless
    /// they are so many, and spheres too, that it would take minutes.
    pub of_every: usize,
}

/// Answers of some kind, held against the truth and against pipelines.
pub(super) trait Fits: Sync {
    /// The count of answers.
    fn len(&self) -> usize;

    /// Returns whether u, v and w themselves are answered.
    fn shows_basis(&self) -> bool {
        false
    }

    /// Finds what has to be known before the first answer is looked at.
    fn prepare(&self, _camera: &mut PipelineCamera) {}

    /// The count of spheres that one answer is held against, about.
    fn work(&self, _pipeline: &Pipeline) -> usize {
        1
    }

    /// Returns whether the pipeline may have given this answer.
    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool;

    /// Returns whether a program that does not see the object that is hit first may have given this
    /// answer.
    fn may_be_unseen(&self, _index: usize) -> bool {
        false
    }

    /// The verdict on this answer, and its distance from the truth.
    fn judged(&self, index: usize) -> Judged;

    /// The right answer in place of this one.
    fn right(&self, index: usize) -> Right;
}

/// Answers that are looked at before all others are.
const FIRST_LOOKS: usize = 64;

/// Maximum number of spheres that a pipeline's rays are held against, some seconds' work.
const MOST_WORK: usize = 50_000_000;

/// Finds the smallest set of mistakes; `is_right` says which answers need none, of which not all
/// do.
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
        // Both turn the picture upside down, and no ray tells them apart. A basis does.
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

/// Mistakes that rays show as two of [`Mistake::GRADED`].
const OTHERS: [Mistake; 2] = [Mistake::RayReversed, Mistake::DistanceAdded];

impl Default for Diagnosis {
    /// The diagnosis where nothing is wrong, or nothing explains it.
    fn default() -> Diagnosis {
        Diagnosis::new(Vec::new())
    }
}

impl Diagnosis {
    fn new(found: Vec<(Vec<Mistake>, usize)>) -> Diagnosis {
        let of_every = found.first().map_or(1, |(_, of_every)| *of_every);
        let mut sets = found.into_iter().map(|(mistakes, _)| mistakes);
        let mistakes = sets.next().unwrap_or_default();
        Diagnosis {
            mistakes,
            alternatives: sets.collect(),
            other: None,
            counted_from_one: false,
            counted_from_zero: false,
            objects_from_one: false,
            may_be_unseen: false,
            of_every,
        }
    }
}

/// The sets of which a pipeline gives all the answers, and the step between those looked at.
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

/// Returns whether the pipeline gives all the answers.
fn explains(given: &GivenCamera, answers: &dyn Fits, looks: &[usize], pipeline: &Pipeline) -> bool {
    let mut camera = given.camera_of(*pipeline);
    answers.prepare(&mut camera);
    let stride = stride(answers, pipeline);
    looks.iter().all(|index| answers.fits(&camera, *index))
        && (0..answers.len()).into_par_iter().step_by(stride).all(|k| answers.fits(&camera, k))
}

/// The step between answers that are held against a pipeline.
fn stride(answers: &dyn Fits, pipeline: &Pipeline) -> usize {
    answers.len().saturating_mul(answers.work(pipeline)).div_ceil(MOST_WORK).max(1)
}

/// Some wrong answers and some right ones, from all over: a program that did not give them is found
/// out at once.
fn first_looks(is_right: &[bool]) -> Vec<usize> {
    let some = |wanted: bool| {
        let all: Vec<usize> =
            (0..is_right.len()).filter(|index| is_right[*index] == wanted).collect();
        let step = (all.len() / FIRST_LOOKS).max(1);
        all.into_iter().step_by(step).take(FIRST_LOOKS).collect::<Vec<_>>()
    };
    [some(false), some(true)].concat()
}
