//! The scenes are what they say, every time.

use std::collections::HashSet;

use pinhole_core::*;

use super::bench::scenes::{self, covered};
use super::bench::{Setting, adversarial};

fn made(name: &str) -> Setting {
    (adversarial::all().into_iter().find(|listed| listed.name == name).unwrap().make)()
}

#[test]
fn as_much_is_covered_as_was_promised() {
    for (count, coverage) in [(1, 0.6), (3, 0.6), (10, 0.3), (1000, 0.6), (300_000, 0.6)] {
        let setting = scenes::spheres_at(count, coverage, 1.0);
        assert_eq!(setting.scene.len(), count);
        let found = covered(&setting);
        assert!((found - coverage).abs() < 0.03, "{count} spheres cover {found}");
    }
    for name in ["six-decades", "in-cloud", "in-cloud-1e3", "dense-1e4", "clustered-1e3"] {
        let found = covered(&made(name));
        assert!((found - scenes::COVERAGE).abs() < 0.03, "{name} covers {found}");
    }
}

#[test]
fn a_factor_is_on_the_radius() {
    let radius = |factor| scenes::spheres_at(100, 0.6, factor).scene.spheres()[7].radius;
    assert_eq!(radius(10.0), 10.0 * radius(1.0));
}

#[test]
fn the_same_scene_every_time_and_another_camera_every_frame() {
    let (a, b) = (scenes::spheres_at(50, 0.6, 1.0), scenes::spheres_at(50, 0.6, 1.0));
    assert_eq!(a.scene, b.scene);
    assert_eq!(made("planet").scene, made("planet").scene);
    let eyes: Vec<DVec3> = (0..100).map(|frame| a.camera(frame).eye()).collect();
    assert_eq!(eyes[3], b.camera(3).eye());
    for (frame, eye) in eyes.iter().enumerate() {
        assert!(!eyes[..frame].contains(eye), "frame {frame}");
        assert!(eye.distance(eyes[0]) < 0.01);
    }
}

#[test]
fn adversarial_scenes_are_what_their_names_say() {
    let hidden = made("behind-one");
    let camera = hidden.camera(0);
    let frame = trace(&hidden.scene, &camera, &Raster::full(camera.image()), Outputs::default());
    assert!(frame.object.iter().all(|object| *object == 100_000));

    let [sub_pixel, inside] = ["sub-pixel", "in-sphere"].map(|name| covered(&made(name)));
    assert!((0.001..0.05).contains(&sub_pixel), "{sub_pixel}");
    assert_eq!(inside, 1.0);

    let dot = made("one-pixel");
    let ray = dot.camera(0).ray_of_pixel(Pixel { row: 611, column: 877 });
    let met = |sphere: &Sphere| sphere.roots(&ray) != Roots::None;
    assert!(dot.scene.spheres().iter().all(met));

    for sphere in made("eye-plane").scene.spheres() {
        assert!(sphere.center.z.abs() < sphere.radius);
        assert!(sphere.center.length() > sphere.radius, "the eye is in none");
    }
    let eye_plane = covered(&made("eye-plane"));
    assert!(eye_plane > 0.2, "{eye_plane}");
    let planet = covered(&made("planet"));
    assert!((0.45..0.6).contains(&planet), "{planet}");
    let thin = ["one-column", "one-row"].map(|name| made(name).image());
    assert_eq!(thin.map(|image| (image.width(), image.height())), [(1, 16384), (16384, 1)]);
}

#[test]
fn the_list_has_every_name_once() {
    let names: Vec<&str> = scenes::all().iter().map(|listed| listed.name).collect();
    assert_eq!(names.iter().collect::<HashSet<_>>().len(), names.len());
    for name in scenes::STATED {
        assert!(names.contains(&name), "{name}");
    }
    for group in ["growth", "adversarial", "sizes"] {
        assert!(scenes::all().iter().any(|listed| listed.group == group), "{group}");
    }
}
