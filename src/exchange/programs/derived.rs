//! Derives this program's camera from what an imported text specifies: the camera's axes and position,
//! an angle of view, and the aspect ratio of the image.

use pinhole_core::glam::{DAffine3, DMat4};
use pinhole_core::{
    Basis, DVec3, ImageSize, ORTHONORMAL_TOLERANCE, Orientation, Viewport, extent_of_fov,
    fov_of_extent,
};

use crate::template::n;

/// The note about a camera in a left-handed world, which is read without its objects.
const MIRRORED: &str = "its world is left-handed, Pinhole's is right-handed: the camera's every z is negated \
                        here, but the objects are not: negate their z, too, for the same picture";

/// Formats a number with at most this many decimals.
pub(super) fn rounded(x: f64, decimals: usize) -> String {
    // A large number keeps its digits, and does not overflow.
    n(format!("{x:.decimals$}").parse().unwrap_or(x))
}

/// Returns the affine map of a 4 x 4 matrix in column-major order. Returns `None` if there are not 16
/// numbers, or if the last row is not 0 0 0 1.
pub(super) fn affine(columns: &[f64]) -> Option<DAffine3> {
    let m = DMat4::from_cols_array(columns.try_into().ok()?);
    (m.row(3).to_array() == [0.0, 0.0, 0.0, 1.0]).then(|| DAffine3::from_mat4(m))
}

/// Returns the orientation and the eye of a camera that looks along its own -z with y up. `frame` maps
/// the camera's coordinates to the world's; its axes may have any length. If they are left-handed,
/// every z is negated, and a note is added.
///
/// # Errors
/// Returns a message about the axes, such as "one of its axes is (0, 0, 0)".
pub(super) fn right_handed(
    frame: &DAffine3,
    notes: &mut Vec<String>,
) -> Result<(Orientation, DVec3), String> {
    let mut frame = *frame;
    let is_mirrored = Basis::is_left_handed(frame.x_axis, frame.y_axis, frame.z_axis);
    if is_mirrored {
        let mirrored = |v: DVec3| DVec3::new(v.x, v.y, 0.0 - v.z);
        let [x, y, z] = [frame.x_axis, frame.y_axis, frame.z_axis].map(mirrored);
        frame = DAffine3::from_cols(x, y, z, mirrored(frame.translation));
    }
    let orientation = orientation([frame.x_axis, frame.y_axis, frame.z_axis], notes)?;
    if is_mirrored {
        notes.push(MIRRORED.to_owned());
    }
    Ok((orientation, frame.translation))
}

/// Returns the orientation with these axes: right, up and backwards. For each correction, a sentence is
/// added to `notes`.
fn orientation(axes: [DVec3; 3], notes: &mut Vec<String>) -> Result<Orientation, String> {
    let axes = axes.map(without_noise);
    let [right, up, backwards] = axes;
    if let Ok(basis) = Basis::by_hand(right, up, backwards) {
        return Ok(Orientation::Basis(basis));
    }
    let [Some(u), Some(v), Some(w)] = axes.map(|axis| axis.try_normalize()) else {
        return Err("one of its axes is (0, 0, 0): it must be a rotation".to_owned());
    };
    let off = Basis::error_of(u, v, w);
    if off > 0.02 {
        return Err(format!(
            "its axes are off a right angle by up to {}: it must be a rotation, without shear",
            rounded(off, 4)
        ));
    }
    let basis = Basis::from_view_up(-w, v).map_err(|error| error.to_string())?;
    if off > ORTHONORMAL_TOLERANCE {
        notes.push(format!(
            "its axes are off a right angle by {off:.0e}: w is as given, v and u straightened"
        ));
    }
    Ok(Orientation::Basis(basis))
}

/// Returns the axis with rounding errors removed: a component that differs only by them from -1, 0 or 1
/// times the axis's length is replaced by a number with few digits.
fn without_noise(axis: DVec3) -> DVec3 {
    let roundings = 4.0 * f64::EPSILON;
    let length = axis.length();
    DVec3::from_array(axis.to_array().map(|x| match (x / length).round() * length {
        whole if (x - whole).abs() <= roundings * length => settled(x, roundings * length),
        _ => x,
    }))
}

