//! Reading a scene of Mitsuba 3: its sensor and film, spheres, and squares as planes.

use pinhole_core::{Camera, DVec3, Orientation, Plane, Sphere, Viewport};
use roxmltree::{Document as Xml, Node};

use super::affine::Affine;
use super::back::{MIRRORED, Mirrored, Stance, extent, image_of, in_ratio, readable};
use super::code::{error_at, number};
use super::sheet::{byte_of_light, n};
use super::{Taken, Text};
use crate::document::Item;
use crate::formats::{FileError, color};

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let xml = Xml::parse(text.text).map_err(|error| {
        let pos = error.pos();
        let place = crate::formats::Place { line: pos.row as usize, column: pos.col as usize };
        let problem = format!("no XML: {error}");
        FileError { place: Some(place), ..FileError::of_file(text.path, problem) }
    })?;
    let file = File::of(text, &xml);
    let mut notes = Vec::new();
    let sensor = xml.descendants().find(|node| node.has_tag_name("sensor"));
    let sensor = sensor.ok_or_else(|| {
        FileError::of_file(
            text.path,
            "sensor is missing: <sensor type=\"perspective\"> must be there",
        )
    })?;
    let kind = sensor.attribute("type").unwrap_or_default();
    if !["perspective", "thinlens"].contains(&kind) {
        return Err(file.fault(sensor, "sensor's type", kind, "it must be perspective"));
    }
    if kind == "thinlens" {
        notes.push("the lens's aperture is left out: a pinhole is sharp everywhere".to_owned());
    }
    let film = sensor.children().find(|node| node.has_tag_name("film"));
    let size = |name: &str, or: f64| {
        film.and_then(|film| named(film, name)).map_or(Ok(or), |node| file.number(node))
    };
    let (width, height) = (size("width", 768.0)?, size("height", 576.0)?);
    let image = image_of(width, height)
        .map_err(|right| file.fault(film.unwrap_or(sensor), "film's width", &n(width), &right))?;
    let viewport = viewport(&file, sensor, image, at_hand.viewport.distance)?;
    for name in ["principal_point_offset_x", "principal_point_offset_y"] {
        if let Some(node) = named(sensor, name)
            && file.number(node)? != 0.0
        {
            notes.push(format!("{name} is left out: the principal point is in the middle here"));
        }
    }
    let (orientation, eye, mirrored) = pose(&file, sensor, &mut notes)?;
    let (mut spheres, mut planes) = shapes(&file, &xml, &mut notes);
    if mirrored {
        notes.push(MIRRORED.to_owned());
        (spheres, planes) = (spheres.mirrored(), planes.mirrored());
    }
    Ok(Taken { camera: Camera { eye, orientation, viewport, image }, spheres, planes, notes })
}

fn pose(
    file: &File,
    sensor: Node,
    notes: &mut Vec<String>,
) -> Result<(Orientation, DVec3, bool), FileError> {
    let transform = named(sensor, "to_world");
    let steps: Vec<Node> =
        transform.iter().flat_map(Node::children).filter(Node::is_element).collect();
    if let [only] = steps[..]
        && only.has_tag_name("lookat")
    {
        let part = |name: &str| file.vector(only, name);
        let (eye, at) = (part("origin")?, part("target")?);
        return Ok((Orientation::At { at, up: part("up")? }, eye, false));
    }
    let to_world = file.transform(transform)?;
    let stance =
        Stance { eye: to_world.at, right: -to_world.x, up: to_world.y, backwards: -to_world.z };
    let Stance { right, up, backwards, .. } = stance;
    let mirrored = pinhole_core::Basis::is_left_handed(right, up, backwards);
    let stance = if mirrored { stance.mirrored() } else { stance };
    let node = transform.unwrap_or(sensor);
    let orientation = stance
        .orientation(notes)
        .map_err(|right| file.fault(node, "to_world", "no rotation", &right))?;
    Ok((orientation, stance.eye, mirrored))
}

