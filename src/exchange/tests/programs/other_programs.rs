//! Tests with the other programs themselves: each reads what was exported, and prints which object it
//! has at every pixel's centre, or where it sees points. Pixels whose centre is within half a pixel of
//! an outline are not compared; all others must agree.
//!
//! A program that is not installed is skipped with a message, unless `PINHOLE_TEST_PROGRAMS` is
//! `required` or lists its name, as in `povray,numpy`. `PINHOLE_TEST_PYTHON` is the Python interpreter
//! that has numpy, mitsuba, cv2 and bpy; `PINHOLE_TEST_NODE_MODULES` is the folder with three and
//! gltf-validator.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use pinhole_core::{DVec2, DVec3, Pixel, ResolvedCamera, Scene};
use pinhole_exchange::document::Document;
use pinhole_exchange::format::Include;

use super::{proofs, written};

/// Returns true if a program is installed, which is so if the command `probe` succeeds. Panics if it is
/// required but not installed.
fn there(name: &str, probe: &mut Command) -> bool {
    let found = probe.output().is_ok_and(|output| output.status.success());
    let wanted = env::var("PINHOLE_TEST_PROGRAMS").unwrap_or_default();
    let required = wanted == "required" || wanted.split(',').any(|wanted| wanted == name);
    assert!(found || !required, "{name} is required by PINHOLE_TEST_PROGRAMS, and is not there");
    println!("{name}: {}", if found { "there" } else { "not there, left out" });
    found
}

fn python() -> Command {
    let python = env::var_os("PINHOLE_TEST_PYTHON").unwrap_or_else(|| "python3".into());
    Command::new(python)
}

fn python_with(name: &str, module: &str) -> bool {
    there(name, python().args(["-c", &format!("import {module}")]))
}

fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs/other_programs").join(name)
}

fn output(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {complaint}");
    String::from_utf8(output.stdout).unwrap()
}

/// Returns the object at every pixel's centre (-1 for none), or `None` if the centre is within half a
/// pixel of an outline.
fn clear_objects(document: &Document) -> Vec<Vec<Option<i64>>> {
    let camera = document.camera.resolve().unwrap();
    let scene = document.scene().unwrap();
    let image = camera.image();
    let object = |row, column| clear_object(&camera, &scene, Pixel { row, column });
    let row = |row| (0..image.width()).map(|column| object(row, column)).collect();
    (0..image.height()).map(row).collect()
}

fn clear_object(camera: &ResolvedCamera, scene: &Scene, pixel: Pixel) -> Option<i64> {
    let viewport = camera.viewport();
    let side = DVec2::new(
        viewport.width / f64::from(camera.image().width()),
        viewport.height / f64::from(camera.image().height()),
    );
    let object = |offset: DVec2| {
        let ray = camera.exact_ray_at(camera.uv_of_pixel(pixel) + offset * side).unwrap();
        scene.first_hit_of(&ray).map_or(-1, |hit| i64::from(hit.object))
    };
    let own = object(DVec2::ZERO);
    let round = (0..24).map(|k| DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 24.0));
    round.map(|offset| object(0.5 * offset)).all(|other| other == own).then_some(own)
}

/// Compares a program's table of objects, with one line per row of the image, with this program's
/// picture.
fn assert_agrees(program: &str, scene: &str, document: &Document, table: &str) {
    let theirs: Vec<Vec<i64>> = table
        .lines()
        .map(|line| line.split_whitespace().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let ours = clear_objects(document);
    assert_eq!(theirs.len(), ours.len(), "{program}, {scene}: rows");
    let mut clear = 0;
    for (i, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
        assert_eq!(theirs.len(), ours.len(), "{program}, {scene}: columns");
        for (j, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
            if let Some(ours) = ours {
                assert_eq!(theirs, ours, "{program}, {scene}: row {i}, column {j}");
                clear += 1;
            }
        }
    }
    let seen: std::collections::BTreeSet<_> = ours.iter().flatten().flatten().collect();
    assert_eq!(seen.len(), 5, "{scene} must show all four spheres and the background");
    println!("{program}: {scene}: {clear} of {} pixels agree", ours.len() * ours[0].len());
}

/// Returns a temporary folder with the exported file, and with the spheres both as JSON and as lines of
/// numbers.
fn folder_of(format: &str, document: &Document, with: Include) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = written(format, document, with).text.text;
    fs::write(folder.path().join(super::format(format).file), text).unwrap();
    let spheres: Vec<String> = document
        .spheres
        .iter()
        .map(|item| {
            let (c, r) = (item.shape.center, item.shape.radius);
            format!("[{:?}, {:?}, {:?}, {r:?}]", c.x, c.y, c.z)
        })
        .collect();
    fs::write(folder.path().join("spheres.json"), format!("[{}]", spheres.join(", "))).unwrap();
    let lines = spheres.join("\n").replace(['[', ']', ','], "");
    fs::write(folder.path().join("spheres.txt"), lines).unwrap();
    folder
}

