//! The open exercise, the typed answers, and the feedback on them. The questions and the right answers
//! come from [`pinhole_lecture`]. No answer is stored or sent; which exercises are done
//! is stored (`progress.rs`).

use pinhole_exchange::document::{Document, Item, WALL_COLOR};
use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{
    Answer, Asked, Exercise, Question, QuestionPart, Verdict, follows,
};

use super::hints::Hint;
use crate::model::expression::evaluate;

/// The open exercise. A lesson's step sets it with [`Exercises::show`].
#[derive(Clone, Debug, PartialEq)]
pub struct Exercises {
    /// The question.
    question: Question,
    /// The seed of the question; `None` for the lecture's own question.
    seed: Option<u64>,
    /// The typed answers, one for each part of the question.
    pub(crate) answers: Vec<TypedAnswer>,
    /// True if the solution is shown.
    pub(crate) is_solved: bool,
    /// True if the solution was shown since the question was opened or cleared.
    pub(crate) saw_solution: bool,
    /// The mistake whose camera the user has asked to see.
    pub(crate) shown_mistake: Option<Mistake>,
    /// The hints that were given.
    pub(crate) hint: Option<Hint>,
    /// The other questions for which the user has typed answers. Their own `kept` lists are empty.
    kept: Vec<Exercises>,
}

/// The typed answer to one part of the question, and the feedback on it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct TypedAnswer {
    /// The texts of the number fields.
    pub(crate) fields: Vec<String>,
    /// The answer to a yes-or-no question.
    pub(crate) yes: Option<bool>,
    /// The feedback of the last check; `None` if the answer has been edited since.
    pub(crate) feedback: Option<Feedback>,
}

/// The feedback on one part of the question.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Feedback {
    /// There is no answer yet.
    NotAnswered,
    /// Some of the numbers are missing.
    Missing,
    /// The typed text is not a number, for the reason given here.
    NoNumber(String),
    /// The answer was judged.
    Judged(Verdict),
    /// The mistake results from a mistake in another part of the question, whose feedback describes it.
    Follows(Asked),
}

impl Feedback {
    /// Returns true if the answer is right.
    pub(crate) fn is_good(&self) -> bool {
        matches!(self, Feedback::Judged(verdict) if verdict.is_right())
    }

    /// Returns true if the answer is wrong, and not only missing.
    pub(crate) fn is_wrong(&self) -> bool {
        !self.is_good() && !matches!(self, Feedback::NotAnswered | Feedback::Missing)
    }

    /// Returns true if what was typed cannot be read.
    pub(crate) fn is_no_number(&self) -> bool {
        matches!(self, Feedback::NoNumber(_))
    }

    /// Returns the feedback in words.
    pub(crate) fn sentence(&self, part: &QuestionPart) -> String {
        match self {
            Feedback::NotAnswered => "Not answered yet.".to_owned(),
            Feedback::Missing => "One of the numbers is missing.".to_owned(),
            Feedback::NoNumber(why) => format!("{why}."),
            Feedback::Judged(verdict) => verdict.sentence(part),
            Feedback::Follows(source) => follows(*source),
        }
    }
}

impl Default for Exercises {
    fn default() -> Self {
        Exercises::open(Exercise::WarmUpRay, None)
    }
}

impl Exercises {
    /// Opens an exercise without answers: the lecture's own question, or a similar one made from a seed.
    pub fn open(exercise: Exercise, seed: Option<u64>) -> Exercises {
        let question = Question::new(exercise, seed);
        let typed =
            |count| TypedAnswer { fields: vec![String::new(); count], ..TypedAnswer::default() };
        let answers = question.parts.iter().map(|part| typed(part.count())).collect();
        Exercises {
            question,
            seed,
            answers,
            is_solved: false,
            saw_solution: false,
            shown_mistake: None,
            hint: None,
            kept: Vec::new(),
        }
    }

    /// Opens this question, with the answers that were typed in it before. The answers to the question that
    /// was open so far are kept.
    pub fn show(&mut self, exercise: Exercise, seed: Option<u64>) {
        if (self.question.exercise, self.seed) == (exercise, seed) {
            return;
        }
        self.shown_mistake = None;
        let mut kept = std::mem::take(&mut self.kept);
        let known =
            kept.iter().position(|kept| (kept.question.exercise, kept.seed) == (exercise, seed));
        let next = match known {
            Some(index) => kept.remove(index),
            None => Exercises::open(exercise, seed),
        };
        let before = std::mem::replace(self, next);
        if before != Exercises::open(before.question.exercise, before.seed) {
            kept.push(before);
        }
        self.kept = kept;
    }

