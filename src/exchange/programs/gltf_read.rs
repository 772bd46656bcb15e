//! Reads the camera of a glTF file, whether JSON or binary. The crate `gltf` is not used, because it
//! reads numbers as `f32`, which would change the camera from the eighth digit on.

use pinhole_core::glam::DAffine3;
use pinhole_core::{Basis, Camera, DVec3};
use serde_json::Value;

use super::derived::{affine, image_of, image_of_ratio, right_handed, viewport_of_radians};
use crate::format::{Imported, Input};
use crate::{FileError, Location};

/// The bytes with which a binary glTF begins.
pub(super) const MAGIC: &[u8] = b"glTF";

/// Returns true if a text looks like a glTF with a camera.
pub(super) fn detect(text: &str) -> bool {
    text.trim_start().starts_with('{') && text.contains("\"asset\"") && text.contains("\"cameras\"")
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

/// Reads the camera of a glTF text. Values that it does not specify are those of the camera `at_hand`.
pub(super) fn read(input: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let value = parse(input)?;
    let root = JsonNode { input, path: String::new(), value: &value };
    let mut notes = Vec::new();
    let nodes = root.need("nodes", "the camera must be in a node")?.items();
    let cameras = root.need("cameras", "it must hold the camera")?.items();
    let taken = node_of_camera(&nodes, &cameras, &mut notes);
    let (index, number) = taken.ok_or_else(|| {
        FileError::of_file(input.path, "nodes: none has a camera: one must have \"camera\": 0")
    })?;
    let camera = number.index().and_then(|number| cameras.get(number));
    let camera =
        camera.ok_or_else(|| number.fault("it must be the number of one of the cameras"))?;
    let lens = camera.need("perspective", "the camera must be a perspective one")?;
    let yfov = lens.need("yfov", "it must be the vertical field of view in radians")?;
    let fov = yfov.number()?;
    if !(fov > 0.0 && fov < std::f64::consts::PI) {
        return Err(yfov.fault("it must be between 0 and pi, in radians"));
    }
    let aspect = lens.get("aspectRatio").map(|aspect| aspect.positive()).transpose()?;
    let extra = |name: &str| camera.get("extras").and_then(|extras| extras.get(name));
    let image = match extra("imageWidth").zip(extra("imageHeight")) {
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
    let viewport = viewport_of_radians(fov, aspect.unwrap_or(image.aspect()), distance);
    // The scale of the frame does not matter.
    let (orientation, eye) = right_handed(&world_of(&nodes, index)?, &mut notes)
        .map_err(|right| nodes[index].fault(&format!("it is no rotation: {right}")))?;
    if nodes.iter().any(|node| node.value.get("mesh").is_some()) {
        notes.push("meshes are left out: Pinhole has spheres and planes".to_owned());
    }
    Ok(Imported { camera: Camera { eye, orientation, viewport, image }, notes })
}

/// Returns the node whose camera is imported, and its field with that camera's index. It is the first
/// node with a perspective camera, or otherwise the first node with any camera. Returns `None` if no
/// node has a camera.
fn node_of_camera<'a>(
    nodes: &[JsonNode<'a>],
    cameras: &[JsonNode],
    notes: &mut Vec<String>,
) -> Option<(usize, JsonNode<'a>)> {
    let all = nodes.iter().enumerate().filter_map(|(k, node)| Some((k, node.get("camera")?)));
    let all: Vec<(usize, JsonNode)> = all.collect();
    let is_perspective = |(_, number): &&(usize, JsonNode)| {
        let camera = number.index().and_then(|number| cameras.get(number));
        camera.is_some_and(|camera| camera.value.get("perspective").is_some())
    };
    let taken = all.iter().find(is_perspective).or(all.first())?;
    if all.len() > 1 {
        let node = &nodes[taken.0];
        let name = node.value.get("name").and_then(Value::as_str);
        let name = name.map_or_else(|| node.path.clone(), |name| format!("node \"{name}\""));
        let more = all.len() - 1;
        let (cameras, are) = if more == 1 { ("camera", "is") } else { ("cameras", "are") };
        notes.push(format!("{name} is taken; {more} more {cameras} {are} left out"));
    }
    Some(taken.clone())
}

/// Returns the map from a node's coordinates to the world's, which combines the transforms of its
/// ancestors.
fn world_of(nodes: &[JsonNode], index: usize) -> Result<DAffine3, FileError> {
    let mut parents: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in node.indices("children") {
            if let Some(parents) = parents.get_mut(child) {
                parents.push(parent);
            }
        }
    }
    let mut passed = vec![false; nodes.len()];
    let (mut above, mut world) = (index, DAffine3::IDENTITY);
    loop {
        world = local(&nodes[above])? * world;
        passed[above] = true;
        above = match parents[above][..] {
            [] => return Ok(world),
            [parent] if !passed[parent] => parent,
            [_] => return Err(nodes[above].fault("it is below itself: it must be no child of it")),
            _ => return Err(nodes[above].fault("it must be a child of one node only")),
        };
    }
}

/// Returns the map from a node's coordinates to those of its parent.
fn local(node: &JsonNode) -> Result<DAffine3, FileError> {
    if let Some(matrix) = node.get("matrix") {
        return affine(&matrix.numbers::<16>()?)
            .ok_or_else(|| matrix.fault("it must be affine, column after column"));
    }
    let vector = |name, default| {
        node.get(name).map_or(Ok(default), |v| v.numbers::<3>().map(DVec3::from_array))
    };
    let mut local = DAffine3::from_translation(vector("translation", DVec3::ZERO)?);
    if let Some(rotation) = node.get("rotation") {
        let [x, y, z, w] = rotation.numbers::<4>()?;
        let Basis { u, v, w } = Basis::of_quaternion([w, x, y, z])
            .ok_or_else(|| rotation.fault("it must be a unit quaternion x, y, z, w"))?;
        local *= DAffine3::from_cols(u, v, w, DVec3::ZERO);
    }
    Ok(local * DAffine3::from_scale(vector("scale", DVec3::ONE)?))
}

/// Parses the text as JSON.
fn parse(input: &Input) -> Result<Value, FileError> {
    serde_json::from_str(input.text).map_err(|error| {
        let said = error.to_string();
        let said = said.split(" at line ").next().unwrap_or_default();
        let problem = match said.strip_prefix("EOF while parsing ") {
            Some(inside) => format!("the text ends inside {inside}: is all of the file there?"),
            None if said == "recursion limit exceeded" => {
                "brackets are nested more than 127 deep here".to_owned()
            }
            None => said.to_owned(),
        };
        // serde_json counts columns in bytes. Column 0 is before the first byte.
        let lines = input.text.split_inclusive('\n').take(error.line().saturating_sub(1));
        let byte = lines.map(str::len).sum::<usize>() + error.column().saturating_sub(1);
        let location = Location::of_byte(input.text.as_bytes(), byte);
        FileError::at(input.path, location, format!("no JSON: {problem}"))
    })
}

/// A JSON value and its path, such as `cameras[0].perspective.yfov`.
#[derive(Clone)]
struct JsonNode<'a> {
    input: &'a Input<'a>,
    path: String,
    value: &'a Value,
}

