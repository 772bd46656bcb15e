//! `new THREE.PerspectiveCamera(...)` and the statements that place it, given by numbers.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Viewport};

use crate::FileError;
use crate::error::one_line;
use crate::format::image_size::{image_of, image_of_ratio};
use crate::format::viewport::viewport_of_angle;
use crate::format::{Imported, Input};
use crate::programs::literal::{Source, Statement};

const RIGHT: &str = "only new THREE.PerspectiveCamera, position.set, position.x =, up.set, lookAt and \
                     setSize may stand beside the camera's, each given by numbers";

pub(super) fn detect(text: &str) -> bool {
    let is_made = |at: usize| {
        let before = text[..at].trim_end();
        before.ends_with("THREE.") || before.ends_with("new")
    };
    text.match_indices("PerspectiveCamera").any(|(at, _)| is_made(at))
}

/// Values that the statements give.
#[derive(Default)]
struct Given {
    /// Name of the camera.
    name: Option<String>,
    /// fov in degrees, and aspect.
    lens: Option<(f64, f64)>,
    position: DVec3,
    /// Up; (0, 1, 0) where it is not given.
    up: Option<DVec3>,
    at: Option<DVec3>,
    size: Option<ImageSize>,
}

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let source = Source::new(text, RIGHT)?;
    let mut given = Given::default();
    for statement in &source.statements {
        given.take(&source, statement)?;
    }
    let (fov, aspect) = given.lens.ok_or_else(|| {
        source.missing(
            "PerspectiveCamera",
            "the camera must be made by it, as new THREE.PerspectiveCamera(50, 1.5)",
        )
    })?;
    let mut notes = Vec::new();
    let image = given
        .size
        .unwrap_or_else(|| image_of_ratio(at_hand.image, aspect, "this code", &mut notes));
    let up = given.up.unwrap_or(DVec3::Y);
    let orientation = match given.at {
        Some(at) => Orientation::At { at, up },
        None => Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y },
    };
    let viewport: Viewport = viewport_of_angle(fov, aspect, at_hand.viewport.distance);
    Ok(Imported::camera(Camera { eye: given.position, orientation, viewport, image }, notes))
}

impl Given {
    fn take(&mut self, source: &Source, statement: &Statement) -> Result<(), FileError> {
        let (target, called) = (&statement.target[..], &statement.called[..]);
        if matches!(called, "PerspectiveCamera" | "THREE.PerspectiveCamera") && statement.is_new {
            self.name = Some(target.to_owned()).filter(|name| !name.is_empty());
            return source.once(&mut self.lens, lens(source, statement)?, statement);
        }
        let is_call = target.is_empty();
        if called.ends_with(".setSize") && is_call {
            let [width, height] = source.all_numbers(statement)?;
            let size =
                image_of(width, height).map_err(|right| source.refused(statement, &right))?;
            return source.once(&mut self.size, size, statement);
        }
        let (path, steps) = match called {
            "" => (target, [".position.x", ".position.y", ".position.z"]),
            _ => (called, [".position.set", ".up.set", ".lookAt"]),
        };
        let step = steps.into_iter().find(|step| path.ends_with(step));
        let Some(step) = step.filter(|_| called.is_empty() || is_call) else {
            return Err(source.refused(statement, RIGHT));
        };
        let owner = &path[..path.len() - step.len()];
        if self.lens.is_none() || self.name.as_ref().is_some_and(|name| name != owner) {
            let right = format!(
                "{} must be the camera, made by new THREE.PerspectiveCamera before it",
                one_line(owner)
            );
            return Err(source.refused(statement, &right));
        }
        self.name = Some(owner.to_owned());
        if self.at.is_some() {
            let right = "it must stand before lookAt, which turns the camera where it is then";
            return Err(source.refused(statement, right));
        }
        if let ("", [value]) = (called, &statement.arguments[..]) {
            let axis = step.chars().last().and_then(|axis| "xyz".find(axis)).unwrap_or_default();
            self.position[axis] = source.number(&step[".position.".len()..], value)?;
            return Ok(());
        }
        let vector = DVec3::from_array(source.all_numbers(statement)?);
        match step {
            ".position.set" => self.position = vector,
            ".up.set" => self.up = Some(vector),
            _ => self.at = Some(vector),
        }
        Ok(())
    }
}

/// fov in degrees and aspect; three.js has 50 and 1 where they are not given.
fn lens(source: &Source, statement: &Statement) -> Result<(f64, f64), FileError> {
    let arguments = &statement.arguments;
    if arguments.len() > 4 {
        return Err(source.refused(statement, "it must be fov, aspect, near, far"));
    }
    for argument in arguments.iter().skip(2) {
        source.number("near and far", argument)?;
    }
    let (mut fov, mut aspect) = (50.0, 1.0);
    if let Some(argument) = arguments.first() {
        fov = source.number("fov", argument)?;
        if !(fov > 0.0 && fov < 180.0) {
            return Err(source.fault("fov", argument, "it must be between 0 and 180 degrees"));
        }
    }
    if let Some(argument) = arguments.get(1) {
        aspect = source.number("aspect", argument)?;
        if aspect <= 0.0 {
            return Err(source.fault("aspect", argument, "it must be greater than 0"));
        }
    }
    Ok((fov, aspect))
}
