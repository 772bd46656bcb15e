//! Tests that whole frames are bit for bit the same on every SIMD level.

use pinhole_core::*;

use crate::common::levels::levels;
use crate::common::{Numbers, camera, frames, given, plane, sphere, vec3};

/// A scene with its name and its camera, and the minimum number of objects that its picture shows.
struct Shown {
    name: &'static str,
    scene: Scene,
    camera: ResolvedCamera,
    objects: usize,
}

fn shown(
    name: &'static str,
    spheres: Vec<Sphere>,
    planes: Vec<Plane>,
    eye: DVec3,
    view: DVec3,
    objects: usize,
) -> Shown {
    // Neither side of the image is a multiple of a SIMD vector's length, and there are more rows than
    // one thread draws at a time.
    let camera = camera(eye, view, DVec3::Y, 203, 117).resolve().unwrap();
    Shown { name, scene: Scene::new(spheres, planes).unwrap(), camera, objects }
}

fn many_spheres() -> Vec<Sphere> {
    let mut numbers = Numbers(11);
    (0..300)
        .map(|_| Sphere {
            center: vec3(0.0, 0.0, -12.0) + numbers.point(5.0),
            radius: numbers.between(0.01, 1.0),
        })
        .collect()
}

fn scenes() -> Vec<Shown> {
    let ball = sphere([0.0, 0.0, -5.0], 1.0);
    let (ahead, tilted) = (DVec3::NEG_Z, vec3(0.3, -0.2, -1.0));
    let (floor, wall) = ([0.0, -1.0, 0.0], [0.0, 0.0, -6.0]);
    let up = [0.0, 1.0, 0.0];
    vec![
        shown("the lecture's ball", vec![ball], vec![], DVec3::ZERO, ahead, 1),
        shown("a large ball", vec![sphere([0.3, 0.2, -2.0], 1.7)], vec![], DVec3::ZERO, tilted, 1),
        shown("from inside", vec![sphere([0.1, 0.2, 0.3], 4.0)], vec![], DVec3::ZERO, tilted, 1),
        shown("on a sphere", vec![sphere([0.0, 0.0, -5.0], 5.0)], vec![], DVec3::ZERO, tilted, 1),
        shown(
            "the course's floor",
            vec![sphere([0.0, -5001.0, 0.0], 5000.0), ball],
            vec![],
            DVec3::ZERO,
            ahead,
            2,
        ),
        shown(
            "a planet under the eye",
            vec![sphere([0.0, -6_371_000.0, 0.0], 6_371_000.0)],
            vec![],
            vec3(0.0, 1e-3, 0.0),
            vec3(0.0, -0.01, -1.0),
            1,
        ),
        shown(
            "planes",
            vec![],
            vec![plane(floor, up), plane(wall, [0.1, 0.0, 1.0]), plane(floor, [0.0, -2.0, 0.0])],
            DVec3::ZERO,
            tilted,
            2,
        ),
        shown("ball and planes", vec![ball], vec![plane(floor, up)], DVec3::ZERO, ahead, 2),
        shown(
            "ties",
            vec![ball, ball, sphere([0.0, 0.0, -4.5], 0.5), sphere([0.0, 0.0, -6.0], 2.0)],
            vec![plane([0.0, 0.0, -4.0], [0.0, 0.0, 1.0])],
            DVec3::ZERO,
            ahead,
            2,
        ),
        shown(
            "tiny and far",
            vec![sphere([0.0, 0.0, -1e6], 1e4), sphere([1e9, 2e8, -1e9], 1e7)],
            vec![],
            DVec3::ZERO,
            tilted,
            1,
        ),
        shown(
            "far from the world's origin",
            vec![sphere([1e12, 1e12 + 1.0, -1e12 - 5.0], 1.25)],
            vec![plane([1e12, 1e12 - 1.0, -1e12], up)],
            vec3(1e12, 1e12, -1e12),
            tilted,
            2,
        ),
        shown("many", many_spheres(), vec![plane([0.0, -4.0, 0.0], up)], DVec3::ZERO, ahead, 50),
        shown(
            "a small world",
            vec![sphere([0.0, 0.0, -5e-20], 1e-20), sphere([1e-20, 0.0, -6e-20], 2e-20)],
            vec![],
            DVec3::ZERO,
            ahead,
            2,
        ),
    ]
}

/// Traces on every SIMD level, asserts that the frames are the same, and returns the number of objects
/// that are visible.
fn assert_same<T: Depth>(
    name: &str,
    levels: &[(&str, Level)],
    scene: &Scene,
    camera: &ResolvedCamera,
) -> usize {
    let raster = Raster::full(camera.image());
    let frame =
        |level| trace_at_level::<T>(level, scene, camera, &raster, Outputs::default(), |_| ());
    let first = frame(levels[0].1);
    let bits = |t: &T| t.widened().to_bits();
    for (level_name, level) in &levels[1..] {
        let other = frame(*level);
        assert_eq!(first.object, other.object, "{name} on {level_name}");
        let differing = first.t.iter().zip(&other.t).position(|(a, b)| bits(a) != bits(b));
        assert_eq!(differing, None, "{name} on {level_name}");
        assert_eq!(first.steps, other.steps, "{name} on {level_name}");
    }
    let seen: std::collections::BTreeSet<u32> =
        first.object.iter().copied().filter(|object| *object != NO_OBJECT).collect();
    seen.len()
}

#[test]
fn scenes_are_the_same_bits_on_every_level() {
    let levels = levels();
    for Shown { name, scene, camera, objects } in scenes() {
        for seen in [
            assert_same::<f64>(name, &levels, &scene, &camera),
            assert_same::<f32>(name, &levels, &scene, &camera),
        ] {
            assert!(seen >= objects, "{name} shows {seen} objects");
        }
    }
}

#[test]
fn stress_frames_are_the_same_bits_on_every_level() {
    let levels = levels();
    let mut frames = 0;
    for family in &frames::FAMILIES {
        for knob in family.knobs {
            for case in family.cases(*knob, 5, 4) {
                if case.camera.rows.max(case.camera.columns) > ImageSize::MAX {
                    continue;
                }
                let (scene, camera) =
                    (given::scene(&case.objects), given::camera(&case.camera).resolve().unwrap());
                assert_same::<f64>(family.name, &levels, &scene, &camera);
                assert_same::<f32>(family.name, &levels, &scene, &camera);
                frames += 1;
            }
        }
    }
    assert!(frames > 100, "{frames}");
}
