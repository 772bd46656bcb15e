//! Tests that conversions and their inverses agree: of pixels and (u, v), view rays and projection,
//! fields of view and viewports.

use std::f64::consts::{FRAC_PI_2, PI};

use pinhole_core::*;
use proptest::prelude::*;

use crate::common::seed::config;
use crate::common::{assert_ulps, vec3};

fn with_viewport(width: f64, height: f64, columns: u32, rows: u32) -> ResolvedCamera {
    let viewport = Viewport { width, height, distance: 1.0 };
    let image = ImageSize::new(columns, rows).unwrap();
    Camera { viewport, image, ..Camera::CANONICAL }.resolve().unwrap()
}

fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|e| 10_f64.powf(e))
}

/// Width and height of viewports that are not exact in binary, and numbers of columns and rows that do
/// not divide them.
const SIZES: [(f64, f64, u32, u32); 8] = [
    (1.6, 0.9, 333, 187),
    (1.0, 1.0, 400, 400),
    (0.1, 0.3, 7, 3),
    (PI, 1e-12, 101, 1),
    (1e12, 2.0 / 3.0, 1, 999),
    (1e-300, 1e300, 640, 481),
    (4.0 / 3.0, 1.0, 16_384, 1),
    (1.0, 0.7, 1, 16_384),
];

#[test]
fn every_pixels_centre_falls_into_the_pixel() {
    for (width, height, columns, rows) in SIZES {
        let camera = with_viewport(width, height, columns, rows);
        for row in 0..rows {
            for column in 0..columns {
                let pixel = Pixel { row, column };
                let position = camera.pixel_of_uv(camera.uv_of_pixel(pixel));
                let inside = PixelOfUv { pixel, column_edge: None, row_edge: None };
                assert_eq!(position, Some(inside), "{width} x {height}");
            }
        }
    }
}

/// A (u, v) on an edge between pixels is recognised as such, whichever formula the caller used to
/// compute it.
#[test]
fn every_edge_is_told() {
    for (width, height, columns, rows) in SIZES {
        let camera = with_viewport(width, height, columns, rows);
        let (row, column) = (rows / 2, columns / 2);
        let centre = camera.uv_of_pixel(Pixel { row, column });
        for k in 0..=columns {
            let share = f64::from(k) / f64::from(columns);
            let pixel_width = width / f64::from(columns);
            let ways = [
                camera.u_of_column_edge(k),
                width * (share - 0.5),
                width * share - 0.5 * width,
                pixel_width * f64::from(k) - 0.5 * width,
            ];
            for u in ways {
                let position = camera.pixel_of_uv(DVec2::new(u, centre.y)).unwrap();
                assert_eq!(
                    (position.column_edge, position.row_edge),
                    (Some(k), None),
                    "{u} of {width}"
                );
                assert_eq!(position.pixel, Pixel { row, column: k.min(columns - 1) });
            }
        }
        for k in 0..=rows {
            let v = camera.v_of_row_edge(k);
            let position = camera.pixel_of_uv(DVec2::new(centre.x, v)).unwrap();
            assert_eq!(
                (position.column_edge, position.row_edge),
                (None, Some(k)),
                "{v} of {height}"
            );
            assert_eq!(position.pixel, Pixel { row: k.min(rows - 1), column });
        }
    }
}

#[test]
fn beside_an_edge_is_inside() {
    let camera = with_viewport(1.6, 0.9, 333, 187);
    let edge = camera.u_of_column_edge(100);
    for (beside, column) in [(-1e-14, 99), (1e-14, 100)] {
        let position = camera.pixel_of_uv(DVec2::new(edge + beside, 0.0)).unwrap();
        assert_eq!((position.pixel.column, position.column_edge), (column, None));
    }
}

#[test]
fn touching_pixels() {
    let camera = with_viewport(4.0, 2.0, 4, 2);
    let touching = |u, v| -> Vec<(u32, u32)> {
        let position = camera.pixel_of_uv(DVec2::new(u, v)).unwrap();
        position.touching(camera.image()).iter().map(|pixel| (pixel.row, pixel.column)).collect()
    };
    assert_eq!(touching(0.5, 0.5), [(0, 2)]);
    assert_eq!(touching(0.0, 0.5), [(0, 1), (0, 2)]);
    assert_eq!(touching(0.5, 0.0), [(0, 2), (1, 2)]);
    assert_eq!(touching(-1.0, 0.0), [(0, 0), (0, 1), (1, 0), (1, 1)]);
    // On the image's own edges and corners.
    assert_eq!(touching(-2.0, 0.5), [(0, 0)]);
    assert_eq!(touching(2.0, 0.0), [(0, 3), (1, 3)]);
    assert_eq!(touching(2.0, -1.0), [(1, 3)]);
    assert_eq!(touching(-2.0, 1.0), [(0, 0)]);
}

