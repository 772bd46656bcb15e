//! OpenCV's K and [R|t], as JSON.
//!
//! ```text
//! s (x, y, 1) = K (R q + t)        x = j, y = i at the centre of pixel (row i, column j)
//! R = (u, -v, -w) as rows          t = -R eye
//! ```

mod fields;
mod read;

use pinhole_core::{DVec3, Intrinsics, Viewport, shortest};

use crate::format::pose::Pose;
use crate::format::text::{flipped, flipped_all, n};
use crate::format::viewport::{settled, shortest_where};
use crate::format::{
    Axis, Conventions, ExportScene, Exported, Format, Importer, PixelConvention, Unsupported,
};

pub(super) const FORMAT: Format = Format {
    name: "opencv",
    label: "OpenCV K [R|t]",
    short: "OpenCV",
    ending: "json",
    conventions: Conventions {
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
    },
    write,
    importer: Some(&IMPORTER),
};

pub(super) const IMPORTER: Importer =
    Importer { name: "opencv", label: "OpenCV K [R|t]", read: read::read, detect: read::detect };

fn write(subject: &ExportScene) -> Result<Exported, Unsupported> {
    let [width, height] = subject.size();
    let Intrinsics { fx, fy, cx, cy } = subject.intrinsics();
    let basis = *subject.resolve().basis();
    let t = translation(subject);
    let text = format!(
        "{{\n  \"image_width\": {width},\n  \"image_height\": {height},\n  \
         \"K\": [[{}, 0, {}],\n        [0, {}, {}],\n        [0, 0, 1]],\n  \
         \"R\": [[{}],\n        [{}],\n        [{}]],\n  \
         \"t\": [{}, {}, {}],\n  \"distortion\": [0, 0, 0, 0, 0]\n}}\n",
        n(fx),
        n(cx - 0.5),
        n(fy),
        n(cy - 0.5),
        basis.u.to_array().map(n).join(", "),
        flipped_all(-basis.v, ", "),
        flipped_all(-basis.w, ", "),
        n(t.x),
        flipped(n(t.y)),
        flipped(n(t.z)),
    );
    let notes = subject.objects_left_out("K and [R|t] are a camera only").into_iter().collect();
    Ok(Exported::one_file("camera.json", &text, notes))
}

/// t = -R eye.
pub(super) fn translation(subject: &ExportScene) -> DVec3 {
    let eye = subject.resolve().basis().to_camera_from_world(subject.resolve().eye());
    DVec3::new(-eye.x, eye.y, eye.z)
}

/// The viewport with as few digits as give these focal lengths.
pub(super) fn viewport_of(
    k: &Intrinsics,
    image: pinhole_core::ImageSize,
    distance: f64,
) -> Viewport {
    let near = k.viewport(image, distance);
    let of = |viewport: Viewport| Intrinsics::from_viewport(&viewport, image);
    let width = shortest_where(near.width, |width| of(Viewport { width, ..near }).fx == k.fx);
    let height = shortest_where(near.height, |height| of(Viewport { height, ..near }).fy == k.fy);
    Viewport { width, height, distance }
}

/// Notes a principal point that is not in the middle.
pub(super) fn off_centre(k: &Intrinsics, image: pinhole_core::ImageSize, notes: &mut Vec<String>) {
    let [right, down] = k.off_centre(image);
    if right.abs().max(down.abs()) > 1e-9 * f64::from(image.width().max(image.height())) {
        notes.push(format!(
            "the principal point is {} pixels right of the image's middle and {} below it: taken as \
             the middle, which every camera here has there",
            shortest((right * 1e6).round() / 1e6),
            shortest((down * 1e6).round() / 1e6)
        ));
    }
}

/// Returns the pose by R's rows and t, in OpenCV's axes.
pub(super) fn pose_of([x, y, z]: [DVec3; 3], t: DVec3) -> Pose {
    // eye = -R^T t
    let eye = DVec3::ZERO - (t.x * x + t.y * y + t.z * z);
    // Nine products and six sums; the digits that they add are not the camera's.
    let roundings = 4.0 * f64::EPSILON * t.length();
    let eye = DVec3::from_array(eye.to_array().map(|x| settled(x, roundings)));
    Pose { eye, right: x, up: -y, backwards: -z }
}
