//! The outlines of several spheres at once (one per SIMD lane), in columns and rows of the image, and
//! the rectangles of pixels that spheres can cover.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;
use glam::DVec3;

use crate::camera::resolved::ResolvedCamera;
use crate::render::frame::Raster;
use crate::render::outline::raster_axes::CameraSpace;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::SphereSlots;

pub(crate) mod raster_axes;
pub(crate) mod small_outlines;

/// Distance, in columns, from the ends of a row of an outline. Pixels farther from the ends are
/// certainly inside or outside; nearer ones are in doubt. The distance is far more than the error of an
/// end, and so small that hardly any pixel is in doubt.
pub(crate) const MARGIN: f64 = 1.0 / 131_072.0;

/// The number of `f64` lanes in the widest SIMD vector of any level.
pub(crate) const MOST_LANES: usize = 8;

/// `2^50`, rounded up: the factor for wide spheres in the choice of [`Outline::thin`], see
/// [`Outlines::find`].
const KEEP: f64 = 1.126e15;

/// The number of `f32` lanes in the widest SIMD vector of any level.
pub(crate) const MOST_SINGLE_LANES: usize = 2 * MOST_LANES;

type Lane8 = [f64; MOST_LANES];

/// The outline of a sphere in the image, row by row. Let c be a column number, and j a row number
/// counted from the row of the sphere's centre. On row j, a sphere that is seen from outside and lies
/// wholly in front of the eye covers the columns
///
/// ```text
/// |c - (column + shear j)| <= w(j)      w^2 = square0 + square1 j + square2 j^2
/// ```
///
/// where w is half the width of the row. In these columns, with
/// `S^2 = w^2 - (c - (column + shear j))^2`, the first hit is at
///
/// ```text
/// t = numerator / (b(c, j) + S)         b = b0 + b_column c + b_row j
/// ```
///
/// where b and S are, up to a common factor, `q.d` and `sqrt D` of the sphere's quadratic.
///
/// Derivation: let r be the radius, `q = (X, Y, -Z)` the centre in camera coordinates,
/// `(xc, yc) = (X, Y) / Z`, and `d = (x, y, -1)` a direction with `(x, y) = (xc, yc) + (dx, dy)`. At
/// `(dx, dy) = 0`, d is parallel to q, so that nothing cancels in the discriminant
/// `D = r^2 d.d - |q x d|^2`:
///
/// ```text
/// D = r^2 (1 + xc^2 + yc^2) + 2 r^2 (xc dx + yc dy)
///     + (r^2 - Z^2 - Y^2) dx^2 + 2 X Y dx dy + (r^2 - Z^2 - X^2) dy^2
/// ```
///
/// With `h = Z^2 + Y^2 - r^2` and the change s of x from one column to the next, `D = h s^2 S^2`; b is
/// `q.d / (s sqrt h)`, and the numerator is `(|q|^2 - r^2) / (distance s sqrt h)`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Outline<T = f64, Mask = bool> {
    pub(crate) column: T,
    /// The middle row of the image.
    pub(crate) middle_row: f64,
    /// Row of the centre, counted from the middle row: `j = (row number - middle_row) - row`. The error
    /// of j is thus relative to these small differences, not to a large row number.
    pub(crate) row: T,
    pub(crate) shear: T,
    pub(crate) square: [T; 3],
    pub(crate) b0: T,
    pub(crate) b_column: T,
    pub(crate) b_row: T,
    pub(crate) numerator: T,
    /// Error bound of `w^2`.
    pub(crate) square_doubt: T,
    /// Number of the first row with `w^2 >= -square_doubt`, a whole number. The row may lie outside the
    /// image.
    pub(crate) first_row: T,
    /// Number of the last row with `w^2 >= -square_doubt`, a whole number. The row may lie outside the
    /// image.
    pub(crate) last_row: T,
    /// Lower bound of `t` of all hits.
    pub(crate) nearest: T,
    /// Value of `w^2`, the square of half a row's width, below which a row is *thin*: so close to the
    /// outline's top or bottom that its pixels are decided individually, by the ladder.
    pub(crate) thin: T,
    /// True if the sphere is so wide that the rounding error of the root S must be corrected, too, as
    /// [`wide`](crate::render::rows::span::SpanLanes::wide) does.
    pub(crate) corrects_root: Mask,
}

