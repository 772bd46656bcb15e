//! The formats of other programs: their conventions, and the values for templates that only one format
//! has. The templates are in the folder `templates`.

use pinhole_core::{DVec3, Object};

use super::gltf;
use crate::format::{Axis, Conventions, ExportScene, Format, LeftOut};
use crate::format::{ExtraValues, PixelConvention};
use crate::template::{TemplateValue, commas, n, quotable};

/// All formats in which a camera can be written.
pub static FORMATS: [Format; 10] =
    [gltf::FORMAT, THREE, MITSUBA, POVRAY, BLENDER, WEEKEND, OPENGL, COURSE, OPENCV, PBRT];

/// POV-Ray 3.7: `camera` with location, right, up and direction, which can express every property
/// of Pinhole's camera.
///
/// The ray through the middle of a pixel is `direction + x right + y up` with x and y from -1/2 to 1/2
/// (POV-Ray's reference, *Camera*), so right is `width * U`, up is `height * V` and direction is
/// `-distance * W`. POV-Ray's world is left-handed by convention only: the vector right determines in which
/// direction the columns of the picture run.
const POVRAY: Format = Format {
    name: "povray",
    label: "POV-Ray",
    short: "POV-Ray",
    file: "scene.pov",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::V, Axis::MINUS_W],
        given_by: "location, right = width u, up = height v, direction = −distance w",
        pixels: PixelConvention::Corner,
        view: "length of right and up against that of direction",
        field: "{width}, {height} : {distance}",
        distance: "length of direction",
        shape: "any: right and up need not go with +W and +H",
    }),
    template: include_str!("../templates/povray.txt"),
    ..Format::PLAIN
};

/// pbrt-v4: `LookAt` and `Camera "perspective"` in a left-handed camera space.
///
/// In pbrt's `LookAt`, `up x view` points to the right; in a right-handed world, it points to the left.
/// A preceding `Scale -1 1 1` flips the picture back (Pharr, Jakob, Humphreys, *Physically Based
/// Rendering*, 4th ed., sections 3.9.5 and 5.1). `fov` is the angle of the image's shorter side.
/// `frameaspectratio` is width / height, even if pixels are not square.
const PBRT: Format = Format {
    name: "pbrt",
    label: "pbrt-v4",
    short: "pbrt",
    file: "scene.pbrt",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::V, Axis::MINUS_W],
        given_by: "LookAt eye at up, after Scale −1 1 1",
        pixels: PixelConvention::Corner,
        view: "fov: of the shorter side, in degrees",
        field: "{shorter_degrees}",
        distance: "focaldistance, which a pinhole's rays do not depend on",
        shape: "any: frameaspectratio is width / height",
    }),
    template: include_str!("../templates/pbrt.txt"),
    left_out: LeftOut::Squares,
    extra: frame_aspect,
};

fn frame_aspect(subject: &ExportScene, _: &mut Vec<String>) -> Result<ExtraValues, String> {
    let viewport = subject.resolve().viewport();
    let aspect = n(viewport.width / viewport.height);
    let line = match subject.pixel_shape() == 1.0 {
        true => String::new(),
        false => format!("\n    \"float frameaspectratio\" [ {aspect} ]"),
    };
    Ok(vec![("frame_aspect", line.into())])
}

/// Mitsuba 3's XML: a `perspective` sensor, in whose coordinates x points to the *left*, y up and z
/// forwards.
const MITSUBA: Format = Format {
    name: "mitsuba",
    label: "Mitsuba 3",
    short: "Mitsuba",
    file: "scene.xml",
    conventions: Some(Conventions {
        axes: [Axis::MINUS_U, Axis::V, Axis::MINUS_W],
        given_by: "lookat: origin, target, up",
        pixels: PixelConvention::Corner,
        view: "fov: in degrees, along fov_axis (x: horizontal)",
        field: "{horizontal_degrees}",
        distance: "none: near_clip and far_clip cut, and change no ray",
        shape: "square only",
    }),
    template: include_str!("../templates/mitsuba.txt"),
    left_out: LeftOut::Squares,
    ..Format::PLAIN
};

