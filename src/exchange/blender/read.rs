//! A camera of a Blender program, or of what its console prints.

use pinhole_core::{Camera, ImageSize, Sphere};

use super::lens::lens;
use super::stance::frame;
use super::things::Things;
use crate::document::Item;
use crate::exchange::back::{image_of, readable};
use crate::exchange::code::{Code, Comments, Piece};
use crate::exchange::gltf::placed;
use crate::exchange::names::MOST_ASSIGNMENTS;
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Hash);
    let things = Things::of(&code);
    let chosen = things.camera(&code)?;
    let mut notes = Vec::new();
    let image = image(&code, at_hand, &mut notes)?;
    let number =
        |name: &str| -> Result<f64, FileError> { Ok(last(&code, name)?.map_or(1.0, |(x, _)| x)) };
    let shape = number("pixel_aspect_x")? / number("pixel_aspect_y")?;
    let lens = lens(&code, &things, &chosen, &mut notes)?;
    if !lens.is_given {
        notes.push("the text does not say the lens: 50 mm taken".to_owned());
    }
    let viewport = lens.viewport(image, shape, at_hand.viewport.distance);
    let frame = frame(&code, &things, &chosen, &mut notes)?;
    let (orientation, eye) =
        placed(&frame, &mut notes).map_err(|right| code.rotation("matrix_world", &right))?;
    let mut taken = Taken::camera(Camera { eye, orientation, viewport, image }, notes);
    spheres(&code, &mut taken);
    Ok(taken)
}

/// The number that a property of the scene is given last.
fn last<'t>(code: &'t Code, name: &str) -> Result<Option<(f64, Piece<'t>)>, FileError> {
    let assignments = code.assignments(name);
    let Some(last) = assignments.last() else { return Ok(None) };
    let Some(value) = last.value.filter(|_| assignments.len() < MOST_ASSIGNMENTS) else {
        let text = code.whole().text.get(last.at..last.at + name.len()).unwrap_or("");
        let right = "it is changed: it must be given as a number";
        return Err(code.fault(name, Piece { text, at: last.at }, right));
    };
    Ok(Some((code.number(name, value)?, value)))
}

fn image(code: &Code, at_hand: &Camera, notes: &mut Vec<String>) -> Result<ImageSize, FileError> {
    let given = last(code, "resolution_x")?.zip(last(code, "resolution_y")?);
    let Some(((width, piece), (height, _))) = given else {
        let image = at_hand.image;
        let (w, h) = (image.width(), image.height());
        notes.push(format!("the text does not say the resolution: {w} × {h} pixels taken"));
        return Ok(image);
    };
    let percent = last(code, "resolution_percentage")?.map_or(1.0, |(percent, _)| percent / 100.0);
    image_of((width * percent).trunc(), (height * percent).trunc())
        .map_err(|right| code.fault("resolution_x", piece, &right))
}

fn spheres(code: &Code, taken: &mut Taken) {
    let sphere = |call: Piece<'_>| {
        let parts = crate::exchange::code::split(call);
        let argument = |name: &str| {
            parts.iter().find_map(|part| {
                let (before, _) = part.text.split_once('=')?;
                (before.trim() == name).then(|| part.from(before.len() + 1))
            })
        };
        let radius = argument("radius").map_or(Ok(1.0), |piece| code.number("radius", piece))?;
        let center =
            argument("location").map(|piece| code.vector("location", piece)).transpose()?;
        if radius <= 0.0 {
            return Err(code.fault("radius", call, "it must be greater than 0"));
        }
        let shape = Sphere { center: center.unwrap_or_default(), radius };
        Ok(Item { name: None, color: None, shape })
    };
    let spheres = code.calls("primitive_uv_sphere_add").into_iter().map(sphere);
    taken.spheres = readable(spheres, "primitive_uv_sphere_add", &mut taken.notes);
    let planes = code.calls("primitive_plane_add").len();
    if planes > 0 {
        taken.notes.push(format!("{planes} squares left out: Pinhole's planes have no end"));
    }
}
