//! Tests of grading the answers of a student's program, with and without mistakes.

mod grazing;
mod habits;
mod pictures;
mod random;
mod student;
mod tolerance;
mod written;

use pinhole_core::*;
use pinhole_lecture::grading::*;
use pinhole_lecture::mistakes::Mistake;
use proptest::prelude::*;

use student::double::{Student, exactly};
use student::{Exercise, single};

/// A camera and scene without special values, so that every mistake changes the answers. Ball 2 is
/// behind the eye; the back wall is behind everything.
fn general() -> Exercise {
    Exercise {
        eye: [1.0, 2.0, 3.0],
        at: [-2.0, 0.5, -4.0],
        up: [0.5, 2.0, 0.25],
        viewport: [1.5, 1.0, 2.0],
        image: [30, 20],
        spheres: vec![([-1.0, 1.0, -2.0], 0.7), ([-3.5, 0.6, -4.5], 1.2), ([2.5, 3.0, 6.5], 1.5)],
        planes: vec![([0.0, 0.0, -9.0], [0.1, 0.2, 1.0])],
    }
}

fn camera_of(exercise: &Exercise) -> Camera {
    let Exercise { eye, at, up, viewport: [width, height, distance], image, .. } = exercise.clone();
    Camera {
        eye: eye.into(),
        orientation: Orientation::At { at: at.into(), up: up.into() },
        viewport: Viewport { width, height, distance },
        image: ImageSize::new(image[0], image[1]).unwrap(),
    }
}

fn scene_of(exercise: &Exercise) -> Scene {
    let spheres = exercise.spheres.iter().map(|(c, r)| Sphere::new(*c, *r).unwrap()).collect();
    let planes = exercise.planes.iter().map(|(p, n)| Plane::new(*p, *n).unwrap()).collect();
    Scene::new(spheres, planes).unwrap()
}

fn graded(exercise: &Exercise, answers: &Answers) -> Grade {
    let (camera, scene) = (camera_of(exercise), scene_of(exercise));
    let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [230, 159, 0] };
    grade(&truth, answers, None).unwrap()
}

fn basis_of(student: &Student) -> Answers {
    Answers::Basis(student.basis().map(exactly))
}

fn rays_of(student: &Student) -> Answers {
    Answers::Rays(student.rays())
}

fn hits_of(student: &Student) -> Answers {
    Answers::Hits(student.hits())
}

fn ids(mistakes: &[Mistake]) -> Vec<&'static str> {
    mistakes.iter().map(|mistake| mistake.id()).collect()
}

/// Returns the diagnosis: the named set of mistakes, followed by its alternatives; only `right` if all
/// answers agree.
fn found(exercise: &Exercise, answers: &Answers) -> Vec<Vec<&'static str>> {
    let grade = graded(exercise, answers);
    assert_eq!(grade.worst.is_some_and(|worst| grade.is_right[worst.index]), grade.all_agree());
    if grade.all_agree() {
        return vec![vec!["right"]];
    }
    let Diagnosis { mistakes, alternatives, .. } = grade.diagnosis;
    [vec![ids(&mistakes)], alternatives.iter().map(|set| ids(set)).collect()].concat()
}

#[track_caller]
fn assert_right(exercise: &Exercise, answers: &Answers) {
    let grade = graded(exercise, answers);
    let worst = grade.worst;
    assert!(grade.all_agree(), "{} of {}: {worst:?}", grade.agree(), grade.answers());
    assert_eq!((grade.diagnosis, worst.is_some()), (Diagnosis::default(), true));
    assert_eq!((grade.right_digits, grade.sentinel), (None, None));
}

