//! A camera of react-three-fiber: `<Canvas camera={{ position: [0, 2, 5], fov: 75 }}>`, or drei's
//! `<PerspectiveCamera makeDefault position={[0, 2, 5]} />`.

use pinhole_core::{Camera, DVec3};

use super::code::{Lens, taken};
use super::stand::Stand;
use crate::exchange::Taken;
use crate::exchange::code::{Code, Piece, after_spaces, split, trimmed, words};
use crate::formats::FileError;

const TAG: &str = "<PerspectiveCamera";

pub(super) fn claims(text: &str) -> bool {
    text.contains(TAG) || (text.contains("<Canvas") && text.contains("camera={"))
}

pub(super) fn read(code: &Code, at_hand: &Camera) -> Result<Taken, FileError> {
    let mut notes = Vec::new();
    let cameras = tags(code, TAG);
    let drei: Vec<Piece> = match cameras.len() {
        1 => cameras,
        _ => cameras.into_iter().filter(|tag| !words(*tag, "makeDefault").is_empty()).collect(),
    };
    if let [_, second, ..] = drei[..] {
        let right = "one of several cameras with makeDefault: leave in one";
        return Err(code.fault("PerspectiveCamera", second, right));
    }
    let canvas = tags(code, "<Canvas")
        .into_iter()
        .find_map(|tag| property(code, tag, "camera").and_then(|value| code.bracketed(value)));
    // What three.js and react-three-fiber have where nothing is given.
    let (fields, mut lens, start, looks) = match (drei.first(), canvas) {
        (Some(tag), _) => {
            let lens = Lens { fov: 50.0, aspect: Ok(at_hand.image.aspect()) };
            (Fields::Tag(*tag), lens, DVec3::ZERO, false)
        }
        (None, Some(object)) => {
            let lens = Lens { fov: 75.0, aspect: Ok(at_hand.image.aspect()) };
            (Fields::Object(object), lens, DVec3::new(0.0, 0.0, 5.0), true)
        }
        (None, None) => {
            let right = "it must be given, as camera={{ position: [0, 0, 5], fov: 75 }}";
            return Err(code.missing("camera", right));
        }
    };
    for name in ["rotation", "quaternion", "lookAt", "onUpdate", "matrix", "args", "manual"] {
        if let Some(value) = fields.get(code, name) {
            let right = "this is not read: the camera must be given by position, fov, zoom and up";
            return Err(code.fault(name, value, right));
        }
    }
    let (Fields::Tag(text) | Fields::Object(text)) = fields;
    for part in ["position-", "rotation-", "up-", "..."] {
        if let Some(at) = text.text.find(part) {
            let piece = Piece { text: part, at: text.at + at };
            return Err(code.fault(
                "a property of the camera",
                piece,
                "it must be position={[x, y, z]}",
            ));
        }
    }
    let vector = |name: &str, or: DVec3| -> Result<DVec3, FileError> {
        fields.get(code, name).map_or(Ok(or), |value| code.vector(name, value))
    };
    let mut stand = Stand::at(vector("position", start)?);
    stand.set_up(vector("up", DVec3::Y)?);
    match fields.get(code, "fov") {
        Some(fov) => lens.set_fov(code, fov)?,
        None => notes.push(format!("fov is not in the text: {} taken", lens.fov)),
    }
    if let Some(value) = fields.get(code, "zoom") {
        stand.zoom = code.number("zoom", value)?;
        if stand.zoom <= 0.0 {
            return Err(code.fault("zoom", value, "it must be greater than 0"));
        }
    }
    let orbit = ["OrbitControls", "MapControls"]
        .into_iter()
        .find_map(|kind| tags(code, &format!("<{kind}")).first().map(|tag| (kind, *tag)));
    match orbit {
        Some((kind, tag)) => {
            let target = property(code, tag, "target");
            let target = target.map_or(Ok(DVec3::ZERO), |value| code.vector("target", value))?;
            stand.orbit(target, kind, &mut notes);
        }
        None if looks => {
            stand.look_at(DVec3::ZERO, &mut notes);
            notes.push("react-three-fiber turns the camera to (0, 0, 0)".to_owned());
        }
        None => (),
    }
    if !code.calls("useFrame").is_empty() {
        notes.push("what useFrame does later is left out".to_owned());
    }
    Ok(taken(&lens, &stand, None, at_hand, notes))
}

/// Where the camera's properties stand.
enum Fields<'t> {
    Tag(Piece<'t>),
    Object(Piece<'t>),
}

impl<'t> Fields<'t> {
    fn get(&self, code: &Code, name: &str) -> Option<Piece<'t>> {
        match self {
            Fields::Tag(tag) => property(code, *tag, name),
            Fields::Object(object) => {
                let object = code.bracketed(trimmed(*object)).unwrap_or(*object);
                split(object).into_iter().find_map(|part| {
                    let (before, _) = part.text.split_once(':')?;
                    let value = part.from(before.len() + 1);
                    (before.trim() == name).then(|| trimmed(value))
                })
            }
        }
    }
}

/// What stands in each tag that begins so, up to its end.
fn tags<'t>(code: &'t Code, start: &str) -> Vec<Piece<'t>> {
    const MOST: usize = 10;
    let whole = code.whole();
    let found = whole.text.match_indices(start).map(|(at, _)| whole.from(at + start.len()));
    let found = found.filter(|rest| !rest.text.starts_with(char::is_alphanumeric)).take(MOST);
    found
        .map(|rest| {
            let mut depth = 0_i32;
            let end = rest.text.char_indices().find(|(_, c)| {
                match c {
                    '{' | '(' | '[' => depth += 1,
                    '}' | ')' | ']' => depth -= 1,
                    _ => (),
                }
                depth <= 0 && *c == '>'
            });
            Piece { text: &rest.text[..end.map_or(rest.text.len(), |(at, _)| at)], ..rest }
        })
        .collect()
}

/// What stands in the braces of `name={...}`.
fn property<'t>(code: &Code, tag: Piece<'t>, name: &str) -> Option<Piece<'t>> {
    words(tag, name).into_iter().find_map(|at| {
        let rest = after_spaces(tag.from(at + name.len()));
        let value = after_spaces(rest.from(rest.text.strip_prefix('=').map(|_| 1)?));
        code.bracketed(value).map(trimmed)
    })
}
