//! glTF 2.0: a node with a perspective camera, which looks along its own -z with y up (Khronos, *glTF
//! 2.0 Specification*, section 3.10). Spheres are meshes there, and written only when asked for.

use pinhole_core::{Camera, DVec3, Viewport};
use serde_json::Value;

use super::affine::Affine;
use super::back::{
    MIRRORED, Mirrored, Stance, image_of, image_of_aspect, in_ratio, shortest_where,
};
use super::gltf_mesh::Meshes;
use super::json::{self, Node};
use super::sheet::{Sheet, n};
use super::terms::{Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, With, Written};
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "gltf",
    label: "glTF 2.0",
    short: "glTF",
    ending: "gltf",
    terms: Terms {
        axes: Terms::OURS,
        given_by: "the node's matrix: u, v, w, eye as columns",
        pixels: Pixels::Device,
        view: "yfov: vertical, in radians, and aspectRatio = width / height",
        field: |subject| n(subject.viewport().vertical_fov()),
        distance: "none: znear and zfar cut, and change no ray",
        shape: "any: aspectRatio need not be the canvas's",
        lengths: "f32 in most programs",
    },
    write,
    read,
    claims: |text| {
        json::looks_like(text) && text.contains("\"asset\"") && text.contains("\"cameras\"")
    },
};

/// u, v, w and eye, column after column.
pub(super) fn columns(subject: &Subject) -> String {
    let basis = subject.posed().basis();
    let column = |v: DVec3, last: &str| {
        let [x, y, z] = v.to_array().map(n);
        format!("{x}, {y}, {z}, {last}")
    };
    [
        column(basis.u, "0"),
        column(basis.v, "0"),
        column(basis.w, "0"),
        column(subject.posed().eye(), "1"),
    ]
    .join(",\n        ")
}

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    let [width, height] = subject.size();
    let viewport = subject.viewport();
    let (near, far) = subject.clip();
    let mut notes = Vec::new();
    let meshes = match subject.with {
        With::Meshes => Meshes::of(subject, &mut notes),
        _ => Meshes::default(),
    };
    if subject.with == With::Objects
        && !(subject.spheres().is_empty() && subject.planes().is_empty())
    {
        notes.push(
            "objects are left out: glTF has meshes only, which are written when asked for"
                .to_owned(),
        );
    }
    let nodes: Vec<String> = (0..=meshes.nodes.len()).map(|k| k.to_string()).collect();
    let text = format!(
        "{{\n  \"asset\": {{ \"version\": \"2.0\", \"generator\": \"Pinhole\" }},\n  \"scene\": 0,\n  \
         \"scenes\": [{{ \"nodes\": [{}] }}],\n  \"cameras\": [\n    {{\n      \
         \"type\": \"perspective\",\n      \"perspective\": {{\n        \"yfov\": {},\n        \
         \"aspectRatio\": {},\n        \"znear\": {},\n        \"zfar\": {}\n      }},\n      \
         \"extras\": {{ \"imageWidth\": {width}, \"imageHeight\": {height}, \"distance\": {} }}\n    \
         }}\n  ],\n  \"nodes\": [\n    {{\n      \"name\": \"camera\",\n      \"camera\": 0,\n      \
         \"matrix\": [\n        {}\n      ]\n    }}{}\n  ]{}\n}}\n",
        nodes.join(", "),
        n(viewport.vertical_fov()),
        n(viewport.width / viewport.height),
        n(near),
        n(far),
        n(viewport.distance),
        columns(subject),
        meshes.nodes.iter().map(|node| format!(",\n    {node}")).collect::<String>(),
        meshes.tables,
    );
    Ok(Written::of("scene.gltf", Sheet::of(&text), notes))
}

fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let value = json::parse(text)?;
    let root = Node::root(text, &value);
    let mut notes = Vec::new();
    let nodes = root.need("nodes", "the camera must be in a node")?.items();
    let index = nodes.iter().position(|node| node.value.get("camera").is_some());
    let index = index.ok_or_else(|| {
        FileError::of_file(text.path, "nodes: none has a camera: one must have \"camera\": 0")
    })?;
    let number = nodes[index].get("camera").and_then(|camera| camera.index());
    let cameras = root.need("cameras", "it must hold the camera")?;
    let camera = number.and_then(|number| cameras.item(number));
    let camera = camera.ok_or_else(|| {
        let of_node = nodes[index].get("camera");
        of_node.map_or_else(
            || FileError::of_file(text.path, "nodes: no camera"),
            |camera| camera.fault("it must be the number of one of the cameras"),
        )
    })?;
    let lens = camera.need("perspective", "the camera must be a perspective one")?;
    let yfov = lens.need("yfov", "it must be the vertical field of view in radians")?;
    let fov = yfov.number()?;
    if !(fov > 0.0 && fov < std::f64::consts::PI) {
        return Err(yfov.fault("it must be between 0 and pi, in radians"));
    }
    let aspect = lens.get("aspectRatio").map(|aspect| aspect.positive()).transpose()?;
    let extra = |name: &str| camera.get("extras").and_then(|extras| extras.get(name));
    let size = extra("imageWidth").zip(extra("imageHeight"));
    let image = match size {
        Some((width, height)) => {
            image_of(width.number()?, height.number()?).map_err(|right| width.fault(&right))?
        }
        None => {
            let aspect = aspect.unwrap_or(at_hand.image.aspect());
            image_of_aspect(at_hand.image, aspect, "glTF", &mut notes)
        }
    };
    let distance = extra("distance").map(|d| d.positive()).transpose()?;
    let distance = distance.unwrap_or(at_hand.viewport.distance);
    let aspect = aspect.unwrap_or(image.aspect());
    let viewport = upright_radians(fov, aspect, distance);
    let world = world_of(&nodes, index, 0)?;
    let (orientation, eye) = placed(&world, &mut notes)
        .map_err(|right| nodes[index].fault(&format!("it is no rotation: {right}")))?;
    if nodes.iter().any(|node| node.value.get("mesh").is_some()) {
        notes.push("meshes are left out: Pinhole has spheres and planes".to_owned());
    }
    Ok(Taken::camera(Camera { eye, orientation, viewport, image }, notes))
}

fn upright_radians(fov: f64, aspect: f64, distance: f64) -> Viewport {
    let near = pinhole_core::extent_of_fov(fov, distance);
    let height = shortest_where(near, |h| pinhole_core::fov_of_extent(h, distance) == fov);
    Viewport { width: in_ratio(height, aspect), height, distance }
}

/// A camera's orientation and eye from its node's frame in the world. Scales are no matter.
pub(super) fn placed(
    world: &Affine,
    notes: &mut Vec<String>,
) -> Result<(pinhole_core::Orientation, DVec3), String> {
    let stance = Stance { eye: world.at, right: world.x, up: world.y, backwards: world.z };
    let mirrored = pinhole_core::Basis::is_left_handed(world.x, world.y, world.z);
    let stance = if mirrored { stance.mirrored() } else { stance };
    let orientation = stance.orientation(notes)?;
    if mirrored {
        notes.push(MIRRORED.to_owned());
    }
    Ok((orientation, stance.eye))
}

/// A node's frame in the world, by way of the nodes that it is a child of.
fn world_of(nodes: &[Node], index: usize, depth: usize) -> Result<Affine, FileError> {
    let own = local(&nodes[index])?;
    let is_child = |node: &Node| {
        let children = node.value.get("children").and_then(Value::as_array);
        children.is_some_and(|list| list.iter().any(|k| k.as_u64() == Some(index as u64)))
    };
    match nodes.iter().position(is_child) {
        // More than there are nodes: a ring, which no glTF may have.
        Some(_) if depth > nodes.len() => {
            Err(nodes[index].fault("a node must not be its own child"))
        }
        Some(parent) => Ok(world_of(nodes, parent, depth + 1)?.of(&own)),
        None => Ok(own),
    }
}

fn local(node: &Node) -> Result<Affine, FileError> {
    if let Some(matrix) = node.get("matrix") {
        let numbers = matrix.numbers_of::<16>()?;
        return Affine::of_columns(&numbers)
            .ok_or_else(|| matrix.fault("it must be affine, column after column"));
    }
    let translation = node.get("translation").map(|t| t.numbers_of::<3>()).transpose()?;
    let scale = node.get("scale").map(|s| s.numbers_of::<3>()).transpose()?;
    let mut local = Affine::translation(translation.unwrap_or_default().into());
    if let Some(rotation) = node.get("rotation") {
        let [x, y, z, w] = rotation.numbers_of::<4>()?;
        let turn = pinhole_core::Basis::of_quaternion([w, x, y, z])
            .ok_or_else(|| rotation.fault("it must be a unit quaternion x, y, z, w"))?;
        local = local.of(&Affine { x: turn.u, y: turn.v, z: turn.w, at: DVec3::ZERO });
    }
    Ok(local.of(&Affine::scaling(scale.map_or(DVec3::ONE, DVec3::from))))
}
