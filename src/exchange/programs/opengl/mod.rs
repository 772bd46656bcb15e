//! `gluLookAt` and `gluPerspective`, and GLM's `lookAt` and `perspective`, which are the same numbers.

mod read;

use crate::format::text::{commas, n, real};
use crate::format::{
    Conventions, ExportScene, Exported, Format, Importer, PixelConvention, Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    short: "gluLookAt",
    ending: "c",
    conventions: Conventions {
        axes: Conventions::OURS,
        given_by: "eye, center (our at), up",
        pixels: PixelConvention::FromBottom,
        view: "fovy: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: zNear and zFar cut, and change no ray",
        shape: "any: aspect need not be that of glViewport",
        lengths: "f64; GLM often f32",
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    read: self::read::read,
    detect: |text| {
        text.contains("gluLookAt")
            || text.contains("gluPerspective")
            || text.contains("glm::lookAt")
            || text.contains("glm::perspective")
            || (text.contains("lookAt(") && text.contains("perspective("))
    },
};

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
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
    notes.extend(subject.objects_left_out("OpenGL has triangles only"));
    Ok(Exported::one_file("camera.c", &text, notes))
}
