//! Tests of reading cameras from glTF, JSON and binary, and of rejecting invalid trees of nodes.

use std::path::Path;

use pinhole_core::{DVec3, OrientationKind};
use pinhole_exchange::document::Document;
use pinhole_exchange::format::Imported;
use pinhole_exchange::programs::file_text;

use super::{FileError, Importer, proofs, scene_of, text_of};

fn read(text: &str) -> Result<Imported, FileError> {
    super::read(Importer::Gltf, text)
}

const CAMERAS: &str = r#""cameras": [
    {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "zfar": 100, "znear": 0.01}},
    {"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1, "znear": 0.01}}]"#;

fn gltf(more: &str, nodes: &str) -> String {
    format!("{{\"asset\": {{\"version\": \"2.0\"}}, {more}\n{CAMERAS},\n\"nodes\": [{nodes}]}}")
}

#[track_caller]
fn assert_taken(text: &str, eye: [f64; 3], said: &[&str]) {
    let taken = read(text).unwrap();
    assert_eq!(taken.camera.eye, DVec3::from_array(eye), "{text}");
    let unsaid = |note: &&String| !note.starts_with("glTF does not say how many pixels");
    assert_eq!(taken.notes.iter().filter(unsaid).collect::<Vec<_>>(), said, "{text}");
}

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    assert_eq!(read(text).unwrap_err().to_string(), message);
}