/// The graded mistakes that the student's program can make, each with the variants in which it makes
/// them. `single-precision` is missing, because it needs a program in `f32`.
const MISTAKES: [(&str, &[&str]); 15] = [
    ("w-as-printed", &["w-as-printed"]),
    ("v-is-u-cross-w", &["v-is-u-cross-w"]),
    ("not-normalized", &["not-normalized", "not-normalized/w", "not-normalized/all"]),
    ("up-as-v", &["up-as-v"]),
    ("distance-dropped", &["distance-dropped", "distance-dropped/left-out"]),
    ("pixel-corner", &["pixel-corner"]),
    ("rows-from-bottom", &["rows-from-bottom"]),
    ("rows-columns-swapped", &["rows-columns-swapped"]),
    ("counted-from-one", &["counted-from-one"]),
    ("aspect-dropped", &["aspect-dropped"]),
    ("left-handed", &["left-handed", "left-handed/u"]),
    ("b-for-half-b", &["b-for-half-b", "b-for-half-b/halved"]),
    ("far-root", &["far-root"]),
    ("negative-t", &["negative-t"]),
    ("t-for-distance", &["t-for-distance", "t-for-distance/point"]),
];

/// The mistakes that grading looks for only alone, not in pairs, and `last-object`, each with the
/// variants in which the student's program makes it.
const ALONE: [(&str, &[&str]); 9] = [
    ("last-object", &["last-object", "last-object/farthest"]),
    ("sign-of-b", &["sign-of-b"]),
    ("center-left-out", &["center-left-out"]),
    ("origin-left-out", &["origin-left-out"]),
    ("radius-not-squared", &["radius-not-squared"]),
    ("root-left-out", &["root-left-out", "root-left-out/d"]),
    ("viewport-swapped", &["viewport-swapped"]),
    ("viewport-scaled", &["viewport-scaled", "viewport-scaled/twice"]),
    ("eye-in-direction", &["eye-in-direction"]),
];

/// A camera and scene in which each mistake of [`ALONE`] gives hits that no other mistake gives. Balls
/// overlap, there is no wall, one ball is behind the eye, and the eye is so near the origin that adding
/// it to a direction reverses no ray.
fn telling() -> Exercise {
    Exercise {
        eye: [0.3, -0.2, -0.5],
        at: [-2.7, -1.7, -7.5],
        viewport: [1.5, 1.0, 1.7],
        spheres: vec![
            ([-1.7, -1.2, -5.5], 0.7),
            ([-2.1, -1.3, -6.3], 1.1),
            ([-1.3, -0.9, -4.5], 0.3),
            ([1.8, 0.8, 3.0], 1.5),
        ],
        planes: vec![],
        ..general()
    }
}

/// The mistakes that can be recognised in a basis.
const OF_BASIS: [&str; 5] =
    ["w-as-printed", "v-is-u-cross-w", "not-normalized", "up-as-v", "left-handed"];
const OF_HITS: [&str; 4] = ["b-for-half-b", "far-root", "negative-t", "t-for-distance"];

fn mistake_of(id: &str) -> Option<Mistake> {
    Mistake::ALL.iter().copied().find(|mistake| mistake.id() == id)
}

#[test]
fn each_mistake_alone_is_found_by_name() {
    let exercise = general();
    for (id, ways) in MISTAKES {
        for way in ways {
            let student = Student { exercise: &exercise, mistakes: &[*way] };
            if OF_BASIS.contains(&id) {
                assert_eq!(found(&exercise, &basis_of(&student)), [[id]], "{way}");
            } else {
                assert_right(&exercise, &basis_of(&student));
            }
            // The picture is upside down, whether v or the rows are reversed; rays cannot
            // distinguish the two.
            let upside_down = vec![vec!["rows-from-bottom"], vec!["v-is-u-cross-w"]];
            let expected = match id {
                "v-is-u-cross-w" | "rows-from-bottom" => upside_down,
                _ => vec![vec![id]],
            };
            let sets = found(&exercise, &rays_of(&student));
            if *way == "distance-dropped" {
                // At half the distance, the viewport appears twice as large.
                assert_eq!(sets, [["distance-dropped"], ["viewport-scaled"]]);
            } else if !OF_HITS.contains(&id) {
                assert_eq!(sets, expected, "rays, {way}");
            }
            let sets = found(&exercise, &hits_of(&student));
            if *way == "b-for-half-b/halved" {
                // It sees none of the balls, but only the wall, which is the farthest object.
                assert_eq!(sets, [["b-for-half-b"], ["far-root"], ["last-object"]], "hits, {way}");
            } else {
                assert_eq!(sets, expected, "hits, {way}");
            }
        }
    }
    let a_left_out = Student { exercise: &exercise, mistakes: &["not-normalized/a"] };
    assert_right(&exercise, &rays_of(&a_left_out));
    assert_eq!(found(&exercise, &hits_of(&a_left_out)), [["not-normalized"]]);
}