fn viewport(
    file: &File,
    sensor: Node,
    image: pinhole_core::ImageSize,
    distance: f64,
) -> Result<Viewport, FileError> {
    if let Some(node) = named(sensor, "focal_length") {
        let value = node.attribute("value").unwrap_or_default();
        return Err(file.fault(
            node,
            "focal_length",
            value,
            "the field of view must be given by fov",
        ));
    }
    let node = named(sensor, "fov").ok_or_else(|| {
        FileError::of_file(file.text.path, "fov is missing: the field of view must be given by it")
    })?;
    let fov = file.number(node)?;
    if !(fov > 0.0 && fov < 180.0) {
        return Err(file.fault(node, "fov", &n(fov), "it must be between 0 and 180 degrees"));
    }
    let axis = named(sensor, "fov_axis").map(|node| file.attribute(node, "value"));
    let axis = axis.as_deref().unwrap_or("x");
    let aspect = image.aspect();
    let across = extent(fov, distance);
    let is_wide = aspect >= 1.0;
    let horizontal = match axis {
        "x" => true,
        "y" => false,
        "smaller" => !is_wide,
        "larger" => is_wide,
        "diagonal" => {
            let height = across / aspect.hypot(1.0);
            return Ok(Viewport { width: aspect * height, height, distance });
        }
        other => {
            let right = "it must be x, y, smaller, larger or diagonal";
            return Err(file.fault(sensor, "fov_axis", other, right));
        }
    };
    let (width, height) = match horizontal {
        true => (across, in_ratio(across, 1.0 / aspect)),
        false => (in_ratio(across, aspect), across),
    };
    Ok(Viewport { width, height, distance })
}

type Shapes = (Vec<Item<Sphere>>, Vec<Item<Plane>>);

fn shapes(file: &File, xml: &Xml, notes: &mut Vec<String>) -> Shapes {
    let mut shapes = (Vec::new(), Vec::new());
    let mut left = Vec::new();
    let nodes = xml.descendants().filter(|node| node.has_tag_name("shape"));
    readable(nodes.map(|node| shape(file, node, &mut shapes, &mut left)), "shape", notes);
    left.dedup();
    notes.append(&mut left);
    shapes
}

fn shape(
    file: &File,
    shape: Node,
    (spheres, planes): &mut Shapes,
    notes: &mut Vec<String>,
) -> Result<(), FileError> {
    let to_world = file.transform(named(shape, "to_world"))?;
    let color = shape.descendants().find(|node| node.has_tag_name("rgb"));
    let color = color.and_then(|node| rgb(&file.attribute(node, "value")));
    match shape.attribute("type").unwrap_or_default() {
        "sphere" => {
            let center = named(shape, "center").map(|node| file.point(node)).transpose()?;
            let radius = named(shape, "radius").map(|node| file.number(node)).transpose()?;
            let Some(scale) = to_world.scale() else {
                notes.push("a sphere that is scaled to an ellipsoid is left out".to_owned());
                return Ok(());
            };
            let center = to_world.point(center.unwrap_or_default());
            let radius = radius.unwrap_or(1.0) * scale;
            if radius <= 0.0 {
                return Err(file.fault(shape, "radius", &n(radius), "it must be greater than 0"));
            }
            spheres.push(Item { name: None, color, shape: Sphere { center, radius } });
        }
        "rectangle" | "disk" => {
            let normal = to_world.x.cross(to_world.y);
            planes.push(Item { name: None, color, shape: Plane { point: to_world.at, normal } });
            notes.push("a rectangle or disk is taken as a plane, which has no end".to_owned());
        }
        other => notes.push(format!("{other} is left out: Pinhole has spheres and planes")),
    }
    Ok(())
}

fn rgb(value: &str) -> Option<[u8; 3]> {
    if value.starts_with('#') {
        return color::parse(value);
    }
    let numbers: Vec<f64> = cells(value).map_while(number).collect();
    let [r, g, b] = numbers.try_into().ok()?;
    Some([r, g, b].map(byte_of_light))
}

fn named<'a, 'x>(node: Node<'a, 'x>, name: &str) -> Option<Node<'a, 'x>> {
    node.children().find(|child| child.attribute("name") == Some(name))
}

fn cells(value: &str) -> impl Iterator<Item = &str> {
    value.split([' ', ',', '\t', '\n']).filter(|cell| !cell.is_empty())
}

struct File<'a> {
    text: &'a Text<'a>,
    /// Names and values, the longest name first: `$width` is not `$w` and idth.
    defaults: Vec<(String, String)>,
}

