//! three.js: which camera is meant, what moves it, what controls do to it, and React.

use std::fs;
use std::process::Command;

use pinhole_core::{Camera, DVec3, Orientation};

use super::programs::{node_modules, output, script, there};
use super::read;

const MADE: &str = "const camera = new THREE.PerspectiveCamera(45, 2, 0.1, 100);\n\
                    camera.position.set(3, 2, 6);\n";
const ORBIT: &str = "const controls = new OrbitControls(camera, renderer.domElement);\n";

#[track_caller]
fn three(text: &str) -> (Camera, Vec<String>) {
    let taken = read("three", text).unwrap_or_else(|error| panic!("{error}: {text}"));
    (taken.camera, taken.notes)
}

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    let error = read("three", text).unwrap_err().to_string();
    assert!(error.contains(message), "{error}: {text}");
}

fn at(camera: &Camera) -> Option<DVec3> {
    match camera.orientation {
        Orientation::At { at, .. } => Some(at),
        _ => None,
    }
}

#[test]
fn the_controls_own_target_counts() {
    for (more, target) in [
        ("controls.target = new THREE.Vector3(0, 1.5, 0);\n", [0.0, 1.5, 0.0]),
        ("controls.target.y = 1.5;\n", [0.0, 1.5, 0.0]),
        ("controls.target.copy(new THREE.Vector3(1, 1.5, 0));\n", [1.0, 1.5, 0.0]),
        (
            "controls.target.set(0, 1, 0);\nlight.target.set(5, 5, 5);\nlight.target.position.set(7, 7, 7);\n",
            [0.0, 1.0, 0.0],
        ),
        ("controls.target.set(0, 1, 0);\ncontrols.target.y += 2;\n", [0.0, 3.0, 0.0]),
    ] {
        let (camera, _) = three(&format!("{MADE}{ORBIT}{more}"));
        assert_eq!(at(&camera), Some(target.into()), "{more}");
    }
    for kind in ["MapControls", "TrackballControls", "ArcballControls"] {
        let orbit = ORBIT.replace("OrbitControls", kind);
        let (camera, notes) = three(&format!("{MADE}{orbit}controls.target.set(0, 0, -3);\n"));
        assert_eq!(at(&camera), Some(DVec3::new(0.0, 0.0, -3.0)));
        assert_eq!(notes[0], format!("{kind} turn the camera to their target, (0, 0, -3)"));
    }
    for kind in ["PointerLockControls", "FlyControls"] {
        let (camera, _) = three(&format!("{MADE}{}", ORBIT.replace("OrbitControls", kind)));
        assert_eq!(camera.view(), DVec3::NEG_Z, "{kind}");
    }
    let other = ORBIT.replace("camera,", "mirrorCamera,");
    assert_eq!(three(&format!("{MADE}{other}")).0.view(), DVec3::NEG_Z);
}

#[test]
fn a_look_at_after_controls_that_are_not_updated_is_refused() {
    let looked = format!("{MADE}{ORBIT}camera.lookAt(1, 1, 1);\n");
    assert_refused(&looked, "in:4:15: lookAt is 1, 1, 1: OrbitControls turn the camera before it");
    for update in ["controls.update();\n", "function animate() { controls.update(); }\n"] {
        assert_eq!(at(&three(&format!("{looked}{update}")).0), Some(DVec3::ZERO), "{update}");
    }
}

#[test]
fn what_moves_the_camera_is_read_or_refused() {
    for (more, eye) in [
        ("camera.position.y += 5;\n", [3.0, 7.0, 6.0]),
        ("camera.position.x -= 1;\ncamera.position.z *= 2;\n", [2.0, 2.0, 12.0]),
        (
            "camera.position.setY(9);\ncamera.position.add(new THREE.Vector3(1, 0, 0));\n",
            [4.0, 9.0, 6.0],
        ),
        ("camera.position\n  .set(1, 2, 3)\n  .multiplyScalar(2);\n", [2.0, 4.0, 6.0]),
        ("const far = camera.position.distanceTo(cube.position);\n", [3.0, 2.0, 6.0]),
        (
            "const group = new THREE.Group();\ngroup.add(camera);\nscene.add(group);\n",
            [3.0, 2.0, 6.0],
        ),
        ("scene.add(camera);\ncamera.add(lamp);\n", [3.0, 2.0, 6.0]),
        ("this.camera = camera;\nthis.camera.position.set(1, 1, 1);\n", [1.0, 1.0, 1.0]),
    ] {
        assert_eq!(three(&format!("{MADE}{more}")).0.eye, DVec3::from(eye), "{more}");
    }
    for (more, message) in [
        (
            "const rig = new THREE.Group();\nrig.position.set(0, 10, 0);\nrig.add(camera);\n",
            "in:5:9: rig.add is camera: rig holds the camera and moves it",
        ),
        ("player.add(camera);\n", "player holds the camera"),
        ("camera.position.y++;\n", "position.y is ++"),
        (
            "camera.position.applyAxisAngle(v, 1);\n",
            "position.applyAxisAngle is v, 1: this is not read",
        ),
        ("camera.translateZ(3);\n", "translateZ is 3"),
        ("camera.rotation.order = 'YXZ';\n", "rotation.order is 'YXZ': the camera must be turned"),
        (
            "camera.setFocalLength(35);\n",
            "is 35: this is not read: the field of view must be given by fov",
        ),
        ("camera.scale.set(1, 1, 2);\n", "a camera that is scaled is not read"),
        ("camera.setViewOffset(8, 8, 0, 0, 4, 4);\n", "a view that is off the middle is not read"),
    ] {
        assert_refused(&format!("{MADE}{more}"), message);
    }
}

