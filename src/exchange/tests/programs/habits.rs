//! Texts as other people write them.

use pinhole_core::{Basis, Camera, DVec3};

use super::read;

/// Right, up and backwards of what was read, with its notes.
#[track_caller]
fn basis_of(format: &str, text: &str) -> (Camera, Basis, Vec<String>) {
    let taken = read(format, text).unwrap_or_else(|error| panic!("{error}"));
    let basis = *taken.camera.resolve().unwrap().basis();
    (taken.camera, basis, taken.notes)
}

#[track_caller]
fn assert_near(a: DVec3, b: [f64; 3]) {
    let b = DVec3::from_array(b);
    assert!((a - b).length() < 1e-12, "{a} {b}");
}

/// The camera of POV-Ray's tutorial: a left-handed world is seen as in a mirror.
#[test]
fn pov_ray_with_look_at_and_angle() {
    let text = "#include \"colors.inc\"\n/* a comment { */\ncamera {\n  location <0, 2, -3>\n  \
                look_at <0, 1, 2>\n  right x*image_width/image_height\n  angle 90\n}\n\
                sphere { <0, 1, 2>, 2 texture { pigment { color rgb <1, 0, 0> } } }\n\
                plane { y, -1 pigment { checker } }\nbox { <0,0,0>, <1,1,1> } // +W320 +H160\n";
    let (camera, basis, notes) = basis_of("povray", text);
    assert_eq!((camera.image.width(), camera.image.height()), (320, 160));
    assert_eq!(camera.eye, DVec3::new(0.0, 2.0, 3.0));
    assert_near(basis.u, [1.0, 0.0, 0.0]);
    assert_near(-basis.w, (DVec3::new(0.0, -1.0, -5.0) / 26_f64.sqrt()).into());
    assert!((camera.viewport.horizontal_fov().to_degrees() - 90.0).abs() < 1e-12);
    let aspect = camera.viewport.width / camera.viewport.height;
    assert!((aspect - 2.0).abs() < 1e-14, "{aspect}");
    assert!(notes[0].starts_with("its world is left-handed"), "{notes:?}");
    assert_eq!(notes[1], "1 of box left out: Pinhole has spheres and planes");
    let taken = read("povray", text).unwrap();
    assert_eq!(taken.spheres[0].shape.center, DVec3::new(0.0, 1.0, -2.0));
    assert_eq!(taken.spheres[0].color, Some([255, 0, 0]));
    assert_eq!(taken.planes[0].shape.point, DVec3::new(0.0, -1.0, 0.0));
}

#[test]
fn pbrt_without_the_mirror_and_by_a_matrix() {
    let text = "LookAt 3 4 1.5  .5 .5 0  0 0 1\nCamera \"perspective\" \"float fov\" 45\n\
                Sampler \"halton\" \"integer pixelsamples\" 128\n\
                Film \"rgb\" \"string filename\" \"simple.png\" \"integer xresolution\" [400] \
                \"integer yresolution\" [400]\nWorldBegin\nAttributeBegin\n  Translate 1 2 3\n  \
                Shape \"sphere\" \"float radius\" 2\nAttributeEnd\nShape \"disk\"\n";
    let (camera, basis, notes) = basis_of("pbrt", text);
    // The same picture: right is the mirror image of pbrt's right.
    assert_eq!(camera.eye, DVec3::new(3.0, 4.0, -1.5));
    let ahead = DVec3::new(-2.5, -3.5, -1.5).normalize();
    let right = DVec3::Z.cross(ahead).normalize();
    assert_near(basis.u, [right.x, right.y, -right.z]);
    assert_eq!(notes.len(), 2, "{notes:?}");
    assert_eq!(read("pbrt", text).unwrap().spheres[0].shape.center, DVec3::new(1.0, 2.0, -3.0));

    let matrix = "Transform [ -1 0 0 0  0 1 0 0  0 0 -1 0  0 0 5 1 ]\n\
                  Camera \"perspective\" \"float fov\" [ 60 ] \"float screenwindow\" [ -2 2 -1 1 ]\n\
                  Film \"rgb\" \"integer xresolution\" 20 \"integer yresolution\" 10\n";
    let (camera, basis, notes) = basis_of("pbrt", matrix);
    assert_eq!(camera.eye, DVec3::new(0.0, 0.0, -5.0));
    assert_near(basis.w, [0.0, 0.0, -1.0]);
    assert_near(basis.u, [-1.0, 0.0, 0.0]);
    let viewport = camera.viewport;
    assert!((viewport.width / viewport.height - 2.0).abs() < 1e-14);
    assert!((viewport.vertical_fov().to_degrees() - 60.0).abs() < 1e-12);
    assert!(notes[0].starts_with("its world is left-handed"), "{notes:?}");
}

