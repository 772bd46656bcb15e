//! The handles of the viewport and of spheres.

use pinhole_core::steering::*;
use pinhole_core::*;
use proptest::prelude::*;

use super::{calm_camera, vec3};
use crate::common::seed::config;

/// Turned and off the origin.
fn camera() -> Camera {
    Camera {
        eye: vec3(2.0, 1.0, 3.0),
        orientation: Orientation::At { at: vec3(0.0, 1.0, 3.0), up: DVec3::Y },
        viewport: Viewport { width: 4.0, height: 2.0, distance: 1.0 },
        image: ImageSize::new(300, 100).unwrap(),
    }
}

#[test]
fn a_corner_makes_width_and_height() {
    let corner = |keeps, corner: ViewportCorner, u: f64, v: f64| {
        let basis = camera().basis().unwrap();
        let point = camera().eye + u * basis.u + v * basis.v - basis.w;
        camera().with_viewport_corner(corner, point, keeps).map(|camera| camera.viewport)
    };
    let sized = |width, height| Ok(Viewport { width, height, distance: 1.0 });
    use CornerKeeps::{Nothing, Ratio};
    assert_eq!(corner(Nothing, ViewportCorner::TopRight, 1.0, 3.0), sized(2.0, 6.0));
    assert_eq!(corner(Nothing, ViewportCorner::BottomLeft, -1.5, -0.5), sized(3.0, 1.0));
    assert_eq!(corner(Ratio, ViewportCorner::TopLeft, -4.0, 2.0), sized(8.0, 4.0));
    // Across the diagonal: nothing changes.
    assert_eq!(corner(Ratio, ViewportCorner::BottomRight, 1.5, -2.0), sized(4.0, 2.0));
    let past = corner(Nothing, ViewportCorner::TopRight, -0.5, 1.0).unwrap_err();
    let expected = "viewport width is -1: it must be finite and greater than 0";
    assert_eq!(past.to_string(), expected);
    assert!(corner(Ratio, ViewportCorner::TopRight, -1.0, -1.0).is_err());
    let none = Camera { viewport: Viewport { width: 0.0, ..camera().viewport }, ..camera() };
    assert!(none.with_viewport_corner(ViewportCorner::TopLeft, DVec3::ZERO, Ratio).is_err());
}

#[test]
fn corners_are_where_they_are_drawn() {
    let resolved = camera().resolve().unwrap();
    for corner in ViewportCorner::ALL {
        let uv = corner.uv(resolved.viewport());
        assert_eq!(uv.abs(), DVec2::new(2.0, 1.0));
        let point = resolved.viewport_point(uv);
        let same = camera().with_viewport_corner(corner, point, CornerKeeps::Nothing).unwrap();
        assert_eq!(same, camera());
    }
}

#[test]
fn the_viewport_is_put_through_a_point() {
    let through = |x: f64, keeps| camera().with_viewport_through(vec3(x, 7.0, 8.0), keeps);
    let size = through(-1.0, DistanceKeeps::Size).unwrap().viewport;
    assert_eq!(size, Viewport { width: 4.0, height: 2.0, distance: 3.0 });
    let picture = through(-1.0, DistanceKeeps::Picture).unwrap().viewport;
    assert_eq!(picture, Viewport { width: 12.0, height: 6.0, distance: 3.0 });
    let nowhere = Viewport { distance: 0.0, ..size }.check().unwrap_err();
    assert_eq!((nowhere.field, nowhere.value), ("distance", 0.0));
    assert_eq!(through(2.0, DistanceKeeps::Size), Err(nowhere.into()));
    assert!(through(2.5, DistanceKeeps::Picture).is_err());
}

#[test]
fn a_sphere_is_put_through_a_point() {
    let ball = Sphere { center: DVec3::X, radius: 2.0 };
    assert_eq!(ball.with_surface_through(vec3(1.0, 3.0, 4.0)).unwrap().radius, 5.0);
    assert_eq!(ball.with_surface_through(DVec3::X), Err(ObjectError::Radius { value: 0.0 }));
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn a_dragged_corner_is_under_the_hand(
        camera in calm_camera(), u in 0.01..10.0_f64, v in 0.01..10.0_f64, which in 0..4_usize,
    ) {
        let corner = ViewportCorner::ALL[which];
        let resolved = camera.resolve().unwrap();
        let uv = corner.signs() * DVec2::new(u, v) * camera.viewport.distance;
        let point = resolved.viewport_point(uv);
        let after = camera.with_viewport_corner(corner, point, CornerKeeps::Nothing).unwrap();
        let found = corner.uv(&after.viewport);
        prop_assert!(found.distance(uv) <= 1e-12 * (uv.length() + camera.eye.length()));
        // With a ratio to keep, the hand is straight across the diagonal from the corner.
        let after = camera.with_viewport_corner(corner, point, CornerKeeps::Ratio).unwrap();
        let found = corner.uv(&after.viewport);
        let off = (uv - found).dot(found) / found.length();
        prop_assert!(off.abs() <= 1e-12 * (uv.length() + camera.eye.length()));
        let ratio = after.viewport.width / after.viewport.height;
        let kept = camera.viewport.width / camera.viewport.height;
        prop_assert!((ratio / kept - 1.0).abs() < 1e-14);
    }
}
