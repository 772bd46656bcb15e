//! Tests of valid scene files: in the various notations that people use, and the built-in ones.

use std::path::Path;

use pinhole_core::{Camera, CameraError, DVec3, ImageSize, Orientation, Viewport};
use pinhole_exchange::document::Document;
use pinhole_exchange::scene_file;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};

fn read(text: &str) -> Document {
    scene_file::parse(text, Path::new("scene.toml"), Path::new("")).unwrap()
}

const CAMERA: &str =
    "pinhole = 1\n[camera]\neye = [1, 2.5, -3e2]\nview = [0, 0, -1]\nup = [0, 1, 0]\n";

#[test]
fn the_contract_s_example() {
    let document = read(
        r##"
pinhole = 1                       # format version

[camera]                          # exactly one of: at | view | basis
eye = [0.0, 0.0, 0.0]
at = [0.0, 0.0, -1.0]
up = [0.0, 1.0, 0.0]
# view = [0.0, 0.0, -1.0]
# basis = { u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0], w = [0.0, 0.0, 1.0] }

[viewport]                        # world units
width = 1.0
height = 1.0
distance = 1.0

[image]                           # pixels
width = 400
height = 400

[[sphere]]
name = "ball"                     # optional
center = [0.0, 0.0, -5.0]
radius = 1.0
color = "#e69f00"                 # optional

[[plane]]
name = "back wall"
point = [0.0, 0.0, -6.0]
normal = [0.0, 0.0, 1.0]
"##,
    );
    assert_eq!(document.camera, Camera::CANONICAL);
    let [ball] = &document.spheres[..] else { panic!("{:?}", document.spheres) };
    assert_eq!((ball.name.as_deref(), ball.color), (Some("ball"), Some([0xe6, 0x9f, 0])));
    assert_eq!((ball.shape.center, ball.shape.radius), (DVec3::new(0.0, 0.0, -5.0), 1.0));
    let [wall] = &document.planes[..] else { panic!("{:?}", document.planes) };
    assert_eq!((wall.name.as_deref(), wall.color), (Some("back wall"), None));
    assert_eq!((wall.shape.point.z, wall.shape.normal), (-6.0, DVec3::Z));
}

#[test]
fn what_is_left_out_is_canonical() {
    let document = read(CAMERA);
    let expected = Camera {
        eye: DVec3::new(1.0, 2.5, -300.0),
        orientation: Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
        ..Camera::CANONICAL
    };
    assert_eq!(document, Document { camera: expected, ..Document::default() });

    let text = format!("{CAMERA}[viewport]\ndistance = 2\n[image]\nwidth = 16384\n");
    let camera = read(&text).camera;
    assert_eq!(camera.viewport, Viewport { distance: 2.0, ..Viewport::CANONICAL });
    assert_eq!(camera.image, ImageSize::new(16384, 400).unwrap());
}

#[test]
fn the_other_ways_of_toml_are_read_too() {
    let plain = read(&format!(
        "{CAMERA}[[sphere]]\ncenter = [0, 1, 2]\nradius = 3\n[[sphere]]\ncenter = [4, 5, 6]\nradius = 7"
    ));
    let others = [
        "camera = { eye = [1, 2.5, -3e2], view = [0, 0, -1], up = [0, 1, 0] }\npinhole = 1\n\
         sphere = [{ center = [0, 1, 2], radius = 3 }, { center = [4, 5, 6], radius = 7 }]\n",
        "[[sphere]]\nradius = 3\ncenter = [0, 1, 2]\n[[sphere]]\nradius = 7\n\
         center = [4, 5, 6]\n[camera]\nup = [0, 1, 0]\nview = [0, 0, -1]\neye = [1, 2.5, -3e2]\n",
        "camera.eye = [1, 2.5, -300.0]\ncamera.view = [-0, 0, -1]\r\ncamera.up = [0, 1_0e-1, 0]\n\
         [[sphere]]\ncenter = [\n  0,\n  1, # one\n  2,\n]\nradius = 0x3\n\
         [[\"sphere\"]]\ncenter = [4, 5, 6]\n'radius' = 7\n",
    ];
    for text in others {
        let head = if text.contains("pinhole") { "" } else { "pinhole = 1\n" };
        assert_eq!(read(&format!("{head}{text}")), plain, "{text}");
    }
}

