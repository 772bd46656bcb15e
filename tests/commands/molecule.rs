//! Molecules as scenes of the commands.

use std::fs;

use serde_json::Value;

use super::run_in;

const WATER: &str = "3\nWater\nO 0 0 0.1192\nH 0 0.7632 -0.477\nH 0 -0.7632 -0.477\n";

#[test]
fn one_is_inspected_and_rendered_like_any_scene() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("water.xyz"), WATER).unwrap();
    let arguments = ["inspect", "water.xyz", "--uv", "0,0", "--json"];
    let inspect: Value = serde_json::from_str(&run_in(folder.path(), &arguments).done()).unwrap();
    // Seen along x: the ray through the middle, (0, 0, 0.2), meets the oxygen.
    let first = inspect["first"].as_u64().unwrap() as usize;
    let hit = &inspect["hits"][first];
    assert_eq!((hit["name"].as_str(), hit["index"].as_u64()), (Some("O1"), Some(0)));
    run_in(folder.path(), &["render", "water.xyz", "-o", "water.png"]).done();
    let picture = image_size(&fs::read(folder.path().join("water.png")).unwrap());
    assert_eq!(picture, (800, 600));
}

/// Width and height stand at fixed places of every PNG.
fn image_size(png: &[u8]) -> (u32, u32) {
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn which_of_several_frames_it_is_about_is_said() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("two.xyz"), [WATER, WATER].concat()).unwrap();
    let run = run_in(folder.path(), &["inspect", "two.xyz", "--uv", "0,0"]);
    assert_eq!(run.status, 0);
    assert_eq!(run.stderr, "pinhole: two.xyz: The file has 2 frames: this is the first.\n");
}

#[test]
fn a_mistake_is_told_at_its_place() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("bad.pdb"), "ATOM      1  N   ALA A   1      11.104   six\n")
        .unwrap();
    run_in(folder.path(), &["inspect", "bad.pdb", "--uv", "0,0"])
        .failed(1, "bad.pdb:1:39: y in columns 39-46 is \"six\": it must be a number of ångström");
    run_in(folder.path(), &["render", "water.xyz", "-o", "a.png"])
        .failed(1, "water.xyz: cannot be read: no such file or directory");
}
