//! Messages on faults of a text: file, line, field, value, what would be right.

use std::path::Path;
use std::time::{Duration, Instant};

use pinhole_core::Camera;
use pinhole_exchange::format::{Importer, Input};
use pinhole_exchange::programs::{FORMATS, IMPORTERS, importer_of, importer_of_file};

use super::read;

#[test]
fn faults_name_place_field_and_what_would_be_right() {
    let cases = [
        (
            "opengl",
            "gluPerspective(60, 1, 0.1, 9);\ngluLookAt(0,0,0, 0,0,x, 0,1,0);",
            "in:2:22: gluLookAt is x: it must be given by numbers, without names or calculations",
        ),
        (
            "opengl",
            "gluPerspective(190, 1, 0.1, 9);\ngluLookAt(0,0,0, 0,0,1, 0,1,0);",
            "in:1:16: fovy is 190: it must be between 0 and 180 degrees",
        ),
        (
            "opengl",
            "gluLookAt(0,0,0, 0,0,1, 0,1,0);",
            "in: gluPerspective is missing: fovy, aspect, zNear and zFar must be given by it",
        ),
        (
            "opengl",
            "gluPerspective(60, 1, 0.1, 9);\ngluLookAt(1,2,3, 1,2,3, 0,1,0);",
            "in: gluLookAt + gluPerspective: eye and at are the same point (1, 2, 3): move one of them",
        ),
        (
            "course",
            "PerspectiveCamera(Vec3(0,0,0), Vec3(0,0,-1), Vec3(0,1,0), -1, 10, 10)",
            "in:1:59: focal is -1: it must be greater than 0",
        ),
        (
            "povray",
            "camera {\n  location <0, 0, a>\n}",
            "in:2:19: location is a: it must be a finite number",
        ),
        (
            "povray",
            "camera { orthographic location <0, 0, 0> }",
            "in:1:10: the projection is orthographic: it must be perspective",
        ),
        (
            "pbrt",
            "LookAt 0 0 0 0 0 1 0 1\nCamera \"perspective\"",
            "in:1:1: LookAt has 8 numbers: it must have 9",
        ),
        (
            "pbrt",
            "LookAt 0 0 0 0 0 1 0 1 0\n\nCamera \"orthographic\"",
            "in:3:1: Camera is orthographic: it must be perspective",
        ),
        (
            "mitsuba",
            "<scene>\n<sensor type=\"perspective\">\n<float name=\"fov\" value=\"0\"/></sensor></scene>",
            "in:3:1: fov is 0: it must be between 0 and 180 degrees",
        ),
        (
            "mitsuba",
            "<scene><sensor type=\"orthographic\"/></scene>",
            "in:1:8: sensor's type is orthographic: it must be perspective",
        ),
        (
            "three",
            "{\"object\": {\"type\": \"PerspectiveCamera\",\n \"fov\": \"wide\"}}",
            "in:2:2: object.fov is \"wide\": it must be a finite number",
        ),
        (
            "gltf",
            "{\"asset\": {}, \"cameras\": [{\"perspective\": {\"yfov\": 4}}],\n \"nodes\": [{\"camera\": 0}]}",
            "in:1:44: cameras[0].perspective.yfov is 4: it must be between 0 and pi, in radians",
        ),
        (
            "gltf",
            "{\"asset\": {}, \"cameras\": [], \"nodes\": [{\"camera\": 3}]}",
            "in:1:41: nodes[0].camera is 3: it must be the number of one of the cameras",
        ),
        (
            "opencv",
            "K = [[1, 0, 5], [0, 1, 5]]\nR = [1,0,0,0,1,0,0,0,1]\nt = [0,0,0]",
            "in:1:5: K is [[1, 0, 5], [0, 1, 5]]: it must be 3 × 3 numbers",
        ),
        (
            "opencv",
            "K = [[1, 2, 5], [0, 1, 5], [0, 0, 1]]\nR = [1,0,0,0,1,0,0,0,1]\nt = [0,0,0]",
            "in:1:5: K is [[1, 2, 5], [0, 1, 5], [0, 0, 1]]: it must be fx 0 cx, 0 fy cy, 0 0 1 with fx \
             and fy greater than 0",
        ),
        (
            "opencv",
            "K = [[9, 0, 4.5], [0, 9, 4.5], [0, 0, 1]]\nR = [1,0,0,1,1,0,0,0,1]\nt = [0,0,0]",
            "in: R is no rotation: its axes are off a right angle by up to 0.7071: it must be a \
             rotation, without shear",
        ),
        (
            "colmap",
            "1 PINHOLE 400 300 400 400 200\n",
            "in: the line of images.txt is missing: 1 QW QX QY QZ TX TY TZ CAMERA_ID NAME",
        ),
        (
            "colmap",
            "1 PINHOLE 400 300 400 400 200\n1 1 0 0 0 0 0 0 1 a.png\n",
            "in:1:1: PINHOLE has 5 numbers: it must have 6",
        ),
        (
            "colmap",
            "1 FISHEYE 400 300 400 400 200\n1 1 0 0 0 0 0 0 1 a.png\n",
            "in:1:1: MODEL is FISHEYE: it must be one of SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, \
             RADIAL, OPENCV, FULL_OPENCV",
        ),
    ];
    for (format, text, message) in cases {
        let error = read(format, text).map(|taken| taken.camera).unwrap_err();
        assert_eq!(error.to_string(), message, "{format}");
    }
}

