//! Which mistakes explain the answers.

use rayon::prelude::*;

use super::KnownMistake;
use super::given::{Given, ProgramCamera};
use super::program::{Change, Program};

/// The mistakes that explain wrong answers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The smallest set of known mistakes with which a program gives all of these answers, the right
    /// ones too: one, or two. Of several such sets, the first in the order of
    /// [`KnownMistake::ALL`], in which `v = u x w` comes last unless a basis is answered: rays cannot
    /// tell it from rows that count from the bottom. Empty where there is none, and where nothing is
    /// wrong.
    pub mistakes: Vec<KnownMistake>,
    /// Other sets of as many that give the same answers here, in the same order.
    pub alternatives: Vec<Vec<KnownMistake>>,
    /// The slip that gives these answers, where no single known mistake does.
    pub other_slip: Option<OtherSlip>,
    /// Whether all answers would be right if rows and columns counted from 1.
    pub counted_from_one: bool,
    /// Whether objects are counted from 1.
    pub objects_from_one: bool,
    /// Every how many answers were held against the program that is named: all, 1, unless they are so
    /// many, and spheres too, that it would take minutes.
    pub of_every: usize,
}

/// Answers of some kind, held against a program.
pub(super) trait Fits: Sync {
    /// How many there are.
    fn len(&self) -> usize;

    /// Whether u, v and w themselves are answered.
    fn shows_basis(&self) -> bool {
        false
    }

    /// What has to be known before the first answer is looked at.
    fn prepare(&self, _camera: &mut ProgramCamera) {}

    /// How many spheres one answer is held against, about.
    fn work(&self, _program: &Program) -> usize {
        1
    }

    /// Whether the program may have given this answer.
    fn fits(&self, camera: &ProgramCamera, index: usize) -> bool;
}

/// Answers that are looked at before all others are.
const FIRST_LOOKS: usize = 64;

/// So many spheres a program's rays are held against at most, some seconds' work.
const MOST_WORK: usize = 50_000_000;

/// Finds the smallest set of mistakes; `is_right` says which answers need none, of which not all do.
pub(super) fn diagnose(
    given: &Given,
    answers: &dyn Fits,
    is_right: &[bool],
    may_be_single: bool,
) -> Diagnosis {
    let looks = first_looks(is_right);
    let mut known = KnownMistake::ALL.to_vec();
    known.retain(|mistake| may_be_single || *mistake != KnownMistake::SinglePrecision);
    if !answers.shows_basis() {
        // Both turn the picture upside down, and no ray tells them apart. A basis does.
        known.sort_by_key(|mistake| *mistake == KnownMistake::VIsUCrossW);
    }
    let one = |mistake: KnownMistake| {
        let ways = mistake.ways().iter();
        ways.map(|way| Program::RIGHT.with(*way)).collect::<Vec<_>>()
    };
    let mut sets: Vec<(Vec<KnownMistake>, Vec<Program>)> =
        known.iter().map(|mistake| (vec![*mistake], one(*mistake))).collect();
    let found = explaining(given, answers, &looks, &sets);
    if !found.is_empty() {
        let is_found = |change: Change| {
            found[0].0 == [KnownMistake::CountedFromOne]
                && explains(given, answers, &looks, &Program::RIGHT.with(change))
        };
        let counted_from_one = is_found(Change::Shift(-1.0));
        let objects_from_one =
            !counted_from_one && (is_found(Change::ObjectsFromOne) || is_found(Change::AllFromOne));
        return Diagnosis { counted_from_one, objects_from_one, ..Diagnosis::of(found) };
    }
    sets.clear();
    for (place, first) in known.iter().enumerate() {
        for second in &known[place + 1..] {
            let programs = one(*first)
                .into_iter()
                .flat_map(|program| second.ways().iter().map(move |way| program.with(*way)));
            let mut both = vec![*first, *second];
            both.sort_unstable();
            sets.push((both, programs.collect()));
        }
    }
    let other_slip = Program::OTHER_SLIPS
        .iter()
        .find(|(program, _)| explains(given, answers, &looks, program))
        .map(|(_, slip)| *slip);
    Diagnosis { other_slip, ..Diagnosis::of(explaining(given, answers, &looks, &sets)) }
}

/// One slip that is none of the known mistakes: of rays, it looks like two of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OtherSlip {
    /// `d = eye - point`.
    RayReversed,
    /// `d = u U + v V + distance w`.
    DistanceAdded,
}

impl OtherSlip {
    /// What to look at.
    pub fn advice(self) -> &'static str {
        match self {
            OtherSlip::RayReversed => {
                "Look at the direction's sign: every ray leads back to the eye, and it is \
                 d = point - eye."
            }
            OtherSlip::DistanceAdded => {
                "Look at the direction's part along w: it is added, and it is -distance w."
            }
        }
    }
}

impl Default for Diagnosis {
    /// Nothing is wrong, or nothing explains it.
    fn default() -> Diagnosis {
        Diagnosis::of(Vec::new())
    }
}

impl Diagnosis {
    /// What gives the same answers as the mistakes named, where that is one slip in place of two.
    pub fn or_other_slip(&self) -> Option<&'static str> {
        self.other_slip.filter(|_| !self.mistakes.is_empty()).map(|slip| match slip {
            OtherSlip::RayReversed => "Or every ray leads back to the eye: it is d = point - eye.",
            OtherSlip::DistanceAdded => {
                "Or the direction's part along w is added: it is -distance w."
            }
        })
    }

    fn of(found: Vec<(Vec<KnownMistake>, usize)>) -> Diagnosis {
        let of_every = found.first().map_or(1, |(_, of_every)| *of_every);
        let mut sets = found.into_iter().map(|(mistakes, _)| mistakes);
        let mistakes = sets.next().unwrap_or_default();
        Diagnosis {
            mistakes,
            alternatives: sets.collect(),
            other_slip: None,
            counted_from_one: false,
            objects_from_one: false,
            of_every,
        }
    }
}

/// The sets of which a program gives all the answers, and every how many of them were looked at.
fn explaining(
    given: &Given,
    answers: &dyn Fits,
    looks: &[usize],
    sets: &[(Vec<KnownMistake>, Vec<Program>)],
) -> Vec<(Vec<KnownMistake>, usize)> {
    let explains = |program: &&Program| explains(given, answers, looks, program);
    let found = sets.iter().filter_map(|(mistakes, programs)| {
        let program = programs.iter().find(explains)?;
        Some((mistakes.clone(), step(answers, program)))
    });
    found.collect()
}

/// Whether the program gives all the answers.
fn explains(given: &Given, answers: &dyn Fits, looks: &[usize], program: &Program) -> bool {
    let mut camera = given.camera_of(*program);
    answers.prepare(&mut camera);
    let step = step(answers, program);
    looks.iter().all(|index| answers.fits(&camera, *index))
        && (0..answers.len()).into_par_iter().step_by(step).all(|k| answers.fits(&camera, k))
}

/// Every how many answers are held against a program.
fn step(answers: &dyn Fits, program: &Program) -> usize {
    answers.len().saturating_mul(answers.work(program)).div_ceil(MOST_WORK).max(1)
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
