//! Mistakes as students really make them.

use super::*;

/// Returns the mistakes that are named first for the hits, and for the rays, of a student's program
/// that makes one mistake.
fn named(exercise: &Exercise, mistake: &str) -> [Vec<&'static str>; 2] {
    let student = Student { exercise, mistakes: &[mistake] };
    [hits_of(&student), rays_of(&student)].map(|answers| found(exercise, &answers).swap_remove(0))
}

#[test]
fn other_ways_to_make_a_mistake_have_its_name() {
    // The viewport's ratio differs from the image's, so that neither can be calculated from the
    // other.
    let exercise = Exercise { viewport: [1.5, 1.1, 2.0], ..general() };
    for (way, id) in [
        ("aspect-dropped/image", "aspect-dropped"),
        ("rows-columns-swapped/counts", "rows-columns-swapped"),
        ("pixel-corner/across", "pixel-corner"),
    ] {
        assert_eq!(named(&exercise, way), [[id], [id]], "{way}");
    }
}

/// A program loops over rows 1 to H and columns 1 to W, and uses each number as if it counted from 0.
#[test]
fn a_loop_from_one_to_the_last_is_counted_from_one() {
    for viewport in [general().viewport, [1.0, 1.0, 1.0]] {
        let exercise = Exercise { viewport, ..general() };
        let [columns, rows] = exercise.image;
        for mistake in ["", "pixel-corner", "w-as-printed"] {
            let student = Student { exercise: &exercise, mistakes: &[mistake] };
            let mut rays = Vec::new();
            for (row, column) in (1..=rows).flat_map(|i| (1..=columns).map(move |j| (i, j))) {
                let (origin, direction) = student.ray(row, column);
                let [origin, direction] = [origin, direction].map(exactly);
                rays.push(RayAnswer { pixel: Pixel { row, column }, origin, direction });
            }
            let grade = graded(&exercise, &Answers::Rays(rays));
            let mut expected = vec!["counted-from-one"];
            if !mistake.is_empty() {
                expected.push(mistake);
                expected.sort_by_key(|id| mistake_of(id));
            }
            assert_eq!(ids(&grade.diagnosis.mistakes), expected);
            assert!(!grade.diagnosis.counted_from_one);
        }
    }
}

#[test]
fn right_answers_that_count_from_one_are_told_to_be() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    let next = |pixel: Pixel| Pixel { row: pixel.row + 1, column: pixel.column + 1 };
    let rays = student.rays().into_iter().map(|ray| RayAnswer { pixel: next(ray.pixel), ..ray });
    let grade = graded(&exercise, &Answers::Rays(rays.collect()));
    assert!(grade.diagnosis.counted_from_one);
}

/// Two mistakes are named, and a single mistake that gives the same rays is reported, too.
#[test]
fn one_mistake_that_looks_like_two_is_told_too() {
    let exercise = general();
    for (id, names, advice) in [
        (
            "ray-reversed",
            ["w-as-printed", "rows-from-bottom"],
            "Look at the direction's sign: every ray leads back to the eye, and it is d = point - eye.",
        ),
        (
            "distance-added",
            ["w-as-printed", "left-handed"],
            "Look at the direction's part along w: it is added, and it is -distance w.",
        ),
    ] {
        let student = Student { exercise: &exercise, mistakes: &[id] };
        for answers in [rays_of(&student), hits_of(&student)] {
            let found = graded(&exercise, &answers);
            assert_eq!(ids(&found.diagnosis.mistakes), names);
            assert_eq!(found.diagnosis.other, mistake_of(id));
            assert!(
                found.advice().ends_with(&format!("Another explanation: {advice}")),
                "{}",
                found.advice()
            );
            // If u, v and w are given, w cannot be reversed.
            let camera = camera_of(&exercise);
            let basis = *camera.resolve().unwrap().basis();
            let camera = Camera { orientation: Orientation::Basis(basis), ..camera };
            let scene = scene_of(&exercise);
            let truth = Truth { camera: &camera, scene: &scene, color_of: &|_| [0; 3] };
            let by_hand = grade(&truth, &answers, None).unwrap();
            assert_eq!(by_hand.diagnosis.mistakes, []);
            assert!(by_hand.advice().starts_with(advice), "{}", by_hand.advice());
        }
    }
    let both = Student { exercise: &exercise, mistakes: &["rows-from-bottom", "far-root"] };
    assert_eq!(graded(&exercise, &hits_of(&both)).diagnosis.other, None);
}

