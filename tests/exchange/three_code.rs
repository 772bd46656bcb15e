//! three.js as people write it in a program.

use std::fs;
use std::process::Command;

use pinhole::exchange::recognised;
use pinhole_core::{Camera, DVec3};

use super::programs::{node_modules, output, script, there};
use super::read;

/// As tutorials have it, with what they forget.
const TUTORIAL: &str = "\
import * as THREE from 'three';
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera( 75, window.innerWidth / window.innerHeight, 0.1, 1000 );
const renderer = new THREE.WebGLRenderer();
renderer.setSize( window.innerWidth, window.innerHeight );
const cube = new THREE.Mesh( new THREE.BoxGeometry( 1, 1, 1 ), material );
light.shadow.camera.position.set(9, 9, 9);
camera.position.z = 5; // back
";

const LOOKING: &str = "\
const camera = new THREE.PerspectiveCamera(35, 16 / 9, 1, 100);
renderer.setSize(320, 180);
camera.position.set(3, 2, -4);
camera.up.set(0, 0, 1);
camera.lookAt(new THREE.Vector3(0.5, 1, 0));
";

/// The order of the statements matters: turned first, moved after.
const MOVED_AFTER: &str = "\
this.view = new THREE.PerspectiveCamera(60, 1.5);
this.view.position.set(0, 0, 4);
this.view.lookAt(1, 0, 0);
this.view.position.y = 2;
this.view.zoom = 2;
this.view.fov = 40;
this.view.updateProjectionMatrix();
";

const TYPED: &str = "\
let camera: THREE.PerspectiveCamera = new THREE.PerspectiveCamera(50);
camera.position.copy(new THREE.Vector3(1, 2, 3));
camera.lookAt(scene.position);
";

#[track_caller]
fn read_code(text: &str) -> (Camera, Vec<String>) {
    assert_eq!(recognised(text).unwrap().name, "three");
    let taken = read("three", text).unwrap();
    (taken.camera, taken.notes)
}

#[test]
fn a_tutorials_camera_is_read() {
    let (camera, notes) = read_code(TUTORIAL);
    assert_eq!(camera.eye, DVec3::new(0.0, 0.0, 5.0));
    let viewport = camera.viewport;
    assert!((viewport.vertical_fov().to_degrees() - 75.0).abs() < 1e-12);
    assert_eq!(viewport.width, viewport.height);
    assert_eq!(
        notes,
        [
            "aspect is window.innerWidth / window.innerHeight, which is no number: 400 / 400 taken",
            "this code does not say how many pixels there are: 400 × 400 taken",
            "meshes are left out: they are read of a scene written by toJSON()",
        ]
    );
}

#[test]
fn statements_count_in_their_order() {
    let (camera, notes) = read_code(LOOKING);
    assert_eq!((camera.image.width(), camera.image.height()), (320, 180));
    assert_eq!(notes, [""; 0]);
    let (_, notes) = read_code(MOVED_AFTER);
    assert_eq!(
        notes[1..],
        ["position is set after lookAt, which had turned the camera from where it was"]
    );
    let orbit =
        format!("{TYPED}const c = new OrbitControls(camera, canvas);\nc.target.set(1, 0, 0);");
    let (camera, notes) = read_code(&orbit);
    let ahead = -camera.resolve().unwrap().basis().w;
    assert!((ahead - DVec3::new(0.0, -2.0, -3.0).normalize()).length() < 1e-15);
    assert_eq!(notes[0], "OrbitControls turn the camera to their target, (1, 0, 0)");
}

#[test]
fn what_is_wrong_or_not_understood_is_told_at_its_place() {
    let camera = |more: &str| format!("{LOOKING}{more}");
    for (text, message) in [
        (
            camera("camera.rotation.y = 1;"),
            "in:6:21: rotation.y is 1: the camera must be turned by lookAt, or be given as toJSON() writes it",
        ),
        (
            camera("camera.position.x = far;"),
            "in:6:21: position.x is far: it must be a finite number",
        ),
        (
            camera("camera.lookAt(cube.position);"),
            "in:6:15: lookAt is cube.position: it must be a finite number",
        ),
        (LOOKING.replace("35", "0"), "in:1:44: fov is 0: it must be between 0 and 180 degrees"),
        (LOOKING.replace("16 / 9", "-1"), "in:1:48: aspect is -1: it must be greater than 0"),
        (
            LOOKING.replace("320", "0"),
            "in:2:18: setSize is 0, 180: it must be whole numbers from 1 to 16384",
        ),
        (camera("camera.zoom = 0;"), "in:6:15: zoom is 0: it must be greater than 0"),
    ] {
        assert_eq!(read("three", &text).unwrap_err().to_string(), message, "{text}");
    }
}

/// three.js runs the same code.
#[test]
fn three_js_makes_the_same_camera_of_it() {
    let modules = node_modules();
    let probe = format!("require('{}/three/package.json')", modules.display());
    if !there("three", Command::new("node").args(["-e", &probe])) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("LOOKING", LOOKING), ("MOVED_AFTER", MOVED_AFTER), ("TYPED", TYPED)] {
        let file = folder.path().join("camera.js");
        fs::write(&file, text.replace(": THREE.PerspectiveCamera", "")).unwrap();
        let variable = if name == "MOVED_AFTER" { "this.view" } else { "camera" };
        let mut run = Command::new("node");
        let said =
            output(run.arg(script("three_camera.mjs")).arg(&modules).arg(file).arg(variable));
        let theirs: Vec<f64> = said.split_whitespace().map(|word| word.parse().unwrap()).collect();
        let (camera, _) = read_code(text);
        let (basis, viewport) = (*camera.resolve().unwrap().basis(), camera.viewport);
        let half = viewport.height / 2.0 / viewport.distance;
        let ours = [basis.u, basis.v, basis.w, camera.eye].map(|v| v.to_array()).concat();
        let ours = [&ours[..], &[half, viewport.width / viewport.height]].concat();
        assert_eq!(ours.len(), theirs.len());
        for (ours, theirs) in ours.iter().zip(&theirs) {
            assert!((ours - theirs).abs() < 1e-12, "{name}: {ours} for {theirs}: {said}");
        }
        println!("three.js: {name}: the same camera");
    }
}