impl<'a> JsonNode<'a> {
    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    fn get(&self, key: &str) -> Option<JsonNode<'a>> {
        let value = self.value.get(key)?;
        Some(JsonNode { input: self.input, path: self.path_of(key), value })
    }

    fn need(&self, key: &str, right: &str) -> Result<JsonNode<'a>, FileError> {
        let problem = || format!("{} is missing: {right}", self.path_of(key));
        self.get(key).ok_or_else(|| FileError::of_file(self.input.path, problem()))
    }

    fn items(&self) -> Vec<JsonNode<'a>> {
        let items = self.value.as_array().map_or(&[][..], Vec::as_slice).iter().enumerate();
        let node =
            |(k, value)| JsonNode { input: self.input, path: format!("{}[{k}]", self.path), value };
        items.map(node).collect()
    }

    /// Returns the indices in the list that is the value of the key `list`.
    fn indices(&self, list: &str) -> impl Iterator<Item = usize> {
        let list = self.value.get(list).and_then(Value::as_array);
        let list = list.map_or(&[][..], Vec::as_slice).iter();
        list.filter_map(|index| usize::try_from(index.as_u64()?).ok())
    }

    /// Creates the error `path is value: right`, where `path` names the value, such as
    /// `nodes[0].camera`. The error is located at the last name of the path if the text contains that
    /// name only once.
    fn fault(&self, right: &str) -> FileError {
        let value: String = self.value.to_string().chars().take(60).collect();
        let problem = format!("{} is {value}: {right}", self.path);
        let name = self.path.rsplit('.').next().unwrap_or_default();
        let quoted = format!("\"{}\"", name.split('[').next().unwrap_or_default());
        let mut matches = self.input.text.match_indices(&quoted);
        match (matches.next(), matches.next()) {
            (Some((at, _)), None) => self.input.error_at(at, problem),
            _ => FileError::of_file(self.input.path, problem),
        }
    }

    fn number(&self) -> Result<f64, FileError> {
        let number = self.value.as_f64().filter(|number| number.is_finite());
        number.ok_or_else(|| self.fault("it must be a finite number"))
    }

    fn positive(&self) -> Result<f64, FileError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.fault("it must be greater than 0")) }
    }

    fn numbers<const N: usize>(&self) -> Result<[f64; N], FileError> {
        let numbers: Result<Vec<f64>, FileError> =
            self.items().iter().map(JsonNode::number).collect();
        numbers?.try_into().map_err(|_| self.fault(&format!("it must be {N} numbers")))
    }

    fn index(&self) -> Option<usize> {
        self.value.as_u64().and_then(|index| usize::try_from(index).ok())
    }
}
