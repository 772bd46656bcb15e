//! Which mistakes explain the answers.

use rayon::prelude::*;

use super::KnownMistake;
use super::given::{Given, ProgramCamera};
use super::program::Program;

/// The mistakes that explain wrong answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// The smallest set of known mistakes with which a program gives all of these answers, the right
    /// ones too: one, or two. Of several such sets, the first in the order of
    /// [`KnownMistake::ALL`], in which `v = u x w` comes last unless a basis is answered: rays cannot
    /// tell it from rows that count from the bottom. Empty where there is none, and where nothing is
    /// wrong.
    pub mistakes: Vec<KnownMistake>,
    /// Other sets of as many that give the same answers here, in the same order.
    pub alternatives: Vec<Vec<KnownMistake>>,
    /// Whether no single known mistake gives these answers, but rays do that are right except that they
    /// lead back to the eye: `d = eye - point`.
    pub reversed: bool,
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

    /// Whether the program may have given this answer.
    fn fits(&self, camera: &ProgramCamera, index: usize) -> bool;
}

/// Answers that are looked at before all others are.
const FIRST_LOOKS: usize = 64;

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
        return Diagnosis::of(found);
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
    let reversed = explains(given, answers, &looks, &Program::REVERSED);
    Diagnosis { reversed, ..Diagnosis::of(explaining(given, answers, &looks, &sets)) }
}

impl Diagnosis {
    /// What gives the same answers as the mistakes named, where that is one slip in place of two.
    pub fn or_reversed(&self) -> Option<&'static str> {
        let is_one_for_two = self.reversed && !self.mistakes.is_empty();
        is_one_for_two.then_some("Or every ray leads back to the eye: it is d = point - eye.")
    }

    fn of(mut found: Vec<Vec<KnownMistake>>) -> Diagnosis {
        let alternatives = if found.is_empty() { Vec::new() } else { found.split_off(1) };
        Diagnosis { mistakes: found.pop().unwrap_or_default(), alternatives, reversed: false }
    }
}

/// The sets of which a program gives all the answers.
fn explaining(
    given: &Given,
    answers: &dyn Fits,
    looks: &[usize],
    sets: &[(Vec<KnownMistake>, Vec<Program>)],
) -> Vec<Vec<KnownMistake>> {
    let explains = |program: &Program| explains(given, answers, looks, program);
    let found = sets.iter().filter(|(_, programs)| programs.iter().any(explains));
    found.map(|(mistakes, _)| mistakes.clone()).collect()
}

/// Whether the program gives all the answers.
fn explains(given: &Given, answers: &dyn Fits, looks: &[usize], program: &Program) -> bool {
    let mut camera = given.camera_of(*program);
    answers.prepare(&mut camera);
    looks.iter().all(|index| answers.fits(&camera, *index))
        && (0..answers.len()).into_par_iter().all(|index| answers.fits(&camera, index))
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
