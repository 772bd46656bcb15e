//! Names in the place of numbers: read where a name has one value, refused where it has not.

use pinhole_core::{DVec3, Orientation};

use super::read;

#[track_caller]
fn assert_refused(format: &str, text: &str, message: &str) {
    assert_eq!(read(format, text).unwrap_err().to_string(), message, "{text}");
}

#[test]
fn a_name_that_has_one_value_is_that_value() {
    let course = "eye = Vec3(1, 2, 3)\nview = Vec3(0.0, 0.0, -1.0)\nup = Vec3(0, 1, 0)\nH, W = 300, 400\n\
                  focal = 2 * half\nhalf = 0.75\ncam = PerspectiveCamera(eye, view, up, focal, H, W)\n";
    let camera = read("course", course).unwrap().camera;
    assert_eq!((camera.eye, camera.viewport.distance), (DVec3::new(1.0, 2.0, 3.0), 1.5));
    assert_eq!((camera.image.width(), camera.image.height()), (400, 300));

    // The manual's first page.
    let three = "const fov = 75;\nconst aspect = 2; // the canvas default\nconst near = 0.1;\n\
                 const far = 5;\nconst camera = new THREE.PerspectiveCamera(fov, aspect, near, far);\n\
                 camera.position.z = 2;\n";
    let camera = read("three", three).unwrap().camera;
    assert!((camera.viewport.vertical_fov().to_degrees() - 75.0).abs() < 1e-12);
    assert!((camera.viewport.width / camera.viewport.height - 2.0).abs() < 1e-15);

    let glm = "const unsigned int SCR_WIDTH = 800;\n#define SCR_HEIGHT 600\n\
               glm::vec3 cameraPos   = glm::vec3(0.0f, 0.0f, 3.0f);\nglm::vec3 target(0.0f, 1.0f, 0.0f);\n\
               auto view = glm::lookAt(cameraPos, target, glm::vec3(0.0f, 1.0f, 0.0f));\n\
               auto projection = glm::perspective(glm::radians(45.0f), (float)SCR_WIDTH / \
               (float)SCR_HEIGHT, 0.1f, 100.0f);\n";
    let camera = read("opengl", glm).unwrap().camera;
    assert_eq!(camera.eye, DVec3::new(0.0, 0.0, 3.0));
    assert!(matches!(camera.orientation, Orientation::At { at, .. } if at == DVec3::Y));
    assert!((camera.viewport.width / camera.viewport.height - 4.0 / 3.0).abs() < 1e-15);
}

#[test]
fn several_names_of_one_statement_have_their_values() {
    let glu = "double eyeX = 4.0, eyeY = 3.0, eyeZ = 2.0;\nconst int W = 800, H = 600;\n\
               gluPerspective(45.0, (double)W / H, 0.1, 100.0);\n\
               gluLookAt(eyeX, eyeY, eyeZ, 0, 0, 0, 0, 1, 0);\n";
    let camera = read("opengl", glu).unwrap().camera;
    assert_eq!(camera.eye, DVec3::new(4.0, 3.0, 2.0));
    assert!((camera.viewport.width / camera.viewport.height - 4.0 / 3.0).abs() < 1e-15);
    for made in [
        "const fov = 40, aspect = 2, near = 0.1, far = 100;\nconst WIDTH = 800, HEIGHT = 400;\n",
        "const fov = 40,\n      aspect = 2,\n      near = 0.1;\nlet WIDTH = 800,\n  HEIGHT = 400;\n",
    ] {
        let text = format!(
            "{made}const camera = new THREE.PerspectiveCamera(fov, aspect);\n\
             renderer.setSize(WIDTH, HEIGHT);\n"
        );
        let camera = read("three", &text).unwrap().camera;
        assert!((camera.viewport.vertical_fov().to_degrees() - 40.0).abs() < 1e-12, "{made}");
        assert_eq!((camera.image.width(), camera.image.height()), (800, 400), "{made}");
    }
    let chain = "fx = fy = 2.5\nPerspectiveCamera((0, 0, 0), (0, 0, -1), (0, 1, 0), fy, 4, 4)";
    for name in ["fx", "fy"] {
        let camera = read("course", &chain.replace("fy, 4", &format!("{name}, 4"))).unwrap().camera;
        assert_eq!(camera.viewport.distance, 2.5);
    }
    let class = "class Stage {\n  private fov = 40;\n  private width = 1280;\n  height = 640;\n\
                 \x20 start() {\n    this.camera = new THREE.PerspectiveCamera(this.fov, 2);\n\
                 \x20   this.renderer.setSize(this.width, this.height);\n  }\n}\n";
    let camera = read("three", class).unwrap().camera;
    assert_eq!((camera.image.width(), camera.image.height()), (1280, 640));
    assert!((camera.viewport.vertical_fov().to_degrees() - 40.0).abs() < 1e-12);
    let local = "function f() {\n  const fov = 40;\n}\nnew THREE.PerspectiveCamera(this.fov, 2);\n";
    assert_refused("three", local, "in:4:29: fov is this.fov: it must be a finite number");
}

