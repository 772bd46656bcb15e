//! Blender programs: the camera among other things, and what turns it.

use pinhole_core::{Basis, Camera, DVec3};

use super::read;

#[track_caller]
fn blender(text: &str) -> (Camera, Basis, Vec<String>) {
    let taken = read("blender", text).unwrap_or_else(|error| panic!("{error}: {text}"));
    (taken.camera, *taken.camera.resolve().unwrap().basis(), taken.notes)
}

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    let error = read("blender", text).unwrap_err().to_string();
    assert!(error.contains(message), "{error}: {text}");
}

const CAMERA: &str = "cam = bpy.data.objects['Camera']\ncam.location = (7, -6, 5)\n\
                      cam.rotation_euler = (0.3, 0.4, 0.5)\ncam.data.lens = 18\n";

#[test]
fn other_things_are_not_the_camera() {
    let (alone, basis, _) = blender(CAMERA);
    for more in [
        "light = bpy.data.objects['Light']\nlight.location = (4, 1, 6)\nlight.rotation_euler = (1, 1, 1)\n",
        "bpy.ops.mesh.primitive_uv_sphere_add(radius=1, location=(1, 2, 3))\n",
        "bpy.ops.mesh.primitive_cube_add(size=2, rotation=(1, 2, 3))\nbpy.context.object.location = (9, 9, 9)\n",
        "sun = bpy.data.objects['Sun']\nsun.data.angle = 0.009\nsun.data.type = 'SUN'\n",
        "def helper(obj):\n    \"\"\"\n    cam.location = (9, 9, 9)\n    \"\"\"\n",
    ] {
        for text in [format!("{CAMERA}{more}"), format!("{more}{CAMERA}")] {
            let (camera, own, _) = blender(&text);
            assert_eq!(
                (camera.eye, camera.viewport, own),
                (alone.eye, alone.viewport, basis),
                "{text}"
            );
        }
    }
}

#[test]
fn the_camera_is_found_however_it_is_made() {
    let stands = "location = (7, -6, 5)\nX.rotation_euler = (0.3, 0.4, 0.5)\n";
    let of = |name: &str| format!("{name}.{}", stands.replace('X', name));
    let (_, basis, _) = blender(CAMERA);
    for text in [
        format!("data = bpy.data.cameras.new('a')\nthing = bpy.data.objects.new('b', data)\ndata.lens = 18\n{}\
                 other = bpy.data.objects.new('c', None)\nother.location = (1, 1, 1)\n", of("thing")),
        format!("bpy.ops.object.camera_add(location=(1, 1, 1))\nc = bpy.context.active_object\n{}c.data.lens = 18\n", of("c")),
        "bpy.ops.object.camera_add(location=(7, -6, 5), rotation=(0.3, 0.4, 0.5))\n\
         bpy.context.object.data.lens = 18\nbpy.ops.object.light_add(location=(5, 5, 5))\n".to_owned(),
        format!("a = bpy.data.objects['Camera.001']\na.location = (1, 1, 1)\nb = bpy.data.objects[\"B\"]\n{}\
                 bpy.context.scene.camera = b\nb.data.lens = 18\n", of("b")),
        format!("scene = bpy.context.scene\n{}scene.camera.data.lens = 18\n", of("scene.camera")),
        ">>> C.scene.camera.location\nVector((7.0, -6.0, 5.0))\n>>> C.scene.camera.rotation_euler\n\
         Euler((0.3, 0.4, 0.5), 'XYZ')\n>>> C.scene.camera.data.lens\n>>> C.scene.camera.data.lens = 18\n".to_owned(),
    ] {
        let (camera, own, _) = blender(&text);
        assert_eq!((camera.eye, own), (DVec3::new(7.0, -6.0, 5.0), basis), "{text}");
        assert!((camera.viewport.horizontal_fov().to_degrees() - 90.0).abs() < 1e-12, "{text}");
    }
}

#[test]
fn which_is_the_camera_must_be_plain() {
    let two = "a = bpy.data.objects['A']\na.location = (1, 2, 3)\nb = bpy.data.objects['B']\nb.location = (3, 2, 1)\n";
    assert_refused(
        two,
        "the one camera is missing: bpy.data.objects['A'] or bpy.data.objects['B']: scene.camera",
    );
    assert_refused("import bpy\n", "matrix_world is missing");
    let lens = format!(
        "{}a_camera.lens = 3\nb_camera.lens = 4\n",
        CAMERA.replace("cam.data.lens = 18\n", "")
    );
    assert_refused(&lens, "the camera's lens is missing: the text gives one to several cameras");
}