fn size(document: &Document) -> [String; 2] {
    [document.camera.image.width(), document.camera.image.height()].map(|n| n.to_string())
}

#[test]
fn pov_ray_renders_the_same_picture() {
    if !there("povray", Command::new("povray").arg("--help")) {
        return;
    }
    for (name, document) in proofs() {
        let folder = folder_of("povray", &document, Include::Objects);
        // Each object is drawn in its own colour, regardless of light.
        let file = folder.path().join("scene.pov");
        let text = fs::read_to_string(&file).unwrap();
        let flat = text.replace("ambient 0 diffuse 1", "ambient 1 diffuse 0");
        assert_ne!(flat, text);
        fs::write(&file, flat).unwrap();
        let [width, height] = size(&document);
        output(Command::new("povray").current_dir(folder.path()).args([
            "+Iscene.pov",
            "+Oout.ppm",
            "+FP",
            "-D",
            "-A",
            "-GA",
            &format!("+W{width}"),
            &format!("+H{height}"),
        ]));
        let picture = fs::read(folder.path().join("out.ppm")).unwrap();
        let pixels = &picture[picture.len()
            - 3 * width.parse::<usize>().unwrap() * height.parse::<usize>().unwrap()..];
        let object = |pixel: &[u8]| {
            let own = document.spheres.iter().position(|s| s.color.unwrap()[..] == *pixel);
            own.map_or("-1".to_owned(), |k| k.to_string())
        };
        let row = |row: &[u8]| row.chunks(3).map(object).collect::<Vec<_>>().join(" ");
        let rows: Vec<String> =
            pixels.chunks(3 * width.parse::<usize>().unwrap()).map(row).collect();
        assert_agrees("POV-Ray", name, &document, &rows.join("\n"));
    }
}

#[test]
fn mitsuba_has_the_same_objects() {
    if !python_with("mitsuba", "mitsuba") {
        return;
    }
    for (name, document) in proofs().into_iter().filter(|(name, _)| *name != "not-square") {
        let folder = folder_of("mitsuba", &document, Include::Objects);
        let scene = folder.path().join("scene.xml");
        let table =
            output(python().arg(script("mitsuba_rays.py")).arg(scene).args(size(&document)));
        assert_agrees("Mitsuba", name, &document, &table);
    }
}

#[test]
fn numpy_has_the_same_rays() {
    if !python_with("numpy", "numpy") {
        return;
    }
    let forms = [("opencv", "camera.json"), ("pbrt", "scene.pbrt"), ("course", "camera.jl")];
    for (form, file) in forms {
        for (name, document) in proofs() {
            if form == "course" && name == "not-square" {
                continue;
            }
            let folder = folder_of(form, &document, Include::Objects);
            let mut run = python();
            run.arg(script("numpy_rays.py")).arg(form).arg(folder.path().join(file));
            run.args(size(&document)).arg(folder.path().join("spheres.json"));
            assert_agrees(&format!("NumPy ({form})"), name, &document, &output(&mut run));
        }
    }
}

#[test]
fn blender_has_the_same_rays() {
    if !python_with("blender", "bpy") {
        return;
    }
    for (name, document) in proofs() {
        let folder = folder_of("blender", &document, Include::Objects);
        let mut run = python();
        run.arg(script("blender_rays.py")).arg(folder.path().join("scene.py"));
        run.args(size(&document)).arg(folder.path().join("spheres.json"));
        let said = output(&mut run);
        // Blender has a word to say of its own.
        let table: Vec<&str> = said
            .lines()
            .filter(|line| line.split_whitespace().all(|cell| cell.parse::<i64>().is_ok()))
            .collect();
        assert_agrees("Blender", name, &document, &table.join("\n"));
    }
}