#[test]
fn one_number_fills_a_vector_of_glm() {
    let text = "glm::mat4 p = glm::perspective(glm::radians(45.0f), 4.0f/3.0f, 0.1f, 100.0f);\n\
                glm::mat4 v = glm::lookAt(glm::vec3(4,3,3), glm::vec3(1.0f), glm::vec3(0,1,0));\n";
    let camera = read("opengl", text).unwrap().camera;
    assert!(matches!(camera.orientation, Orientation::At { at, .. } if at == DVec3::ONE));
    let three = "const camera = new THREE.PerspectiveCamera(40, 2);\ncamera.position.set(0, 1, 2);\n\
                 camera.lookAt(new THREE.Vector3());\n";
    let camera = read("three", three).unwrap().camera;
    assert!(matches!(camera.orientation, Orientation::At { at, .. } if at == DVec3::ZERO));
}

#[test]
fn a_name_that_has_not_one_value_is_refused() {
    let course = |before: &str| {
        format!("{before}PerspectiveCamera((0, 0, 0), (0, 0, -1), (0, 1, 0), focal, 4, 4)")
    };
    let right = "it is given more than once, or changed: here it must be numbers";
    for before in [
        "focal = 1\nfocal = 2\n",
        "focal = 1\nfocal += 1\n",
        "focal = 1\nfocal, rest = read()\n",
        "focal = 1\nif true\n  focal = 2\nend\n",
    ] {
        let line = before.lines().count() + 1;
        let message = format!("in:{line}:53: focal is focal: {right}");
        assert_refused("course", &course(before), &message);
    }
    for before in [
        "",
        "f(focal = 1)\n",
        "focal == 1\n",
        "focal = focal\n",
        "focal = a\na = b\nb = focal\n",
        "other.focal = 3\n",
        "for focal in 1:3 end\n",
        "focal = f(3)\n",
        "f(a = 1, focal = 3)\n",
        "f(a = focal = 3)\n",
    ] {
        let line = before.lines().count() + 1;
        let message = format!("in:{line}:53: focal is focal: it must be a finite number");
        assert_refused("course", &course(before), &message);
    }
    let vector =
        "eye = [1, 2, 3]\neye[3] = 0\nPerspectiveCamera(eye, (0, 0, -1), (0, 1, 0), 1, 4, 4)";
    assert_refused("course", vector, &format!("in:3:19: eye is eye: {right}"));
}

/// Names made of names made of names, twice each: to be worked out once each.
#[test]
fn names_that_grow_end() {
    let mut text = "a0 = 1\n".to_owned();
    for k in 1..5000 {
        text += &format!("a{k} = a{} + a{}\n", k - 1, k - 1);
    }
    for k in [10, 4999] {
        let call = format!("PerspectiveCamera((0, 0, 0), (0, 0, -1), (0, 1, 0), a{k}, 4, 4)");
        let taken = read("course", &format!("{text}{call}"));
        assert_eq!(taken.is_ok(), k == 10);
        if let Ok(taken) = taken {
            assert_eq!(taken.camera.viewport.distance, 1024.0);
        }
    }
}