#[test]
fn outside_the_viewport_is_no_pixel() {
    let camera = with_viewport(1.6, 0.9, 333, 187);
    for (u, v) in [
        (0.8 + 1e-14, 0.0),
        (-0.8 - 1e-14, 0.0),
        (0.0, 0.45 + 1e-14),
        (0.0, -0.45 - 1e-14),
        (1e300, 0.0),
        (0.0, -f64::MAX),
        (f64::INFINITY, 0.0),
        (f64::NAN, 0.0),
        (0.0, f64::NAN),
    ] {
        assert_eq!(camera.pixel_of_uv(DVec2::new(u, v)), None, "({u}, {v})");
    }
}

fn resolve() -> impl Strategy<Value = ResolvedCamera> {
    let coordinate = || -1.0..1.0_f64;
    let vector = || [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array);
    let extent = || magnitude(-2.0, 2.0);
    (vector(), vector(), vector(), [extent(), extent(), extent()], 1..2000_u32, 1..2000_u32)
        .prop_filter_map("has a basis", |(eye, view, up, [width, height, distance], w, h)| {
            Camera {
                eye: 10.0 * eye,
                orientation: Orientation::View { view, up },
                viewport: Viewport { width, height, distance },
                image: ImageSize::new(w, h).unwrap(),
            }
            .resolve()
            .ok()
        })
}

proptest! {
    #![proptest_config(config(3000))]

    /// The projection of a point of a view ray is the ray's (u, v), and its depth is t * distance, up
    /// to a few rounding errors of the coordinates.
    #[test]
    fn projection_undoes_the_ray(
        camera in resolve(), across in -0.5..0.5_f64, up in -0.5..0.5_f64, t in magnitude(-2.0, 3.0),
        behind in any::<bool>(),
    ) {
        let Viewport { width, height, distance } = *camera.viewport();
        let uv = DVec2::new(across * width, up * height);
        let ray = camera.ray(uv);
        let t = if behind { -t } else { t };
        let Projection { uv: found, depth } = camera.project(ray.at(t));
        let size = camera.eye().length() + ray.distance_along(t).abs();
        let rounding = 16.0 * f64::EPSILON * size;
        prop_assert!((depth - t * distance).abs() <= rounding);
        // The rounding error of the point, projected onto the viewport.
        let seen = rounding * (1.0 / t.abs()) * (ray.direction.length() / distance);
        prop_assert!((found - uv).abs().max_element() <= 2.0 * seen, "{found} {uv} {seen:e}");
        let in_front = camera.project(ray.at(t)).is_in_front();
        prop_assert!(in_front != behind || depth.abs() <= rounding);
    }

    /// The ray through a point's projection passes through the point at `t = depth / distance`.
    #[test]
    fn the_ray_undoes_projection(camera in resolve(), point in [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0]) {
        let point = DVec3::from_array(point);
        let projection = camera.project(point);
        let ray = camera.ray(projection.uv);
        let t = projection.depth / camera.viewport().distance;
        let rounding = 32.0 * f64::EPSILON * (camera.eye().length() + point.length());
        prop_assert!((ray.at(t) - point).length() <= rounding, "{} {point}", ray.at(t));
    }

    #[test]
    fn a_pixels_ray_projects_into_the_pixel(camera in resolve(), row in 0.0..1.0, column in 0.0..1.0) {
        let image = camera.image();
        let pixel = Pixel {
            row: (row * f64::from(image.height())) as u32,
            column: (column * f64::from(image.width())) as u32,
        };
        let point = camera.ray_of_pixel(pixel).at(3.0);
        let position = camera.pixel_of_uv(camera.project(point).uv).unwrap();
        prop_assert_eq!(position.pixel, pixel);
        prop_assert!(image.contains(pixel));
    }

    /// Converts extents to fields of view, from 1e-9 rad to about 1e-9 below pi, and back.
    #[test]
    fn field_of_view_and_extent_undo_each_other(
        distance in magnitude(-12.0, 12.0), ratio in magnitude(-9.0, 9.0),
    ) {
        let extent = ratio * distance;
        let fov = fov_of_extent(extent, distance);
        prop_assert!(0.0 < fov && fov < PI);
        let back = extent_of_fov(fov, distance);
        // Near pi, one ulp of the angle corresponds to many ulps of the extent.
        let tolerance = 4.0 * f64::EPSILON * (1.0 + ratio);
        prop_assert!((back / extent - 1.0).abs() <= tolerance, "{back} {extent}");
    }

    #[test]
    fn a_new_field_of_view_keeps_the_shape(
        width in magnitude(-12.0, 12.0), height in magnitude(-12.0, 12.0), fov in 0.01..3.1_f64,
    ) {
        let before = Viewport { width, height, distance: 2.0 };
        for after in [before.with_vertical_fov(fov), before.with_horizontal_fov(fov)] {
            prop_assert_eq!(after.distance, 2.0);
            let ratio = (after.width / after.height) / (width / height);
            prop_assert!((ratio - 1.0).abs() <= 4.0 * f64::EPSILON);
        }
        prop_assert!((before.with_vertical_fov(fov).vertical_fov() - fov).abs() <= 1e-15 * fov);
        prop_assert!((before.with_horizontal_fov(fov).horizontal_fov() - fov).abs() <= 1e-15 * fov);
        let square = Viewport { height: width, ..before }.with_vertical_fov(fov);
        prop_assert_eq!(square.width, square.height);
    }
}

