//! Tests the exact pixels of the world view, and picking positions in it.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, DVec2, Outputs, Pixel, Raster, Scene, trace_as};

use super::*;

#[test]
fn the_picture_on_the_viewport_has_its_own_colours() {
    let camera = Camera { image: image(8, 8), ..Camera::CANONICAL };
    let mut stage = Stage::new(camera, vec![sphere(0.3, 0.2, -5.0, 1.5)], vec![]);
    stage.items = OverlayItems::NONE.with(Item::Picture, true);
    let mut dots = stage.dots();
    assert_eq!(stage.painted(&stage.view(), &mut dots).labels, []);
    let picture = stage.picture.as_ref().expect("a picture");
    let mut colors = std::collections::HashSet::new();
    for pixel in (0..8).flat_map(|row| (0..8).map(move |column| Pixel { row, column })) {
        let center = stage.resolve().viewport_point(stage.resolve().uv_of_pixel(pixel));
        let at = stage.to_screen(center);
        let dot = dots[at.y as usize * SIZE.0 as usize + at.x as usize];
        let traced = picture.raster.nearest_to(pixel).map(|to_screen| picture.pixels[to_screen]);
        assert_eq!(Some(dot), traced, "{pixel:?}");
        colors.insert(dot);
    }
    assert!(colors.len() > 5);
}

#[test]
fn with_nothing_on_only_the_background_changes() {
    let mut stage = canonical();
    stage.items = OverlayItems::NONE;
    let before = stage.dots();
    let mut after = before.clone();
    assert_eq!(stage.painted(&stage.view(), &mut after).labels, []);
    let sphere = opaque(color_of(0));
    let background = Style::Light.colors().background;
    let seen = traced_scene(&stage.scene, &[]);
    let edges = edge_blends(&stage.frame, &seen);
    for (pixel, (before, after)) in before.iter().zip(&after).enumerate() {
        if edges.iter().all(|edge| edge.pixel as usize != pixel) {
            assert_eq!(*after, if *before == sphere { sphere } else { background });
        }
    }
    assert!(after.contains(&sphere) && after.contains(&background));
}

#[test]
fn a_border_that_the_picture_hides_does_not_show_through() {
    let camera = Camera { image: image(64, 64), ..Camera::CANONICAL };
    let scene = Scene::new(vec![sphere(0.0, 0.0, -5.0, 0.7)], vec![]).expect("a scene");
    let mut stage = Stage::seen_by(camera, scene, Observer::new(DVec3::ZERO, 0.0, 0.0, 4.0));
    let (raster, colors) = (Raster::full(camera.image), [Color32::WHITE, Color32::BLACK]);
    let pixels = (0..64 * 64).map(|k| colors[(k + k / 64) % 2]).collect();
    stage.picture = Some(Arc::new(Picture { raster, image: camera.image, pixels }));
    let mixed = |stage: &Stage| {
        let mut dots = stage.dots();
        stage.painted(&stage.view(), &mut dots);
        let inside = |k: &usize| {
            let at = [(k % SIZE.0 as usize) as f32 + 0.5, (k / SIZE.0 as usize) as f32 + 0.5];
            pick(stage.resolve(), &stage.frame, at).is_some()
        };
        let plain = [colors[0], colors[1], Style::Light.colors().background, opaque(color_of(0))];
        let inside = (0..dots.len()).filter(inside);
        inside.filter(|k| !plain.contains(&dots[*k])).count()
    };
    stage.items = OverlayItems::NONE.with(Item::Picture, true);
    assert_eq!(mixed(&stage), 0);
    stage.items = OverlayItems::NONE;
    assert!(mixed(&stage) > 50, "without the picture, the ball's border is seen");
}

#[test]
fn a_frame_of_another_size_is_no_panic() {
    let stage = canonical();
    let mut dots = vec![Color32::BLACK; 100];
    stage.painted(&stage.view(), &mut dots);
    let image = stage.frame.camera().image();
    let part = Raster::shown_on(image, 7, 5);
    let frame = trace_as(&stage.scene, stage.frame.camera(), &part, Outputs::default());
    let mut dots = stage.dots();
    stage.painted(&WorldView { frame: Same(Arc::new(frame)), ..stage.view() }, &mut dots);
}

#[test]
fn picking_is_the_inverse_of_seeing() {
    let stage = canonical();
    let mut found = 0;
    for (i, j) in (0..20).flat_map(|i| (0..20).map(move |j| (i, j))) {
        let uv = DVec2::new(f64::from(i) - 9.5, f64::from(j) - 9.5) / 20.0;
        let at = stage.to_screen(stage.resolve().viewport_point(uv));
        let picked = pick(stage.resolve(), &stage.frame, [at.x as f32, at.y as f32]);
        // Positions are `f32`, with an error of about 1e-5 screen pixels; a screen pixel is about 0.02 wide
        // on the viewport.
        assert!(picked.is_some_and(|picked| picked.distance(uv) < 1e-5), "{uv}: {picked:?}");
        found += 1;
    }
    assert_eq!(found, 400);
    let beside = stage.to_screen(stage.resolve().viewport_point(DVec2::new(0.6, 0.0)));
    assert_eq!(pick(stage.resolve(), &stage.frame, [beside.x as f32, beside.y as f32]), None);
}

