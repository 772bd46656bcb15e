//! `pinhole report`

use std::fs;
use std::path::Path;
use std::time::Duration;

use super::{Run, command_in, entries, run, run_in};

/// Small, so that it is soon measured.
const SCENE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [image]\nwidth = 12\nheight = 8\n[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    fs::write(folder.path().join("two.toml"), SCENE.replace("-5", "-6")).unwrap();
    folder
}

fn report(folder: &Path, line: &str) -> Run {
    run_in(folder, &line.split(' ').collect::<Vec<_>>())
}

fn json_of(text: &str) -> serde_json::Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_table_that_says_what_it_rests_on() {
    let folder = folder();
    let table = report(folder.path(), "report s.toml").done();
    for part in ["reference  ", "cpu  ", "s.toml: ", "coverage ", "\nladder ", "\ntextbook-f32 "] {
        assert!(table.contains(part), "no {part:?} in\n{table}");
    }
    assert!(table.lines().all(|line| line.chars().count() <= 120), "{table}");
    assert_eq!(entries(folder.path()), ["s.toml", "two.toml"]);
}

#[test]
fn json_without_a_path_is_all_there_is_on_standard_output() {
    let folder = folder();
    for line in ["report s.toml --json", "report s.toml --json -", "report --json -- s.toml"] {
        let answer = json_of(&report(folder.path(), line).done());
        assert_eq!(answer["cases"][0]["name"], "s.toml");
        assert_eq!(answer["cases"][0]["knob"], serde_json::Value::Null);
        let methods = answer["cases"][0]["methods"].as_array().unwrap();
        let ladder = methods.iter().find(|method| method["name"] == "ladder").unwrap();
        assert_eq!(ladder["wrong"], 0);
        assert!(ladder["decisions"].as_u64().unwrap() > 0);
        assert!(ladder["ns_per_pixel"]["median"].as_f64().unwrap() > 0.0);
    }
    assert_eq!(entries(folder.path()), ["s.toml", "two.toml"]);
}

/// The fields that the command line promises; further ones may be added.
#[test]
fn json_has_the_fields_of_the_contract() {
    let folder = folder();
    let answer = json_of(&report(folder.path(), "report s.toml --json").done());
    let has = |object: &serde_json::Value, fields: &[&str]| {
        let missing: Vec<_> = fields.iter().filter(|field| object.get(field).is_none()).collect();
        assert!(missing.is_empty(), "no {missing:?} in {object:#}");
    };
    has(&answer, &["reference", "cpu", "cases", "left_out"]);
    assert!(answer["reference"].is_string() && answer["cpu"].is_string());
    assert!(answer["left_out"].as_array().unwrap().iter().all(|text| text.is_string()));
    let case = &answer["cases"][0];
    has(case, &["name", "knob", "coverage", "methods"]);
    let methods = case["methods"].as_array().unwrap();
    for method in methods {
        let numbers = ["wrong", "decisions", "normal_error_max"];
        has(method, &["name", "ulp", "ns_per_pixel", "steps"]);
        has(method, &numbers);
        has(&method["ulp"], &["median", "p99", "max"]);
        has(&method["ns_per_pixel"], &["median", "min"]);
        if !method["steps"].is_null() {
            has(&method["steps"], &["f64", "double_double", "exact"]);
        }
    }
    let formulas =
        ["textbook", "half-b", "kahan", "perpendicular", "closest-point", "recentred", "lagrange"];
    let with_precision = |formula: &str| ["f32", "f64"].map(|type_| format!("{formula}-{type_}"));
    let ladder = ["ladder", "ladder-f32", "double-double"].map(str::to_owned);
    for name in ladder.into_iter().chain(formulas.into_iter().flat_map(with_precision)) {
        assert!(methods.iter().any(|method| method["name"] == *name), "no {name}");
    }
    let ladder = methods.iter().find(|method| method["name"] == "ladder").unwrap();
    assert!(ladder["steps"].is_object());
    let help = run("report --help").done();
    let words: Vec<&str> = help.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    for field in fields_of(&answer) {
        assert!(words.contains(&field.as_str()), "the help does not explain {field}");
    }
}

