//! three.js as it is written in a program: `new THREE.PerspectiveCamera(...)` and what is done to it,
//! one statement after the other, without running it.

use pinhole_core::{Camera, DVec3, ImageSize, Viewport};

use super::handed::handed;
use super::react;
use super::stand::{Stand, changed, moves, number_after};
use super::steps::{Step, Verb, camera, later, made, names, steps};
use crate::exchange::back::{image_of, image_of_aspect, upright};
use crate::exchange::code::{Code, Comments, Piece, split, words};
use crate::exchange::{Taken, Text};
use crate::formats::FileError;

const CAMERA: &str = "PerspectiveCamera";

/// Whether a text makes a camera so.
pub(super) fn claims(text: &str) -> bool {
    let is_made = |at: usize| {
        let before = text[..at].trim_end();
        before.ends_with("THREE.") || before.ends_with("new")
    };
    react::claims(text) || text.match_indices(CAMERA).any(|(at, _)| is_made(at))
}

pub(super) fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Slashes);
    if react::claims(text.text) && made(&code, CAMERA).is_empty() {
        return react::read(&code, at_hand);
    }
    let mut notes = Vec::new();
    let (name, call) = camera(&code, CAMERA, &mut notes)?;
    let mut lens = Lens::read(&code, call)?;
    let mut stand = Stand::default();
    match name {
        Some(name) => follow(&code, call, name, &mut stand, &mut lens, &mut notes)?,
        None => notes.push("the camera is given no name: it stays where it is made".to_owned()),
    }
    let size = match code.calls("setSize").last() {
        Some(call) => size(&code, *call)?,
        None => None,
    };
    let mut taken = taken(&lens, &stand, size, at_hand, notes);
    if text.text.contains("Geometry(") {
        let note = "meshes are left out: they are read of a scene written by toJSON()";
        taken.notes.push(note.to_owned());
    }
    Ok(taken)
}

/// The camera that stands so.
pub(super) fn taken(
    lens: &Lens,
    stand: &Stand,
    size: Option<ImageSize>,
    at_hand: &Camera,
    mut notes: Vec<String>,
) -> Taken {
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
    Taken::camera(Camera { eye: stand.position, orientation, viewport, image }, notes)
}

/// Every statement about the camera, under each of its names, and those that turn it with others.
fn follow(
    code: &Code,
    made: Piece,
    name: &str,
    stand: &mut Stand,
    lens: &mut Lens,
    notes: &mut Vec<String>,
) -> Result<(), FileError> {
    let names = names(code, name);
    let mut all: Vec<Step> = names.iter().flat_map(|name| steps(code, name)).collect();
    all.sort_by_key(|step| step.at);
    let is_made_once = code.calls(CAMERA).len() == 1;
    let all: Vec<Step> = all.into_iter().filter(|step| is_made_once || step.at > made.at).collect();
    for step in now(code, all, notes) {
        if step.at < made.at && moves(&step.path) {
            let right = "it stands before the camera is made: it must stand after it";
            return Err(code.fault(step.path.trim_start_matches('.'), step.values, right));
        }
        match (step.path.as_str(), step.verb) {
            (".fov", verb) if verb != Verb::Call => {
                lens.fov = number_after(code, "fov", &step, lens.fov)?;
                lens.check(code, step.values)?;
            }
            (".aspect", Verb::Give) => lens.set_aspect(code, step.values)?,
            _ => stand.step(code, &step, notes)?,
        }
    }
    carried(code, &names, DEEPEST)?;
    handed(code, &names, &later(code))?;
    controls(code, &names, stand, notes)
}

/// Without those that are done later.
fn now<'t>(code: &Code, all: Vec<Step<'t>>, notes: &mut Vec<String>) -> Vec<Step<'t>> {
    let later = later(code);
    let is_later = |step: &Step| later.contains(step.at);
    let (left, now): (Vec<Step>, Vec<Step>) = all.into_iter().partition(is_later);
    if left.iter().any(|step| moves(&step.path)) {
        let note = "what moves the camera later, as in animate() or where an event is answered, is \
                    left out";
        if !notes.iter().any(|said| said == note) {
            notes.push(note.to_owned());
        }
    }
    let turns = |steps: &[Step]| steps.iter().any(|step| step.path == ".lookAt");
    if turns(&left) && !turns(&now) {
        notes.push("lookAt is among it, and stands nowhere else".to_owned());
    }
    now
}

/// So many scenes may hold the camera.
const MOST_HOLDERS: usize = 10;

/// So many things may hold one another.
const DEEPEST: usize = 8;