#[test]
fn a_camera_without_a_basis_loads_and_says_why() {
    let cases = [
        (
            "at = [1, 2, 3]\nup = [0, 1, 0]",
            "eye and at are the same point (1, 2, 3): move one of them",
        ),
        ("view = [0, 0, 0]\nup = [0, 1, 0]", "view is (0, 0, 0): it must point somewhere"),
        ("view = [0, 0, 1]\nup = [0, 0, 0]", "up is (0, 0, 0): it must point somewhere"),
        (
            "view = [0, 2, 0]\nup = [0, -1, 0]",
            "up (0, -1, 0) is parallel to the view direction (0, 2, 0): turn one of them",
        ),
        (
            "basis = { u = [2, 0, 0], v = [0, 1, 0], w = [0, 0, 1] }",
            "u has length 2: it must be 1 within 1e-9",
        ),
        (
            "basis = { u = [1, 0, 0], v = [0, 1, 0], w = [0, 0, -1] }",
            "the basis is left-handed: u x v is -w and must be w, which points backwards",
        ),
    ];
    for (orientation, reason) in cases {
        let document = read(&format!("pinhole = 1\n[camera]\neye = [1, 2, 3]\n{orientation}\n"));
        let error = document.camera.resolve().unwrap_err();
        assert!(matches!(error, CameraError::Basis(_)), "{error:?}");
        assert_eq!(error.to_string(), reason);
    }
}

#[test]
fn the_note_is_the_comment_at_the_head() {
    let document = read(&format!("# What to look for:\n#\n#  the horizon.\n\n# no note\n{CAMERA}"));
    assert_eq!(document.note, "What to look for:\n\n the horizon.");
    assert_eq!(read(&format!("\u{feff}# one\r\n# two\r\n{CAMERA}")).note, "one\ntwo");
    assert_eq!(read(&format!("\n# late\n{CAMERA}")).note, "");
}

#[test]
fn a_file_that_is_no_text_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, b"pinhole = 1\n# caf\xe9\n").unwrap();
    let message = scene_file::load(&path).unwrap_err().to_string();
    let expected = ":2:6: not UTF-8 text: a scene file is text in UTF-8";
    assert_eq!(message, format!("{}{expected}", path.display()));
    let missing = folder.path().join("missing.toml");
    let message = scene_file::load(&missing).unwrap_err().to_string();
    let expected = ": cannot be read: no such file or directory";
    assert_eq!(message, format!("{}{expected}", missing.display()));
}

#[test]
fn built_in_scenes_load_and_can_be_seen() {
    let names: Vec<&str> = BuiltinScene::all().iter().map(|builtin| builtin.name).collect();
    let wanted = "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up \
                  planet grazing tiny-far inside non-square";
    assert_eq!(names.join(" "), wanted);
    for builtin in BuiltinScene::all() {
        let document = builtin.load().unwrap();
        assert!(!document.note.is_empty() && !document.spheres.is_empty(), "{}", builtin.name);
        document.camera.resolve().unwrap();
        document.scene().unwrap();
        let summary = builtin.summary();
        assert!(summary.ends_with('.') && summary.len() <= 80, "{summary}");
        assert!(document.note.replace('\n', " ").starts_with(&summary));
        assert_eq!(
            SceneSource::from_argument(Path::new(builtin.name)),
            Ok(SceneSource::Builtin(builtin))
        );
    }
}

#[test]
fn a_scene_argument_is_a_path_or_a_name() {
    let folder = tempfile::tempdir().unwrap();
    let named_like_a_scene = folder.path().join("planet");
    std::fs::write(&named_like_a_scene, CAMERA).unwrap();
    for path in [&named_like_a_scene, Path::new("a/b"), Path::new("./planet"), Path::new("x.toml")]
    {
        assert_eq!(SceneSource::from_argument(path), Ok(SceneSource::File(path.to_owned())));
    }
    let message = |name: &str| SceneSource::from_argument(Path::new(name)).unwrap_err().to_string();
    assert_eq!(
        message("fourty-five"),
        "fourty-five: neither a file nor a built-in scene: did you mean forty-five?"
    );
    assert_eq!(
        message("zebra"),
        "zebra: neither a file nor a built-in scene: the built-in ones are canonical, \
         distance-two, moved-eye, forty-five, look-at, roll, almost-parallel-up, planet, grazing, \
         tiny-far, inside, non-square"
    );
}
