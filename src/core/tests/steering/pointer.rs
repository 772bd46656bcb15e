//! Tests that dragged points stay under the pointer.

use pinhole_core::steering::*;
use pinhole_core::*;
use proptest::prelude::*;

use super::{direction, vec3};
use crate::common::seed::config;

/// Returns a camera at (0, 0, 10) that looks along -z, with a viewport of 2 x 2 at distance 1.
fn straight() -> ResolvedCamera {
    Camera {
        eye: vec3(0.0, 0.0, 10.0),
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        viewport: Viewport { width: 2.0, height: 2.0, distance: 1.0 },
        ..Camera::CANONICAL
    }
    .resolve()
    .unwrap()
}

/// Generates an observer's camera, the (u, v) of an anchor (the point that is dragged) in its picture,
/// and the anchor.
fn observed() -> impl Strategy<Value = (ResolvedCamera, DVec2, DVec3)> {
    let uv = || (-0.5..0.5_f64, -0.5..0.5_f64).prop_map(DVec2::from);
    (direction(), direction(), -6.0..6.0_f64, uv(), -2.0..2.0_f64).prop_filter_map(
        "up across the view",
        |(view, position, size, uv, depth)| {
            let size = 10_f64.powf(size);
            let camera = Camera {
                eye: size * position,
                orientation: Orientation::View { view, up: vec3(0.1, 1.0, 0.2) },
                viewport: Viewport { width: 1.0, height: 1.0, distance: 0.8 },
                ..Camera::CANONICAL
            };
            let resolved = camera.resolve().ok()?;
            let anchor = resolved.ray(uv).at(size * 10_f64.powf(depth));
            Some((resolved, uv, anchor))
        },
    )
}

fn image(observer: &ResolvedCamera, point: DVec3) -> DVec2 {
    observer.project(point).uv
}

#[test]
fn what_is_far_moves_farther() {
    let (anchor, begun_at) = (vec3(1.0, 0.0, 6.0), DVec2::new(0.25, 0.0));
    let to = |u, v, along| straight().dragged(anchor, begun_at, DVec2::new(u, v), along);
    assert_eq!(to(0.5, 0.25, DragAlong::ViewPlane), Ok(vec3(2.0, 1.0, 6.0)));
    assert_eq!(to(0.5, 0.25, DragAlong::Axis(2.0 * DVec3::Y)), Ok(vec3(1.0, 1.0, 6.0)));
    let oblique = to(0.5, 0.0, DragAlong::Axis(vec3(1.0, 0.0, -1.0))).unwrap();
    // On the ray (0.5, 0, -1) from z = 10, and on the axis: x = (10 - z)/2 = 7 - z.
    assert!((oblique - vec3(3.0, 0.0, 4.0)).length() < 1e-14);
    // On the floor the ray (0.25, -0.5, -1) comes down one unit at z = 8.
    let (anchor, begun_at) = (vec3(0.0, -1.0, 6.0), DVec2::new(0.0, -0.25));
    let plane = DragAlong::Plane(DVec3::Y);
    let moved = straight().dragged(anchor, begun_at, DVec2::new(0.25, -0.5), plane).unwrap();
    assert!((moved - vec3(0.5, -1.0, 8.0)).length() < 1e-14);
    assert_eq!(straight().dragged(anchor, begun_at, begun_at, plane), Ok(anchor));
}

#[test]
fn a_pixel_measures_more_far_away() {
    let at = |z| pixel_in_world(&straight(), vec3(3.0, 1.0, z));
    // 2 x 2 in 400 x 400 pixels.
    assert_eq!(at(9.0), Ok(0.005));
    assert_eq!(at(-10.0), Ok(0.1));
    assert_eq!(at(10.0), Err(SteerError::NotInFront { depth: 0.0 }));
}

#[test]
fn nothing_jumps_to_infinity() {
    let begun_at = DVec2::new(0.0, -0.1);
    let to =
        |v, along| straight().dragged(vec3(0.0, -1.0, 0.0), begun_at, DVec2::new(0.0, v), along);
    // Along the floor, towards the horizon in the middle and past it.
    let away = DragAlong::Axis(DVec3::NEG_Z);
    assert!(to(-0.2, away).is_ok());
    for v in [-9e-5, 0.0, 0.3] {
        assert_eq!(to(v, away), Err(SteerError::PastHorizon));
    }
    assert!(to(-0.0875, DragAlong::Plane(DVec3::Y)).is_ok());
    let on_edge = to(-0.08, DragAlong::Plane(DVec3::Y));
    assert!(matches!(on_edge, Err(SteerError::OnEdge { .. })));
    let wall = DragAlong::Plane(vec3(0.0, 1.0, 1.0));
    assert_eq!(to(2.0, wall), Err(SteerError::PastHorizon));
    let towards = DragAlong::Axis(vec3(0.0, 1.0, 10.0));
    assert!(matches!(to(0.3, towards), Err(SteerError::OnEdge { angle }) if angle < 1e-9));
    let behind = vec3(0.0, 0.0, 11.0);
    let refused = straight().dragged(behind, begun_at, DVec2::ZERO, DragAlong::ViewPlane);
    assert_eq!(refused, Err(SteerError::NotInFront { depth: -1.0 }));
    assert!(matches!(to(f64::NAN, DragAlong::ViewPlane), Err(SteerError::Camera(_))));
}

