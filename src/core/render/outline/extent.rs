//! Rectangles of the pixels of a raster that a sphere can cover.

use std::ops::Range;

use glam::DVec3;

use crate::camera::resolved::ResolvedCamera;
use crate::render::frame::Raster;
use crate::scene::sphere::Sphere;

/// Rows and columns of a raster, not of the image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    rows: [u16; 2],
    columns: [u16; 2],
}

impl Extent {
    pub(crate) fn new(rows: Range<usize>, columns: Range<usize>) -> Extent {
        let pair = |range: Range<usize>| [range.start as u16, range.end as u16];
        Extent { rows: pair(rows), columns: pair(columns) }
    }

    pub(crate) fn rows(&self) -> Range<usize> {
        usize::from(self.rows[0])..usize::from(self.rows[1])
    }

    pub(crate) fn columns(&self) -> Range<usize> {
        usize::from(self.columns[0])..usize::from(self.columns[1])
    }
}

/// A camera and a raster as the extents of all spheres need them.
pub(crate) struct Extents<'a> {
    camera: &'a ResolvedCamera,
    raster: &'a Raster,
    /// See [`Extents::new`].
    doubt: f64,
    /// Pixels for each unit of `u / distance`.
    columns_per_slope: f64,
    rows_per_slope: f64,
}

impl<'a> Extents<'a> {
    /// The rays are exact; the bounds are computed in `f64` from the rounded basis and the rounded
    /// way to the centre. With respect to that basis, taken as orthonormal, a ray is off by the
    /// basis' rounding (or, by hand, by its tolerance), and the centre by the rounding of its
    /// coordinates: all together by less than `doubt` times their length, a share of the length, not
    /// of each coordinate, which on a viewport of extreme aspect is the difference between a margin
    /// and none. So a ray that meets the sphere is, in these coordinates, one that meets a sphere
    /// larger by `doubt * (|oc| + r)`.
    pub(crate) fn new(camera: &'a ResolvedCamera, raster: &'a Raster) -> Extents<'a> {
        const ROUNDING: f64 = 64.0 * f64::EPSILON;
        let (viewport, image) = (camera.viewport(), camera.image());
        Extents {
            camera,
            raster,
            doubt: ROUNDING + 4.0 * camera.basis().defect(),
            columns_per_slope: viewport.distance / viewport.width * f64::from(image.width()),
            rows_per_slope: viewport.distance / viewport.height * f64::from(image.height()),
        }
    }

    /// A rectangle that contains every pixel of the raster whose view ray can hit the sphere at
    /// `t > 0`; `None` where no pixel's can.
    ///
    /// In camera coordinates the view rays tangent to the sphere's outline in the u-w plane have
    ///
    /// ```text
    /// u / distance = (x z -+ r sqrt(x^2 + z^2 - r^2)) / (z^2 - r^2)
    /// ```
    ///
    /// with z the centre's depth; likewise for v. They bound the sphere while it lies wholly in front
    /// of the eye (z > r). A sphere that crosses the eye's plane can be anywhere in the image.
    pub(crate) fn find(&self, sphere: &Sphere) -> Option<Extent> {
        let to_center = sphere.center - self.camera.eye();
        let q = self.camera.basis().to_camera_from_world(to_center);
        let depth = -q.z;
        let radius = sphere.radius + self.doubt * (sphere.radius + to_center.abs().element_sum());
        let is_plain = is_in_plain_range(q, radius);
        if is_plain && depth + radius < 0.0 {
            return None;
        }
        let (rows, columns) = if is_plain && depth > radius {
            let image = self.camera.image();
            let (left, right) = tangents(q.x, depth, radius);
            let (bottom, top) = tangents(q.y, depth, radius);
            let columns = cells(left, right, self.columns_per_slope, image.width());
            (cells(-top, -bottom, self.rows_per_slope, image.height()), columns)
        } else {
            (0..u32::MAX, 0..u32::MAX)
        };
        let part = |cells: Range<u32>, cells_shown: &[u32]| {
            [cells.start, cells.end].map(|cell| cells_shown.partition_point(|x| *x < cell) as u16)
        };
        let (rows, columns) =
            (part(rows, self.raster.rows()), part(columns, self.raster.columns()));
        let is_seen = rows[0] < rows[1] && columns[0] < columns[1];
        is_seen.then_some(Extent { rows, columns })
    }
}

/// Returns whether the formula for the tangents neither overflows nor underflows.
fn is_in_plain_range(q: DVec3, radius: f64) -> bool {
    q.abs().max_element() < 1e100 && radius > 1e-100
}

/// The slopes of the two tangents from the eye to a circle of `radius` around `(x, depth)`,
/// `depth > radius`.
fn tangents(x: f64, depth: f64, radius: f64) -> (f64, f64) {
    let denominator = (depth - radius) * (depth + radius);
    let swing = radius * (x * x + denominator).sqrt();
    ((x * depth - swing) / denominator, (x * depth + swing) / denominator)
}

/// The cells, `count` of which span the viewport, whose centres can lie between two slopes.
fn cells(from: f64, to: f64, cells_per_slope: f64, count: u32) -> Range<u32> {
    /// Share of a cell, for the rounding of cell centres (below 1e-10 of 65536 cells).
    const MARGIN: f64 = 1e-6;
    /// Allowance for the rounding of slopes. Where one tangent is steep and the other is not, the
    /// steep one's rounding is in both.
    const RELATIVE_MARGIN: f64 = 1e-9;
    let (from, to) = (from * cells_per_slope, to * cells_per_slope);
    let margin = MARGIN + RELATIVE_MARGIN * (from.abs() + to.abs());
    // Cell k's centre is k + 0.5 cells from the viewport's edge.
    let middle = 0.5 * f64::from(count) - 0.5;
    let (first, last) = (middle + from - margin, middle + to + margin);
    if first.is_nan() || last.is_nan() {
        return 0..u32::MAX;
    }
    // A cast from float saturates at both ends of u32.
    first.ceil() as u32..(last + 1.0).floor() as u32
}
