//! `gluLookAt` and `gluPerspective`, and GLM's `lookAt` and `perspective`, which are the same numbers.

use pinhole_core::{Camera, DVec3, Orientation};

use super::back::{image_of, image_of_aspect, upright};
use super::code::{Code, Comments, Piece, split};
use super::sheet::{Sheet, commas, n, real};
use super::terms::{Pixels, Terms};
use super::{Format, Subject, Taken, Text, Unsayable, Written};
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    short: "gluLookAt",
    ending: "c",
    terms: Terms {
        axes: Terms::OURS,
        given_by: "eye, center (our at), up",
        pixels: Pixels::FromBottom,
        view: "fovy: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: zNear and zFar cut, and change no ray",
        shape: "any: aspect need not be that of glViewport",
        lengths: "f64; GLM often f32",
    },
    write,
    read,
    claims: |text| {
        text.contains("gluLookAt")
            || text.contains("gluPerspective")
            || (text.contains("lookAt(") && text.contains("perspective("))
    },
};

fn write(subject: &Subject) -> Result<Written, Unsayable> {
    let [eye, at, up] = subject.look_at()?;
    let [width, height] = subject.size();
    let (near, far) = subject.clip();
    let viewport = subject.viewport();
    let text = format!(
        "glViewport(0, 0, {width}, {height});\n\
         glMatrixMode(GL_PROJECTION);\n\
         glLoadIdentity();\n\
         gluPerspective({}, {}, {}, {});\n\
         glMatrixMode(GL_MODELVIEW);\n\
         glLoadIdentity();\n\
         gluLookAt({},\n          {},\n          {});\n",
        real(subject.vertical_degrees()),
        real(viewport.width / viewport.height),
        real(near),
        real(far),
        commas(eye),
        commas(at),
        commas(up),
    );
    let mut notes = vec![format!(
        "zNear {} and zFar {} are chosen: OpenGL cuts off what is nearer or farther",
        n(near),
        n(far)
    )];
    let objects = subject.spheres().len() + subject.planes().len();
    if objects > 0 {
        notes.push("objects are left out: OpenGL has triangles only".to_owned());
    }
    Ok(Written::of("camera.c", Sheet::of(&text), notes))
}

fn read(text: &Text, at_hand: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Slashes);
    let mut notes = Vec::new();
    let look = ["gluLookAt", "lookAt"].iter().find_map(|name| code.calls(name).last().copied());
    let look = look.ok_or_else(|| {
        code.missing("gluLookAt", "the camera's eye, center and up must be given by it")
    })?;
    let [ex, ey, ez, cx, cy, cz, ux, uy, uz] = numbers(&code, "gluLookAt", look)?;
    let (at, up) = (DVec3::new(cx, cy, cz), DVec3::new(ux, uy, uz));
    let lens =
        ["gluPerspective", "perspective"].iter().find_map(|name| code.calls(name).last().copied());
    let lens = lens.ok_or_else(|| {
        code.missing("gluPerspective", "fovy, aspect, zNear and zFar must be given by it")
    })?;
    let (fovy, aspect) = field_of_view(&code, lens)?;
    let size =
        code.calls("glViewport").last().map(|call| (*call, code.numbers("glViewport", *call)));
    let image = match size {
        Some((call, size)) => match size?[..] {
            [_, _, width, height] => image_of(width, height)
                .map_err(|right| code.fault("glViewport's size", call, &right))?,
            _ => return Err(code.fault("glViewport", call, "it must have four numbers")),
        },
        None => image_of_aspect(at_hand.image, aspect, "gluPerspective", &mut notes),
    };
    let camera = Camera {
        eye: DVec3::new(ex, ey, ez),
        orientation: Orientation::At { at, up },
        viewport: upright(fovy, aspect, at_hand.viewport.distance),
        image,
    };
    Ok(Taken::camera(camera, notes))
}

fn numbers<const N: usize>(code: &Code, name: &str, call: Piece) -> Result<[f64; N], FileError> {
    let numbers = code.numbers(name, call)?;
    numbers.try_into().map_err(|_| code.fault(name, call, &format!("it must have {N} numbers")))
}

/// fovy in degrees, and aspect.
fn field_of_view(code: &Code, lens: Piece) -> Result<(f64, f64), FileError> {
    let parts = split(lens);
    let [fovy, aspect, ..] = parts[..] else {
        return Err(code.fault("gluPerspective", lens, "it must be fovy, aspect, zNear, zFar"));
    };
    let degrees = code.number("fovy", fovy)?;
    // GLM counts in radians, which are mostly written as radians(45).
    let before = code.whole().text[..lens.at].trim_end_matches('(').trim_end();
    let is_glu = before.ends_with("gluPerspective");
    let degrees = if is_glu { degrees } else { degrees.to_degrees() };
    if !(degrees > 0.0 && degrees < 180.0) {
        return Err(code.fault("fovy", fovy, "it must be between 0 and 180 degrees"));
    }
    let ratio = code.number("aspect", aspect)?;
    if ratio <= 0.0 {
        return Err(code.fault("aspect", aspect, "it must be greater than 0"));
    }
    Ok((degrees, ratio))
}
