//! The invariants of the layout, absences included.

use std::collections::{BTreeMap, BTreeSet};
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
                "src/figure/overlay/",
                "src/figure/formula/",
                "src/figure/derivation/",
                "src/exchange/programs/",
            ]
            .iter()
            .any(|f| name.starts_with(f))
            || [
                "src/exchange/document.rs",
                "src/view/derive/mod.rs",
                "src/figure/inspection.rs",
                "src/features/lines/state.rs",
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
        if ["src/figure/formula/", "src/figure/derivation/", "src/exchange/"]
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

/// The crates, each with the folder of its sources. Cargo keeps them apart.
const CRATES: [&str; 6] =
    ["src/core/", "src/exchange/", "src/figure/", "src/lecture/", "src/reference/", "src/"];

/// The floors of the program's own crate, from the ground up.
const FLOORS: [&[&str]; 5] = [&["model"], &["view"], &["report"], &["ui", "cli"], &["platform"]];

/// Adds the paths in `rest`, which follows `before`, with those in braces written out. Returns what is left.
fn expand<'a>(before: &str, rest: &'a str, found: &mut BTreeSet<String>) -> &'a str {
    let rest = rest.trim_start();
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    let (path, rest) = (format!("{before}{}", &rest[..end]), &rest[end..]);
    match rest.strip_prefix("::") {
        Some(rest) => expand(&format!("{path}::"), rest, found),
        None if end == 0 && rest.starts_with('{') => {
            let mut rest = rest;
            while let Some(item) = rest.strip_prefix(['{', ',']) {
                rest = expand(before, item, found).trim_start();
            }
            rest.strip_prefix('}').unwrap_or(rest)
        }
        None => {
            found.insert(path);
            rest
        }
    }
}

/// Returns the paths of a file that begin at its crate.
fn paths(text: &str) -> BTreeSet<String> {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code = lines.collect::<Vec<_>>().join(" ");
    let mut found = BTreeSet::new();
    for part in code.split("crate::").skip(1) {
        expand("", part, &mut found);
    }
    found
}

/// Returns for each room, a module of a crate, of a floor or of a feature, those that it uses: `src/view/derive` uses
/// `src/model/session`. Names that a floor or crate passes on count as those of the room that they come from.
fn rooms() -> BTreeMap<String, BTreeSet<String>> {
    let is_apart = |name: &str| {
        ["/tests/", "/benches/", "/examples/"].iter().any(|folder| name.contains(folder))
    };
    let files: Vec<_> = sources("src").into_iter().filter(|(name, _)| !is_apart(name)).collect();
    let room_of = |file: &str| {
        let root = CRATES.into_iter().find(|root| file.starts_with(root)).unwrap();
        let parts: Vec<&str> = file[root.len()..].trim_end_matches(".rs").split('/').collect();
        let depth = match parts[0] {
            "features" => 3,
            _ if root == "src/" => 2,
            _ => 1,
        };
        let room = &parts[..parts.len().min(depth)];
        (root, format!("{root}{}", room.join("/")))
    };
    let known: BTreeSet<String> = files.iter().map(|(name, _)| room_of(name).1).collect();
    let mut passed_on = BTreeMap::new();
    for (name, text) in &files {
        let Some(home) = ["mod.rs", "lib.rs"].iter().find_map(|page| name.strip_suffix(page))
        else {
            continue;
        };
        for part in text.split("pub use ").chain(text.split("pub(crate) use ")).skip(1) {
            let mut found = BTreeSet::new();
            expand("", part, &mut found);
            for path in found {
                let (room, item) = (path.split("::").next().unwrap(), path.rsplit("::").next());
                passed_on.insert(format!("{home}{}", item.unwrap()), format!("{home}{room}"));
            }
        }
    }
    let mut uses = BTreeMap::<String, BTreeSet<String>>::new();
    for (name, text) in &files {
        let (root, from) = room_of(name);
        // What stands for a floor names its parts.
        if from.ends_with("/mod") {
            continue;
        }
        for path in paths(text) {
            let place = format!("{root}{}", path.replace("::", "/"));
            let prefixes = place.match_indices('/').map(|(end, _)| &place[..end]);
            let passed = prefixes.chain([&*place]).find_map(|prefix| passed_on.get(prefix));
            let to = room_of(passed.unwrap_or(&place)).1;
            // A feature that is used by its name is followed to its files.
            let name = to.strip_prefix("src/features/").filter(|name| !name.contains('/'));
            let mut files = Vec::new();
            if let Some(own) = name.map(|name| format!("{name}::")) {
                for part in text.split(&own).skip(1) {
                    let end = part.find(|c: char| !c.is_alphanumeric() && c != '_');
                    files.push(format!("{to}/{}", &part[..end.unwrap_or(part.len())]));
                }
            }
            for to in files.into_iter().chain([to]) {
                if known.contains(&to) && to != from {
                    uses.entry(from.clone()).or_default().insert(to);
                }
            }
        }
    }
    uses
}

#[test]
fn nothing_reaches_up() {
    let floor_of = |room: &str| {
        let mut parts = room.strip_prefix("src/")?.split('/');
        let floor = match (parts.next()?, parts.nth(1)) {
            ("features", Some(file)) if file.starts_with("ui") => "ui",
            ("features", _) => "view",
            (floor, _) => floor,
        };
        FLOORS.iter().position(|floors| floors.contains(&floor))
    };
    let rooms = rooms();
    assert!(rooms["src/view/derive"].contains("src/model/session"), "{rooms:#?}");
    for (from, uses) in &rooms {
        for to in uses {
            let floors = (floor_of(from), floor_of(to));
            // What a feature remembers and computes is part of the session, on the lowest floor.
            let is_state = to.starts_with("src/features/") && floors.1 == Some(1);
            let reaches_up = matches!(floors, (Some(from), Some(to)) if from < to);
            assert!(!reaches_up || is_state, "{from} uses {to}");
        }
    }
}

/// The features that use another one.
const FEATURES_OF_OTHERS: [(&str, &str); 6] = [
    ("class", "exercises"),
    ("exercises", "lines"),
    ("export", "lines"),
    ("export", "play"),
    ("mistakes", "vote"),
    ("vote", "mistakes"),
];

#[test]
fn features_do_not_use_one_another() {
    let feature =
        |room: &str| Some(room.strip_prefix("src/features/")?.split('/').next()?.to_owned());
    let mut found = BTreeSet::new();
    for (from, uses) in rooms() {
        let pairs = uses.iter().filter_map(|to| Some((feature(&from)?, feature(to)?)));
        found.extend(pairs.filter(|(from, to)| from != to));
    }
    let known = FEATURES_OF_OTHERS.map(|(from, to)| (from.to_owned(), to.to_owned()));
    assert_eq!(found, BTreeSet::from(known));
}

#[test]
fn no_circle_runs_between_rooms() {
    let mut rooms = rooms();
    // A room that uses none of those that are left is in no circle.
    while let Some(free) = {
        let is_free = |uses: &BTreeSet<String>| uses.iter().all(|to| !rooms.contains_key(to));
        rooms.iter().find(|(_, uses)| is_free(uses)).map(|(room, _)| room.clone())
    } {
        rooms.remove(&free);
    }
    assert!(rooms.is_empty(), "in a circle, or using one: {rooms:#?}");
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
