//! Codes in which students send their answers to an exercise, by any way that carries a line of text.
//!
//! ```text
//! answer1/turned-basis/7/alone/MC43CjAK.../2f7c01ae
//! answer1/sphere/lecture/seen/NAo.../93d1b6f0
//! ```
//!
//! Between the version and the check ([`seal`](pinhole_exchange::seal)) are the exercise, the question's seed, or
//! `lecture` for the lecture's own question, `seen` if the solution was shown, and the typed texts in base64url
//! (RFC 4648) without padding, a line each. A code has no name in it, and no blank.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use pinhole_exchange::seal::Form;
use pinhole_lecture::exercises::Exercise;

use crate::features::exercises::state::{Exercises, Feedback, TypedAnswer};

const FORM: Form = Form { prefix: "answer", version: 1 };

/// The seed's place in the code of the lecture's own question.
const LECTURE: &str = "lecture";

/// The marks of answers that were sent without and with a look at the solution.
const SEEN: [&str; 2] = ["alone", "seen"];

/// The texts of the answers to a yes-or-no question.
const YES_NO: [&str; 2] = ["yes", "no"];

impl Exercises {
    /// Returns the code of the typed answers.
    pub fn to_code(&self) -> String {
        let texts: Vec<String> = self.answers.iter().flat_map(TypedAnswer::texts).collect();
        let packed = URL_SAFE_NO_PAD.encode(texts.join("\n"));
        let seed = self.seed().map_or_else(|| LECTURE.to_owned(), |seed| seed.to_string());
        let seen = SEEN[usize::from(self.saw_solution)];
        FORM.seal(&format!("{}/{seed}/{seen}/{packed}", self.question().exercise.id()))
    }

    /// Returns true if a part of the question is answered, and nothing that was typed cannot be read.
    pub(crate) fn is_readable(&self) -> bool {
        let is_read = |own: &TypedAnswer| !matches!(own.answer(), Err(Feedback::NoNumber(_)));
        self.answers.iter().all(is_read) && self.answers.iter().any(|own| own.answer().is_ok())
    }

    /// Opens a question, types these texts into its fields, yes or no where it asks for that, and checks them.
    /// Returns `None` unless there are as many texts as fields.
    pub fn with_answers(
        exercise: Exercise,
        seed: Option<u64>,
        texts: &[&str],
    ) -> Option<Exercises> {
        let mut exercises = Exercises::open(exercise, seed);
        let mut texts = texts.iter();
        for typed in &mut exercises.answers {
            if typed.fields.is_empty() {
                let text = texts.next()?;
                typed.yes = YES_NO.contains(text).then_some(*text == YES_NO[0]);
            }
            for field in &mut typed.fields {
                *field = (*texts.next()?).to_owned();
            }
        }
        exercises.check();
        texts.next().is_none().then_some(exercises)
    }

    fn of_content(content: &str) -> Option<Exercises> {
        let parts: Vec<&str> = content.split('/').collect();
        let [id, seed, seen, packed] = parts[..] else { return None };
        let exercise = Exercise::LISTED.iter().find(|exercise| exercise.id() == id)?;
        let seed = if seed == LECTURE { None } else { Some(seed.parse().ok()?) };
        let text = String::from_utf8(URL_SAFE_NO_PAD.decode(packed).ok()?).ok()?;
        let texts: Vec<&str> = text.split('\n').collect();
        let mut exercises = Exercises::with_answers(*exercise, seed, &texts)?;
        exercises.saw_solution = seen == SEEN[1];
        Some(exercises)
    }
}

impl TypedAnswer {
    /// Returns the text of each field, on one line, or of the answer to a yes-or-no question.
    pub(crate) fn texts(&self) -> Vec<String> {
        if self.fields.is_empty() {
            return vec![self.yes.map_or("", |yes| YES_NO[usize::from(!yes)]).to_owned()];
        }
        self.fields.iter().map(|field| field.replace('\n', " ")).collect()
    }
}

/// Reads the codes in a line of text, which may have other words in it. Each is the checked answers, or the reason
/// why it cannot be read.
pub fn codes_in(line: &str) -> impl Iterator<Item = Result<Exercises, String>> {
    let is_of_code = |c: char| c.is_ascii_alphanumeric() || matches!(c, '/' | '-' | '_');
    let words = line.split(move |c| !is_of_code(c)).filter(|word| FORM.is_meant(word));
    words.map(|code| {
        let content = FORM.open(code).map_err(|(_, problem)| problem)?;
        Exercises::of_content(content).ok_or_else(|| "of no exercise in this program".to_owned())
    })
}

#[cfg(test)]
mod tests {
    use proptest::option;
    use proptest::prelude::*;

    use super::*;

