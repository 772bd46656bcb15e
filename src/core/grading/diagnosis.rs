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
    /// [`KnownMistake::ALL`]. Empty where there is none, and where nothing is wrong.
    pub mistakes: Vec<KnownMistake>,
    /// Other sets of as many that give the same answers here, in the same order.
    pub alternatives: Vec<Vec<KnownMistake>>,
}

/// Answers of some kind, held against a program.
pub(super) trait Fits: Sync {
    /// How many there are.
    fn len(&self) -> usize;

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
    let known = KnownMistake::ALL
        .into_iter()
        .filter(|mistake| may_be_single || *mistake != KnownMistake::SinglePrecision);
    let known: Vec<KnownMistake> = known.collect();
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
            let programs = one(*first).into_iter().flat_map(|program| {
                second.ways().iter().map(move |way| program.with(*way))
            });
            sets.push((vec![*first, *second], programs.collect()));
        }
    }
    Diagnosis::of(explaining(given, answers, &looks, &sets))
}

impl Diagnosis {
    fn of(mut found: Vec<Vec<KnownMistake>>) -> Diagnosis {
        let alternatives = if found.is_empty() { Vec::new() } else { found.split_off(1) };
        Diagnosis { mistakes: found.pop().unwrap_or_default(), alternatives }
    }
}

/// The sets of which a program gives all the answers.
fn explaining(
    given: &Given,
    answers: &dyn Fits,
    looks: &[usize],
    sets: &[(Vec<KnownMistake>, Vec<Program>)],
) -> Vec<Vec<KnownMistake>> {
    let explains = |program: &Program| {
        let mut camera = given.camera_of(*program);
        answers.prepare(&mut camera);
        looks.iter().all(|index| answers.fits(&camera, *index))
            && (0..answers.len()).into_par_iter().all(|index| answers.fits(&camera, index))
    };
    let found = sets.iter().filter(|(_, programs)| programs.iter().any(explains));
    found.map(|(mistakes, _)| mistakes.clone()).collect()
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
