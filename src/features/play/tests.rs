//! Tests of phases and of the player.

#![allow(clippy::unwrap_used, reason = "a test that cannot read its input has failed")]

use pinhole_core::steering::SteerError;
use pinhole_core::{Camera, DVec2, DVec3, ImageSize, Orientation, Pixel, Scene, Selection, Sphere};

use super::player::Player;
use super::state::*;

fn start() -> Start {
    let camera = Camera { image: ImageSize::new(4, 3).unwrap(), ..Camera::CANONICAL };
    let selection = Selection::Uv(DVec2::new(0.2, -0.1));
    Start { camera, selection, ray_point_t: None, end: 6.0, orbit: None }
}

#[test]
fn up_swings_round_the_view() {
    let start = start();
    for (phase, up) in [(0.25, DVec3::NEG_X), (0.5, DVec3::NEG_Y), (0.75, DVec3::X)] {
        let Still { camera, ray_point_t, scanned_pixels, .. } =
            start.at(Kind::SwingUp, phase).unwrap();
        assert_eq!(camera.orientation, Orientation::At { at: DVec3::NEG_Z, up });
        assert_eq!((camera.eye, ray_point_t, scanned_pixels), (DVec3::ZERO, None, None));
    }
    for phase in [0.0, 1.0] {
        assert_eq!(start.at(Kind::SwingUp, phase).unwrap(), start.still());
    }
}

#[test]
fn the_eye_orbits_at() {
    let start = start();
    let positions = [(0.25, (1.0, -1.0)), (0.5, (0.0, -2.0)), (0.75, (-1.0, -1.0))];
    for (phase, (x, z)) in positions {
        let Still { camera, .. } = start.at(Kind::Orbit, phase).unwrap();
        assert!(camera.eye.distance(DVec3::new(x, 0.0, z)) < 1e-15, "{}", camera.eye);
        assert_eq!(camera.orientation, start.camera.orientation);
    }
    assert_eq!(start.at(Kind::Orbit, 1.0).unwrap(), start.still());
}

#[test]
fn the_view_goes_over_the_top_and_meets_up_without_rounding() {
    let start = start();
    for by_view in [false, true] {
        let (view, up) = (DVec3::new(0.0, -0.5, -1.0), DVec3::new(0.0, 2.0, 0.0));
        let orientation = match by_view {
            true => Orientation::View { view, up },
            false => Orientation::At { at: start.camera.eye + view, up },
        };
        let start = Start { camera: Camera { orientation, ..start.camera }, ..start };
        let at = |phase| start.at(Kind::OverTheTop, phase).unwrap().camera;
        for pole in [0.25, 0.75] {
            assert_eq!(at(pole).view().cross(up), DVec3::ZERO, "{pole}");
            let right = |phase: f64| at(phase).basis().unwrap().u;
            let flip = right(pole - 0.01).dot(right(pole + 0.01));
            assert!(flip < -0.999_999, "{flip}: u turns round");
        }
        for phase in (0..=100).map(|k| f64::from(k) / 100.0) {
            // When view is parallel to up, it is up times a factor of few digits.
            let off = if [0.25, 0.75].contains(&phase) { 2e-3 } else { 1e-12 };
            let length = at(phase).view().length();
            assert!((length / view.length() - 1.0).abs() < off, "{phase}: {length}");
        }
        assert_eq!(start.at(Kind::OverTheTop, 1.0).unwrap(), start.still());
    }
    let orientation = Orientation::Basis(start.camera.basis().unwrap());
    let by_hand = Start { camera: Camera { orientation, ..start.camera }, ..start };
    assert_eq!(by_hand.at(Kind::OverTheTop, 0.1), Err(SteerError::NoUp));
    let orientation = Orientation::At { at: DVec3::new(-1e308, 0.0, -1.0), up: DVec3::Y };
    let far = Start { camera: Camera { orientation, ..start.camera }, ..start };
    assert_eq!(far.at(Kind::OverTheTop, 0.1), Err(SteerError::OutOfRange));
    let poles = (0..240).filter(|k| Kind::OverTheTop.phase_of_frame(*k, 240) == 0.25);
    assert_eq!(poles.count(), 0, "every exported frame has a picture");
}

#[test]
fn t_runs_to_the_hit() {
    let ray_point_t = |phase| start().at(Kind::Walk, phase).unwrap().ray_point_t;
    assert_eq!([0.0, 0.25, 1.0].map(ray_point_t), [Some(0.0), Some(1.5), Some(6.0)]);
}