#[test]
fn the_first_perspective_camera_is_taken() {
    let two = r#"{"name": "near", "translation": [1, 0, 0], "camera": 1}, {"translation": [5, 0, 3], "camera": 1}"#;
    assert_taken(
        &gltf("", two),
        [1.0, 0.0, 0.0],
        &["node \"near\" is taken; 1 more camera is left out"],
    );
    let ortho = r#"{"rotation": [-0.383, 0, 0, 0.924], "camera": 0}, {"translation": [0.5, 0.5, 3.0], "camera": 1}"#;
    assert_taken(
        &gltf("", ortho),
        [0.5, 0.5, 3.0],
        &["nodes[1] is taken; 1 more camera is left out"],
    );
    assert_refused(
        &gltf("", r#"{"camera": 0}"#),
        "in: cameras[0].perspective is missing: the camera must be a perspective one",
    );
}

#[test]
fn a_ring_of_nodes_and_two_parents_are_refused() {
    for (nodes, message) in [
        (
            r#"{"children": [1]}, {"children": [0], "camera": 1}"#,
            "nodes[0] is below itself: it must be no child of it",
        ),
        (
            r#"{"children": [0], "camera": 1}"#,
            "nodes[0] is below itself: it must be no child of it",
        ),
        (
            r#"{"children": [2]}, {"children": [2]}, {"camera": 1}"#,
            "nodes[2] must be a child of one node only",
        ),
    ] {
        assert_eq!(read(&gltf("", nodes)).unwrap_err().problem, message);
    }
}

/// Tests long chains and a cycle of nodes. A recursive reader would overflow the stack; a naive one
/// would take time quadratic in the number of nodes.
#[test]
fn long_chains_and_rings_end() {
    let many = 100_000;
    let step = |k: usize| format!("{{\"children\": [{}], \"translation\": [0, 0, 1]}}", k + 1);
    let chain: Vec<String> = (0..many).map(step).collect();
    let chain = chain.join(", ");
    let scene = "\"scenes\": [{\"nodes\": [0]}],";
    assert_taken(&gltf(scene, &format!("{chain}, {{\"camera\": 1}}")), [0.0, 0.0, 1e5], &[]);
    let ring = gltf(scene, &format!("{chain}, {{\"camera\": 1, \"children\": [0]}}"));
    assert!(read(&ring).unwrap_err().problem.contains("is below itself"));

    let deep = format!("{{\"object\": {}{}}}", "{\"children\": [".repeat(many), "]}".repeat(many));
    let error = read(&deep).unwrap_err();
    assert!(error.problem.starts_with("no glTF with a camera: nodes is missing"), "{error}");
}

/// A node takes a hundred times its text.
#[test]
fn a_text_with_very_many_values_is_refused() {
    let many = gltf("", &format!("{}{{\"camera\": 1}}", "{},".repeat(1_000_000)));
    let problem = "it has more than 1000000 values: export the camera alone, without objects";
    assert_eq!(read(&many).unwrap_err().problem, problem);
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let text = text_of("gltf", &Document::default());
    let marked = format!("\u{feff}{text}");
    assert_eq!(Importer::of(&marked), Some(Importer::Gltf));
    assert_eq!(read(&marked), read(&text));
    assert_refused("\u{feff}{\"nodes\": x}", "in:1:11: no JSON: a value must stand here");
}

/// Words such as *f64*, *sequence* and *map* are those of programmers.
#[test]
fn values_of_a_wrong_kind_are_told_in_plain_words() {
    for (nodes, problem) in [
        (r#"{"camera": "1"}"#, "string \"1\" is there: it must be a whole number from 0"),
        (r#"{"camera": -1}"#, "integer -1 is there: it must be a whole number from 0"),
        (r#"{"camera": 0.5}"#, "number 0.5 is there: it must be a whole number from 0"),
        (r#"{"name": []}"#, "a list is there: it must be text in quotes"),
        (r#"{"children": {}}"#, "an object is there: it must be a list"),
        ("7", "integer 7 is there: it must be an object"),
        (r#"{"matrix": [1, 2]}"#, "a list of length 2 is there: it must be an array of length 16"),
        (
            r#"{"translation": [1, 2]}"#,
            "a list of length 2 is there: it must be a list of 3 numbers",
        ),
        (r#"{"rotation": [1, 2, 3, true]}"#, "boolean true is there: it must be a number"),
    ] {
        let error = read(&gltf("", nodes)).unwrap_err();
        assert_eq!(error.problem, format!("no glTF with a camera: {problem}"), "{nodes}");
    }
    let long = gltf("", &format!("{{\"camera\": \"{}\"}}", "a".repeat(100_000)));
    assert!(read(&long).unwrap_err().problem.len() < 200);
    let empty = gltf("", "").replace(r#""perspective": {"yfov": 0.7,"#, r#""perspective": {"#);
    assert_eq!(read(&empty).unwrap_err().problem, "no glTF with a camera: yfov is missing");
}

#[test]
fn places_in_json_are_characters_counted_from_one() {
    for (text, message) in [
        ("", "in:1:1: no JSON: the text ends inside a value: is all of the file there?"),
        ("{\"é\": 1, x}", "in:1:10: no JSON: key must be a string"),
        ("{\n  \"a\": 1,\n  é\n}", "in:3:3: no JSON: key must be a string"),
    ] {
        assert_refused(text, message);
    }
}

#[test]
fn a_camera_by_rotation_in_a_parent() {
    let text = r#"{"asset": {"version": "2.0"}, "cameras": [{"type": "perspective",
        "perspective": {"yfov": 1.0, "znear": 0.1, "aspectRatio": 2}}],
        "nodes": [{"children": [1], "translation": [1, 0, 0]},
        {"camera": 0, "translation": [0, 2, 0], "scale": [3, 3, 3],
         "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]}]}"#;
    let Imported { camera, notes } = read(text).unwrap();
    assert_eq!(camera.eye, DVec3::new(1.0, 2.0, 0.0));
    assert!((camera.resolve().unwrap().basis().w - DVec3::X).length() < 1e-12);
    assert_eq!((camera.image.width(), camera.image.height()), (800, 400));
    assert_eq!(notes, ["glTF does not say how many pixels there are: 800 × 400 taken"]);
}

/// A camera that is written as glTF and read back is the same: its pose to the bit, its viewport up to
/// a few rounding errors.
#[test]
fn what_is_written_is_read_back() {
    for (name, document) in proofs() {
        let camera = document.camera.given_by(OrientationKind::Basis).unwrap();
        let back = read(&text_of("gltf", &scene_of(camera))).unwrap().camera;
        assert_eq!((back.eye, back.orientation), (camera.eye, camera.orientation), "{name}");
        let ([a, b], image) = ([back, camera].map(|camera| camera.viewport), camera.image);
        assert_eq!((back.image, a.distance), (image, b.distance), "{name}");
        assert!((a.width - b.width).abs().max((a.height - b.height).abs()) < 1e-12, "{name}");
    }
}

fn text(bytes: &[u8]) -> Result<String, String> {
    file_text(Path::new("in"), bytes.to_owned()).map_err(|error| error.to_string())
}

/// Returns a binary glTF that consists of this JSON and a chunk of vertices.
fn binary(json: &str) -> Vec<u8> {
    let padded = format!("{json}{}", " ".repeat(json.len().next_multiple_of(4) - json.len()));
    let mut chunks = Vec::new();
    for (kind, chunk) in [(b"JSON", padded.as_bytes()), (b"BIN\0", &[0xff; 8])] {
        chunks.extend((chunk.len() as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(chunk);
    }
    let length = 12 + chunks.len() as u32;
    [b"glTF", &2_u32.to_le_bytes()[..], &length.to_le_bytes(), &chunks].concat()
}

#[test]
fn a_binary_gltf_is_the_camera_of_its_json() {
    for (name, document) in proofs() {
        let json = text_of("gltf", &document);
        let taken = text(&binary(&json)).unwrap();
        assert_eq!(taken.trim_end(), json.trim_end());
        let [own, other] = [&json, &taken].map(|json| read(json).unwrap().camera);
        assert_eq!(own, other, "{name}");
    }
}

#[test]
fn a_damaged_binary_gltf_is_told() {
    let whole = binary(&text_of("gltf", &Document::default()));
    let count = whole.len();
    let json = u32::from_le_bytes(*whole[12..].first_chunk().unwrap());
    let with = |at: usize, bytes: &[u8]| {
        let mut other = whole.clone();
        other[at..at + bytes.len()].copy_from_slice(bytes);
        other
    };
    let there = "are there: is all of the file there?";
    for (damaged, said) in [
        (
            whole[..19].to_owned(),
            format!("the header with that of the JSON is 20 bytes, and 19 {there}"),
        ),
        (
            whole[..count - 1].to_owned(),
            format!("the length is {count} bytes, and {} {there}", count - 1),
        ),
        (
            with(12, &u32::MAX.to_le_bytes()),
            format!("the JSON is {} bytes, and {} {there}", u32::MAX, count - 20),
        ),
        (with(4, &[1]), "the version is 1: it must be 2".to_owned()),
        (with(16, b"BIN\0"), "the first chunk's type is BIN\\x00: it must be JSON".to_owned()),
        (with(24, &[0xff]), "the JSON must be UTF-8".to_owned()),
    ] {
        assert_eq!(text(&damaged).unwrap_err(), format!("in: binary glTF: {said}"));
    }
    // Where it says that it has less JSON, the JSON's own fault is told.
    let cut = text(&with(12, &(json / 2).to_le_bytes())).unwrap();
    assert!(read(&cut).unwrap_err().problem.contains("is all of the file there?"));
    for end in 4..count {
        assert!(text(&whole[..end]).is_err());
    }
}

#[test]
fn what_is_not_utf_8_is_refused() {
    let scene = "1 2 3 0 0 0 0 1 0 # Gr\u{fc}n";
    assert_eq!(text(scene.as_bytes()), Ok(scene.to_owned()));
    let latin: Vec<u8> = scene.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let no_text = "in: not text: a camera is read from text in UTF-8";
    // A picture, UTF-16 and Latin-1.
    for bytes in [&b"\x89PNG\r\n\x1a\n"[..], b"\xff\xfec\0a\0", &latin] {
        assert_eq!(text(bytes), Err(no_text.to_owned()));
    }
}