fn only_t(hits: Vec<HitAnswer>, write: impl Fn(f64) -> Written<f64>) -> Answers {
    let hits = hits.into_iter().map(|answer| {
        let t = answer.hit.and_then(|hit| hit.t).map(|t| write(t.value));
        HitAnswer { hit: t.map(|t| GivenHit { t: Some(t), ..GivenHit::default() }), ..answer }
    });
    Answers::Hits(hits.collect())
}

/// If a program makes a mistake and prints with `%.3f`, the few digits are reported next to the
/// mistake, and not attributed to `f32`.
#[test]
fn few_digits_beside_a_mistake_are_told_and_are_no_f32() {
    let exercise = general();
    for mistake in ["pixel-corner", "t-for-distance", "rows-from-bottom", "far-root"] {
        let student = Student { exercise: &exercise, mistakes: &[mistake] };
        let short = |t: f64| Written { value: (t * 1e3).round() / 1e3, rounding: 0.0 };
        let grade = graded(&exercise, &only_t(student.hits(), short));
        assert_eq!(ids(&grade.diagnosis.mistakes), [mistake]);
        let advice = grade.advice();
        assert!(advice.ends_with(" digits: write at least six."), "{advice}");
    }
}

/// Among many numbers with few digits, such as the t of a plane, a single number in full `f64`
/// precision rules out a program in `f32`.
#[test]
fn one_number_of_full_precision_anywhere_is_no_f32() {
    let exercise = general();
    let student = single::Student { exercise: &far_out(), mistakes: &[] };
    let mut hits = student.hits();
    let answers = |hits: &[HitAnswer]| only_t(hits.to_vec(), Written::exactly);
    let single = Answers::Hits(hits.clone());
    assert_eq!(found(&far_out(), &single), [["single-precision"]]);
    let last = hits.iter_mut().rev().find_map(|answer| answer.hit.as_mut()?.t.as_mut()).unwrap();
    last.value *= 1.0 + 1e-6;
    assert_eq!(found(&far_out(), &answers(&hits)), [[""; 0]]);
    assert_right(&exercise, &hits_of(&Student { exercise: &exercise, mistakes: &[] }));
}

#[test]
fn one_number_for_every_miss_is_told_to_stand_for_it() {
    let exercise = Exercise { planes: vec![], ..general() };
    let student = Student { exercise: &exercise, mistakes: &[] };
    for stands in [-1.0, 0.0, 1e30] {
        let hits = student.hits().into_iter().map(|answer| {
            let t = answer.hit.map_or(Written::exactly(stands), |hit| hit.t.unwrap());
            HitAnswer { hit: Some(GivenHit { t: Some(t), ..GivenHit::default() }), ..answer }
        });
        let grade = graded(&exercise, &Answers::Hits(hits.collect()));
        assert_eq!((grade.sentinel, &grade.diagnosis.mistakes[..]), (Some(stands), &[][..]));
        assert!(grade.advice().starts_with("t = "), "{}", grade.advice());
        assert!(grade.advice().contains("seems to stand for a miss"), "{}", grade.advice());
    }
    // If there is another mistake, both are named.
    for mistake in ["far-root", "rows-from-bottom", "distance-added"] {
        let student = Student { exercise: &exercise, mistakes: &[mistake] };
        let hits = student.hits().into_iter().map(|answer| {
            let t = answer.hit.map_or(-1.0, |hit| hit.t.unwrap().value);
            let t = Some(Written::exactly(t));
            HitAnswer { hit: Some(GivenHit { t, ..GivenHit::default() }), ..answer }
        });
        let grade = graded(&exercise, &Answers::Hits(hits.collect()));
        let named = found(&exercise, &hits_of(&student)).swap_remove(0);
        assert_eq!(ids(&grade.diagnosis.mistakes)[..], named[..]);
        assert!(grade.advice().contains("t = -1 seems to stand for a miss"), "{}", grade.advice());
    }
}

#[test]
fn objects_from_one_are_told_apart_from_rows() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    for by in [0, 1] {
        let hits = student.hits().into_iter().map(|answer| {
            let Pixel { row, column } = answer.pixel;
            let pixel = Pixel { row: row + by, column: column + by };
            let hit = answer.hit.map(|hit| GivenHit { object: hit.object.map(|k| k + 1), ..hit });
            HitAnswer { pixel, hit }
        });
        let grade = graded(&exercise, &Answers::Hits(hits.collect()));
        assert_eq!(ids(&grade.diagnosis.mistakes), ["counted-from-one"]);
        assert!(grade.diagnosis.objects_from_one);
        assert!(grade.advice().contains("Objects are counted from 1"), "{}", grade.advice());
    }
}

