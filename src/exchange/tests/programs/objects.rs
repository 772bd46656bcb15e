//! Objects of other people's scenes: put where they belong, or left out with a note, and never in the
//! camera's way.

use pinhole_core::{Camera, DVec3};
use pinhole_exchange::format::Include;

use super::{format, read, scene_of};

/// A right-handed camera, so that no z is turned.
const CAMERA: &str = "camera { location <0, 0, 9> right <1, 0, 0> up <0, 1, 0> direction <0, 0, -1> } \
                      // +W10 +H10\n";

fn povray(objects: &str) -> (Vec<([f64; 3], f64)>, Vec<String>) {
    let taken = read("povray", &format!("{CAMERA}{objects}")).unwrap();
    let spheres = taken.spheres.iter();
    let spheres = spheres.map(|item| (item.shape.center.to_array(), item.shape.radius)).collect();
    (spheres, taken.notes)
}

#[test]
fn pov_ray_s_steps_move_an_object_one_after_the_other() {
    for (object, expected) in [
        ("sphere { <1, 2, 3>, 2 translate <1, 0, 0> scale 2 }", ([4.0, 4.0, 6.0], 4.0)),
        ("sphere { <1, 2, 3> 2 scale 2 translate x*3 }", ([5.0, 4.0, 6.0], 4.0)),
        ("sphere { <1, 2, 3>, 0.5 rotate y*90 }", ([3.0, 2.0, -1.0], 0.5)),
        ("sphere { <1, 2, 3>, 0.5 rotate <90, 0, 90> }", ([3.0, 1.0, 2.0], 0.5)),
        (
            "sphere { <1, 2, 3>, 0.5 matrix <0, 1, 0, 1, 0, 0, 0, 0, 1, 5, 6, 7> }",
            ([7.0, 7.0, 10.0], 0.5),
        ),
        ("sphere { <1, 2, 3>, 1 texture { pigment { Red } scale 9 } }", ([1.0, 2.0, 3.0], 1.0)),
    ] {
        let (spheres, notes) = povray(object);
        assert_eq!((spheres, notes), (vec![expected], Vec::new()), "{object}");
    }
    let apart = "it must be taken apart: translate, scale, rotate or matrix by itself";
    for (moved, said) in [
        (
            "transform { rotate 90*y inverse }",
            format!("transform is {{ rotate 90*y inverse }}: {apart}"),
        ),
        ("transform Mine", format!("transform is Mine: {apart}")),
        ("matrix <1, 0, 0>", "matrix is <1, 0, 0>: it must be twelve numbers".to_owned()),
        ("scale Big", "scale is Big: it must be a vector of numbers, as <1, 2, 3>".to_owned()),
        ("#if (1) scale 2 #end", "object is if: no directive must stand in it".to_owned()),
    ] {
        let (spheres, notes) = povray(&format!("sphere {{ <1, 2, 3>, 2 {moved} }}"));
        assert_eq!(spheres, []);
        assert_eq!(notes, [format!("1 of sphere left out: line 2: {said}")]);
    }
    let (spheres, notes) = povray("sphere { <1, 2, 3>, 2 scale <1, 2, 1> }");
    assert_eq!(spheres, []);
    let said =
        "line 2: sphere is <1, 2, 3>, 2 scale <1, 2, 1>: it must not be scaled to an ellipsoid";
    assert_eq!(notes, [format!("1 of sphere left out: {said}")]);
    let taken =
        read("povray", &format!("{CAMERA}plane {{ y, 2 rotate -90*x translate <0, 0, 3> }}"));
    let plane = taken.unwrap().planes[0].shape;
    let z = plane.normal.z;
    assert_eq!((plane.normal, z.abs()), (DVec3::new(0.0, 0.0, z), 1.0));
    assert!([1.0, -1.0].contains(&plane.point.z), "{}", plane.point);
}

#[test]
fn parts_of_objects_declarations_and_conditions_are_no_objects() {
    let (spheres, notes) = povray(
        "#declare R = 1\nsphere { <1, 1, 1>, 1 }\n#declare Ball = sphere { <0, 0, 0>, 1 }\n\
         #if (clock < 2)\nsphere { <2, 2, 2>, 1 }\n#else #if (a > b) #end sphere { 0, 1 }\n#end\n\
         difference { sphere { <0, 0, 0>, 1 } box { <0, 0, 0>, <1, 1, 1> } }\n\
         union { sphere { <0, 0, 0>, 1 } plane { y, 0 } }\nblob { sphere { <0, 0, 0>, 1, 1 } }\n\
         light_source { <0, 9, 0> looks_like { sphere { <0, 0, 0>, 1 } } }\nsphere { <3, 3, 3>, 1 }",
    );
    assert_eq!(spheres, [([1.0; 3], 1.0), ([3.0; 3], 1.0)]);
    assert_eq!(
        notes,
        [
            "1 of difference left out with its parts: Pinhole has whole spheres and planes",
            "1 of union left out with its parts: Pinhole has whole spheres and planes",
            "1 of blob left out with its parts: Pinhole has whole spheres and planes",
            "what #declare names is left out: an object must stand by itself",
            "what stands between #if, #while, #for, #switch or #macro and #end is left out",
        ]
    );
}

