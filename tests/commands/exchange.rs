//! `pinhole export` and `pinhole import`

use std::fs;

use super::{command_in, entries, finished, run, run_in};

const NAMES: [&str; 10] = [
    "gltf", "three", "mitsuba", "povray", "blender", "weekend", "opengl", "course", "opencv",
    "pbrt",
];

const LANGUAGES: [&str; 6] = ["julia", "numpy", "glm", "glsl", "glam", "javascript"];

const CANONICAL: &str = "glViewport(0, 0, 400, 400);\nglMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n\
                         gluPerspective(53.13010235415598, 1.0, 0.01, 10000.0);\n\
                         glMatrixMode(GL_MODELVIEW);\nglLoadIdentity();\ngluLookAt(0, 0, 0,\n          \
                         0, 0, -5,\n          0, 1, 0);\n";

const LOOK_AT: &str = "gluLookAt(0, 0, 0,  0, 0, -5,  0, 1, 0);\n";

#[test]
fn the_names_are_in_the_help_and_in_the_error() {
    let help = run("export --help").done();
    for name in NAMES {
        assert!(help.contains(&format!("- {name}:")), "{name}: {help}");
    }
    let all = [&NAMES[..], &LANGUAGES].concat().join(", ");
    run("export canonical --to maya").refused(&format!("[possible values: {all}]"));
    run("export canonical").refused("--to <NAME>");
    run("export canonical --to gltf --meshes --camera-only").refused("cannot be used with");
}

#[test]
fn code_is_exported_like_a_camera() {
    let folder = tempfile::tempdir().unwrap();
    for name in LANGUAGES {
        let code = run(&format!("export look-at --to {name}")).done();
        assert!(code.contains("0.581238"), "{name}: {code}");
        let out = format!("ray.{name}");
        run_in(folder.path(), &["export", "look-at", "--to", name, "-o", &out]).done();
        assert_eq!(fs::read_to_string(folder.path().join(&out)).unwrap(), code);
    }
    let julia = run("export look-at --to julia").done();
    assert_eq!(julia, include_str!("../../src/exchange/tests/files/code/look-at.jl"));
}

#[test]
fn to_standard_output_or_to_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let told = run_in(folder.path(), &["export", "canonical", "--to", "opengl", "--camera-only"]);
    assert_eq!((told.status, told.stdout.as_str()), (0, CANONICAL));
    assert_eq!(
        told.stderr,
        "note: zNear 0.01 and zFar 10000 are chosen: OpenGL cuts off what is nearer or \
         farther\n"
    );
    let arguments = ["export", "canonical", "--to", "opengl", "-o", "camera.c"];
    let told = run_in(folder.path(), &arguments);
    assert_eq!((told.status, told.stdout.as_str()), (0, ""));
    assert_eq!(fs::read_to_string(folder.path().join("camera.c")).unwrap(), CANONICAL);
    run_in(folder.path(), &["export", "canonical", "--to", "course", "-o", "no/camera.jl"])
        .failed(1, "no/camera.jl: cannot be written: no such file or directory");
}

#[test]
fn a_gltf_and_numbers_make_the_scene_again() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    let ray = |scene: &str| -> Vec<f64> {
        let json = run(&format!("inspect {scene} --pixel 99,199 --json")).done();
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        let numbers = value["ray"]["direction"].as_array().unwrap().iter();
        numbers.map(|x| x.as_f64().unwrap()).collect()
    };
    assert_eq!(run("export look-at --to gltf -o a.gltf").status, 0);
    let look_at = "20 4 10  -1 0 -5  0 1 0";
    fs::write(folder.path().join("b.txt"), look_at).unwrap();
    assert_eq!(run("export look-at --to opencv -o c.json").status, 0);
    let literal = "# From literal numbers.\n";
    for (file, head) in [("a.gltf", "# From glTF 2.0.\n"), ("b.txt", literal), ("c.json", literal)]
    {
        assert_eq!(run(&format!("import {file} -o a.toml")).status, 0, "{file}");
        let text = fs::read_to_string(folder.path().join("a.toml")).unwrap();
        assert!(
            text.starts_with(head) && text.contains("[camera]\neye = [20.0, 4.0, 10.0"),
            "{text}"
        );
        for (a, b) in ray("look-at").iter().zip(ray("a.toml")) {
            assert!((a - b).abs() < 1e-12, "{file}: {a} {b}");
        }
    }
    // What else is exported is not read, and the message says what is.
    for name in NAMES.iter().filter(|name| !["gltf", "opencv"].contains(name)) {
        run(&format!("export look-at --to {name} -o out.{name}"));
        let refused = run(&format!("import out.{name}"));
        let reasons = [
            "no camera that Pinhole reads: it reads glTF (.gltf, .glb), and numbers: ",
            "only one gluLookAt or",
            "it must be nine numbers",
        ];
        assert_eq!(refused.status, 1, "{name}");
        assert!(reasons.iter().any(|r| refused.stderr.contains(r)), "{name}: {}", refused.stderr);
    }
}

