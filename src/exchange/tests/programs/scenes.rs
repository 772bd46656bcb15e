//! Scenes of pbrt and Mitsuba as people have them: old spellings, groups, instances, parts of pictures.

use pinhole_core::DVec3;
use pinhole_exchange::FileError;

use super::read;

const LOOK: &str = "LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 30\n\
                    Film \"rgb\" \"integer xresolution\" 60 \"integer yresolution\" 40\n";

fn pbrt(film: &str, world: &str) -> (Vec<[f64; 3]>, Vec<String>) {
    let text = format!("Scale -1 1 1\n{LOOK}{film}\nWorldBegin\n{world}");
    let taken = read("pbrt", &text).unwrap();
    let spheres = taken.spheres.iter().map(|item| item.shape.center.to_array()).collect();
    (spheres, taken.notes)
}

fn mitsuba(version: &str, fov_axis: &str, to_world: &str, more: &str) -> String {
    format!(
        "<scene version=\"{version}\"><sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/>\
         <string name=\"{fov_axis}\" value=\"smaller\"/><transform name=\"{to_world}\">\
         <lookat origin=\"278, 273, -800\" target=\"278, 273, -799\" up=\"0, 1, 0\"/></transform>\
         <film type=\"hdrfilm\"><integer name=\"width\" value=\"512\"/>\
         <integer name=\"height\" value=\"256\"/></film></sensor>{more}</scene>"
    )
}

fn perspective(more: &str) -> String {
    mitsuba("3.0.0", "fov_axis", "to_world", more)
}

#[test]
fn mitsuba_s_old_spelling_is_read_too() {
    for (version, fov_axis, to_world) in
        [("0.5.0", "fovAxis", "toWorld"), ("0.6.0", "fov_axis", "to_world")]
    {
        let sphere = "<shape type=\"sphere\"><transform name=\"toWorld\"><translate x=\"100\"/></transform></shape>";
        let taken = read("mitsuba", &mitsuba(version, fov_axis, to_world, sphere)).unwrap();
        assert_eq!(taken.camera.eye, DVec3::new(278.0, 273.0, -800.0));
        assert!((taken.camera.viewport.vertical_fov().to_degrees() - 40.0).abs() < 1e-12);
        assert_eq!(taken.spheres[0].shape.center, DVec3::new(100.0, 0.0, 0.0));
        assert_eq!(taken.notes, [""; 0]);
    }
    let camel = mitsuba("0.5.0", "fovAxis", "toWorld", "").replace("lookat", "lookAt");
    assert_eq!(read("mitsuba", &camel).unwrap().camera.eye.z, -800.0);
    // Old versions do not agree where a scaled sphere's centre lies.
    let scaled = "<shape type=\"sphere\"><point name=\"center\" x=\"1\"/><transform name=\"toWorld\">\
                  <scale value=\"2\"/></transform></shape>";
    let taken = read("mitsuba", &mitsuba("0.5.0", "fovAxis", "toWorld", scaled)).unwrap();
    assert_eq!((taken.spheres.len(), taken.notes.len()), (0, 1));
}

/// A lens stands before a film of 36 mm by 24 mm, whose diagonal is the picture's.
#[test]
fn mitsuba_s_lens_is_read_and_is_50_mm_where_nothing_is_said() {
    let fov = "<float name=\"fov\" value=\"40\"/>";
    let with = |lens: &str| {
        let taken = read("mitsuba", &perspective("").replace(fov, lens))?;
        let viewport = taken.camera.viewport;
        assert!((viewport.width / viewport.height - 2.0).abs() < 1e-12);
        let diagonal = viewport.width.hypot(viewport.height) / viewport.distance;
        Ok::<_, FileError>((36_f64.hypot(24.0) / diagonal, taken.notes))
    };
    let lens = |value: &str| format!("<string name=\"focal_length\" value=\"{value}\"/>");
    for (given, millimetres) in [("35mm", 35.0), ("85.5 mm", 85.5), ("50", 50.0)] {
        let (length, notes) = with(&lens(given)).unwrap();
        assert!((length - millimetres).abs() < 1e-12, "{given}: {length}");
        assert_eq!(notes, [""; 0]);
    }
    let (length, notes) = with("").unwrap();
    assert!((length - 50.0).abs() < 1e-12, "{length}");
    assert_eq!(notes, ["fov is not given: focal_length 50mm, which is Mitsuba's own, taken"]);
    for (given, said) in [
        (lens("0mm"), "focal_length is \"0mm\": it must be millimetres greater than 0, as 50mm"),
        (lens("wide"), "focal_length is \"wide\": it must be millimetres greater than 0, as 50mm"),
        (lens("35mm") + fov, "focal_length is 35mm: fov is given too: only one of them may be"),
    ] {
        assert_eq!(with(&given).unwrap_err().problem, said);
    }
}