#[test]
fn what_a_sphere_hides_cannot_be_picked() {
    let observer = Observer::new(DVec3::ZERO, 0.0, 0.0, 10.0);
    let scene = Scene::new(vec![sphere(0.0, 0.0, 2.0, 0.3)], vec![]).expect("a scene");
    let stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    let pick_at = |uv: DVec2| {
        let at = stage.to_screen(stage.resolve().viewport_point(uv));
        pick(stage.resolve(), &stage.frame, [at.x as f32, at.y as f32])
    };
    assert_eq!(pick_at(DVec2::ZERO), None);
    assert!(pick_at(DVec2::new(0.45, 0.45)).is_some());
}

#[test]
fn seen_from_behind_the_picture_is_mirrored() {
    let camera = Camera { image: image(2, 1), ..Camera::CANONICAL };
    let scene = Scene::default();
    let mut stage = Stage::seen_by(camera, scene, Observer::new(DVec3::ZERO, 0.0, 0.0, 4.0));
    let (left, right) = (Color32::from_rgb(9, 8, 7), Color32::from_rgb(1, 2, 3));
    let raster = Raster::full(camera.image);
    stage.picture =
        Some(Arc::new(Picture { raster, image: camera.image, pixels: vec![left, right] }));
    stage.items = OverlayItems::NONE.with(Item::Picture, true);
    let seen = |stage: &Stage| {
        let mut dots = stage.dots();
        stage.painted(&stage.view(), &mut dots);
        let row = &dots[SIZE.0 as usize * (SIZE.1 as usize / 2)..][..SIZE.0 as usize];
        let at = |color: Color32| row.iter().position(|dot| *dot == color);
        (at(left).expect("a left pixel"), at(right).expect("a right pixel"))
    };
    let (l, r) = seen(&stage);
    assert!(l < r);
    let opposite = Observer::new(DVec3::ZERO, std::f64::consts::PI, 0.0, 4.0);
    let Stage { picture, items, camera, scene, .. } = stage;
    let stage = Stage { picture, items, ..Stage::seen_by(camera, scene, opposite) };
    let (l, r) = seen(&stage);
    assert!(l > r);
}

#[test]
fn a_sphere_around_the_camera_is_painted_cut_away() {
    let around = sphere(0.0, 0.0, -1.0, 4.0);
    let scene = Scene::new(vec![around], vec![]).expect("a scene");
    let observer = from_the_right(around.center, 16.0);
    let stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    assert_eq!(*stage.enclosing, [0]);
    let mut dots = stage.dots();
    let background = Style::Light.colors().background;
    stage.painted(&stage.view(), &mut dots);
    let at = |y: f64| {
        let spot = stage.to_screen(DVec3::new(0.0, y, -2.3));
        dots[spot.y as usize * SIZE.0 as usize + spot.x as usize]
    };
    let [r, g, b] = color_of(0).map(i32::from);
    let nearness = |dot: Color32| {
        (i32::from(dot.r()) - r).abs()
            + (i32::from(dot.g()) - g).abs()
            + (i32::from(dot.b()) - b).abs()
    };
    assert!(nearness(at(2.9)) < nearness(background) - 60, "{:?}", at(2.9));
    assert_eq!(at(5.0), background, "beside it");
    // No part of the sphere hides the camera.
    assert!(!stage.drawing().marks.iter().any(|mark| mark.item == Item::Eye && mark.hidden));
}

#[test]
fn of_a_thousand_spheres_around_the_camera_the_largest_are_drawn() {
    let radius = |k: u32| 4.0 + f64::from(k * 7 % 1000) / 1000.0;
    let spheres = (0..1000).map(|k| sphere(0.0, 0.0, -1.0, radius(k))).collect();
    let scene = Scene::new(spheres, vec![]).expect("a scene");
    let observer = from_the_right(DVec3::new(0.0, 0.0, -1.0), 16.0);
    let stage = Stage::seen_by(Camera::CANONICAL, scene, observer);
    assert_eq!(stage.enclosing.len(), 1000);
    let bowls = stage.view().backdrop(stage.scene()).bowls;
    assert!((1..10).contains(&bowls.len()), "{}", bowls.len());
    assert!(bowls.iter().all(|bowl| bowl.sphere.radius > 4.99), "{:?}", bowls[0].sphere);
    // They lie over one another in the order of the objects, as fewer do.
    let colors: Vec<_> = bowls.iter().map(|bowl| bowl.color).collect();
    let mut largest: Vec<u32> = (0..1000).filter(|k| radius(*k) > 4.9935).collect();
    largest.sort_unstable();
    assert_eq!(colors, largest.into_iter().map(color_of).collect::<Vec<_>>());
}
