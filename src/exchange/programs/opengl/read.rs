//! `gluLookAt` and `gluPerspective`, or GLM's `lookAt` and `perspective`, given by numbers.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation};

use crate::FileError;
use crate::error::one_line;
use crate::format::image_size::{image_of, image_of_ratio};
use crate::format::text::n;
use crate::format::viewport::viewport_of_angle;
use crate::format::{Imported, Input};
use crate::programs::literal::{Argument, Source, Statement, three};

const RIGHT: &str = "only gluLookAt, gluPerspective, glViewport, glMatrixMode and glLoadIdentity, or \
                     glm::lookAt and glm::perspective, may stand beside the camera's, each given by numbers";

/// Calls of the camera.
#[derive(Default)]
struct Calls {
    points: Option<[DVec3; 3]>,
    /// fovy in degrees, and aspect.
    lens: Option<(f64, f64)>,
    lens_name: &'static str,
    size: Option<ImageSize>,
    /// Matrix that `glMatrixMode` chooses; empty before the first.
    mode: String,
}

const PROJECTION: &str = "GL_PROJECTION";
const MODEL_VIEW: &str = "GL_MODELVIEW";

pub(super) fn read(text: &Input, at_hand: &Camera) -> Result<Imported, FileError> {
    let source = Source::new(text, RIGHT)?;
    let mut calls = Calls::default();
    for statement in &source.statements {
        calls.take(&source, statement)?;
    }
    let [eye, at, up] = calls.points.ok_or_else(|| {
        source.missing("gluLookAt", "the camera's eye, center and up must be given by it")
    })?;
    let (fovy, aspect) = calls.lens.ok_or_else(|| {
        source.missing("gluPerspective", "fovy, aspect, zNear and zFar must be given by it")
    })?;
    let mut notes = Vec::new();
    let image = calls
        .size
        .unwrap_or_else(|| image_of_ratio(at_hand.image, aspect, calls.lens_name, &mut notes));
    let camera = Camera {
        eye,
        orientation: Orientation::At { at, up },
        viewport: viewport_of_angle(fovy, aspect, at_hand.viewport.distance),
        image,
    };
    Ok(Imported::camera(camera, notes))
}

impl Calls {
    fn take(&mut self, source: &Source, statement: &Statement) -> Result<(), FileError> {
        let called = &statement.called[..];
        if matches!(
            (called, &self.mode[..]),
            ("gluLookAt", PROJECTION) | ("gluPerspective", MODEL_VIEW)
        ) {
            let right = "glMatrixMode before it must choose its own matrix";
            return Err(source.refused(statement, right));
        }
        match called {
            "gluLookAt" => {
                source.once(&mut self.points, three(source.all_numbers(statement)?), statement)
            }
            "lookAt" | "glm::lookAt" => {
                let [eye, center, up] = &statement.arguments[..] else {
                    return Err(source.refused(statement, "it must be eye, center, up"));
                };
                let point = |argument| source.vector(called, argument);
                let points = [point(eye)?, point(center)?, point(up)?];
                source.once(&mut self.points, points, statement)
            }
            "gluPerspective" | "perspective" | "glm::perspective" => {
                let is_glu = called == "gluPerspective";
                self.lens_name = if is_glu { "gluPerspective" } else { "perspective" };
                source.once(&mut self.lens, lens(source, statement, is_glu)?, statement)
            }
            "glViewport" => {
                let [_, _, width, height] = source.all_numbers(statement)?;
                let size =
                    image_of(width, height).map_err(|right| source.refused(statement, &right))?;
                source.once(&mut self.size, size, statement)
            }
            "glMatrixMode" => {
                self.mode = match &statement.arguments[..] {
                    [mode] if [PROJECTION, MODEL_VIEW].contains(&&mode.text[..]) => {
                        mode.text.clone()
                    }
                    _ => return Err(source.refused(statement, RIGHT)),
                };
                Ok(())
            }
            "glLoadIdentity" => {
                let is_lost = self.lens.is_some() && self.mode != MODEL_VIEW
                    || self.points.is_some() && self.mode != PROJECTION;
                let right = "it must stand before the camera's call, which it undoes";
                if is_lost { Err(source.refused(statement, right)) } else { Ok(()) }
            }
            _ => Err(source.refused(statement, RIGHT)),
        }
    }
}

/// fovy in degrees, and aspect.
fn lens(source: &Source, statement: &Statement, is_glu: bool) -> Result<(f64, f64), FileError> {
    let [fovy, aspect, near, far] = &statement.arguments[..] else {
        return Err(source.refused(statement, "it must be fovy, aspect, zNear, zFar"));
    };
    source.number("zNear", near)?;
    source.number("zFar", far)?;
    let degrees = degrees(source, fovy, is_glu)?;
    let ratio = source.number("aspect", aspect)?;
    if divides_whole(aspect) {
        let right =
            "C divides whole numbers without a fraction: write it with a point, as 4.0 / 3.0";
        return Err(source.fault("aspect", aspect, right));
    }
    let right = "it must be greater than 0";
    (ratio > 0.0).then_some((degrees, ratio)).ok_or_else(|| source.fault("aspect", aspect, right))
}

/// Returns true for a quotient such as 4 / 3, which is 1 in C.
fn divides_whole(argument: &Argument) -> bool {
    argument.text.contains('/') && !argument.text.contains('.')
}

/// GLU counts in degrees; GLM in radians, which are mostly written as radians(45).
fn degrees(source: &Source, fovy: &Argument, is_glu: bool) -> Result<f64, FileError> {
    let degrees = match fovy.degrees {
        Some(_) if is_glu => {
            return Err(source.fault("fovy", fovy, "gluPerspective counts in degrees"));
        }
        Some(degrees) => degrees,
        None => {
            let given = source.number("fovy", fovy)?;
            if !is_glu && (std::f64::consts::PI..180.0).contains(&given) {
                let right = format!(
                    "GLM counts in radians, and {} radians are {} degrees: write glm::radians({})",
                    n(given),
                    n(given.to_degrees().round()),
                    one_line(&fovy.text)
                );
                return Err(source.fault("fovy", fovy, &right));
            }
            if is_glu { given } else { given.to_degrees() }
        }
    };
    if divides_whole(fovy) || !(degrees > 0.0 && degrees < 180.0) {
        return Err(source.fault("fovy", fovy, "it must be between 0 and 180 degrees"));
    }
    Ok(degrees)
}