/// Rounds `x` to the fewest digits for which the result satisfies `fits`; returns `x` if there are
/// none.
pub(super) fn shortest_where(x: f64, fits: impl Fn(f64) -> bool) -> f64 {
    (0..17)
        .filter_map(|digits| format!("{x:.digits$e}").parse::<f64>().ok())
        .find(|x| fits(*x))
        .unwrap_or(x)
}

/// Rounds `x` to the fewest digits for which the result differs from `x` by at most `roundings`.
pub(super) fn settled(x: f64, roundings: f64) -> f64 {
    if x.abs() <= roundings {
        return 0.0;
    }
    shortest_where(x, |y| (y - x).abs() <= roundings)
}

/// Returns a viewport at `distance` whose height spans this angle in radians, and whose width is
/// `aspect` times its height. Both numbers have as few digits as possible; `fits` decides whether a
/// rounded height is accurate enough.
fn viewport(fov: f64, aspect: f64, distance: f64, fits: impl Fn(f64) -> bool) -> Viewport {
    let height = shortest_where(extent_of_fov(fov, distance), fits);
    let is_in_ratio = |x: f64| (x / height / aspect - 1.0).abs() <= 2.0 * f64::EPSILON;
    let width = match aspect {
        1.0 => height,
        aspect => shortest_where(height * aspect, is_in_ratio),
    };
    Viewport { width, height, distance }
}

/// Returns the viewport at `distance` that spans this vertical angle in degrees and is `aspect` times
/// as wide as high.
pub(super) fn viewport_of_angle(degrees: f64, aspect: f64, distance: f64) -> Viewport {
    let fits = |height| fov_of_extent(height, distance).to_degrees() == degrees;
    viewport(degrees.to_radians(), aspect, distance, fits)
}

/// Returns the same viewport as [`viewport_of_angle`] for an angle in radians.
pub(super) fn viewport_of_radians(fov: f64, aspect: f64, distance: f64) -> Viewport {
    viewport(fov, aspect, distance, |height| fov_of_extent(height, distance) == fov)
}

/// Returns the image size for a format that specifies only the aspect ratio. Of the images up to twice as
/// high as the one at hand, it is the one that has the ratio most nearly (which may have been rounded to
/// `f32`), then the height or width at hand, then multiples of ten pixels, then the nearest height.
pub(super) fn image_of_ratio(
    at_hand: ImageSize,
    aspect: f64,
    program: &str,
    notes: &mut Vec<String>,
) -> ImageSize {
    let (w, h) = (at_hand.width(), at_hand.height());
    let of_height = |height: u32| {
        let width = (f64::from(height) * aspect).round();
        ImageSize::new(width as u32, height).ok()
    };
    let merit = |image: &ImageSize| {
        let off = (image.aspect() / aspect - 1.0).abs();
        let are_tens = [image.width(), image.height()].iter().all(|n| n.is_multiple_of(10));
        let is_other = image.height() != h && !(image.width() == w && are_tens);
        let farther = image.height().abs_diff(h);
        (off > 1e-6, off > 1e-9, is_other, image.height() != h, !are_tens, farther)
    };
    let image = (1..=h.saturating_mul(2)).filter_map(of_height).min_by_key(merit);
    let image = image.unwrap_or(at_hand);
    let unsaid = format!("{program} does not say how many pixels there are");
    notes.push(size_note(&unsaid, image, " taken"));
    image
}

/// Returns the note that says which size is used for an image whose size the text does not specify.
/// `unsaid` says what is missing, and `taken` why this size is used.
pub(super) fn size_note(unsaid: &str, image: ImageSize, taken: &str) -> String {
    format!("{unsaid}: {} × {}{taken}", image.width(), image.height())
}

/// Returns the image size, if it is valid.
pub(super) fn image_of(width: f64, height: f64) -> Result<ImageSize, String> {
    let whole = |x: f64| x.fract() == 0.0 && (1.0..=f64::from(ImageSize::MAX)).contains(&x);
    if !(whole(width) && whole(height)) {
        return Err(format!("it must be whole numbers from 1 to {}", ImageSize::MAX));
    }
    ImageSize::new(width as u32, height as u32).map_err(|error| error.to_string())
}
