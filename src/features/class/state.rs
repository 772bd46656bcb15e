//! The answers of a class: how many are right, and how many show which mistake.

use std::collections::{BTreeMap, BTreeSet};
use std::iter::repeat_n;

use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{Exercise, Verdict};
use pinhole_lecture::grading::Grade;
use serde::Serialize;

use super::code::codes_in;
use crate::features::exercises::state::{Exercises, Feedback};

/// The answers of a class, counted, each graded by its own question.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ClassAnswers {
    /// The exercises with an answer, in the lecture's order.
    pub exercises: Vec<ClassExercise>,
    /// The codes that cannot be read, each with its line, counted from 1, and the reason.
    pub not_readable: Vec<(usize, String)>,
    /// The lines without a code that are not empty.
    pub lines_without: usize,
}

/// The answers of a class to an exercise.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ClassExercise {
    /// The exercise's name in files.
    pub exercise: &'static str,
    /// The exercise's title, the number of answers, and how many were sent after the solution was shown.
    pub title: String,
    /// The number of answers.
    pub answers: usize,
    /// The number of answers that were sent after the solution was shown.
    pub saw_solution: usize,
    /// What was found in them.
    #[serde(flatten)]
    pub tally: Tally,
}

/// What was found in the answers of a class.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// How often each outcome was found: [`RIGHT`] first, then the most common one. A mistake has the name that
    /// `pinhole check` uses. An answer with several mistakes counts for each.
    pub counts: Vec<(String, usize)>,
    /// The name of each mistake that was found, and what is wrong.
    pub explanations: Vec<String>,
}

/// The outcome of an answer that is right in all parts.
pub const RIGHT: &str = "right";
/// The outcome of a wrong answer that no known mistake explains.
const OTHER: &str = "another mistake";
/// The outcome of an answer in which nothing is wrong, but something is missing.
pub(crate) const INCOMPLETE: &str = "not complete";
/// The outcome of answers none of which can be judged.
pub(crate) const NOT_JUDGED: &str = "not judged";
/// The outcome of answers that are right to the digits with which they are written.
const FEW_DIGITS: &str = "too few digits";

impl Tally {
    /// Counts the outcomes of each answer. `explain` says what is wrong with a mistake.
    pub(crate) fn new(
        all: impl Iterator<Item = BTreeSet<String>>,
        mistakes: &BTreeSet<Mistake>,
        explain: impl Fn(Mistake) -> &'static str,
    ) -> Tally {
        let mut counts: BTreeMap<String, usize> = BTreeMap::new();
        for outcome in all.flatten() {
            *counts.entry(outcome).or_default() += 1;
        }
        let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
        counts.sort_by_key(|(outcome, count)| (outcome != RIGHT, usize::MAX - count));
        let explained = |one: &Mistake| format!("{}: {}", one.id(), explain(*one));
        Tally { counts, explanations: mistakes.iter().map(explained).collect() }
    }
}

impl ClassAnswers {
    /// Reads and grades all codes in a text.
    pub fn read(text: &str) -> ClassAnswers {
        let mut class = ClassAnswers::default();
        let mut all: Vec<Findings> = Exercise::LISTED.iter().map(|_| Findings::default()).collect();
        let mut add = |own: &Exercises| {
            let exercise = own.question().exercise;
            let found = Exercise::LISTED.iter().zip(&mut all).find(|(one, _)| **one == exercise);
            found.into_iter().for_each(|(_, found)| found.add(own));
        };
        for (line, text) in (1..).zip(text.lines()) {
            let mut codes = codes_in(text).peekable();
            if codes.peek().is_none() && !text.trim().is_empty() {
                class.lines_without += 1;
            }
            for code in codes {
                match code {
                    Ok(answers) => add(&answers),
                    Err(problem) => class.not_readable.push((line, problem)),
                }
            }
        }
        let answered = Exercise::LISTED.iter().zip(&all).filter(|(_, found)| found.answers > 0);
        class.exercises = answered.map(|(one, found)| ClassExercise::of(*one, found)).collect();
        class
    }

    /// Returns true if there are codes, and each is that of a right answer.
    pub fn all_right(&self) -> bool {
        let mut counts = self.exercises.iter().flat_map(|own| &own.tally.counts);
        self.not_readable.is_empty()
            && !self.exercises.is_empty()
            && counts.all(|(it, _)| it == RIGHT)
    }

