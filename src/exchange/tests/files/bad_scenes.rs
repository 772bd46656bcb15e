//! Invalid scene files, each with the exact error message.

use std::path::Path;

use pinhole_exchange::scene_file;

/// Pairs of an invalid text, before which [`check`] puts a valid beginning, and the error message after
/// `scene.toml:`.
type Cases = &'static [(&'static str, &'static str)];

const WHOLE_FILES: Cases = &[
    ("", "1:1: pinhole is missing: write pinhole = 1 (the format version) at the top"),
    (
        "# only a comment\n",
        "1:1: pinhole is missing: write pinhole = 1 (the format version) at the top",
    ),
    (
        "pinhole = 2\nwarp = 9\n",
        "1:11: pinhole is 2: this scene format is newer than this program, which reads 1: get a newer Pinhole",
    ),
    ("pinhole = 0\n", "1:11: pinhole is 0: the format version must be 1"),
    ("pinhole = \"1\"\n", "1:11: pinhole is \"1\": the format version must be 1"),
    ("pinhole = 1.0\n", "1:11: pinhole is 1.0: the format version must be 1"),
    (
        "[camera]\neye = [0, 0, 0]\n",
        "1:1: pinhole is missing: write pinhole = 1 (the format version) at the top",
    ),
    ("pinhole = 1\n", "1:1: camera is missing: write [camera] with eye, at and up"),
    ("pinhole = 1\ncamera = 3\n", "2:10: camera is 3: it must be one table, [camera]"),
    (
        "pinhole = 1\n[[camera]]\neye = [0, 0, 0]\n",
        "2:1: camera is a list of tables: it must be one table, [camera]",
    ),
    ("pinhole = 1\n[camra]\neye = [0, 0, 0]\n", "2:2: camra is unknown: did you mean camera?"),
    (
        "pinhole = 1\nsphere = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "2:10: sphere is 1: each one must be a table that begins with [[sphere]]",
    ),
    (
        "pinhole = 1\nsphere = [{ center = [0, 0, -5], radius = 1 }, 5]\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "2:48: sphere[1] is 5: each one must be a table that begins with [[sphere]]",
    ),
    (
        "pinhole = 1\nspheres = 5\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "2:11: spheres is 5: it must be the path of a CSV file",
    ),
    (
        "pinhole = 1\nspheres = \"no-such.csv\"\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "2:11: spheres is \"no-such.csv\": the table of the scene's spheres must be there, but no-such.csv: cannot be read: no such file or directory",
    ),
    (
        "pinhole 1\n",
        "1:9: after a name comes = and its value, such as width = 1.0: is it a scene's file?",
    ),
    (
        "\u{feff}pinhole = 3\n",
        "1:11: pinhole is 3: this scene format is newer than this program, which reads 1: get a newer Pinhole",
    ),
    (
        "pinhole = 1\r\n[camera]\r\neye = [0, 0, x]\r\n",
        "3:14: x is no value: write a number, or text in quotes",
    ),
];

const CAMERA_START: &str = "pinhole = 1\n[camera]\n";

