//! The feature `serde`: what is written, and what is refused when it is read.

use std::fmt::Debug;

use pinhole_core::*;
use serde::de::value::{Error, SeqDeserializer};
use serde::{Deserialize, Serialize, de::DeserializeOwned};

use crate::common::{plane, sphere, vec3};

#[track_caller]
fn assert_kept<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T, text: &str) {
    assert_eq!(serde_json::to_string(&value).unwrap(), text);
    assert_eq!(serde_json::from_str::<T>(text).unwrap(), value);
}

#[track_caller]
fn assert_refused<T: DeserializeOwned + Debug>(text: &str, message: &str) {
    assert_eq!(serde_json::from_str::<T>(text).unwrap_err().to_string(), message);
}

#[test]
fn all_is_read_as_it_was_written() {
    let viewport = Viewport { width: 0.1, height: 5e-324, distance: f64::MAX };
    assert_kept(viewport, r#"{"width":0.1,"height":5e-324,"distance":1.7976931348623157e+308}"#);
    let image = ImageSize::new(ImageSize::MAX, 1).unwrap();
    assert_kept(image, r#"{"width":16384,"height":1}"#);
    assert_kept(Pixel { row: 2, column: 3 }, r#"{"row":2,"column":3}"#);
    assert_kept(
        Intrinsics::from_viewport(&Viewport::CANONICAL, Camera::CANONICAL.image),
        r#"{"fx":400.0,"fy":400.0,"cx":200.0,"cy":200.0}"#,
    );
    assert_kept(
        Ray::new([0.0, -0.0, 1.0], [0.1, 0.2, -1e300]).unwrap(),
        r#"{"origin":[0.0,-0.0,1.0],"direction":[0.1,0.2,-1e+300]}"#,
    );
    let kinds = [OrientationKind::At, OrientationKind::View, OrientationKind::Basis];
    assert_kept(kinds, r#"["at","view","basis"]"#);
    assert_kept(Shade::ALL, r#"["lambert","normal","t","object"]"#);
    assert_kept(Outputs::default(), r#"{"t":true,"object":true,"normal":false}"#);
}

#[test]
fn cameras_are_given_in_three_ways() {
    let rest = r#""viewport":{"width":1.0,"height":1.0,"distance":1.0},"image":{"width":400,"height":400}"#;
    let eye = vec3(1.0, 2.0, 3.0);
    for (orientation, text) in [
        (
            Orientation::At { at: vec3(0.0, 0.0, 0.5), up: DVec3::Y },
            r#"{"at":{"at":[0.0,0.0,0.5],"up":[0.0,1.0,0.0]}}"#,
        ),
        (
            Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
            r#"{"view":{"view":[0.0,0.0,-1.0],"up":[0.0,1.0,0.0]}}"#,
        ),
        (
            Orientation::Basis(Basis::CANONICAL),
            r#"{"basis":{"u":[1.0,0.0,0.0],"v":[0.0,1.0,0.0],"w":[0.0,0.0,1.0]}}"#,
        ),
    ] {
        let camera = Camera { eye, orientation, ..Camera::CANONICAL };
        let text = format!(r#"{{"eye":[1.0,2.0,3.0],"orientation":{text},{rest}}}"#);
        assert_kept(camera, &text);
    }
}

#[test]
fn scenes_are_their_objects() {
    let (ball, wall) = (sphere([0.0, 0.0, -5.0], 1.5), plane([0.0; 3], [0.0, 0.0, 2.0]));
    let ball_text = r#"{"center":[0.0,0.0,-5.0],"radius":1.5}"#;
    let wall_text = r#"{"point":[0.0,0.0,0.0],"normal":[0.0,0.0,2.0]}"#;
    assert_kept(
        Scene::new(vec![ball], vec![wall]).unwrap(),
        &format!(r#"{{"spheres":[{ball_text}],"planes":[{wall_text}]}}"#),
    );
    assert_kept(Scene::default(), r#"{"spheres":[],"planes":[]}"#);
    assert_kept(Object::Sphere(ball), &format!(r#"{{"sphere":{ball_text}}}"#));
    assert_kept(Object::Plane(wall), &format!(r#"{{"plane":{wall_text}}}"#));
}

#[test]
fn what_code_refuses_is_refused_with_the_same_message() {
    assert_refused::<ImageSize>(
        r#"{"width":0,"height":1}"#,
        "image width is 0: it must be 1 to 16384 pixels",
    );
    assert_refused::<Viewport>(
        r#"{"width":1,"height":-1.5,"distance":1}"#,
        "viewport height is -1.5: it must be finite and greater than 0",
    );
    assert_refused::<Sphere>(
        r#"{"center":[0,0,0],"radius":0}"#,
        "radius is 0: it must be finite and greater than 0",
    );
    assert_refused::<Plane>(
        r#"{"point":[0,0,0],"normal":[0,0,0]}"#,
        "normal is (0, 0, 0): it must point somewhere",
    );
    assert_refused::<Object>(
        r#"{"plane":{"point":[0,0,0],"normal":[0,0,-0.0]}}"#,
        "normal is (0, 0, 0): it must point somewhere",
    );
    assert_refused::<Ray>(
        r#"{"origin":[0,0,0],"direction":[0,0,0]}"#,
        "direction is (0, 0, 0): it must point somewhere",
    );
    assert_refused::<Basis>(
        r#"{"u":[1,0,0],"v":[0,1,0],"w":[0,0,-1]}"#,
        "the basis is left-handed: u x v is -w and must be w, which points backwards",
    );
    assert_refused::<Camera>(
        r#"{"eye":[0,0,0],"orientation":{"at":{"at":[0,0,0],"up":[0,1,0]}},
            "viewport":{"width":1,"height":1,"distance":1},"image":{"width":5,"height":5}}"#,
        "eye and at are the same point (0, 0, 0): move one of them",
    );
}

#[test]
fn the_object_of_a_scene_that_is_refused_is_named() {
    assert_refused::<Scene>(
        r#"{"spheres":[{"center":[0,0,0],"radius":1},{"center":[0,0,0],"radius":-1}],"planes":[]}"#,
        "sphere 1: radius is -1: it must be finite and greater than 0",
    );
    assert_refused::<Scene>(
        r#"{"spheres":[{"center":[0,0,0],"radius":1}],"planes":[{"point":[0,0,0],"normal":[0,0,0]}]}"#,
        "plane 1: normal is (0, 0, 0): it must point somewhere",
    );
}

/// JSON has no such numbers; other formats have.
#[test]
fn numbers_that_are_not_finite_are_refused() {
    for (value, text) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let numbers = SeqDeserializer::<_, Error>::new([1.0, 1.0, value].into_iter());
        assert_eq!(
            Viewport::deserialize(numbers).unwrap_err().to_string(),
            format!("viewport distance is {text}: it must be finite and greater than 0")
        );
    }
    let no_number = r#"{"center":[0,null,0],"radius":1}"#;
    assert_refused::<Sphere>(no_number, "invalid type: null, expected f64 at line 1 column 17");
}

#[test]
fn what_is_missing_is_named() {
    assert_refused::<Scene>(r#"{"spheres":[]}"#, "missing field `planes` at line 1 column 14");
    assert_refused::<Sphere>(
        "7",
        "invalid type: integer `7`, expected struct Sphere at line 1 column 1",
    );
}
