//! `pinhole bench`

use std::fs;
use std::path::Path;
use std::time::Duration;

use super::Run;
use super::command_in;
use super::entries;
use super::run;
use super::run_in;

/// Small, so that it is soon measured; a sphere and a plane.
const SCENE: &str = "pinhole = 1\n[camera]\neye = [0, 0, 0]\nview = [0, 0, -1]\nup = [0, 1, 0]\n\
                     [image]\nwidth = 12\nheight = 8\n[[sphere]]\ncenter = [0, 0, -5]\nradius = 1\n\
                     [[plane]]\npoint = [0, 0, -9]\nnormal = [0, 0, 1]\n";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.toml"), SCENE).unwrap();
    folder
}

fn bench(folder: &Path, line: &str) -> Run {
    run_in(folder, &line.split(' ').collect::<Vec<_>>())
}

fn json_of(text: &str) -> serde_json::Value {
    serde_json::from_str(text).unwrap()
}

/// The fields of an object, in alphabetical order.
fn fields(value: &serde_json::Value) -> Vec<&str> {
    let mut names: Vec<&str> = value.as_object().unwrap().keys().map(String::as_str).collect();
    names.sort_unstable();
    names
}

#[test]
fn a_table_with_the_ladder_the_rivals_and_the_limit() {
    let folder = folder();
    let table = bench(folder.path(), "bench s.toml").done();
    for part in [
        "cpu  ",
        "threads  ",
        "12 x 8",
        "× ladder  × stores\n",
        "\ns.toml  ladder ",
        " textbook ",
        " stores ",
        "\nleft out:\n  textbook-bvh (too few spheres for a tree): s.toml\n",
    ] {
        assert!(table.contains(part), "no {part:?} in\n{table}");
    }
    assert!(table.lines().all(|line| line.chars().count() <= 80), "{table}");
    assert_eq!(entries(folder.path()), ["s.toml"]);
}

#[test]
fn a_tree_from_a_hundred_spheres_on() {
    let folder = folder();
    let spheres: String = (0..100).map(|k| format!("{},0,-20,0.4\n", k - 50)).collect();
    fs::write(folder.path().join("many.csv"), format!("x,y,z,r\n{spheres}")).unwrap();
    let scene = SCENE.replace("pinhole = 1", "pinhole = 1\nspheres = \"many.csv\"");
    fs::write(folder.path().join("s.toml"), scene).unwrap();
    let table = bench(folder.path(), "bench s.toml").done();
    assert!(table.contains(" textbook-bvh  "), "{table}");
    assert!(
        table.contains("\n  textbook (asks all spheres: too many of them): s.toml\n"),
        "{table}"
    );
}

#[test]
fn json_is_the_contract_and_all_there_is_on_standard_output() {
    let folder = folder();
    for line in ["bench s.toml --json", "bench s.toml --json -", "bench --json -- s.toml"] {
        let answer = json_of(&bench(folder.path(), line).done());
        assert_eq!(fields(&answer), ["cpu", "rows", "threads"]);
        assert!(answer["threads"].as_u64().unwrap() > 0);
        let rows = answer["rows"].as_array().unwrap();
        for row in rows {
            assert_eq!(fields(row), ["method", "mrays_per_s", "ms", "scene"]);
            assert_eq!(row["scene"], "s.toml");
            let [median, min] = ["median", "min"].map(|name| row["ms"][name].as_f64().unwrap());
            assert!(0.0 < min && min <= median);
            // 96 pixels in so many milliseconds.
            let rate = row["mrays_per_s"].as_f64().unwrap();
            assert!((rate * median * 1e3 / 96.0 - 1.0).abs() < 1e-9, "{row}");
        }
        let methods: Vec<&str> = rows.iter().map(|row| row["method"].as_str().unwrap()).collect();
        let known = ["ladder", "uncertified", "textbook", "textbook-bvh", "stores"];
        assert!(methods.iter().all(|method| known.contains(method)), "{methods:?}");
        assert!(["ladder", "textbook", "stores"].iter().all(|name| methods.contains(name)));
    }
    assert_eq!(entries(folder.path()), ["s.toml"]);
}

#[test]
fn files_beside_the_table() {
    let folder = folder();
    let table = bench(folder.path(), "bench s.toml --json a.json --plot a.svg").done();
    assert!(table.contains("\ns.toml  ladder "), "{table}");
    let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(json_of(&read("a.json"))["rows"][0]["method"], "ladder");
    let svg = read("a.svg");
    for text in ["milliseconds a frame", "objects in the scene", "ladder", "textbook", "stores"] {
        assert!(svg.contains(&format!(">{text}</text>")), "{text}: {svg}");
    }
    assert!(!svg.contains(">textbook-bvh</text>"), "what was not run has no name there");

    bench(folder.path(), "bench canonical --plot a.PNG").done();
    let bytes = fs::read(folder.path().join("a.PNG")).unwrap();
    let image = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    assert_eq!(image.info().width, 1920);
    assert_eq!(entries(folder.path()), ["a.PNG", "a.json", "a.svg", "s.toml"]);
}

#[test]
fn wrong_arguments_are_told_before_anything_is_measured() {
    let folder = folder();
    let fails =
        |line: &str, status: i32, message: &str| bench(folder.path(), line).failed(status, message);
    fails("bench --plot a.pdf", 2, "--plot writes SVG or PNG: not a.pdf but a.svg or a.png");
    fails("bench --plot -", 2, "--plot needs a file: only --json can go to standard output");
    fails("bench --json a.csv", 2, "--json writes JSON: not a.csv but a.json");
    let message = "--json takes s.toml as the file to write: put scenes first, as in s.toml --json";
    fails("bench --json s.toml", 2, message);
    fails("bench --plot no/a.svg", 1, "no/a.svg: cannot be written: no such file or directory");
    fails(
        "bench --json a --plot a.svg no.toml",
        1,
        "no.toml: cannot be read: no such file or directory",
    );
    run("bench cannonical")
        .failed(1, "cannonical: neither a file nor a built-in scene: did you mean canonical?");
    run("bench canonical s.toml").refused("unexpected argument 's.toml'");
    fs::write(folder.path().join("s.toml"), SCENE.replace("[0, 1, 0]", "[0, 0, 2]")).unwrap();
    let run = bench(folder.path(), "bench s.toml");
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains("s.toml:5:6: "), "{}", run.stderr);
    assert_eq!(entries(folder.path()), ["s.toml"]);
}

/// The built-in series takes most of a minute, so it is sure to be interrupted.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing() {
    let folder = folder();
    let mut child = command_in(folder.path())
        .args(["bench", "--json", "a.json", "--plot", "a.png"])
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(300));
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.unwrap().success());
    assert!(!child.wait().unwrap().success());
    assert_eq!(entries(folder.path()), ["s.toml"]);
}
