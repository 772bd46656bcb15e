//! glTF 2.0: a node with a perspective camera, which looks along its own -z with y up (Khronos, *glTF
//! 2.0 Specification*, section 3.10). Spheres and planes are written as meshes, only on request. All
//! objects share the vertices of one sphere and one square.

use std::f32::consts::PI;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use pinhole_core::{Object, Rgb};

use crate::format::{Conventions, ExportScene, Format, Include};
use crate::format::{ExtraValues, PixelConvention, square_note};
use crate::template::{self, commas, light, n, quotable};

pub(super) const FORMAT: Format = Format {
    name: "gltf",
    label: "glTF 2.0",
    short: "glTF",
    file: "scene.gltf",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "the node's matrix: u, v, w, eye as columns",
        pixels: PixelConvention::Device,
        view: "yfov: vertical, in radians, and aspectRatio = width / height",
        field: "{vertical_radians}",
        distance: "none: znear and zfar cut, and change no ray",
        shape: "any: aspectRatio need not be the canvas's",
    }),
    template: include_str!("../templates/gltf.txt"),
    extra,
    ..Format::PLAIN
};

/// Returns the template's values for the objects: their nodes, and the top-level arrays of the glTF
/// file (meshes, materials, accessors, buffer views and buffers) to which the nodes refer.
fn extra(subject: &ExportScene, notes: &mut Vec<String>) -> Result<ExtraValues, String> {
    let mut nodes = Vec::new();
    let mut tables = String::new();
    if subject.objects.is_empty() {
    } else if subject.include != Include::Meshes {
        notes.push(
            "objects are left out: glTF has meshes only, which are written when asked for".into(),
        );
    } else {
        let colors;
        (nodes, colors) = nodes_of(subject, notes);
        tables = tables_of(&colors)?;
    }
    let indices: Vec<String> = (0..=nodes.len()).map(|k| k.to_string()).collect();
    let objects: String = nodes.iter().map(|node| format!(",\n    {node}")).collect();
    Ok(vec![
        ("nodes", indices.join(", ").into()),
        ("objects", objects.into()),
        ("tables", tables.into()),
    ])
}

/// Number of subdivisions of the sphere's mesh from pole to pole. There are twice as many around the
/// axis.
const STEPS: u16 = 32;

/// A mesh of triangles, given by their vertices.
struct Mesh {
    points: Vec<[f32; 3]>,
    triangles: Vec<[u16; 3]>,
}

/// Returns a glTF node for each object, and the list of the objects' distinct colours. For the colour
/// with index k, mesh 2 k is a sphere, and mesh 2 k + 1 a square.
fn nodes_of(subject: &ExportScene, notes: &mut Vec<String>) -> (Vec<String>, Vec<Rgb>) {
    let mut colors: Vec<Rgb> = Vec::new();
    let mut nodes = Vec::new();
    for object in &subject.objects {
        let k = colors.iter().position(|known| *known == object.color).unwrap_or_else(|| {
            colors.push(object.color);
            colors.len() - 1
        });
        let name = quotable(&object.title);
        nodes.push(match &object.shape {
            Object::Sphere(sphere) => {
                let (mesh, center, r) = (2 * k, commas(sphere.center), n(sphere.radius));
                format!(
                    "{{ \"name\": \"{name}\", \"mesh\": {mesh}, \"translation\": [{center}], \
                     \"scale\": [{r}, {r}, {r}] }}"
                )
            }
            Object::Plane(plane) => {
                let (middle, half, [a, b]) = subject.square_of(plane);
                notes.push(square_note(&object.title, "glTF", half));
                let [x, y, z] = [half * a, half * b, a.cross(b)].map(commas);
                let (mesh, middle) = (2 * k + 1, commas(middle));
                format!(
                    "{{ \"name\": \"{name}\", \"mesh\": {mesh}, \"matrix\": [{x}, 0, {y}, 0, {z}, 0, \
                     {middle}, 1] }}"
                )
            }
        });
    }
    if matches!(subject.objects[0].shape, Object::Sphere(_)) {
        let triangles = sphere().triangles.len();
        notes.push(format!("each sphere is a mesh of {triangles} triangles, inside its outline"));
    }
    (nodes, colors)
}

/// Returns the glTF file's top-level arrays for objects in these colours. Each colour has a material
/// and two meshes, a sphere and a square. All meshes share one buffer, with the vertices and triangles
/// of one sphere and one square. The numbers of vertices and of triangles' indices, and their
/// positions in the buffer, are constants in the template.
fn tables_of(colors: &[Rgb]) -> Result<String, String> {
    let material = |color: &Rgb| {
        format!(
            "{{ \"pbrMetallicRoughness\": {{ \"baseColorFactor\": [{}, 1], \"metallicFactor\": 0 }}, \
             \"doubleSided\": true }}",
            commas(light(*color))
        )
    };
    let mesh = |k: usize| {
        let (points, material) = (2 * (k % 2), k / 2);
        format!(
            "{{ \"primitives\": [{{ \"attributes\": {{ \"POSITION\": {points} }}, \"indices\": {}, \
             \"material\": {material} }}] }}",
            points + 1
        )
    };
    let mut bytes: Vec<u8> = Vec::new();
    for Mesh { points, triangles } in [sphere(), square()] {
        bytes.extend(points.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend(triangles.iter().flatten().flat_map(|k| k.to_le_bytes()));
    }
    let list = |items: Vec<String>| Some(items.join(",\n    ").into());
    let tables = template::section(FORMAT.template, "\n@meshes\n").trim_end();
    template::filled(tables, |name| {
        Ok(match name {
            "meshes" => list((0..2 * colors.len()).map(mesh).collect()),
            "materials" => list(colors.iter().map(material).collect()),
            "length" => Some(bytes.len().to_string().into()),
            "bytes" => Some(BASE64_STANDARD.encode(&bytes).into()),
            _ => None,
        })
    })
}

/// Returns a mesh of the unit sphere, divided by longitude and latitude. Its triangles are
/// counterclockwise as seen from outside.
fn sphere() -> Mesh {
    let round = 2 * STEPS;
    let mut points = vec![[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    for step in 1..STEPS {
        let down = PI * f32::from(step) / f32::from(STEPS);
        for turn in 0..round {
            let around = 2.0 * PI * f32::from(turn) / f32::from(round);
            points.push([down.sin() * around.cos(), down.cos(), -down.sin() * around.sin()]);
        }
    }
    let at = |step: u16, turn: u16| 2 + (step - 1) * round + turn % round;
    let mut triangles = Vec::new();
    for turn in 0..round {
        triangles.push([0, at(1, turn), at(1, turn + 1)]);
        triangles.push([1, at(STEPS - 1, turn + 1), at(STEPS - 1, turn)]);
        for step in 1..STEPS - 1 {
            let (a, b) = (at(step, turn), at(step, turn + 1));
            let (c, d) = (at(step + 1, turn), at(step + 1, turn + 1));
            triangles.push([a, c, b]);
            triangles.push([b, c, d]);
        }
    }
    Mesh { points, triangles }
}

/// Returns a mesh of the square from -1 to 1 in x and y.
fn square() -> Mesh {
    let points = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    Mesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]] }
}
