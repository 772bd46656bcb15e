//! Tests every exercise with right answers, and with each classic mistake.
#![allow(clippy::approx_constant, reason = "answers that are rounded are what is tested")]

use std::collections::HashSet;
use std::f64::consts::{FRAC_1_SQRT_2 as S, SQRT_2};

use pinhole_lecture::exercises::{Answer, Asked, Exercise, Question, QuestionPart, Verdict};
use pinhole_lecture::mistakes::Mistake;

mod classic;
mod left_over;
mod written;

fn numbers(x: &[f64]) -> Answer {
    Answer::Numbers(x.to_vec())
}

fn judged(exercise: Exercise, asked: Asked, answer: Answer) -> Verdict {
    let question = Question::new(exercise, None);
    let part = question.parts.iter().position(|part| part.asked == asked).unwrap();
    alone(&question, part, answer)
}

/// Returns the verdict on one answer if the question's other parts are not answered.
fn alone(question: &Question, part: usize, answer: Answer) -> Verdict {
    let mut answers = vec![None; question.parts.len()];
    answers[part] = Some(answer);
    let mut verdicts = question.judge(&answers);
    assert_eq!(verdicts.iter().flatten().count(), 1, "nothing is said of what was not answered");
    verdicts.swap_remove(part).unwrap()
}

#[test]
fn the_lectures_answers_are_right() {
    let (r74, r682) = (74f64.sqrt(), 682f64.sqrt());
    let r = 666f64.sqrt() * r682;
    let cases: Vec<(Exercise, Asked, Vec<f64>)> = vec![
        (Exercise::WarmUpRay, Asked::Origin, vec![0.0, 0.0, 0.0]),
        (Exercise::WarmUpRay, Asked::Direction, vec![0.2, -0.1, -1.0]),
        (Exercise::WarmUpPlane, Asked::T, vec![6.0]),
        (Exercise::WarmUpPlane, Asked::Point, vec![1.2, -0.6, -6.0]),
        (Exercise::Distance, Asked::Direction, vec![0.2, -0.1, -2.0]),
        (Exercise::Distance, Asked::T, vec![3.0]),
        (Exercise::Turned, Asked::U, vec![S, 0.0, -S]),
        (Exercise::Turned, Asked::V, vec![0.0, 1.0, 0.0]),
        (Exercise::Turned, Asked::W, vec![S, 0.0, S]),
        (Exercise::Turned, Asked::Direction, vec![-0.8 * S, -0.1, -1.2 * S]),
        (Exercise::Turned, Asked::T, vec![5.0 * SQRT_2]),
        (Exercise::ViewUp, Asked::U, vec![0.0, 0.0, 1.0]),
        (Exercise::ViewUp, Asked::V, vec![1.0, 0.0, 0.0]),
        (Exercise::ViewUp, Asked::W, vec![0.0, 1.0, 0.0]),
        (Exercise::EyeAtUp, Asked::U, vec![5.0 / r74, 0.0, -7.0 / r74]),
        (Exercise::EyeAtUp, Asked::W, vec![21.0 / r682, 4.0 / r682, 15.0 / r682]),
        // w x u, with 9 (5, 0, -7) / sqrt 74 = 9 (5, 0, -7) 3 / sqrt 666.
        (Exercise::EyeAtUp, Asked::V, vec![-84.0 / r, 666.0 / r, -60.0 / r]),
        (Exercise::Sphere, Asked::T, vec![4.0]),
        (Exercise::Sphere, Asked::Point, vec![0.0, 0.0, -4.0]),
        (Exercise::Sphere, Asked::Normal, vec![0.0, 0.0, 1.0]),
        // 240.5/400 and 280.5/400, in the middle of the pixel.
        (Exercise::PixelUv, Asked::Uv, vec![0.20125, -0.10125]),
        (Exercise::PointAt, Asked::Point, vec![21.2, 3.4, 4.0]),
        (Exercise::Coefficients, Asked::A, vec![1.0]),
        (Exercise::Coefficients, Asked::B, vec![-5.0]),
        (Exercise::Coefficients, Asked::C, vec![24.0]),
        (Exercise::Coefficients, Asked::Discriminant, vec![1.0]),
        (Exercise::Lines, Asked::T, vec![1.0]),
        (Exercise::Lines, Asked::Point, vec![1.0, 1.0]),
    ];
    for (exercise, asked, answer) in cases {
        let verdict = judged(exercise, asked, numbers(&answer));
        assert_eq!(verdict, Verdict::Right, "{exercise:?} {asked:?} {answer:?}");
    }
    assert_eq!(judged(Exercise::Lines, Asked::Hits, Answer::Yes(true)), Verdict::Right);
    let no = judged(Exercise::Lines, Asked::Hits, Answer::Yes(false));
    assert_eq!(no, Verdict::Mistakes(vec![Mistake::LineForRay]));
}