#[test]
fn mitsuba_s_groups_instances_and_other_files_are_told() {
    let sphere = "<shape type=\"sphere\"/>";
    let obj = "<shape type=\"obj\"/>";
    let square = "<shape type=\"rectangle\"/>";
    let group = format!("<shape type=\"shapegroup\" id=\"g\">{sphere}{sphere}</shape>");
    let instance = "<shape type=\"instance\"><ref id=\"g\"/></shape>";
    let more = format!(
        "{group}{instance}{obj}{square}{obj}{square}{obj}<include filename=\"a.xml\"/>{sphere}\
         <sensor type=\"orthographic\"/>"
    );
    let taken = read("mitsuba", &perspective(&more)).unwrap();
    assert_eq!((taken.spheres.len(), taken.planes.len()), (1, 2));
    assert_eq!(
        taken.notes,
        [
            "1 of sensor left out: the first is taken",
            "1 of shapegroup left out with its parts: Pinhole has whole spheres and planes",
            "1 of instance left out: an object must stand by itself",
            "3 of obj left out: Pinhole has spheres and planes",
            "2 of rectangle taken as a plane, which has no end",
            "1 of include left out: what is in other files is not read",
        ]
    );
    let flat =
        "<shape type=\"disk\"><transform name=\"to_world\"><scale x=\"0\"/></transform></shape>";
    let taken = read("mitsuba", &perspective(flat)).unwrap();
    assert_eq!((taken.planes.len(), taken.notes.len()), (0, 1), "{:?}", taken.notes);
}

#[test]
fn mitsuba_s_film_and_colours_are_found_by_reference_and_a_crop_is_told() {
    let crop = |width: u32| {
        let crop = format!(
            "<integer name=\"crop_width\" value=\"{width}\"/><integer name=\"crop_height\" value=\"256\"/>\
             <integer name=\"crop_offset_x\" value=\"0\"/></film>"
        );
        read("mitsuba", &perspective("").replace("</film>", &crop)).unwrap()
    };
    assert_eq!(crop(512).notes, [""; 0]);
    assert_eq!(
        crop(128).notes,
        ["the film's crop is left out: the whole image, 512 × 256, is taken"]
    );
    let text = "<scene version=\"3.0.0\"><film type=\"hdrfilm\" id=\"f\"><integer name=\"width\" value=\"30\"/>\
                <integer name=\"height\" value=\"20\"/></film><sensor type=\"perspective\"><float name=\"fov\" \
                value=\"40\"/><ref id=\"f\"/></sensor><bsdf type=\"diffuse\" id=\"red\"><rgb name=\"reflectance\" \
                value=\"1 0 0\"/></bsdf><bsdf type=\"conductor\" id=\"gold\"/>\
                <shape type=\"sphere\"><ref id=\"red\"/></shape><shape type=\"sphere\"><ref id=\"gold\"/></shape>\
                </scene>";
    let taken = read("mitsuba", text).unwrap();
    assert_eq!([taken.camera.image.width(), taken.camera.image.height()], [30, 20]);
    assert_eq!(taken.spheres[0].color, Some([255, 0, 0]));
    assert_eq!(taken.notes, ["1 of bsdf left out: a colour must be rgb"]);
}

#[test]
fn mitsuba_s_defaults_stand_for_whole_values() {
    let fov = |value: &str| {
        let defaults =
            "<default name=\"f\" value=\"35.5\"/><default name=\"g\" value=\"$f\"/><sensor";
        let text = perspective("").replace("<sensor", defaults);
        let taken = read("mitsuba", &text.replace("value=\"40\"", &format!("value=\"{value}\"")));
        taken.map(|taken| taken.camera.viewport.vertical_fov().to_degrees())
    };
    for value in ["$f", "$g"] {
        assert!((fov(value).unwrap() - 35.5).abs() < 1e-12);
    }
    for value in ["$h", "$f5", "$$f"] {
        let problem = fov(value).unwrap_err().problem;
        assert_eq!(problem, format!("value is {value:?}: it must be numbers"));
    }
    // What is made of itself, or of more and more.
    let own = "<default name=\"b\" value=\"$b$b\"/>".repeat(19);
    assert!(read("mitsuba", &perspective(&own)).is_ok());
}

