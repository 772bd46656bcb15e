//! A camera that is aimed: `(target - camera.location).to_track_quat('-Z', 'Y').to_euler()`.

use pinhole_core::DVec3;

use super::parts::{is_active, is_path, plain};
use super::stance::Stance;
use super::things::{Chosen, Deed, Things};
use crate::exchange::affine::Affine;
use crate::exchange::code::{Code, Piece, trimmed};
use crate::exchange::names::{Given, MOST_ASSIGNMENTS};
use crate::exchange::python::Verb;
use crate::formats::FileError;

impl Stance<'_, '_> {
    /// The rotation of a camera that is aimed at a point.
    pub(super) fn aimed(&mut self, part: &str, deed: &Deed) -> Result<Option<Affine>, FileError> {
        if !part.is_empty() || deed.verb != Verb::Give {
            return Ok(None);
        }
        // Each one that is followed takes passes over the text.
        const MOST_FOLLOWED: usize = 100;
        let is_followed = is_path(deed.value.text) || deed.value.text.contains(".to_");
        self.followed += usize::from(is_followed);
        if !is_followed {
            return Ok(None);
        }
        if self.followed > MOST_FOLLOWED {
            let right = "the camera is turned too often: it must be given once";
            return Err(self.code.fault("the camera's turn", deed.value, right));
        }
        let found = aim(self.code, self.things, self.chosen, deed.value, self.location)?;
        let Some(Aim { turn, at }) = found else { return Ok(None) };
        let is_located = self.chosen.is_made || self.located == [true; 3];
        if at < self.placed_at || !is_located {
            let right = "the camera's location must be given before it is aimed from there";
            return Err(self.code.fault("the camera's aim", deed.value, right));
        }
        self.is_aimed = true;
        Ok(Some(turn))
    }
}

/// How the camera is turned, and where the text reckons the way to its target.
struct Aim {
    turn: Affine,
    at: usize,
}

/// `None` where the value is no such thing. Blender turns the camera so that its y is as near to the
/// world's z as can be.
fn aim(
    code: &Code,
    things: &Things,
    chosen: &Chosen,
    value: Piece,
    location: DVec3,
) -> Result<Option<Aim>, FileError> {
    let mut quaternion = followed(code, value);
    for ending in [".to_euler()", ".to_euler('XYZ')", ".to_euler(\"XYZ\")"] {
        if let Some(text) = quaternion.text.strip_suffix(ending) {
            quaternion = followed(code, Piece { text, ..quaternion });
        }
    }
    const TRACK: &str = ".to_track_quat(";
    let Some((way, rest)) = quaternion.text.rsplit_once(TRACK) else { return Ok(None) };
    let axes = rest.strip_suffix(')').map(plain);
    let sign = match axes.as_deref() {
        Some("'-Z','Y'") => 1.0,
        Some("'Z','Y'") => -1.0,
        _ => {
            let right = "it must be to_track_quat('-Z', 'Y'): the camera looks along its -z, y up";
            return Err(code.fault("the camera's aim", quaternion, right));
        }
    };
    let way = followed(code, Piece { text: way, ..quaternion });
    let right = "it must be a point less the camera's location";
    let (from, to) = difference(way).ok_or_else(|| code.fault("the way", way, right))?;
    // A name that is given again may have been another thing's here.
    let is_one = |name: &str| {
        let found = code.assignments(name);
        let whole = found.iter().filter(|a| a.owner.is_empty() && a.value.is_some());
        found.len() < MOST_ASSIGNMENTS && whole.count() == 1
    };
    let is_own = |piece: Piece| {
        let head = piece.text.strip_suffix(".location").filter(|head| !is_active(head));
        let known = head.filter(|head| !is_path(head) || head.contains('.') || is_one(head));
        known.is_some_and(|head| chosen.camera.contains(&things.path_of(&plain(head))))
    };
    let way_at = match (is_own(from), is_own(to)) {
        (true, false) => code.vector("the target", to)? - location,
        (false, true) => location - code.vector("the target", from)?,
        _ => return Err(code.fault("the way", way, right)),
    };
    let z = (-sign * way_at).try_normalize();
    let turn = z.and_then(|z| {
        // Nearer to the vertical Blender's own single precision has a say in it.
        let x = DVec3::Z.cross(z);
        let x = (x.length() > 1e-4).then(|| x.normalize())?;
        Some(Affine { x, y: z.cross(x), z, at: DVec3::ZERO })
    });
    let right = "it must be neither nothing nor straight up or down: y has no way up there";
    let turn = turn.ok_or_else(|| code.fault("the way", way, right))?;
    Ok(Some(Aim { turn, at: way.at }))
}

/// What a name stands for, without the brackets round it.
fn followed<'t>(code: &'t Code, piece: Piece<'t>) -> Piece<'t> {
    const LONGEST_CHAIN: usize = 4;
    let mut piece = trimmed(piece);
    for _ in 0..LONGEST_CHAIN {
        if !is_path(piece.text) {
            break;
        }
        let Given::Once(value) = code.given(piece.text) else { break };
        piece = trimmed(value);
    }
    match code.bracketed(piece) {
        Some(inside) if inside.text.len() + 2 == piece.text.len() => trimmed(inside),
        _ => piece,
    }
}

/// Of `b - a` the one that is taken off, and the other.
fn difference(piece: Piece) -> Option<(Piece, Piece)> {
    let mut depth = 0_i32;
    let mut signs = piece.text.char_indices().filter(|(_, c)| {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => (),
        }
        depth == 0 && "+-*/@%".contains(*c)
    });
    let (Some((at, '-')), None) = (signs.next(), signs.next()) else { return None };
    let to = trimmed(Piece { text: &piece.text[..at], ..piece });
    Some((trimmed(piece.from(at + 1)), to))
}
