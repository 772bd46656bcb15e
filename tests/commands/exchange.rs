//! `pinhole export` and `pinhole import`

use std::fs;

use super::{command_in, entries, finished, run, run_in};

const NAMES: [&str; 11] = [
    "gltf", "three", "mitsuba", "povray", "blender", "weekend", "opengl", "course", "colmap",
    "opencv", "pbrt",
];

const LANGUAGES: [&str; 6] = ["julia", "numpy", "glm", "glsl", "glam", "javascript"];

const CANONICAL: &str = "glViewport(0, 0, 400, 400);\nglMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n\
                         gluPerspective(53.13010235415598, 1.0, 0.01, 10000.0);\n\
                         glMatrixMode(GL_MODELVIEW);\nglLoadIdentity();\ngluLookAt(0, 0, 0,\n          \
                         0, 0, -5,\n          0, 1, 0);\n";

#[test]
fn the_names_are_in_the_help_and_in_the_error() {
    let help = run("export --help").done();
    for name in NAMES {
        assert!(help.contains(&format!("- {name}:")), "{name}: {help}");
    }
    let all = [&NAMES[..], &LANGUAGES].concat().join(", ");
    run("export canonical --to maya").refused(&format!("[possible values: {all}]"));
    run("export canonical").refused("--to <NAME>");
    run("import a.txt --from maya").refused("possible values: gltf");
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
    run("import a.jl --from julia").refused("possible values: gltf");
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
fn colmap_is_a_folder_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(run("export look-at --to colmap -o model").status, 0);
    let model = folder.path().join("model");
    assert_eq!(entries(&model), ["cameras.txt", "images.txt", "points3D.txt"]);
    let from_folder = run("import model").done();
    assert!(from_folder.contains("[camera]\neye = [20.0, 4.0, 10.0"), "{from_folder}");
    assert_eq!(run("import model/images.txt").done(), from_folder);
    assert_eq!(run("import model/cameras.txt").done(), from_folder);
    fs::remove_file(model.join("images.txt")).unwrap();
    run("import model").failed(1, "model/images.txt: cannot be read: no such file or directory");
    // Each fault is in its own file.
    fs::write(model.join("images.txt"), "# Image list\n1 1 0 0 0 0 0 5 7 a.png\n").unwrap();
    run("import model").failed(
        1,
        "model/images.txt:2:1: CAMERA_ID of a.png is 7: it must be that of a camera in cameras.txt, 1",
    );
    fs::write(model.join("cameras.txt"), "\n1 FISHEYE 9 9 9 9 9").unwrap();
    fs::write(model.join("images.txt"), "1 1 0 0 0 0 0 5 1 a.png\n").unwrap();
    let fisheye = run("import model");
    assert!(fisheye.stderr.starts_with("error: model/cameras.txt:2:1: MODEL is FISHEYE"));
    fs::remove_file(model.join("cameras.txt")).unwrap();
    fs::write(model.join("cameras.bin"), [1, 0, 0xff]).unwrap();
    let binary = "model/cameras.bin: binary: `colmap model_converter --output_type TXT` writes the model as text";
    run("import model").failed(1, binary);
    run("import model/cameras.bin").failed(1, binary);
}

#[test]
fn every_format_that_is_read_goes_out_and_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    let ray = |scene: &str| -> Vec<f64> {
        let json = run(&format!("inspect {scene} --pixel 99,199 --json")).done();
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        let numbers = value["ray"]["direction"].as_array().unwrap().iter();
        numbers.map(|x| x.as_f64().unwrap()).collect()
    };
    let before = ray("look-at");
    for name in NAMES {
        assert_eq!(run(&format!("export look-at --to {name} -o out.{name}")).status, 0, "{name}");
        if ["blender", "weekend"].contains(&name) {
            let refused = run(&format!("import out.{name}"));
            assert_eq!(refused.status, 1, "{name}");
            // Either as a whole, or at the first line that is not literal.
            let reasons = ["no camera of a known form", "it must be nine numbers"];
            let is_told = reasons.iter().any(|reason| refused.stderr.contains(reason));
            assert!(is_told, "{name}: {}", refused.stderr);
            continue;
        }
        assert_eq!(run(&format!("import out.{name} -o {name}.toml")).status, 0, "{name}");
        for (a, b) in before.iter().zip(ray(&format!("{name}.toml"))) {
            assert!((a - b).abs() < 1e-12, "{name}: {a} {b}");
        }
        // The scene is one that opens, with what it came from at its head.
        let text = fs::read_to_string(folder.path().join(format!("{name}.toml"))).unwrap();
        assert!(text.starts_with("# From "), "{text}");
    }
}

