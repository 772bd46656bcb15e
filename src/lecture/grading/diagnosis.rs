//! Finds the mistakes that explain a student's wrong answers.

use rayon::prelude::*;

use super::certainty::Certainty;
use super::grade::AnswerValue;
use crate::mistakes::{GivenCamera, Mistake, Pipeline, PipelineCamera, Way};

/// The mistakes that explain wrong answers, and remarks on them.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The smallest set of known mistakes with which a program gives all of these answers, including
    /// the right ones. It contains one mistake, or two of [`Mistake::GRADED`]. It is empty if there is
    /// no such set, or if all answers are right.
    ///
    /// Of several such sets, it is the first in the order of [`Mistake::GRADED`] and
    /// [`Mistake::ALONE`]. Unless the answers are a basis, `v = u x w` comes last in
    /// [`Mistake::GRADED`], because it gives the same rays as counting rows from the bottom.
    pub mistakes: Vec<Mistake>,
    /// Other sets with as many mistakes that lead to the same answers, in the same order.
    pub alternatives: Vec<Vec<Mistake>>,
    /// One of [`Mistake::RayReversed`] and [`Mistake::DistanceAdded`], if it leads to these answers and
    /// no other single mistake does.
    pub other: Option<Mistake>,
    /// True if all answers are right when rows and columns are counted from 1.
    pub counted_from_one: bool,
    /// True if rows and columns were read as counted from 1, but all answers are right when they are
    /// counted from 0.
    pub counted_from_zero: bool,
    /// True if objects are counted from 1.
    pub objects_from_one: bool,
    /// True if mistakes are named, and every wrong answer is a miss or a hit of an object behind the
    /// right one. Such answers may also come from a program that, for any reason, does not see the
    /// nearer object.
    pub may_be_unseen: bool,
    /// Says that one in this many answers was compared with those of a program that makes the named
    /// mistakes. It is 1 if all were compared, and larger if there are so many answers and spheres that
    /// comparing all would take minutes. It is 0 if no mistakes are named.
    pub of_every: usize,
}

/// The camera with which answers are compared, and the allowed errors.
#[derive(Clone, Copy)]
pub(super) struct GradingContext<'a> {
    pub(super) given: &'a GivenCamera,
    /// The camera without any mistake.
    pub(super) right: PipelineCamera,
    /// This camera moved by half a pixel up, down, left and right.
    pub(super) around: [PipelineCamera; 4],
    /// Maximum error of an answer: relative or, for a picture, in levels (steps of an 8-bit channel).
    pub(super) tolerance: f64,
    /// The fraction, 0 to 1, of [`Written::rounding`](super::Written::rounding) that is allowed as an
    /// additional error.
    pub(super) digits: f64,
}

/// Answers of one kind, which can be compared with the right ones and with those of a pipeline (a
/// program that may make mistakes).
pub(super) trait Fits: Sync {
    /// Returns true if the answers are the basis vectors u, v and w themselves, not rays or hits.
    fn shows_basis(&self) -> bool {
        false
    }

    /// Completes a pipeline's camera with values that depend on the answers, before the first
    /// comparison.
    fn prepare(&self, _camera: &mut PipelineCamera) {}

    /// Returns the approximate number of spheres that must be tested to compare one answer with this
    /// pipeline.
    fn work(&self, _pipeline: &Pipeline) -> usize {
        1
    }

    /// Returns true if a program with this camera and its pipeline may have given the answer with this
    /// index.
    fn fits(&self, camera: &PipelineCamera, index: usize) -> bool;

    /// Returns true if an answer that [fits](Fits::fits) is evidence of such a program: most other answers
    /// would not fit.
    fn is_evidence(&self, _camera: &PipelineCamera, _index: usize) -> bool {
        true
    }

    /// Returns true if the answer may come from a program that does not see the object that the ray
    /// hits first: it is a miss, or a hit of an object behind.
    fn may_be_unseen(&self, _index: usize) -> bool {
        false
    }

    /// Returns whether an answer that is accepted is known to be right.
    fn certainty(&self, index: usize) -> Certainty;

    /// Returns the error of an answer, to be compared with [`GradingContext::tolerance`].
    fn error(&self, index: usize) -> f64;

    /// Returns the right answer.
    fn right(&self, index: usize) -> AnswerValue;
}

/// Maximum number of wrong answers, and of right ones, that are compared with a pipeline first, because
/// they rule out most pipelines quickly.
const FIRST_LOOKS: usize = 64;