/// Returns the names of all fields, at any depth.
fn fields_of(value: &serde_json::Value) -> Vec<String> {
    match value {
        serde_json::Value::Object(fields) => {
            let nested = fields.values().flat_map(fields_of);
            fields.keys().cloned().chain(nested).collect()
        }
        serde_json::Value::Array(values) => values.iter().flat_map(fields_of).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn several_scenes_are_several_cases_in_every_file() {
    let folder = folder();
    let line = "report s.toml two.toml --json a.json --plot a.svg";
    let table = report(folder.path(), line).done();
    assert!(table.contains("\ns.toml: ") && table.contains("\ntwo.toml: "), "{table}");
    assert_eq!(
        entries(folder.path()),
        ["a-2.svg", "a-3.svg", "a.json", "a.svg", "s.toml", "two.toml"]
    );
    let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(json_of(&read("a.json"))["cases"].as_array().unwrap().len(), 2);
    // The summary is the first page.
    assert!(read("a.svg").contains(">wrong decisions</tspan>"), "{}", read("a.svg"));
    assert!(read("a-2.svg").contains(">s.toml</tspan>"));
    assert!(read("a-3.svg").contains(">two.toml</tspan>"));
}

#[test]
fn a_plot_may_be_pixels() {
    let folder = folder();
    report(folder.path(), "report s.toml --plot a.PNG").done();
    let bytes = fs::read(folder.path().join("a.PNG")).unwrap();
    let image = image_of(&bytes);
    assert_eq!((image.width, image.height), (1920, 1080));
    assert_eq!(entries(folder.path()), ["a.PNG", "s.toml", "two.toml"]);
}

fn image_of(bytes: &[u8]) -> png::OutputInfo {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap()
}

#[test]
fn wrong_arguments_are_told_before_anything_is_measured() {
    let folder = folder();
    let fails = |line: &str, status: i32, message: &str| {
        report(folder.path(), line).failed(status, message)
    };
    fails("report --plot a.pdf", 2, "--plot writes SVG or PNG: not a.pdf but a.svg or a.png");
    fails("report --plot a", 2, "--plot writes SVG or PNG: not a but a.svg or a.png");
    fails("report --json a.csv", 2, "--json writes JSON: not a.csv but a.json");
    for scene in ["canonical", "s.toml"] {
        let message = format!(
            "--json takes {scene} as the file to write: put scenes first, as in {scene} --json"
        );
        fails(&format!("report --json {scene}"), 2, &message);
    }
    fails("report --plot no/a.svg", 1, "no/a.svg: cannot be written: no such file or directory");
    fails("report --plot a.svg --json a.svg", 2, "--json writes JSON: not a.svg but a.json");
    fails("report --plot -", 2, "--plot needs a file: only --json can go to standard output");
    fails("report s.toml no.toml", 1, "no.toml: cannot be read: no such file or directory");
    run("report canonical cannonical")
        .failed(1, "cannonical: neither a file nor a built-in scene: did you mean canonical?");
    run("report --seed x").refused("invalid value 'x' for '--seed <N>'");
    assert_eq!(entries(folder.path()), ["s.toml", "two.toml"]);
}

#[test]
fn no_page_of_the_plot_is_written_over_a_scene() {
    let folder = folder();
    fs::rename(folder.path().join("two.toml"), folder.path().join("o-2.svg")).unwrap();
    let message =
        "--plot would write over o-2.svg, which is read as ./o-2.svg: choose another name";
    report(folder.path(), "report ./o-2.svg s.toml --plot o.svg").failed(2, message);
    assert_eq!(entries(folder.path()), ["o-2.svg", "s.toml"]);
    // A single scene has a single page.
    report(folder.path(), "report ./o-2.svg --plot o.svg").done();
    assert!(fs::read_to_string(folder.path().join("o-2.svg")).unwrap().starts_with("pinhole = 1"));
}

#[test]
fn a_scene_at_fault_is_told_at_its_place() {
    let folder = folder();
    fs::write(folder.path().join("s.toml"), SCENE.replace("[0, 1, 0]", "[0, 0, 2]")).unwrap();
    let run = report(folder.path(), "report two.toml s.toml");
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains("s.toml:5:6: "), "{}", run.stderr);
}

/// All families take minutes, so they are sure to be interrupted.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing() {
    let folder = folder();
    let mut child = command_in(folder.path())
        .args(["report", "--json", "a.json", "--plot", "a.png"])
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(300));
    // Not SIGINT, which a shell has its background jobs ignore until they say otherwise.
    super::send_signal(&child, "TERM");
    assert!(!child.wait().unwrap().success());
    assert_eq!(entries(folder.path()), ["s.toml", "two.toml"]);
}
