//! Tests of the counts of work that a frame left out.

use pinhole_core::{
    Camera, Counts, DVec3, Frame, ImageSize, NO_OBJECT, Outputs, Raster, ResolvedCamera, Scene,
    Sphere, trace_as,
};
use rayon::prelude::*;

fn camera(side: u32) -> ResolvedCamera {
    Camera { image: ImageSize::new(side, side).unwrap(), ..Camera::CANONICAL }.resolve().unwrap()
}

/// Returns spheres at random places all around the eye, the same in every run.
fn around(count: u32, radius: f64) -> Scene {
    let mut state = 1_u64;
    let mut number = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 24)
    };
    let spheres = (0..count).map(|_| {
        let [x, y, z] = [0; 3].map(|_| 20.0 * number() - 10.0);
        Sphere { center: DVec3::new(x, y, z), radius: radius * (0.2 + number()) }
    });
    Scene::new(spheres.collect(), vec![]).unwrap()
}

fn frame(scene: &Scene, side: u32) -> Frame<f32> {
    let camera = camera(side);
    trace_as(scene, &camera, &Raster::full(camera.image()), Outputs::default())
}

/// No sphere that is visible counts as left out, but most spheres do, since they lie beside the picture
/// or behind the eye.
#[test]
fn the_spheres_that_are_shown_are_not_left_out() {
    for (count, radius) in
        [(1, 1.0), (255, 0.5), (256, 0.5), (256, 1e-4), (3000, 0.02), (3000, 2.0), (50_000, 0.3)]
    {
        let frame = frame(&around(count, radius), 200);
        let Counts { spheres, spheres_left_out, .. } = frame.counts;
        assert_eq!(spheres, u64::from(count));
        let shown: std::collections::BTreeSet<u32> =
            frame.object.iter().copied().filter(|object| *object != NO_OBJECT).collect();
        assert!(spheres_left_out + shown.len() as u64 <= spheres, "{count} of radius {radius}");
        assert!(count < 255 || 2 * spheres_left_out > spheres, "{count} of radius {radius}");
    }
}

#[test]
fn rows_that_nothing_reaches_show_nothing() {
    let tangent = Sphere { center: DVec3::new(0.0, -1.0, -5.0), radius: 1.0 };
    for scene in [Scene::new(vec![tangent], vec![]).unwrap(), around(300, 0.1), around(40, 0.4)] {
        let frame = frame(&scene, 101);
        let rows = frame.object.chunks(101);
        let empty = rows.filter(|row| row.iter().all(|object| *object == NO_OBJECT)).count();
        assert!(frame.counts.rows_untouched <= empty as u64, "{:?} {empty}", frame.counts);
        assert_eq!(frame.counts.rows, 101);
    }
}

/// A scene's spatial index is built when it is first needed, which may be by several frames at once.
#[test]
fn many_frames_of_a_new_scene_at_once() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(8).build().unwrap();
    for _ in 0..4 {
        let scene = around(20_000, 0.1);
        let hits: Vec<usize> = pool.install(|| {
            let frames = (0..24).into_par_iter().map(|_| frame(&scene, 40));
            frames.map(|frame| frame.object.iter().filter(|o| **o != NO_OBJECT).count()).collect()
        });
        assert!(hits.iter().all(|count| *count == hits[0] && *count > 0));
    }
}

/// Thousands of copies of one sphere need no decision beyond `f64`, although all have the same t.
#[test]
fn copies_are_no_doubt() {
    let ball = Sphere { center: DVec3::new(0.0, 0.0, -5.0), radius: 1.5 };
    for count in [2, 200, 3000] {
        let frame = frame(&Scene::new(vec![ball; count], vec![]).unwrap(), 64);
        assert!(frame.object.iter().all(|object| *object == 0 || *object == NO_OBJECT));
        assert!(frame.object.contains(&0));
        assert_eq!(frame.steps.beyond_f64(), 0);
    }
}
