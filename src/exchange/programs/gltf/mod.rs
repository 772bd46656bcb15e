//! glTF 2.0: a node with a perspective camera, which looks along its own -z with y up (Khronos, *glTF
//! 2.0 Specification*, section 3.10). Spheres are meshes there, and written only when asked for.

mod binary;
mod mesh;

use pinhole_core::{Camera, DVec3, Viewport};
use serde_json::Value;

pub(super) use self::binary::{MAGIC, json_of};
use self::mesh::Meshes;
use crate::FileError;
use crate::format::affine::Affine;
use crate::format::image_size::{image_of, image_of_ratio};
use crate::format::json::{self, Node};
use crate::format::pose::Pose;
use crate::format::text::n;
use crate::format::viewport::{in_ratio, shortest_where};
use crate::format::{
    Conventions, ExportScene, Exported, Format, Imported, Importer, Include, Input,
    PixelConvention, Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "gltf",
    label: "glTF 2.0",
    short: "glTF",
    ending: "gltf",
    conventions: Conventions {
        axes: Conventions::OURS,
        given_by: "the node's matrix: u, v, w, eye as columns",
        pixels: PixelConvention::Device,
        view: "yfov: vertical, in radians, and aspectRatio = width / height",
        field: |subject| n(subject.viewport().vertical_fov()),
        distance: "none: znear and zfar cut, and change no ray",
        shape: "any: aspectRatio need not be the canvas's",
        lengths: "f32 in most programs",
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "gltf",
    label: "glTF 2.0",
    read,
    detect: |text| {
        json::looks_like(text) && text.contains("\"asset\"") && text.contains("\"cameras\"")
    },
};

/// u, v, w and eye, column after column.
pub(super) fn columns(subject: &ExportScene) -> String {
    let basis = subject.resolve().basis();
    let column = |v: DVec3, last: &str| {
        let [x, y, z] = v.to_array().map(n);
        format!("{x}, {y}, {z}, {last}")
    };
    [
        column(basis.u, "0"),
        column(basis.v, "0"),
        column(basis.w, "0"),
        column(subject.resolve().eye(), "1"),
    ]
    .join(",\n        ")
}

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
    let [width, height] = subject.size();
    let viewport = subject.viewport();
    let (near, far) = subject.clip();
    let mut notes = Vec::new();
    let meshes = match subject.include {
        Include::Meshes => Meshes::new(subject, &mut notes),
        _ => {
            let why = "glTF has meshes only, which are written when asked for";
            notes.extend(subject.objects_left_out(why));
            Meshes::default()
        }
    };
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
    Ok(Exported::one_file("scene.gltf", &text, notes))
}

fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let value = json::parse(text)?;
    let root = Node::root(text, &value);
    let mut notes = Vec::new();
    let nodes = root.need("nodes", "the camera must be in a node")?.items();
    let cameras = root.need("cameras", "it must hold the camera")?.items();
    let index = node_of_camera(&root, &nodes, &cameras, &mut notes)?.ok_or_else(|| {
        FileError::of_file(text.path, "nodes: none has a camera: one must have \"camera\": 0")
    })?;
    let number = nodes[index].get("camera").and_then(|camera| camera.index());
    let camera = number.and_then(|number| cameras.get(number));
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
            image_of_ratio(at_hand.image, aspect, "glTF", &mut notes)
        }
    };
    let distance = extra("distance").map(|d| d.positive()).transpose()?;
    let distance = distance.unwrap_or(at_hand.viewport.distance);
    let aspect = aspect.unwrap_or(image.aspect());
    let viewport = upright_radians(fov, aspect, distance);
    let world = world_of(&nodes, index)?;
    // Scales are no matter.
    let (orientation, eye, _) = Pose::from_frame(&world)
        .right_handed(&mut notes)
        .map_err(|right| nodes[index].fault(&format!("it is no rotation: {right}")))?;
    if nodes.iter().any(|node| node.value.get("mesh").is_some()) {
        notes.push("meshes are left out: Pinhole has spheres and planes".to_owned());
    }
    Ok(Imported::camera(Camera { eye, orientation, viewport, image }, notes))
}

fn upright_radians(fov: f64, aspect: f64, distance: f64) -> Viewport {
    let near = pinhole_core::extent_of_fov(fov, distance);
    let height = shortest_where(near, |h| pinhole_core::fov_of_extent(h, distance) == fov);
    Viewport { width: in_ratio(height, aspect), height, distance }
}