#[test]
fn an_object_that_cannot_be_read_leaves_the_camera() {
    let (spheres, notes) =
        povray("sphere { <0, 0, 0>, R }\nsphere { <1, 1, R>, 1 } sphere { <1, 1, 1>, 1 }");
    assert_eq!(spheres, [([1.0; 3], 1.0)]);
    assert!(
        notes[0].starts_with("2 of sphere left out: line 2: sphere is <0, 0, 0>, R: "),
        "{notes:?}"
    );
    let pbrt = "Camera \"perspective\"\nShape \"sphere\" \"float radius\" -1\n\
                Scale 1 2 1\nShape \"sphere\"\n";
    assert_eq!(
        read("pbrt", pbrt).unwrap().notes[1..3],
        [
            "1 of sphere left out: line 2: radius is -1: it must be greater than 0",
            "1 of sphere left out: scaled to an ellipsoid"
        ]
    );
    let mitsuba = "<scene version=\"3.0.0\"><default name=\"fov\" value=\"40\"/><sensor \
                   type=\"perspective\"><float name=\"fov\" value=\"$fov\"/></sensor>\
                   <shape type=\"sphere\"><float name=\"radius\" value=\"$r\"/></shape></scene>";
    let taken = read("mitsuba", mitsuba).unwrap();
    assert!((taken.camera.viewport.horizontal_fov().to_degrees() - 40.0).abs() < 1e-12);
    assert_eq!(taken.notes, ["1 of shape left out: line 1: value is \"$r\": it must be numbers"]);
}

#[test]
fn pov_ray_s_lens_is_left_out_and_what_moves_its_camera_refused() {
    let camera = |more: &str| {
        read("povray", &CAMERA.replacen("<0, 0, -1>", &format!("<0, 0, -1> {more}"), 1))
    };
    let taken =
        camera("focal_point <0, 0, 1> blur_samples 10 confidence 0.9 variance 1/128").unwrap();
    assert_eq!(taken.notes, ["lens blur is left out: a pinhole is sharp everywhere"]);
    assert_eq!(taken.camera.viewport.distance, 1.0);
    let bent = camera("normal { bumps 0.1 }").unwrap();
    assert_eq!(bent.notes, ["the camera's normal is left out: a pinhole's rays are straight"]);
    for (more, message) in [
        ("scale 2", "scale is 2: the camera must be given without it"),
        ("translate 2*x", "translate is 2*x: the camera must be given without it"),
    ] {
        assert_eq!(camera(more).unwrap_err().problem, message);
    }
    let declared = format!("#declare Mine = {CAMERA}camera {{ Mine }}");
    assert_eq!(read("povray", &declared).unwrap().camera.eye, DVec3::new(0.0, 0.0, 9.0));
    let named = |color: &str| {
        let text = format!("{CAMERA}sphere {{ <0, 0, 0>, 1 pigment {{ {color} }} }}");
        let taken = read("povray", &text).unwrap();
        (taken.spheres[0].color, taken.notes.len())
    };
    assert_eq!(named("Red"), (Some([255, 0, 0]), 0));
    assert_eq!(named("color rgb <0, 1, 1>"), (Some([0, 255, 255]), 0));
    assert_eq!(named("rgbf 1"), (Some([255; 3]), 0));
    assert_eq!(named("Feldspar"), (None, 1));
}

/// It took time that grows with the square of the text.
#[test]
fn what_is_never_closed_ends() {
    assert!(read("povray", &"camera {".repeat(100_000)).is_err());
}

/// Where a form gives a ratio and no size, pixels are square.
#[test]
fn a_ratio_alone_makes_square_pixels() {
    for (ratio, size) in [
        ("4.0f / 3.0f", (400, 300)),
        ("16.0 / 9.0", (640, 360)),
        ("1.7777778", (640, 360)),
        ("2.0", (800, 400)),
    ] {
        let text = format!(
            "glm::perspective(glm::radians(45.0f), {ratio}, 0.1f, 100.0f);\n\
             glm::lookAt(glm::vec3(4, 3, 3), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0));"
        );
        let Camera { image, .. } = read("opengl", &text).unwrap().camera;
        assert_eq!((image.width(), image.height()), size, "{ratio}");
    }
    let text = "gluPerspective(45, 4.0f / 3.0f, 0.1, 100);\ngluLookAt(4, 3, 3, 0, 0, 0, 0, 1, 0);";
    let scene = scene_of(read("opengl", text).unwrap().camera);
    let subject = pinhole_exchange::format::ExportScene::new(&scene, Include::CameraAlone).unwrap();
    assert!(format("weekend").write(&subject).is_ok());
}