const CAMERAS: Cases = &[
    ("eys = [0, 0, 0]\n", "3:1: camera.eys is unknown: did you mean eye?"),
    (
        "at = [0, 0, -1]\nup = [0, 1, 0]\n",
        "2:1: camera.eye is missing: write eye = [0.0, 0.0, 0.0]",
    ),
    (
        "eye = [0, 0, 0]\nup = [0, 1, 0]\n",
        "2:1: camera.at (or view, or basis) is missing: write at = [0.0, 0.0, -1.0]",
    ),
    ("eye = [0, 0, 0]\nat = [0, 0, -1]\n", "2:1: camera.up is missing: write up = [0.0, 1.0, 0.0]"),
    (
        "eye = [0, 0, 0]\nview = [0, 0, -1]\n",
        "2:1: camera.up is missing: write up = [0.0, 1.0, 0.0]",
    ),
    (
        "eye = [0, 0, 0]\nat = [0, 0, -1]\nview = [0, 0, -1]\nup = [0, 1, 0]\n",
        "5:8: camera.view is there together with camera.at: keep exactly one of at, view and basis",
    ),
    (
        "eye = [0, 0, 0]\nup = [0, 1, 0]\nbasis = { u = [1, 0, 0], v = [0, 1, 0], w = [0, 0, 1] }\nat = [0, 0, -1]\n",
        "5:9: camera.basis is there together with camera.at: keep exactly one of at, view and basis",
    ),
    (
        "eye = [0, 0, 0]\nup = [0, 1, 0]\nbasis = { u = [1, 0, 0], v = [0, 1, 0], w = [0, 0, 1] }\n",
        "4:6: camera.up is there together with camera.basis: a basis needs no up, leave it out",
    ),
    (
        "eye = [0, 0, 0]\nbasis = { u = [1, 0, 0], v = [0, 1, 0] }\n",
        "4:9: camera.basis.w is missing: write w = [0.0, 0.0, 1.0]",
    ),
    (
        "eye = [0, 0, 0]\nbasis = { u = [1, 0, 0], v = [0, 1, 0], w = [0, 0, 1], z = 1 }\n",
        "4:56: camera.basis.z is unknown: the fields here are u, v, w",
    ),
    (
        "eye = [0, 0, 0]\nbasis = [1, 0, 0]\n",
        "4:9: camera.basis is [1, 0, 0]: it must be one table, [camera.basis]",
    ),
    ("eye = 0\n", "3:7: camera.eye is 0: it must be three numbers, such as [0.0, 1.0, 0.0]"),
    (
        "eye = [0, 0]\n",
        "3:7: camera.eye is [0, 0]: it must be three numbers, such as [0.0, 1.0, 0.0]",
    ),
    (
        "eye = [0, 0, 0, 1]\n",
        "3:7: camera.eye is [0, 0, 0, 1]: it must be three numbers, such as [0.0, 1.0, 0.0]",
    ),
    ("eye = [0, 0, \"far\"]\n", "3:14: camera.eye[2] is \"far\": it must be a number"),
    ("eye = [0, nan, 0]\n", "3:11: camera.eye[1] is nan: it must be a finite number"),
    ("eye = [0, 0, -inf]\n", "3:14: camera.eye[2] is -inf: it must be a finite number"),
    ("eye = [true, 0, 0]\n", "3:8: camera.eye[0] is true: it must be a number"),
    ("eye = [0, [1], 0]\n", "3:11: camera.eye[1] is [1]: it must be a number"),
    ("eye = [0, 0, { z = 1 }]\n", "3:14: camera.eye[2] is a table: it must be a number"),
    (
        "eye = { x = 1, y = 0, z = 0 }\n",
        "3:7: camera.eye is a table: it must be three numbers, such as [0.0, 1.0, 0.0]",
    ),
    (
        "eye = [0, 0, 0]\nat = 1979-05-27\n",
        "4:6: camera.at is 1979-05-27: it must be three numbers, such as [0.0, 1.0, 0.0]",
    ),
    (
        "eye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, inf]\n",
        "5:13: camera.up[2] is inf: it must be a finite number",
    ),
    ("eye = [0, 0, 0\n", "3:15: the ] after the last number is missing"),
    ("eye = \n", "3:7: the value after = is missing"),
    ("eye = [0, 0, 0]\neye = [0, 0, 1]\n", "4:1: eye is given twice"),
    ("[camera]\n", "3:2: camera is given twice"),
    ("eye = [0, 0, 1e999]\n", "3:14: 1e999 is too large a number"),
    ("eye = [0, 0, 01]\n", "3:14: not valid TOML: unexpected leading zero"),
    (
        "name = \"ö\" eye = 1\n",
        "3:12: only one name and one value fit in a line: begin a new line here",
    ),
    (
        "eye = [0, 0, 0]\nat = [\n  0.0,\n  # the depth\n  nan,\n  1,\n]\n",
        "7:3: camera.at[1] is nan: it must be a finite number",
    ),
];

const CAMERA: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n";

