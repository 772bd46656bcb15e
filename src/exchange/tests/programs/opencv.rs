//! OpenCV's K, R and t in JSON and in YAML.

use pinhole_core::{Camera, DVec3, ImageSize};
use pinhole_exchange::programs::importer_of;

use super::read;

const JSON: &str = "{\"K\": [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]],\n\
                    \"R\": [1, 0, 0, 0, -1, 0, 0, 0, -1],\n\"t\": [[1], [2], [3]]}";

#[track_caller]
fn camera(text: &str) -> (Camera, Vec<String>) {
    assert_eq!(importer_of(text).map(|importer| importer.name), Some("opencv"), "{text}");
    let taken = read("opencv", text).unwrap_or_else(|error| panic!("{error}: {text}"));
    (taken.camera, taken.notes)
}

#[test]
fn json_and_yaml_in_the_forms_that_opencv_writes() {
    let (plain, notes) = camera(JSON);
    assert_eq!(plain.eye, DVec3::new(-1.0, 2.0, 3.0));
    assert_eq!(
        notes,
        ["the image's size is not given: 640 × 480, whose middle is the principal point, taken"]
    );
    let storage = "{\"left\": {\"camera_matrix\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, \"cols\": 3, \
                   \"data\": [500, 0, 319.5, 0, 510, 239.5, 0, 0, 1]},\n\
                   \"rvec\": [3.141592653589793, 0, 0], \"tvec\": [1, 2, 3]}}";
    let (stored, _) = camera(storage);
    assert!((stored.eye - plain.eye).length() < 1e-12, "{}", stored.eye);
    let yaml = "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   \
                rows: 3\n   cols: 3\n   dt: d\n   data: [ 500., 0., 319.5, 0., 510.,\n       239.5, 0., 0., 1. ]\n\
                rvec: [3.141592653589793, 0, 0]\ntvec: [1, 2, 3]\n";
    let (written, notes) = camera(yaml);
    assert!((written.eye - plain.eye).length() < 1e-12, "{}", written.eye);
    assert_eq!((written.image, notes), (ImageSize::new(640, 480).unwrap(), vec![]));
    let ros = "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [500, 0, 320, 0, 510, 240, 0, 0, 1]\n\
               distortion_coefficients:\n  data: [0.1, 0, 0, 0, 0]\nrotation: [1, 0, 0, 0, -1, 0, 0, 0, -1]\n\
               translation: [1, 2, 3]\n";
    let (read, notes) = camera(ros);
    assert_eq!(read.eye, plain.eye);
    // 320 is meant as half of 640, though whole numbers are centres.
    assert_eq!(notes[0], "the image's size is not given: 640 × 480, twice cx and cy, taken");
    assert!(notes[1].starts_with("the principal point is 0.5 pixels right"), "{notes:?}");
    assert!(notes[2].starts_with("distortion_coefficients is left out"), "{notes:?}");
}

/// As `cv::calibrateCamera` and ROS have it.
#[test]
fn k_without_r_and_t_is_a_camera_at_the_origin() {
    let yaml = "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   \
                rows: 3\n   cols: 3\n   dt: d\n   data: [ 500., 0., 319.5, 0., 510., 239.5, 0., 0., 1. ]\n";
    let json =
        "{\"width\": 640, \"height\": 480, \"K\": [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]}";
    let statement = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nwidth = 640\nheight = 480";
    for text in [yaml, json, statement] {
        let (taken, notes) = camera(text);
        let basis = *taken.resolve().unwrap().basis();
        assert_eq!((taken.eye, basis.u), (DVec3::ZERO, DVec3::X));
        assert_eq!((basis.v, basis.w), (DVec3::NEG_Y, DVec3::NEG_Z));
        assert_eq!(taken.viewport.width / taken.viewport.distance, 640.0 / 500.0);
        let note = "R and t are not given: the eye is taken at the origin, looking along +z with y down, as \
                    OpenCV's camera does";
        assert_eq!(notes, [note]);
    }
}

#[test]
fn what_is_given_twice_or_makes_no_camera_is_refused() {
    for (text, message) in [
        (
            JSON.replace("\"R\":", "\"rvec\": [0, 1, 0], \"R\":"),
            "in:2:1: rvec is [0,1,0]: R in line 2 is another rotation: only one of them may be given",
        ),
        (JSON.replace("\"t\":", "\"tvec\": [0, 1, 0], \"t\":"), "only one of them may be"),
        (
            JSON.replace(
                "\"R\": [1",
                "\"extrinsic\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], \"R\": [1",
            ),
            "extrinsic is given too",
        ),
        (
            JSON.replace("\"R\":", "\"width\": 40, \"height\": 0.5, \"R\":"),
            "it must be whole numbers from 1 to",
        ),
        (JSON.replace("500", "\"wide\""), "it must be 3 × 3 numbers"),
        (
            JSON.replace("\"t\"", "\"offset\""),
            "in: t is missing: the translation must be three numbers",
        ),
        (
            JSON.replace("319.5", "0.5").replace("239.5", "0.5"),
            "in: width is missing: K's principal point is (0.5, 0.5)",
        ),
    ] {
        let error = read("opencv", &text).unwrap_err().to_string();
        assert!(error.contains(message), "{error}: {text}");
    }
    let degrees = JSON.replace("\"R\": [1, 0, 0, 0, -1, 0, 0, 0, -1]", "\"rvec\": [0, 45, 0]");
    assert!(camera(&degrees).1.iter().any(|note| note.starts_with("rvec turns by more than")));
}

#[test]
fn a_rotation_given_twice_is_that_of_the_matrix() {
    let both = |rvec: &str| JSON.replace("\"t\":", &format!("\"rvec\": {rvec}, \"t\":"));
    // As NumPy prints it.
    let (taken, notes) = camera(&both("[3.14159265, 0, 0]"));
    assert_eq!((taken, notes), camera(JSON));
    let refused = read("opencv", &both("[3.1416, 0, 0]")).unwrap_err().to_string();
    let message = "in:3:1: rvec is [3.1416,0,0]: R in line 2 is another rotation: only one of them may be given";
    assert_eq!(refused, message);
    let whole = "K = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]\nrvec = [0.1, 0, 0]\nt = [0, 0, 5]\n\
                 R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
    let refused = read("opencv", whole).unwrap_err().to_string();
    assert!(
        refused.starts_with("in:2:8: rvec is [0.1, 0, 0]: R in line 4 is another"),
        "{refused}"
    );
}

#[test]
fn a_mirrored_world_is_turned_over() {
    let (mirrored, notes) = camera(&JSON.replace("0, 0, -1],", "0, 0, 1],"));
    assert!(notes.iter().any(|note| note.starts_with("its world is left-handed")), "{notes:?}");
    assert_eq!(mirrored.eye, DVec3::new(-1.0, 2.0, 3.0));
}