#[test]
fn pixels_are_scanned_row_by_row() {
    let at = |scanned_pixels: u64| {
        let still = start().at(Kind::Scan, scanned_pixels as f64 / 12.0).unwrap();
        assert_eq!(still.scanned_pixels, Some(scanned_pixels));
        still.selection
    };
    let pixel = |row, column| Selection::Pixel(Pixel { row, column });
    assert_eq!(
        [0, 1, 4, 5, 12].map(at),
        [(0, 0), (0, 0), (0, 3), (1, 0), (2, 3)].map(|(i, j)| pixel(i, j))
    );
}

#[test]
fn frames_of_a_turn_do_not_show_its_beginning_twice() {
    assert_eq!([0, 1, 3].map(|k| Kind::Orbit.phase_of_frame(k, 4)), [0.0, 0.25, 0.75]);
    assert_eq!([0, 1, 4].map(|k| Kind::Scan.phase_of_frame(k, 5)), [0.0, 0.25, 1.0]);
    assert_eq!(Kind::Scan.phase_of_frame(0, 1), 0.0);
}

#[test]
fn steps_go_to_whole_steps() {
    let mut player = Player::new(Kind::SwingUp, start());
    player.phase = 0.1;
    for (by, position) in [(1, "45°"), (1, "60°"), (-1, "45°"), (-4, "345°")] {
        player.step(by);
        assert_eq!(player.position(), position);
    }
    let mut player = Player::new(Kind::Scan, start());
    for (by, position) in [(1, "1 of 12 pixels"), (-3, "0 of 12 pixels"), (99, "12 of 12 pixels")] {
        player.step(by);
        assert_eq!(player.position(), position);
    }
}

#[test]
fn time_moves_what_runs() {
    let mut player = Player::new(Kind::Walk, start());
    for now in [0.0, 0.25] {
        player.go_on(now);
    }
    assert_eq!(player.phase, 0.0, "it rests");
    player.toggle();
    for now in [1.0, 1.25, 1.5] {
        player.go_on(now);
    }
    assert_eq!(player.phase, 0.5 / 6.0);
    player.speed = 2.0;
    player.go_on(1.75);
    assert_eq!(player.phase, 1.0 / 6.0);
    for k in 1..40 {
        player.go_on(1.75 + 0.25 * f64::from(k));
    }
    assert_eq!((player.phase, player.running), (1.0, false), "it does not loop");
    player.toggle();
    assert_eq!((player.phase, player.running), (0.0, true), "again from the start");
}

#[test]
fn reduced_motion_shows_whole_steps_alone() {
    let mut player = Player::new(Kind::SwingUp, start());
    player.reduced = true;
    player.toggle();
    player.go_on(0.0);
    player.go_on(0.4);
    assert_eq!(player.still(), player.start.still());
    player.go_on(0.6);
    assert_eq!(player.still(), player.start.at(Kind::SwingUp, 1.0 / 24.0).unwrap());
}

#[test]
fn what_cannot_move_says_why() {
    let mut player = Player::new(Kind::SwingUp, start());
    player.start.camera.orientation = Orientation::At { at: DVec3::NEG_Z, up: DVec3::Z };
    player.toggle();
    player.phase = 0.3;
    assert_eq!(player.still(), player.start.still());
    assert!(!player.running);
    assert!(player.fault.unwrap().to_string().contains("parallel"));
}

#[test]
fn a_camera_given_by_view_orbits_what_it_looks_at() {
    let ball = |x, z| Sphere { center: DVec3::new(x, 0.0, z), radius: 1.0 };
    let view = Orientation::View { view: 0.5 * DVec3::NEG_Z, up: DVec3::Y };
    let basis = Orientation::Basis(Camera::CANONICAL.resolve().unwrap().basis().to_owned());
    let scenes = [(vec![ball(0.0, -5.0), ball(3.0, -9.0)], 4.0), (vec![ball(0.0, -7.0)], 6.0)];
    for (spheres, away) in scenes {
        let scene = Scene::new(spheres, vec![]).unwrap();
        let pivot = DVec3::new(0.0, 0.0, -away);
        for orientation in [view, basis] {
            let camera = Camera { orientation, ..start().camera };
            let orbit = distance_ahead(&camera, &scene);
            let start = Start { camera, orbit, ..start() };
            for phase in [0.25, 0.5, 0.8] {
                let orbited = start.at(Kind::Orbit, phase).unwrap().camera;
                assert!((orbited.eye.distance(pivot) - away).abs() < 1e-12, "{}", orbited.eye);
                let ahead = orbited.eye - away * orbited.resolve().unwrap().basis().w;
                assert!(ahead.distance(pivot) < 1e-12, "{ahead}");
                assert!((orbited.view().length() - camera.view().length()).abs() < 1e-12);
                assert_eq!(orbited.viewport, camera.viewport);
            }
            assert_eq!(start.at(Kind::Orbit, 1.0).unwrap(), start.still());
        }
    }
    assert_eq!(distance_ahead(&start().camera, &Scene::default()), None);
}