#[test]
fn each_slip_alone_is_found_by_name() {
    let exercise = telling();
    for (id, ways) in ALONE {
        for way in ways {
            let student = Student { exercise: &exercise, mistakes: &[*way] };
            assert_right(&exercise, &basis_of(&student));
            if ["viewport-swapped", "viewport-scaled", "eye-in-direction"].contains(&id) {
                assert_eq!(found(&exercise, &rays_of(&student)), [[id]], "rays, {way}");
            } else {
                assert_right(&exercise, &rays_of(&student));
            }
            assert_eq!(found(&exercise, &hits_of(&student)), [[id]], "hits, {way}");
            let student = single::Student { exercise: &exercise, mistakes: &[*way] };
            let hits = Answers::Hits(student.hits());
            assert_eq!(found(&exercise, &hits), [[id]], "hits in f32, {way}");
        }
    }
    let last = Student { exercise: &exercise, mistakes: &["rows-from-bottom", "last-object"] };
    assert_eq!(found(&exercise, &hits_of(&last))[0], ["rows-from-bottom", "last-object"]);
}

/// If several mistakes give the same answers, the advice says that the named mistake is not certain.
#[test]
fn what_may_be_another_mistake_says_so() {
    let exercise = general();
    let ahead = Exercise { spheres: general().spheres[..2].to_vec(), ..general() };
    for (exercise, answers_of, way, named, others) in [
        (
            &exercise,
            rays_of as fn(&Student) -> Answers,
            "viewport-scaled/twice",
            "distance-dropped",
            "viewport-scaled",
        ),
        (&ahead, hits_of, "sign-of-b", "b-for-half-b", "far-root; last-object; sign-of-b"),
    ] {
        let answers = answers_of(&Student { exercise, mistakes: &[way] });
        let grade = graded(exercise, &answers);
        assert_eq!(ids(&grade.diagnosis.mistakes), [named]);
        let image = camera_of(exercise).image;
        let advice = Graded { answers, grade, image, count_from: 0 }.advice();
        let hedge = format!("It may be another mistake, with the same answers here: {others}.");
        assert!(advice.ends_with(&hedge), "{advice}");
    }
}

