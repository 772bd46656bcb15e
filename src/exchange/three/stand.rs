//! Where the statements of a three.js program leave the camera, and how they leave it turned.

use pinhole_core::{DVec3, Orientation};

use super::steps::{Step, Verb, is_question};
use crate::exchange::code::{Code, Piece};
use crate::exchange::sheet::commas;
use crate::formats::FileError;

/// As three.js makes it, and then as the statements leave it.
pub(super) struct Stand {
    pub(super) position: DVec3,
    up: DVec3,
    /// Euler's angles, in the order XYZ.
    rotation: DVec3,
    pub(super) zoom: f64,
    turned: Option<Turned>,
}

/// The last turn: from where to where, where it is to a point; along what, and with which up.
#[derive(Clone, Copy)]
struct Turned {
    points: Option<[DVec3; 2]>,
    view: DVec3,
    up: DVec3,
}

impl Default for Stand {
    fn default() -> Stand {
        Stand {
            position: DVec3::ZERO,
            up: DVec3::Y,
            rotation: DVec3::ZERO,
            zoom: 1.0,
            turned: None,
        }
    }
}

impl Stand {
    pub(super) fn at(position: DVec3) -> Stand {
        Stand { position, ..Stand::default() }
    }

    pub(super) fn set_up(&mut self, up: DVec3) {
        self.up = up;
    }

    pub(super) fn step(
        &mut self,
        code: &Code,
        step: &Step,
        notes: &mut Vec<String>,
    ) -> Result<(), FileError> {
        let (path, values) = (step.path.as_str(), step.values);
        if is_question(path) && step.verb == Verb::Call {
            return Ok(());
        }
        if let Some(rest) = path.strip_prefix(".position") {
            return changed(code, "position", rest, step, &mut self.position);
        }
        if let Some(rest) = path.strip_prefix(".up").filter(|rest| !rest.starts_with('d')) {
            return changed(code, "up", rest, step, &mut self.up);
        }
        match (path, step.verb) {
            (".zoom", verb) if verb != Verb::Call => {
                let zoom = number_after(code, "zoom", step, self.zoom)?;
                if zoom <= 0.0 {
                    return Err(code.fault("zoom", values, "it must be greater than 0"));
                }
                self.zoom = zoom;
            }
            (".lookAt", Verb::Call) => {
                // Where a scene's position is not set, it is the origin.
                let at = match values.text.trim() {
                    "scene.position" | "this.scene.position" => DVec3::ZERO,
                    _ => code.vector("lookAt", values)?,
                };
                self.look_at(at, notes);
            }
            (".rotation.x" | ".rotation.y" | ".rotation.z" | ".rotation.set", _)
                if self.turned.is_none_or(|turned| turned.points.is_none()) =>
            {
                changed(code, "rotation", &path[".rotation".len()..], step, &mut self.rotation)?;
                self.rotate();
            }
            (other, _) if turns(other) => {
                let right = instead_of(other);
                return Err(code.fault(other.trim_start_matches('.'), values, right));
            }
            _ => (),
        }
        Ok(())
    }