#[test]
fn what_the_camera_is_handed_to_must_leave_it_alone() {
    for (more, message) in [
        (
            "function place(cam) { cam.position.set(3, 4, 5); }\nplace(camera);\n",
            "in:4:7: what place is handed is camera: what it does to the camera is not read",
        ),
        (
            "const pos = camera.position;\npos.y = 9;\n",
            "in:4:9: pos.y is 9: it is a part of the camera",
        ),
        ("const { position } = camera;\nposition.y = 9;\n", "position: it is a part of the camera"),
        (
            "Object.assign(camera.position, { x: 1 });\n",
            "in:3:15: what Object.assign is handed is camera.position:",
        ),
        (
            "gsap.to(camera.position, { x: 4 });\n",
            "in:3:9: what gsap.to is handed is camera.position:",
        ),
        ("frame({ camera, mesh });\n", "what frame is handed is camera:"),
    ] {
        assert_refused(&format!("{MADE}{more}"), message);
    }
    for more in [
        "renderer.render(scene, camera);\ncomposer.addPass(new RenderPass(scene, camera));\n",
        "scene.add(camera, new THREE.CameraHelper(camera));\nconsole.log(camera.position);\n",
        "raycaster.setFromCamera(pointer, camera);\ngui.add(camera.position, 'x', 0, 9);\n",
        "const p = v.project(camera);\nsprite.lookAt(camera.position);\nv.copy(camera.position);\n",
        "function show(world, cam) { renderer.render(world, cam); cam.updateMatrixWorld(); }\nshow(s, camera);\n",
        "function go() { gsap.to(camera.position, { x: 4 }); }\naddEventListener('click', go);\n",
        "const pos = camera.position;\nconsole.log(pos.x);\n",
        "const start = camera.position.clone();\nstart.y = 9;\n",
        "f(camera.position.x);\nif (camera) { g(); }\nconst all = { camera, scene };\n",
    ] {
        assert_eq!(three(&format!("{MADE}{more}")).0.eye, DVec3::new(3.0, 2.0, 6.0), "{more}");
    }
}

#[test]
fn what_is_done_later_is_left_out_and_told() {
    let told =
        "what moves the camera later, as in animate() or where an event is answered, is left out";
    for more in [
        "function animate(time) {\n  camera.position.x = Math.sin(time) * 5;\n}\n",
        "const tick = () => {\n  camera.position.x = 5;\n};\n",
        "renderer.setAnimationLoop((t) => { camera.lookAt(t, 0, 0); });\n",
        "function go() { camera.rotation.y = 1; }\nrequestAnimationFrame(go);\n",
        "class A {\n  update(dt: number): void {\n    camera.zoom = dt;\n  }\n}\n",
        "window.addEventListener('wheel', e => { camera.fov += e.deltaY; });\n",
    ] {
        let (camera, notes) = three(&format!("{MADE}{more}"));
        assert_eq!(
            (camera.eye, camera.view()),
            (DVec3::new(3.0, 2.0, 6.0), DVec3::NEG_Z),
            "{more}"
        );
        assert_eq!(notes[0], told, "{more}");
    }
    let turned = "function animate() {\n  camera.lookAt(scene.position);\n}\n";
    let alone = "lookAt is among it, and stands nowhere else";
    assert_eq!(three(&format!("{MADE}{turned}")).1[1], alone);
    let both = format!("{MADE}camera.lookAt(0, 0, 0);\n{turned}");
    assert!(!three(&both).1.contains(&alone.to_owned()));
    let harmless = "function animate() { renderer.render(scene, camera); }\n";
    assert!(!three(&format!("{MADE}{harmless}")).1.contains(&told.to_owned()));
}

#[test]
fn of_several_cameras_one_must_be_plain() {
    let mirror =
        "const mirror = new THREE.PerspectiveCamera(90, 1);\nmirror.position.set(0, 10, 0);\n";
    let (camera, notes) = three(&format!("{MADE}{mirror}"));
    assert_eq!((camera.eye.x, notes[0].as_str()), (3.0, "2 cameras are made: camera is taken"));
    let (camera, notes) = three(&format!("{MADE}{mirror}renderer.render(scene, mirror);\n"));
    assert_eq!((camera.eye.y, notes[0].as_str()), (10.0, "2 cameras are made: mirror is taken"));
    let unnamed = format!("{MADE}{mirror}").replace("camera", "left");
    assert_refused(&unnamed, "one of 2 cameras: leave in one");
}