    /// Any answers to any exercise, without the feedback on them.
    fn any_answers() -> impl Strategy<Value = Exercises> {
        let exercise = prop::sample::select(Exercise::LISTED);
        let texts = prop::collection::vec("[^\\n]{0,20}|[0-9./*()sqrt-]{0,20}", 20);
        (exercise, option::of(any::<u64>()), any::<bool>(), texts, option::of(any::<bool>()))
            .prop_map(|(exercise, seed, saw_solution, texts, yes)| {
                let mut exercises = Exercises::open(exercise, seed);
                exercises.saw_solution = saw_solution;
                let mut texts = texts.into_iter();
                for typed in &mut exercises.answers {
                    typed.yes = yes.filter(|_| typed.fields.is_empty());
                    let fields = typed.fields.iter_mut().zip(&mut texts);
                    fields.for_each(|(field, text)| *field = text);
                }
                exercises
            })
    }

    fn read(text: &str) -> (Vec<Exercises>, Vec<String>) {
        let (read, broken): (Vec<_>, Vec<_>) =
            text.lines().flat_map(codes_in).partition(Result::is_ok);
        (read.into_iter().flatten().collect(), broken.into_iter().filter_map(Result::err).collect())
    }

    proptest! {
        #[test]
        fn codes_are_read_back_from_any_text(all in prop::collection::vec(any_answers(), 1..4)) {
            let codes: Vec<String> = all.iter().map(Exercises::to_code).collect();
            let checked = all.into_iter().map(|mut own| { own.check(); own }).collect::<Vec<_>>();
            for text in [
                codes.join("\n"),
                codes.join(" "),
                format!("Anna: {}. Best wishes!\r\n", codes.join(">\r\n\r\n<")),
                format!("name,answer\n\"Berta\",\"{}\"", codes.join("\"\n\"Carl\",\"")),
            ] {
                prop_assert_eq!(&read(&text).0, &checked);
                prop_assert!(read(&text).1.is_empty());
            }
        }

        #[test]
        fn one_wrong_character_or_a_cut_is_noticed(
            own in any_answers(), place in any::<prop::sample::Index>(), other in "[a-zA-Z0-9_-]",
        ) {
            let whole = own.to_code();
            let at = "answer1/".len() + place.index(whole.len() - "answer1/".len());
            let changed = format!("{}{other}{}", &whole[..at], &whole[at + 1..]);
            for broken in [changed, whole[..at].to_owned()] {
                if broken != whole {
                    let found = read(&format!("{broken}\n{whole}"));
                    prop_assert_eq!((found.0.len(), found.1.len()), (1, 1));
                }
            }
        }

        #[test]
        fn any_text_is_read_or_refused(
            text in "\\PC*|(answer1/[a-z-]{0,9}/[0-9]{0,30}/?[a-zA-Z0-9/_-]{0,99}\\s?)*",
        ) {
            let _ = (read(&text), read(&FORM.seal(&text)));
        }
    }

    /// Codes that students have kept must be readable for ever.
    #[test]
    fn codes_of_version_1_are_read() {
        let texts = ["4", "0", "0", "-4", "0", "0", "1"];
        let mut expected = Exercises::with_answers(Exercise::Sphere, None, &texts);
        expected.iter_mut().for_each(|own| own.saw_solution = true);
        let (found, broken) = read("answer1/sphere/lecture/seen/NAowCjAKLTQKMAowCjE/cc98a6a5");
        assert_eq!((found, broken), (Vec::from_iter(expected), vec![]));
    }

    #[test]
    fn broken_codes_are_refused_with_a_reason() {
        let sealed = |content: &str| FORM.seal(content);
        let code = sealed("sphere/lecture/alone/NAowCjAKLTQKMAowCjE");
        for (broken, reason) in [
            (&code[..code.len() - 3], "cut off: copy it again as a whole"),
            (&code.replace("NAow", "NAOw"), "mistyped or cut off: copy it again as a whole"),
            (
                &code.replace("answer1", "answer2"),
                "of version 2, and this program reads version 1: a newer Pinhole opens it",
            ),
            (
                &code.replace("answer1", "answer0"),
                "of version 0, and this program reads version 1: mistyped, or of an older Pinhole: make it again",
            ),
            (&code.replace("answer1", &format!("answer{}", "9".repeat(100_000))), "of version 999"),
            (&sealed("cube/7/alone/NAow"), "of no exercise in this program"),
            (&sealed("sphere/seven/alone/NAow"), "of no exercise in this program"),
            (&sealed("sphere/7/alone/NAow"), "of no exercise in this program"),
            (&sealed("sphere/7/alone/_w"), "of no exercise in this program"),
        ] {
            let (found, broken) = read(broken);
            assert_eq!((found.len(), broken.len()), (0, 1));
            assert!(broken[0].starts_with(reason) && broken[0].len() < 200, "{broken:?}");
        }
    }
}