/// The outlines of a SIMD vector of spheres, one in each lane.
#[derive(Clone, Default)]
pub(crate) struct Outlines {
    pub(crate) lanes: Outline<Lane8, u64>,
    /// Upper bounds of `w^2`, the square of half a row's width.
    pub(crate) size: Lane8,
    /// Lanes in which all fields above are valid.
    pub(crate) is_plain: u64,
    /// Lanes whose spheres lie wholly behind the eye.
    pub(crate) is_behind: u64,
    /// Lanes whose spheres lie outside the view: no ray through the image can meet them.
    pub(crate) is_outside: u64,
}

/// Returns the dot product `q . axis` in each lane.
#[inline(always)]
fn along<S: Simd>(simd: S, q: [S::f64s; 3], axis: [f64; 3]) -> S::f64s {
    let axis = axis.map(|x| S::f64s::splat(simd, x));
    q[0] * axis[0] + q[1] * axis[1] + q[2] * axis[2]
}

impl Outlines {
    /// Finds the outlines of the spheres in a SIMD vector of slots.
    ///
    /// Error bounds, with the symbols of [`Outline`], `c = |q|^2 - r^2`, `u = 2^-53` and
    /// `k = r^2 / (Z^2 - r^2)`, which neither `r^2 / h` nor `r^2 / c` exceeds: the coefficients of `w^2`
    /// are computed by at most a dozen operations, each on numbers of one sign, apart from c, h and
    /// `Z^2 - r^2`, whose relative error is larger by a factor of `1 + k`. So each coefficient is off by
    /// less than `16 u (4 + 8 k)` of itself. The radius itself may be off by `eta = doubt (|q| + r)`
    /// (see [`CameraSpace::new`]), which moves each coefficient by at most `(4 + 8 k) eta / r` of
    /// itself: `r^2 / h` by `(2 + 2 k) eta / r`, its square by twice that, and
    /// `square2 = -c (Z^2 - r^2) / h^2` by `8 k eta / r`. In the rows that the sphere covers, the terms
    /// of `w^2` add up to at most `4 (square0 + square1^2 / |square2|)`.
    ///
    /// At any hit `b >= sqrt(b^2 - S^2) >= sqrt c / (s sqrt h)`, the least b. A pixel that lies at least
    /// [`MARGIN`] inside a row's ends, in a row that is not thin, has
    /// `S^2 >= MARGIN sqrt(thin) = keep square_doubt`. S is off by `square_doubt / (2 S)` at most, which
    /// is at most `2^-28` of b if `keep >= square_doubt 2^54 / b^2`. For wide spheres, whose kernel
    /// leaves more room for errors, `2^-26` of b suffices, with `2^50` in place of `2^54`. With
    /// `sqrt(2 w + 1) < 0.1 b` the rounding in a wide row adds less than `0.2 2^-24` of b.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(&mut self, simd: S, space: &CameraSpace, slots: &SphereSlots) {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let centers = Centers::<S>::new(simd, space, slots);
        let Centers { x, y, z, r, qq } = centers;
        let (one, two) = (splat(1.0), splat(2.0));
        let (yy, zz, rr) = (y * y, z * z, r * r);
        let h = zz + yy - rr;
        let c = qq - rr;
        let depths = (z - r) * (z + r);

        let inverse_zr = one / (z * r);
        let (inverse_z, inverse_r) = (inverse_zr * r, inverse_zr * z);
        let inverse_h = one / h;
        // One division instead of three.
        let inverse_c_depths = one / (c * depths);
        let (xc, yc) = (x * inverse_z, y * inverse_z);
        let (per_column, per_row) = (splat(space.per_column), splat(space.per_row));
        let column_center = splat(space.middle_column) + xc * per_column;
        let row = -(yc * per_row);
        let by_h = rr * inverse_h;
        let offset = by_h * xc * per_column;
        let ratio = splat(space.ratio);
        let shear = -(x * y * inverse_h * ratio);
        let stretch = by_h * per_column * per_column;
        let square0 = stretch * (one + xc * xc + yc * yc) + offset * offset;
        let square1 = two * (offset * shear - stretch * yc * splat(space.row_slope));
        let minus_square2 = (c * inverse_h) * (depths * inverse_h) * (ratio * ratio);

