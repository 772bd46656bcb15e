//! COLMAP's two files: which camera an image has, and names with blanks.

use pinhole_core::{DVec3, ImageSize};

use super::read;

const CAMERAS: &str = "# Camera list\n1 SIMPLE_RADIAL 3072 2304 2559.81 1536 1152 -0.02\n\
                       2 PINHOLE 640 480 500 510 320 240\n";

#[test]
fn an_image_has_the_camera_of_its_camera_id() {
    let text = format!("{CAMERAS}1 1 0 0 0 0 0 5 2 a.jpg\n\n2 1 0 0 0 0 0 6 1 b.jpg\n\n");
    let taken = read("colmap", &text).unwrap();
    assert_eq!(taken.camera.image, ImageSize::new(640, 480).unwrap());
    assert_eq!(taken.notes, ["a.jpg is taken; 1 more images are left out"]);
    for (text, message) in [
        (
            format!("{CAMERAS}1 1 0 0 0 0 0 5 7 a.jpg\n"),
            "in:4:1: CAMERA_ID of a.jpg is 7: it must be that of a camera in cameras.txt, 1, 2",
        ),
        (
            format!("{CAMERAS}2 PINHOLE 64 48 50 51 32 24\n1 1 0 0 0 0 0 5 2 a.jpg\n"),
            "in:4:1: CAMERA_ID is 2: it must be given once",
        ),
    ] {
        assert_eq!(read("colmap", &text).unwrap_err().to_string(), message);
    }
}

#[test]
fn names_may_have_blanks_or_be_numbers() {
    let points = "2362.39 248.498 58396 1784.7 268.254 59027 1784.7 268.254 -1 5 5 5\n";
    let other = "9 0.5 0.5 0.5 0.5 0 0 6 1 b.jpg\n\n";
    for (name, points) in [
        ("my photo 1.jpg", "\n"),
        ("my photo 1.jpg", points),
        ("1 2 3.jpg", points),
        ("000123", points),
        ("000123", "\n"),
        ("a.jpg", ""),
        ("a.jpg", "\r\n"),
    ] {
        let text = format!("{CAMERAS}4 1 0 0 0 0 0 5 2 {name}\n{points}{other}");
        let taken = read("colmap", &text).unwrap();
        assert_eq!(taken.camera.eye, DVec3::new(0.0, 0.0, -5.0), "{name}");
        assert_eq!(taken.notes, [format!("{name} is taken; 1 more images are left out")]);
    }
    let broken = format!("{CAMERAS}4 1 0 0 zero 0 0 5 2 a.jpg\n\n{other}");
    let taken = read("colmap", &broken).unwrap();
    assert_eq!(
        taken.notes[0],
        "1 lines are left out, the first is \"4 1 0 0 zero 0 0 5 2 a.jpg\": they are none of a camera, \
         an image or its points"
    );
}
