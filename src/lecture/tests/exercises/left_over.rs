//! Wrong numbers that no mistake gives; the verdict states the remainder that they leave in the
//! equation.

use std::f64::consts::{FRAC_1_SQRT_2 as S, SQRT_2};

use pinhole_core::DVec2;
use pinhole_lecture::exercises::{Answer, Asked, Exercise, Finding, Verdict};

use super::{alone, judged, numbers, questions};

/// The verdict states the remainder when the answer is substituted.
#[test]
fn a_wrong_number_is_told_by_what_it_leaves_over() {
    let wrong = |exercise, asked, answer: &[f64]| match judged(exercise, asked, numbers(answer)) {
        Verdict::Wrong(findings) => findings,
        other => panic!("{exercise:?} {asked:?} {answer:?}: {other:?}"),
    };
    let wall = Exercise::WarmUpPlane;
    assert_eq!(wrong(wall, Asked::T, &[5.5]), [Finding::OffWall { z: -5.5, wall: -6.0 }]);
    let findings = wrong(wall, Asked::Point, &[0.0, 1.0, 0.0]);
    let [Finding::OffWall { z: 0.0, wall: -6.0 }, Finding::OffRay { distance }] = findings[..]
    else {
        panic!("{findings:?}")
    };
    // |(0, 1, 0)|^2 minus the square of its component along d, (-0.1)^2/1.05.
    assert!((distance.powi(2) - (1.0 - 0.01 / 1.05)).abs() < 1e-12);
    let ray = Exercise::WarmUpRay;
    assert_eq!(
        wrong(ray, Asked::Origin, &[3.0, 4.0, 0.0])[2..],
        [Finding::OffEye { distance: 5.0 }]
    );
    let findings = wrong(ray, Asked::Direction, &[1.0, 0.5, -2.0]);
    let (uv, wanted) = (DVec2::new(0.5, 0.25), DVec2::new(0.2, -0.1));
    assert_eq!(findings, [Finding::OffUv { uv, wanted }]);
    let findings = wrong(ray, Asked::Direction, &[1.0, 0.5, 2.0]);
    assert_eq!(findings, [Finding::NotForwards { along_w: 2.0 }]);
    // Straight along -w = (-s, 0, -s), plus half of u = (s, 0, -s).
    let findings = wrong(Exercise::Turned, Asked::Direction, &[-0.5 * S, 0.0, -1.5 * S]);
    let [Finding::OffUv { uv, .. }] = findings[..] else { panic!("{findings:?}") };
    assert!(uv.distance(DVec2::new(0.5, 0.0)) < 1e-12);
    let sphere = Exercise::Sphere;
    assert_eq!(
        wrong(sphere, Asked::T, &[2.5]),
        [Finding::OffSphere { distance: 2.5, radius: 1.0 }]
    );
    let [.., on, beside] = &wrong(sphere, Asked::Point, &[3.0, 4.0, -5.0])[..] else { panic!() };
    assert_eq!(*on, Finding::OffSphere { distance: 5.0, radius: 1.0 });
    assert_eq!(*beside, Finding::OffRay { distance: 5.0 });
    let findings = wrong(sphere, Asked::Normal, &[0.0, 0.6, 0.8]);
    let [Finding::Coordinate(1), Finding::Coordinate(2), Finding::Angle { degrees }] = findings[..]
    else {
        panic!("{findings:?}")
    };
    assert!((degrees - 0.8f64.acos().to_degrees()).abs() < 1e-12);
    let lines = Exercise::Lines;
    assert_eq!(wrong(lines, Asked::T, &[2.5]), [Finding::OffLine { value: 3.0 }]);
    // On the line but not on the ray: (3, -1) is 2 √2 from (1, 1), perpendicular to the ray.
    let findings = wrong(lines, Asked::Point, &[3.0, -1.0]);
    let [Finding::OffRay { distance }] = findings[..] else { panic!("{findings:?}") };
    assert!((distance - 2.0 * SQRT_2).abs() < 1e-12);
}

/// Whatever number is typed, the verdict says more than that it is another number.
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
            assert!(!findings.contains(&Finding::Another), "{:?} {given:?}", question.given);
        }
    }
}