        // Rows: where w^2 = 0.
        let inverse_square2 = (h * h) * inverse_c_depths * splat(space.inverse_ratio_squared);
        let eta = centers.eta(simd, space);
        let near = splat(8.0) * rr * (c * inverse_c_depths) + splat(4.0);
        let share = near * (splat(16.0 * 1.2e-16) + eta * inverse_r);
        let size = square0 + square1 * square1 * inverse_square2;
        let square_doubt = share * (splat(4.0) * size);
        let middle = splat(0.5) * square1 * inverse_square2;
        let reach = ((square0 + square_doubt) * inverse_square2 + middle * middle).sqrt();
        let margin = splat(1e-6) + splat(1e-12) * row.abs();
        let reach = reach + margin;
        let whole = splat(space.middle_row) + row;
        let (first_row, last_row) = (whole + middle - reach, whole + middle + reach);

        let root = inverse_h.sqrt();
        let per_s = root * per_column;
        let b_column = x * root;
        let b_row = -(y * root * ratio);
        let b0 = qq * inverse_z * per_s - b_column * column_center;
        let numerator = c * per_s * splat(space.per_distance);
        let nearest = (z - r - eta) * splat(space.per_distance) * splat(1.0 - 1e-6);

        let kinds = Kinds::<S>::new(
            simd,
            [c * inverse_h, h * (depths * inverse_c_depths)],
            (space, size, square_doubt),
            b_column,
        );
        let far = splat(131_072.0);
        let is_plain = centers.are_plain(simd)
            & kinds.is_plain(simd, numerator, nearest)
            & column_center.abs().simd_lt(far)
            & row.abs().simd_lt(far)
            & size.simd_lt(far * far)
            & size.simd_gt(splat(1e-12));
        self.is_plain = if space.is_plain { is_plain.to_bitmask() } else { 0 };
        (self.is_behind, self.is_outside) = centers.not_seen(simd, space);
        let put = |to: &mut Lane8, x: S::f64s| x.store_slice(&mut to[..S::f64s::LEN]);
        put(&mut self.size, size);
        let lanes = &mut self.lanes;
        lanes.corrects_root = kinds.corrects_root.to_bitmask();
        put(&mut lanes.column, column_center + offset);
        lanes.middle_row = space.middle_row;
        put(&mut lanes.row, row);
        put(&mut lanes.shear, shear);
        put(&mut lanes.square[0], square0);
        put(&mut lanes.square[1], square1);
        put(&mut lanes.square[2], -minus_square2);
        put(&mut lanes.b0, b0);
        put(&mut lanes.b_column, b_column);
        put(&mut lanes.b_row, b_row);
        put(&mut lanes.numerator, numerator);
        put(&mut lanes.square_doubt, square_doubt);
        put(&mut lanes.first_row, first_row.ceil());
        put(&mut lanes.last_row, last_row.floor());
        put(&mut lanes.nearest, nearest);
        put(&mut lanes.thin, (kinds.thin * kinds.thin).max(splat(32.0) * square_doubt));
    }

    /// Returns the outline in one lane.
    #[inline(always)]
    pub(crate) fn one(&self, lane: usize) -> Outline {
        let lanes = &self.lanes;
        Outline {
            column: lanes.column[lane],
            middle_row: lanes.middle_row,
            row: lanes.row[lane],
            shear: lanes.shear[lane],
            square: lanes.square.map(|x| x[lane]),
            b0: lanes.b0[lane],
            b_column: lanes.b_column[lane],
            b_row: lanes.b_row[lane],
            numerator: lanes.numerator[lane],
            square_doubt: lanes.square_doubt[lane],
            first_row: lanes.first_row[lane],
            last_row: lanes.last_row[lane],
            nearest: lanes.nearest[lane],
            thin: lanes.thin[lane],
            corrects_root: lanes.corrects_root >> lane & 1 == 1,
        }
    }
}

/// The centres of a SIMD vector of spheres, as coordinates x, y, z along the camera's u, v and -w from
/// the eye, with the radii r and the squared distances qq from the eye.
#[derive(Clone, Copy)]
pub(crate) struct Centers<S: Simd> {
    x: S::f64s,
    y: S::f64s,
    z: S::f64s,
    r: S::f64s,
    qq: S::f64s,
}

impl<S: Simd> Centers<S> {
    #[inline(always)]
    fn new(simd: S, space: &CameraSpace, slots: &SphereSlots) -> Self {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let load = |x: &[f64]| S::f64s::from_slice(simd, &x[..S::f64s::LEN]);
        let q = [
            load(slots[0]) - splat(space.eye[0]),
            load(slots[1]) - splat(space.eye[1]),
            load(slots[2]) - splat(space.eye[2]),
        ];
        let x = along(simd, q, space.u);
        let y = along(simd, q, space.v);
        let z = -along(simd, q, space.w);
        Centers { x, y, z, r: load(slots[3]), qq: x * x + y * y + z * z }
    }