impl<'a> File<'a> {
    fn of(text: &'a Text<'a>, xml: &Xml) -> File<'a> {
        let defaults = xml.descendants().filter(|node| node.has_tag_name("default"));
        let defaults = defaults.filter_map(|node| {
            Some((format!("${}", node.attribute("name")?), node.attribute("value")?.to_owned()))
        });
        let mut defaults: Vec<_> = defaults.collect();
        defaults.sort_by_key(|(name, _)| std::cmp::Reverse(name.len()));
        File { text, defaults }
    }

    /// An attribute with the defaults in the places of their names; empty where there is none.
    fn attribute(&self, node: Node, name: &str) -> String {
        let value = node.attribute(name).unwrap_or_default().to_owned();
        if !value.contains('$') {
            return value;
        }
        self.defaults.iter().fold(value, |value, (name, is)| value.replace(name, is))
    }

    fn fault(&self, node: Node, field: &str, value: &str, right: &str) -> FileError {
        let problem = format!("{field} is {value}: {right}");
        error_at(self.text.path, self.text.text, node.range().start, problem)
    }

    fn numbers(&self, node: Node, attribute: &str) -> Result<Vec<f64>, FileError> {
        let value = self.attribute(node, attribute);
        let numbers: Option<Vec<f64>> = cells(&value).map(number).collect();
        numbers
            .ok_or_else(|| self.fault(node, attribute, &format!("{value:?}"), "it must be numbers"))
    }

    fn number(&self, node: Node) -> Result<f64, FileError> {
        let name = node.attribute("name").unwrap_or("value");
        match self.numbers(node, "value")?[..] {
            [number] => Ok(number),
            _ => {
                let value = node.attribute("value").unwrap_or_default();
                Err(self.fault(node, name, &format!("{value:?}"), "it must be one number"))
            }
        }
    }

    fn vector(&self, node: Node, attribute: &str) -> Result<DVec3, FileError> {
        match self.numbers(node, attribute)?[..] {
            [x, y, z] => Ok(DVec3::new(x, y, z)),
            _ => {
                let value = node.attribute(attribute).unwrap_or_default();
                Err(self.fault(node, attribute, &format!("{value:?}"), "it must be three numbers"))
            }
        }
    }

    /// By x, y and z, each 0 where it is left out, or by one value.
    fn point(&self, node: Node) -> Result<DVec3, FileError> {
        if node.has_attribute("value") {
            return self.vector(node, "value");
        }
        let part = |name: &str| match node.attribute(name) {
            Some(_) => self.numbers(node, name).map(|n| n.first().copied().unwrap_or_default()),
            None => Ok(0.0),
        };
        Ok(DVec3::new(part("x")?, part("y")?, part("z")?))
    }

    /// Steps of a transform, each after those above it.
    fn transform(&self, node: Option<Node>) -> Result<Affine, FileError> {
        let Some(node) = node else { return Ok(Affine::IDENTITY) };
        let mut whole = Affine::IDENTITY;
        for step in node.children().filter(Node::is_element) {
            let one = match step.tag_name().name() {
                "translate" => Some(Affine::translation(self.point(step)?)),
                "scale" => {
                    let alike = self.numbers(step, "value")?;
                    let part = |name: &str| -> Result<f64, FileError> {
                        let value = self.numbers(step, name)?;
                        Ok(value.first().copied().unwrap_or(1.0))
                    };
                    Some(Affine::scaling(match alike[..] {
                        [scale] => DVec3::splat(scale),
                        [x, y, z] => DVec3::new(x, y, z),
                        _ => DVec3::new(part("x")?, part("y")?, part("z")?),
                    }))
                }
                "rotate" => {
                    let angle = self.numbers(step, "angle")?.first().copied().unwrap_or_default();
                    Affine::rotation(angle, self.point(step)?)
                }
                "matrix" => {
                    let numbers = self.numbers(step, "value")?;
                    Some(numbers).filter(|n| n.len() == 16).and_then(|n| Affine::of_rows(&n))
                }
                "lookat" => self.look_at(step)?,
                _ => None,
            };
            let name = step.tag_name().name();
            let right =
                "it must be translate, scale, rotate, lookat, or an affine matrix of 16 numbers";
            let one = one.ok_or_else(|| self.fault(step, "to_world", name, right))?;
            whole = one.of(&whole);
        }
        Ok(whole)
    }

    fn look_at(&self, node: Node) -> Result<Option<Affine>, FileError> {
        let origin = self.vector(node, "origin")?;
        let ahead = (self.vector(node, "target")? - origin).try_normalize();
        let up = self.vector(node, "up")?;
        Ok(ahead.and_then(|z| {
            let x = up.cross(z).try_normalize()?;
            Some(Affine { x, y: z.cross(x), z, at: origin })
        }))
    }
}
