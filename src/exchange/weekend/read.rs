//! The book's camera as programs set it up: line by line since version 4, by its constructor before.

use std::fmt::Display;

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Sphere, Viewport};

use crate::document::Item;
use crate::exchange::back::{extent, image_of, in_ratio, readable};
use crate::exchange::code::{Code, Comments, Piece, is_of_word, number, split, trimmed};
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

pub(super) fn read(text: &Text, _: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Slashes);
    let mut notes = Vec::new();
    let camera = match constructor(&code)? {
        Some(call) => constructed(&code, call, &mut notes)?,
        None => set_up(&code, &mut notes)?,
    };
    let spheres = code.calls("make_shared<sphere>").into_iter().map(|call| sphere(&code, call));
    let spheres = readable(spheres, "sphere", &mut notes);
    Ok(Taken { spheres, ..Taken::camera(camera, notes) })
}

/// What the programs of the first chapters set of their camera.
const OWN: [&str; 4] = ["image_width", "aspect_ratio", "vfov", "lookat"];

/// `cam.lookfrom = ...` and its like. What is not set is as in the book's camera, and told.
fn set_up(code: &Code, notes: &mut Vec<String>) -> Result<Camera, FileError> {
    // Without any of it there is no camera whose place could be left as it is made.
    let is_set = OWN.iter().any(|name| {
        let assignments = code.assignments(name);
        assignments.iter().any(|assignment| !assignment.owner.is_empty())
    });
    if given(code, "lookfrom")?.is_none() && !is_set {
        return Err(code.missing("lookfrom", "it must be given, as lookfrom = point3(0, 0, 0);"));
    }
    let mut vector = |name: &str, or: [i32; 3]| -> Result<DVec3, FileError> {
        match given(code, name)? {
            Some(piece) => code.vector(name, piece),
            None => {
                let [x, y, z] = or;
                notes.push(not_given(name, format!("({x}, {y}, {z})")));
                Ok(DVec3::from_array(or.map(f64::from)))
            }
        }
    };
    let eye = vector("lookfrom", [0, 0, 0])?;
    let (at, up) = (vector("lookat", [0, 0, -1])?, vector("vup", [0, 1, 0])?);
    let mut number = |name: &str, or: i32| -> Result<f64, FileError> {
        match given(code, name)? {
            Some(piece) => code.number(name, piece),
            None => {
                notes.push(not_given(name, or));
                Ok(f64::from(or))
            }
        }
    };
    let vfov = angle(code, number("vfov", 90)?, given(code, "vfov")?)?;
    let (width, ratio) = (number("image_width", 100)?, number("aspect_ratio", 1)?);
    let distance = number("focus_dist", 10)?;
    let image = image(code, width, ratio, given(code, "image_width")?)?;
    if given(code, "defocus_angle")?.is_some_and(|angle| number_of(angle) != Some(0.0)) {
        notes.push("defocus_angle is left out: a pinhole is sharp everywhere".to_owned());
    }
    let height = extent(vfov, distance);
    let viewport = Viewport { width: in_ratio(height, image.aspect()), height, distance };
    Ok(Camera { eye, orientation: Orientation::At { at, up }, viewport, image })
}

fn not_given(name: &str, or: impl Display) -> String {
    format!("{name} is not in the text: {or} taken, as in the book's camera")
}

fn number_of(piece: Piece) -> Option<f64> {
    number(piece.text)
}

/// The one value that a field or a variable of this name is given.
fn given<'t>(code: &'t Code, name: &str) -> Result<Option<Piece<'t>>, FileError> {
    let assignments = code.assignments(name);
    let Some(first) = assignments.first() else { return Ok(code.value(name)) };
    let at =
        |at: usize| Piece { text: code.whole().text.get(at..at + name.len()).unwrap_or(""), at };
    let mut values = Vec::new();
    for assignment in &assignments {
        let Some(value) = assignment.value else {
            let right = "a part of it is changed: it must be given at once";
            return Err(code.fault(name, at(assignment.at), right));
        };
        values.push(value);
    }
    // The same twice is one.
    if values.iter().any(|value| value.text != values[0].text) {
        let right = format!("it is given {} times: leave in one camera", values.len());
        return Err(code.fault(name, values[1], &right));
    }
    Ok(first.value)
}

fn angle(code: &Code, vfov: f64, piece: Option<Piece>) -> Result<f64, FileError> {
    let is_angle = vfov > 0.0 && vfov < 180.0;
    let right = "it must be between 0 and 180 degrees";
    is_angle.then_some(vfov).ok_or_else(|| code.fault("vfov", piece.unwrap_or(code.whole()), right))
}

/// As the book's `initialize` reckons it.
fn image(
    code: &Code,
    width: f64,
    ratio: f64,
    piece: Option<Piece>,
) -> Result<ImageSize, FileError> {
    let height = (width / ratio).trunc().max(1.0);
    image_of(width, height)
        .map_err(|right| code.fault("image_width", piece.unwrap_or(code.whole()), &right))
}

