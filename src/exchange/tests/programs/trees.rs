//! The camera that is taken of a glTF's or three.js's tree, and trees that no file may have.

use pinhole_core::DVec3;

use super::read;

const CAMERAS: &str = r#""cameras": [
    {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "zfar": 100, "znear": 0.01}},
    {"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1, "znear": 0.01}}]"#;

fn gltf(more: &str, nodes: &str) -> String {
    format!("{{\"asset\": {{\"version\": \"2.0\"}}, {more}\n{CAMERAS},\n\"nodes\": [{nodes}]}}")
}

#[track_caller]
fn assert_taken(text: &str, eye: [f64; 3], said: &[&str]) {
    let taken = read("gltf", text).unwrap();
    assert_eq!(taken.camera.eye, DVec3::from_array(eye), "{text}");
    let unsaid = |note: &&String| !note.starts_with("glTF does not say how many pixels");
    assert_eq!(taken.notes.iter().filter(unsaid).collect::<Vec<_>>(), said, "{text}");
}

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    assert_eq!(read("gltf", text).unwrap_err().to_string(), message);
}

#[test]
fn the_first_perspective_camera_of_the_scene_that_is_shown_is_taken() {
    let two = r#"{"translation": [1, 0, 0], "camera": 1}, {"name": "far", "translation": [5, 0, 3], "camera": 1}"#;
    let scenes = r#""scenes": [{"nodes": [0]}, {"nodes": [1]}],"#;
    assert_taken(
        &gltf(&format!("\"scene\": 1, {scenes}"), two),
        [5.0, 0.0, 3.0],
        &["node \"far\" is taken; 1 more camera is left out"],
    );
    assert_taken(
        &gltf(scenes, two),
        [1.0, 0.0, 0.0],
        &["nodes[0] is taken; 1 more camera is left out"],
    );
    let ortho = r#"{"rotation": [-0.383, 0, 0, 0.924], "camera": 0}, {"translation": [0.5, 0.5, 3.0], "camera": 1}"#;
    assert_taken(
        &gltf("", ortho),
        [0.5, 0.5, 3.0],
        &["nodes[1] is taken; 1 more camera is left out"],
    );
    // Deeper in the scene, and in none.
    let deep = r#"{"camera": 1}, {"children": [2]}, {"children": [3], "translation": [0, 1, 0]},
                  {"translation": [0, 0, 7], "camera": 1}"#;
    assert_taken(
        &gltf(r#""scenes": [{"nodes": [1]}],"#, deep),
        [0.0, 1.0, 7.0],
        &["nodes[3] is taken; 1 more camera is left out"],
    );
    assert_taken(
        &gltf(r#""scenes": [{"nodes": [1]}],"#, r#"{"translation": [0, 0, 2], "camera": 1}, {}"#),
        [0.0, 0.0, 2.0],
        &["nodes[0] is not in the scene that is shown: no camera is"],
    );
    assert_refused(
        &gltf("", r#"{"camera": 0}"#),
        "in: cameras[0].perspective is missing: the camera must be a perspective one",
    );
    assert_refused(
        &gltf(r#""scene": 2, "scenes": [{"nodes": [0]}],"#, r#"{"camera": 1}"#),
        "in:1:31: scene is 2: it must be the number of one of the scenes",
    );
}

#[test]
fn a_ring_of_nodes_and_two_parents_are_refused() {
    for (nodes, message) in [
        (
            r#"{"children": [1]}, {"children": [0], "camera": 1}"#,
            "nodes[0] is {\"children\":[1]}: it is below itself: it must be no child of it",
        ),
        (
            r#"{"children": [0], "camera": 1}"#,
            "nodes[0] is {\"camera\":1,\"children\":[0]}: it is below itself: it must be no child of it",
        ),
        (
            r#"{"children": [2]}, {"children": [2]}, {"camera": 1}"#,
            "nodes[2] is {\"camera\":1}: it must be a child of one node only",
        ),
    ] {
        assert_eq!(read("gltf", &gltf("", nodes)).unwrap_err().problem, message);
    }
}

/// Each took the stack, or time that grows with the square of the nodes.
#[test]
fn long_chains_and_rings_end() {
    let many = 100_000;
    let step = |k: usize| format!("{{\"children\": [{}], \"translation\": [0, 0, 1]}}", k + 1);
    let chain: Vec<String> = (0..many).map(step).collect();
    let chain = chain.join(", ");
    let scene = "\"scenes\": [{\"nodes\": [0]}],";
    assert_taken(&gltf(scene, &format!("{chain}, {{\"camera\": 1}}")), [0.0, 0.0, 1e5], &[]);
    let ring = gltf(scene, &format!("{chain}, {{\"camera\": 1, \"children\": [0]}}"));
    assert!(read("gltf", &ring).unwrap_err().problem.contains("it is below itself"));

    let mesh =
        "{\"type\": \"Mesh\", \"geometry\": \"g99999\", \"material\": \"none\"}, ".repeat(many);
    let geometries: Vec<String> = (0..many)
        .map(|k| format!("{{\"uuid\": \"g{k}\", \"type\": \"SphereGeometry\", \"radius\": -1}}"))
        .collect();
    let text = format!(
        "{{\"geometries\": [{}], \"object\": {{\"children\": [{mesh}{{\"type\": \"PerspectiveCamera\"}}]}}}}",
        geometries.join(", ")
    );
    let taken = read("three", &text).unwrap();
    assert_eq!(taken.spheres.len(), 0);
    assert!(taken.notes.iter().any(|note| note.starts_with("100 of SphereGeometry left out")));
    let deep = format!("{{\"object\": {}{}}}", "{\"children\": [".repeat(many), "]}".repeat(many));
    let error = read("three", &deep).unwrap_err();
    assert_eq!(error.to_string(), "in:1:894: no JSON: brackets are nested more than 127 deep here");
}

#[test]
fn places_in_json_are_characters_counted_from_one() {
    for (text, message) in [
        ("", "in:1:1: no JSON: the text ends inside a value: is all of the file there?"),
        ("{\"é\": 1, x}", "in:1:10: no JSON: key must be a string"),
        ("{\n  \"a\": 1,\n  é\n}", "in:3:3: no JSON: key must be a string"),
    ] {
        assert_refused(text, message);
    }
}