/// Returns points in front of the camera, and their positions in the image in pixels, with x right and
/// y down from its corner.
fn points(document: &Document) -> (String, Vec<DVec2>) {
    let camera = document.camera.resolve().unwrap();
    let (viewport, image) = (*camera.viewport(), camera.image());
    let points: Vec<DVec3> = (0..40)
        .map(|k| {
            let k = f64::from(k);
            let uv =
                DVec2::new((1.7 * k).sin() * viewport.width, (2.3 * k).cos() * viewport.height);
            camera.ray(0.5 * uv).at(1.0 + 0.3 * k)
        })
        .collect();
    let seen = points.iter().map(|point| {
        let uv = camera.project(*point).uv;
        let x = (uv.x / viewport.width + 0.5) * f64::from(image.width());
        let y = (0.5 - uv.y / viewport.height) * f64::from(image.height());
        DVec2::new(x, y)
    });
    let text: Vec<String> =
        points.iter().map(|p| format!("[{:?}, {:?}, {:?}]", p.x, p.y, p.z)).collect();
    (format!("[{}]", text.join(", ")), seen.collect())
}

fn assert_sees(program: &str, scene: &str, seen: &[DVec2], offset: f64, table: &str) {
    let theirs: Vec<DVec2> = table
        .lines()
        .map(|line| {
            let (x, y) = line.split_once(' ').unwrap();
            DVec2::new(x.parse().unwrap(), y.parse().unwrap())
        })
        .collect();
    assert_eq!(theirs.len(), seen.len());
    for (ours, theirs) in seen.iter().zip(&theirs) {
        let theirs = *theirs + offset;
        assert!((theirs - *ours).length() < 1e-9, "{program}, {scene}: {theirs} for {ours}");
    }
    println!("{program}: {scene}: {} points agree", seen.len());
}

#[test]
fn opencv_sees_points_in_the_same_places() {
    if !python_with("opencv", "cv2") {
        return;
    }
    for (name, document) in proofs() {
        let folder = folder_of("opencv", &document, Include::CameraAlone);
        let (text, seen) = points(&document);
        fs::write(folder.path().join("points.json"), text).unwrap();
        let mut run = python();
        run.arg(script("opencv_points.py")).arg(folder.path().join("camera.json"));
        let table = output(run.arg(folder.path().join("points.json")));
        // Its first pixel's centre is (0, 0).
        assert_sees("OpenCV", name, &seen, 0.5, &table);
    }
}

fn node_modules() -> PathBuf {
    env::var_os("PINHOLE_TEST_NODE_MODULES").map_or("node_modules".into(), PathBuf::from)
}

#[test]
fn three_js_and_gltf_have_the_same_objects() {
    let modules = node_modules();
    let has = |name: &str| format!("require('{}/{name}')", modules.display());
    let forms = [
        ("three", "three", "scene.json", Include::Objects),
        ("gltf", "gltf-validator", "scene.gltf", Include::Meshes),
    ];
    for (format, module, file, with) in forms {
        let three = has("three/package.json");
        let probe = format!("{three}; {}", has(&format!("{module}/package.json")));
        if !there(format, Command::new("node").args(["-e", &probe])) {
            continue;
        }
        for (name, document) in proofs() {
            let folder = folder_of(format, &document, with);
            let mut run = Command::new("node");
            run.arg(script("three_rays.mjs")).arg(&modules).arg(folder.path().join(file));
            let table = output(run.args(size(&document)));
            assert_agrees(&format!("three.js ({format})"), name, &document, &table);
        }
    }
}

/// Compiles a C++ program that includes the exported code, runs it, and returns its output.
fn compiled(source: &str, folder: &Path) -> String {
    let program = folder.join("program");
    let include = |path: &Path| format!("-I{}", path.display());
    output(
        Command::new("c++")
            .args(["-std=c++17", "-O1", "-w", &include(folder), &include(&script(""))])
            .arg(script(source))
            .arg("-o")
            .arg(&program),
    );
    output(Command::new(&program).arg(folder.join("spheres.txt")))
}

#[test]
fn c_plus_plus_has_the_same_rays() {
    let forms = [("opengl", "glm", "glm/glm.hpp"), ("weekend", "c++", "vector")];
    for (form, name, header) in forms {
        let mut probe = Command::new("c++");
        probe.args(["-x", "c++", "-include", header, "-fsyntax-only", "/dev/null"]);
        if !there(name, &mut probe) {
            continue;
        }
        for (scene, document) in proofs() {
            if form == "weekend" && scene == "not-square" {
                continue;
            }
            let with = if form == "weekend" { Include::Objects } else { Include::CameraAlone };
            let folder = folder_of(form, &document, with);
            let table = compiled(&format!("{form}_rays.cpp"), folder.path());
            assert_agrees(&format!("C++ ({form})"), scene, &document, &table);
        }
    }
}