    /// Returns the lanes whose spheres lie in front of the eye, have ordinary sizes, and lose no digits
    /// in `h = z^2 + y^2 - r^2`.
    #[inline(always)]
    fn are_plain(self, simd: S) -> <S::f64s as SimdBase<S>>::Mask {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let Centers { z, r, qq, .. } = self;
        z.simd_gt(r * 1.07)
            & qq.simd_lt(splat(1e24))
            & r.simd_gt(splat(1e-12))
            & r.simd_gt(z * splat(1e-9))
    }

    /// Returns bounds of the radii's errors, see [`CameraSpace::new`].
    #[inline(always)]
    fn eta(self, simd: S, space: &CameraSpace) -> S::f64s {
        let Centers { x, y, z, r, .. } = self;
        S::f64s::splat(simd, space.doubt) * (x.abs() + y.abs() + z.abs() + r)
    }

    /// Returns two masks: the spheres that lie behind the eye, and those that lie beyond one of the
    /// image's four borders. Both allow for all rounding errors.
    #[inline(always)]
    fn not_seen(self, simd: S, space: &CameraSpace) -> (u64, u64) {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let Centers { x, y, z, r, qq } = self;
        let safe = r + self.eta(simd, space) * 4.0;
        let is_ordinary = qq.simd_gt(splat(1e-200))
            & qq.simd_lt(splat(1e200))
            & r.simd_gt(splat(1e-100))
            & r.simd_lt(splat(1e100));
        let is_behind = (z + safe).simd_lt(splat(0.0));
        let [wide, high] = space.widest;
        // The plane through the eye and the border x = widest: (1, -widest) over its length.
        let [wide_length, high_length] = space.border_lengths;
        let is_outside = (x.abs() - z * splat(wide)).simd_gt(safe * splat(wide_length))
            | (y.abs() - z * splat(high)).simd_gt(safe * splat(high_length));
        ((is_behind & is_ordinary).to_bitmask(), (is_outside & is_ordinary).to_bitmask())
    }
}

/// How the rows of each sphere of a SIMD vector are drawn: with or without correcting the rounding error
/// of the root S (see [`Outline`]). The least value of b (see [`Outlines::find`]) is stored as its
/// square, so that the only square root to compute is that of the width, in `f32`, rounded up.
struct Kinds<S: Simd> {
    corrects_root: <S::f64s as SimdBase<S>>::Mask,
    /// Lanes in which the kernel that corrects the rounding error of the root is accurate enough.
    can_correct_root: <S::f64s as SimdBase<S>>::Mask,
    /// The square root of [`Outline::thin`].
    thin: S::f64s,
    /// The square of the least b.
    least: S::f64s,
}

impl<S: Simd> Kinds<S> {
    /// Chooses how rows are drawn, given `c / h` and its inverse, with the symbols of
    /// [`Outlines::find`].
    #[inline(always)]
    fn new(
        simd: S,
        [c_by_h, h_by_c]: [S::f64s; 2],
        (space, size, square_doubt): (&CameraSpace, S::f64s, S::f64s),
        b_column: S::f64s,
    ) -> Self {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let (one, slope) = (splat(1.0), splat(space.column_slope * space.column_slope));
        let least = c_by_h * splat(space.per_column * space.per_column);
        let widest = size.narrow(size).sqrt().widen().0 * splat(1.0 + 1e-6);
        let b_column = b_column.abs();
        let error = (splat(4.5) + splat(4.0) * b_column) * widest;
        let corrects_root = (error * error).simd_gt(splat(0.42 * 0.42) * least);
        let root_error = corrects_root.select(splat(KEEP), splat(16.0 * KEEP));
        let keep = (square_doubt * root_error * (h_by_c * slope)).max(splat(32.0));
        let thin = square_doubt * keep * splat(1.0 / MARGIN);
        let twice = b_column * widest + b_column * widest;
        let can_correct_root = widest.simd_lt(splat(2040.0))
            & (twice * twice).simd_lt(splat(16.0) * least)
            & (widest + widest + one).simd_lt(splat(0.01) * least);
        Kinds { corrects_root, can_correct_root, thin, least }
    }