#[test]
fn pairs_are_found_wherever_they_can_be_told() {
    let exercise = general();
    let alone = |exercise: &Exercise| Exercise { planes: vec![], ..exercise.clone() };
    for (k, (first, _)) in MISTAKES.iter().enumerate() {
        for (second, _) in &MISTAKES[k + 1..] {
            let pair = [*first, *second];
            let student = Student { exercise: &exercise, mistakes: &pair };
            let are_in = |known: &[&str]| pair.iter().all(|id| known.contains(id));
            if are_in(&OF_BASIS) {
                let expected: &[&str] = match pair {
                    // u = w x up and v = u x w already form the left-handed basis.
                    ["v-is-u-cross-w", "left-handed"] => &["left-handed"],
                    // v is up, whatever the calculation of v would have given.
                    ["v-is-u-cross-w", "up-as-v"] => &["up-as-v"],
                    _ => &pair,
                };
                assert_eq!(found(&exercise, &basis_of(&student))[0], expected, "basis, {pair:?}");
            }
            let expected: &[&str] = match pair {
                ["v-is-u-cross-w", "left-handed"] => &["left-handed"],
                ["v-is-u-cross-w", "up-as-v"] => &["up-as-v"],
                // Upside down twice.
                ["v-is-u-cross-w", "rows-from-bottom"] => &["right"],
                // Reversing u and v is the same as reversing u alone.
                ["rows-from-bottom", "left-handed"] => &["left-handed"],
                _ => &pair,
            };
            // Of two mistakes that look alike, the one about rows is named.
            let mut alike = expected.to_vec();
            for id in &mut alike {
                if *id == "v-is-u-cross-w" {
                    *id = "rows-from-bottom";
                }
            }
            let order = |id: &&str| MISTAKES.iter().position(|(known, _)| known == id);
            alike.sort_by_key(order);
            let check = |kind: &str, sets: Vec<Vec<&str>>| {
                assert_eq!(sets[0], alike, "{kind}, {pair:?}");
                assert!(sets.iter().any(|set| set == expected), "{kind}, {pair:?}: {sets:?}");
            };
            if !pair.iter().any(|id| OF_HITS.contains(id)) {
                check("rays", found(&exercise, &rays_of(&student)));
            }
            if pair == ["b-for-half-b", "far-root"] {
                // The far root of a doubled b is behind the wall, so hits without the wall
                // distinguish the mistakes.
                let exercise = alone(&exercise);
                let student = Student { exercise: &exercise, mistakes: &pair };
                check("hits", found(&exercise, &hits_of(&student)));
            } else {
                check("hits", found(&exercise, &hits_of(&student)));
            }
        }
    }
}

#[test]
fn rows_and_columns_from_one_are_right_when_said_and_a_mistake_when_not() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    assert_right(&exercise, &hits_of(&student));
    // A stated first row and column is subtracted beforehand; these are the numbers as written.
    let next = |pixel: Pixel| Pixel { row: pixel.row + 1, column: pixel.column + 1 };
    let rays = student.rays().into_iter().map(|ray| RayAnswer { pixel: next(ray.pixel), ..ray });
    let hits = student.hits().into_iter().map(|hit| HitAnswer { pixel: next(hit.pixel), ..hit });
    let (rays, hits) = (Answers::Rays(rays.collect()), Answers::Hits(hits.collect()));
    assert_eq!(found(&exercise, &rays), [["counted-from-one"]]);
    assert_eq!(found(&exercise, &hits), [["counted-from-one"]]);
    let grade = graded(&exercise, &rays);
    let worst = grade.worst.unwrap();
    assert_eq!((worst.right, worst.error), (AnswerValue::NoPixel, f64::INFINITY));
}

#[test]
fn numbers_of_six_digits_are_right_and_fewer_are_not() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    let to_digits = |x: f64, digits: usize| format!("{x:.*e}", digits - 1).parse::<f64>().unwrap();
    let written = |digits: usize| {
        let vector = |v: WrittenVector| Written {
            value: DVec3::from(v.value.to_array().map(|x| to_digits(x, digits))),
            rounding: 0.5 * 10f64.powi(1 - digits as i32) * v.value.abs().max_element(),
        };
        let number = |t: Written<f64>| Written {
            value: to_digits(t.value, digits),
            rounding: 0.5 * 10f64.powi(1 - digits as i32) * t.value.abs(),
        };
        let rays = student.rays().into_iter().map(|ray| RayAnswer {
            origin: vector(ray.origin),
            direction: vector(ray.direction),
            ..ray
        });
        let hits = student.hits().into_iter().map(|answer| HitAnswer {
            hit: answer.hit.map(|hit| GivenHit {
                t: hit.t.map(number),
                point: hit.point.map(vector),
                ..hit
            }),
            ..answer
        });
        let basis = student.basis().map(|v| vector(exactly(v)));
        [Answers::Basis(basis), Answers::Rays(rays.collect()), Answers::Hits(hits.collect())]
    };
    for answers in written(6) {
        assert_right(&exercise, &answers);
    }
    let without_digits = |answers: &Answers| match answers.clone() {
        Answers::Hits(hits) => Answers::Hits(
            hits.into_iter()
                .map(|answer| HitAnswer {
                    hit: answer.hit.map(|hit| GivenHit {
                        t: hit.t.map(|t| Written::exactly(t.value)),
                        point: None,
                        ..hit
                    }),
                    ..answer
                })
                .collect(),
        ),
        other => other,
    };
    let [_, _, hits] = written(3);
    let few = graded(&exercise, &without_digits(&hits));
    assert!(!few.all_agree());
    assert_eq!((few.right_digits, &few.diagnosis.mistakes[..]), (Some(3), &[][..]));
    assert_eq!(few.advice(), "The answers are right to 3 digits; write at least six.");
}

