//! Tests that an invalid ray, object, basis or camera is rejected with a typed error when it is created
//! or checked, and that using it without a check causes no panic, no hit and no endless loop.

use pinhole_core::methods::Method;
use pinhole_core::*;
use pinhole_reference::{Object as GivenObject, RayCase};

use crate::common::{first_hit_by, given, invalid, roots_of, vec3};

/// Returns the field that is invalid according to a case's text: "center" for "center.x is NaN".
fn field_of(what: &str) -> &str {
    let name = what.split(' ').next().unwrap();
    name.strip_suffix(".x").or(name.strip_suffix(".y")).or(name.strip_suffix(".z")).unwrap_or(name)
}

fn objects_of(case: &RayCase) -> (Vec<Sphere>, Vec<Plane>) {
    let (mut spheres, mut planes) = (Vec::new(), Vec::new());
    for object in &case.objects {
        match *object {
            GivenObject::Sphere { center, radius } => {
                spheres.push(Sphere { center: center.into(), radius });
            }
            GivenObject::Plane { point, normal } => {
                planes.push(Plane { point: point.into(), normal: normal.into() });
            }
        }
    }
    (spheres, planes)
}

#[track_caller]
fn assert_ray_error(error: RayError, what: &str) {
    match error {
        RayError::NotFinite { field, value } => {
            assert_eq!(field, field_of(what), "{what}");
            assert!(!value.is_finite(), "{what}");
        }
        RayError::DirectionIsZero => assert!(what.starts_with("direction is "), "{what}"),
        other => panic!("{what}: {other}"),
    }
}

#[track_caller]
fn assert_object_error(error: ObjectError, what: &str) {
    match error {
        ObjectError::NotFinite { field, value } => {
            assert_eq!(field, field_of(what), "{what}");
            assert!(!value.is_finite(), "{what}");
        }
        ObjectError::Radius { value } => {
            assert_eq!(field_of(what), "radius");
            assert!(value.is_nan() || value <= 0.0 || value.is_infinite(), "{what}");
        }
        ObjectError::NormalIsZero => assert!(what.starts_with("normal is "), "{what}"),
        other => panic!("{what}: {other}"),
    }
}

#[test]
fn rays_and_objects() {
    let mut refused = [0; 3];
    for (what, case) in invalid::rays() {
        let (spheres, planes) = objects_of(&case);
        let ray = Ray { origin: case.origin.into(), direction: case.direction.into() };
        let (sphere, plane) = (spheres[0], planes[0]);
        let doors = [
            ray.check().err(),
            Ray::new(case.origin, case.direction).err(),
            ExactRay::from_ray(&ray).err(),
        ];
        let of_sphere = [sphere.check().err(), Sphere::new(sphere.center, sphere.radius).err()];
        let of_plane = [plane.check().err(), Plane::new(plane.point, plane.normal).err()];
        match Scene::new(spheres, planes) {
            Ok(scene) => {
                refused[0] += 1;
                for error in doors {
                    assert_ray_error(error.unwrap(), &what);
                }
                assert_meets_nothing(&scene, &ray, &what);
            }
            Err(SceneError { kind: "sphere", index, error }) => {
                refused[1] += 1;
                assert_eq!(index, 0, "{what}");
                for door in [Some(error)].into_iter().chain(of_sphere) {
                    assert_object_error(door.unwrap(), &what);
                }
                assert_is_none(&Object::Sphere(sphere), &what);
            }
            Err(SceneError { index, error, .. }) => {
                refused[2] += 1;
                assert_eq!(index, 1, "{what}");
                for door in [Some(error)].into_iter().chain(of_plane) {
                    assert_object_error(door.unwrap(), &what);
                }
                assert_is_none(&Object::Plane(plane), &what);
            }
        }
    }
    assert!(refused.iter().all(|count| *count >= 10), "{refused:?}");
}

/// A ray that is none meets nothing.
#[track_caller]
fn assert_meets_nothing(scene: &Scene, ray: &Ray, what: &str) {
    assert_eq!(scene.first_hit(ray), None, "{what}");
    assert_eq!(roots_of(scene, ray), [], "{what}");
    assert_eq!(first_hit_by(Method::Ladder, scene, ray), None, "{what}");
    for object in scene.objects() {
        assert_eq!(object.roots(ray), Roots::None, "{what}");
    }
    for method in Method::all() {
        if let Some(hit) = first_hit_by(method, scene, ray) {
            assert!(hit.t > 0.0 && hit.t.is_finite(), "{method} on {what}");
        }
    }
    let _ = (ray.at(1.0), ray.distance_along(1.0));
}