#[test]
fn every_way_of_turning_is_read() {
    let turn = |more: &str| {
        let (_, basis, _) =
            blender(&format!("cam = bpy.data.objects['Camera']\ncam.location = (0, 0, 1)\n{more}"));
        basis
    };
    // About z first, then y, then x: the last turn is about the world's x.
    let basis = turn("cam.rotation_mode = 'ZYX'\ncam.rotation_euler = (0.3, 0.4, 0.5)\n");
    let order = [(DVec3::Z, 0.5), (DVec3::Y, 0.4), (DVec3::X, 0.3)];
    let by =
        |order: &[(DVec3, f64)], v: DVec3| order.iter().fold(v, |v, (axis, a)| about(*axis, *a, v));
    for (own, v) in [(basis.u, DVec3::X), (basis.v, DVec3::Y), (basis.w, DVec3::Z)] {
        assert!((own - by(&order, v)).length() < 1e-15);
    }
    for (mode, order) in [
        ("XYZ", [0, 1, 2]),
        ("XZY", [0, 2, 1]),
        ("YXZ", [1, 0, 2]),
        ("YZX", [1, 2, 0]),
        ("ZXY", [2, 0, 1]),
    ] {
        let basis = turn(&format!(
            "cam.rotation_mode = '{mode}'\ncam.rotation_euler = Euler((0.3, 0.4, 0.5), '{mode}')\n"
        ));
        let axes = [(DVec3::X, 0.3), (DVec3::Y, 0.4), (DVec3::Z, 0.5)];
        let w = by(&order.map(|k: usize| axes[k]), DVec3::Z);
        assert!((basis.w - w).length() < 1e-15, "{mode}");
    }
    let whole = turn("cam.rotation_euler = (1.1, 0, 0.4)\n");
    assert_eq!(turn("cam.rotation_euler[0] = 1.1\ncam.rotation_euler.z = 0.4\n"), whole);
    assert_eq!(turn("cam.rotation_euler = (1, 0, 0.4)\ncam.rotation_euler.x += 0.1\n"), whole);
    let quaternion =
        "cam.rotation_mode = 'QUATERNION'\ncam.rotation_quaternion = (0.5, 0.5, 0.5, 0.5)\n";
    assert!((turn(quaternion).u - DVec3::Y).length() < 1e-15);
    // Blender does not heed the quaternion then.
    let unheeded = "cam.rotation_mode = 'XYZ'\ncam.rotation_euler = (1.1, 0, 0.4)\ncam.rotation_quaternion = (0.5, 0.5, 0.5, 0.5)\n";
    assert_eq!(turn(unheeded), whole);
}

/// A vector turned about an axis of length 1.
fn about(axis: DVec3, angle: f64, v: DVec3) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    cos * v + sin * axis.cross(v) + (1.0 - cos) * axis.dot(v) * axis
}

#[test]
fn what_the_console_prints_of_a_matrix_is_read() {
    let rows = "(0.0, 0.0, 1.0, 7.0),\n        (1.0, 0.0, 0.0, -6.0),\n        (0.0, 1.0, 0.0, 5.0),\n        (0.0, 0.0, 0.0, 1.0)";
    let printed = rows.replace("),", ")");
    for text in [
        format!(">>> bpy.context.scene.camera.matrix_world\nMatrix(({rows}))\n"),
        format!(">>> C.object.matrix_world\n<Matrix 4x4 {printed}>\n"),
        format!("<Matrix 4x4 {printed}>\n"),
        format!(
            ">>> print(cam.matrix_world)\n<Matrix 4x4 {printed}>\n>>> light.location\nVector((1.0, 2.0, 3.0))\n"
        ),
    ] {
        let (camera, basis, _) = blender(&text);
        assert_eq!((camera.eye, basis.w), (DVec3::new(7.0, -6.0, 5.0), DVec3::X), "{text}");
    }
}

