//! Libraries: OpenGL's GLU and GLM, three.js and OpenCV.

use pinhole_core::{Intrinsics, Sphere, Viewport};

use crate::format::{Axis, Conventions, Format, PixelConvention};
use crate::format::{ExportScene, Unsupported, square_note};
use crate::format::{commas, commas_of, flipped, n, quotable, real};
use crate::programs::gltf::columns;

/// `gluLookAt` and `gluPerspective`, and GLM's `lookAt` and `perspective`, which take the same numbers.
pub(super) const OPENGL: Format = Format {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    short: "gluLookAt",
    file: "camera.c",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, center (our at), up",
        pixels: PixelConvention::FromBottom,
        view: "fovy: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: zNear and zFar cut, and change no ray",
        shape: "any: aspect need not be that of glViewport",
        lengths: "f64; GLM often f32",
    }),
    write: opengl,
};

fn opengl(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [eye, at, up] = subject.look_at()?;
    let [width, height] = subject.size();
    let (near, far) = subject.clip();
    let viewport = subject.viewport();
    let text = format!(
        "glViewport(0, 0, {width}, {height});\n\
         glMatrixMode(GL_PROJECTION);\n\
         glLoadIdentity();\n\
         gluPerspective({}, {}, {}, {});\n\
         glMatrixMode(GL_MODELVIEW);\n\
         glLoadIdentity();\n\
         gluLookAt({},\n          {},\n          {});\n",
        real(subject.vertical_degrees()),
        real(viewport.width / viewport.height),
        real(near),
        real(far),
        commas(eye),
        commas(at),
        commas(up),
    );
    notes.push(format!(
        "zNear {} and zFar {} are chosen: OpenGL cuts off what is nearer or farther",
        n(near),
        n(far)
    ));
    notes.extend(subject.objects_left_out("OpenGL has triangles only"));
    Ok(text)
}

/// three.js's JSON Object/Scene format 4, which `Object3D.toJSON` writes and `ObjectLoader` reads. Cameras look
/// along their own -z with y up; matrices are column-major.
pub(super) const THREE: Format = Format {
    name: "three",
    label: "three.js",
    short: "three.js",
    file: "scene.json",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "the object's matrix: u, v, w, eye as columns",
        pixels: PixelConvention::Device,
        view: "fov: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: near and far cut, and change no ray",
        shape: "any: aspect need not be the canvas's",
        lengths: "f64, f32 when drawn",
    }),
    write: three,
};

fn three(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [width, height] = subject.size();
    let Viewport { width: across, height: up, distance } = *subject.viewport();
    let (near, far) = subject.clip();
    let mut children = vec![format!(
        "{{\n      \"uuid\": \"{}\",\n      \"type\": \"PerspectiveCamera\",\n      \
         \"name\": \"camera\",\n      \"fov\": {},\n      \"aspect\": {},\n      \"near\": {},\n      \
         \"far\": {},\n      \"matrix\": [\n        {}\n      ],\n      \
         \"userData\": {{ \"imageWidth\": {width}, \"imageHeight\": {height}, \"distance\": {} }}\n    }}",
        uuid(1),
        n(subject.vertical_degrees()),
        n(across / up),
        n(near),
        n(far),
        columns(subject),
        n(distance)
    )];
    let StandIns { geometries, materials, meshes } = stand_ins(subject, notes);
    children.extend(meshes);
    let list = |name: &str, items: Vec<String>| match items.is_empty() {
        true => String::new(),
        false => format!("  \"{name}\": [\n    {}\n  ],\n", items.join(",\n    ")),
    };
    let text = format!(
        "{{\n  \"metadata\": {{ \"version\": 4.6, \"type\": \"Object\", \"generator\": \"Pinhole\" }},\n\
         {}{}  \"object\": {{\n    \"uuid\": \"{}\",\n    \"type\": \"Scene\",\n    \
         \"matrix\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],\n    \"children\": [{}]\n  }}\n}}\n",
        list("geometries", geometries),
        list("materials", materials),
        uuid(0),
        children.join(", ")
    );
    Ok(text)
}