#[test]
fn a_camera_that_stands_at_its_target_looks_as_in_three_js() {
    let text = "const camera = new THREE.PerspectiveCamera(45, 2);\ncamera.lookAt(0, 0, 0);\ncamera.position.set(0, 1, 5);\n";
    let (camera, notes) = three(text);
    assert_eq!((camera.eye, camera.view()), (DVec3::new(0.0, 1.0, 5.0), DVec3::NEG_Z));
    assert!(notes[0].starts_with("lookAt: the camera stands at (0, 0, 0) itself"), "{notes:?}");
}

#[test]
fn react_s_cameras_are_read() {
    let (camera, notes) =
        three("<Canvas shadows camera={{ position: [0, 2, 5], fov: 60 }}>\n  <mesh />\n</Canvas>");
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(0.0, 2.0, 5.0), Some(DVec3::ZERO)));
    assert!((camera.viewport.vertical_fov().to_degrees() - 60.0).abs() < 1e-12);
    assert_eq!(notes[0], "react-three-fiber turns the camera to (0, 0, 0)");
    let (camera, notes) = three("<PerspectiveCamera makeDefault position={[0, 2, 5]} />");
    assert_eq!((camera.eye, camera.view()), (DVec3::new(0.0, 2.0, 5.0), DVec3::NEG_Z));
    assert_eq!(notes[0], "fov is not in the text: 50 taken");
    let (camera, _) = three(
        "<PerspectiveCamera makeDefault position={[0, 2, 5]} fov={50} />\n<OrbitControls target={[0, 1, 0]} />",
    );
    assert_eq!(at(&camera), Some(DVec3::Y));
    for (text, message) in [
        ("<Canvas camera={{ rotation: [0, 1, 0] }}>", "rotation is [0, 1, 0]: this is not read"),
        ("<PerspectiveCamera position-z={5} />", "it must be position={[x, y, z]}"),
        ("<Canvas camera={settings}>", "camera is missing"),
    ] {
        assert_refused(text, message);
    }
}

/// three.js runs the same code.
#[test]
fn three_js_moves_the_camera_there_too() {
    let modules = node_modules();
    let probe = format!("require('{}/three/package.json')", modules.display());
    if !there("three", Command::new("node").args(["-e", &probe])) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for more in [
        "camera.position.y += 5;\ncamera.lookAt(0, 0, 0);\n",
        "camera.position.set(0, 7, 0);\ncamera.lookAt(0, 0, 0);\n",
        "camera.up.set(0, 0, 1);\ncamera.position.set(0, 0, 7);\ncamera.lookAt(0, 0, 0);\n",
        "camera.position.set(0, 0, 0);\ncamera.lookAt(0, 0, 0);\ncamera.position.set(1, 2, 3);\n",
        "camera.rotation.x = -0.3;\n",
        "camera.rotation.set(-0.5, 0.7, 0.2);\ncamera.rotation.y += 0.1;\ncamera.position.x = 1;\n",
        "camera.rotation.y = Math.PI / 4;\ncamera.rotation.z = THREE.MathUtils.degToRad(20);\n",
        "camera.rotation.x = 1;\ncamera.lookAt(0, 1, 0);\n",
        "camera.lookAt(new THREE.Vector3());\n",
        "camera.position.set(1, 1, 1).multiplyScalar(3);\ncamera.lookAt(0, 1, 0);\n",
        "const controls = new OrbitControls(camera);\ncontrols.target.y = 1.5;\ncontrols.update();\n",
        "const controls = new MapControls(camera);\ncontrols.target.set(0, 0, -3);\ncontrols.update();\n",
        "camera.position.set(0, 7, 0);\nconst controls = new OrbitControls(camera);\n",
    ] {
        let text = format!("{MADE}{more}");
        let file = folder.path().join("camera.js");
        fs::write(&file, &text).unwrap();
        let mut run = Command::new("node");
        let said =
            output(run.arg(script("three_camera.mjs")).arg(&modules).arg(file).arg("camera"));
        let theirs: Vec<f64> = said.split_whitespace().map(|word| word.parse().unwrap()).collect();
        let (camera, _) = three(&text);
        let basis = *camera.resolve().unwrap().basis();
        let ours = [basis.u, basis.v, basis.w, camera.eye].map(|v| v.to_array()).concat();
        for (ours, theirs) in ours.iter().zip(&theirs) {
            assert!((ours - theirs).abs() < 1e-9, "{more}: {ours} for {theirs}: {said}");
        }
    }
}
