//! Tests that inputs are rejected that are too large, or may never end.

use std::fs::{self, File};
use std::path::Path;

use pinhole_core::{DVec3, Sphere};
use pinhole_exchange::document::{Document, Item};
use pinhole_exchange::{limits, scene_file};

#[test]
fn a_file_is_read_up_to_its_limit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    fs::write(&path, "four").unwrap();
    assert_eq!(limits::read(&path, 4).unwrap(), b"four");
    assert_eq!(limits::read_from(&b"four"[..], &path, 4).unwrap(), b"four");
    let refused = format!(
        "{}: it is too large: at most 2 MiB are read. Many spheres belong in a table: spheres = \"file.csv\"",
        path.display()
    );
    // The file is sparse, so it takes no space on the disk.
    File::create(&path).unwrap().set_len(limits::TEXT + 1).unwrap();
    assert_eq!(scene_file::load(&path).unwrap_err().to_string(), refused);
    let more = std::io::repeat(b'#');
    let error = limits::read_from(more, &path, limits::TEXT).unwrap_err();
    assert_eq!(error.to_string(), refused);
}

/// Parsed, a text takes up to 300 times its size, wherever it comes from.
#[test]
fn no_larger_text_is_parsed_and_none_is_written_that_could_not_be_read_back() {
    let sphere = Item::plain(Sphere { center: DVec3::new(0.1, 0.2, -5.0), radius: 0.3 });
    let scene = |count: usize| Document {
        spheres: vec![sphere.clone(); count].into(),
        ..Document::default()
    };
    let (few, many) = (scene(20_000), scene(50_000));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    let saved = scene_file::save(&few, &path, None).unwrap();
    assert_eq!(scene_file::load(&path).unwrap(), few);
    let advice = "it is too large: at most 2 MiB are read. Many spheres belong in a table: spheres = \"file.csv\"";
    let error = scene_file::save(&many, &path, Some(&saved.text)).unwrap_err();
    assert_eq!(error.problem, format!("not saved: {advice}"));
    assert_eq!(fs::read_to_string(&path).unwrap(), saved.text);
    let text = scene_file::to_text(&many, None);
    assert!(scene_file::prepare(&many, &path, None, true).is_err());
    assert_eq!(scene_file::parse(&text, &path, folder.path()).unwrap_err().problem, advice);
}

#[test]
fn text_in_utf_16_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wide.toml");
    for bytes in [b"\xff\xfep\0i\0", b"\xfe\xff\0p\0i"] {
        fs::write(&path, bytes).unwrap();
        let told = format!("{}: it is text in UTF-16: save it as UTF-8", path.display());
        assert_eq!(scene_file::load(&path).unwrap_err().to_string(), told);
        assert_eq!(limits::read_from(&bytes[..], &path, 9).unwrap_err().to_string(), told);
    }
}

#[cfg(unix)]
#[test]
fn devices_and_pipes_are_refused() {
    use std::process::Command;

    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for path in [Path::new("/dev/zero"), &pipe] {
        let said = "cannot be read: it is a device or a pipe, and must be a file";
        let told = format!("{}: {said}", path.display());
        assert_eq!(scene_file::load(path).unwrap_err().to_string(), told);
        let scene = folder.path().join("scene.toml");
        let text = format!(
            "pinhole = 1\nspheres = \"{}\"\n[camera]\neye = [0, 0, 0]\nat = [0, 0, 1]\nup = [0, 1, 0]\n",
            path.display()
        );
        fs::write(&scene, text).unwrap();
        let error = scene_file::load(&scene).unwrap_err().to_string();
        assert!(error.ends_with(&told), "{error}");
    }
}