proptest! {
    #![proptest_config(config(4000))]

    #[test]
    fn the_point_is_under_the_pointer(
        (observer, uv, anchor) in observed(),
        beside in (-0.02..0.02_f64, -0.02..0.02_f64).prop_map(DVec2::from),
        way in (-0.5..0.5_f64, -0.5..0.5_f64).prop_map(DVec2::from),
        normal in direction(),
    ) {
        // Rounding of the anchor and of the point: both may be near an observer far from the origin.
        let near = observer.project(anchor).depth.min(1e300);
        let rounding = 1e-9 + 1e-14 * observer.eye().length() / near;
        let uv = uv + beside;
        for along in [DragAlong::ViewPlane, DragAlong::Plane(normal)] {
            let Ok(point) = observer.dragged(anchor, uv, uv + way, along) else {
                prop_assert!(along != DragAlong::ViewPlane);
                continue;
            };
            let nearer = near / observer.project(point).depth;
            let off = image(&observer, point) + beside - (uv + way);
            prop_assert!(off.length() <= rounding * nearer.max(1.0), "{:?} {}", along, off);
            if let DragAlong::Plane(normal) = along {
                let moved = point - anchor;
                let off = normal.normalize().dot(moved);
                prop_assert!(off.abs() <= 1e-9 * moved.length() + 1e-14 * observer.eye().length());
            }
            // The exception is a plane that is seen edge-on there.
            let back = observer.dragged(anchor, uv, uv, along);
            let on_edge = matches!(back, Err(SteerError::OnEdge { .. }));
            prop_assert!(back == Ok(anchor) || on_edge);
        }
    }

    /// A point that is dragged along an axis is the one nearest to the pointer: in the picture, the
    /// remaining distance to the pointer is perpendicular to the axis.
    #[test]
    fn along_an_axis_the_nearest_point_is_found(
        (observer, uv, anchor) in observed(),
        way in (-0.5..0.5_f64, -0.5..0.5_f64).prop_map(DVec2::from),
        axis in direction(),
    ) {
        prop_assume!(observer.eye().length() < 100.0 * observer.project(anchor).depth);
        let Ok(point) = observer.dragged(anchor, uv, uv + way, DragAlong::Axis(axis)) else {
            return Ok(());
        };
        let depth = observer.project(anchor).depth;
        let moved = point - anchor;
        let size = 1e-12 * (observer.eye().length() + depth);
        prop_assert!(moved.cross(axis).length() <= 1e-9 * moved.length() + size);
        let other = image(&observer, anchor + 1e-3 * depth * axis);
        let line = (other - image(&observer, anchor)).normalize();
        let rest = image(&observer, anchor) + way - image(&observer, point);
        let nearer = (depth / observer.project(point).depth).max(1.0);
        prop_assert!(rest.dot(line).abs() <= 1e-8 * nearer, "{} {}", rest, line);
        prop_assert_eq!(observer.dragged(anchor, uv, uv, DragAlong::Axis(axis)), Ok(anchor));
    }

    #[test]
    fn pointers_side_by_side_drag_to_points_side_by_side(
        (observer, uv, anchor) in observed(),
        way in (-0.3..0.3_f64, -0.3..0.3_f64).prop_map(DVec2::from),
        axis in direction(),
    ) {
        prop_assume!(observer.eye().length() < 100.0 * observer.project(anchor).depth);
        let to = |way: DVec2| observer.dragged(anchor, uv, uv + way, DragAlong::Axis(axis));
        let (Ok(a), Ok(b)) = (to(way), to(way + DVec2::splat(1e-9))) else {
            return Ok(());
        };
        // The distance may grow with the square of the depth, and with the inverse of the smallest
        // allowed angle.
        let deeper = observer.project(a).depth / observer.project(anchor).depth;
        let most = 1e-9 * 1000.0 * (1.0 + deeper * deeper) * observer.project(anchor).depth;
        prop_assert!(a.distance(b) <= most);
    }
}