#[test]
fn pbrt_s_objects_stand_where_they_belong_or_are_told() {
    let (spheres, notes) = pbrt(
        "",
        "ObjectBegin \"ball\"\n Translate 1 1 1\n Shape \"sphere\"\nObjectEnd\n\
         AttributeBegin\n Translate 5 0 0\n ObjectInstance \"ball\"\nAttributeEnd\n\
         AttributeBegin\n CoordSysTransform \"camera\"\n Translate 0 0 3\n Shape \"sphere\"\nAttributeEnd\n\
         Shape \"disk\"\nReverseOrientation\nShape \"cone\"\nInclude \"more.pbrt\"\nShape \"disk\"\n\
         Shape \"sphere\" \"float zmin\" [0]\nShape \"sphere\" \"float zmin\" -1 \"float zmax\" 1\n",
    );
    // Three in front of the eye at z = 5; and the one whose zmin and zmax leave it whole.
    assert_eq!(spheres, [[0.0, 0.0, 2.0], [0.0; 3]]);
    assert_eq!(
        notes,
        [
            "1 of ObjectBegin left out with its parts: an object must stand by itself",
            "1 of ObjectInstance left out: an object must stand by itself",
            "2 of disk left out: Pinhole has spheres and planes",
            "1 of cone left out: Pinhole has spheres and planes",
            "1 of Include left out: what is in other files is not read",
            "1 of sphere left out with zmin, zmax or phimax: Pinhole has whole spheres",
        ]
    );
    let (spheres, _) = pbrt(
        "",
        "Translate 1 2 3\nCoordinateSystem \"mine\"\nTranslate 9 9 9\nCoordSysTransform \"mine\"\n\
         Shape \"sphere\"\nCoordSysTransform \"world\"\nShape \"sphere\"",
    );
    assert_eq!(spheres, [[1.0, 2.0, 3.0], [0.0; 3]]);
    for (world, said) in [
        (
            "CoordSysTransform \"lamp\"",
            "CoordSysTransform: it must be camera, world, or named by CoordinateSystem before it",
        ),
        ("Shear 1 2 3", "Shear: no directive of pbrt"),
        (
            "ActiveTransform EndTime",
            "ActiveTransform is EndTime: it must be All: nothing must move while the shutter is open",
        ),
        (
            "Attribute \"shape\" \"float radius\" 2",
            "Attribute: a sphere's parameters must stand in its Shape",
        ),
        ("Shape \"sphere\" \"float radius\" [ 1", "a list is not closed: its ] is missing"),
    ] {
        let text = format!("{LOOK}WorldBegin\n{world}\nShape \"sphere\"");
        assert_eq!(read("pbrt", &text).unwrap_err().problem, said);
    }
}

#[test]
fn pbrt_s_film_is_told_where_its_size_is_not_given() {
    let camera = "Camera \"perspective\"\n";
    for (film, size, note) in [
        ("", [1280, 720], "xresolution and yresolution: 1280 × 720, as in pbrt, taken"),
        (
            "Film \"rgb\" \"integer xresolution\" 400",
            [400, 720],
            "yresolution: 400 × 720, as in pbrt, taken",
        ),
    ] {
        let taken = read("pbrt", &format!("{camera}{film}")).unwrap();
        assert_eq!([taken.camera.image.width(), taken.camera.image.height()], size);
        assert_eq!(taken.notes[0], format!("Film does not give {note}"));
    }
}

#[test]
fn pbrt_s_scene_without_motion_may_name_its_times() {
    let world = "ActiveTransform All\nTranslate 1 2 3\nShape \"sphere\"";
    assert_eq!(pbrt("TransformTimes 0 1", world), (vec![[1.0, 2.0, 3.0]], vec![]));
}

#[test]
fn pbrt_s_colours_are_found_by_name_and_the_others_told() {
    let world = "MakeNamedMaterial \"my red\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 0 0]\n\
                 MakeNamedMaterial \"gold\" \"string type\" \"conductor\"\n\
                 NamedMaterial \"my red\" Shape \"sphere\"\nNamedMaterial \"gold\" Shape \"sphere\"\n\
                 Material \"matte\" \"rgb Kd\" [0 1 0] Shape \"sphere\"\n\
                 Material \"diffuse\" \"texture reflectance\" \"checks\" Shape \"sphere\"\n";
    let taken = read("pbrt", &format!("{LOOK}WorldBegin\nShape \"sphere\"\n{world}")).unwrap();
    let colors: Vec<_> = taken.spheres.iter().map(|item| item.color).collect();
    assert_eq!(colors, [None, Some([255, 0, 0]), None, Some([0, 255, 0]), None]);
    assert_eq!(taken.notes[0], "2 of Material left out: a colour must be \"rgb reflectance\"");
}

#[test]
fn pbrt_s_camera_is_that_of_its_own_transformation() {
    let size = "Film \"rgb\" \"integer xresolution\" 60 \"integer yresolution\" 40";
    let part = format!("{size} \"float cropwindow\" [0.25 0.75 0 1]");
    let told = ["cropwindow is left out: the whole image, 60 × 40, is taken"];
    assert_eq!(pbrt(&part, "").1, told);
    assert_eq!(pbrt(&format!("{size} \"float cropwindow\" [0 1 0 1]"), "").1, [""; 0]);
    // A LookAt that is ended or replaced is none of the camera's.
    let camera = "Camera \"perspective\"";
    for (before, eye) in [
        (
            "Translate 0 0 7\nAttributeBegin\nLookAt 1 2 5 0 0 0 0 1 0\nAttributeEnd",
            [0.0, 0.0, 7.0],
        ),
        ("LookAt 1 2 5 0 0 0 0 1 0\nIdentity\nTranslate 0 0 7", [0.0, 0.0, 7.0]),
        ("LookAt 1 2 5 0 0 0 0 1 0\nIdentity", [0.0; 3]),
    ] {
        // A mirror of every z comes with each of these left-handed cameras.
        let taken = read("pbrt", &format!("{before}\n{camera}\n{size}")).unwrap();
        assert_eq!(taken.camera.eye.to_array(), eye, "{before}");
        assert_eq!(taken.notes.len(), 1, "{:?}", taken.notes);
    }
}
