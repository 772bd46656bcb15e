//! OpenCV's K and [R|t], as JSON.
//!
//! ```text
//! s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
//! R = (u, -v, -w) as rows          t = -R eye
//! ```

use pinhole_core::Intrinsics;

use crate::format::text::{commas, commas_of, flipped, n};
use crate::format::{Axis, Conventions, ExportScene, Format, PixelConvention, Unsupported};

pub(super) const FORMAT: Format = Format {
    name: "opencv",
    label: "OpenCV K [R|t]",
    short: "OpenCV",
    file: "camera.json",
    conventions: Some(Conventions {
        axes: [Axis::U, Axis::MINUS_V, Axis::MINUS_W],
        given_by: "R from world to camera, t = −R eye",
        pixels: PixelConvention::AtCentre,
        view: "fx, fy: distance / pixel's width and height, in pixels",
        field: |subject| {
            let Intrinsics { fx, fy, .. } = subject.intrinsics();
            format!("{}, {}", n(fx), n(fy))
        },
        distance: "none: K knows pixels only",
        shape: "any: fx and fy differ",
        lengths: "f64",
    }),
    write,
};

fn write(subject: &ExportScene, notes: &mut Vec<String>) -> Result<String, Unsupported> {
    let [width, height] = subject.size();
    let Intrinsics { fx, fy, cx, cy } = subject.intrinsics();
    let basis = *subject.resolve().basis();
    let eye = basis.to_camera_from_world(subject.resolve().eye());
    let text = format!(
        "{{\n  \"image_width\": {width},\n  \"image_height\": {height},\n  \
         \"K\": [[{}, 0, {}],\n        [0, {}, {}],\n        [0, 0, 1]],\n  \
         \"R\": [[{}],\n        [{}],\n        [{}]],\n  \
         \"t\": [{}, {}, {}],\n  \"distortion\": [0, 0, 0, 0, 0]\n}}\n",
        n(fx),
        n(cx - 0.5),
        n(fy),
        n(cy - 0.5),
        commas(basis.u),
        commas_of(-basis.v, flipped),
        commas_of(-basis.w, flipped),
        n(-eye.x),
        flipped(eye.y),
        flipped(eye.z),
    );
    notes.extend(subject.objects_left_out("K and [R|t] are a camera only"));
    Ok(text)
}