/// Texts for which a reader took a minute, as it held everything in them against everything else.
#[test]
fn a_text_of_many_parts_is_read_or_refused_in_no_time() {
    let attributes: String = (0..40_000).map(|k| format!(" a{k}=\"1\"")).collect();
    let spaces: String = (0..100).map(|k| format!("<a xmlns:a{k}=\"u{k}\"/>")).collect();
    let rotations = "{\"R\": 0}, ".repeat(20_000);
    let k = "{\"K\": [0]}, ".repeat(20_000);
    let escaped = "{\"\\u0052\": 0}, ".repeat(20_000);
    let cases = [
        (
            "mitsuba",
            format!("<scene>\n<sensor{attributes}/></scene>"),
            "in:2:1: there are too many attributes: at most 64 are read",
        ),
        (
            "mitsuba",
            format!("<scene><sensor/>{spaces}</scene>"),
            "in:1:1277: there are too many namespaces: at most 64 are read",
        ),
        (
            "mitsuba",
            format!("<scene><sensor/>{}", "<a>".repeat(100_000)),
            "in:1:206: there are too many nested elements: at most 64 are read",
        ),
        ("opencv", format!("[{rotations}{k}0]"), "in:1:200003: K is [0]: it must be 3 × 3 numbers"),
        ("opencv", format!("[{escaped}0]"), "in: K is missing: it must be nine numbers"),
    ];
    for (format, text, message) in cases {
        let begun = Instant::now();
        let error = read(format, &text).map(|taken| taken.camera).unwrap_err();
        assert_eq!(error.to_string(), message, "{format}");
        assert!(begun.elapsed() < Duration::from_secs(30), "{format}: {:?}", begun.elapsed());
    }
}

#[test]
fn a_text_that_is_cut_is_told_where_it_is_open() {
    let head = "<scene>\n<!-- <b> -->\n<sensor type=\"per>\"/>\n  <film><a></a>";
    let said = "is not closed: is all of the file there?";
    let cases = [
        ("mitsuba", head.to_owned(), format!("in:4:3: no XML: <film> {said}")),
        ("mitsuba", format!("{head}</film>"), format!("in:1:1: no XML: <scene> {said}")),
        ("mitsuba", format!("{head}<b c="), format!("in:4:3: no XML: <film> {said}")),
        (
            "gltf",
            "{\"asset\": {\n\"version\": 2".to_owned(),
            "in:2:12: no JSON: the text ends inside an object: is all of the file there?"
                .to_owned(),
        ),
    ];
    for (format, text, message) in cases {
        let error = read(format, &text).map(|taken| taken.camera).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

/// A format is known by what is in a text; where that does not tell, by the name.
#[test]
fn what_is_no_camera_is_recognised_as_none() {
    for text in ["", "hello", "{}", "<html/>", "[1, 2, 3]", "K = 3", "eye = [0, 0, 0]"] {
        assert!(importer_of(text).is_none(), "{text}");
    }
    let of = |name: &str| {
        let text = Input { path: Path::new(name), text: "nothing" };
        importer_of_file(&text).map(|format| format.name).map_err(|error| error.to_string())
    };
    // What may be anything is not told by its ending.
    for ending in ["py", "json", "txt", "cc", "c", "xml", "jl"] {
        let name = format!("a.{ending}");
        let refused = of(&name).unwrap_err();
        assert!(refused.starts_with(&format!("{name}: no camera of a known form: ")), "{refused}");
    }
    assert_eq!(of("a.pov"), Ok("povray"));
    assert_eq!(of("a.pbrt"), Ok("pbrt"));
    let refused = of("a.json").unwrap_err();
    assert!(
        refused.starts_with("a.json: no camera of a known form: it may be glTF 2.0, "),
        "{refused}"
    );
    assert!(IMPORTERS.iter().all(|importer| refused.contains(importer.label)), "{refused}");
}

/// No text makes a reader panic: beginnings of exports, and exports with a byte or a number gone, or
/// another one in its place.
#[test]
fn broken_texts_are_errors() {
    for (_, document) in super::proofs() {
        for format in &FORMATS {
            let subject =
                pinhole_exchange::format::ExportScene::new(&document, Default::default()).unwrap();
            let Ok(written) = format.write(&subject) else { continue };
            let text = written.joined().text;
            for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)).step_by(5) {
                let (head, tail) = text.split_at(end);
                let after = |from: usize| tail.get(from..).unwrap_or("");
                let comma = tail.find([',', ' ']).map_or(0, |at| at + 1);
                for broken in [
                    head.to_owned(),
                    format!("{head}{}", after(1)),
                    format!("{head}{}", after(comma)),
                    format!("{head}1e308{}", after(1)),
                    format!("{head} -0 {}", after(1)),
                ] {
                    let text = Input { path: Path::new("in"), text: &broken };
                    for reader in
                        [Importer::named(format.name), importer_of(&broken)].into_iter().flatten()
                    {
                        if let Ok(taken) = reader.read(&text, &Camera::CANONICAL) {
                            assert!(taken.camera.resolve().is_ok());
                        }
                    }
                }
            }
        }
    }
}
