//! The camera that a molecule is looked at with.

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Sphere, Viewport};

/// Half the picture's height as seen from the eye, over the distance: a field of view of 33 degrees,
/// in which spheres at the border are hardly stretched.
const SLOPE: f64 = 0.3;

/// Columns and rows of the picture.
const IMAGE: (u32, u32) = (800, 600);

/// The share of the picture's half that is left free around the molecule.
const MARGIN: f64 = 0.06;

/// A camera that has all of the spheres in its picture, in numbers that can be read out: it looks
/// along the axis along which the molecule is thinnest, from the positive side, at the middle; up is
/// y, or z where it looks along y. The viewport is a third of the way to the molecule, or nearer.
pub(super) fn camera(spheres: impl Iterator<Item = Sphere> + Clone) -> Camera {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for Sphere { center, radius } in spheres.clone() {
        (low, high) = (low.min(center - radius), high.max(center + radius));
    }
    let extent = high - low;
    let (back, up) = match extent.min_element() {
        least if extent.z == least => (DVec3::Z, DVec3::Y),
        least if extent.y == least => (DVec3::Y, DVec3::Z),
        _ => (DVec3::X, DVec3::Y),
    };
    let right = up.cross(back);
    let middle = (0.5 * (low + high)).map(|x| rounded(x, 10.0));
    // As far as a sphere needs: its outline is within the picture's border if its centre is
    // r sqrt(1 + k^2) inside the plane through eye and border, whose slope is k.
    let (columns, rows) = IMAGE;
    let aspect = f64::from(columns) / f64::from(rows);
    let needs = |Sphere { center, radius }: Sphere, axis: DVec3, k: f64| {
        let from_middle = center - middle;
        from_middle.dot(back) + (from_middle.dot(axis).abs() + radius * k.hypot(1.0)) / k
    };
    let slope = SLOPE * (1.0 - MARGIN);
    let far = spheres
        .map(|sphere| needs(sphere, right, slope * aspect).max(needs(sphere, up, slope)))
        .fold(0.0, f64::max);
    let far = rounded(far + 0.05, 10.0);
    let distance = round_below(far / 3.0);
    Camera {
        eye: (middle + far * back).map(|x| rounded(x, 10.0)),
        orientation: Orientation::At { at: middle, up },
        viewport: Viewport {
            width: rounded(2.0 * SLOPE * aspect * distance, 1e4),
            height: rounded(2.0 * SLOPE * distance, 1e4),
            distance,
        },
        image: ImageSize::new(columns, rows).unwrap_or(Camera::CANONICAL.image),
    }
}

/// To the nearest of `steps` parts of 1; no negative zero.
fn rounded(x: f64, steps: f64) -> f64 {
    (x * steps).round() / steps + 0.0
}

/// The largest of ..., 1, 2, 5, 10, 20, ... that is no larger.
fn round_below(x: f64) -> f64 {
    let power = 10_f64.powi(x.log10().floor() as i32);
    [5.0, 2.0].map(|step| step * power).into_iter().find(|step| *step <= x).unwrap_or(power)
}
