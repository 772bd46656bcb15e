//! Answers about scenes from nowhere.

use super::*;

fn coordinate() -> impl Strategy<Value = f64> {
    (-1000..1000_i32).prop_map(|k| f64::from(k) * 0.01)
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [coordinate(), coordinate(), coordinate()]
}

fn exercise() -> impl Strategy<Value = Exercise> {
    let measure = || (10..400_i32).prop_map(|k| f64::from(k) * 0.01);
    let spheres = proptest::collection::vec((point(), measure()), 1..6);
    let planes = proptest::collection::vec((point(), point()), 0..2);
    let viewport = [measure(), measure(), measure()];
    (point(), point(), point(), viewport, [2..24_u32, 2..24_u32], spheres, planes)
        .prop_map(|(eye, at, up, viewport, image, spheres, planes)| Exercise {
            eye,
            at,
            up,
            viewport,
            image,
            spheres,
            planes,
        })
        .prop_filter("a camera and objects", |exercise| {
            let Exercise { planes, .. } = exercise;
            let is_flat = |(_, normal): &([f64; 3], [f64; 3])| *normal != [0.0; 3];
            camera_of(exercise).resolve().is_ok() && planes.iter().all(is_flat)
        })
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 200,
        failure_persistence: None,
        ..Default::default()
    })]

    /// No program without mistakes is called wrong, whatever the scene and however it rounds.
    #[test]
    fn right_programs_are_right(exercise in exercise(), scale in 0.01..50.0_f64) {
        let student = Student { exercise: &exercise, mistakes: &[] };
        let scaled = student.rays().into_iter().map(|ray| RayAnswer {
            direction: Written::exactly(scale * ray.direction.value),
            ..ray
        });
        for answers in [
            basis_of(&student),
            hits_of(&student),
            Answers::Rays(scaled.collect()),
        ] {
            let grade = graded(&exercise, &answers);
            prop_assert!(grade.all_agree(), "{:?}: {:?}", grade.kind, grade.worst);
        }
    }

    /// Answers computed in `f32` without mistakes are right, or the only mistake that is named is that
    /// `f32` is not precise enough.
    #[test]
    fn single_precision_is_blamed_for_nothing_else(exercise in exercise()) {
        let student = single::Student { exercise: &exercise, mistakes: &[] };
        for answers in [Answers::Rays(student.rays()), Answers::Hits(student.hits())] {
            let sets = found(&exercise, &answers);
            let known = vec![vec!["single-precision"]];
            prop_assert!(sets == [["right"]] || sets == known, "{:?}", sets);
        }
    }

    /// If a mistake changes any answer, it is among the mistakes that are named.
    #[test]
    fn a_mistake_is_found_in_any_scene(exercise in exercise(), which in 0..24_usize) {
        let all = [&MISTAKES.map(|(id, ways)| (id, &ways[..1]))[..], &ALONE].concat();
        let (id, ways) = all[which];
        for way in ways {
            let student = Student { exercise: &exercise, mistakes: &[*way] };
            for answers in [rays_of(&student), hits_of(&student)] {
                let sets = found(&exercise, &answers);
                prop_assert!(sets == [["right"]] || sets.contains(&vec![id]), "{way}: {sets:?}");
            }
        }
    }

    /// No mistakes explain random numbers.
    #[test]
    fn wrong_numbers_are_explained_by_nothing(
        factors in proptest::collection::vec(1.06..1.4_f64, 600),
        turns in proptest::collection::vec([-0.3..0.3_f64, -0.3..0.3_f64, -0.3..0.3_f64], 600),
    ) {
        let exercise = general();
        let student = Student { exercise: &exercise, mistakes: &[] };
        let mut hits = student.hits();
        for (answer, factor) in hits.iter_mut().zip(&factors) {
            if let Some(hit) = &mut answer.hit {
                hit.t = hit.t.map(|t| Written::exactly(factor * t.value));
            }
        }
        prop_assert_eq!(found(&exercise, &Answers::Hits(hits)), [[""; 0]]);
        let mut rays = student.rays();
        for (ray, turn) in rays.iter_mut().zip(&turns) {
            ray.direction.value += DVec3::from(*turn);
        }
        prop_assert_eq!(found(&exercise, &Answers::Rays(rays)), [[""; 0]]);
        // No mistake makes one wrong answer among right ones.
        let mut hits = student.hits();
        let k = (turns[0][0].abs() * 1999.0) as usize % hits.len();
        hits[k].hit = Some(GivenHit {
            t: Some(Written::exactly(3.0 * factors[0])),
            point: None,
            object: None,
        });
        prop_assert_eq!(found(&exercise, &Answers::Hits(hits)), [[""; 0]]);
    }
}