    /// Opens the question made from this seed, without answers. The answers to other questions are
    /// kept.
    pub(crate) fn renew(&mut self, seed: u64) {
        self.show(self.question.exercise, Some(seed));
        self.clear();
    }

    /// Clears the answers to the open question.
    pub(crate) fn clear(&mut self) {
        let kept = std::mem::take(&mut self.kept);
        *self = Exercises { kept, ..Exercises::open(self.question.exercise, self.seed) };
    }

    /// Returns the open question.
    pub fn question(&self) -> &Question {
        &self.question
    }

    /// Returns the seed of the question; `None` for the lecture's own question.
    pub fn seed(&self) -> Option<u64> {
        self.seed
    }

    /// Shows or hides the solution.
    pub(crate) fn toggle_solution(&mut self) {
        self.is_solved = !self.is_solved;
        self.saw_solution = true;
    }

    /// Checks all typed answers.
    pub(crate) fn check(&mut self) {
        // What went with a changed answer does not come back by itself.
        self.shown_mistake = self.shown_mistake.filter(|_| self.ghost().is_some());
        self.answers.iter_mut().for_each(TypedAnswer::spread);
        self.hint.iter_mut().for_each(|hint| hint.is_new = false);
        let answers: Vec<Result<Answer, Feedback>> =
            self.answers.iter().map(TypedAnswer::answer).collect();
        let known: Vec<Option<Answer>> =
            answers.iter().map(|answer| answer.as_ref().ok().cloned()).collect();
        let verdicts = self.question.judge(&known);
        for (k, (typed, answer)) in self.answers.iter_mut().zip(answers).enumerate() {
            typed.feedback = Some(match (self.question.source_of(k, &verdicts), &verdicts[k]) {
                (Some(source), _) => Feedback::Follows(source),
                (None, Some(verdict)) => Feedback::Judged(verdict.clone()),
                (None, None) => answer.err().unwrap_or(Feedback::NotAnswered),
            });
        }
    }

    /// Returns true if all answers are right.
    pub(crate) fn is_right(&self) -> bool {
        self.answers.iter().all(|typed| typed.feedback.as_ref().is_some_and(Feedback::is_good))
    }

    /// Returns a document with the question's camera and objects; `None` if the question has no camera.
    pub(crate) fn document(&self) -> Option<Document> {
        let question = &self.question;
        let wall = |plane| Item { color: Some(WALL_COLOR), ..Item::plain(plane) };
        Some(Document {
            note: format!("{}.", question.exercise.title()),
            camera: question.camera()?,
            spheres: Vec::from_iter(question.sphere().map(Item::plain)).into(),
            planes: Vec::from_iter(question.plane().map(wall)).into(),
            ..Document::default()
        })
    }
}

impl TypedAnswer {
    /// Returns the typed numbers; `None` unless all fields are filled and can be evaluated.
    pub(crate) fn numbers(&self) -> Option<Vec<f64>> {
        match self.answer() {
            Ok(Answer::Numbers(numbers)) => Some(numbers),
            _ => None,
        }
    }

    /// Returns the typed answer, or the feedback on one that is missing or cannot be read.
    pub(crate) fn answer(&self) -> Result<Answer, Feedback> {
        if self.fields.is_empty() {
            return self.yes.map(Answer::Yes).ok_or(Feedback::NotAnswered);
        }
        let is_empty = |field: &String| field.trim().is_empty();
        if self.fields.iter().all(is_empty) {
            return Err(Feedback::NotAnswered);
        }
        if self.fields.iter().any(is_empty) {
            return Err(Feedback::Missing);
        }
        let numbers: Result<Vec<f64>, String> =
            self.fields.iter().map(|field| evaluate(field)).collect();
        numbers.map(Answer::Numbers).map_err(Feedback::NoNumber)
    }