/// A node's frame in the world, by way of the nodes that it is a child of.
fn world_of(nodes: &[Node], index: usize) -> Result<Affine, FileError> {
    let mut parents: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in children(node) {
            if let Some(parents) = parents.get_mut(child) {
                parents.push(parent);
            }
        }
    }
    let mut passed = vec![false; nodes.len()];
    let (mut above, mut world) = (index, Affine::IDENTITY);
    loop {
        world = local(&nodes[above])?.after(&world);
        passed[above] = true;
        above = match parents[above][..] {
            [] => return Ok(world),
            [parent] if !passed[parent] => parent,
            [_] => return Err(nodes[above].fault("it is below itself: it must be no child of it")),
            _ => return Err(nodes[above].fault("it must be a child of one node only")),
        };
    }
}

/// The numbers of the nodes right below one.
fn children(node: &Node) -> impl Iterator<Item = usize> {
    indices(node.value.get("children"))
}

fn indices(list: Option<&Value>) -> impl Iterator<Item = usize> {
    let list = list.and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    list.iter().filter_map(|index| usize::try_from(index.as_u64()?).ok())
}

/// The node whose camera is taken: the first perspective one of the scene that is shown, else the first
/// of all, else the first camera of any kind.
fn node_of_camera(
    root: &Node,
    nodes: &[Node],
    cameras: &[Node],
    notes: &mut Vec<String>,
) -> Result<Option<usize>, FileError> {
    let shown = shown(root, nodes)?;
    let all: Vec<usize> =
        (0..nodes.len()).filter(|k| nodes[*k].value.get("camera").is_some()).collect();
    let is_perspective = |k: &usize| {
        let number = nodes[*k].get("camera").and_then(|camera| camera.index());
        let camera = number.and_then(|number| cameras.get(number));
        camera.is_some_and(|camera| camera.value.get("perspective").is_some())
    };
    let mut perspective = all.iter().filter(|k| is_perspective(k));
    let first = perspective.clone().find(|k| shown[**k]).or_else(|| perspective.next());
    let Some(&taken) = first else { return Ok(all.first().copied()) };
    let name = nodes[taken].value.get("name").and_then(Value::as_str);
    let name = name.map_or_else(|| nodes[taken].path.clone(), |name| format!("node \"{name}\""));
    if all.len() > 1 {
        let more = all.len() - 1;
        let (cameras, are) = if more == 1 { ("camera", "is") } else { ("cameras", "are") };
        notes.push(format!("{name} is taken; {more} more {cameras} {are} left out"));
    }
    if !shown[taken] {
        notes.push(format!("{name} is not in the scene that is shown: no camera is"));
    }
    Ok(Some(taken))
}

/// Marks the nodes of the scene that is shown: the one of number `scene`, else the first one; all where
/// there are no scenes.
fn shown(root: &Node, nodes: &[Node]) -> Result<Vec<bool>, FileError> {
    let Some(scenes) = root.get("scenes") else { return Ok(vec![true; nodes.len()]) };
    let scenes = scenes.items();
    let scene = match root.get("scene") {
        Some(number) => {
            let scene = number.index().and_then(|number| scenes.get(number));
            let right = "it must be the number of one of the scenes";
            Some(scene.ok_or_else(|| number.fault(right))?)
        }
        None => scenes.first(),
    };
    let Some(scene) = scene else { return Ok(vec![true; nodes.len()]) };
    let mut shown = vec![false; nodes.len()];
    let mut left: Vec<usize> = indices(scene.value.get("nodes")).collect();
    while let Some(index) = left.pop() {
        if shown.get(index) == Some(&false) {
            shown[index] = true;
            left.extend(children(&nodes[index]));
        }
    }
    Ok(shown)
}

fn local(node: &Node) -> Result<Affine, FileError> {
    if let Some(matrix) = node.get("matrix") {
        let numbers = matrix.numbers_of::<16>()?;
        return Affine::from_columns(&numbers)
            .ok_or_else(|| matrix.fault("it must be affine, column after column"));
    }
    let translation = node.get("translation").map(|t| t.numbers_of::<3>()).transpose()?;
    let scale = node.get("scale").map(|s| s.numbers_of::<3>()).transpose()?;
    let mut local = Affine::translation(translation.unwrap_or_default().into());
    if let Some(rotation) = node.get("rotation") {
        let [x, y, z, w] = rotation.numbers_of::<4>()?;
        let turn = pinhole_core::Basis::of_quaternion([w, x, y, z])
            .ok_or_else(|| rotation.fault("it must be a unit quaternion x, y, z, w"))?;
        local = local.after(&Affine { x: turn.u, y: turn.v, z: turn.w, at: DVec3::ZERO });
    }
    Ok(local.after(&Affine::scaling(scale.map_or(DVec3::ONE, DVec3::from))))
}