    /// Returns a sentence for each code that cannot be read, and one about the lines without a code.
    pub fn problems(&self) -> impl Iterator<Item = String> {
        let count = self.lines_without;
        let without = format!("Lines without a code: {count}.");
        let broken = self.not_readable.iter();
        let broken = broken.map(|(line, problem)| format!("The code in line {line} is {problem}."));
        broken.chain(Some(without).filter(|_| count > 0))
    }
}

/// What is found in the answers to an exercise. The answers themselves are not kept, as there may be very many.
#[derive(Default)]
struct Findings {
    answers: usize,
    saw_solution: usize,
    /// How often these outcomes of an answer were found together.
    outcomes: BTreeMap<BTreeSet<String>, usize>,
    mistakes: BTreeSet<Mistake>,
}

impl Findings {
    fn add(&mut self, own: &Exercises) {
        self.answers += 1;
        self.saw_solution += usize::from(own.saw_solution);
        *self.outcomes.entry(outcomes(own, &mut self.mistakes)).or_default() += 1;
    }
}

impl ClassExercise {
    fn of(exercise: Exercise, found: &Findings) -> ClassExercise {
        let Findings { answers, saw_solution, outcomes, mistakes } = found;
        let plural = if *answers == 1 { "answer" } else { "answers" };
        let seen = match saw_solution {
            0 => String::new(),
            count => format!(", {count} after a look at the solution"),
        };
        let all = outcomes.iter().flat_map(|(outcome, count)| repeat_n(outcome.clone(), *count));
        ClassExercise {
            exercise: exercise.id(),
            title: format!("{}: {answers} {plural}{seen}", exercise.title()),
            answers: *answers,
            saw_solution: *saw_solution,
            tally: Tally::new(all, mistakes, |one| one.exercise_feedback()),
        }
    }
}

/// Returns all that is found in checked answers, and adds the mistakes.
fn outcomes(own: &Exercises, mistakes: &mut BTreeSet<Mistake>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let feedback = || own.answers.iter().filter_map(|typed| typed.feedback.as_ref());
    for said in feedback() {
        if let Feedback::Judged(Verdict::Mistakes(any)) = said {
            // Which one of them was made cannot be told.
            found.insert(any.iter().map(|one| one.id()).collect::<Vec<_>>().join(" or "));
            mistakes.extend(any);
        }
    }
    if found.is_empty() {
        let is_wrong = feedback().any(Feedback::is_wrong);
        let outcome = if own.is_right() { RIGHT } else { INCOMPLETE };
        found.insert(if is_wrong { OTHER } else { outcome }.to_owned());
    }
    found
}

/// Returns all that is found in a file's graded answers, and adds the mistakes.
pub(crate) fn outcomes_of_grade(
    grade: &Grade,
    mistakes: &mut BTreeSet<Mistake>,
) -> BTreeSet<String> {
    let made = &grade.diagnosis.mistakes;
    let other = grade.diagnosis.other.filter(|_| made.is_empty());
    let made: Vec<Mistake> = made.iter().copied().chain(other).collect();
    mistakes.extend(&made);
    if !made.is_empty() {
        return made.iter().map(|one| one.id().to_owned()).collect();
    }
    let outcome = match grade.right_digits {
        _ if grade.passes() => RIGHT,
        _ if !grade.is_judged() => NOT_JUDGED,
        _ if grade.wrong() == 0 => INCOMPLETE,
        Some(_) => FEW_DIGITS,
        None => OTHER,
    };
    BTreeSet::from([outcome.to_owned()])
}

/// The codes that a lecturer has collected, and what they say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ClassCodes {
    /// The text with the codes.
    pub text: String,
    /// The text that was removed last.
    pub removed: String,
    /// The answers in it, as of the last `update`.
    pub answers: ClassAnswers,
}

impl ClassCodes {
    /// Adds a text with codes.
    pub(crate) fn add(&mut self, text: &str) {
        self.text = [&self.text, text].join("\n").trim().to_owned();
        self.update();
    }

    /// Removes all codes or, if there are none, brings back those that were removed.
    pub(crate) fn remove_or_bring_back(&mut self) {
        let back =
            if self.text.is_empty() { std::mem::take(&mut self.removed) } else { String::new() };
        self.removed = std::mem::replace(&mut self.text, back);
        self.update();
    }

    /// Reads the text again.
    pub(crate) fn update(&mut self) {
        self.answers = ClassAnswers::read(&self.text);
    }
}
