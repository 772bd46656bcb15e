//! Cameras of pasted text: taken where every number is literal, refused at the line at fault else.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation};
use pinhole_exchange::programs::importer_of;

use super::read;

const GLU: &str =
    "gluPerspective(45.0, 4.0 / 3.0, 0.1, 100.0);\ngluLookAt(0, 0, 5, 0, 1, 0, 0, 1, 0);\n";
const GLM: &str = "glm::mat4 proj = glm::perspective(glm::radians(45.0f), 4.0f / 3.0f, 0.1f, 100.0f);\n\
                   glm::mat4 view = glm::lookAt(glm::vec3(4, 3, 3), // the eye\n  \
                   glm::vec3(0.0f), glm::vec3(0, 1, 0));\n";
const THREE: &str = "import * as THREE from 'three';\n\
                     const camera = new THREE.PerspectiveCamera(50, 800 / 400, 0.1, 1000); // mine\n\
                     camera.position.set(1, 2, 3);\ncamera.lookAt(0, 0.5, 0);\n";
const K_R_T: &str = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\n\
                     R = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]\nt = [1, 2, 3]\n";

#[track_caller]
fn taken(name: &str, text: &str) -> Camera {
    assert_eq!(importer_of(text).map(|importer| importer.name), Some(name), "{text}");
    read(name, text).unwrap_or_else(|error| panic!("{error}: {text}")).camera
}

#[track_caller]
fn assert_refused(name: &str, text: &str, message: &str) {
    let error = read(name, text).unwrap_err().to_string();
    assert!(error.contains(message), "{error}: {text}");
}

fn at(camera: &Camera) -> DVec3 {
    match camera.orientation {
        Orientation::At { at, .. } => at,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_usual_statements_are_taken() {
    let camera = taken("opengl", GLU);
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(0.0, 0.0, 5.0), DVec3::Y));
    assert_eq!(camera.image, ImageSize::new(400, 300).unwrap());
    assert!((camera.viewport.vertical_fov().to_degrees() - 45.0).abs() < 1e-12);
    let camera = taken("opengl", GLM);
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(4.0, 3.0, 3.0), DVec3::ZERO));
    assert!((camera.viewport.vertical_fov().to_degrees() - 45.0).abs() < 1e-12);
    let camera = taken("opengl", &format!("/* two\nlines */ {}", GLM.replace("glm::", "")));
    assert_eq!(camera.eye, DVec3::new(4.0, 3.0, 3.0));
    let camera = taken("three", THREE);
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 0.5, 0.0)));
    assert!((camera.viewport.width / camera.viewport.height - 2.0).abs() < 1e-12);
    let axis = "let cam = new THREE.PerspectiveCamera( 75, 2 )\ncam.position.z = 5;cam.position.x=-.5\n\
                renderer.setSize(640, 320);";
    let camera = taken("three", axis);
    assert_eq!((camera.eye, camera.view()), (DVec3::new(-0.5, 0.0, 5.0), DVec3::NEG_Z));
    assert_eq!(camera.image, ImageSize::new(640, 320).unwrap());
    let vector = THREE.replace("lookAt(0, 0.5, 0)", "lookAt(new THREE.Vector3(0, 0.5, 0))");
    assert_eq!(at(&taken("three", &vector)).y, 0.5);
    let course = "cam = Cameras.PerspectiveCamera(Vec3(20,4,10), [-21, -4, -15], Vec3(0, 1, 0), # up\n 0.5, 300, 400)";
    let camera = taken("course", course);
    assert_eq!(camera.view(), DVec3::new(-21.0, -4.0, -15.0));
    assert_eq!((camera.viewport.height, camera.viewport.distance), (0.75, 0.5));
}

#[test]
fn k_r_and_t_are_taken_as_lists_arrays_and_as_numpy_prints_them() {
    let printed = "K:\n[[500.    0.  319.5]\n [  0.  510.  239.5]\n [  0.    0.    1. ]]\n\
                   R = [[ 1.  0.  0.]\n [ 0. -1. -0.]\n [ 0. -0. -1.]]\nt = [1. 2. 3.]\n";
    let arrays = K_R_T.replace("= [", "= np.array([").replace("]\n", "])\n");
    for text in [K_R_T, printed, &format!("import numpy as np\n{arrays}")] {
        let camera = taken("opencv", text);
        assert_eq!(camera.eye, DVec3::new(-1.0, 2.0, 3.0), "{text}");
        assert_eq!(camera.resolve().unwrap().basis().w, DVec3::Z);
        assert_eq!(camera.image, ImageSize::new(640, 480).unwrap());
    }
    let whole = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nwidth = 640\nheight = 480\n\
                 Rt = [[1, 0, 0, 1], [0, -1, 0, 2], [0, 0, -1, 3]]\n";
    assert_eq!(taken("opencv", whole).eye, DVec3::new(-1.0, 2.0, 3.0));
}

