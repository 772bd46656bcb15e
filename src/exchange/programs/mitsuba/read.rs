//! Reading a scene of Mitsuba, 3 or an older one: its sensor and film.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Viewport};
use roxmltree::{Document as Xml, Node};

use super::file::{File, number};
use super::shapes::{Shapes, shapes};
use super::tags;
use crate::FileError;
use crate::error::one_line;
use crate::format::image_size::image_of;
use crate::format::pose::Pose;
use crate::format::text::n;
use crate::format::viewport::{extent, in_ratio};
use crate::format::{Imported, Input};

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    if let Some((at, problem)) = tags::too_much(text.text) {
        return Err(text.error_at(at, problem));
    }
    let xml = Xml::parse(text.text).map_err(|error| no_xml(text, &error))?;
    let file = File::new(text, &xml);
    let mut notes = Vec::new();
    let mut sensors = xml.descendants().filter(|node| node.has_tag_name("sensor"));
    let sensor = sensors.next().ok_or_else(|| {
        file.missing("sensor is missing: <sensor type=\"perspective\"> must be there")
    })?;
    let others = sensors.count();
    if others > 0 {
        notes.push(format!("{others} of sensor left out: the first is taken"));
    }
    let kind = file.attribute(sensor, "type");
    if !["perspective", "thinlens"].contains(&kind) {
        return Err(file.fault(sensor, "sensor's type", kind, "it must be perspective"));
    }
    if kind == "thinlens" {
        notes.push("the lens's aperture is left out: a pinhole is sharp everywhere".to_owned());
    }
    let image = image(&file, sensor, &mut notes)?;
    let viewport = viewport(&file, sensor, image, at_hand.viewport.distance, &mut notes)?;
    for name in ["principal_point_offset_x", "principal_point_offset_y"] {
        if let Some(node) = file.named(sensor, name)
            && file.number(node)? != 0.0
        {
            notes.push(format!("{name} is left out: the principal point is in the middle here"));
        }
    }
    let (orientation, eye, mirrored) = pose(&file, sensor, &mut notes)?;
    let Shapes { spheres, planes, .. } = shapes(&file, &xml, &mut notes);
    let camera = Camera { eye, orientation, viewport, image };
    Ok(Imported { camera, spheres, planes, notes }.mirrored_if(mirrored))
}

/// A fault of the syntax; what is not closed is told where it begins.
fn no_xml(text: &Input, error: &roxmltree::Error) -> FileError {
    use roxmltree::Error::{UnclosedRootNode, UnexpectedEndOfStream};
    if let (UnclosedRootNode | UnexpectedEndOfStream, Some((at, name))) =
        (error, tags::unclosed(text.text))
    {
        let problem =
            format!("no XML: <{}> is not closed: is all of the file there?", one_line(name));
        return text.error_at(at, problem);
    }
    let pos = error.pos();
    let location = crate::Location { line: pos.row as usize, column: pos.col as usize };
    FileError::at(text.path, location, format!("no XML: {error}"))
}

/// The film's size; a part of it that is rendered alone is told in a note.
fn image<'x>(
    file: &File<'_, 'x>,
    sensor: Node<'x, 'x>,
    notes: &mut Vec<String>,
) -> Result<ImageSize, FileError> {
    let film = file.parts(sensor).find(|node| node.has_tag_name("film"));
    let given = |name: &str, or: f64| {
        film.and_then(|film| file.named(film, name)).map_or(Ok(or), |node| file.number(node))
    };
    let (width, height) = (given("width", 768.0)?, given("height", 576.0)?);
    let image = image_of(width, height)
        .map_err(|right| file.fault(film.unwrap_or(sensor), "film's width", &n(width), &right))?;
    let crop = [
        given("crop_width", width)?,
        given("crop_height", height)?,
        given("crop_offset_x", 0.0)?,
        given("crop_offset_y", 0.0)?,
    ];
    if crop != [width, height, 0.0, 0.0] {
        let (w, h) = (image.width(), image.height());
        notes.push(format!("the film's crop is left out: the whole image, {w} × {h}, is taken"));
    }
    Ok(image)
}

fn pose<'x>(
    file: &File<'_, 'x>,
    sensor: Node<'x, 'x>,
    notes: &mut Vec<String>,
) -> Result<(Orientation, DVec3, bool), FileError> {
    let transform = file.named(sensor, "to_world");
    let steps: Vec<Node> =
        transform.iter().flat_map(Node::children).filter(Node::is_element).collect();
    if let [only] = steps[..]
        && file.is_look_at(only)
    {
        let part = |name: &str| file.vector(only, name);
        let (eye, at) = (part("origin")?, part("target")?);
        return Ok((Orientation::At { at, up: part("up")? }, eye, false));
    }
    let to_world = file.transform(transform)?;
    let pose =
        Pose { eye: to_world.at, right: -to_world.x, up: to_world.y, backwards: -to_world.z };
    let node = transform.unwrap_or(sensor);
    pose.right_handed(notes).map_err(|right| file.fault(node, "to_world", "no rotation", &right))
}

/// The lens in millimetres, as in `35mm`.
fn focal_length<'x>(file: &File<'_, 'x>, lens: Node<'x, 'x>) -> Result<f64, FileError> {
    let value = file.attribute(lens, "value");
    let length = number(value.strip_suffix("mm").unwrap_or(value).trim());
    length.filter(|length| *length > 0.0).ok_or_else(|| {
        let right = "it must be millimetres greater than 0, as 50mm";
        file.fault(lens, "focal_length", &format!("{value:?}"), right)
    })
}

/// The viewport by `fov` along `fov_axis`, or by a lens before a film of 36 mm by 24 mm: its picture and
/// the film have the same diagonal (Mitsuba 3's plugins, *Perspective pinhole camera*).
fn viewport<'x>(
    file: &File<'_, 'x>,
    sensor: Node<'x, 'x>,
    image: ImageSize,
    distance: f64,
    notes: &mut Vec<String>,
) -> Result<Viewport, FileError> {
    let axis = file.named(sensor, "fov_axis").map_or("x", |node| file.attribute(node, "value"));
    let (across, axis) = match (file.named(sensor, "fov"), file.named(sensor, "focal_length")) {
        (Some(_), Some(lens)) => {
            let right = "fov is given too: only one of them may be";
            return Err(file.fault(lens, "focal_length", file.attribute(lens, "value"), right));
        }
        (Some(node), None) => {
            let fov = file.number(node)?;
            if !(fov > 0.0 && fov < 180.0) {
                let right = "it must be between 0 and 180 degrees";
                return Err(file.fault(node, "fov", &n(fov), right));
            }
            (extent(fov, distance), axis)
        }
        (None, lens) => {
            let length = match lens {
                Some(lens) => focal_length(file, lens)?,
                None => {
                    let said = "fov is not given: focal_length 50mm, which is Mitsuba's own, taken";
                    notes.push(said.to_owned());
                    50.0
                }
            };
            (distance * 36_f64.hypot(24.0) / length, "diagonal")
        }
    };
    let aspect = image.aspect();
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