#[test]
fn what_moves_the_camera_and_is_not_read_is_refused() {
    for (more, message) in [
        (
            "cam.rotation_mode = 'AXIS_ANGLE'\n",
            "in:5:21: rotation_mode is 'AXIS_ANGLE': it must be QUATERNION, or one of",
        ),
        ("cam.data.type = 'ORTHO'\n", "in:5:17: the camera's type is 'ORTHO': it must be PERSP"),
        (
            "bpy.context.scene.camera = cam\nbpy.context.scene.camera.data.type = 'PANO'\n",
            "the camera's type is 'PANO'",
        ),
        ("c = cam.constraints.new(type='TRACK_TO')\n", "this moves or turns the camera"),
        ("cam.parent = empty\n", "parent is empty: this moves or turns the camera"),
        ("for k in range(9):\n    cam.location.x += 1\n", "location.x is 1: it is done in a loop"),
        ("if top:\n    cam.location = (0, 0, 9)\n", "it is given in an if, and more than once"),
        (
            "cam.location = target.location\n",
            "location is target.location: it must be a finite number",
        ),
        ("cam.rotation_euler.rotate_axis('X', 1)\n", "rotation_euler.rotate_axis"),
        (
            "cam.rotation_euler = Euler((0, 0, 1), 'ZYX')\n",
            "Euler's order is 'ZYX': it must be the order of rotation_mode, XYZ",
        ),
        ("cam.data.lens = 0\n", "lens is 0: it must be greater than 0"),
    ] {
        assert_refused(&format!("{CAMERA}{more}"), message);
    }
}

/// What is taken is told: of a camera that the text does not make, little is known.
#[test]
fn what_is_not_in_the_text_is_told() {
    let (_, _, notes) = blender("cam = bpy.data.objects['Camera']\ncam.location.z = 5\n");
    assert_eq!(
        notes[1..],
        [
            "the text does not say the lens: 50 mm taken",
            "location.x, y is not in the text: 0 taken",
            "rotation_euler is not in the text: (0, 0, 0) taken"
        ]
    );
}

/// Blender makes a focal length of an angle, by the side of the sensor that it is of.
#[test]
fn an_angle_is_of_its_side_of_the_sensor() {
    let (camera, _, _) = blender(&format!("{CAMERA}cam.data.angle_y = 1.0\n"));
    let length = 12.0 / 0.5_f64.tan();
    assert!((camera.viewport.width - 36.0 / length).abs() < 1e-12, "{:?}", camera.viewport);
}

/// A function may move what it is given: only one that is seen to read it is let be.
#[test]
fn a_camera_that_is_handed_to_a_function_is_refused() {
    let aim = "def point_at(obj, target):\n    obj.rotation_euler = (Vector(target) - obj.location)\
               .to_track_quat('-Z', 'Y').to_euler()\n";
    let up = "def move_up(o):\n    o.location.z += 3\n\n";
    for (more, message) in [
        (
            format!("{aim}point_at(cam, (0, 0, 0))\n"),
            "the call is point_at(cam, (0, 0, 0)): it may",
        ),
        (format!("{up}move_up(cam)\n"), "in:8:1: the call is move_up(cam): it may move or turn"),
        (format!("{up}move_up(o=cam)\n"), "the call is move_up(o=cam)"),
        (format!("{up}x = [move_up(o) for o in f([cam])]\n"), "the call is f([cam])"),
        ("shake(cam.location, 2)\n".to_owned(), "the call is shake(cam.location, 2)"),
        ("tools.aim(bpy.data.objects[\"Camera\"])\n".to_owned(), "the call is tools.aim"),
        ("wide(cam.data)\n".to_owned(), "the call is wide(cam.data): it may change the lens"),
        ("setattr(cam, 'location', (1, 2, 3))\n".to_owned(), "the call is setattr(cam"),
        ("def f(o):\n  p = o\n  p.location.x = 9\nf(cam)\n".to_owned(), "the call is f(cam)"),
    ] {
        assert_refused(&format!("{CAMERA}{more}"), message);
    }
    let (alone, _, _) = blender(CAMERA);
    for more in [
        "bpy.context.scene.collection.objects.link(cam)\n",
        "bpy.context.view_layer.objects.active = cam\ncam.select_set(True)\n",
        "print(cam, cam.location, 'move(cam)', len(cam.name))\n",
        "def tell(o, k):\n    print(o.name, o.location.x)\n\ntell(cam, 2)\n",
        "def place(o, c):\n    o.location = (1, 2, 3)\n    x = c.location.x + 1\nplace(light, cam)\n",
        "way = (Vector((0, 0, 0)) - cam.location).length\n",
    ] {
        assert_eq!(blender(&format!("{CAMERA}{more}")).0, alone, "{more}");
    }
}

#[test]
fn a_camera_that_moves_with_the_frames_is_refused() {
    for (more, message) in [
        (
            "cam.keyframe_insert(data_path=\"location\", frame=1)\n",
            "in:5:1: the camera's motion is cam.keyframe_insert(data_path=\"location\", frame=1)",
        ),
        ("cam.driver_add('location', 2)\n", "the camera's motion is cam.driver_add('location', 2)"),
        ("cam.data.keyframe_insert('lens')\n", "the lens's motion is cam.data.keyframe_insert"),
    ] {
        assert_refused(&format!("{CAMERA}{more}"), message);
    }
}