    /// Distributes a vector that was pasted into one field, such as `(1, 2, 3)`, over all fields.
    pub(crate) fn spread(&mut self) {
        let count = self.fields.len();
        let whole = self.fields.iter().find(|field| field.matches(',').count() + 1 == count);
        let Some(whole) = whole.filter(|_| count > 1) else { return };
        let inside = whole.trim().trim_start_matches('(').trim_end();
        // Strip a bracket that closes the vector, but not one that belongs to the last number.
        let unbalanced = inside.matches(')').count() > inside.matches('(').count();
        let inside = if unbalanced { inside.strip_suffix(')').unwrap_or(inside) } else { inside };
        self.fields = inside.split(',').map(|field| field.trim().to_owned()).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pasted_vector_fills_its_fields() {
        for text in ["(0.2, -0.1, -1)", "0.2,-0.1,-1", " ( 0.2 , -0.1 , -1 ) "] {
            let fields = vec![text.to_owned(), String::new(), String::new()];
            let mut typed = TypedAnswer { fields, ..TypedAnswer::default() };
            typed.spread();
            assert_eq!(typed.fields, ["0.2", "-0.1", "-1"], "{text}");
        }
        let root = "(1/sqrt(2), 0, -1/sqrt(2))".to_owned();
        let mut typed = TypedAnswer {
            fields: vec![root, String::new(), String::new()],
            ..TypedAnswer::default()
        };
        typed.spread();
        assert_eq!(typed.fields, ["1/sqrt(2)", "0", "-1/sqrt(2)"]);
    }

    #[test]
    fn what_was_typed_is_kept_for_each_question() {
        let mut exercises = Exercises::open(Exercise::Sphere, Some(3));
        exercises.answers[0].fields[0] = "4".to_owned();
        let typed = exercises.clone();
        exercises.show(Exercise::Sphere, Some(3));
        assert_eq!(exercises, typed);
        for (exercise, seed) in [(Exercise::Sphere, None), (Exercise::Lines, None)] {
            exercises.show(exercise, seed);
            assert!(exercises.answers.iter().all(|typed| typed.numbers().is_none()));
            exercises.answers[0].fields[0] = "5".to_owned();
        }
        exercises.show(Exercise::Sphere, Some(3));
        assert_eq!(exercises.answers, typed.answers);
        exercises.renew(4);
        assert_eq!(exercises.answers[0].fields[0], "");
        exercises.show(Exercise::Sphere, Some(3));
        assert_eq!(exercises.answers[0].fields[0], "4");
        exercises.show(Exercise::Sphere, Some(2));
        exercises.renew(3);
        assert_eq!(exercises.answers[0].fields[0], "", "asked for anew");
        exercises.show(Exercise::Lines, None);
        assert_eq!(exercises.answers[0].fields[0], "5", "of another exercise");
    }

    #[test]
    fn exact_entry_is_right() {
        let mut exercises = Exercises::open(Exercise::Turned, None);
        let typed = [
            ["1/sqrt(2)", "0", "-1/sqrt(2)"],
            ["0", "1", "0"],
            ["sqrt(2)/2", "0", "√(2)/2"],
            ["-0.8/sqrt(2)", "−0.1", "-1.2/sqrt(2)"],
        ];
        for (part, typed) in exercises.answers.iter_mut().zip(typed) {
            part.fields = typed.map(str::to_owned).to_vec();
        }
        exercises.answers[4].fields = vec!["5*sqrt(2)".to_owned()];
        exercises.check();
        assert!(exercises.is_right(), "{:?}", exercises.answers);
        exercises.answers[4].fields = vec!["5*sqrt(".to_owned()];
        exercises.check();
        assert!(matches!(exercises.answers[4].feedback, Some(Feedback::NoNumber(_))));
        exercises.answers[0].fields[1].clear();
        exercises.check();
        assert_eq!(exercises.answers[0].feedback, Some(Feedback::Missing));
    }

    #[test]
    fn u_and_v_are_not_measured_where_they_are_asked_for() {
        let legs = |exercises: &Exercises| {
            let usual = pinhole_figure::OverlayItems::NONE.with(pinhole_figure::Item::UvLegs, true);
            exercises.items(usual) == usual
        };
        assert!(legs(&Exercises::open(Exercise::WarmUpRay, None)));
        let mut exercises = Exercises::open(Exercise::PixelUv, None);
        assert!(!legs(&exercises));
        exercises.toggle_solution();
        assert!(legs(&exercises));
    }

    #[test]
    fn every_question_has_its_words_and_its_scene() {
        for &exercise in Exercise::LISTED {
            for seed in [None, Some(1), Some(2)] {
                let exercises = Exercises::open(exercise, seed);
                let question = exercises.question();
                assert!(!pinhole_lecture::exercises::question(&question.given).is_empty());
                for part in &question.parts {
                    assert!(!part.asked.symbol().is_empty());
                }
                let document = exercises.document();
                assert_eq!(document.is_none(), exercise == Exercise::Lines);
                assert!(document.is_none_or(|document| document.scene().is_ok()));
            }
        }
    }
}
