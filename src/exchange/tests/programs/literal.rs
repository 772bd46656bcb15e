//! Tests of cameras in pasted text, which are read if every number is literal, and otherwise rejected
//! with the line of the error.

use pinhole_core::{Camera, DVec3, ImageSize, Intrinsics, Orientation};
use pinhole_exchange::FileError;
use pinhole_exchange::format::Imported;

use super::{Importer, proofs, text_of};

const GLU: &str = "gluLookAt(0, 0, 5, 0, 1, 0, 0, 1, 0);\n";
const GLM: &str = "glm::mat4 view = glm::lookAt(glm::vec3(4, 3, 3), // the eye\n  \
                   glm::vec3(0.0f), glm::vec3(0, 1, 0));\n";
const K_R_T: &str = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\n\
                     R = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]\nt = [1, 2, 3]\n";

fn read(text: &str) -> Result<Imported, FileError> {
    super::read(Importer::Literal, text)
}

#[track_caller]
fn taken(text: &str) -> Camera {
    assert_eq!(Importer::of(text), Some(Importer::Literal), "{text}");
    read(text).unwrap_or_else(|error| panic!("{error}: {text}")).camera
}

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    let error = read(text).unwrap_err().to_string();
    assert!(error.contains(message), "{error}: {text}");
}

fn at(camera: &Camera) -> DVec3 {
    match camera.orientation {
        Orientation::At { at, .. } => at,
        other => panic!("{other:?}"),
    }
}

#[test]
fn one_look_at_is_taken_and_the_rest_is_as_at_hand() {
    let camera = taken(GLU);
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(0.0, 0.0, 5.0), DVec3::Y));
    assert_eq!(camera.viewport, Camera::CANONICAL.viewport);
    let notes = read(GLU).unwrap().notes;
    assert_eq!(notes, ["the field of view is not given: 53.1301 degrees from bottom to top kept"]);
    let camera = taken(&format!("/* two\nlines */ {}", GLM.replace("glm::", "")));
    assert_eq!((camera.eye, at(&camera)), (DVec3::new(4.0, 3.0, 3.0), DVec3::ZERO));
    assert_eq!(taken(GLM), camera);
    // A no-break space, and a byte order mark.
    assert_eq!(taken(&GLU.replace(' ', "\u{a0}")), taken(GLU));
    assert_eq!(taken(&format!("\u{feff}{GLU}")), taken(GLU));
}

#[test]
fn eye_at_and_up_are_taken_by_their_names() {
    let camera = taken(GLU);
    for text in [
        "eye = 0 0 5\nat = 0 1 0\nup = 0 1 0",
        "up: (0, 1, 0)\nat: (0, 1, 0)\neye: (0, 0, 5)\n",
        "eye = glm::vec3(0, 0, 5); at = glm::vec3(0, 1, 0); up = glm::vec3(0, 1, 0);",
        "eye = [0, 0, 5], at = [0, 1, 0], up = [0, 1, 0]",
        "vec3 eye = vec3(0, 0, 5);\nvec3 at = vec3(0, 1, 0);\nvec3 up = vec3(0, 1, 0);",
    ] {
        assert_eq!(taken(text), camera, "{text}");
    }
    for (text, message) in [
        ("eye = 0 0 5\nat = 0 1 0", "in: up is missing: it must be three numbers"),
        ("eye = 0 0 5\nat = 0 1\nup = 0 1 0", "in:2:1: at = 0 1: it must have three numbers"),
        ("eye = 0 0 5\neye = 0 1 0", "in:2:1: eye = 0 1 0: eye is given twice"),
        ("eye = 0 0 5\nfov = 60", "in:2:1: fov = 60: only eye, at and up may"),
    ] {
        assert_refused(text, message);
    }
}