/// A number such as 4 has one digit, and no more are wanted where it is exact.
#[test]
fn short_numbers_that_are_exact_lack_no_digits() {
    let exercise = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [1.0; 3],
        image: [1, 1],
        spheres: vec![([0.0, 0.0, -5.0], 1.0)],
        planes: vec![],
    };
    let student = Student { exercise: &exercise, mistakes: &[] };
    assert_eq!(student.hit(0, 0).unwrap(), (4.0, [0.0, 0.0, -4.0], 0));
    for answers in [basis_of(&student), rays_of(&student), hits_of(&student)] {
        assert_right(&exercise, &answers);
    }
}

#[test]
fn a_stricter_tolerance_wants_its_digits() {
    let exercise = general();
    let (camera, scene) = (camera_of(&exercise), scene_of(&exercise));
    let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [0; 3] };
    let student = single::Student { exercise: &exercise, mistakes: &[] };
    let hits = Answers::Hits(student.hits());
    assert!(grade(&truth, &hits, None).unwrap().all_agree());
    let strict = grade(&truth, &hits, Some(1e-10)).unwrap();
    assert!(!strict.all_agree());
    assert_eq!(ids(&strict.diagnosis.mistakes), ["single-precision"]);
    let double = Student { exercise: &exercise, mistakes: &[] };
    assert!(grade(&truth, &hits_of(&double), Some(1e-10)).unwrap().all_agree());
}

/// A camera and scene so far from the world's origin that coordinates in `f32` have only three
/// decimals.
fn far_out() -> Exercise {
    let by = [8000.25, -3000.5, 5000.125];
    let moved = |v: [f64; 3]| [v[0] + by[0], v[1] + by[1], v[2] + by[2]];
    let Exercise { eye, at, spheres, planes, .. } = general();
    Exercise {
        eye: moved(eye),
        at: moved(at),
        spheres: spheres.into_iter().map(|(center, r)| (moved(center), r)).collect(),
        planes: planes.into_iter().map(|(point, normal)| (moved(point), normal)).collect(),
        ..general()
    }
}

#[test]
fn single_precision_is_found_where_it_does_not_suffice() {
    let exercise = far_out();
    let student = single::Student { exercise: &exercise, mistakes: &[] };
    assert_eq!(found(&exercise, &Answers::Hits(student.hits())), [["single-precision"]]);
    assert_right(&exercise, &hits_of(&Student { exercise: &exercise, mistakes: &[] }));
    for mistake in ["far-root", "rows-from-bottom", "distance-dropped", "t-for-distance"] {
        let student = single::Student { exercise: &exercise, mistakes: &[mistake] };
        let sets = found(&exercise, &Answers::Hits(student.hits()));
        let mut wanted = vec![mistake, "single-precision"];
        wanted.sort_by_key(|id| mistake_of(id));
        assert_eq!(sets[0], wanted);
        // In double precision, `f32` is not mentioned.
        let student = Student { exercise: &exercise, mistakes: &[mistake] };
        assert_eq!(found(&exercise, &hits_of(&student))[0], [mistake]);
    }
}