/// Maximum number of sphere tests for comparing all answers with one pipeline, which takes some
/// seconds. If more are needed, the answers are sampled.
const MOST_WORK: usize = 50_000_000;

/// Finds the smallest set of mistakes that explains the answers. `is_right` is true for each right
/// answer; at least one answer is wrong.
pub(super) fn diagnose(
    given: &GivenCamera,
    answers: &dyn Fits,
    is_right: &[bool],
    may_be_single: bool,
) -> Diagnosis {
    let search = Search { given, answers, count: is_right.len(), looks: first_looks(is_right) };
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
        // `v = u x w` and rows counted from the bottom both turn the picture upside down. Rays cannot
        // distinguish them, but a basis can.
        known.sort_by_key(|mistake| *mistake == Mistake::VIsUCrossW);
    }
    let alone = known.iter().chain(Mistake::ALONE);
    let mut sets: Vec<(Vec<Mistake>, Vec<Pipeline>)> =
        alone.map(|mistake| (vec![*mistake], mistake.pipelines().collect())).collect();
    let found = search.explaining(&sets);
    if !found.is_empty() {
        let is_found = |way: Way| {
            found[0].0 == [Mistake::CountedFromOne] && search.explains(&Pipeline::RIGHT.with(way))
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
    let explains_all =
        |mistake: &&Mistake| mistake.pipelines().any(|pipeline| search.explains(&pipeline));
    let other = OTHERS.iter().find(explains_all).copied();
    Diagnosis { other, ..named(search.explaining(&sets)) }
}

/// Mistakes that, in rays, look like two of [`Mistake::GRADED`].
const OTHERS: [Mistake; 2] = [Mistake::RayReversed, Mistake::DistanceAdded];

impl Diagnosis {
    fn new(found: Vec<(Vec<Mistake>, usize)>) -> Diagnosis {
        let of_every = found.first().map_or(0, |(_, of_every)| *of_every);
        let mut sets = found.into_iter().map(|(mistakes, _)| mistakes);
        let mistakes = sets.next().unwrap_or_default();
        Diagnosis { mistakes, alternatives: sets.collect(), of_every, ..Diagnosis::default() }
    }
}

/// The answers that are compared with pipelines.
struct Search<'a> {
    given: &'a GivenCamera,
    answers: &'a dyn Fits,
    count: usize,
    /// The indices of the wrong and of the right ones that are compared first.
    looks: [Vec<usize>; 2],
}

impl Search<'_> {
    /// Returns those sets of mistakes for which some pipeline gives all the answers, each with the step
    /// between the answers that were compared.
    fn explaining(&self, sets: &[(Vec<Mistake>, Vec<Pipeline>)]) -> Vec<(Vec<Mistake>, usize)> {
        let found = sets.iter().filter_map(|(mistakes, pipelines)| {
            let pipeline = pipelines.iter().find(|pipeline| self.explains(pipeline))?;
            Some((mistakes.clone(), self.stride(pipeline)))
        });
        found.collect()
    }

    /// Returns true if the pipeline gives all the answers, and would not give any others just as well.
    fn explains(&self, pipeline: &Pipeline) -> bool {
        let mut camera = self.given.camera_of(*pipeline);
        self.answers.prepare(&mut camera);
        let all = (0..self.count).into_par_iter().step_by(self.stride(pipeline));
        self.looks.iter().flatten().all(|index| self.answers.fits(&camera, *index))
            && self.looks[0].iter().any(|index| self.answers.is_evidence(&camera, *index))
            && all.all(|index| self.answers.fits(&camera, index))
    }

    /// Returns the step between the answers that are compared with a pipeline: 1 if all are, more if
    /// there are too many.
    fn stride(&self, pipeline: &Pipeline) -> usize {
        self.count.saturating_mul(self.answers.work(pipeline)).div_ceil(MOST_WORK).max(1)
    }
}

/// Returns the indices of some wrong and some right answers, spread evenly. Comparing these first
/// quickly rules out most pipelines.
fn first_looks(is_right: &[bool]) -> [Vec<usize>; 2] {
    [false, true].map(|wanted| {
        let all: Vec<usize> =
            (0..is_right.len()).filter(|index| is_right[*index] == wanted).collect();
        let step = (all.len() / FIRST_LOOKS).max(1);
        all.into_iter().step_by(step).take(FIRST_LOOKS).collect()
    })
}