#[test]
fn k_r_and_t_are_taken_as_lists_arrays_and_as_numpy_prints_them() {
    let printed = "K:\n[[500.    0.  319.5]\n [  0.  510.  239.5]\n [  0.    0.    1. ]]\n\
                   R = [[ 1.  0.  0.]\n [ 0. -1. -0.]\n [ 0. -0. -1.]]\nt = [1. 2. 3.]\n";
    let arrays = K_R_T.replace("= [", "= np.array([").replace("]\n", "])\n");
    for text in [K_R_T, printed, &format!("import numpy as np\n{arrays}")] {
        let camera = taken(text);
        assert_eq!(camera.eye, DVec3::new(-1.0, 2.0, 3.0), "{text}");
        assert_eq!(camera.resolve().unwrap().basis().w, DVec3::Z);
        assert_eq!(camera.image, ImageSize::new(640, 480).unwrap());
    }
    let whole = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nwidth = 640\nheight = 480\n\
                 Rt = [[1, 0, 0, 1], [0, -1, 0, 2], [0, 0, -1, 3]]\n";
    assert_eq!(taken(whole).eye, DVec3::new(-1.0, 2.0, 3.0));
}

/// The form that `pinhole import --help` and the man page give.
#[test]
fn k_r_and_t_are_taken_on_one_line_and_as_json() {
    let help = include_str!("../../../cli/about/import.txt");
    let form = "K = [[...]], R = [[...]], t = [...]";
    assert!(help.contains(form), "{help}");
    let [k, r, t] =
        ["500, 0, 319.5], [0, 510, 239.5], [0, 0, 1", "1, 0, 0], [0, -1, 0], [0, 0, -1", "1, 2, 3"];
    let line =
        [k, r, t].iter().fold(form.to_owned(), |line, numbers| line.replacen("...", numbers, 1));
    assert_eq!(taken(&line), taken(K_R_T));
    assert_eq!(taken(&format!("{line}, width = 640, height = 480")), taken(K_R_T));
    let quoted = line.replace(" =", "\":").replace(", R", ",\n\"R").replace(", t", ", \"t");
    let json = format!("{{\n  \"{quoted},\n  \"distortion\": [0, 0, 0, 0, 0]\n}}\n");
    assert_eq!(taken(&json), taken(K_R_T));
    assert_eq!(taken(&json.replace('"', "'")), taken(K_R_T));
    let distorted = json.replace("0, 0]\n}", "0, 0.1]\n}");
    assert_refused(&distorted, "in:4:17: distortion is [0, 0, 0, 0, 0.1]: it must be 0");
    assert_refused(&json.replace("\"R", "\"S"), "in:3:2: S: [[1, 0, 0], [0, -1, 0]");
}

/// Except for the viewport's distance, which K, R and t do not tell.
#[test]
fn what_is_written_for_opencv_is_read_back() {
    for (name, document) in proofs() {
        let (back, camera) = (taken(&text_of("opencv", &document)), document.camera);
        let [a, b] = [back, camera].map(|camera| *camera.resolve().unwrap().basis());
        assert!((a.u - b.u).length().max((a.w - b.w).length()) < 1e-15, "{name}: {a:?} {b:?}");
        assert!((back.eye - camera.eye).length() < 1e-14, "{name}: {}", back.eye);
        let lens = |camera: &Camera| Intrinsics::from_viewport(&camera.viewport, camera.image);
        let (a, b) = (lens(&back), lens(&camera));
        assert!((a.fx / b.fx - 1.0).abs().max((a.fy / b.fy - 1.0).abs()) < 1e-15, "{name}");
        assert_eq!(back.image, camera.image, "{name}");
    }
}

/// Sixty digits are no news, and *inf* is wrong.
#[test]
fn a_principal_point_far_out_is_told_with_its_number() {
    let text = K_R_T.replace("319.5", "1e308") + "width = 640\nheight = 480\n";
    let notes = read(&text).unwrap().notes.join(" ");
    assert!(
        notes.contains("is 1e308 pixels right of the image's middle and 0 below it"),
        "{notes}"
    );
}

#[test]
fn k_alone_is_a_camera_at_the_origin_and_what_it_leaves_open_is_told() {
    let k = "K = [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]]\n";
    let Imported { camera, notes } = read(&format!("{k}width = 640\nheight = 480")).unwrap();
    let basis = *camera.resolve().unwrap().basis();
    assert_eq!((camera.eye, basis.u), (DVec3::ZERO, DVec3::X));
    assert_eq!((basis.v, basis.w), (DVec3::NEG_Y, DVec3::NEG_Z));
    assert_eq!(camera.viewport.width / camera.viewport.distance, 640.0 / 500.0);
    let origin = "R and t are not given: the eye is taken at the origin, looking along +z with y down, as \
                  OpenCV's camera does";
    assert_eq!(notes, [origin]);
    let size =
        "the image's size is not given: 640 × 480, whose middle is the principal point, taken";
    assert_eq!(read(k).unwrap().notes, [size, origin]);
    // A principal point of 320 is meant as half of 640, although integers are pixel centres in OpenCV.
    let notes = read(&k.replace("319.5", "320").replace("239.5", "240")).unwrap().notes;
    assert_eq!(notes[0], "the image's size is not given: 640 × 480, twice cx and cy, taken");
    assert!(notes[1].starts_with("the principal point is 0.5 pixels right"), "{notes:?}");
    let mirrored = read(&K_R_T.replace("0, 0, -1]]\n", "0, 0, 1]]\n")).unwrap();
    assert!(mirrored.notes.iter().any(|note| note.starts_with("its world is left-handed")));
    assert_eq!(mirrored.camera.eye, DVec3::new(-1.0, 2.0, 3.0));
}

