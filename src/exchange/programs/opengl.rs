//! `gluLookAt` and `gluPerspective`, and GLM's `lookAt` and `perspective`, which are the same numbers.

use crate::format::text::{commas, n, real};
use crate::format::{Conventions, ExportScene, Format, PixelConvention, Unsupported};

pub(super) const FORMAT: Format = Format {
    name: "opengl",
    label: "gluLookAt + gluPerspective",
    short: "gluLookAt",
    file: "camera.c",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, center (our at), up",
        pixels: PixelConvention::FromBottom,
        view: "fovy: vertical, in degrees, and aspect = width / height",
        field: |subject| n(subject.vertical_degrees()),
        distance: "none: zNear and zFar cut, and change no ray",
        shape: "any: aspect need not be that of glViewport",
        lengths: "f64; GLM often f32",
    }),
    write,
};

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
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
    notes.push(format!(
        "zNear {} and zFar {} are chosen: OpenGL cuts off what is nearer or farther",
        n(near),
        n(far)
    ));
    notes.extend(subject.objects_left_out("OpenGL has triangles only"));
    Ok(text)
}