/// Returns questions with random numbers from many seeds, and the lecture's own questions.
fn questions() -> impl Iterator<Item = Question> {
    Exercise::LISTED.iter().copied().flat_map(|exercise| {
        (0..200).map(Some).chain([None]).map(move |seed| Question::new(exercise, seed))
    })
}

#[test]
fn right_answers_are_never_blamed() {
    for question in questions() {
        let mut answers: Vec<_> =
            question.parts.iter().map(|part| Some(part.truth.clone())).collect();
        for verdict in question.judge(&answers) {
            assert_eq!(verdict, Some(Verdict::Right), "{question:?}");
        }
        for (part, answer) in question.parts.iter().zip(&mut answers) {
            let Some(Answer::Numbers(truth)) = answer else { continue };
            assert!(truth.iter().all(|x| x.is_finite()), "{question:?}");
            if part.may_be_scaled {
                truth.iter_mut().for_each(|x| *x *= 1.7);
            }
        }
        let verdicts = question.judge(&answers);
        assert!(verdicts.iter().flatten().all(Verdict::is_right), "{question:?}");
    }
}

#[test]
fn every_mistake_that_gives_an_answer_is_named() {
    for question in questions() {
        for (index, part) in question.parts.iter().enumerate() {
            for (mistake, answer) in &part.mistakes {
                assert!(!mistake.exercise_feedback().is_empty(), "{mistake}");
                let verdict = alone(&question, index, answer.clone());
                let tells = |named: &Mistake| named == mistake || named.is_part_of(*mistake);
                let named =
                    matches!(&verdict, Verdict::Mistakes(mistakes) if mistakes.iter().any(tells));
                // The verdict on the same line, backwards, says so first.
                let backwards = part.may_be_scaled && matches!(verdict, Verdict::Backwards { .. });
                let given = question.given;
                assert!(named || backwards, "{given:?}: {mistake:?} {answer:?}: {verdict:?}");
            }
        }
    }
}