#[test]
fn numbers_alone_are_eye_at_up_or_a_matrix() {
    let look = taken("(1, 2, 3)\n(0, 0, 0)\n(0, 1, 0)");
    assert_eq!((look.eye, at(&look)), (DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO));
    assert_eq!(look.viewport, Camera::CANONICAL.viewport);
    assert_eq!(taken("1 2 3 0 0 0 0 1 0"), look);
    assert_eq!(taken("[1, 2, 3, 0, 0, 0, 0, 1, 0]"), look);
    let ten = taken("1, 2, 3,  0, 0, 0,\n 0, 1, 0,  60");
    assert!((ten.viewport.vertical_fov().to_degrees() - 60.0).abs() < 1e-12);
    let rows = taken("0 0 1 7\n0 1 0 8\n-1 0 0 9");
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
        assert_eq!(taken(text), rows, "{text}");
    }
    let rotation = "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
    assert_refused(rotation, "it must be nine numbers (eye, at, up), ten");
    let eleven = "1 2 3 0 0 0 0 1 0 45 6";
    assert_refused(eleven, "in: the count of numbers is 11: it must be 9 (eye, at, up), 10 (and");
    assert_refused("1 2 3 4 5 6 7 8 9, 10 - 3", "this is 10 - 3: it must be given by");
    assert_refused("1 2 3 0 0 0 0 1 0 190", "it must be between 0 and 180 degrees");
    assert_refused("view = [[1,0,0,0],[0,1,0,0],[0,0,1,0]]", "it must be nine numbers");
    assert_refused("1 0 0 0\n0 1 0 0\n0 0 0 0", "it is no rotation: one of its axes");
    let program = "def looks(name):\ncamera.matrix_world = Matrix(((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)))";
    assert_refused(program, "def looks(name): it must be nine numbers");
    let notes = |text: &str| read(text).unwrap().notes.join("; ");
    assert!(notes("0 0 -1 0\n0 1 0 0\n1 0 0 0\n7 8 9 1").contains("its rows are right, up"));
    assert!(!notes("0 0 1 7\n0 1 0 8\n-1 0 0 9").contains("scale"));
    assert!(notes("0 0 2 7\n0 1 0 8\n-1 0 0 9").contains("its scale is left out"));
}