    /// By Euler's angles: about the camera's x, then its y, then its z.
    fn rotate(&mut self) {
        let (x, y, z) = (self.rotation.x, self.rotation.y, self.rotation.z);
        let turned = |v: DVec3| {
            let (s, c) = z.sin_cos();
            let v = DVec3::new(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
            let (s, c) = y.sin_cos();
            let v = DVec3::new(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
            let (s, c) = x.sin_cos();
            DVec3::new(v.x, c * v.y - s * v.z, s * v.y + c * v.z)
        };
        let (view, up) = (turned(DVec3::NEG_Z), turned(DVec3::Y));
        self.turned = Some(Turned { points: None, view, up });
    }

    /// As three.js does it, also where it stands at the point, or looks along up.
    pub(super) fn look_at(&mut self, at: DVec3, notes: &mut Vec<String>) {
        let (from, up) = (self.position, self.up);
        let view = match (at - from).try_normalize() {
            None => {
                notes.push(format!(
                    "lookAt: the camera stands at ({}) itself when it is turned there: as in \
                     three.js it looks along (0, 0, -1)",
                    commas(at)
                ));
                DVec3::NEG_Z
            }
            Some(view) if up.cross(view) == DVec3::ZERO => {
                notes.push(
                    "up is parallel to where the camera looks: three.js turns it away by 0.0001, \
                     and so is done here"
                        .to_owned(),
                );
                match up.z.abs() == 1.0 {
                    true => view - DVec3::new(1e-4, 0.0, 0.0),
                    false => view - DVec3::new(0.0, 0.0, 1e-4),
                }
            }
            Some(_) => at - from,
        };
        self.turned = Some(Turned { points: Some([from, at]), view, up });
    }

    /// Orbit controls turn the camera to their target, wherever it looked before; they keep it a little
    /// off the pole.
    pub(super) fn orbit(&mut self, at: DVec3, kind: &str, notes: &mut Vec<String>) {
        const OFF: f64 = 1e-6;
        let off = self.position - at;
        let is_orbit = ["OrbitControls", "MapControls"].contains(&kind);
        if is_orbit && self.up == DVec3::Y && off.x == 0.0 && off.z == 0.0 && off.y != 0.0 {
            let radius = off.y.abs();
            self.position = at + DVec3::new(0.0, off.y * OFF.cos(), radius * OFF.sin());
            notes.push(format!("{kind} keep the camera {OFF} radians off the pole"));
        }
        self.look_at(at, notes);
        notes.push(format!("{kind} turn the camera to their target, ({})", commas(at)));
    }

    /// A camera that is moved after it was turned looks the same way from elsewhere.
    pub(super) fn orientation(&self, notes: &mut Vec<String>) -> Orientation {
        let Some(Turned { points, view, up }) = self.turned else {
            return Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y };
        };
        let Some([from, at]) = points else { return Orientation::View { view, up } };
        if from == self.position && view == at - from {
            return Orientation::At { at, up };
        }
        if from != self.position {
            let note =
                "position is set after lookAt, which had turned the camera from where it was";
            notes.push(note.to_owned());
        }
        Orientation::View { view, up }
    }
}

/// Whether a statement may change the picture.
pub(super) fn moves(path: &str) -> bool {
    let words = [".position", ".up", ".lookAt", ".zoom", ".fov"];
    let is_update = path.starts_with(".upd");
    !is_question(path) && !is_update && (turns(path) || words.iter().any(|w| path.starts_with(w)))
}

/// A vector after `.set(...)`, `.x = ...`, `.copy(...)` and their like.
pub(super) fn changed(
    code: &Code,
    name: &str,
    rest: &str,
    step: &Step,
    vector: &mut DVec3,
) -> Result<(), FileError> {
    let values = step.values;
    if is_question(rest) && step.verb == Verb::Call {
        return Ok(());
    }
    let field = format!("{name}{rest}");
    match (rest, step.verb) {
        ("", Verb::Give) | (".set" | ".copy" | ".fromArray", Verb::Call) => {
            *vector = code.vector(name, values)?;
        }
        (".x" | ".y" | ".z", Verb::Give | Verb::Change(_)) => {
            let part = part_of(vector, rest);
            *part = number_after(code, &field, step, *part)?;
        }
        (".setX" | ".setY" | ".setZ", Verb::Call) => {
            *part_of(vector, &rest.to_ascii_lowercase().replace("set", "")) =
                code.number(&field, values)?;
        }
        (".setScalar", Verb::Call) => *vector = DVec3::splat(code.number(&field, values)?),
        (".add", Verb::Call) => *vector += code.vector(&field, values)?,
        (".sub", Verb::Call) => *vector -= code.vector(&field, values)?,
        (".multiplyScalar", Verb::Call) => *vector *= code.number(&field, values)?,
        // Nothing is done to what is only part of something else.
        _ => {
            let right = "this is not read: it must be given by set(x, y, z)";
            return Err(code.fault(&field, values, right));
        }
    }
    Ok(())
}

fn part_of<'v>(vector: &'v mut DVec3, name: &str) -> &'v mut f64 {
    match name {
        ".x" => &mut vector.x,
        ".y" => &mut vector.y,
        _ => &mut vector.z,
    }
}

/// A number after `= 2` or `+= 2`.
pub(super) fn number_after(
    code: &Code,
    field: &str,
    step: &Step,
    before: f64,
) -> Result<f64, FileError> {
    let number = |piece: Piece| code.number(field, piece);
    Ok(match step.verb {
        Verb::Change('+') => before + number(step.values)?,
        Verb::Change('-') => before - number(step.values)?,
        Verb::Change('*') => before * number(step.values)?,
        Verb::Change('/') => before / number(step.values)?,
        Verb::Give => number(step.values)?,
        _ => {
            return Err(code.fault(
                field,
                step.values,
                "this is not read: it must be = and a number",
            ));
        }
    })
}

/// What must be written in the place of a statement that is not taken over.
fn instead_of(path: &str) -> &'static str {
    let is_of = |words: &[&str]| words.iter().any(|word| path.starts_with(word));
    if is_of(&[".setFocalLength", ".projectionMatrix"]) {
        "this is not read: the field of view must be given by fov"
    } else if is_of(&[".setViewOffset", ".filmOffset"]) {
        "a view that is off the middle is not read: the camera must be given without it"
    } else if is_of(&[".scale"]) {
        "a camera that is scaled is not read: it must be given without it"
    } else {
        "the camera must be turned by lookAt, or be given as toJSON() writes it"
    }
}

/// What else changes the camera's axes, its place or its lens.
fn turns(path: &str) -> bool {
    const TURNING: [&str; 15] = [
        ".rotation",
        ".quaternion",
        ".rotate",
        ".matrix",
        ".applyMatrix4",
        ".applyQuaternion",
        ".setRotation",
        ".translate",
        ".setViewOffset",
        ".setFocalLength",
        ".filmOffset",
        ".projectionMatrix",
        ".copy",
        ".scale",
        ".attach",
    ];
    TURNING.iter().any(|word| path.starts_with(word))
}
