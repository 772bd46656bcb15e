//! Tests of grading whole pictures, with and without mistakes.

use super::*;

pub(super) const COLORS: [Rgb; 4] = [[230, 159, 0], [86, 180, 233], [0, 158, 115], [204, 121, 167]];

/// Returns the student's picture.
pub(super) fn painted(student: &Student, shade: Shade) -> Answers {
    let [columns, rows] = student.exercise.image;
    let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let ts = pixels.clone().filter_map(|(row, column)| Some(student.hit(row, column)?.0));
    let nearest = ts.fold(f64::INFINITY, f64::min);
    let linear = |byte: u8| {
        let s = f64::from(byte) / 255.0;
        if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
    };
    let byte = |x: f64| {
        let s = if x <= 0.0031308 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
        // Cut off, as `(int)` does.
        (255.0 * s) as u8
    };
    let color = |row: u32, column: u32| {
        let Some((t, point, object)) = student.hit(row, column) else { return BACKGROUND };
        let own = COLORS[object as usize];
        let point = DVec3::from(point);
        let normal = match student.exercise.spheres.get(object as usize) {
            Some((center, _)) => point - DVec3::from(*center),
            None => DVec3::from(student.exercise.planes[0].1),
        };
        let d = DVec3::from(student.ray(row, column).1);
        match shade {
            Shade::Object => return own,
            Shade::T => return [(255.0 * nearest / t) as u8; 3],
            Shade::Normal => {
                return normal.normalize().to_array().map(|x| (127.5 * (x + 1.0)) as u8);
            }
            Shade::Lambert => {}
        }
        let light = 0.15 + 0.85 * (normal.dot(d) / normal.length() / d.length()).abs();
        own.map(|channel| byte(light * linear(channel)))
    };
    Answers::Picture(pixels.map(|(row, column)| color(row, column)).collect())
}

pub(super) fn graded(exercise: &Exercise, answers: &Answers) -> Grade {
    let (camera, scene) = (camera_of(exercise), scene_of(exercise));
    let truth =
        Truth { camera: &camera, scene: &scene, color_of: &|object| COLORS[object as usize] };
    grade(&truth, answers, None).unwrap()
}

#[test]
fn the_right_picture_is_right_in_its_shading() {
    let exercise = general();
    let student = Student { exercise: &exercise, mistakes: &[] };
    for shade in Shade::ALL {
        let grade = graded(&exercise, &painted(&student, shade));
        assert!(grade.all_agree(), "{} of {}", grade.agree(), grade.answers());
        assert_eq!(grade.shade, Some(shade));
    }
}

#[test]
fn mistakes_that_show_in_a_picture_are_found() {
    let exercise = general();
    for (id, ways) in MISTAKES {
        // A colour is the same along the whole ray, and the same where the ray enters a sphere and
        // where it leaves, so neither mistake shows.
        if ["far-root", "t-for-distance"].contains(&id) {
            let student = Student { exercise: &exercise, mistakes: &[id] };
            assert!(graded(&exercise, &painted(&student, Shade::Lambert)).all_agree(), "{id}");
            continue;
        }
        let student = Student { exercise: &exercise, mistakes: &ways[..1] };
        for shade in Shade::ALL {
            if (id, shade) == ("negative-t", Shade::T) {
                // Its t of the nearest hit is below 0, which is no shade of grey.
                continue;
            }
            let grade = graded(&exercise, &painted(&student, shade));
            let Diagnosis { mistakes, alternatives, .. } = grade.diagnosis;
            let sets = [vec![ids(&mistakes)], alternatives.iter().map(|a| ids(a)).collect()];
            assert!(sets.concat().contains(&vec![id]), "{id}, {shade:?}: {sets:?}");
        }
    }
}

#[test]
fn slips_that_show_in_a_picture_are_found() {
    let exercise = telling();
    for (id, ways) in ALONE {
        for way in ways {
            let student = Student { exercise: &exercise, mistakes: &[*way] };
            let Diagnosis { mistakes, alternatives, .. } =
                graded(&exercise, &painted(&student, Shade::Lambert)).diagnosis;
            assert!(
                [vec![mistakes], alternatives].concat().iter().any(|set| ids(set) == [id]),
                "{way}"
            );
        }
    }
}

/// If a picture shows none of the spheres, the diagnosis is called a guess, because there can be many
/// reasons.
#[test]
fn a_picture_of_nothing_is_a_guess() {
    let exercise =
        Exercise { spheres: general().spheres[..2].to_vec(), planes: vec![], ..general() };
    let student = Student { exercise: &exercise, mistakes: &["sign-of-b"] };
    let answers = painted(&student, Shade::Lambert);
    let grade = graded(&exercise, &answers);
    assert!(grade.diagnosis.alternatives.contains(&vec![Mistake::SignOfB]));
    let image = camera_of(&exercise).image;
    let advice = Graded { answers, grade, image, count_from: 0 }.advice();
    assert!(advice.contains("This is a guess: all wrong answers are misses"), "{advice}");
}

#[test]
fn another_picture_is_explained_by_nothing() {
    let exercise = general();
    let noise = (0..600_u32).map(|k| (k.wrapping_mul(2_654_435_761) >> 8).to_le_bytes());
    let noise = Answers::Picture(noise.map(|[r, g, b, _]| [r, g, b]).collect());
    let grade = graded(&exercise, &noise);
    assert!(!grade.all_agree());
    assert_eq!(grade.diagnosis, Diagnosis::default());
    assert_eq!(grade.advice(), "No known mistake explains this.");
}