/// With many answers and spheres, only a sample of the answers is compared, because comparing all of
/// them would take minutes.
#[test]
fn many_answers_and_spheres_are_sampled_and_that_is_told() {
    let ball = |k: u32| ([f64::from(k % 100) - 50.0, f64::from(k / 100) - 50.0, -60.0], 0.4);
    let spheres: Vec<_> = (0..10_000).map(ball).collect();
    let exercise = Exercise { spheres, planes: vec![], image: [100, 80], ..general() };
    let student = Student { exercise: &exercise, mistakes: &["b-for-half-b"] };
    let pixel = |k: u32| Pixel { row: k / 100, column: k % 100 };
    let answer = |k: u32| {
        let hit = student.hit(pixel(k).row, pixel(k).column);
        let hit =
            hit.map(|(t, ..)| GivenHit { t: Some(Written::exactly(t)), ..GivenHit::default() });
        HitAnswer { pixel: pixel(k), hit }
    };
    let grade = graded(&exercise, &Answers::Hits((0..8000).map(answer).collect()));
    assert_eq!(ids(&grade.diagnosis.mistakes), ["b-for-half-b"]);
    assert_eq!(grade.diagnosis.of_every, 2);
    assert!(grade.advice().ends_with("One of 2 answers was looked at."), "{}", grade.advice());
}

/// A point that is printed with `%.4g` is right if each of its coordinates is right to the digits that
/// it has.
#[test]
fn a_point_is_right_where_each_coordinate_is() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    let four = |x: f64| format!("{x:.3e}").parse::<f64>().unwrap();
    let hits = student.hits().into_iter().map(|answer| {
        let hit = answer.hit.map(|hit| GivenHit {
            t: hit.t.map(|t| Written::exactly(four(t.value))),
            point: hit.point.map(|p| Written::exactly(DVec3::from(p.value.to_array().map(four)))),
            ..hit
        });
        HitAnswer { hit, ..answer }
    });
    let grade = graded(&exercise, &Answers::Hits(hits.collect()));
    assert_eq!(grade.right_digits, Some(4), "{}", grade.advice());
}

/// The answers of a program that tests only planes are hits of the wall behind each ball. The diagnosis
/// of such answers is called a guess.
#[test]
fn what_lies_behind_alone_is_a_guess() {
    let exercise = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [1.0; 3],
        spheres: vec![([0.0, 0.0, -5.0], 1.0)],
        planes: vec![([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])],
        ..general()
    };
    let without = Exercise { spheres: vec![], ..exercise.clone() };
    let student = Student { exercise: &without, mistakes: &[] };
    let answers = only_t(student.hits(), Written::exactly);
    let grade = graded(&exercise, &answers);
    assert!(!grade.diagnosis.mistakes.is_empty());
    let image = camera_of(&exercise).image;
    let advice = Graded { answers, grade, image, count_from: 0 }.advice();
    let guess = "This is a guess: every wrong answer is what lies behind";
    assert!(advice.contains(guess), "{advice}");
}

/// Of three balls in a row, hits of the middle one come neither from the first nor from the last, in the
/// order of distance or of the list.
#[test]
fn the_middle_of_three_is_neither_first_nor_last() {
    let ball = |z: f64| ([0.0, 0.0, z], 1.0);
    let seen = |spheres: Vec<([f64; 3], f64)>| Exercise {
        eye: [0.0, 0.1, 0.2],
        at: [0.0, 0.1, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [0.06, 0.06, 1.0],
        spheres,
        planes: vec![],
        ..general()
    };
    let all = seen(vec![ball(-14.0), ball(-9.0), ball(-4.0)]);
    let hits = |exercise: &Exercise| {
        let student = Student { exercise, mistakes: &[] };
        only_t(student.hits(), Written::exactly)
    };
    assert_right(&all, &hits(&all));
    assert_eq!(found(&all, &hits(&seen(vec![ball(-9.0)]))), [[""; 0]]);
    let last = found(&all, &hits(&seen(vec![ball(-14.0)])));
    assert!(last.contains(&vec!["last-object"]), "{last:?}");
    // Behind the eye, too, only the nearest and the farthest are what a program without t > 0 takes.
    let behind = seen(vec![ball(14.0), ball(9.0), ball(4.0)]);
    let taken = [(4.0, vec!["negative-t"]), (9.0, vec![]), (14.0, vec!["negative-t"])];
    for (z, mistakes) in taken {
        let exercise = seen(vec![ball(z)]);
        let student = Student { exercise: &exercise, mistakes: &["negative-t"] };
        let answers = only_t(student.hits(), Written::exactly);
        assert_eq!(found(&behind, &answers), [mistakes], "{z}");
    }
}
