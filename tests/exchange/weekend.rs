//! The book's camera by its constructor, and what is not set.

use pinhole_core::DVec3;

use super::read;

const THIRD: &str = "\
    const auto aspect_ratio = 3.0 / 2.0;
    const int image_width = 1200;
    const int image_height = static_cast<int>(image_width / aspect_ratio);
    point3 lookfrom(13,2,3);
    point3 lookat(0,0,0);
    vec3 vup(0,1,0);
    auto dist_to_focus = 10.0;
    camera cam(lookfrom, lookat, vup, 20, aspect_ratio, 0.1, dist_to_focus);
";

#[test]
fn the_constructor_of_the_earlier_versions_is_read() {
    let rust = THIRD
        .replace("point3 lookfrom(13,2,3)", "let lookfrom = Point3::new(13.0, 2.0, 3.0)")
        .replace("camera cam(", "let cam = Camera::new(")
        .replace("static_cast<int>(image_width / aspect_ratio)", "800");
    for text in [THIRD, &rust, &THIRD.replace("camera cam(", "camera cam = camera(")] {
        let taken = read("weekend", text).unwrap();
        let camera = taken.camera;
        assert_eq!((camera.eye, camera.viewport.distance), (DVec3::new(13.0, 2.0, 3.0), 10.0));
        assert_eq!((camera.image.width(), camera.image.height()), (1200, 800));
        assert!((camera.viewport.vertical_fov().to_degrees() - 20.0).abs() < 1e-12, "{text}");
        assert_eq!(taken.notes, ["aperture is left out: a pinhole is sharp everywhere"]);
    }
    let way = THIRD.replace("= 10.0", "= (lookfrom-lookat).length()");
    assert_eq!(read("weekend", &way).unwrap().camera.viewport.distance, 182_f64.sqrt());
    let defined = format!(
        "camera(point3 lookfrom, point3 lookat, vec3 vup, double vfov, double aspect) {{}}\n{THIRD}"
    );
    assert_eq!(read("weekend", &defined).unwrap().camera.eye.x, 13.0);
}

#[test]
fn what_is_not_set_is_told() {
    let taken = read("weekend", "cam.lookfrom = point3(0, 0, 1);\n").unwrap();
    let told = ["lookat", "vup", "vfov", "image_width", "aspect_ratio", "focus_dist"]
        .map(|name| format!("{name} is not in the text: "));
    assert_eq!(taken.notes.len(), told.len());
    for (note, told) in taken.notes.iter().zip(told) {
        assert!(note.starts_with(&told), "{note}");
    }
    assert_eq!(taken.notes[2], "vfov is not in the text: 90 taken, as in the book's camera");
}

#[test]
fn of_several_cameras_none_is_taken() {
    let two = "cam.lookfrom = point3(0, 0, 1);\ncam.lookfrom = point3(0, 0, 2);\n";
    let error = read("weekend", two).unwrap_err().to_string();
    assert_eq!(
        error,
        "in:2:16: lookfrom is point3(0, 0, 2): it is given 2 times: leave in one camera"
    );
    let two = format!(
        "{THIRD}    camera b(lookfrom, lookat, vup, 30, aspect_ratio, 0.1, dist_to_focus);\n"
    );
    assert!(
        read("weekend", &two).unwrap_err().to_string().contains("one of 2 cameras: leave in one")
    );
}
