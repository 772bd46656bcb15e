//! Wrong numbers to which no known mistake leads. The verdict substitutes them into the equation that
//! they should solve, and states what remains.

use std::f64::consts::FRAC_1_SQRT_2 as S;

use pinhole_lecture::exercises::{Answer, Asked, Exercise, Verdict};
use pinhole_lecture::numbers::written;

use super::{alone, judged, numbers, questions};

/// The verdict states by how much a wrong answer fails the equation into which it is substituted.
#[test]
fn a_wrong_number_is_told_by_what_it_leaves_over() {
    let wrong = |exercise, asked, answer: &[f64]| match judged(exercise, asked, numbers(answer)) {
        Verdict::Wrong(findings) => findings,
        other => panic!("{exercise:?} {asked:?} {answer:?}: {other:?}"),
    };
    let wall = Exercise::WarmUpPlane;
    assert_eq!(wrong(wall, Asked::T, &[5.5]), ["at this 𝑡, 𝑧 is −5.5, not the wall's −6"]);
    // |(0, 1, 0)|^2 minus the square of its component along d, (-0.1)^2/1.05.
    let away = (1.0 - 0.01 / 1.05_f64).sqrt();
    assert_eq!(
        wrong(wall, Asked::Point, &[0.0, 1.0, 0.0]),
        [
            "its 𝑧 is 0, not the wall's −6".to_owned(),
            format!("it is not on the ray, but {} away from it", written(away, 5)),
        ]
    );
    let ray = Exercise::WarmUpRay;
    assert_eq!(
        wrong(ray, Asked::Origin, &[3.0, 4.0, 0.0])[2..],
        ["it is 5 from the eye, where every view ray starts"]
    );
    let findings = wrong(ray, Asked::Direction, &[1.0, 0.5, -2.0]);
    assert_eq!(findings, ["it passes the viewport at (𝑢, 𝑣) = (0.5, 0.25), not (0.2, −0.1)"]);
    let findings = wrong(ray, Asked::Direction, &[1.0, 0.5, 2.0]);
    assert_eq!(findings, ["it does not point forwards: 𝐝 · 𝐰 is 2, and must be below 0"]);
    // Straight along -w = (-s, 0, -s), plus half of u = (s, 0, -s).
    let findings = wrong(Exercise::Turned, Asked::Direction, &[-0.5 * S, 0.0, -1.5 * S]);
    let [passed] = &findings[..] else { panic!("{findings:?}") };
    assert!(passed.starts_with("it passes the viewport at (𝑢, 𝑣) = (0.5, "), "{passed}");
    let sphere = Exercise::Sphere;
    assert_eq!(
        wrong(sphere, Asked::T, &[2.5]),
        [
            "the point at this 𝑡 is not on the sphere: it is 2.5 from the centre, and the radius is 1"
        ]
    );
    let [.., on, beside] = &wrong(sphere, Asked::Point, &[3.0, 4.0, -5.0])[..] else { panic!() };
    assert_eq!(on, "it is not on the sphere: it is 5 from the centre, and the radius is 1");
    assert_eq!(beside, "it is not on the ray, but 5 away from it");
    let degrees = written(0.8f64.acos().to_degrees(), 5);
    assert_eq!(
        wrong(sphere, Asked::Normal, &[0.0, 0.6, 0.8]),
        [
            "𝑦 should be another number".to_owned(),
            "𝑧 should be another number".to_owned(),
            format!("it is {degrees}° off the direction from the centre to the hit"),
        ]
    );
    let lines = Exercise::Lines;
    assert_eq!(
        wrong(lines, Asked::T, &[2.5]),
        ["the point at this 𝑡 is not on the line: put into its equation, it gives 3, not 0"]
    );
    // On the line but not on the ray: (3, -1) is 2 √2 from (1, 1), perpendicular to the ray.
    let findings = wrong(lines, Asked::Point, &[3.0, -1.0]);
    assert_eq!(findings, ["it is not on the ray, but 2√2 away from it"]);
}

/// Whatever wrong number is typed, the verdict gives a reason, and does not just say that it should be
/// another number.
#[test]
fn every_wrong_number_gets_a_reason() {
    for question in questions() {
        for (index, part) in question.parts.iter().enumerate() {
            let Answer::Numbers(truth) = &part.truth else { continue };
            // All coordinates are wrong, and no mistake gives them.
            let given: Vec<f64> =
                (0..truth.len()).map(|k| truth[k] + 0.128_374_65 + 0.037_1 * k as f64).collect();
            let verdict = alone(&question, index, numbers(&given));
            let Verdict::Wrong(findings) = verdict else { panic!("{question:?}: {verdict:?}") };
            let is_reason = |said: &String| {
                !["it should be another number", "every coordinate should be another number"]
                    .contains(&&**said)
            };
            assert!(findings.iter().all(is_reason), "{:?} {given:?}", question.given);
        }
    }
}
