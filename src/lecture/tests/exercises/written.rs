//! All that a student reads, kept as text: questions, right and wrong answers, and verdicts.
//! `UPDATE_EXPECT=1` writes the files anew.

use std::fmt::Write as _;

use expect_test::expect_file;
use pinhole_lecture::exercises::{follows, question};

use super::*;

/// Formats an answer so that it is the same on every machine.
fn plain(answer: &Answer) -> String {
    match answer {
        Answer::Yes(yes) => format!("{yes}"),
        Answer::Numbers(numbers) => {
            // Adding 0 takes the sign from -0.
            let texts = numbers.iter().map(|x| format!("{:.6}", (x * 1e6).round() / 1e6 + 0.0));
            format!("({})", texts.collect::<Vec<_>>().join(", "))
        }
    }
}

fn heading(text: &mut String, exercise: Exercise, seed: Option<u64>) {
    let seed = seed.map_or_else(|| "the lecture's".to_owned(), |seed| format!("seed {seed}"));
    writeln!(text, "# {} ({}), {seed}", exercise.title(), exercise.id()).unwrap();
}

#[test]
fn questions_and_their_answers_read_as_they_did() {
    let mut text = String::new();
    for &exercise in Exercise::LISTED {
        for seed in [None].into_iter().chain((1..=12).map(Some)) {
            let asked = Question::new(exercise, seed);
            heading(&mut text, exercise, seed);
            writeln!(text, "{}", question(&asked.given).join("\n")).unwrap();
            for part in &asked.parts {
                let scaled = if part.may_be_scaled { ", or any multiple" } else { "" };
                let (id, symbol, truth) = (part.asked.id(), part.asked.symbol(), &part.truth);
                writeln!(text, "{id}: {symbol} = {}{scaled}", plain(truth)).unwrap();
                for (mistake, answer) in part.mistakes.iter().filter(|_| seed < Some(3)) {
                    writeln!(text, "  {}: {}", mistake.id(), plain(answer)).unwrap();
                }
            }
            text.push('\n');
        }
    }
    expect_file!["questions.txt"].assert_eq(&text);
}

/// Returns wrong and unusual answers to a part whose right answer is `truth`.
fn unusual(truth: &[f64]) -> Vec<Vec<f64>> {
    let each = |f: &dyn Fn(f64) -> f64| truth.iter().map(|x| f(*x)).collect::<Vec<f64>>();
    let digits =
        |count: usize| each(&|x| format!("{x:.*e}", count - 1).parse::<f64>().unwrap_or_default());
    let cut = |x: f64| (x * 1e4).trunc() / 1e4;
    let mut all = vec![
        each(&|x| 2.0 * x),
        each(&|x| -x),
        each(&|x| -3.0 * x),
        each(&|x| 0.1 * x),
        digits(1),
        digits(2),
        digits(3),
        digits(4),
        digits(6),
        each(&cut),
        each(&|_| 0.0),
        truth.iter().rev().copied().collect(),
    ];
    for k in 0..truth.len() {
        let mut off = truth.to_vec();
        off[k] += 0.25;
        all.push(off);
    }
    all
}

#[test]
fn verdicts_on_single_answers_read_as_they_did() {
    let mut text = String::new();
    for &exercise in Exercise::LISTED {
        for seed in [None, Some(1), Some(5)] {
            let question = Question::new(exercise, seed);
            heading(&mut text, exercise, seed);
            for (index, part) in question.parts.iter().enumerate() {
                let Answer::Numbers(truth) = &part.truth else { continue };
                writeln!(text, "{} = {}", part.asked.symbol(), plain(&part.truth)).unwrap();
                let mut seen = HashSet::new();
                for answer in unusual(truth) {
                    let answer = numbers(&answer);
                    if !seen.insert(plain(&answer)) {
                        continue;
                    }
                    let verdict = alone(&question, index, answer.clone());
                    let right = if verdict.is_right() { "+" } else { "-" };
                    let said = verdict.sentence(part);
                    writeln!(text, "  {right} {}: {said}", plain(&answer)).unwrap();
                }
            }
            text.push('\n');
        }
    }
    expect_file!["verdicts.txt"].assert_eq(&text);
}

/// Each student makes one mistake, and calculates the other parts from what it gives.
#[test]
fn verdicts_on_sheets_with_one_mistake_read_as_they_did() {
    let mut text = String::new();
    for &exercise in Exercise::LISTED {
        let question = Question::new(exercise, Some(1));
        heading(&mut text, exercise, Some(1));
        let all = question.parts.iter().flat_map(|part| &part.mistakes).map(|(made, _)| *made);
        let mut mistakes: Vec<Mistake> = all.collect();
        mistakes.sort_unstable();
        mistakes.dedup();
        for mistake in mistakes {
            let answer = |part: &QuestionPart| {
                let wrong = part.mistakes.iter().find(|(made, _)| *made == mistake);
                Some(wrong.map_or(&part.truth, |(_, answer)| answer).clone())
            };
            let answers: Vec<_> = question.parts.iter().map(answer).collect();
            let verdicts = question.judge(&answers);
            writeln!(text, "{}", mistake.id()).unwrap();
            for (k, (part, verdict)) in question.parts.iter().zip(&verdicts).enumerate() {
                let said = match question.source_of(k, &verdicts) {
                    Some(source) => follows(source),
                    None => verdict.as_ref().unwrap().sentence(part),
                };
                writeln!(text, "  {}: {said}", part.asked.symbol()).unwrap();
            }
        }
        text.push('\n');
    }
    expect_file!["sheets.txt"].assert_eq(&text);
}

/// An answer is right up to an error of 1e-9 of its size, whatever its size is.
#[test]
fn rounding_errors_are_right_up_to_a_fixed_share_of_the_size() {
    for question in questions().filter(|question| question.uv().is_none()) {
        for (index, part) in question.parts.iter().enumerate() {
            let Answer::Numbers(truth) = &part.truth else { continue };
            let size = truth.iter().map(|x| x * x).sum::<f64>().sqrt();
            for k in 0..truth.len() {
                let off = |by: f64| {
                    let mut off = truth.clone();
                    off[k] += by * if size == 0.0 { 1.0 } else { size };
                    alone(&question, index, numbers(&off))
                };
                assert_eq!(off(0.9e-9), Verdict::Right, "{question:?}");
                let verdict = off(1.1e-9);
                let is_rounded = matches!(verdict, Verdict::Rounded { digits: 8.. });
                assert!(!verdict.is_right() || is_rounded, "{question:?}: {verdict:?}");
            }
        }
    }
}
