//! Tests of the error messages for invalid texts: file, line, field, value, and the rule for valid
//! values.

use std::path::Path;

use pinhole_core::Camera;
use pinhole_exchange::format::ExportScene;
use pinhole_exchange::format::Input;
use pinhole_exchange::programs::{FORMATS, UNKNOWN};

use super::{Importer, read};

#[test]
fn faults_name_place_field_and_what_would_be_right() {
    let cases = [
        (
            Importer::Literal,
            "gluLookAt(1,2,3, 1,2,3, 0,1,0);",
            "in: literal numbers: eye and at are the same point (1, 2, 3): move one of them",
        ),
        (
            Importer::Gltf,
            "{\"asset\": {}, \"cameras\": [{\"perspective\": {\"yfov\": 4}}],\n \"nodes\": [{\"camera\": 0}]}",
            "in:1:44: cameras[0].perspective.yfov is 4: it must be between 0 and pi, in radians",
        ),
        (
            Importer::Gltf,
            "{\"asset\": {}, \"cameras\": [], \"nodes\": [{\"camera\": 3}]}",
            "in:1:41: nodes[0].camera is 3: it must be the number of one of the cameras",
        ),
        (
            Importer::Gltf,
            "{\"asset\": {\n\"version\": 2",
            "in:2:12: no JSON: the text ends inside an object: is all of the file there?",
        ),
    ];
    for (importer, text, message) in cases {
        let error = read(importer, text).map(|taken| taken.camera).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

/// The kind of a text is detected from its content or, for glTF, from the file's extension. For texts
/// of unsupported kinds, the message lists the supported ones.
#[test]
fn what_is_no_camera_is_recognised_as_none() {
    for text in [
        "",
        "hello",
        "{}",
        "<html/>",
        "K = 3",
        "eye = [0, 0, 0]",
        "gluPerspective(60, 1, 0.1, 9);",
        "camera { location <0, 1, -9> look_at <0, 0, 0> }",
        "LookAt 0 0 0 0 0 1 0 1 0\nCamera \"perspective\"",
        "<scene version=\"3.0.0\"><sensor type=\"perspective\"><lookAt origin=\"1,2,3\"/></sensor></scene>",
        "{\"object\": {\"type\": \"PerspectiveCamera\", \"matrix\": [1]}}",
        "const camera = new THREE.PerspectiveCamera(50, 1.5);\ncamera.lookAt(0, 0.5, 0);",
        "PerspectiveCamera(Vec3(0,0,0), Vec3(0,0,-1), Vec3(0,1,0), 1, 10, 10)",
        "1 PINHOLE 400 300 400 400 200 150\n1 1 0 0 0 0 0 0 1 a.png\n",
    ] {
        assert_eq!(Importer::of(text), None, "{text}");
    }
    let of = |name: &str| {
        let text = Input { path: Path::new(name), text: "nothing" };
        Importer::of_file(&text).map_err(|error| error.to_string())
    };
    let many = "1, ".repeat(100_000);
    let large = Input { path: Path::new("in"), text: &many };
    let told =
        "no glTF, and too large for numbers: at most 128 KiB are read. Give the camera alone";
    assert_eq!(Importer::of_file(&large).unwrap_err().problem, told);
    for ending in ["py", "json", "txt", "cc", "c", "xml", "jl", "pov", "pbrt"] {
        assert_eq!(of(&format!("a.{ending}")), Err(format!("a.{ending}: {UNKNOWN}")));
    }
    assert_eq!(of("a.gltf"), Ok(Importer::Gltf));
    assert_eq!(of("a.glb"), Ok(Importer::Gltf));
}

/// No damaged text makes a reader panic: exports that are cut off, and exports in which a byte or a
/// number is missing or replaced.
#[test]
fn broken_texts_are_errors() {
    for (_, document) in super::proofs() {
        for format in &FORMATS {
            let subject = ExportScene::new(&document, Default::default()).unwrap();
            let Ok(written) = format.write(&subject) else { continue };
            let text = written.text.text;
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
                    for importer in [Importer::Gltf, Importer::Literal] {
                        let input = Input { path: Path::new("in"), text: &broken };
                        if let Ok(taken) = importer.read(&input, &Camera::CANONICAL) {
                            assert!(taken.camera.resolve().is_ok());
                        }
                    }
                }
            }
        }
    }
}
