//! A camera as the outlines of all spheres need it.

use crate::camera::resolved::ResolvedCamera;

/// A camera as spheres are seen by it: lengths along u, v and -w from the eye, and slopes
/// `x = u / distance`, `y = v / distance` in whole columns and rows.
///
/// ```text
/// x = column_slope (column - middle_column)      y = row_slope (middle_row - row)
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct CameraSpace {
    pub(crate) eye: [f64; 3],
    pub(crate) u: [f64; 3],
    pub(crate) v: [f64; 3],
    pub(crate) w: [f64; 3],
    pub(crate) distance: f64,
    pub(crate) column_slope: f64,
    pub(crate) row_slope: f64,
    /// Columns and rows for each unit of slope, and 1 / distance.
    pub(crate) per_column: f64,
    pub(crate) per_row: f64,
    pub(crate) per_distance: f64,
    /// Rows' slope for each unit of columns' slope, and its square's inverse.
    pub(crate) ratio: f64,
    pub(crate) inverse_ratio_squared: f64,
    pub(crate) middle_column: f64,
    pub(crate) middle_row: f64,
    /// The largest `|x|` and `|y|` of a pixel's centre, and a little more.
    pub(crate) widest: [f64; 2],
    /// `sqrt(1 + widest^2)` of both.
    pub(crate) border_lengths: [f64; 2],
    /// See [`CameraSpace::new`].
    pub(crate) doubt: f64,
    /// True if lengths and slopes are so ordinary that no product of a few of them overflows, and
    /// the basis so close to orthonormal that `doubt` is small.
    pub(crate) is_plain: bool,
}

impl CameraSpace {
    /// The rays are exact; here they are taken from the rounded basis, as if that were orthonormal.
    /// With `u = 2^-53`, `q = center - eye` is off by `u |q|`, its three dot products by `3 u |q|`
    /// each, the basis by its rounding (or, by hand, by its defect) and the slopes by `3 u`: together
    /// by less than 12 u and the defect. So a ray that meets a sphere is one that, here, meets a
    /// sphere of the computed centre that is larger by `doubt (|q| + r)`, and one that meets a sphere
    /// smaller by as much meets the true one.
    pub(crate) fn new(camera: &ResolvedCamera) -> CameraSpace {
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let basis = camera.basis();
        let (u, v, w) = (basis.u, basis.v, basis.w);
        let (viewport, image) = (camera.viewport(), camera.image());
        let (columns, rows) = (f64::from(image.width()), f64::from(image.height()));
        let column_slope = viewport.width / (viewport.distance * columns);
        let row_slope = viewport.height / (viewport.distance * rows);
        let doubt = ROUNDING + 4.0 * basis.defect();
        let plain = 1e-12..1e12;
        let is_plain = plain.contains(&column_slope)
            && plain.contains(&row_slope)
            && (1e-5..1e5).contains(&(column_slope / row_slope))
            && plain.contains(&viewport.distance)
            && camera.eye().abs().max_element() < 1e12
            && doubt < 1e-12;
        let ratio = row_slope / column_slope;
        let widest = [0.5001 * columns * column_slope, 0.5001 * rows * row_slope];
        CameraSpace {
            eye: camera.eye().to_array(),
            u: u.to_array(),
            v: v.to_array(),
            w: w.to_array(),
            distance: viewport.distance,
            column_slope,
            row_slope,
            per_column: 1.0 / column_slope,
            per_row: 1.0 / row_slope,
            per_distance: 1.0 / viewport.distance,
            ratio,
            inverse_ratio_squared: 1.0 / (ratio * ratio),
            middle_column: 0.5 * columns - 0.5,
            middle_row: 0.5 * rows - 0.5,
            widest,
            border_lengths: widest.map(|widest| (1.0 + widest * widest).sqrt()),
            doubt,
            is_plain,
        }
    }
}
