//! three.js's JSON Object/Scene format 4: what `Object3D.toJSON` writes and `ObjectLoader` reads. Cameras
//! look along their own -z with y up; matrices are column after column.

use pinhole_core::{Sphere, Viewport};

use super::gltf::columns;
use crate::format::text::{commas, n, quotable};
use crate::format::{Conventions, ExportScene, Format, PixelConvention, Unsupported, square_note};

pub(super) const FORMAT: Format = Format {
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
    write,
};

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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

/// Meshes that stand for the objects.
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
