//! The text in a file's bytes: binary glTF, UTF-8 and Latin-1.

use std::path::Path;

use pinhole_exchange::document::Document;
use pinhole_exchange::programs::file_text;

use super::{proofs, read, text_of};

fn text(bytes: &[u8]) -> Result<(String, Option<String>), String> {
    file_text(Path::new("in"), bytes.to_owned()).map_err(|error| error.to_string())
}

/// A binary glTF of this JSON and a chunk of vertices.
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
        let (taken, note) = text(&binary(&json)).unwrap();
        assert_eq!(taken.trim_end(), json.trim_end());
        assert_eq!(note, None);
        let [own, other] = [&json, &taken].map(|json| read("gltf", json).unwrap().camera);
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
    let (cut, _) = text(&with(12, &(json / 2).to_le_bytes())).unwrap();
    assert!(read("gltf", &cut).unwrap_err().problem.contains("is all of the file there?"));
    for end in 4..count {
        assert!(text(&whole[..end]).is_err());
    }
}

#[test]
fn latin_1_is_read_and_told_and_what_is_no_text_is_refused() {
    let scene = "// Gr\u{fc}n: caf\u{e9}\ncamera { location <1, 2, -\u{e9}> }";
    let note = "it is not UTF-8: read as Latin-1";
    assert_eq!(text(scene.as_bytes()), Ok((scene.to_owned(), None)));
    let latin: Vec<u8> = scene.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let (taken, told) = text(&latin).unwrap();
    assert_eq!((taken.as_str(), told.as_deref()), (scene, Some(note)));
    let refused = read("povray", &taken).unwrap_err();
    assert_eq!(refused.to_string(), "in:2:26: location is -\u{e9}: it must be a finite number");
    let no_text = "in: not text: a camera is read from text in UTF-8";
    // A picture, and UTF-16.
    for bytes in [&b"\x89PNG\r\n\x1a\n"[..], b"\xff\xfec\0a\0"] {
        assert_eq!(text(bytes), Err(no_text.to_owned()));
    }
}