/// What the camera is put into must not stand anywhere but at the origin.
fn carried(code: &Code, names: &[&str], deeper: usize) -> Result<(), FileError> {
    let whole = code.whole();
    let mut held: Vec<&str> = Vec::new();
    for call in ["add", "attach"].into_iter().flat_map(|name| code.calls(name)) {
        if !split(call).iter().any(|part| names.contains(&part.text)) {
            continue;
        }
        let before = whole.text[..call.at].trim_end_matches('(').trim_end();
        let before = before.trim_end_matches(char::is_alphanumeric);
        let Some(path) = before.strip_suffix('.') else { continue };
        let start = path.rfind(|c: char| !(c.is_alphanumeric() || "_$.".contains(c)));
        let holder = &path[start.map_or(0, |at| at + 1)..];
        let short = holder.rsplit('.').next().unwrap_or_default();
        if held.contains(&holder) || short.to_ascii_lowercase().ends_with("scene") {
            continue;
        }
        let value = code.value(short).map_or("", |value| value.text);
        let is_of = |kinds: &[&str]| {
            kinds.iter().any(|kind| {
                let rest = value.strip_prefix("new ").unwrap_or_default().trim_start();
                let rest = rest.strip_prefix("THREE.").unwrap_or(rest);
                rest.strip_prefix(kind).is_some_and(|rest| rest.starts_with('('))
            })
        };
        held.push(holder);
        if is_of(&["Scene"]) && held.len() < MOST_HOLDERS {
            continue;
        }
        // A thing has one that holds it.
        let is_still = held.len() == 1
            && is_of(&["Group", "Object3D"])
            && !steps(code, holder).iter().any(|step| moves(&step.path));
        let Some(deeper) = deeper.checked_sub(1).filter(|_| is_still) else {
            let right = format!(
                "{holder} holds the camera and moves it: the camera must stand in the scene, or be \
                 given as toJSON() writes it"
            );
            return Err(code.fault(&format!("{holder}.add"), call, &right));
        };
        carried(code, &[holder], deeper)?;
    }
    Ok(())
}

/// What turns the camera to a target of its own; the others only answer the mouse or keys.
const ORBITING: [&str; 4] =
    ["OrbitControls", "MapControls", "TrackballControls", "ArcballControls"];

fn controls(
    code: &Code,
    names: &[&str],
    stand: &mut Stand,
    notes: &mut Vec<String>,
) -> Result<(), FileError> {
    for kind in ORBITING {
        let is_own = |(_, call): &(_, Piece)| {
            split(*call).first().is_some_and(|camera| names.contains(&camera.text))
        };
        // Of several the last one turns the camera last.
        if let Some((name, made_with)) = made(code, kind).into_iter().rfind(is_own) {
            let steps = name.map(|name| steps(code, name)).unwrap_or_default();
            looked_after(code, names, made_with.at, &steps, kind)?;
            let mut target = DVec3::ZERO;
            for step in now(code, steps, notes) {
                if let Some(rest) = step.path.strip_prefix(".target").filter(|r| *r != "0") {
                    changed(code, "target", rest, &step, &mut target)?;
                }
                if step.path.starts_with(".object.") && moves(&step.path[".object".len()..]) {
                    let right = "the camera must be moved by its own name";
                    return Err(code.fault(&step.path[1..], step.values, right));
                }
            }
            stand.orbit(target, kind, notes);
        }
    }
    let (whole, later) = (code.whole(), later(code));
    for at in words(whole, "getObject") {
        let rest = whole.from(at + "getObject".len()).text;
        if ["().position", "().rotation"].iter().any(|word| rest.starts_with(word))
            && !later.contains(at)
        {
            let right = "the camera must be moved by its own name";
            let piece = Piece { text: "getObject", at };
            return Err(code.fault("the controls' object", piece, right));
        }
    }
    Ok(())
}

/// Controls turn the camera when they are made, and where they are updated: a `lookAt` between the two
/// is undone, one after them holds.
fn looked_after(
    code: &Code,
    names: &[&str],
    made: usize,
    of_controls: &[Step],
    kind: &str,
) -> Result<(), FileError> {
    let later = later(code);
    let updated = of_controls.iter().rfind(|step| step.path == ".update").map(|step| step.at);
    if updated.is_some_and(|at| later.contains(at)) {
        return Ok(());
    }
    let after = updated.map_or(made, |at| at.max(made));
    for step in names.iter().flat_map(|name| steps(code, name)) {
        if step.path == ".lookAt" && step.at > after && !later.contains(step.at) {
            let right =
                format!("{kind} turn the camera before it: one of the two must be left out");
            return Err(code.fault("lookAt", step.values, &right));
        }
    }
    Ok(())
}

/// What the camera is made with.
pub(super) struct Lens<'t> {
    /// Vertical, in degrees.
    pub(super) fov: f64,
    /// The text where it is no number, such as `window.innerWidth / window.innerHeight`.
    pub(super) aspect: Result<f64, &'t str>,
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

    pub(super) fn set_fov(&mut self, code: &Code, value: Piece) -> Result<(), FileError> {
        self.fov = code.number("fov", value)?;
        self.check(code, value)
    }

    fn check(&self, code: &Code, value: Piece) -> Result<(), FileError> {
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