#[test]
fn fields_of_view_at_the_ends() {
    assert_ulps(Viewport::CANONICAL.vertical_fov(), 2.0 * 0.5_f64.atan(), 1);
    assert_ulps(extent_of_fov(FRAC_PI_2, 1.0), 2.0, 1);
    assert_ulps(fov_of_extent(2.0, 1.0), FRAC_PI_2, 0);
    assert_eq!(fov_of_extent(1e308, 1e-308), PI);
    assert_eq!(fov_of_extent(1e-308, 1e308), 0.0);
    assert!(extent_of_fov(PI, 1.0) > 1e15);
    assert_eq!(extent_of_fov(1e-3, f64::MAX), 2.0 * (f64::MAX * 0.5e-3_f64.tan()));
    // No angle, no viewport: the door says so.
    for fov in [0.0, -1.0, 3.2, 7.0, f64::NAN, f64::INFINITY] {
        let viewport = Viewport::CANONICAL.with_vertical_fov(fov);
        assert_eq!(viewport, Viewport { height: 0.0, ..Viewport::CANONICAL });
        let flat = viewport.check().unwrap_err();
        assert_eq!((flat.field, flat.value), ("height", 0.0));
        // And the next angle is taken.
        assert_eq!(viewport.with_vertical_fov(FRAC_PI_2).check(), Ok(()));
    }
    let extreme = Viewport { width: 1e-300, height: 1e300, distance: 1e300 };
    assert_eq!(extreme.with_vertical_fov(1.0).check(), Ok(()));
}

#[test]
fn projection_at_the_ends() {
    let camera = Camera::CANONICAL.resolve().unwrap();
    let behind = camera.project(vec3(1.0, 2.0, 4.0));
    assert_eq!((behind.uv, behind.depth), (DVec2::new(-0.25, -0.5), -4.0));
    assert!(!behind.is_in_front());
    // A point in the plane through the eye has no (u, v), and is not in front of the eye.
    let beside = camera.project(vec3(1.0, -1.0, 0.0));
    assert!(!beside.uv.is_finite() && !beside.is_in_front());
    // A point has a projection even if its difference from the eye overflows.
    let eye = vec3(0.0, 0.0, 1.7e308);
    let camera = Camera {
        eye,
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        ..Camera::CANONICAL
    };
    let far = camera.resolve().unwrap().project(vec3(0.0, 1.7e308, -1.7e308));
    assert_eq!(far.uv, DVec2::new(0.0, 0.5));
    assert!(far.is_in_front());
}

#[test]
fn the_viewports_corners_in_the_world() {
    let camera = with_viewport(1.6, 0.9, 16, 9);
    assert_eq!(camera.viewport_point(DVec2::new(-0.8, 0.45)), vec3(-0.8, 0.45, -1.0));
    assert_eq!(camera.ray(DVec2::ZERO).direction, DVec3::NEG_Z);
}