/// Blender's Python: a camera object with `matrix_world`, whose camera looks along its own -z with y
/// up. World coordinates are exported unchanged: that z is up is a convention of Blender's views, not
/// of its cameras.
const BLENDER: Format = Format {
    name: "blender",
    label: "Blender Python",
    short: "Blender",
    file: "scene.py",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "matrix_world: u, v, w, eye as columns",
        pixels: PixelConvention::Corner,
        view: "angle_x: horizontal, in radians, with sensor_fit HORIZONTAL",
        field: "{horizontal_radians}",
        distance: "none: clip_start and clip_end cut, and change no ray",
        shape: "any: pixel_aspect_x and pixel_aspect_y",
    }),
    template: include_str!("../templates/blender.txt"),
    left_out: LeftOut::Squares,
    extra: pixel_aspect,
};

/// Returns Blender's two numbers for the aspect ratio of a pixel, along x and y, each of which must be
/// at least 1.
fn pixel_aspect(subject: &ExportScene, _: &mut Vec<String>) -> Result<ExtraValues, String> {
    let shape = subject.pixel_shape();
    let (x, y) = if shape >= 1.0 { (shape, 1.0) } else { (1.0, 1.0 / shape) };
    if x.max(y) > 200.0 {
        return Err(format!(
            "pixels are {} times as wide as high: Blender's pixel aspect goes to 200",
            n(shape)
        ));
    }
    Ok(vec![("pixel_aspect_x", x.into()), ("pixel_aspect_y", y.into())])
}

/// *Ray Tracing in One Weekend* (P. Shirley, T. D. Black, S. Hollasch, version 4): the lines of code
/// that set up its `camera`.
const WEEKEND: Format = Format {
    name: "weekend",
    label: "Ray Tracing in One Weekend",
    short: "One Weekend",
    file: "main.cc",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "lookfrom, lookat, vup",
        pixels: PixelConvention::ColumnFirst,
        view: "vfov: vertical, in degrees",
        field: "{vertical_degrees}",
        distance: "focus_dist: the viewport is there, t = 1 too",
        shape: "square only; image_height = int(image_width / aspect_ratio)",
    }),
    template: include_str!("../templates/weekend.txt"),
    left_out: LeftOut::Planes("the book's first volume has spheres only"),
    extra: aspect_ratio,
};

/// Returns an aspect ratio for which `int(image_width / aspect_ratio)` is exactly the image's height.
fn aspect_ratio(subject: &ExportScene, _: &mut Vec<String>) -> Result<ExtraValues, String> {
    let image = subject.resolve().image();
    let (w, h) = (f64::from(image.width()), f64::from(image.height()));
    let ratio = match (w / (w / h)) as u32 == image.height() {
        true => format!("{w:?} / {h:?}"),
        // The quotient was rounded up, so that a row would be lost. The next smaller number avoids
        // this.
        false => format!("{:?}", (w / h).next_down()),
    };
    Ok(vec![("aspect_ratio", ratio.into())])
}

/// The camera of the lecture's own Julia code, a call `PerspectiveCamera(eye, view, up, focal, H, W)`.
/// Its viewport is 1 wide and H / W high.
const COURSE: Format = Format {
    name: "course",
    label: "PerspectiveCamera of the course",
    short: "Course",
    file: "camera.jl",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, view, up",
        pixels: PixelConvention::FromOne,
        view: "focal: distance / width",
        field: "{focal}",
        distance: "focal; the viewport is 1 wide",
        shape: "square only: the viewport is H / W high",
    }),
    template: include_str!("../templates/course.txt"),
    left_out: LeftOut::Objects("the call makes a camera only"),
    extra: |subject, notes| {
        let scale = n(subject.resolve().viewport().width);
        if scale != "1" {
            notes.push(format!(
                "the course's viewport is 1 wide, this one {scale}: the same rays, and every t is \
                 {scale} times as large there"
            ));
        }
        Ok(Vec::new())
    },
};

/// `gluLookAt` and `gluPerspective`, or GLM's `lookAt` and `perspective`, which take the same numbers.
const OPENGL: Format = Format {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    short: "gluLookAt",
    file: "camera.c",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, center (our at), up",
        pixels: PixelConvention::FromBottom,
        view: "fovy: vertical, in degrees, and aspect = width / height",
        field: "{vertical_degrees}",
        distance: "none: zNear and zFar cut, and change no ray",
        shape: "any: aspect need not be that of glViewport",
    }),
    template: include_str!("../templates/opengl.txt"),
    left_out: LeftOut::Objects("OpenGL has triangles only"),
    extra: |subject, notes| {
        let (near, far) = subject.clip();
        notes.push(format!(
            "zNear {} and zFar {} are chosen: OpenGL cuts off what is nearer or farther",
            n(near),
            n(far)
        ));
        Ok(Vec::new())
    },
};

