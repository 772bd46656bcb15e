//! The course's own camera, a call of Julia: `PerspectiveCamera(eye, view, up, focal, H, W)`, whose
//! viewport is 1 wide and H / W high.

use pinhole_core::{Camera, Orientation, Viewport};

use super::literal::{Source, last_segment};
use crate::FileError;
use crate::format::image_size::image_of;
use crate::format::text::{commas, n, real};
use crate::format::{
    Conventions, ExportScene, Exported, Format, Imported, Importer, Input, PixelConvention,
    Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "course",
    label: "PerspectiveCamera of the course",
    short: "Course",
    ending: "jl",
    conventions: Conventions {
        axes: Conventions::OURS,
        given_by: "eye, view, up",
        pixels: PixelConvention::FromOne,
        view: "focal: distance / width",
        field: |subject| n(focal(subject)),
        distance: "focal; the viewport is 1 wide",
        shape: "square only: the viewport is H / W high",
        lengths: "f64",
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer = Importer {
    name: "course",
    label: "PerspectiveCamera of the course",
    read,
    detect: |text| {
        text.contains("PerspectiveCamera(")
            && !["THREE.", "\"PerspectiveCamera", "new "].iter().any(|other| text.contains(other))
    },
};

fn focal(subject: &ExportScene) -> f64 {
    subject.viewport().distance / subject.viewport().width
}

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
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
    let mut notes = Vec::new();
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
    Ok(Exported::one_file("camera.jl", &text, notes))
}

const RIGHT: &str = "it must be one call of PerspectiveCamera(eye, view, up, focal, height, width), given by \
                     numbers";

fn read(text: &Input, _: &Camera) -> Result<Imported, FileError> {
    let source = Source::new(text, RIGHT)?;
    let [call] = &source.statements[..] else {
        return Err(match source.statements.get(1) {
            Some(second) => source.refused(second, RIGHT),
            None => source.missing("PerspectiveCamera", RIGHT),
        });
    };
    if last_segment(&call.called) != "PerspectiveCamera" || call.is_new {
        return Err(source.refused(call, RIGHT));
    }
    let [eye, view, up, focal, rows, columns] = &call.arguments[..] else {
        return Err(source.refused(call, RIGHT));
    };
    let (eye, view) = (source.vector("eye", eye)?, source.vector("view", view)?);
    let up = source.vector("up", up)?;
    let distance = source.number("focal", focal)?;
    if distance <= 0.0 {
        return Err(source.fault("focal", focal, "it must be greater than 0"));
    }
    let image = image_of(source.number("width", columns)?, source.number("height", rows)?)
        .map_err(|right| source.fault("the image's height", rows, &right))?;
    let height = f64::from(image.height()) / f64::from(image.width());
    let camera = Camera {
        eye,
        orientation: Orientation::View { view, up },
        viewport: Viewport { width: 1.0, height, distance },
        image,
    };
    Ok(Imported::camera(camera, Vec::new()))
}
