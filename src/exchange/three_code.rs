//! three.js as it is written in a program: `new THREE.PerspectiveCamera(...)` and what is done to it,
//! one statement after the other, without running it.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Viewport};

use super::back::{image_of, image_of_aspect, upright};
use super::code::{Code, Comments, Piece, after_spaces, split, trimmed, words};
use super::sheet::commas;
use super::{Taken, Text};
use crate::formats::FileError;

const CAMERA: &str = "PerspectiveCamera";

/// Whether a text makes a camera so.
pub(super) fn claims(text: &str) -> bool {
    let is_made = |at: usize| {
        let before = text[..at].trim_end();
        before.ends_with("THREE.") || before.ends_with("new")
    };
    text.match_indices(CAMERA).any(|(at, _)| is_made(at))
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Slashes);
    let mut notes = Vec::new();
    let call = code.calls(CAMERA).last().copied();
    let call = call.ok_or_else(|| {
        code.missing(CAMERA, "it must be made, as new THREE.PerspectiveCamera(50, 4 / 3, 0.1, 100)")
    })?;
    let mut lens = Lens::read(&code, call)?;
    let mut stand = Stand::default();
    match name_of(code.whole(), call) {
        Some(name) => stand.follow(&code, call, name, &mut lens)?,
        None => notes.push("the camera is given no name: it stays where it is made".to_owned()),
    }
    stand.orbit(&code, &mut notes)?;
    let size = match code.calls("setSize").last() {
        Some(call) => size(&code, *call)?,
        None => None,
    };
    let aspect = lens.aspect.unwrap_or_else(|said| {
        let image = size.unwrap_or(at_hand.image);
        let (w, h) = (image.width(), image.height());
        notes.push(format!("aspect is {said}, which is no number: {w} / {h} taken"));
        image.aspect()
    });
    let image =
        size.unwrap_or_else(|| image_of_aspect(at_hand.image, aspect, "this code", &mut notes));
    let viewport = upright(lens.fov, aspect, at_hand.viewport.distance);
    let zoom = stand.zoom;
    let viewport =
        Viewport { width: viewport.width / zoom, height: viewport.height / zoom, ..viewport };
    let orientation = stand.orientation(&mut notes);
    if text.text.contains("Geometry(") {
        let note = "meshes are left out: they are read of a scene written by toJSON()";
        notes.push(note.to_owned());
    }
    Ok(Taken::camera(Camera { eye: stand.position, orientation, viewport, image }, notes))
}

/// What the camera is made with.
struct Lens<'t> {
    /// Vertical, in degrees.
    fov: f64,
    /// The text where it is no number, such as `window.innerWidth / window.innerHeight`.
    aspect: Result<f64, &'t str>,
}

impl<'t> Lens<'t> {
    /// three.js has fov 50 and aspect 1 where nothing is given.
    fn read(code: &Code, call: Piece<'t>) -> Result<Lens<'t>, FileError> {
        let parts = split(call);
        let mut lens = Lens { fov: 50.0, aspect: Ok(1.0) };
        if let Some(fov) = parts.first() {
            lens.set_fov(code, *fov)?;
        }
        if let Some(aspect) = parts.get(1) {
            lens.aspect = Err(aspect.text);
            lens.set_aspect(code, *aspect)?;
        }
        Ok(lens)
    }

    fn set_fov(&mut self, code: &Code, value: Piece) -> Result<(), FileError> {
        self.fov = code.number("fov", value)?;
        let is_angle = self.fov > 0.0 && self.fov < 180.0;
        let right = "it must be between 0 and 180 degrees";
        is_angle.then_some(()).ok_or_else(|| code.fault("fov", value, right))
    }

    /// What is no number, as in the answer to a resized window, changes nothing.
    fn set_aspect(&mut self, code: &Code, value: Piece) -> Result<(), FileError> {
        let Ok(aspect) = code.number("aspect", value) else { return Ok(()) };
        self.aspect = Ok(aspect);
        (aspect > 0.0)
            .then_some(())
            .ok_or_else(|| code.fault("aspect", value, "it must be greater than 0"))
    }
}

/// Of `renderer.setSize(800, 600)`; `None` where it is of a window.
fn size(code: &Code, call: Piece) -> Result<Option<ImageSize>, FileError> {
    let numbers = code.numbers("setSize", call).unwrap_or_default();
    let [width, height, ..] = numbers[..] else { return Ok(None) };
    image_of(width, height).map(Some).map_err(|right| code.fault("setSize", call, &right))
}

/// The name that the camera is given: `const camera = new THREE.PerspectiveCamera(`.
fn name_of<'t>(whole: Piece<'t>, call: Piece) -> Option<&'t str> {
    let (before, made) = whole.text[..call.at].rsplit_once('=')?;
    let made: String = made.split_whitespace().collect();
    if !["newTHREE.PerspectiveCamera(", "newPerspectiveCamera("].contains(&made.as_str()) {
        return None;
    }
    // In TypeScript its kind may follow the name.
    let before = before.trim_end();
    let before = before.trim_end_matches(CAMERA).trim_end_matches("THREE.").trim_end();
    let before = before.trim_end_matches(':').trim_end();
    let is_part = |c: char| c.is_alphanumeric() || "_$.".contains(c);
    let start = before.rfind(|c| !is_part(c)).map_or(0, |at| at + 1);
    let name = before.get(start..).unwrap_or_default();
    (!name.is_empty()).then_some(name)
}