const BEHIND_THE_CAMERA: Cases = &[
    (
        "[lights]\nsun = 1\n",
        "6:2: lights is unknown: the fields here are pinhole, spheres, camera, viewport, image, observer, sphere, plane",
    ),
    ("[viewport]\nwidth = 0\n", "7:9: viewport.width is 0: it must be greater than 0"),
    ("[viewport]\nheight = -1.5\n", "7:10: viewport.height is -1.5: it must be greater than 0"),
    ("[viewport]\ndistance = nan\n", "7:12: viewport.distance is nan: it must be a finite number"),
    ("[viewport]\ndistance = \"1\"\n", "7:12: viewport.distance is \"1\": it must be a number"),
    (
        "[viewport]\ndistance = \"4,0\"\n",
        "7:12: viewport.distance is \"4,0\": it must be a number with a decimal point: write 4.0",
    ),
    ("[viewport]\ndistance = 4,0\n", "7:13: a decimal point, not a comma, must stand here"),
    (
        "[viewport]\nfov = 60\n",
        "7:1: viewport.fov is unknown: the fields here are width, height, distance",
    ),
    ("[viewport]\nhieght = 1\n", "7:1: viewport.hieght is unknown: did you mean height?"),
    (
        "viewport = 1\n",
        "6:1: camera.viewport is unknown: the fields here are eye, at, view, up, basis",
    ),
    (
        "[[viewport]]\nwidth = 1\n",
        "6:1: viewport is a list of tables: it must be one table, [viewport]",
    ),
    (
        "[image]\nwidth = 0\n",
        "7:9: image.width is 0: it must be a whole number of pixels, 1 to 16384",
    ),
    (
        "[image]\nwidth = 16385\n",
        "7:9: image.width is 16385: it must be a whole number of pixels, 1 to 16384",
    ),
    (
        "[image]\nheight = 400.0\n",
        "7:10: image.height is 400.0: it must be a whole number of pixels, 1 to 16384",
    ),
    (
        "[image]\nheight = -400\n",
        "7:10: image.height is -400: it must be a whole number of pixels, 1 to 16384",
    ),
    (
        "[image]\ndistance = 1\n",
        "7:1: image.distance is unknown: the fields here are width, height",
    ),
    (
        "[observer]\ntarget = [0, 0, 0]\nazimuth = 40\nelevation = 20\n",
        "6:1: observer.distance is missing: write distance = 12.0",
    ),
    (
        "observer = { target = [0, 0, 0], azimuth = nan, elevation = 20, distance = 12 }\n",
        "6:1: camera.observer is unknown: the fields here are eye, at, view, up, basis",
    ),
    (
        "[observer]\ntarget = [0, 0, 0]\nazimuth = nan\nelevation = 20\ndistance = 12\n",
        "8:11: observer.azimuth is nan: it must be a finite number",
    ),
    (
        "[observer]\ntarget = [0, 0, 0]\nazimuth = 4\nelevation = 91\ndistance = 12\n",
        "9:13: observer.elevation is 91: it must be -90 to 90 degrees",
    ),
    (
        "[observer]\ntarget = [0, 0, 0]\nazimuth = 4\nelevation = 9\ndistance = 0\n",
        "10:12: observer.distance is 0: it must be 1e-9 to 1e12",
    ),
    (
        "[observer]\ntarget = [0, 2e12, 0]\nazimuth = 4\nelevation = 9\ndistance = 1\n",
        "7:10: observer.target is [0, 2e12, 0]: it must be at most 1e12 away",
    ),
    (
        "[observer]\ntarget = [0, 0, 0]\nazimut = 4\nelevation = 9\ndistance = 1\n",
        "8:1: observer.azimut is unknown: did you mean azimuth?",
    ),
    ("[[sphere]]\ncenter = [0, 0, -5]\n", "6:1: sphere[0].radius is missing: write radius = 1.0"),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 0\n",
        "8:10: sphere[0].radius is 0: it must be greater than 0",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n[[sphere]]\ncenter = [0, 0, -5]\nradius = -2.5\n",
        "14:10: sphere[2].radius is -2.5: it must be greater than 0",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = inf\n",
        "8:10: sphere[0].radius is inf: it must be a finite number",
    ),
    (
        "[[sphere]]\nradius = 1\n",
        "6:1: sphere[0].center is missing: write center = [0.0, 0.0, -5.0]",
    ),
    (
        "[[sphere]]\ncentre = [0, 0, -5]\nradius = 1\n",
        "7:1: sphere[0].centre is unknown: did you mean center?",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\ncolour = \"#ffffff\"\n",
        "9:1: sphere[0].colour is unknown: did you mean color?",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\ncolor = \"red\"\n",
        "9:9: sphere[0].color is \"red\": it must be a colour such as \"#e69f00\"",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\ncolor = \"#e69f0\"\n",
        "9:9: sphere[0].color is \"#e69f0\": it must be a colour such as \"#e69f00\"",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\ncolor = 0xe69f00\n",
        "9:9: sphere[0].color is 0xe69f00: it must be a colour such as \"#e69f00\"",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\nname = 7\n",
        "9:8: sphere[0].name is 7: it must be text in quotes",
    ),
    (
        "[sphere]\ncenter = [0, 0, -5]\nradius = 1\n",
        "6:1: sphere is a table: each one must be a table that begins with [[sphere]]",
    ),
    (
        "[[plane]]\npoint = [0, 0, -6]\n",
        "6:1: plane[0].normal is missing: write normal = [0.0, 0.0, 1.0]",
    ),
    (
        "[[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 0.0]\n",
        "8:10: plane[0].normal is [0, 0, 0.0]: it must point somewhere",
    ),
    (
        "[[plane]]\npoint = [0, 0, -6]\nnormal = [0, nan, 1]\n",
        "8:14: plane[0].normal[1] is nan: it must be a finite number",
    ),
    (
        "[[plane]]\nnormal = [0, 0, 1]\n",
        "6:1: plane[0].point is missing: write point = [0.0, 0.0, -6.0]",
    ),
    (
        "[[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 1]\nradius = 1\n",
        "9:1: plane[0].radius is unknown: the fields here are name, point, normal, color",
    ),
    (
        "[[plane]]\npoint = [0, 0, -6]\nnormal = [0, 0, 1]\nspheres = \"balls.csv\"\n",
        "9:1: plane[0].spheres is unknown: it belongs at the top of the file, before the first [table]",
    ),
    (
        "[[sphere]]\ncenter = [0, 0, -5]\nradius = 1.\n",
        "8:12: not valid TOML: invalid fraction, expected digits",
    ),
];

