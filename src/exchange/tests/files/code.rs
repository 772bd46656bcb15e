//! Tests of exported code: compiled and run, it gives the same rays as this program.
//!
//! A language whose tools are not installed is skipped with a message; with
//! `PINHOLE_TEST_CODE=required`, that is an error. Only the program `julia` may always be missing,
//! because no package registry has it. A Julia grammar from npm is used, too, in the folder
//! `PINHOLE_TEST_NODE_MODULES`.

#![allow(clippy::print_stdout, reason = "CI shows which languages ran, and how far they were off")]

use std::fs;
use std::path::Path;
use std::process::Command;

use expect_test::expect_file;
use pinhole_core::{Camera, DVec3, Orientation, Pixel, ResolvedCamera, Viewport};
use pinhole_exchange::code::LANGUAGES;
use pinhole_exchange::document::Document;
use pinhole_exchange::format::{ExportScene, Include};
use pinhole_exchange::scenes::SceneSource;

/// The code that was exported to Rust for two cameras, compiled into this test.
mod glam_look_at {
    #![allow(dead_code, missing_docs, clippy::print_stdout, clippy::excessive_precision)]
    include!("code/look-at.rs");
    pub(super) fn of(i: u32, j: u32) -> (DVec3, DVec3) {
        ray(i, j)
    }
}
mod glam_extreme {
    #![allow(dead_code, missing_docs, clippy::print_stdout, clippy::excessive_precision)]
    include!("code/extreme.rs");
    pub(super) fn of(i: u32, j: u32) -> (DVec3, DVec3) {
        ray(i, j)
    }
}

fn camera(scene: &str) -> ResolvedCamera {
    let source = SceneSource::from_argument(Path::new(scene)).unwrap();
    source.load().unwrap().camera.resolve().unwrap()
}

/// Numbers of all sizes.
fn extreme() -> ResolvedCamera {
    let camera = Camera {
        eye: DVec3::new(1e16, -0.1, 1.0 / 3.0),
        orientation: Orientation::View { view: DVec3::new(1.0, 2e-7, -3.0), up: DVec3::Y },
        viewport: Viewport { width: 1e-12, height: 2.5e-13, distance: 7e20 },
        ..Camera::CANONICAL
    };
    camera.resolve().unwrap()
}

fn code(language: &str, camera: &ResolvedCamera) -> Result<String, String> {
    let orientation = Orientation::Basis(*camera.basis());
    let (eye, viewport, image) = (camera.eye(), *camera.viewport(), camera.image());
    let camera = Camera { eye, orientation, viewport, image };
    let document = Document { camera, ..Document::default() };
    let subject = ExportScene::new(&document, Include::CameraAlone).unwrap();
    let language = LANGUAGES.iter().find(|known| known.name == language).unwrap();
    language.write(&subject).map(|written| written.text.text).map_err(|error| error.to_string())
}

/// Returns pixels to compare: the corners and some inside the image.
fn pixels(camera: &ResolvedCamera) -> Vec<Pixel> {
    let (last_row, last_column) = (camera.image().height() - 1, camera.image().width() - 1);
    let corners = [(0, 0), (0, last_column), (last_row, 0), (last_row, last_column)];
    let inside = [(1, 2), (2, 1), (4, 5)].map(|(a, b)| (last_row / (a + 1), last_column / (b + 1)));
    corners.into_iter().chain(inside).map(|(row, column)| Pixel { row, column }).collect()
}

/// Returns the larger of the relative errors of an origin and a direction, compared with the camera's
/// ray.
fn error(camera: &ResolvedCamera, pixel: Pixel, origin: DVec3, direction: DVec3) -> f64 {
    let ray = camera.ray_of_pixel(pixel);
    let apart = |a: DVec3, b: DVec3| a.distance(b) / a.length().max(f64::MIN_POSITIVE);
    apart(ray.origin, origin).max(apart(ray.direction, direction))
}

/// Returns the largest error over all pixels, for each of which there are six numbers: origin and
/// direction.
fn worst_error(camera: &ResolvedCamera, pixels: &[Pixel], numbers: &[f64]) -> f64 {
    assert_eq!(numbers.len(), 6 * pixels.len(), "{numbers:?}");
    let errors = numbers
        .chunks(6)
        .zip(pixels)
        .map(|(n, pixel)| error(camera, *pixel, DVec3::from_slice(n), DVec3::from_slice(&n[3..])));
    errors.fold(0.0, f64::max)
}

fn numbers_of(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|word| word.parse().unwrap()).collect()
}

