//! `gluLookAt` and `gluPerspective`, and GLM's `lookAt` and `perspective`, which are the same numbers.

mod read;

use crate::programs::sheet::{Sheet, commas, n, real};
use crate::programs::terms::{Pixels, Terms};
use crate::programs::{Check, Format, Importer, Subject, Unsayable, Written};

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
    check: Check::Import,
};

pub(super) const IMPORTER: Importer = Importer {
    name: FORMAT.name,
    label: FORMAT.label,
    read: self::read::read,
    claims: |text| {
        text.contains("gluLookAt")
            || text.contains("gluPerspective")
            || text.contains("glm::lookAt")
            || text.contains("glm::perspective")
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