/// A text with a variable, a calculation or a further statement is rejected, and not read in part.
#[test]
fn what_is_not_literal_is_refused_at_its_line() {
    let numbers = "it must be given by numbers, without names or calculations";
    for (text, message) in [
        (GLU.replace("0, 0, 5", "x, 0, 5"), "in:1:11: gluLookAt is x: "),
        (GLU.replace("0, 0, 5", "0,, 0, 5"), "gluLookAt"),
        (GLM.replace("glm::vec3(4, 3, 3)", "pos"), "in:1:30: glm::lookAt is pos: "),
        (GLM.replace("vec3(4, 3, 3)", "vec3(4, 3, 3) + front"), "in:1:30: glm::lookAt is "),
    ] {
        assert_refused(&text, message);
        assert_refused(&text, numbers);
    }
    for (text, message) in [
        (
            format!("{GLU}glTranslatef(0, 0, -6);\n"),
            "in:2:1: glTranslatef(0, 0, -6): only one gluLookAt",
        ),
        (
            format!("gluPerspective(45, 1.5, 0.1, 100);\n{GLU}"),
            "in:1:1: gluPerspective(45, 1.5, 0.1, 100): only one gluLookAt",
        ),
        (format!("{GLU}{GLU}"), "in:2:1: gluLookAt(0, 0, 5, 0, 1, 0, 0, 1, 0): only one gluLookAt"),
        (format!("{GLM}view = glm::rotate(view, 1.0f, axis);"), "in:3:1: view = glm::rotate"),
        (GLM.replace("= glm::lookAt", "= roll * glm::lookAt"), "in:1:1: glm::mat4 view = roll * "),
        (GLM.replace("0));\n", "0)) * model;\n"), "in:1:1: glm::mat4 view = "),
        ("gluLookAt(1, 2)".to_owned(), "in:1:1: gluLookAt(1, 2): it must have 9 numbers"),
        (format!("#if 0\n{GLU}#endif\n"), "in:1:1: "),
        (format!("if (far) {{\n{GLU}}}\n"), "in:1:1: if (far) {"),
        ("# nothing".to_owned(), "in: a number is missing: it must be nine numbers"),
        (format!("{K_R_T}t[2] = 9\n"), "in:4:1: t[2] = 9: it must be nine numbers"),
        (format!("{K_R_T}t = t / 1000\n"), "in:4:5: t is t / 1000: it must be three numbers"),
        (format!("{K_R_T}if far:\n    t = [0, 0, 9]\n"), "in:4:1: if far:"),
        (
            format!("{K_R_T}tvec = [0, 0, 9]\n"),
            "in:4:8: tvec is [0, 0, 9]: t is given too: only one",
        ),
        (format!("{K_R_T}Rt = 3\n"), "in:4:6: Rt is 3: it must be [R|t], 3 × 4"),
        (format!("{K_R_T}rvec = [0, 0, 1]\n"), "in:4:1: rvec = [0, 0, 1]: only K, R and t, and"),
        (K_R_T.replace("[1, 2, 3]", "np.zeros(3)"), "in:3:1: t = np.zeros(3): only K, R and t"),
        (
            K_R_T.replace("t = [1, 2, 3]\n", ""),
            "in: t is missing: the translation must be three numbers",
        ),
        (
            K_R_T.replace("[1, 2, 3]", "[1, 2, 3000] / 1000"),
            "in:3:5: t is [1, 2, 3000] / 1000: it must be three",
        ),
        (K_R_T.replace("2, 3]", "2 // 3]"), "in:3:11: // 3]: a number must not stand before //"),
        (K_R_T.replace("2, 3]", "5 -3]"), "in:3:5: t is [1, 5 -3]: it must be three"),
        (K_R_T.replace("2, 3]", "2, 3_0]"), "in:3:5: t is [1, 2, 3_0]: it must be three"),
        (
            K_R_T.replace("500, 0", "500, 2"),
            "it must be fx 0 cx, 0 fy cy, 0 0 1 with fx and fy greater",
        ),
        (
            K_R_T.replace(", [0, 0, 1]]", "]"),
            "in:1:5: K is [[500, 0, 319.5], [0, 510, 239.5]]: it must be",
        ),
        (
            K_R_T.replace("[0, -1, 0]", "[1, -1, 0]"),
            "in: R is no rotation: its axes are off a right angle by",
        ),
        (
            format!("{K_R_T}width = 40\nheight = 0.5"),
            "width is 40: it must be whole numbers from 1 to",
        ),
        (
            K_R_T.replace("319.5", "0.5").replace("239.5", "0.5"),
            "in: width is missing: K's principal point is (0.5, 0.5)",
        ),
    ] {
        assert_refused(&text, message);
    }
}

/// Reading deeply nested brackets and very long texts ends with an error, and soon.
#[test]
fn long_texts_end() {
    let many = 100_000;
    for text in [
        "gluLookAt(".repeat(many),
        format!("{}{}", "gluLookAt(".repeat(many), ")".repeat(many)),
        format!("gluLookAt({}1{})", "vec3(".repeat(many), ")".repeat(many)),
        "K = ".repeat(many),
        "K = 3\n".repeat(many),
        format!("K = {}{}\n", "[".repeat(many), "]".repeat(many)),
        format!("K = [{}]\n", "1, ".repeat(many)),
        format!("K = {}1\n", "-".repeat(many)),
        "1 ".repeat(many),
        "1, 2\n".repeat(many),
        GLU.repeat(many),
    ] {
        assert!(read(&text).is_err(), "{}", &text[..40]);
    }
}