#[test]
fn mitsuba_by_steps_and_by_the_smaller_side() {
    let text = "<?xml version=\"1.0\"?>\n<scene version=\"3.0.0\"><sensor type=\"perspective\">\
                <float name=\"fov\" value=\"40\"/><string name=\"fov_axis\" value=\"smaller\"/>\
                <transform name=\"to_world\"><rotate y=\"1\" angle=\"180\"/>\
                <translate value=\"1, 2, 3\"/></transform></sensor>\
                <shape type=\"sphere\"><transform name=\"to_world\"><scale value=\"2\"/>\
                <translate x=\"4\"/></transform></shape><shape type=\"obj\"/></scene>";
    let (camera, basis, notes) = basis_of("mitsuba", text);
    assert_eq!(camera.eye, DVec3::new(1.0, 2.0, 3.0));
    // Mitsuba's camera looks along its +z, with +x to the left.
    assert_near(basis.u, [1.0, 0.0, 0.0]);
    assert_near(basis.w, [0.0, 0.0, 1.0]);
    assert_eq!((camera.image.width(), camera.image.height()), (768, 576));
    assert!((camera.viewport.vertical_fov().to_degrees() - 40.0).abs() < 1e-12);
    assert_eq!(notes, ["1 of obj left out: Pinhole has spheres and planes"]);
    let sphere = read("mitsuba", text).unwrap().spheres[0].shape;
    assert_eq!((sphere.center, sphere.radius), (DVec3::new(4.0, 0.0, 0.0), 2.0));
}

#[test]
fn gltf_by_rotation_in_a_parent() {
    let text = r#"{"asset": {"version": "2.0"}, "cameras": [{"type": "perspective",
        "perspective": {"yfov": 1.0, "znear": 0.1, "aspectRatio": 2}}],
        "nodes": [{"children": [1], "translation": [1, 0, 0]},
        {"camera": 0, "translation": [0, 2, 0], "scale": [3, 3, 3],
         "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]}]}"#;
    let (camera, basis, notes) = basis_of("gltf", text);
    assert_eq!(camera.eye, DVec3::new(1.0, 2.0, 0.0));
    assert_near(basis.w, [1.0, 0.0, 0.0]);
    assert_eq!((camera.image.width(), camera.image.height()), (800, 400));
    assert_eq!(notes, ["glTF does not say how many pixels there are: 800 × 400 taken"]);
}

#[test]
fn colmap_with_several_images_and_distortion() {
    let text = "# Camera list\n1 SIMPLE_RADIAL 3072 2304 2559.69 1536 1152 -0.0218531\n# Image list\n\
                1 0.851773 0.0165051 0.503764 -0.142941 -0.737434 1.02973 3.74354 1 P1180141.JPG\n\
                2362.39 248.498 58396 1784.7 268.254 59027 1784.7 268.254 -1\n\
                2 0.851773 0.0165051 0.503764 -0.142941 -0.737434 1.02973 3.74354 1 P1180142.JPG\n\
                1190.83 663.957 23056 1258.77 640.354 59070\n";
    let (camera, _, notes) = basis_of("colmap", text);
    assert_eq!((camera.image.width(), camera.image.height()), (3072, 2304));
    let distance_to_origin = camera.eye.length();
    let t = DVec3::new(-0.737434, 1.02973, 3.74354).length();
    assert!((distance_to_origin - t).abs() < 1e-12);
    assert_eq!(
        notes,
        [
            "P1180141.JPG is taken; 1 more images are left out",
            "the distortion is left out: a pinhole draws straight lines straight"
        ]
    );
}
