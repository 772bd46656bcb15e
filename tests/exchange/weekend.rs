//! The book's camera by its constructor, and what is not set.

use pinhole::exchange::recognised;
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

#[test]
fn a_constructor_of_bare_vectors_is_recognised() {
    let text = "int nx = 200;\nint ny = 100;\n\
                camera cam(vec3(-2,2,1), vec3(0,0,-1), vec3(0,1,0), 90, float(nx)/float(ny));\n";
    let rust = "let cam = Camera::new(\n    Point3::new(-2.0, 2.0, 1.0),\n    Point3::new(0.0, 0.0, -1.0),\n    \
                Vec3::new(0.0, 1.0, 0.0),\n    90.0,\n    ASPECT,\n);\nconst ASPECT: f64 = 2.0;\n";
    for text in [text, &text.replace("vec3(-", "point3(-"), rust] {
        assert_eq!(recognised(text).map(|format| format.name), Some("weekend"), "{text}");
        let camera = read("weekend", text).unwrap().camera;
        assert_eq!(camera.eye, DVec3::new(-2.0, 2.0, 1.0));
        assert_eq!(camera.viewport.width, 2.0 * camera.viewport.height);
    }
    for other in [
        "Camera camera(glm::vec3(0.0f, 0.0f, 3.0f));\n",
        "Camera camera(vec3(0, 0, 3), vec3(0, 1, 0), -90, 0);\n",
        "const camera = new THREE.PerspectiveCamera(50, 1.5, 0.1, 100);\n",
        "perspective_camera(vec3(0,0,3), vec3(0,0,0), vec3(0,1,0), 90, 1);\n",
    ] {
        assert_ne!(recognised(other).map(|format| format.name), Some("weekend"), "{other}");
    }
}

#[test]
fn the_first_chapters_camera_stands_where_it_is_made() {
    let text = "camera cam;\ncam.aspect_ratio = 16.0 / 9.0;\ncam.image_width  = 400;\ncam.render(world);\n";
    assert_eq!(recognised(text).map(|format| format.name), Some("weekend"));
    let taken = read("weekend", text).unwrap();
    assert_eq!((taken.camera.eye, taken.camera.view()), (DVec3::ZERO, DVec3::NEG_Z));
    assert_eq!((taken.camera.image.width(), taken.camera.image.height()), (400, 225));
    let told = ["lookfrom", "lookat", "vup", "vfov", "focus_dist"];
    assert_eq!(taken.notes.len(), told.len());
    for (note, told) in taken.notes.iter().zip(told) {
        assert!(note.starts_with(&format!("{told} is not in the text: ")), "{note}");
    }
    let error = read("weekend", "int image_width = 400;\n").unwrap_err().to_string();
    assert!(error.contains("lookfrom is missing"), "{error}");
}
