//! The course's own camera, a call of Julia: `PerspectiveCamera(eye, view, up, focal, H, W)`, whose
//! viewport is 1 wide and H / W high.

use crate::format::text::{commas, n, real};
use crate::format::{Conventions, ExportScene, Format, PixelConvention, Unsupported};

pub(super) const FORMAT: Format = Format {
    name: "course",
    label: "PerspectiveCamera of the course",
    short: "Course",
    file: "camera.jl",
    conventions: Some(Conventions {
        axes: Conventions::OURS,
        given_by: "eye, view, up",
        pixels: PixelConvention::FromOne,
        view: "focal: distance / width",
        field: |subject| n(focal(subject)),
        distance: "focal; the viewport is 1 wide",
        shape: "square only: the viewport is H / W high",
        lengths: "f64",
    }),
    write,
};

fn focal(subject: &ExportScene) -> f64 {
    subject.viewport().distance / subject.viewport().width
}

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    subject.square_pixels("the course's camera")?;
    let camera = subject.camera();
    let [width, height] = subject.size();
    let text = format!(
        "PerspectiveCamera(\n    Vec3({}), # eye\n    Vec3({}), # view\n    Vec3({}), # up\n    {}, # focal\n    \
         {height}, {width}) # H, W\n",
        commas(camera.eye),
        commas(camera.view()),
        commas(camera.up()),
        real(focal(subject)),
    );
    let scale = subject.viewport().width;
    if scale != 1.0 {
        notes.push(format!(
            "the course's viewport is 1 wide, this one {}: the same rays, and every t is {} times \
             as large there",
            n(scale),
            n(scale)
        ));
    }
    notes.extend(subject.objects_left_out("the call makes a camera only"));
    Ok(text)
}