/// Asserts that no ray meets an invalid object, wherever the ray starts.
#[track_caller]
fn assert_is_none(object: &Object, what: &str) {
    let resolved = Camera::CANONICAL.resolve().unwrap();
    let given = [
        Ray::new([0.0; 3], [0.0, 0.0, -1.0]).unwrap(),
        Ray::new([0.0, 0.0, -5.0], [0.3, 0.2, -1.0]).unwrap(),
        Ray::new([1e300, -1e-300, 5.0], [1e-300, 5e-324, -1e300]).unwrap(),
    ];
    let pixel = Pixel { row: 200, column: 200 };
    let mut rays: Vec<ExactRay> =
        given.iter().map(|ray| ExactRay::from_ray(ray).unwrap()).collect();
    rays.push(resolved.exact_ray(pixel));
    for ray in rays {
        assert_eq!(object.first_hit(0, &ray), None, "{what}");
        match object {
            Object::Sphere(sphere) => {
                assert!(sphere.quadratic_of(&ray).discriminant.is_nan(), "{what}");
            }
            Object::Plane(plane) => {
                assert!(plane.terms_of(&ray).rate.is_nan(), "{what}");
                assert!(!plane.is_same(plane), "{what}");
            }
        }
        assert_eq!(object.roots_of(&ray), Roots::None, "{what}");
    }
    assert!(object.check().is_err(), "{what}");
}

#[test]
fn bases() {
    let cases = invalid::bases();
    assert!(cases.len() > 50);
    for (what, case) in cases {
        let eye = case.eye.into();
        let orientation = given::orientation(&case.orientation);
        let camera = Camera { eye, orientation, ..Camera::CANONICAL };
        let alone = match orientation {
            Orientation::At { at, up } => Basis::from_eye_at_up(eye, at, up).err(),
            Orientation::View { view, up } => Basis::from_view_up(view, up).err(),
            Orientation::Basis(Basis { u, v, w }) => Basis::by_hand(u, v, w).err(),
        };
        for error in [camera.basis().err(), camera.up_angle().err(), alone] {
            let Some(BasisError::NotFinite { field, value }) = error else {
                panic!("{error:?} where {what}");
            };
            assert_eq!(field, field_of(&what));
            assert!(!value.is_finite(), "{what}");
        }
        let resolved = camera.resolve();
        assert!(
            matches!(resolved, Err(CameraError::Basis(BasisError::NotFinite { .. }))),
            "{resolved:?} where {what}"
        );
        assert!(camera.up_angle().is_err(), "{what}");
        for kind in [OrientationKind::At, OrientationKind::View, OrientationKind::Basis] {
            // Converted, it has no basis either, unless u alone is at fault, which is left out.
            if field_of(&what) == "basis.u" {
                continue;
            }
            let converted = camera.given_by(kind).and_then(|camera| camera.basis());
            assert!(converted.is_err(), "{what} by {kind:?}");
        }
        let _ = (camera.view(), camera.up());
    }
}

#[test]
fn cameras() {
    let cases = invalid::cameras();
    assert!(cases.len() >= 20);
    for (what, given) in cases {
        let size = ImageSize::new(given.columns, given.rows);
        let Ok(image) = size else {
            assert!(what.starts_with("columns") || what.starts_with("rows"), "{what}");
            continue;
        };
        let viewport =
            Viewport { width: given.width, height: given.height, distance: given.distance };
        let camera = Camera { image, viewport, ..Camera::CANONICAL };
        let error = camera.resolve().unwrap_err();
        assert!(matches!(error, CameraError::Viewport(_)), "{error:?} where {what}");
        assert_eq!(
            viewport.check().err().map(CameraError::Viewport).map(|e| e.to_string()),
            Some(error.to_string())
        );
        assert!(error.to_string().contains(field_of(&what)), "{error} where {what}");
        // The basis is valid all the same.
        assert!(camera.basis().is_ok(), "{what}");
        let _ = (viewport.horizontal_fov(), viewport.vertical_fov());
    }
}

/// Tests invalid (u, v), points and pixels as arguments of a valid camera's methods.
#[test]
fn places_in_a_camera() {
    let resolved = Camera::CANONICAL.resolve().unwrap();
    let strange = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for x in strange {
        for uv in [DVec2::new(x, 0.0), DVec2::new(0.0, x), DVec2::splat(x)] {
            let error = resolved.exact_ray_at(uv).unwrap_err();
            assert!(matches!(error, RayError::NotFinite { field: "uv", .. }), "{error:?}");
            assert_eq!(resolved.pixel_of_uv(uv), None, "{uv}");
            assert!(resolved.ray(uv).check().is_err(), "{uv}");
        }
        for point in [vec3(x, 0.0, -1.0), vec3(0.0, 0.0, x)] {
            assert!(
                !resolved.project(point).uv.is_finite()
                    || !resolved.project(point).depth.is_finite()
            );
        }
    }
    // Pixels outside the image have valid rays, too.
    let scene = Scene::new(vec![Sphere::new([0.0, 0.0, -5.0], 1.0).unwrap()], vec![]).unwrap();
    for pixel in [Pixel { row: u32::MAX, column: 0 }, Pixel { row: 400, column: u32::MAX }] {
        assert!(resolved.ray_of_pixel(pixel).check().is_ok());
        assert_eq!(scene.first_hit_of(&resolved.exact_ray(pixel)), None);
    }
}