/// If all parts are answered with the same mistake, no other mistake is named unless it gives the same
/// answers.
#[test]
fn a_sheet_with_one_mistake_is_told_that_mistake_in_every_wrong_part() {
    for question in questions() {
        let mistakes: HashSet<Mistake> = question
            .parts
            .iter()
            .flat_map(|part| &part.mistakes)
            .map(|(mistake, _)| *mistake)
            .collect();
        let gives = |mistake: Mistake, k: usize| {
            question.parts[k]
                .mistakes
                .iter()
                .filter(move |(other, _)| *other == mistake)
                .map(|(_, a)| a)
        };
        for mistake in mistakes {
            let parts = 0..question.parts.len();
            let answer = |k| gives(mistake, k).next().unwrap_or(&question.parts[k].truth).clone();
            let answers: Vec<_> = parts.clone().map(|k| Some(answer(k))).collect();
            let verdicts = question.judge(&answers);
            for k in parts.clone() {
                let verdict = verdicts[k].as_ref().unwrap();
                match gives(mistake, k).next() {
                    None => assert_eq!(*verdict, Verdict::Right, "{question:?} {mistake:?}"),
                    Some(_) if matches!(verdict, Verdict::Backwards { .. }) => (),
                    Some(_) => {
                        let Verdict::Mistakes(named) = verdict else { panic!("{verdict:?}") };
                        let tells =
                            |named: &Mistake| *named == mistake || named.is_part_of(mistake);
                        assert!(named.iter().any(tells), "{question:?} {mistake:?}: {named:?}");
                    }
                }
            }
            // What is wrong is said once, and every other part refers to one that says it.
            let sources = Vec::from_iter(parts.map(|k| question.source_of(k, &verdicts)));
            let mut said = HashSet::new();
            for ((part, verdict), source) in question.parts.iter().zip(&verdicts).zip(&sources) {
                let verdict = verdict.as_ref().unwrap();
                let sentence = verdict.sentence(part);
                let is_new = verdict.is_right() || source.is_some() || said.insert(sentence);
                assert!(is_new, "{question:?} {mistake:?}: {verdicts:?}");
                let is_head = |asked: Asked| {
                    let parts = question.parts.iter().zip(&sources);
                    parts.into_iter().any(|(part, from)| part.asked == asked && from.is_none())
                };
                assert!(source.is_none_or(is_head), "{question:?} {mistake:?}: {sources:?}");
            }
        }
    }
}

#[test]
fn every_seed_gives_a_question_that_can_be_solved() {
    for &exercise in Exercise::LISTED {
        let asked = |question: &Question| -> Vec<Asked> {
            question.parts.iter().map(|part| part.asked).collect()
        };
        let known = asked(&Question::new(exercise, None));
        assert!(!known.is_empty(), "{exercise:?}");
        for seed in (0..3000).chain(1_000_000_000 - 100..=1_000_000_000) {
            let question = Question::new(exercise, Some(seed));
            assert_eq!(asked(&question), known, "{exercise:?} {seed}");
            let is_finite = |part: &QuestionPart| match &part.truth {
                Answer::Numbers(truth) => truth.iter().all(|x| x.is_finite()),
                Answer::Yes(_) => true,
            };
            assert!(question.parts.iter().all(is_finite), "{question:?}");
        }
    }
}

#[test]
fn seeds_are_kept_and_differ() {
    for &exercise in Exercise::LISTED {
        assert_eq!(Question::new(exercise, Some(7)), Question::new(exercise, Some(7)));
        let all: Vec<_> = (0..20).map(|seed| Question::new(exercise, Some(seed)).given).collect();
        let others = all.iter().filter(|given| **given != all[0]).count();
        assert!(others >= 12, "{exercise:?}: {all:?}");
    }
}

#[test]
fn lessons_name_exercises_by_ids_that_stay() {
    let ids: Vec<_> = Exercise::LISTED.iter().map(|exercise| exercise.id()).collect();
    let known = [
        "pixel-uv",
        "warm-up-ray",
        "point-at-t",
        "warm-up-plane",
        "distance",
        "turned-basis",
        "view-up",
        "eye-at-up",
        "coefficients",
        "sphere",
        "lines",
    ];
    assert_eq!(ids, known);
}

