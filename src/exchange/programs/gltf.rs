//! glTF 2.0: a node with a perspective camera, which looks along its own -z with y up (Khronos,
//! *glTF 2.0 Specification*, section 3.10). In glTF, spheres and planes are meshes: a sphere and a
//! square, whose vertices all objects share. The meshes are only written on request.

use std::f32::consts::PI;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use pinhole_core::{Object, Rgb};

use crate::format::{Conventions, ExportScene, Format, Include, LeftOut};
use crate::format::{OwnValues, PixelConvention, square_note};
use crate::template::{commas, light, n, quotable};

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
        lengths: "f32 in most programs",
    }),
    template: include_str!("../templates/gltf.txt"),
    left_out: LeftOut::Nothing,
    own,
};

/// Returns the nodes of the objects, and the glTF tables to which the nodes refer.
fn own(subject: &ExportScene, notes: &mut Vec<String>) -> Result<OwnValues, String> {
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
        tables = tables_of(&colors);
    }
    let indices: Vec<String> = (0..=nodes.len()).map(|k| k.to_string()).collect();
    let objects: String = nodes.iter().map(|node| format!(",\n    {node}")).collect();
    Ok(vec![
        ("nodes", indices.join(", ").into()),
        ("objects", objects.into()),
        ("tables", tables.into()),
    ])
}

/// Number of steps of the sphere from pole to pole; there are twice as many around the axis.
const STEPS: u16 = 32;

/// Vertices and triangles.
struct Mesh {
    points: Vec<[f32; 3]>,
    triangles: Vec<[u16; 3]>,
}

/// Returns a node for each object, and the different colours. The colour of index k has the meshes 2
/// k, a sphere, and 2 k + 1, a square.
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

/// Returns the vertices of all shapes as bytes, with the views and accessors that describe them.
fn vertices() -> (Vec<u8>, Vec<String>, Vec<String>) {
    let (mut bytes, mut views, mut accessors) = (Vec::new(), Vec::new(), Vec::new());
    for Mesh { points, triangles } in [sphere(), square()] {
        let mut add = |part: Vec<u8>, target: u16| {
            let (from, length) = (bytes.len(), part.len());
            views.push(format!(
                "{{ \"buffer\": 0, \"byteOffset\": {from}, \"byteLength\": {length}, \"target\": {target} }}"
            ));
            bytes.extend(part);
            bytes.resize(bytes.len().next_multiple_of(4), 0);
        };
        add(points.iter().flatten().flat_map(|x| x.to_le_bytes()).collect(), 34962);
        add(triangles.iter().flatten().flat_map(|k| k.to_le_bytes()).collect(), 34963);
        let (view, points_count, index_count) =
            (accessors.len(), points.len(), 3 * triangles.len());
        let bound = |of: fn(f32, f32) -> f32| {
            let bound = |k: usize| points.iter().map(|p| p[k]).reduce(of).unwrap_or_default();
            [0, 1, 2].map(|k| bound(k).to_string()).join(", ")
        };
        accessors.push(format!(
            "{{ \"bufferView\": {view}, \"componentType\": 5126, \"count\": {points_count}, \
             \"type\": \"VEC3\", \"min\": [{}], \"max\": [{}] }}",
            bound(f32::min),
            bound(f32::max)
        ));
        accessors.push(format!(
            "{{ \"bufferView\": {}, \"componentType\": 5123, \"count\": {index_count}, \
             \"type\": \"SCALAR\" }}",
            view + 1
        ));
    }
    (bytes, views, accessors)
}

/// Returns the meshes, two for each colour, with their materials and vertices.
fn tables_of(colors: &[Rgb]) -> String {
    let (bytes, views, accessors) = vertices();
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
    let list = |items: Vec<String>| items.join(",\n    ");
    format!(
        ",\n  \"meshes\": [\n    {}\n  ],\n  \"materials\": [\n    {}\n  ],\n  \
         \"accessors\": [\n    {}\n  ],\n  \"bufferViews\": [\n    {}\n  ],\n  \
         \"buffers\": [{{ \"byteLength\": {}, \"uri\": \"data:application/octet-stream;base64,{}\" }}]",
        list((0..2 * colors.len()).map(mesh).collect()),
        list(colors.iter().map(material).collect()),
        list(accessors),
        list(views),
        bytes.len(),
        BASE64_STANDARD.encode(&bytes)
    )
}

/// Returns the unit sphere, divided by longitude and latitude, with counterclockwise triangles as seen from
/// outside.
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

/// Returns a square from -1 to 1 in x and y.
fn square() -> Mesh {
    let points = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    Mesh { points, triangles: vec![[0, 1, 2], [0, 2, 3]] }
}
