//! Where a Blender program's statements leave the camera, and how they leave it turned.

use pinhole_core::{Basis, DVec3};

use super::parts::{euler, missing, parted, printed, rows, turned};
use super::passed::is_only_read;
use super::things::{Chosen, Deed, Things};
use crate::exchange::affine::Affine;
use crate::exchange::code::{Code, Piece, split, trimmed};
use crate::exchange::python::{Block, Verb};
use crate::formats::FileError;

/// The orders in which Blender turns about its axes, and in which of these about which: the first
/// letter's turn comes first.
const ORDERS: [&str; 6] = ["XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"];

/// What gives the camera its rotation.
enum Turn {
    /// Angles about x, y and z, and which of them are given.
    Angles(DVec3, [bool; 3]),
    /// The rotation of a matrix or of a quaternion.
    By(Affine),
}

pub(super) struct Stance<'c, 't> {
    pub(super) code: &'c Code<'t>,
    pub(super) things: &'c Things<'c>,
    pub(super) chosen: &'c Chosen,
    /// Where the text gives the camera its place last.
    pub(super) placed_at: usize,
    pub(super) is_aimed: bool,
    pub(super) followed: usize,
    pub(super) location: DVec3,
    pub(super) located: [bool; 3],
    mode: Option<String>,
    turn: Turn,
    quaternion: Option<Affine>,
}

/// The camera's frame in the world.
pub(super) fn frame<'c>(
    code: &'c Code<'c>,
    things: &'c Things<'c>,
    chosen: &'c Chosen,
    notes: &mut Vec<String>,
) -> Result<Affine, FileError> {
    let turn = Turn::Angles(DVec3::ZERO, [false; 3]);
    let mut stance = Stance {
        code,
        things,
        chosen,
        placed_at: 0,
        is_aimed: false,
        followed: 0,
        location: DVec3::ZERO,
        located: [false; 3],
        mode: None,
        turn,
        quaternion: None,
    };
    let mut given_perhaps = None;
    let mut seen: Vec<String> = Vec::new();
    for deed in &things.deeds {
        let own = chosen.camera.iter().find_map(|name| deed.path.strip_prefix(name.as_str()));
        let Some(path) = own.filter(|path| path.starts_with('.')) else { continue };
        if !stance.take(path, deed)? {
            continue;
        }
        match deed.block {
            Block::Often => {
                let right = "it is done in a loop: the camera must be given by numbers once";
                return Err(code.fault(path.trim_start_matches('.'), deed.value, right));
            }
            Block::Perhaps => given_perhaps = Some(deed),
            Block::Always => (),
        }
        if let Some(perhaps) = given_perhaps.filter(|_| seen.iter().any(|before| before == path)) {
            let right = "it is given in an if, and more than once: leave in one";
            return Err(code.fault(path.trim_start_matches('.'), perhaps.value, right));
        }
        if seen.len() < 100 {
            seen.push(path.to_owned());
        }
    }
    if given_perhaps.is_some() {
        notes.push("what stands in an if is taken as done".to_owned());
    }
    stance.frame(chosen, notes)
}