/// Meshes that represent the objects.
#[derive(Default)]
struct StandIns {
    geometries: Vec<String>,
    materials: Vec<String>,
    meshes: Vec<String>,
}

fn stand_ins(subject: &ExportScene, notes: &mut Vec<String>) -> StandIns {
    let mut made = StandIns::default();
    let mut add = |title: &str, color: [u8; 3], geometry: &str, matrix: String| {
        let k = 10 + 3 * made.geometries.len();
        let (own, shape, looks) = (uuid(k), uuid(k + 1), uuid(k + 2));
        made.geometries.push(format!("{{ \"uuid\": \"{shape}\", {geometry} }}"));
        let [r, g, b] = color.map(u32::from);
        made.materials.push(format!(
            "{{ \"uuid\": \"{looks}\", \"type\": \"MeshBasicMaterial\", \"color\": {}, \"side\": 2 }}",
            r << 16 | g << 8 | b
        ));
        made.meshes.push(format!(
            "{{ \"uuid\": \"{own}\", \"type\": \"Mesh\", \"name\": \"{}\", \"geometry\": \"{shape}\", \
             \"material\": \"{looks}\", \"matrix\": [{matrix}] }}",
            quotable(title)
        ));
    };
    for sphere in &subject.spheres {
        let Sphere { center, radius } = sphere.shape;
        let geometry = format!(
            "\"type\": \"SphereGeometry\", \"radius\": {}, \"widthSegments\": 64, \
             \"heightSegments\": 32",
            n(radius)
        );
        let matrix = format!("1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, {}, 1", commas(center));
        add(&sphere.title, sphere.color, &geometry, matrix);
    }
    for plane in &subject.planes {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let side = n(2.0 * half);
        let geometry =
            format!("\"type\": \"PlaneGeometry\", \"width\": {side}, \"height\": {side}");
        let (a, b, c) = (commas(a), commas(b), commas(a.cross(b)));
        let matrix = format!("{a}, 0, {b}, 0, {c}, 0, {}, 1", commas(middle));
        add(&plane.title, plane.color, &geometry, matrix);
        notes.push(square_note(&plane.title, "three.js", half));
    }
    made
}

fn uuid(k: usize) -> String {
    format!("00000000-0000-4000-8000-{k:012x}")
}

/// OpenCV's K and [R|t], as JSON.
///
/// ```text
/// s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
/// R = (u, -v, -w) as rows          t = -R eye
/// ```
pub(super) const OPENCV: Format = Format {
    name: "opencv",
    label: "OpenCV K [R|t]",
    short: "OpenCV",
    file: "camera.json",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::MINUS_V, Axis::MINUS_W],
        given_by: "R from world to camera, t = −R eye",
        pixels: PixelConvention::AtCentre,
        view: "fx, fy: distance / pixel's width and height, in pixels",
        field: |subject| {
            let Intrinsics { fx, fy, .. } = subject.intrinsics();
            format!("{}, {}", n(fx), n(fy))
        },
        distance: "none: K knows pixels only",
        shape: "any: fx and fy differ",
        lengths: "f64",
    }),
    write: opencv,
};

fn opencv(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [width, height] = subject.size();
    let Intrinsics { fx, fy, cx, cy } = subject.intrinsics();
    let basis = *subject.resolve().basis();
    let eye = basis.to_camera_from_world(subject.resolve().eye());
    let text = format!(
        "{{\n  \"image_width\": {width},\n  \"image_height\": {height},\n  \
         \"K\": [[{}, 0, {}],\n        [0, {}, {}],\n        [0, 0, 1]],\n  \
         \"R\": [[{}],\n        [{}],\n        [{}]],\n  \
         \"t\": [{}, {}, {}],\n  \"distortion\": [0, 0, 0, 0, 0]\n}}\n",
        n(fx),
        n(cx - 0.5),
        n(fy),
        n(cy - 0.5),
        commas(basis.u),
        commas_of(-basis.v, flipped),
        commas_of(-basis.w, flipped),
        n(-eye.x),
        flipped(eye.y),
        flipped(eye.z),
    );
    notes.extend(subject.objects_left_out("K and [R|t] are a camera only"));
    Ok(text)
}