    /// Returns the lanes in which the chosen way to draw rows is accurate enough, and whose values `f32`
    /// can hold.
    #[inline(always)]
    fn is_plain(
        &self,
        simd: S,
        numerator: S::f64s,
        nearest: S::f64s,
    ) -> <S::f64s as SimdBase<S>>::Mask {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let in_range = |x: S::f64s| x.simd_gt(splat(1e-20)) & x.simd_lt(splat(1e20));
        self.thin.simd_lt(splat(32.0))
            & (self.can_correct_root | !self.corrects_root)
            & self.least.simd_gt(splat(1e-40))
            & self.least.simd_lt(splat(1e40))
            & in_range(numerator)
            & in_range(nearest)
            & (numerator * numerator).simd_lt(self.least * splat(1e40))
    }
}

/// A rectangle of pixels: a range of rows and a range of columns, counted in the raster, not in the
/// image.
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

/// The data of a camera and a raster from which the extents of spheres are computed.
pub(crate) struct Extents<'a> {
    camera: &'a ResolvedCamera,
    raster: &'a Raster,
    /// Relative error of centres and rays, see [`Extents::new`].
    doubt: f64,
    /// Number of columns per unit of the slope `u / distance`.
    columns_per_slope: f64,
    /// Number of rows per unit of the slope `v / distance`.
    rows_per_slope: f64,
}

impl<'a> Extents<'a> {
    /// Computes the data. The field `doubt`, a relative error, is derived as follows. The rays are
    /// exact, but the bounds are computed in `f64` from the rounded basis, as if it were orthonormal,
    /// and from the rounded vector oc to the centre. In these coordinates, the error of a ray comes from
    /// rounding the basis (or from its tolerance, if it is given by hand), and that of the centre from
    /// rounding its coordinates. Together they are less than `doubt` times the length of the vector, not
    /// of each coordinate, which matters on a viewport of extreme aspect. So a ray that hits the sphere
    /// hits, in these coordinates, a sphere whose radius is larger by `doubt * (|oc| + r)`.
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

    /// Finds a rectangle that contains every pixel of the raster whose view ray can hit the sphere at
    /// `t > 0`; returns `None` if no view ray can.
    ///
    /// In camera coordinates the view rays tangent to the sphere's outline in the u-w plane have
    ///
    /// ```text
    /// u / distance = (x z -+ r sqrt(x^2 + z^2 - r^2)) / (z^2 - r^2)
    /// ```
    ///
    /// with x the centre's coordinate along u, z its depth and r the radius; likewise for v. They bound
    /// the sphere if it lies wholly in front of the eye (z > r). A sphere that crosses the eye's plane
    /// can be anywhere in the image.
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

/// Returns whether the formula for the tangents to a sphere with the centre `q`, in camera
/// coordinates, neither overflows nor underflows.
fn is_in_plain_range(q: DVec3, radius: f64) -> bool {
    q.abs().max_element() < 1e100 && radius > 1e-100
}

/// Returns the slopes of the two tangents from the eye to a circle of `radius` around `(x, depth)`,
/// where `depth > radius`. The slope of a line through the eye is its sideways offset per unit of
/// depth, `u / distance` or `v / distance`.
fn tangents(x: f64, depth: f64, radius: f64) -> (f64, f64) {
    let denominator = (depth - radius) * (depth + radius);
    let swing = radius * (x * x + denominator).sqrt();
    ((x * depth - swing) / denominator, (x * depth + swing) / denominator)
}

/// Returns the range of columns, or of rows, whose centres can lie between the view rays with the
/// slopes `from` and `to`, as [`tangents`] returns them. `count` columns or rows span the viewport.
fn cells(from: f64, to: f64, cells_per_slope: f64, count: u32) -> Range<u32> {
    /// Allowance, in rows or columns, for the rounding errors of their centres (below 1e-10 if there are
    /// 65536).
    const MARGIN: f64 = 1e-6;
    /// Allowance for the rounding of slopes. If one tangent is steep and the other is not, the rounding
    /// of the steep one affects both slopes.
    const RELATIVE_MARGIN: f64 = 1e-9;
    let (from, to) = (from * cells_per_slope, to * cells_per_slope);
    let margin = MARGIN + RELATIVE_MARGIN * (from.abs() + to.abs());
    // Cell k's centre is k + 0.5 cells from the viewport's edge.
    let middle = 0.5 * f64::from(count) - 0.5;
    let (first, last) = (middle + from - margin, middle + to + margin);
    if first.is_nan() || last.is_nan() {
        return 0..u32::MAX;
    }
    // A cast from float saturates at either end of u32.
    first.ceil() as u32..(last + 1.0).floor() as u32
}