/// What is in the brackets of `camera cam(lookfrom, lookat, vup, 20, aspect_ratio, aperture, focus)`, and
/// of `Camera::new(...)` in Rust; a definition has kinds of things in them.
fn constructor<'t>(code: &'t Code) -> Result<Option<Piece<'t>>, FileError> {
    let whole = code.whole();
    let mut found: Vec<Piece> = Vec::new();
    for word in ["camera", "Camera"] {
        let mut from = 0;
        for at in crate::exchange::code::words(whole, word) {
            let rest = whole.text[at + word.len()..].trim_start();
            let rest = rest.strip_prefix("::new").unwrap_or(rest);
            let rest = rest.trim_start_matches(is_of_word).trim_start();
            let Some(inside) = code.bracketed(whole.from(whole.text.len() - rest.len())) else {
                continue;
            };
            if inside.at < from {
                continue;
            }
            from = inside.at + inside.text.len();
            let parts = split(inside);
            let has_kind = |part: &Piece| part.text.contains([' ', ':']) && is_declared(part.text);
            if parts.len() >= 5 && !parts.iter().any(has_kind) {
                found.push(inside);
            }
        }
    }
    match found[..] {
        [_, second, ..] => {
            let right = format!("one of {} cameras: leave in one", found.len());
            Err(code.fault("camera", second, &right))
        }
        _ => Ok(found.first().copied()),
    }
}

/// `vec3 vup`, `double vfov = 90` and `vup: Vec3`, as against `16.0 / 9.0` and `Vec3::new(0, 1, 0)`.
fn is_declared(part: &str) -> bool {
    let part = part.split_once('=').map_or(part, |(before, _)| before).trim();
    let is_path = |text: &str| {
        text.starts_with(|c: char| c.is_alphabetic())
            && text.chars().all(|c| c.is_alphanumeric() || "_&*:<>".contains(c))
    };
    let in_rust = part.split_once(": ").is_some_and(|(name, kind)| is_path(name) && is_path(kind));
    in_rust
        || part.rsplit_once(' ').is_some_and(|(kind, name)| {
            is_path(kind.split_whitespace().last().unwrap_or_default()) && is_path(name)
        })
}

/// Of versions 1 to 3: the viewport has the ratio that is given, and stands at the last number.
fn constructed(code: &Code, call: Piece, notes: &mut Vec<String>) -> Result<Camera, FileError> {
    let parts = split(call);
    let [eye, at, up, vfov, ratio, ref rest @ ..] = parts[..] else {
        let right = "it must be lookfrom, lookat, vup, vfov, aspect_ratio, aperture, focus_dist";
        return Err(code.fault("camera", call, right));
    };
    let eye = code.vector("lookfrom", eye)?;
    let at = code.vector("lookat", at)?;
    let up = code.vector("vup", up)?;
    let vfov = angle(code, code.number("vfov", vfov)?, Some(vfov))?;
    let aspect = code.number("aspect_ratio", ratio)?;
    if aspect <= 0.0 {
        return Err(code.fault("aspect_ratio", ratio, "it must be greater than 0"));
    }
    if rest.first().is_some_and(|aperture| number_of(*aperture) != Some(0.0)) {
        notes.push("aperture is left out: a pinhole is sharp everywhere".to_owned());
    }
    let distance = match rest.get(1) {
        Some(piece) => focus(code, *piece, (at - eye).length())?,
        // The first edition's camera has its viewport there.
        None => 1.0,
    };
    let named = |names: [&str; 3]| -> Option<Piece> {
        names.iter().find_map(|name| given(code, name).ok().flatten())
    };
    let width_given = named(["image_width", "IMAGE_WIDTH", "nx"]);
    let width = match width_given {
        Some(piece) => code.number("image_width", piece)?,
        None => {
            notes.push("image_width is not in the text: 400 taken".to_owned());
            400.0
        }
    };
    // Mostly it is made of the width, by a cast that is no number here.
    let height = named(["image_height", "IMAGE_HEIGHT", "ny"]);
    let height = height.and_then(|piece| code.number("image_height", piece).ok());
    let image = match height {
        Some(height) => image_of(width, height)
            .map_err(|right| code.fault("image_width", width_given.unwrap_or(call), &right))?,
        None => image(code, width, aspect, width_given)?,
    };
    let high = extent(vfov, distance);
    let viewport = Viewport { width: in_ratio(high, aspect), height: high, distance };
    Ok(Camera { eye, orientation: Orientation::At { at, up }, viewport, image })
}

/// The last argument, which may be the way from one point to the other.
fn focus(code: &Code, piece: Piece, way: f64) -> Result<f64, FileError> {
    let text = match code.given(piece.text.trim()) {
        crate::exchange::names::Given::Once(value) => value.text,
        _ => piece.text,
    };
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let plain = plain.replace('&', "");
    if ["(lookfrom-lookat).length()", "(lookat-lookfrom).length()"].contains(&plain.as_str()) {
        return Ok(way);
    }
    let distance = code.number("focus_dist", piece)?;
    let is_far = distance > 0.0;
    is_far
        .then_some(distance)
        .ok_or_else(|| code.fault("focus_dist", piece, "it must be greater than 0"))
}

fn sphere(code: &Code, call: Piece) -> Result<Item<Sphere>, FileError> {
    let parts = split(call);
    let [center, radius, ..] = parts[..] else {
        return Err(code.fault("sphere", call, "it must have a centre and a radius"));
    };
    let center = code.vector("sphere centre", trimmed(center))?;
    let radius_value = code.number("sphere radius", radius)?;
    if radius_value <= 0.0 {
        return Err(code.fault("sphere radius", radius, "it must be greater than 0"));
    }
    let color = code.calls_in(call, "color").first().and_then(|color| {
        let [r, g, b] = code.numbers("color", *color).ok()?.try_into().ok()?;
        Some([r, g, b].map(crate::exchange::sheet::byte_of_light))
    });
    Ok(Item { name: None, color, shape: Sphere { center, radius: radius_value } })
}
