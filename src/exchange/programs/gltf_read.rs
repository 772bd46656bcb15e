//! Reads the camera of a glTF file, whether JSON or binary. The crate `gltf` is not used, because it
//! reads numbers as `f32`, which would change the camera from the eighth digit on.

use pinhole_core::glam::DAffine3;
use pinhole_core::{Basis, Camera, DVec3};
use serde::Deserialize;
use serde_json::Value;

use super::derived::{affine, image_of, image_of_ratio, right_handed, viewport_of_radians};
use crate::error::of_json;
use crate::format::{Imported, Input};
use crate::template::n;
use crate::{FileError, limits};

/// The bytes with which a binary glTF begins.
pub(super) const MAGIC: &[u8] = b"glTF";

/// Returns a text without the byte order mark that some editors write.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Returns true if a text looks like a glTF with a camera.
pub(super) fn detect(text: &str) -> bool {
    without_mark(text).trim_start().starts_with('{')
        && text.contains("\"asset\"")
        && text.contains("\"cameras\"")
}

/// Returns the JSON part of a binary glTF file, which consists of a header of 12 bytes and of chunks,
/// the first of which is the JSON (Khronos, *glTF 2.0 Specification*, section 4.4). The other chunks
/// are not needed for a camera.
///
/// # Errors
/// Returns a message about the header or the first chunk.
pub(super) fn json_of(bytes: &[u8]) -> Result<&str, String> {
    let is_cut = |what: &str, has: u32, of: usize| {
        format!("binary glTF: {what} is {has} bytes, and {of} are there: is all of the file there?")
    };
    let Some((header, rest)) = bytes.split_at_checked(20) else {
        return Err(is_cut("the header with that of the JSON", 20, bytes.len()));
    };
    let number = |at: usize| header[at..].first_chunk().map_or(0, |four| u32::from_le_bytes(*four));
    let [version, whole, json] = [4, 8, 12].map(number);
    if version != 2 {
        return Err(format!("binary glTF: the version is {version}: it must be 2"));
    }
    if u64::from(whole) > bytes.len() as u64 {
        return Err(is_cut("the length", whole, bytes.len()));
    }
    let kind = &header[16..];
    if kind != b"JSON" {
        let kind = kind.escape_ascii();
        return Err(format!("binary glTF: the first chunk's type is {kind}: it must be JSON"));
    }
    let chunk = usize::try_from(json).ok().and_then(|length| rest.get(..length));
    let chunk = chunk.ok_or_else(|| is_cut("the JSON", json, rest.len()))?;
    std::str::from_utf8(chunk).map_err(|_| "binary glTF: the JSON must be UTF-8".to_owned())
}

/// What is read of a glTF.
#[derive(Deserialize)]
struct Gltf {
    nodes: Vec<Node>,
    cameras: Vec<GltfCamera>,
}

/// A node, placed in its parent by a matrix, or by translation, rotation (a quaternion x, y, z, w) and scale.
#[derive(Deserialize)]
struct Node {
    name: Option<String>,
    camera: Option<usize>,
    mesh: Option<usize>,
    #[serde(default)]
    children: Vec<usize>,
    matrix: Option<Box<[f64; 16]>>,
    translation: Option<DVec3>,
    rotation: Option<[f64; 4]>,
    scale: Option<DVec3>,
}

#[derive(Deserialize)]
struct GltfCamera {
    perspective: Option<Lens>,
    /// Any program's own values, here those that this one writes.
    #[serde(default)]
    extras: Value,
}

#[derive(Deserialize)]
struct Lens {
    yfov: f64,
    #[serde(rename = "aspectRatio")]
    aspect: Option<f64>,
}

