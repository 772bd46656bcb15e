//! three.js's JSON Object/Scene format 4: what `Object3D.toJSON` writes and `ObjectLoader` reads. The
//! statements that make a camera are read too, where they are given by numbers (`code`).
//! Cameras look along their own -z with y up; matrices are column after column.

mod code;

use std::collections::HashMap;

use pinhole_core::{Camera, DVec3, Plane, Sphere, Viewport};

use crate::FileError;
use crate::document::Item;
use crate::format::affine::Affine;
use crate::format::image_size::{image_of, image_of_ratio};
use crate::format::json::{self, Node};
use crate::format::left_out::readable;
use crate::format::pose::Pose;
use crate::format::text::{n, quotable};
use crate::format::viewport::viewport_of_angle;
use crate::format::{
    Conventions, ExportScene, Exported, Format, Imported, Importer, Input, PixelConvention,
    Unsupported, square_note,
};
use crate::programs::gltf::columns;

pub(super) const FORMAT: Format = Format {
    name: "three",
    label: "three.js",
    short: "three.js",
    ending: "json",
    conventions: Conventions {
        axes: Conventions::OURS,
        given_by: "the object's matrix: u, v, w, eye as columns",
        pixels: PixelConvention::Device,
        view: "fov: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: near and far cut, and change no ray",
        shape: "any: aspect need not be the canvas's",
        lengths: "f64, f32 when drawn",
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "three",
    label: "three.js",
    read,
    detect: |text| {
        (json::looks_like(text) && text.contains("\"PerspectiveCamera\"")) || code::detect(text)
    },
};

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
    let [width, height] = subject.size();
    let Viewport { width: across, height: up, distance } = *subject.viewport();
    let (near, far) = subject.clip();
    let mut notes = Vec::new();
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
    let Meshes { geometries, materials, meshes } = stand_ins(subject, &mut notes);
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
    Ok(Exported::one_file("scene.json", &text, notes))
}

/// Meshes that stand for the objects.
#[derive(Default)]
struct Meshes {
    geometries: Vec<String>,
    materials: Vec<String>,
    meshes: Vec<String>,
}

fn stand_ins(subject: &ExportScene, notes: &mut Vec<String>) -> Meshes {
    let mut made = Meshes::default();
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
    for sphere in subject.spheres() {
        let Sphere { center, radius } = sphere.shape;
        let [x, y, z] = center.to_array().map(n);
        let geometry = format!(
            "\"type\": \"SphereGeometry\", \"radius\": {}, \"widthSegments\": 64, \
             \"heightSegments\": 32",
            n(radius)
        );
        let matrix = format!("1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, {x}, {y}, {z}, 1");
        add(&sphere.title, sphere.color, &geometry, matrix);
    }
    for plane in subject.planes() {
        let (middle, half, [a, b]) = subject.square_of(&plane.shape);
        let column = |v: DVec3| v.to_array().map(n).join(", ");
        let side = n(2.0 * half);
        let geometry =
            format!("\"type\": \"PlaneGeometry\", \"width\": {side}, \"height\": {side}");
        let (a, b, c) = (column(a), column(b), column(a.cross(b)));
        let matrix = format!("{a}, 0, {b}, 0, {c}, 0, {}, 1", column(middle));
        add(&plane.title, plane.color, &geometry, matrix);
        notes.push(square_note(&plane.title, "three.js", half));
    }
    made
}

fn uuid(k: usize) -> String {
    format!("00000000-0000-4000-8000-{k:012x}")
}

fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    if code::detect(text.text) {
        return code::read(text, at_hand);
    }
    let value = json::parse(text)?;
    let root = Node::root(text, &value);
    let mut notes = Vec::new();
    let mut all = Vec::new();
    let top = root.need("object", "it must hold the camera, or the scene with the camera in it")?;
    collect(&top, Affine::IDENTITY, &mut all)?;
    let is = |node: &Node, kind: &str| node.value.get("type").is_some_and(|t| t == kind);
    let camera = all.iter().find(|(node, _)| is(node, "PerspectiveCamera"));
    let (camera, world) = camera.ok_or_else(|| {
        FileError::of_file(text.path, "object: no PerspectiveCamera is in it: there must be one")
    })?;
    let or = |name: &str, or: f64| camera.get(name).map_or(Ok(or), |node| node.positive());
    let (fov, aspect) = (or("fov", 50.0)?, or("aspect", 1.0)?);
    if fov >= 180.0 {
        return Err(camera.need("fov", "")?.fault("it must be between 0 and 180 degrees"));
    }
    let extra = |name: &str| camera.get("userData").and_then(|data| data.get(name));
    let image = match extra("imageWidth").zip(extra("imageHeight")) {
        Some((w, h)) => image_of(w.number()?, h.number()?).map_err(|right| w.fault(&right))?,
        None => image_of_ratio(at_hand.image, aspect, "three.js", &mut notes),
    };
    let distance = extra("distance").map(|d| d.positive()).transpose()?;
    let mut viewport =
        viewport_of_angle(fov, aspect, distance.unwrap_or(at_hand.viewport.distance));
    let zoom = or("zoom", 1.0)?;
    if zoom != 1.0 {
        viewport =
            Viewport { width: viewport.width / zoom, height: viewport.height / zoom, ..viewport };
    }
    let view = camera.get("view").and_then(|view| view.get("enabled"));
    let offset = camera.get("filmOffset").map_or(Ok(0.0), |offset| offset.number())?;
    if offset != 0.0 || view.is_some_and(|on| on.value == &serde_json::Value::Bool(true)) {
        notes.push("the offset of the view is left out: the middle is the middle here".to_owned());
    }
    let (orientation, eye, mirrored) = Pose::from_frame(world)
        .right_handed(&mut notes)
        .map_err(|right| camera.fault(&format!("its matrix is no rotation: {right}")))?;
    let mut taken = Imported::camera(Camera { eye, orientation, viewport, image }, notes);
    objects(&root, &all, &mut taken);
    Ok(taken.mirrored_if(mirrored))
}

/// Every object below this one, each with its frame in the world. JSON that is read has no more than
/// 128 brackets in each other.
fn collect<'a>(
    node: &Node<'a>,
    around: Affine,
    all: &mut Vec<(Node<'a>, Affine)>,
) -> Result<(), FileError> {
    let own = match node.get("matrix") {
        Some(matrix) => Affine::from_columns(&matrix.numbers_of::<16>()?)
            .ok_or_else(|| matrix.fault("it must be affine, column after column"))?,
        None => Affine::IDENTITY,
    };
    let world = around.after(&own);
    all.push((node.clone(), world));
    for child in node.get("children").map_or_else(Vec::new, |children| children.items()) {
        collect(&child, world, all)?;
    }
    Ok(())
}

/// A list's items by their uuids.
fn by_uuid<'a>(root: &Node<'a>, list: &str) -> HashMap<&'a str, Node<'a>> {
    let items = root.get(list).map_or_else(Vec::new, |list| list.items());
    let named =
        items.into_iter().filter_map(|item| Some((item.value.get("uuid")?.as_str()?, item)));
    // Of several, the first.
    named.rev().collect()
}

fn objects(root: &Node, all: &[(Node, Affine)], taken: &mut Imported) {
    let (geometries, materials) = (by_uuid(root, "geometries"), by_uuid(root, "materials"));
    let (mut left, mut squares) = (0, false);
    let mut spheres = Vec::new();
    for (node, world) in all {
        let of = |key: &str| node.value.get(key).and_then(|uuid| uuid.as_str());
        let Some(geometry) = of("geometry").and_then(|uuid| geometries.get(uuid)) else { continue };
        let material = of("material").and_then(|uuid| materials.get(uuid));
        let color = material.and_then(|m| m.value.get("color")?.as_u64());
        let color = color.map(|c| [(c >> 16) as u8, (c >> 8) as u8, c as u8]);
        let kind = geometry.value.get("type").and_then(|t| t.as_str()).unwrap_or_default();
        match (kind, world.scale()) {
            ("SphereGeometry" | "SphereBufferGeometry", Some(scale)) => {
                spheres.push((geometry, world.at, scale, color));
            }
            ("PlaneGeometry" | "PlaneBufferGeometry", _) => {
                let shape = Plane { point: world.at, normal: world.x.cross(world.y) };
                taken.planes.push(Item { name: None, color, shape });
                squares = true;
            }
            _ => left += 1,
        }
    }
    if squares {
        taken.notes.push("a PlaneGeometry is taken as a plane, which has no end".to_owned());
    }
    let spheres = spheres.into_iter().map(|(geometry, center, scale, color)| {
        let radius = geometry.get("radius").map_or(Ok(1.0), |radius| radius.positive())?;
        Ok(Item { name: None, color, shape: Sphere { center, radius: radius * scale } })
    });
    taken.spheres = readable(spheres, "SphereGeometry", &mut taken.notes);
    if left > 0 {
        taken.notes.push(format!("{left} meshes left out: Pinhole has spheres and planes"));
    }
}
