//! The invariants of the layout, absences included.

mod floors;
mod planted;
mod uses;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn source_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            source_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

fn sources(folder: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    source_files(&root().join(folder), &mut found);
    assert!(!found.is_empty());
    found
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(root()).unwrap().to_str().unwrap().to_owned();
            let text = fs::read_to_string(path).unwrap();
            (name, text)
        })
        .collect()
}

#[test]
fn core_depends_on_no_window_and_no_file_format() {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "-p", "pinhole-core", "-e", "normal", "--prefix", "none"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let tree = String::from_utf8(tree.stdout).unwrap();
    let crates: BTreeSet<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(crates.contains("glam") && crates.contains("pinhole-core"), "{crates:?}");
    for forbidden in [
        "egui",
        "epaint",
        "egui-wgpu",
        "wgpu",
        "winit",
        "tiny-skia",
        "toml_edit",
        "serde_json",
        "csv",
        "png",
        "exr",
    ] {
        assert!(!crates.contains(forbidden), "pinhole-core depends on {forbidden}");
    }
}

#[test]
fn wgpu_is_known_to_one_file_only() {
    let knows = |text: &str| text.contains("wgpu::");
    let files: Vec<String> = sources("src")
        .into_iter()
        .filter_map(|(name, text)| knows(&text).then_some(name))
        .collect();
    assert_eq!(files, ["src/platform/desktop/gpu.rs"]);
}

#[test]
fn what_is_pure_knows_no_effect() {
    for (name, text) in sources("src") {
        let pure = name.starts_with("src/core/")
            || [
                "src/view/overlay/",
                "src/view/formula/",
                "src/view/derivation/",
                "src/exchange/programs/",
            ]
            .iter()
            .any(|f| name.starts_with(f))
            || [
                "src/exchange/document.rs",
                "src/view/derive/mod.rs",
                "src/model/inspection.rs",
                "src/model/lines.rs",
            ]
            .contains(&name.as_str());
        let may = ["/tests/", "/benches/", "/examples/"].iter().any(|part| name.contains(part));
        if pure && !may {
            for effect in
                ["std::fs", "std::env", "std::process", "std::time", "println!", "eprintln!"]
            {
                assert!(!text.contains(effect), "{name} uses {effect}");
            }
        }
    }
}

#[test]
fn formulas_the_derivation_and_exchange_know_no_window() {
    for (name, text) in sources("src") {
        if ["src/view/formula/", "src/view/derivation/", "src/exchange/"]
            .iter()
            .any(|f| name.starts_with(f))
        {
            assert!(!text.contains("egui"), "{name} knows egui");
        }
    }
}

#[test]
fn the_top_level_holds_what_it_should() {
    // What is built and what is hidden is no part of the layout; neither needs git to be told.
    let top: BTreeSet<String> = fs::read_dir(root())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name != "target" && !name.starts_with('.'))
        .collect();
    assert!(top.contains("Cargo.toml") && top.contains("src"), "{top:?}");
    let known = [
        "Cargo.lock",
        "Cargo.toml",
        "LICENSE-APACHE",
        "LICENSE-MIT",
        "README.md",
        "assets",
        "src",
        "tests",
    ];
    let strangers: Vec<_> = top.iter().filter(|name| !known.contains(&name.as_str())).collect();
    assert!(strangers.is_empty(), "{strangers:?}");
}

/// The program's sources without their tests, benches and examples, with their paths.
fn program() -> Vec<(String, String)> {
    let is_apart = |name: &str| {
        ["/tests/", "/benches/", "/examples/"].iter().any(|folder| name.contains(folder))
    };
    sources("src").into_iter().filter(|(name, _)| !is_apart(name)).collect()
}

#[test]
fn nothing_reaches_up() {
    let faults = floors::faults_of_floors(&uses::uses(&program()));
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn no_circle_runs_between_folders() {
    let circles = floors::circles_of_folders(&uses::uses(&program()));
    assert!(circles.is_empty(), "{}", circles.join("\n"));
}

#[test]
fn the_map_names_what_is_there() {
    let map = include_str!("../src/lib.rs");
    let named =
        map.split('`').skip(1).step_by(2).filter(|name| name.contains('/') && !name.contains(' '));
    let missing: Vec<&str> = named
        .filter(|name| !root().join("src").join(name).exists() && !root().join(name).exists())
        .collect();
    assert!(map.contains("`core/") && missing.is_empty(), "{missing:?}");
}