/// The names and contents of files.
type Files = Vec<(&'static str, String)>;

/// How to run the exported code in a language. The run prints six numbers per pixel: origin and
/// direction.
struct Runner {
    language: &'static str,
    /// A command that succeeds if the required program is installed.
    needs: &'static [&'static str],
    tolerance: f64,
    /// Returns the files to write for the exported code and calls of it for these pixels.
    files: fn(&str, &[Pixel]) -> Files,
    run: &'static [&'static [&'static str]],
}

fn calls(pixels: &[Pixel], call: fn(u32, u32) -> String) -> String {
    pixels.iter().map(|pixel| call(pixel.row, pixel.column) + "\n").collect()
}

const RUNNERS: [Runner; 5] = [
    Runner {
        language: "numpy",
        needs: &["python3", "-c", "import numpy"],
        tolerance: 1e-12,
        files: |code, pixels| {
            let calls = calls(pixels, |i, j| format!("for p in ray({i}, {j}): print(*p.tolist())"));
            vec![
                ("camera.py", code.to_owned()),
                ("run.py", format!("from camera import ray\n{calls}")),
            ]
        },
        run: &[&["python3", "run.py"], &["python3", "camera.py"]],
    },
    Runner {
        language: "javascript",
        needs: &["node", "--version"],
        tolerance: 1e-12,
        files: |code, pixels| {
            let calls =
                calls(pixels, |i, j| format!("console.log(ray({i}, {j}).flat().join(' '));"));
            let quiet = code.replace("console.log(ray(0, 0));", "");
            vec![("camera.js", code.to_owned()), ("run.js", format!("{quiet}{calls}"))]
        },
        run: &[&["node", "run.js"], &["node", "camera.js"]],
    },
    Runner {
        language: "julia",
        needs: &["julia", "--version"],
        tolerance: 1e-12,
        files: |code, pixels| {
            let calls =
                calls(pixels, |i, j| format!("for p in ray({i}, {j}) println(join(p, ' ')) end"));
            vec![
                ("camera.jl", code.to_owned()),
                ("run.jl", format!("include(\"camera.jl\")\n{calls}")),
            ]
        },
        run: &[&["julia", "run.jl"], &["julia", "camera.jl"]],
    },
    Runner {
        language: "glm",
        needs: &["g++", "-fsyntax-only", "-include", "glm/glm.hpp", "-x", "c++", "/dev/null"],
        tolerance: 1e-12,
        files: |code, pixels| {
            let calls = calls(pixels, |i, j| format!("say(ray({i}, {j}));"));
            let say = "void put(glm::dvec3 p) { std::printf(\"%.17g %.17g %.17g \", p.x, p.y, p.z); }\n\
                       void say(Ray r) { put(r.origin), put(r.direction); }";
            let run = code.replace("int main()", "void example()")
                + &format!("{say}\nint main() {{\n{calls}}}\n");
            vec![("camera.cpp", code.to_owned()), ("run.cpp", run)]
        },
        run: &[
            &["g++", "-Wall", "-Werror", "run.cpp", "-o", "run"],
            &["./run"],
            &["g++", "-Wall", "-Werror", "camera.cpp", "-o", "camera"],
        ],
    },
    Runner {
        // With GLM, the shader's text, except for its first lines, is valid C++, and computes in `f32`,
        // as on a GPU.
        language: "glsl",
        needs: &["g++", "-fsyntax-only", "-include", "glm/glm.hpp", "-x", "c++", "/dev/null"],
        tolerance: 1e-6,
        files: |code, pixels| {
            let calls = calls(pixels, |i, j| format!("say(ray({i}, {j}));"));
            let shader =
                code.replace("#version 330 core\nout ", "").replace("void main", "void shade");
            let run = format!(
                "#include <cstdio>\n#include <glm/glm.hpp>\nusing namespace glm;\nvec4 gl_FragCoord;\n{shader}\n\
                 void put(vec3 p) {{ std::printf(\"%.9g %.9g %.9g \", p.x, p.y, p.z); }}\n\
                 void say(Ray r) {{ put(r.origin), put(r.direction); }}\nint main() {{\n{calls}}}\n"
            );
            vec![("run.cpp", run)]
        },
        run: &[
            &[
                "g++",
                "-std=c++20",
                "-fsingle-precision-constant",
                "-Wall",
                "-Werror",
                "run.cpp",
                "-o",
                "run",
            ],
            &["./run"],
        ],
    },
];

fn must_run(language: &str) -> bool {
    let required = std::env::var("PINHOLE_TEST_CODE").is_ok_and(|value| value == "required");
    required && language != "julia"
}

/// `PINHOLE_TEST_PYTHON` is the Python that has NumPy.
fn command(program: &str) -> Command {
    let python = std::env::var_os("PINHOLE_TEST_PYTHON").filter(|_| program == "python3");
    Command::new(python.unwrap_or_else(|| program.into()))
}

fn is_there(program: &[&str]) -> bool {
    command(program[0]).args(&program[1..]).output().is_ok_and(|output| output.status.success())
}

/// Runs all commands of a language, and returns the numbers that the first one prints.
fn numbers(runner: &Runner, code: &str, pixels: &[Pixel]) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in (runner.files)(code, pixels) {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let mut numbers = Vec::new();
    for line in runner.run {
        let mut run = match line[0] {
            "./run" => Command::new(folder.path().join("run")),
            program => command(program),
        };
        let output = run.args(&line[1..]).current_dir(folder.path()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{line:?}: {said}");
        if numbers.is_empty() {
            let text = String::from_utf8(output.stdout).unwrap();
            numbers = numbers_of(&text);
        }
    }
    numbers
}

#[test]
fn every_language_gives_this_programs_rays() {
    let cameras = [("look-at", camera("look-at")), ("non-square", camera("non-square"))];
    for runner in RUNNERS {
        let language = runner.language;
        if !is_there(runner.needs) {
            assert!(!must_run(language), "{language} is not there: {:?}", runner.needs);
            println!("{language}: left out, {:?} does not run", runner.needs);
            continue;
        }
        let extreme = [("extreme", extreme())];
        let double = runner.tolerance < 1e-9;
        for (name, camera) in cameras.iter().chain(extreme.iter().filter(|_| double)) {
            let pixels = pixels(camera);
            let numbers = numbers(&runner, &code(language, camera).unwrap(), &pixels);
            let worst = worst_error(camera, &pixels, &numbers);
            println!("{language}, {name}: {} rays, {worst:.1e} off at most", pixels.len());
            assert!(worst <= runner.tolerance, "{language}, {name}: {worst:e}");
        }
    }
}

/// Tests the Julia code without Julia: `julia.mjs` parses it with a grammar, and evaluates the syntax
/// tree.
#[test]
fn julia_is_read_by_its_grammar() {
    let modules = std::env::var("PINHOLE_TEST_NODE_MODULES").unwrap_or("node_modules".into());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/files/julia.mjs");
    if !Path::new(&modules).join("@plutojl/lezer-julia").exists() || !is_there(&["node", "-v"]) {
        assert!(!must_run("Julia's grammar"), "no Node or no grammar of Julia in {modules}");
        println!("Julia's grammar: left out, no Node or not in {modules}");
        return;
    }
    for (name, camera) in [("non-square", camera("non-square")), ("extreme", extreme())] {
        let pixels = pixels(&camera);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("camera.jl");
        fs::write(&path, code("julia", &camera).unwrap()).unwrap();
        let mut run = Command::new("node");
        run.arg(&script).arg(&modules).arg(&path);
        let numbers = pixels.iter().flat_map(|pixel| [pixel.row, pixel.column]);
        let output = run.args(numbers.map(|number| number.to_string())).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).unwrap();
        let worst = worst_error(&camera, &pixels, &numbers_of(&text));
        println!("Julia's grammar, {name}: {} rays, {worst:.1e} off at most", pixels.len());
        assert!(worst <= 1e-12, "{name}: {worst:e}");
    }
}

#[test]
fn the_shader_is_glsl() {
    if !is_there(&["glslangValidator", "--version"]) {
        assert!(!must_run("glsl"), "glslangValidator is not there");
        println!("glslangValidator: left out, it is not installed");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("camera.frag");
    fs::write(&path, code("glsl", &camera("look-at")).unwrap()).unwrap();
    let output = Command::new("glslangValidator").arg(&path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    println!("glslangValidator: the shader is valid");
}

#[test]
fn rust_gives_this_programs_rays() {
    let assert_rays = |camera: ResolvedCamera, ray: fn(u32, u32) -> (DVec3, DVec3)| {
        for pixel in pixels(&camera) {
            let (origin, direction) = ray(pixel.row, pixel.column);
            assert!(error(&camera, pixel, origin, direction) <= 1e-12, "{pixel:?}");
        }
    };
    assert_rays(camera("look-at"), glam_look_at::of);
    assert_rays(extreme(), glam_extreme::of);
}

/// `UPDATE_EXPECT=1` writes them anew.
#[test]
fn the_code_reads_as_it_did() {
    for language in LANGUAGES {
        let code = code(language.name, &camera("look-at")).unwrap();
        expect_file![format!("code/look-at.{}", language.ending())].assert_eq(&code);
        assert!(code.lines().all(|line| line.chars().count() <= 120), "{code}");
    }
    expect_file!["code/extreme.rs"].assert_eq(&code("glam", &extreme()).unwrap());
}

#[test]
fn numbers_beyond_f32_are_refused_where_there_is_no_more() {
    let refused = |camera: Camera| code("glsl", &camera.resolve().unwrap()).unwrap_err();
    let right = "and GLSL calculates in f32: it must be between 1e-37 and 1e38 in size";
    let viewport = Viewport { distance: 1e-40, ..Viewport::CANONICAL };
    assert_eq!(
        refused(Camera { viewport, ..Camera::CANONICAL }),
        format!("the viewport's distance has the number 1e-40, {right}")
    );
    let view = Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y };
    assert_eq!(
        refused(Camera {
            eye: DVec3::new(1.0, 1e-50, -1e39),
            orientation: view,
            ..Camera::CANONICAL
        }),
        format!("eye has the number -1e39, {right}")
    );
}