/// OpenCV's intrinsic matrix K and pose R, t, as JSON. They map a point q of the world to the pixel
/// coordinates (x, y):
///
/// ```text
/// s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
/// R = (u, -v, -w) as rows          t = -R eye
/// ```
const OPENCV: Format = Format {
    name: "opencv",
    label: "OpenCV K [R|t]",
    short: "OpenCV",
    file: "camera.json",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::MINUS_V, Axis::MINUS_W],
        given_by: "R from world to camera, t = −R eye",
        pixels: PixelConvention::AtCentre,
        view: "fx, fy: distance / pixel's width and height, in pixels",
        field: "{fx}, {fy}",
        distance: "none: K knows pixels only",
        shape: "any: fx and fy differ",
    }),
    template: include_str!("../templates/opencv.txt"),
    left_out: LeftOut::Objects("K and [R|t] are a camera only"),
    ..Format::PLAIN
};

/// three.js's JSON Object/Scene format 4, which `Object3D.toJSON` writes and `ObjectLoader` reads.
/// Cameras look along their own -z with y up. Matrices are column-major.
const THREE: Format = Format {
    name: "three",
    label: "three.js",
    short: "three.js",
    file: "scene.json",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "the object's matrix: u, v, w, eye as columns",
        pixels: PixelConvention::Device,
        view: "fov: vertical, in degrees, and aspect = width / height",
        field: "{vertical_degrees}",
        distance: "none: near and far cut, and change no ray",
        shape: "any: aspect need not be the canvas's",
    }),
    template: include_str!("../templates/three.txt"),
    left_out: LeftOut::Squares,
    extra: stand_ins,
};

/// Returns the template's values for the objects: the meshes that represent them in three.js, with
/// their geometries and materials.
fn stand_ins(subject: &ExportScene, _: &mut Vec<String>) -> Result<ExtraValues, String> {
    let uuid = |k: usize| format!("00000000-0000-4000-8000-{k:012x}");
    let matrix = |[a, b, c, at]: [DVec3; 4]| {
        format!("{}, 0, {}, 0, {}, 0, {}, 1", commas(a), commas(b), commas(c), commas(at))
    };
    let [mut geometries, mut materials, mut meshes] = [const { Vec::new() }; 3];
    for (k, object) in (10..).step_by(3).zip(&subject.objects) {
        let (mesh, shape, material) = (uuid(k), uuid(k + 1), uuid(k + 2));
        let (geometry, matrix) = match &object.shape {
            Object::Sphere(sphere) => {
                let radius = n(sphere.radius);
                let geometry = format!(
                    "\"SphereGeometry\", \"radius\": {radius}, \"widthSegments\": 64, \
                     \"heightSegments\": 32"
                );
                (geometry, matrix([DVec3::X, DVec3::Y, DVec3::Z, sphere.center]))
            }
            Object::Plane(plane) => {
                let (middle, half, [a, b]) = subject.square_of(plane);
                let side = n(2.0 * half);
                let geometry = format!("\"PlaneGeometry\", \"width\": {side}, \"height\": {side}");
                (geometry, matrix([a, b, a.cross(b), middle]))
            }
        };
        geometries.push(format!("{{ \"uuid\": \"{shape}\", \"type\": {geometry} }}"));
        let [r, g, b] = object.color.map(u32::from);
        materials.push(format!(
            "{{ \"uuid\": \"{material}\", \"type\": \"MeshBasicMaterial\", \"color\": {}, \"side\": 2 }}",
            r << 16 | g << 8 | b
        ));
        meshes.push(format!(
            ", {{ \"uuid\": \"{mesh}\", \"type\": \"Mesh\", \"name\": \"{}\", \"geometry\": \"{shape}\", \
             \"material\": \"{material}\", \"matrix\": [{matrix}] }}",
            quotable(&object.title)
        ));
    }
    let list = |name: &str, items: Vec<String>| match items.is_empty() {
        true => String::new(),
        false => format!("  \"{name}\": [\n    {}\n  ],\n", items.join(",\n    ")),
    };
    Ok(vec![
        ("geometries", list("geometries", geometries).into()),
        ("materials", list("materials", materials).into()),
        ("meshes", TemplateValue::Text(meshes.concat())),
    ])
}