#[test]
fn numbers_alone_are_eye_at_up_or_a_matrix() {
    let look = taken("numbers", "(1, 2, 3)\n(0, 0, 0)\n(0, 1, 0)");
    assert_eq!((look.eye, at(&look)), (DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO));
    assert_eq!(look.viewport, Camera::CANONICAL.viewport);
    assert_eq!(taken("numbers", "1 2 3 0 0 0 0 1 0"), look);
    assert_eq!(taken("numbers", "[1, 2, 3, 0, 0, 0, 0, 1, 0]"), look);
    let ten = taken("numbers", "1, 2, 3,  0, 0, 0,\n 0, 1, 0,  60");
    assert!((ten.viewport.vertical_fov().to_degrees() - 60.0).abs() < 1e-12);
    let rows = taken("numbers", "0 0 1 7\n0 1 0 8\n-1 0 0 9");
    assert_eq!(
        (rows.eye, rows.resolve().unwrap().basis().w),
        (DVec3::new(7.0, 8.0, 9.0), DVec3::X)
    );
    for text in [
        "0 0 1 7\n0 1 0 8\n-1 0 0 9\n0 0 0 1",
        "[[0, 0, 1, 7], [0, 1, 0, 8], [-1, 0, 0, 9], [0, 0, 0, 1]]",
        "c2w = np.array([[0, 0, 1, 7], [0, 1, 0, 8], [-1, 0, 0, 9], [0, 0, 0, 1]])",
        "cam.matrix_world = Matrix(((0, 0, 1, 7), (0, 1, 0, 8), (-1, 0, 0, 9), (0, 0, 0, 1)))",
        // Column after column.
        "0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 7, 8, 9, 1",
    ] {
        assert_eq!(taken("numbers", text), rows, "{text}");
    }
    for text in ["[[1, 0, 0], [0, 1, 0], [0, 0, 1]]", "1 2 3 0 0 0 0 1 0 45 6"] {
        assert_refused("numbers", text, "it must be nine numbers (eye, at, up), ten");
    }
    assert_refused("numbers", "1 2 3 4 5 6 7 8 9, 10 - 3", "this is 10 - 3: it must be given by");
    assert_refused("numbers", "1 2 3 0 0 0 0 1 0 190", "it must be between 0 and 180 degrees");
    assert_refused("numbers", "view = [[1,0,0,0],[0,1,0,0],[0,0,1,0]]", "it must be nine numbers");
    assert_refused("numbers", "1 0 0 0\n0 1 0 0\n0 0 0 0", "it is no rotation: one of its axes");
    let program = "def looks(name):\ncamera.matrix_world = Matrix(((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)))";
    assert_refused("numbers", program, "def looks(name): it must be nine numbers");
    let notes = |text: &str| read("numbers", text).unwrap().notes.join("; ");
    assert!(notes("0 0 -1 0\n0 1 0 0\n1 0 0 0\n7 8 9 1").contains("its rows are right, up"));
    assert!(!notes("0 0 1 7\n0 1 0 8\n-1 0 0 9").contains("scale"));
    assert!(notes("0 0 2 7\n0 1 0 8\n-1 0 0 9").contains("its scale is left out"));
}