/// Where the camera stands, as the statements leave it.
struct Stand {
    position: DVec3,
    up: DVec3,
    zoom: f64,
    /// From where, to where and with which up it was turned last.
    turned: Option<(DVec3, DVec3, DVec3)>,
}

impl Default for Stand {
    fn default() -> Stand {
        Stand { position: DVec3::ZERO, up: DVec3::Y, zoom: 1.0, turned: None }
    }
}

impl Stand {
    /// Every statement that begins with the camera's name, in the order of the text.
    fn follow(
        &mut self,
        code: &Code,
        made: Piece,
        name: &str,
        lens: &mut Lens,
    ) -> Result<(), FileError> {
        let whole = code.whole();
        let is_own = |at: &usize| *at > made.at && !whole.text[..*at].ends_with('.');
        for at in words(whole, name).into_iter().filter(is_own) {
            let rest = whole.from(at + name.len());
            let end = rest.text.find(|c: char| !(c.is_alphanumeric() || c == '.'));
            let (path, rest) = rest.text.split_at(end.unwrap_or(rest.text.len()));
            let rest = after_spaces(Piece { text: rest, at: at + name.len() + path.len() });
            let values = match rest.text.chars().next() {
                Some('(') => code.bracketed(rest),
                Some('=') if !rest.text.starts_with("==") => {
                    let value = rest.from(1);
                    let end = value.text.find([';', '\n']).unwrap_or(value.text.len());
                    Some(trimmed(Piece { text: &value.text[..end], ..value }))
                }
                _ => None,
            };
            match (path, values) {
                (".fov", Some(value)) => lens.set_fov(code, value)?,
                (".aspect", Some(value)) => lens.set_aspect(code, value)?,
                (_, Some(values)) => self.step(code, path, values)?,
                (_, None) => (),
            }
        }
        Ok(())
    }

    /// `OrbitControls` turn the camera to their target, wherever it looked before.
    fn orbit(&mut self, code: &Code, notes: &mut Vec<String>) -> Result<(), FileError> {
        if code.calls("OrbitControls").is_empty() {
            return Ok(());
        }
        let target = code.calls("target.set").last().copied();
        let target = target.map(|target| code.vector("target", target)).transpose()?;
        let at = target.unwrap_or(DVec3::ZERO);
        self.turned = Some((self.position, at, self.up));
        notes.push(format!("OrbitControls turn the camera to their target, ({})", commas(at)));
        Ok(())
    }

    fn step(&mut self, code: &Code, path: &str, values: Piece) -> Result<(), FileError> {
        match path {
            ".position.set" | ".position.copy" => {
                self.position = code.vector("position", values)?
            }
            ".position.x" => self.position.x = code.number("position.x", values)?,
            ".position.y" => self.position.y = code.number("position.y", values)?,
            ".position.z" => self.position.z = code.number("position.z", values)?,
            ".up.set" | ".up.copy" => self.up = code.vector("up", values)?,
            ".up" => self.up = code.vector("up", values)?,
            ".zoom" => match code.number("zoom", values)? {
                zoom if zoom > 0.0 => self.zoom = zoom,
                _ => return Err(code.fault("zoom", values, "it must be greater than 0")),
            },
            ".lookAt" => {
                // Where a scene's position is not set, it is the origin.
                let at = match values.text.trim() {
                    "scene.position" => DVec3::ZERO,
                    _ => code.vector("lookAt", values)?,
                };
                self.turned = Some((self.position, at, self.up));
            }
            other if turns(other) => {
                let right =
                    "the camera must be turned by lookAt, or be given as toJSON() writes it";
                return Err(code.fault(other.trim_start_matches('.'), values, right));
            }
            _ => (),
        }
        Ok(())
    }

    /// A camera that is moved after it was turned looks the same way from elsewhere.
    fn orientation(&self, notes: &mut Vec<String>) -> Orientation {
        let Some((from, at, up)) = self.turned else {
            return Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y };
        };
        if from == self.position {
            return Orientation::At { at, up };
        }
        let note = "position is set after lookAt, which had turned the camera from where it was";
        notes.push(note.to_owned());
        Orientation::View { view: at - from, up }
    }
}

/// What else changes the camera's axes, its place or its lens.
fn turns(path: &str) -> bool {
    const TURNING: [&str; 12] = [
        ".rotation",
        ".quaternion",
        ".rotate",
        ".matrix",
        ".applyMatrix4",
        ".applyQuaternion",
        ".setRotation",
        ".translate",
        ".position",
        ".setViewOffset",
        ".setFocalLength",
        ".filmOffset",
    ];
    TURNING.iter().any(|word| path.starts_with(word))
}