fn check(before: &str, cases: Cases) {
    for (text, expected) in cases {
        let text = format!("{before}{text}");
        let message = match scene_file::parse(&text, Path::new("scene.toml"), Path::new("")) {
            Ok(document) => panic!("no error in:\n{text}\n{document:?}"),
            Err(error) => error.to_string(),
        };
        assert_eq!(message, format!("scene.toml:{expected}"), "in:\n{text}");
    }
}

#[test]
fn whole_files() {
    check("", WHOLE_FILES);
}

/// The TOML parser recurses for every open bracket, and continues after an error. Without a check, it
/// would overflow the stack here.
#[test]
fn brackets_that_are_nested_too_deep_are_told_before_they_are_parsed() {
    let unclosed = "up = [0, 1, 0]\nbasis = {0]\n".repeat(7200);
    let cases = [
        (format!("pinhole = 1\n{unclosed}"), "3:9"),
        (format!("pinhole = 1\nup = {}", "[".repeat(100_000)), "2:6"),
        (format!("pinhole = 1\nup = {}", "{a=".repeat(100_000)), "2:6"),
    ];
    for (text, place) in cases {
        let message = scene_file::parse(&text, Path::new("scene.toml"), Path::new("")).unwrap_err();
        let problem = "from this bracket on they are nested more than 64 deep: is it closed?";
        let expected = format!("scene.toml:{place}: {problem}");
        assert_eq!(message.to_string(), expected);
    }
    // Brackets within a string do not count.
    let text = format!("{CAMERA}[[sphere]]\nname = \"{}\"\n", "[".repeat(100));
    let message = scene_file::parse(&text, Path::new("scene.toml"), Path::new("")).unwrap_err();
    assert!(message.to_string().contains("center is missing"), "{message}");
}