#[test]
fn what_cannot_be_said_or_read_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    let refused = run("export non-square --to mitsuba -o a.xml");
    assert_eq!(refused.status, 1);
    assert!(refused.stderr.starts_with("error: non-square: pixels are "), "{}", refused.stderr);
    assert_eq!(entries(folder.path()), Vec::<String>::new());
    fs::write(folder.path().join("a.txt"), "nothing").unwrap();
    let unknown = run("import a.txt");
    assert_eq!(unknown.status, 1);
    assert!(
        unknown.stderr.starts_with("error: a.txt: no camera that Pinhole reads: it reads glTF"),
        "{}",
        unknown.stderr
    );
    fs::write(folder.path().join("a.dat"), "nothing").unwrap();
    let unknown = run("import a.dat -o a.toml");
    assert_eq!(unknown.status, 1);
    assert!(
        unknown.stderr.starts_with("error: a.dat: no camera that Pinhole reads: it reads glTF")
    );
    fs::write(folder.path().join("a.txt"), " \n").unwrap();
    run("import a.txt").failed(1, "a.txt: it is empty: export the camera again");
    for text in ["1 2 3\n4 5 6\n7 8", "[[1, 2, 3, 4], [5, 6, 7, 8]]"] {
        fs::write(folder.path().join("a.txt"), text).unwrap();
        let counts = "a.txt: the count of numbers is 8: it must be 9 (eye, at, up), 10 (and the vertical \
                      angle in degrees), or 12 or 16 (a matrix from camera to world)";
        run("import a.txt").failed(1, counts);
    }
    let ours = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n";
    fs::write(folder.path().join("a.txt"), ours).unwrap();
    run("import a.txt").failed(1, "a.txt: this is a scene of Pinhole: open it as it is");
    fs::write(folder.path().join("b.c"), "\ngluLookAt(1, 2);").unwrap();
    run("import b.c").failed(1, "b.c:2:1: gluLookAt(1, 2): it must have 9 numbers");
    run("import no.gltf").failed(1, "no.gltf: cannot be read: no such file or directory");
    assert_eq!(entries(folder.path()), ["a.dat", "a.txt", "b.c"]);
    for (bytes, why) in [
        ([0xff, 0xfe, b'g', 0], "it is text in UTF-16: save it as UTF-8"),
        ([b'g', 0xe9, b'g', 0], "not text: a camera is read from text in UTF-8"),
    ] {
        fs::write(folder.path().join("c.c"), bytes).unwrap();
        run("import c.c").failed(1, &format!("c.c: {why}"));
    }
    fs::write(folder.path().join("d.glb"), b"glTF\x02\0\0\0\xff").unwrap();
    run("import d.glb").failed(
        1,
        "d.glb: binary glTF: the header with that of the JSON is 20 bytes, and 9 are there: is all of \
         the file there?",
    );
}

#[test]
fn binary_gltf_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    run("export look-at --to gltf --camera-only -o a.gltf");
    let json = fs::read(folder.path().join("a.gltf")).unwrap();
    let [length, whole] = [json.len(), json.len() + 20].map(|n| (n as u32).to_le_bytes());
    let binary = [&b"glTF"[..], &2_u32.to_le_bytes(), &whole, &length, b"JSON", &json].concat();
    fs::write(folder.path().join("a.glb"), binary).unwrap();
    assert_eq!(run("import a.glb").done(), run("import a.gltf").done());
}

#[test]
fn a_camera_from_standard_input() {
    use std::io::Write as _;
    use std::process::Stdio;
    let mut child = command_in(&std::env::temp_dir())
        .args(["import", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(LOOK_AT.as_bytes()).unwrap();
    let scene = finished(child.wait_with_output().unwrap());
    assert_eq!(scene.status, 0);
    assert!(scene.stdout.contains("at = [0.0, 0.0, -5.0]"), "{}", scene.stdout);
}