#[test]
fn a_direction_may_be_any_positive_multiple_where_the_question_allows_it() {
    let verdict = |exercise, d: [f64; 3]| judged(exercise, Asked::Direction, numbers(&d));
    let ray = Exercise::WarmUpRay;
    assert_eq!(verdict(ray, [0.4, -0.2, -2.0]), Verdict::Multiple { times: 2.0 });
    assert!(verdict(ray, [0.4, -0.2, -2.0]).is_right());
    let Verdict::Backwards { times } = verdict(ray, [-0.2, 0.1, 1.0]) else { panic!() };
    assert_eq!(times, -1.0);
    let length = 1.05f64.sqrt();
    let Verdict::Multiple { times } = verdict(ray, [0.2 / length, -0.1 / length, -1.0 / length])
    else {
        panic!()
    };
    assert!((times * length - 1.0).abs() < 1e-15);
    assert_eq!(verdict(ray, [0.195, -0.0976, -0.976]), Verdict::Rounded { digits: 3 });
    // If t is also asked for, the length matters.
    let Verdict::OtherLength { times } = verdict(Exercise::Turned, [-1.6 * S, -0.2, -2.4 * S])
    else {
        panic!()
    };
    assert!((times - 2.0).abs() < 1e-15);
    assert!(matches!(
        verdict(Exercise::Turned, [0.8 * S, 0.1, 1.2 * S]),
        Verdict::Backwards { .. }
    ));
}

#[test]
fn a_rounded_answer_is_told_apart_from_a_wrong_one() {
    let u = |x: f64, z: f64| judged(Exercise::Turned, Asked::U, numbers(&[x, 0.0, z]));
    assert_eq!(u(0.707, -0.707), Verdict::Rounded { digits: 3 });
    assert_eq!(u(0.71, -0.70711), Verdict::Rounded { digits: 2 });
    // One digit is too few for a rounded answer.
    assert!(matches!(u(0.7, -0.70711), Verdict::Wrong(_)));
    assert!(matches!(u(0.7, -0.7), Verdict::OtherLength { .. }));
    assert_eq!(u(0.7071067811865, -S), Verdict::Right, "all the digits that matter");
    assert!(matches!(u(0.708, -0.707), Verdict::Wrong(_)));
    let t = |t: f64| judged(Exercise::Turned, Asked::T, numbers(&[t]));
    assert_eq!(t(7.07), Verdict::Rounded { digits: 3 });
    assert_eq!(t(7.0710678), Verdict::Rounded { digits: 8 });
    assert!(matches!(t(7.08), Verdict::Wrong(_)));
    assert!(matches!(t(7.0), Verdict::Wrong(_)));
}

/// The right number minus one unit in the last typed digit does not pass for the right number
/// truncated, although rounding errors of binary subtraction suggest it.
#[test]
fn a_number_just_below_a_short_one_is_wrong() {
    for (exercise, asked, answer) in [
        (Exercise::Sphere, Asked::T, vec![3.99]),
        (Exercise::WarmUpPlane, Asked::T, vec![5.9]),
        (Exercise::WarmUpPlane, Asked::T, vec![5.99]),
        (Exercise::Distance, Asked::T, vec![2.99]),
        (Exercise::WarmUpPlane, Asked::Point, vec![1.1, -0.6, -6.0]),
        // These numbers do not come from the mistakes that give 6, 8 and 5, either.
        (Exercise::Sphere, Asked::T, vec![5.99]),
        (Exercise::Sphere, Asked::T, vec![7.9]),
        (Exercise::WarmUpPlane, Asked::T, vec![4.9]),
    ] {
        let verdict = judged(exercise, asked, numbers(&answer));
        assert!(matches!(verdict, Verdict::Wrong(_)), "{exercise:?} {answer:?}: {verdict:?}");
    }
}

#[test]
fn digits_cut_off_are_told_like_rounded_ones() {
    let t = |t: f64| judged(Exercise::Turned, Asked::T, numbers(&[t]));
    // 7.0710678...
    assert_eq!(t(7.071067), Verdict::Rounded { digits: 7 });
    assert!(matches!(t(7.071066), Verdict::Wrong(_)));
    let u = |x: f64, z: f64| judged(Exercise::EyeAtUp, Asked::U, numbers(&[x, 0.0, z]));
    // 0.581238..., -0.813733...
    assert_eq!(u(0.5812, -0.8137), Verdict::Rounded { digits: 4 });
    assert!(u(0.5812, -0.8137).is_right() && !u(0.581, -0.814).is_right());
    assert_eq!(u(0.58123, -0.81373), Verdict::Rounded { digits: 5 });
    assert!(matches!(u(0.58122, -0.81373), Verdict::Wrong(_)));
    // A mistake's number may be truncated, too: 6 |d| = 6.1481...
    let t = judged(Exercise::WarmUpPlane, Asked::T, numbers(&[6.14]));
    assert_eq!(t, Verdict::Mistakes(vec![Mistake::TForDistance]));
}

