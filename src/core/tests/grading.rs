//! Answers of a student's own programs, right ones and wrong ones.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "grading/student.rs"]
mod student;

use pinhole_core::grading::*;
use pinhole_core::*;
use student::{Exercise, Student};

/// As general as a scene gets: every mistake shows in it. Ball 2 is behind the eye; the back wall
/// is behind everything.
fn general() -> Exercise {
    Exercise {
        eye: [1.0, 2.0, 3.0],
        at: [-2.0, 0.5, -4.0],
        up: [0.5, 2.0, 0.25],
        viewport: [1.5, 1.0, 2.0],
        image: [30, 20],
        spheres: vec![
            ([-1.0, 1.0, -2.0], 0.7),
            ([-3.5, 0.6, -4.5], 1.2),
            ([2.5, 3.0, 6.5], 1.5),
        ],
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

fn ids(mistakes: &[KnownMistake]) -> Vec<&'static str> {
    mistakes.iter().map(|mistake| mistake.id()).collect()
}

#[test]
fn look() {
    let exercise = general();
    let all = ["w-as-printed","v-is-u-cross-w","not-normalized","up-as-v","distance-dropped","pixel-corner","rows-from-bottom","rows-columns-swapped","counted-from-one","aspect-dropped","left-handed","b-for-half-b","far-root","negative-t","t-for-distance"];
    let more = ["not-normalized/w","not-normalized/all","not-normalized/a","left-handed/u","distance-dropped/left-out","b-for-half-b/halved","t-for-distance/point"];
    let mut sets: Vec<Vec<&str>> = vec![vec![]];
    sets.extend(all.iter().chain(&more).map(|m| vec![*m]));
    for (i, a) in all.iter().enumerate() { for b in &all[i+1..] { sets.push(vec![*a, *b]); } }
    for set in sets {
        let student = Student { exercise: &exercise, mistakes: &set };
        let mut want: Vec<&str> = set.iter().map(|m| m.split('/').next().unwrap()).collect();
        want.sort();
        for (kind, answers) in [
            ("basis", Answers::Basis(student.basis().map(|v| Written::exactly(DVec3::from(v))))),
            ("rays", Answers::Rays(student.rays())), ("hits", Answers::Hits(student.hits()))] {
            let g = graded(&exercise, &answers);
            let mut got = ids(&g.diagnosis.mistakes); got.sort();
            if got != want && !(kind == "basis" && got.len() < want.len()) && !(kind=="rays" && got.len() < want.len() && want.iter().any(|w| ["b-for-half-b","far-root","negative-t","t-for-distance"].contains(w))) {
                println!("{kind} {set:?}: {got:?} alt {:?} agree {}/{}", g.diagnosis.alternatives.iter().map(|a| ids(a)).collect::<Vec<_>>(), g.agree(), g.answers());
            }
        }
    }
}