impl Stance<'_, '_> {
    /// Whether it changes the place or the turn.
    fn take(&mut self, path: &str, deed: &Deed) -> Result<bool, FileError> {
        let (property, part) = parted(path);
        let is_place = matches!(property, "added" | "location") || property.starts_with("matrix_");
        if is_place && !matches!(deed.verb, Verb::Say | Verb::Return) || property == "added" {
            self.placed_at = deed.value.at;
            if self.is_aimed {
                let right = "the camera is aimed before: its place must be given first";
                return Err(self.code.fault(property, deed.value, right));
            }
        }
        match property {
            "added" => self.added(deed)?,
            "location" => {
                let mut location = (self.location, self.located);
                self.vector("location", part, deed, &mut location)?;
                (self.location, self.located) = location;
            }
            "rotation_euler" => self.rotation_euler(part, deed)?,
            "rotation_quaternion" => self.rotation_quaternion(part, deed)?,
            "rotation_mode" => self.set_mode(part, deed)?,
            "matrix_world" | "matrix_local" | "matrix_basis" => {
                self.matrix(property, part, deed)?
            }
            "scale" => {
                let scale = self.code.vector("scale", self.whole("scale", part, deed)?)?;
                if scale.min_element() <= 0.0 {
                    let right = "it must be greater than 0";
                    return Err(self.code.fault("scale", deed.value, right));
                }
                return Ok(false);
            }
            "passed" if is_only_read(self.code, deed.value, part.trim_matches(['[', ']'])) => {
                return Ok(false);
            }
            "passed" => {
                let right = "it may move or turn the camera that it is given: the camera must be \
                             given by matrix_world, or by location and rotation_euler alone";
                return Err(self.code.fault("the call", deed.value, right));
            }
            property
                if property.starts_with("keyframe_insert")
                    || property.starts_with("driver_add") =>
            {
                let right = "the camera moves with the frames: it must be given once, without \
                             keyframes";
                return Err(self.code.fault("the camera's motion", deed.value, right));
            }
            "constraints"
            | "ops"
            | "parent"
            | "delta_location"
            | "delta_rotation_euler"
            | "delta_rotation_quaternion"
            | "rotation_axis_angle"
            | "matrix_parent_inverse"
            | "track_axis" => {
                if deed.verb == Verb::Give
                    && (deed.value.text == "None" || deed.value.text.starts_with('<'))
                {
                    return Ok(false);
                }
                let right = "this moves or turns the camera: it must be given by matrix_world, or by \
                             location and rotation_euler alone";
                return Err(self.code.fault(property, deed.value, right));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The value, where the whole property is given at once.
    fn whole<'p>(&self, name: &str, part: &str, deed: &Deed<'p>) -> Result<Piece<'p>, FileError> {
        let is_whole = deed.verb == Verb::Give && ["", "[:]", ".xyz"].contains(&part);
        let right = "it must be given at once, by numbers";
        is_whole.then_some(deed.value).ok_or_else(|| self.code.fault(name, deed.value, right))
    }

    /// `camera_add(location=..., rotation=...)`.
    fn added(&mut self, deed: &Deed) -> Result<(), FileError> {
        let code = self.code;
        let open = deed.value.text.find('(').map_or(0, |at| at + 1);
        let inside = deed.value.from(open);
        let inside = Piece { text: inside.text.strip_suffix(')').unwrap_or(inside.text), ..inside };
        let parts = split(inside);
        let argument = |name: &str| {
            parts.iter().find_map(|part| {
                let (before, _) = part.text.split_once('=')?;
                (before.trim() == name).then(|| trimmed(part.from(before.len() + 1)))
            })
        };
        if let Some(piece) = argument("location") {
            self.location = code.vector("location", piece)?;
        }
        self.located = [true; 3];
        match (argument("rotation"), argument("align")) {
            (Some(piece), _) => {
                self.turn = Turn::Angles(code.vector("rotation", printed(piece))?, [true; 3]);
            }
            (None, Some(align)) if align.text.contains("VIEW") => {
                let right = "the camera must be turned by rotation=(...)";
                return Err(code.fault("align", align, right));
            }
            _ => self.turn = Turn::Angles(DVec3::ZERO, [true; 3]),
        }
        Ok(())
    }

    fn rotation_euler(&mut self, part: &str, deed: &Deed) -> Result<(), FileError> {
        let code = self.code;
        if let Some(turn) = self.aimed(part, deed)? {
            if self.mode.as_deref().is_some_and(|mode| mode != "XYZ") {
                let right = "its angles are of the order XYZ: rotation_mode must be XYZ";
                return Err(code.fault("rotation_euler", deed.value, right));
            }
            self.turn = Turn::By(turn);
            return Ok(());
        }
        let before = match &self.turn {
            Turn::Angles(angles, given) => (*angles, *given),
            Turn::By(_) if part.is_empty() && deed.verb == Verb::Give => (DVec3::ZERO, [false; 3]),
            Turn::By(_) => {
                let right = "the camera is turned by a matrix already: it must be given at once";
                return Err(code.fault("rotation_euler", deed.value, right));
            }
        };
        if part.is_empty() && deed.verb == Verb::Give {
            // Its own order is no matter: what counts is the object's rotation_mode.
            let (angles, order) = euler(printed(deed.value));
            let mode = self.mode.as_deref().unwrap_or("XYZ");
            if let Some(order) = order.filter(|order| order.text.trim_matches(['\'', '"']) != mode)
            {
                let right = format!("it must be the order of rotation_mode, {mode}");
                return Err(code.fault("Euler's order", order, &right));
            }
            self.turn = Turn::Angles(code.vector("rotation_euler", angles)?, [true; 3]);
            return Ok(());
        }
        let mut turned = before;
        self.vector("rotation_euler", part, deed, &mut turned)?;
        self.turn = Turn::Angles(turned.0, turned.1);
        Ok(())
    }

    fn rotation_quaternion(&mut self, part: &str, deed: &Deed) -> Result<(), FileError> {
        if let Some(turn) = self.aimed(part, deed)? {
            self.quaternion = Some(turn);
            return Ok(());
        }
        let piece = self.whole("rotation_quaternion", part, deed)?;
        let numbers = self.code.numbers("rotation_quaternion", printed(piece))?;
        let q: Option<[f64; 4]> = numbers.try_into().ok();
        let turn = q.and_then(Basis::of_quaternion);
        let right = "it must be four numbers w, x, y, z";
        let turn = turn.ok_or_else(|| self.code.fault("rotation_quaternion", piece, right))?;
        let at = DVec3::ZERO;
        self.quaternion = Some(Affine { x: turn.u, y: turn.v, z: turn.w, at });
        Ok(())
    }

    /// A vector that is given at once, by parts, or is added to.
    fn vector(
        &self,
        name: &str,
        part: &str,
        deed: &Deed,
        into: &mut (DVec3, [bool; 3]),
    ) -> Result<(), FileError> {
        let code = self.code;
        let index = match part {
            "" | "[:]" | ".xyz" => None,
            ".x" | "[0]" => Some(0),
            ".y" | "[1]" => Some(1),
            ".z" | "[2]" => Some(2),
            _ => {
                let right = "this is not read: it must be given by numbers";
                return Err(code.fault(&format!("{name}{part}"), deed.value, right));
            }
        };
        let sign = match deed.verb {
            Verb::Give => 0.0,
            Verb::Change('+') => 1.0,
            Verb::Change('-') => -1.0,
            // It is only asked for.
            Verb::Say | Verb::Return | Verb::Define => return Ok(()),
            Verb::Change(_) => {
                let right = "this is not read: it must be given by numbers";
                return Err(code.fault(name, deed.value, right));
            }
        };
        let (vector, given) = into;
        match index {
            Some(k) => {
                let number = code.number(name, deed.value)?;
                vector[k] = if sign == 0.0 { number } else { vector[k] + sign * number };
                given[k] |= sign == 0.0;
            }
            None => {
                let value = code.vector(name, printed(deed.value))?;
                *vector = if sign == 0.0 { value } else { *vector + sign * value };
                *given = if sign == 0.0 { [true; 3] } else { *given };
            }
        }
        Ok(())
    }

    /// Blender keeps the rotation where it goes over to quaternions, and the angles where it goes over
    /// to another order.
    fn set_mode(&mut self, part: &str, deed: &Deed) -> Result<(), FileError> {
        let piece = self.whole("rotation_mode", part, deed)?;
        let mode = piece.text.trim_matches(['\'', '"']);
        if mode == "QUATERNION" {
            if self.mode.as_deref() != Some(mode) && self.quaternion.is_some() {
                let right = "it must stand before rotation_quaternion: here Blender makes one of the angles";
                return Err(self.code.fault("rotation_mode", piece, right));
            }
            self.quaternion = self.quaternion.or(self.by_angles());
        } else if !ORDERS.contains(&mode) {
            let right = "it must be QUATERNION, or one of XYZ, XZY, YXZ, YZX, ZXY, ZYX";
            return Err(self.code.fault("rotation_mode", piece, right));
        }
        if self.is_aimed && !["QUATERNION", "XYZ"].contains(&mode) {
            let right = "it must stand before the camera is aimed";
            return Err(self.code.fault("rotation_mode", piece, right));
        }
        self.mode = Some(mode.to_owned());
        Ok(())
    }

    fn matrix(&mut self, name: &str, part: &str, deed: &Deed) -> Result<(), FileError> {
        let code = self.code;
        if matches!(deed.verb, Verb::Say | Verb::Return) {
            return Ok(());
        }
        let piece = self.whole(name, part, deed)?;
        let numbers = match piece.text.starts_with('<') {
            true => rows(code, name, piece)?,
            false => code.numbers(name, piece)?,
        };
        let right = "it must be four rows of four numbers, the last one 0, 0, 0, 1";
        let affine = Affine::of_rows(&numbers).ok_or_else(|| code.fault(name, piece, right))?;
        (self.location, self.located) = (affine.at, [true; 3]);
        self.turn = Turn::By(Affine { at: DVec3::ZERO, ..affine });
        let is_kept = self.mode.as_deref() == Some("QUATERNION");
        self.quaternion = is_kept.then_some(Affine { at: DVec3::ZERO, ..affine });
        Ok(())
    }

    /// The rotation by angles, where any is given.
    fn by_angles(&self) -> Option<Affine> {
        let (angles, given) = match &self.turn {
            Turn::By(affine) => return Some(*affine),
            Turn::Angles(angles, given) => (angles, given),
        };
        let order = self.mode.as_deref().filter(|mode| ORDERS.contains(mode)).unwrap_or("XYZ");
        given.contains(&true).then(|| turned(*angles, order))
    }

    fn frame(&self, chosen: &Chosen, notes: &mut Vec<String>) -> Result<Affine, FileError> {
        let code = self.code;
        let is_located = self.located.contains(&true);
        if !is_located && !chosen.is_made {
            let right = "the camera must be given by it, or by location and rotation_euler";
            return Err(code.missing("matrix_world", right));
        }
        if is_located && !chosen.is_made {
            let axes: Vec<&str> = missing(self.located).collect();
            if !axes.is_empty() {
                notes.push(format!("location.{} is not in the text: 0 taken", axes.join(", ")));
            }
        } else if !is_located {
            notes.push("location is not in the text: (0, 0, 0) taken".to_owned());
        }
        let angles = self.by_angles();
        let turned = match (self.mode.as_deref(), self.quaternion, angles) {
            (Some("QUATERNION"), Some(turned), _) => turned,
            (Some("QUATERNION"), None, _) => {
                let right = "rotation_mode is QUATERNION: it must be given";
                return Err(code.missing("rotation_quaternion", right));
            }
            (None, Some(_), Some(_)) => {
                let right = "it must say which of rotation_euler and rotation_quaternion counts";
                return Err(code.missing("rotation_mode", right));
            }
            (None, Some(turned), None) => {
                notes.push("rotation_mode is not in the text: QUATERNION taken".to_owned());
                turned
            }
            (_, _, Some(turned)) => {
                if let Turn::Angles(_, given) = self.turn
                    && !chosen.is_made
                {
                    let axes: Vec<&str> = missing(given).collect();
                    if !axes.is_empty() {
                        let axes = axes.join(", ");
                        notes.push(format!("rotation_euler.{axes} is not in the text: 0 taken"));
                    }
                }
                turned
            }
            (_, _, None) => {
                notes.push("rotation_euler is not in the text: (0, 0, 0) taken".to_owned());
                Affine::IDENTITY
            }
        };
        Ok(Affine { at: self.location, ..turned })
    }
}