#[test]
fn otherwise_it_says_what_is_wrong() {
    let verdict = |asked, v: [f64; 3]| match judged(Exercise::ViewUp, asked, numbers(&v)) {
        Verdict::Wrong(findings) => findings,
        other => panic!("{other:?}"),
    };
    assert_eq!(verdict(Asked::U, [0.0; 3]), ["a direction cannot be (0, 0, 0)"]);
    assert_eq!(
        verdict(Asked::U, [0.0, 3.0, 1.0]),
        [
            "𝑦 should be another number",
            "its length is √10, not 1",
            "it is not perpendicular to up: the dot product is 6",
            "it is not perpendicular to 𝐰: the dot product is 3",
        ]
    );
    assert_eq!(
        verdict(Asked::V, [0.6, 0.0, 0.8]),
        [
            "𝑥 should be another number",
            "𝑧 should be another number",
            "it is not perpendicular to 𝐮: the dot product is 0.8",
        ]
    );
    // A point has no length and no direction.
    let of_point = |v: [f64; 3]| judged(Exercise::WarmUpPlane, Asked::Point, numbers(&v));
    for v in [[0.2, -0.1, -1.0], [0.0; 3]] {
        let Verdict::Wrong(findings) = of_point(v) else { panic!("{:?}", of_point(v)) };
        assert!(findings.iter().all(|said| !said.contains("direction")), "{v:?}");
    }
    for strange in [&[1.2, -0.6][..], &[1.2, -0.6, f64::NAN], &[1.2, -0.6, -6.0, 0.0]] {
        let verdict = judged(Exercise::WarmUpPlane, Asked::Point, numbers(strange));
        let expected = vec!["every coordinate should be another number".to_owned()];
        assert_eq!(verdict, Verdict::Wrong(expected), "{strange:?}");
    }
    let none = judged(Exercise::WarmUpPlane, Asked::T, numbers(&[f64::NAN]));
    assert_eq!(none, Verdict::Wrong(vec!["it should be another number".to_owned()]));
}

#[test]
fn the_questions_camera_sends_the_questions_ray() {
    for question in questions() {
        let Some(camera) = question.camera() else {
            assert_eq!(question.exercise, Exercise::Lines);
            continue;
        };
        let resolved = camera.resolve().unwrap();
        let ray = question.uv().map(|uv| resolved.ray(uv));
        for part in &question.parts {
            let Answer::Numbers(truth) = &part.truth else { continue };
            let basis = resolved.basis();
            let known = match part.asked {
                Asked::U => basis.u.to_array().to_vec(),
                Asked::V => basis.v.to_array().to_vec(),
                Asked::W => basis.w.to_array().to_vec(),
                Asked::Direction => ray.unwrap().direction.to_array().to_vec(),
                Asked::Origin => resolved.eye().to_array().to_vec(),
                Asked::T => {
                    let scene = pinhole_core::Scene::new(
                        question.sphere().into_iter().collect(),
                        question.plane().into_iter().collect(),
                    );
                    vec![scene.unwrap().first_hit(&ray.unwrap()).unwrap().t]
                }
                _ => continue,
            };
            let near =
                known.iter().zip(truth).all(|(x, y)| (x - y).abs() < 1e-13 * y.abs().max(1.0));
            assert!(near, "{question:?}: {known:?}");
        }
    }
}