/// A name, a calculation, a step of a program: nothing of it is half taken.
#[test]
fn what_is_not_literal_is_refused_at_its_line() {
    let numbers = "it must be given by numbers, without names or calculations";
    for (name, text, message) in [
        ("opengl", GLU.replace("0, 0, 5", "x, 0, 5"), "in:2:11: gluLookAt is x: "),
        ("opengl", GLU.replace("0, 0, 5", "0,, 0, 5"), "gluLookAt"),
        ("three", THREE.replace("(1, 2, 3)", "(1,, 2, 3)"), "camera.position.set"),
        ("opengl", GLU.replace("4.0 / 3.0", "w / h"), "in:1:22: aspect is w / h: "),
        (
            "opengl",
            GLU.replace("4.0 / 3.0", "(float)800 / 600"),
            "in:1:22: aspect is (float)800 / 600: ",
        ),
        ("opengl", GLM.replace("glm::vec3(4, 3, 3)", "pos"), "in:2:30: glm::lookAt is pos: "),
        (
            "opengl",
            GLM.replace("vec3(4, 3, 3)", "vec3(4, 3, 3) + front"),
            "in:2:30: glm::lookAt is ",
        ),
        (
            "three",
            THREE.replace("800 / 400", "innerWidth / innerHeight"),
            "in:2:48: aspect is innerWidth / innerHeight: ",
        ),
        (
            "three",
            THREE.replace("(1, 2, 3)", "(1, 2, 3 * r)"),
            "in:3:27: camera.position.set is 3 * r: ",
        ),
        (
            "course",
            "PerspectiveCamera(eye, (0, 0, -1), (0, 1, 0), 1, 4, 4)".to_owned(),
            "in:1:19: eye is eye: ",
        ),
    ] {
        assert_refused(name, &text, message);
        assert_refused(name, &text, numbers);
    }
    for (name, text, message) in [
        (
            "opengl",
            format!("{GLU}glTranslatef(0, 0, -6);\n"),
            "in:3:1: glTranslatef(0, 0, -6): only gluLookAt, ",
        ),
        (
            "opengl",
            format!("{GLU}gluLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0);"),
            "in:3:1: gluLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0): it is given twice",
        ),
        (
            "opengl",
            format!("{GLM}view = glm::rotate(view, 1.0f, axis);"),
            "in:4:1: view = glm::rotate",
        ),
        (
            "opengl",
            GLM.replace("= glm::lookAt", "= roll * glm::lookAt"),
            "in:2:1: glm::mat4 view = roll * ",
        ),
        ("opengl", GLM.replace("0));\n", "0)) * model;\n"), "in:2:1: glm::mat4 view = "),
        (
            "opengl",
            GLM.replace("glm::radians(45.0f)", "45.0f"),
            "in:1:35: fovy is 45.0f: GLM counts in radians, and 45 radians are 2578 degrees",
        ),
        (
            "opengl",
            GLU.replace("4.0 / 3.0", "4 / 3"),
            "in:1:22: aspect is 4 / 3: C divides whole numbers",
        ),
        ("opengl", format!("#if 0\n{GLU}#endif\n"), "in:1:1: "),
        ("opengl", format!("if (far) {{\n{GLU}}}\n"), "in:1:1: if (far) {"),
        ("opengl", format!("{GLU}glLoadIdentity();"), "it must stand before the camera's call"),
        (
            "opengl",
            format!("glMatrixMode(GL_PROJECTION);\n{GLU}"),
            "in:3:1: gluLookAt(0, 0, 5, 0, 1, 0, 0, 1, 0): glMatrixMode",
        ),
        ("opengl", GLU.lines().next().unwrap().to_owned(), "in: gluLookAt is missing: "),
        (
            "three",
            format!("{THREE}camera.rotation.x = 0.5;\n"),
            "in:5:1: camera.rotation.x = 0.5: only new THREE.PerspectiveCamera, ",
        ),
        ("three", format!("{THREE}scene.add(camera);\n"), "in:5:1: scene.add(camera): only "),
        (
            "three",
            format!("{THREE}mesh.position.set(1, 2, 3);\n"),
            "in:5:1: mesh.position.set(1, 2, 3): mesh must be the camera",
        ),
        (
            "three",
            format!("{THREE}camera.position.z = 9;\n"),
            "in:5:1: camera.position.z = 9: it must stand before lookAt",
        ),
        ("three", format!("{THREE}camera.position.z += 9;\n"), "in:5:1: camera.position.z += 9"),
        ("three", format!("{THREE}for (;;) {{ camera.position.z = 9; }}\n"), "in:5:"),
        ("opencv", format!("{K_R_T}t[2] = 9\n"), "in:4:1: t[2] = 9: only K, R (or rvec) and t"),
        (
            "opencv",
            format!("{K_R_T}t = t / 1000\n"),
            "in:4:5: t is t / 1000: it must be three numbers",
        ),
        ("opencv", format!("{K_R_T}if far:\n    t = [0, 0, 9]\n"), "in:4:1: if far:"),
        ("opencv", K_R_T.replace("[1, 2, 3]", "np.zeros(3)"), "in:3:1: t = np.zeros(3): only "),
        (
            "opencv",
            K_R_T.replace("[1, 2, 3]", "[1, 2, 3000] / 1000"),
            "in:3:5: t is [1, 2, 3000] / 1000: it must be three",
        ),
        (
            "opencv",
            K_R_T.replace("2, 3]", "2 // 3]"),
            "in:3:11: // 3]: a number must not stand before //",
        ),
        ("opencv", K_R_T.replace("2, 3]", "5 -3]"), "in:3:5: t is [1, 5 -3]: it must be three"),
        ("opencv", K_R_T.replace("2, 3]", "2, 3_0]"), "in:3:5: t is [1, 2, 3_0]: it must be three"),
    ] {
        assert_refused(name, &text, message);
    }
}

/// Brackets in brackets, and statements without end: each ends, and soon.
#[test]
fn long_texts_end() {
    let many = 100_000;
    for (name, text) in [
        ("opengl", "gluLookAt(".repeat(many)),
        ("opengl", format!("{}{}", "gluLookAt(".repeat(many), ")".repeat(many))),
        (
            "opengl",
            format!("gluPerspective({}1{}, 1, 1, 9)", "radians(".repeat(many), ")".repeat(many)),
        ),
        ("opencv", "K = ".repeat(many)),
        ("opencv", "K = 3\n".repeat(many)),
        ("opencv", format!("K = {}{}\n", "[".repeat(many), "]".repeat(many))),
        ("opencv", format!("K = [{}]\n", "1, ".repeat(many))),
        ("opencv", format!("K = {}1\n", "-".repeat(many))),
        ("numbers", "1 ".repeat(many)),
        ("numbers", "1, 2\n".repeat(many)),
        ("three", format!("{THREE}{}", "camera.up.set(0, 1, 0)\n".repeat(many))),
    ] {
        assert!(read(name, &text).is_err(), "{}", &text[..40]);
    }
    // A no-break space, and a byte order mark.
    assert_eq!(taken("opengl", &GLU.replace(' ', "\u{a0}")), taken("opengl", GLU));
    assert_eq!(taken("opengl", &format!("\u{feff}{GLU}")), taken("opengl", GLU));
}
