//! A camera of a Blender program, or of what its console prints.

use pinhole_core::{Camera, ImageSize, Sphere};

use super::lens::lens;
use super::stance::frame;
use super::things::{Deed, Things};
use crate::document::Item;
use crate::exchange::back::{image_of, readable};
use crate::exchange::code::{Code, Comments, Piece, words};
use crate::exchange::gltf::placed;
use crate::exchange::python::{Block, Verb};
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Hash);
    let things = Things::of(&code);
    let chosen = things.camera(&code)?;
    let mut notes = Vec::new();
    let image = image(&code, &things, at_hand, &mut notes)?;
    let number = |name: &str| -> Result<f64, FileError> {
        Ok(last(&code, &things, name)?.map_or(1.0, |(x, _)| x))
    };
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

/// The number that a property of the scene's render is given last.
fn last<'t>(
    code: &Code,
    things: &Things<'t>,
    name: &str,
) -> Result<Option<(f64, Piece<'t>)>, FileError> {
    let end = format!(".{name}");
    let is_given = |deed: &&Deed| !matches!(deed.verb, Verb::Say | Verb::Return | Verb::Define);
    let of = |is_own: &dyn Fn(&str) -> bool| -> Vec<&Deed<'t>> {
        things.deeds.iter().filter(is_given).filter(|deed| is_own(&deed.path)).collect()
    };
    let mut given = of(&|path| path.ends_with(&end));
    if given.is_empty() {
        given = of(&|path| path == name);
    }
    let Some(last) = given.last() else { return Ok(None) };
    if let Some(changed) = given.iter().find(|deed| deed.verb != Verb::Give) {
        let right = "it is changed: it must be given as a number";
        return Err(code.fault(name, changed.value, right));
    }
    let others = given.iter().any(|deed| deed.value.text != last.value.text);
    if others && let Some(perhaps) = given.iter().find(|deed| deed.block == Block::Perhaps) {
        let right = "it is given in an if, and more than once: leave in one";
        return Err(code.fault(name, perhaps.value, right));
    }
    Ok(Some((code.number(name, last.value)?, last.value)))
}

fn image(
    code: &Code,
    things: &Things,
    at_hand: &Camera,
    notes: &mut Vec<String>,
) -> Result<ImageSize, FileError> {
    const NAMES: [&str; 2] = ["resolution_x", "resolution_y"];
    let [x, y] = NAMES;
    let (width, height, piece) = match (last(code, things, x)?, last(code, things, y)?) {
        (Some((width, piece)), Some((height, _))) => (width, height, piece),
        (None, None) => {
            let image = at_hand.image;
            let (w, h) = (image.width(), image.height());
            let is_named = NAMES.iter().any(|name| !words(code.whole(), name).is_empty());
            let said = match is_named {
                true => "gives the resolution no number",
                false => "does not say the resolution",
            };
            notes.push(format!("the text {said}: {w} × {h} pixels taken"));
            return Ok(image);
        }
        (Some(_), None) => return Err(code.missing(y, "it must be given as resolution_x is")),
        (None, Some(_)) => return Err(code.missing(x, "it must be given as resolution_y is")),
    };
    let percent = last(code, things, "resolution_percentage")?.map_or(1.0, |(x, _)| x / 100.0);
    image_of((width * percent).trunc(), (height * percent).trunc())
        .map_err(|right| code.fault(x, piece, &right))
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