#[test]
fn the_resolution_is_read_however_the_scene_is_called() {
    let size = |more: &str| {
        let (camera, _, notes) = blender(&format!("{CAMERA}{more}"));
        ((camera.image.width(), camera.image.height()), notes)
    };
    for more in [
        "bpy.data.scenes['Scene'].render.resolution_x = 640\n\
         bpy.data.scenes[\"Scene\"].render.resolution_y = 480\n",
        "scene.render.resolution_x, scene.render.resolution_y = 640, 480\n",
        "render = bpy.context.scene.render\nrender.resolution_x = 640\nrender.resolution_y = 480\n",
        "resolution_x = 640\nr.resolution_x = resolution_x\nr.resolution_y = 480\n",
    ] {
        let (size, notes) = size(more);
        assert_eq!(size, (640, 480), "{more}");
        assert!(notes.iter().all(|note| !note.contains("resolution")), "{notes:?}");
    }
    assert!(size("").1[0].starts_with("the text does not say the resolution: "));
    let named = "setattr(scene.render, 'resolution_x', 9)\n";
    assert!(size(named).1[0].starts_with("the text gives the resolution no number: "));
    let one = "scene.render.resolution_x = 640\n";
    assert_refused(&format!("{CAMERA}{one}"), "resolution_y is missing: it must be given as");
    let perhaps =
        format!("{one}scene.render.resolution_y = 480\nif fast:\n    {}", one.replace('6', "1"));
    assert_refused(&format!("{CAMERA}{perhaps}"), "resolution_x is 140: it is given in an if");
}

/// Blender's own idiom for a camera that looks at a point: y as near to the world's z as can be.
#[test]
fn a_camera_that_is_aimed_is_read() {
    let made = "data = bpy.data.cameras.new('a')\ncam = bpy.data.objects.new('b', data)\n\
                cam.location = (3, -6, 4)\n";
    let way = DVec3::new(-3.0, 6.0, -4.0).normalize();
    for aim in [
        "cam.rotation_euler = (Vector((0, 0, 0)) - cam.location).to_track_quat('-Z', 'Y').to_euler()\n",
        "cam.rotation_euler = (cam.location - Vector((0, 0, 0))).to_track_quat('Z', 'Y').to_euler()\n",
        "target = Vector((0, 0, 0))\ndirection = target - cam.location\n\
         rot_quat = direction.to_track_quat(\"-Z\", \"Y\")\ncam.rotation_euler = rot_quat.to_euler()\n",
        "cam.rotation_mode = 'QUATERNION'\n\
         cam.rotation_quaternion = (Vector((0, 0, 0)) - cam.location).to_track_quat('-Z', 'Y')\n",
    ] {
        let (_, basis, _) = blender(&format!("{made}{aim}bpy.context.scene.camera = cam\n"));
        assert!((basis.w + way).length() < 1e-15, "{basis:?}: {aim}");
        assert!(basis.u.z.abs() < 1e-15 && basis.v.z > 0.0, "{basis:?}: {aim}");
    }
    let aim = "cam.rotation_euler = (Vector((0, 0, 0)) - cam.location).to_track_quat('-Z', 'Y').to_euler()\n";
    for (text, message) in [
        (aim.replace("Vector((0, 0, 0))", "cube.location"), "the target is cube.location"),
        (aim.replace("- cam", "- cube"), "it must be a point less the camera's location"),
        (aim.replace("'-Z', 'Y'", "'X', 'Z'"), "it must be to_track_quat('-Z', 'Y')"),
        (aim.replace("(0, 0, 0)", "(3, -6, 9)"), "nor straight up or down"),
        (format!("{aim}cam.location.x = 1\n"), "location is 1: the camera is aimed before"),
        (format!("{aim}cam.rotation_mode = 'ZYX'\n"), "it must stand before the camera is aimed"),
        (format!("{aim}cam.rotation_euler.z += 1\n"), "the camera is turned by a matrix already"),
        (
            "way = Vector((0, 0, 0)) - cam.location\ncam.location = (1, 2, 3)\n\
             cam.rotation_euler = way.to_track_quat('-Z', 'Y').to_euler()\n"
                .to_owned(),
            "the camera's location must be given before it is aimed from there",
        ),
    ] {
        assert_refused(&format!("{made}{text}"), message);
    }
}
