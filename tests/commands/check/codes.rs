//! Codes of a class's answers to exercises.

use expect_test::expect;
use pinhole::features::exercises::Exercises;
use pinhole_lecture::Mistake;
use pinhole_lecture::exercises::{Answer, Exercise, Question};

use super::*;

/// The code of the answers to which a mistake leads, or of the right ones.
fn code(exercise: Exercise, seed: Option<u64>, mistake: Option<Mistake>) -> String {
    let text = |answer: &Answer| match answer {
        Answer::Numbers(numbers) => numbers.iter().map(f64::to_string).collect(),
        Answer::Yes(yes) => vec![if *yes { "yes" } else { "no" }.to_owned()],
    };
    let question = Question::new(exercise, seed);
    let texts = question.parts.iter().flat_map(|part| {
        let wrong = part.mistakes.iter().find(|(made, _)| Some(*made) == mistake);
        text(wrong.map_or(&part.truth, |(_, answer)| answer))
    });
    let texts: Vec<String> = texts.collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    Exercises::with_answers(exercise, seed, &texts).unwrap().to_code()
}

fn graded(text: &str, more: &[&str]) -> Run {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("codes.txt"), text).unwrap();
    run_in(folder.path(), &[&["check", "--codes", "codes.txt"], more].concat())
}

/// A class with questions of its own for each student.
fn class() -> String {
    let mut lines = vec!["The answers of Tuesday's group".to_owned()];
    for seed in 0..9 {
        let made = [None, Some(Mistake::WIsAtMinusEye), None, Some(Mistake::VIsUCrossW)];
        lines.push(code(Exercise::EyeAtUp, Some(seed), made[seed as usize % 4]));
    }
    let own = |texts: &[&str]| Exercises::with_answers(Exercise::Sphere, None, texts).unwrap();
    lines.push(own(&["4", "0", "0", "-4", "0", "0", "1"]).to_code());
    lines.push(own(&["6", "0", "0", "-6", "0", "0", "-1"]).to_code());
    lines.push(own(&["4", "", "", "", "", "", ""]).to_code());
    lines.push(own(&["17", "0", "0", "-4", "0", "0", "1"]).to_code());
    lines.push(own(&["four", "0", "0", "-4", "0", "0", "1"]).to_code());
    lines.push(lines[1][..60].to_owned());
    lines.join("\n")
}

#[cfg(target_os = "linux")]
#[test]
fn a_hundred_thousand_answers_take_little_memory() {
    let folder = tempfile::tempdir().unwrap();
    let line = code(Exercise::Sphere, None, None) + "\n";
    fs::write(folder.path().join("codes.txt"), line.repeat(100_000)).unwrap();
    let limit = "-v 300000";
    let run = crate::commands::outputs::run_within(limit, folder.path(), "check --codes codes.txt");
    assert!(run.done().starts_with("A ray and a sphere: 100000 answers\n  right"));
}

#[test]
fn the_mistakes_of_a_class_are_counted() {
    let run = graded(&class(), &[]);
    assert_eq!((run.status, &*run.stderr), (1, ""));
    expect![[r#"
        A basis from eye, at and up: 9 answers
          right                 5  #####
          v-is-u-cross-w        2  ##
          w-is-at-minus-eye     2  ##
          v-is-u-cross-w: 𝐯 = 𝐮 × 𝐰 points down: the factors are exchanged.
          w-is-at-minus-eye: at − eye is the view: 𝐰 points the other way, from at to eye.
        A ray and a sphere: 5 answers
          right               1  #
          another mistake     2  ##
          far-root            1  #
          not complete        1  #
          far-root: That is the second root, where the ray leaves. Which one is first?
        The code in line 16 is mistyped or cut off: copy it again as a whole.
        Lines without a code: 1.
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn they_are_counted_as_json() {
    let value = json_of(&graded(&class(), &["--json"]));
    let first = &value["exercises"][0];
    assert_eq!((&first["exercise"], &first["answers"]), (&json!("eye-at-up"), &json!(9)));
    assert_eq!(first["counts"][0], json!(["right", 5]));
    assert_eq!(value["exercises"][1]["saw_solution"], 0);
    assert_eq!(value["not_readable"][0][0], 16);
    assert_eq!(value["lines_without"], json!(1));
}

/// The right answers to one question are wrong to another.
#[test]
fn each_code_is_graded_by_its_own_question() {
    for &exercise in Exercise::LISTED {
        let all: Vec<String> = [None, Some(1), Some(2), Some(1_000_000_000)]
            .map(|seed| code(exercise, seed, None))
            .to_vec();
        let said = graded(&all.join("\n"), &[]).done();
        assert_eq!(said, format!("{}: 4 answers\n  right     4  ####\n", exercise.title()));
    }
}

#[test]
fn a_file_without_a_code_that_can_be_read_is_status_2() {
    graded("Hello", &[])
        .failed(2, "codes.txt: no code in it: the code of an answer begins with answer1/");
    graded("answer1/sphere/7/MTIz", &[]).failed(
        2,
        "codes.txt: no code can be read: that in line 1 is cut off: copy it again as a whole",
    );
    let refused = run_in(Path::new("."), &["check", "canonical", "--codes", "codes.txt"]);
    refused.refused("cannot be used with");
    run_in(Path::new("."), &["check", "--codes", "none.txt"])
        .failed(2, "none.txt: cannot be read: no such file or directory");
}