#[test]
fn a_scene_with_its_spheres_comes_back_from_pov_ray() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(run("export look-at --to povray -o a.pov").done(), "");
    assert_eq!(run("import a.pov -o a.toml").done(), "");
    let hits = |scene: &str| {
        let json = run(&format!("inspect {scene} --uv 0.01,0 --json")).done();
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        value["hits"].as_array().unwrap().len()
    };
    assert_eq!(hits("a.toml"), hits("look-at"));
    // The same scene again: what is exported of it differs in names alone.
    let again = run("export a.toml --to povray").done();
    let first = fs::read_to_string(folder.path().join("a.pov")).unwrap();
    let numbers = |text: &str| {
        let lines = text.lines().map(|line| line.split("//").next().unwrap().trim_end().to_owned());
        lines.collect::<Vec<_>>()
    };
    assert_eq!(numbers(&again), numbers(&first));
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
        unknown.stderr.starts_with("error: a.txt: no camera of a known form: it may be glTF"),
        "{}",
        unknown.stderr
    );
    fs::write(folder.path().join("a.dat"), "nothing").unwrap();
    let unknown = run("import a.dat -o a.toml");
    assert_eq!(unknown.status, 1);
    assert!(unknown.stderr.starts_with("error: a.dat: no camera of a known form: it may be glTF"));
    fs::write(folder.path().join("b.c"), "gluPerspective(60, 1, 1, 2);\ngluLookAt(1, 2);").unwrap();
    run("import b.c").failed(1, "b.c:2:1: gluLookAt(1, 2): it must have 9 numbers");
    run("import b.c --from pbrt").failed(1, "b.c:1:1: gluPerspective(60,: no directive of pbrt");
    assert_eq!(entries(folder.path()), ["a.dat", "a.txt", "b.c"]);
    fs::write(folder.path().join("c.c"), [0xff, 0xfe, b'g', 0]).unwrap();
    run("import c.c").failed(1, "c.c: not text: a camera is read from text in UTF-8");
    fs::write(folder.path().join("d.glb"), b"glTF\x02\0\0\0\xff").unwrap();
    run("import d.glb").failed(
        1,
        "d.glb: binary glTF: the header with that of the JSON is 20 bytes, and 9 are there: is all of \
         the file there?",
    );
}

#[test]
fn binary_gltf_and_latin_1_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| run_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
    run("export look-at --to gltf --camera-only -o a.gltf");
    let json = fs::read(folder.path().join("a.gltf")).unwrap();
    let [length, whole] = [json.len(), json.len() + 20].map(|n| (n as u32).to_le_bytes());
    let binary = [&b"glTF"[..], &2_u32.to_le_bytes(), &whole, &length, b"JSON", &json].concat();
    fs::write(folder.path().join("a.glb"), binary).unwrap();
    assert_eq!(run("import a.glb").done(), run("import a.gltf").done());
    fs::write(folder.path().join("a.c"), [&b"// \xe9\n"[..], CANONICAL.as_bytes()].concat())
        .unwrap();
    fs::write(folder.path().join("b.c"), CANONICAL).unwrap();
    let told = run("import a.c");
    assert_eq!(told.stdout, run("import b.c").done());
    assert_eq!(told.stderr, "note: it is not UTF-8: read as Latin-1\n");
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
    child.stdin.take().unwrap().write_all(CANONICAL.as_bytes()).unwrap();
    let scene = finished(child.wait_with_output().unwrap()).done();
    assert!(scene.contains("at = [0.0, 0.0, -5.0]"), "{scene}");
}