#[test]
fn a_long_value_makes_no_long_message_and_what_is_hidden_is_escaped() {
    let long = "a".repeat(100_000);
    for text in [
        format!("pinhole = 1\n{long} = 1\n"),
        format!("pinhole = {long}\n"),
        format!("pinhole = \"{long}\"\n"),
    ] {
        let message = scene_file::parse(&text, Path::new("scene.toml"), Path::new("")).unwrap_err();
        let message = message.to_string();
        assert!(message.len() < 200 && message.contains("aaaa..."), "{message}");
    }
    let text = "pinhole = \"\u{202e}gnp\u{1b}\"\n".replace('\u{1b}', "\u{200f}");
    let path = Path::new("a\u{1b}[2J\u{202e}.toml");
    let message = scene_file::parse(&text, path, Path::new("")).unwrap_err().to_string();
    let expected = "a\\u{1b}[2J\\u{202e}.toml:1:11: pinhole is \"\\u{202e}gnp\\u{200f}\": the format version \
                    must be 1";
    assert_eq!(message, expected);
    let text = "pinhole = \"1\u{feff}\u{ad}\u{200b}\u{3164}é\u{301}\"\n";
    let message = scene_file::parse(text, Path::new("a\u{feff}.toml"), Path::new("")).unwrap_err();
    let expected = "a\\u{feff}.toml:1:11: pinhole is \"1\\u{feff}\\u{ad}\\u{200b}\\u{3164}é\u{301}\": the format \
                    version must be 1";
    assert_eq!(message.to_string(), expected);
}

/// Each of these names is another one, of bytes that make or look like escapes and signs.
#[cfg(unix)]
#[test]
fn unlike_names_are_shown_unlike_and_nothing_in_them_is_hidden() {
    use std::collections::BTreeMap;
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt as _;

    let parts: [&[u8]; 16] = [
        b"a",
        b" ",
        b"\\",
        b"u{202e}",
        "\u{202e}".as_bytes(),
        b"xe2",
        b"\xe2",
        b"\x80",
        b"\xae",
        b"'",
        b"\"",
        b"n",
        b"\n",
        "\u{301}".as_bytes(),
        "\u{200d}".as_bytes(),
        "\u{3164}".as_bytes(),
    ];
    let mut shown = BTreeMap::new();
    let mut names = vec![Vec::new()];
    for _ in 0..4 {
        for name in &names {
            let legible = pinhole_exchange::legible_name(OsStr::from_bytes(name));
            assert!(
                !legible.contains(['\n', '\u{202e}', '\u{200d}', '\u{3164}', '\u{fffd}']),
                "{legible:?}"
            );
            assert_eq!(legible.trim(), legible);
            let other = shown.insert(legible.clone(), name.clone());
            assert!(other.is_none_or(|other| other == *name), "{legible}");
        }
        names = names.iter().flat_map(|name| parts.map(|part| [name, part].concat())).collect();
    }
    // What belongs to the spelling stays: a gradebook has these names, too.
    let persian = "\u{646}\u{6cc}\u{645}\u{627}\u{200c}\u{631}\u{636}\u{627}.csv";
    let emoji = "\u{1f469}\u{200d}\u{1f393} \u{2764}\u{fe0f}\u{200d}\u{1f525}";
    for plain in ["O'Brien, \"Zo\u{eb}\" \u{5c71}-1.csv", persian, emoji] {
        assert_eq!(pinhole_exchange::legible_name(plain), plain);
    }
    assert_eq!(pinhole_exchange::legible_name("an\u{200d}na"), r"an\u{200d}na");
}

#[test]
fn cameras() {
    check(CAMERA_START, CAMERAS);
}

#[test]
fn behind_the_camera() {
    check(CAMERA, BEHIND_THE_CAMERA);
}