/// Reads the camera of a glTF text. Values that it does not specify are those of the camera `at_hand`.
pub(super) fn read(input: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let input = &Input { text: without_mark(input.text), ..*input };
    if input.text.matches(',').count() > limits::VALUES {
        let problem = format!(
            "it has more than {} values: export the camera alone, without objects",
            limits::VALUES
        );
        return Err(FileError::of_file(input.path, problem));
    }
    let gltf: Gltf = serde_json::from_str(input.text).map_err(|error| fault(input, &error))?;
    let mut notes = Vec::new();
    let (index, number) = node_of_camera(&gltf, &mut notes).ok_or_else(|| {
        FileError::of_file(input.path, "nodes: none has a camera: one must have \"camera\": 0")
    })?;
    let wrong = |value: f64, path: &str, right: &str| {
        let problem = format!("{path} is {}: {right}", n(value));
        let key = format!("\"{}\"", path.rsplit('.').next().unwrap_or_default());
        let mut found = input.text.match_indices(&key);
        match (found.next(), found.next()) {
            (Some((at, _)), None) => input.error_at(at, problem),
            _ => FileError::of_file(input.path, problem),
        }
    };
    let right = "it must be the number of one of the cameras";
    let camera = gltf.cameras.get(number);
    let camera =
        camera.ok_or_else(|| wrong(number as f64, &format!("nodes[{index}].camera"), right))?;
    let path = format!("cameras[{number}].perspective");
    let Some(Lens { yfov, aspect }) = camera.perspective else {
        let problem = format!("{path} is missing: the camera must be a perspective one");
        return Err(FileError::of_file(input.path, problem));
    };
    if !(yfov > 0.0 && yfov < std::f64::consts::PI) {
        let right = "it must be between 0 and pi, in radians";
        return Err(wrong(yfov, &format!("{path}.yfov"), right));
    }
    if let Some(aspect) = aspect.filter(|aspect| *aspect <= 0.0) {
        return Err(wrong(aspect, &format!("{path}.aspectRatio"), "it must be greater than 0"));
    }
    let extra = |name: &str| camera.extras.get(name).and_then(Value::as_f64);
    let image = match extra("imageWidth").zip(extra("imageHeight")) {
        Some((width, height)) => image_of(width, height).map_err(|right| {
            wrong(width, &format!("cameras[{number}].extras.imageWidth"), &right)
        })?,
        None => {
            let aspect = aspect.unwrap_or(at_hand.image.aspect());
            image_of_ratio(at_hand.image, aspect, "glTF", &mut notes)
        }
    };
    let distance = extra("distance").filter(|distance| *distance > 0.0);
    let distance = distance.unwrap_or(at_hand.viewport.distance);
    let viewport = viewport_of_radians(yfov, aspect.unwrap_or(image.aspect()), distance);
    // The scale of the frame does not matter.
    let placed = world_of(&gltf.nodes, index).and_then(|world| {
        let placed = right_handed(&world, &mut notes);
        placed.map_err(|right| format!("nodes[{index}]: it is no rotation: {right}"))
    });
    let (orientation, eye) = placed.map_err(|problem| FileError::of_file(input.path, problem))?;
    if gltf.nodes.iter().any(|node| node.mesh.is_some()) {
        notes.push("meshes are left out: Pinhole has spheres and planes".to_owned());
    }
    Ok(Imported { camera: Camera { eye, orientation, viewport, image }, notes })
}

/// Returns the first node with a perspective camera, or if there is none, the first with any camera; and the
/// number of its camera. Returns `None` if no node has a camera. If there are several, a note says which one
/// is returned.
fn node_of_camera(gltf: &Gltf, notes: &mut Vec<String>) -> Option<(usize, usize)> {
    let all = gltf.nodes.iter().enumerate().filter_map(|(k, node)| Some((k, node.camera?)));
    let all: Vec<(usize, usize)> = all.collect();
    let is_perspective = |(_, number): &&(usize, usize)| {
        gltf.cameras.get(*number).is_some_and(|camera| camera.perspective.is_some())
    };
    let taken = *all.iter().find(is_perspective).or(all.first())?;
    if all.len() > 1 {
        let name = gltf.nodes[taken.0].name.as_ref();
        let name = name.map_or(format!("nodes[{}]", taken.0), |name| format!("node \"{name}\""));
        let more = all.len() - 1;
        let (cameras, are) = if more == 1 { ("camera", "is") } else { ("cameras", "are") };
        notes.push(format!("{name} is taken; {more} more {cameras} {are} left out"));
    }
    Some(taken)
}

/// Returns the map from a node's coordinates to the world's. Returns a message if the node, or one above it,
/// has several parents or is below itself.
fn world_of(nodes: &[Node], index: usize) -> Result<DAffine3, String> {
    let mut parents: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in &node.children {
            if let Some(parents) = parents.get_mut(*child) {
                parents.push(parent);
            }
        }
    }
    let mut passed = vec![false; nodes.len()];
    let (mut above, mut world) = (index, DAffine3::IDENTITY);
    loop {
        world = local(&nodes[above]).map_err(|right| format!("nodes[{above}].{right}"))? * world;
        passed[above] = true;
        above = match parents[above][..] {
            [] => return Ok(world),
            [parent] if !passed[parent] => parent,
            [_] => {
                return Err(format!("nodes[{above}] is below itself: it must be no child of it"));
            }
            _ => return Err(format!("nodes[{above}] must be a child of one node only")),
        };
    }
}

/// Returns the map from a node's coordinates to its parent's.
fn local(node: &Node) -> Result<DAffine3, &'static str> {
    if let Some(matrix) = &node.matrix {
        return affine(matrix.as_slice()).ok_or("matrix: it must be affine, column after column");
    }
    let mut local = DAffine3::from_translation(node.translation.unwrap_or_default());
    if let Some([x, y, z, w]) = node.rotation {
        let Basis { u, v, w } = Basis::of_quaternion([w, x, y, z])
            .ok_or("rotation: it must be a unit quaternion x, y, z, w")?;
        local *= DAffine3::from_cols(u, v, w, DVec3::ZERO);
    }
    Ok(local * DAffine3::from_scale(node.scale.unwrap_or(DVec3::ONE)))
}

/// Returns the error about a text that serde does not read, with its place in characters.
fn fault(input: &Input, error: &serde_json::Error) -> FileError {
    let what = if error.is_data() { "no glTF with a camera" } else { "no JSON" };
    let problem = format!("{what}: {}", of_json(error));
    // serde_json counts columns in bytes. Column 0 is before the first byte.
    let lines = input.text.split_inclusive('\n').take(error.line().saturating_sub(1));
    let byte = lines.map(str::len).sum::<usize>() + error.column().saturating_sub(1);
    input.error_at(byte, problem)
}
