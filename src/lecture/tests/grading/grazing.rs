//! Answers where a ray grazes a sphere.

use super::*;

#[test]
fn where_a_hair_decides_neither_side_is_wrong() {
    // The rays of row 0 touch the lecture's sphere exactly: D is 0 up to rounding.
    let exercise = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [2.0, 2.0, 1.0],
        image: [1, 1],
        spheres: vec![([1.0, 0.0, -7.0], 1.0), ([0.0, 0.0, -9.0], 1.0)],
        planes: vec![],
    };
    let pixel = Pixel { row: 0, column: 0 };
    let say = |hit: Option<(f64, u32)>| {
        let hit = hit.map(|(t, object)| GivenHit {
            t: Some(Written::exactly(t)),
            point: None,
            object: Some(object),
        });
        graded(&exercise, &Answers::Hits(vec![HitAnswer { pixel, hit }])).all_agree()
    };
    for t in [7.0, 7.0 * (1.0 + 1e-7), 7.0 * (1.0 - 1e-7)] {
        assert!(say(Some((t, 0))), "the sphere that is touched, as t = {t}");
    }
    assert!(!say(Some((7.001, 0))), "what is behind where it is touched");
    assert!(say(Some((8.0, 1))), "what is behind it");
    assert!(!say(None), "that there is nothing at all");
    assert!(!say(Some((10.0, 1))), "the far side of what is behind it");
    assert!(!say(Some((8.0, 0))));
}

#[test]
fn single_precision_is_enough_at_every_pixel_of_an_ordinary_scene() {
    // Some of these rays graze a sphere so closely that D is 0 in `f32`, or has the opposite sign.
    let distance_two = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [1.0, 1.0, 2.0],
        image: [400, 400],
        spheres: vec![([-0.5, 0.4, -5.0], 0.6), ([0.5, 0.6, -4.5], 0.25)],
        planes: vec![([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])],
    };
    let moved_eye = Exercise {
        eye: [0.5, 0.4, 1.0],
        at: [0.5, 0.4, 0.0],
        viewport: [1.0; 3],
        spheres: vec![([0.0, 0.0, -5.0], 1.0), ([-1.2, 0.9, -4.0], 0.5)],
        ..distance_two.clone()
    };
    for exercise in [distance_two, moved_eye] {
        let student = single::Student { exercise: &exercise, mistakes: &[] };
        assert_right(&exercise, &Answers::Rays(student.rays()));
        assert_right(&exercise, &Answers::Hits(student.hits()));
    }
}

#[test]
fn one_of_many_answers_that_cannot_be_judged_is_found_wherever_it_is() {
    let ball = |radius| ([0.0, 0.0, -5.0], radius);
    let exercise = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [4.0, 4.0, 1.0],
        image: [301, 201],
        spheres: vec![ball(1.0), ball(1.0 + 1e-10)],
        planes: vec![],
    };
    let middle = Pixel { row: 100, column: 150 };
    let hits = Student { exercise: &exercise, mistakes: &[] }.hits().into_iter();
    let (middle, answers): (Vec<_>, Vec<_>) = hits
        .filter(|answer| answer.hit.is_none() || answer.pixel == middle)
        .partition(|answer| answer.hit.is_some());
    assert!(middle.len() == 1 && answers.len() > 40_000);
    for index in [0, 1, 2, 40_001, answers.len()] {
        let mut answers = answers.clone();
        answers.insert(index, middle[0]);
        let grade = graded(&exercise, &Answers::Hits(answers));
        assert_eq!((grade.wrong(), &grade.not_judged), (0, &vec![index]));
        assert_ne!(grade.worst.unwrap().index, index);
    }
}

/// Without the square root, rounding outgrows t on a large sphere, so that any t would fit.
#[test]
fn a_mistake_that_any_answer_would_fit_is_not_named() {
    let planet = Exercise {
        eye: [0.0; 3],
        at: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        viewport: [1.0; 3],
        image: [16, 16],
        spheres: vec![([0.0, 0.0, -5e5], 1e5)],
        planes: vec![],
    };
    let answers = [(7, 7, 1.25e5), (7, 8, 8.5e5), (8, 7, 2.75e5), (8, 8, 7.0e5)];
    let hits = answers.map(|(row, column, t)| {
        let t = Some(Written::exactly(t));
        HitAnswer { pixel: Pixel { row, column }, hit: Some(GivenHit { t, ..GivenHit::default() }) }
    });
    assert_eq!(found(&planet, &Answers::Hits(hits.to_vec())), [Vec::<&str>::new()]);
}
