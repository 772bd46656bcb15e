//! The course's own camera, a call of Julia: `PerspectiveCamera(eye, view, up, focal, H, W)`, whose
//! viewport is 1 wide and H / W high.

use pinhole_core::{Camera, DVec3, Orientation, Viewport};

use super::Format;
use super::Subject;
use super::Taken;
use super::Text;
use super::Unsayable;
use super::Written;
use super::back::image_of;
use super::code::{Code, Comments, split};
use super::sheet::{Sheet, commas, n, real};
use super::terms::{Pixels, Terms};
use crate::formats::FileError;

pub(super) const FORMAT: Format = Format {
    name: "course",
    label: "PerspectiveCamera of the course",
    short: "Course",
    ending: "jl",
    terms: Terms {
        axes: Terms::OURS,
        given_by: "eye, view, up",
        pixels: Pixels::FromOne,
        view: "focal: distance / width",
        field: |subject| n(focal(subject)),
        distance: "focal; the viewport is 1 wide",
        shape: "square only: the viewport is H / W high",
        lengths: "f64",
    },
    write,
    read,
    claims: |text| {
        text.contains("PerspectiveCamera(")
            && !["THREE.", "\"PerspectiveCamera", "new "].iter().any(|other| text.contains(other))
    },
};

fn focal(subject: &Subject) -> f64 {
    subject.viewport().distance / subject.viewport().width
}

fn write(subject: &Subject) -> Result<Written, Unsayable> {
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
    if !(subject.spheres().is_empty() && subject.planes().is_empty()) {
        notes.push("objects are left out: the call makes a camera only".to_owned());
    }
    Ok(Written::of("camera.jl", Sheet::of(&text), notes))
}

fn read(text: &Text, _: &Camera) -> Result<Taken, FileError> {
    let code = Code::new(text, Comments::Hash);
    let calls = code.calls("PerspectiveCamera");
    // What names its arguments by type is the definition.
    let calls: Vec<_> = calls.iter().filter(|call| !call.text.contains("::")).collect();
    let Some(call) = calls.last() else {
        return Err(code.missing("PerspectiveCamera", "it must be called with its six arguments"));
    };
    let mut notes = Vec::new();
    if calls.iter().any(|other| other.text != call.text) {
        notes.push(format!("{} calls of PerspectiveCamera: the last is taken", calls.len()));
    }
    let parts = split(**call);
    let [eye, view, up, focal, rows, columns] = parts[..] else {
        let right = "it must have six arguments: eye, view, up, focal, height, width";
        return Err(code.fault("PerspectiveCamera", **call, right));
    };
    let vector = |name: &str, piece| -> Result<DVec3, FileError> { code.vector(name, piece) };
    let (eye, view, up) = (vector("eye", eye)?, vector("view", view)?, vector("up", up)?);
    let distance = code.number("focal", focal)?;
    if distance <= 0.0 {
        return Err(code.fault("focal", focal, "it must be greater than 0"));
    }
    let image = image_of(code.number("width", columns)?, code.number("height", rows)?)
        .map_err(|right| code.fault("the image's height", rows, &right))?;
    let height = f64::from(image.height()) / f64::from(image.width());
    let camera = Camera {
        eye,
        orientation: Orientation::View { view, up },
        viewport: Viewport { width: 1.0, height, distance },
        image,
    };
    Ok(Taken::camera(camera, notes))
}