#[test]
fn many_spheres_are_graded_as_few_are() {
    // There are enough balls for an index, with which a ray finds the balls near it.
    let ball = |k: u32| {
        let part = |by: u32| f64::from(k.wrapping_mul(by) >> 8 & 0xffff) / 65536.0;
        let [x, y, z] = [2_654_435_761, 2_246_822_519, 3_266_489_917].map(part);
        ([8.0 * x - 6.0, 6.0 * y - 2.0, -10.0 * z - 1.0], 0.05 + 0.002 * f64::from(k % 50))
    };
    let exercise = Exercise { spheres: (0..600).map(ball).collect(), planes: vec![], ..general() };
    let hits = |mistakes: &[&str]| {
        let student = Student { exercise: &exercise, mistakes };
        found(&exercise, &hits_of(&student))
    };
    assert_eq!(hits(&[]), [["right"]]);
    for mistake in
        ["rows-columns-swapped", "pixel-corner", "b-for-half-b", "far-root", "t-for-distance"]
    {
        assert_eq!(hits(&[mistake]), [[mistake]]);
    }
    for (id, ways) in ALONE {
        for way in ways {
            let sets = hits(&[way]);
            assert!(sets.contains(&vec![id]), "{way}: {sets:?}");
        }
    }
    assert_eq!(hits(&["distance-dropped", "far-root"]), [["distance-dropped", "far-root"]]);
}

#[test]
fn what_cannot_be_graded_is_told() {
    let exercise = general();
    let graded_by = |camera: &Camera, answers: &Answers, tolerance| {
        let truth = Truth { camera, scene: &scene_of(&exercise), color_of: &|_| [0; 3] };
        grade(&truth, answers, tolerance)
    };
    let camera = camera_of(&exercise);
    let basis = Answers::Basis([DVec3::X, DVec3::Y, DVec3::Z].map(Written::exactly));
    let orientation = Orientation::At { at: exercise.eye.into(), up: DVec3::Y };
    let broken = graded_by(&Camera { orientation, ..camera }, &basis, None);
    assert!(broken.unwrap_err().starts_with("eye and at are the same point"));
    for tolerance in [-1.0, f64::NAN] {
        let message = graded_by(&camera, &basis, Some(tolerance)).unwrap_err().to_string();
        assert!(message.ends_with("it must be a number of at least 0"), "{message}");
    }
    for none in [Answers::Rays(vec![]), Answers::Hits(vec![])] {
        assert_eq!(graded_by(&camera, &none, None), Err("there is no answer to grade".to_owned()));
    }
    for pixels in [0, 20, 601] {
        let picture = Answers::Picture(vec![[0; 3]; pixels]);
        let error = graded_by(&camera, &picture, None).unwrap_err();
        assert!(error.starts_with(&format!("the picture has {pixels} pixels: it must have ")));
    }
    // The directions are so short that t is too large.
    let viewport = Viewport { width: 1e-310, height: 1e-310, distance: 1e-310 };
    let camera = Camera { viewport, image: ImageSize::new(1, 1).unwrap(), ..Camera::CANONICAL };
    let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    let scene = Scene::new(vec![ball], vec![]).unwrap();
    let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [0; 3] };
    let pixel = Pixel { row: 0, column: 0 };
    let answers = Answers::Hits(vec![HitAnswer { pixel, hit: None }]);
    let error = grade(&truth, &answers, None).unwrap_err();
    assert!(
        error.starts_with("the true t of row 0, column 0 (counted from 0) is beyond"),
        "{error}"
    );
}

#[test]
fn what_is_no_number_is_off_by_any() {
    let exercise = general();
    let pixel = Pixel { row: 19, column: 3 };
    let hit = |t: f64| GivenHit { t: Some(Written::exactly(t)), ..GivenHit::default() };
    let hits = Answers::Hits(vec![HitAnswer { pixel, hit: Some(hit(f64::NAN)) }]);
    let ray = |direction: DVec3| {
        let origin = Written::exactly(exercise.eye.into());
        Answers::Rays(vec![RayAnswer { pixel, origin, direction: Written::exactly(direction) }])
    };
    for answers in [hits, ray(DVec3::ZERO), ray(DVec3::NAN)] {
        let worst = graded(&exercise, &answers).worst.unwrap();
        assert_eq!(worst.error, f64::INFINITY);
    }
}
