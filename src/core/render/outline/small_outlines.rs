//! Outlines of spheres that are small compared with their distance, one in each lane of a SIMD vector of
//! `f32`.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use crate::render::outline::raster_axes::{CameraSpace, RasterAxes};
use crate::render::outline::{Centers, KEEP, MARGIN, MOST_LANES, MOST_SINGLE_LANES};
use crate::scene::sphere_index::SphereSlots;

/// One `f32` for each sphere of a SIMD vector of spheres.
pub(crate) type Singles = [f32; MOST_SINGLE_LANES];
/// One `f64` for each sphere of a SIMD vector of spheres, in two halves, because a SIMD vector holds
/// half as many `f64` as `f32`.
pub(crate) type Halves = [[f64; MOST_LANES]; 2];

/// The largest square of half a row's width at which `f32` can hold both column numbers, counted from
/// the row's first one, and the fractions that are added to them, as
/// [`Runs::t`](crate::render::rows::small_spheres::Runs::t) requires.
const MOST_SIZE: f32 = 4_194_304.0;

/// Factor that turns the result of a few rounded `f32` operations into an upper bound of the exact
/// result.
const UP: f32 = 1.0 + 1e-5;

/// Outlines of small spheres, in nearly the form of [`Outline`](crate::render::outline::Outline). Let
/// c be a column number, and j a row number counted from the row of the sphere's centre,
/// `middle_row + row`. On row j, a sphere covers the columns c within w of `middle + shear j`, where w
/// is half the width of the row, and `w^2` is a polynomial in j with the coefficients `square`. In
/// these columns, with `S^2 = w^2 - (c - middle - shear j)^2`, the first hit is at
///
/// ```text
/// t = Q / (1 + e)      e = slope (c - column) + row_slope j + inverse S
/// ```
///
/// where `(middle_row + row, column)` is the centre in the picture, and Q is the `t` that the centre
/// would have if S were 0. Derivation: with q, X, Y, Z, r, h and s as for `Outline`, `q.d` is
/// `|q|^2 / Z` at the centre and linear in row and column, and `sqrt D` is `sqrt h s S`. Dividing
/// numerator and denominator of `t` by `|q|^2 / Z` gives
///
/// ```text
/// Q = Z (1 - r^2 / |q|^2) / distance      slope = s X Z / |q|^2      inverse = s sqrt h Z / |q|^2
/// ```
#[derive(Clone, Debug, Default)]
pub(crate) struct SmallOutlines {
    /// The middle row of the image.
    pub(crate) middle_row: f64,
    /// Row of each centre, counted from the middle row.
    pub(crate) row: Halves,
    /// Column of each centre.
    pub(crate) column: Halves,
    /// Middle of the covered columns on the row of the centre.
    pub(crate) middle: Halves,
    pub(crate) shear: Halves,
    pub(crate) square: [Halves; 3],
    /// Value of `w^2`, the square of half a row's width, below which a row is *thin*: so close to the
    /// outline's top or bottom that its pixels are decided individually, by the ladder.
    pub(crate) thin: Halves,
    /// A whole number, at most the first covered row.
    pub(crate) first_row: Singles,
    /// A whole number, at least the last covered row.
    pub(crate) last_row: Singles,
    pub(crate) slope: Halves,
    pub(crate) row_slope: Halves,
    /// `slope`, rounded.
    pub(crate) rounded_slope: Singles,
    /// `inverse^2`, rounded.
    pub(crate) inverse_squared: Singles,
    /// Q, in two parts.
    pub(crate) quotient: [Singles; 2],
    /// Lower bound of `t` of all hits.
    pub(crate) nearest: Singles,
    /// Upper bound of the distance from the centre to any covered column, in columns, plus one.
    pub(crate) reach: Singles,
    /// Lanes in which all fields above are valid.
    pub(crate) is_small: u64,
    /// Lanes whose spheres lie wholly behind the eye.
    pub(crate) is_behind: u64,
    /// Lanes whose spheres lie outside the view: no ray through the image can meet them.
    pub(crate) is_outside: u64,
}

/// The values that need `f64`, for one half of a SIMD vector of spheres. X, Y, Z, r and h are those of
/// [`Outline`](crate::render::outline::Outline).
struct Doubles<S: Simd> {
    centers: Centers<S>,
    /// Column of the centre.
    column: S::f64s,
    /// Row of the centre, counted from the image's middle row.
    row: S::f64s,
    offset: S::f64s,
    shear: S::f64s,
    square0: S::f64s,
    square1: S::f64s,
    minus_square2: S::f64s,
    quotient: S::f64s,
    /// `X / Z`
    xc: S::f64s,
    /// `Y / Z`
    yc: S::f64s,
    /// `r / Z`
    a: S::f64s,
    /// `h / Z^2`
    g: S::f64s,
    slope: S::f64s,
    row_slope: S::f64s,
    inverse_squared: S::f64s,
}

impl<S: Simd> Doubles<S> {
    #[inline(always)]
    fn new(simd: S, space: &CameraSpace, slots: &SphereSlots) -> Self {
        let splat = |x: f64| S::f64s::splat(simd, x);
        let centers = Centers::<S>::new(simd, space, slots);
        let one = splat(1.0);
        let inverse_z = one / centers.z;
        let (xc, yc, a) = (centers.x * inverse_z, centers.y * inverse_z, centers.r * inverse_z);
        let (aa, level) = (a * a, one + yc * yc);
        let (m, g) = (level + xc * xc, level - aa);
        let (inverse_m, inverse_g) = (one / m, one / g);
        let by_h = aa * inverse_g;
        let (per_column, ratio) = (splat(space.per_column), splat(space.ratio));
        let from_middle = xc * per_column;
        let offset = by_h * from_middle;
        let shear = -(xc * yc * inverse_g * ratio);
        let stretch = by_h * (per_column * per_column);
        let square0 = stretch * m + offset * offset;
        let half_square1 = offset * shear - stretch * (yc * splat(space.row_slope));
        let per_q = inverse_m * splat(space.column_slope);
        let c = m - aa;
        let minus_square2 = (c * inverse_g) * ((one - aa) * inverse_g) * (ratio * ratio);
        Doubles {
            column: splat(space.middle_column) + from_middle,
            row: -(yc * splat(space.per_row)),
            offset,
            shear,
            square0,
            square1: half_square1 + half_square1,
            minus_square2,
            quotient: (centers.z * splat(space.per_distance)) * (c * inverse_m),
            centers,
            xc,
            yc,
            a,
            g,
            slope: xc * per_q,
            row_slope: -(yc * per_q * ratio),
            inverse_squared: g * (per_q * per_q),
        }
    }
}

/// Bounds for a SIMD vector of spheres. w, S and e are those of [`SmallOutlines`].
struct Bounds<S: Simd> {
    /// Upper bound of `w^2`, the square of half a row's width, in any row.
    size: S::f32s,
    /// Error bound of `w^2`.
    square_doubt: S::f32s,
    /// Distance, in rows, from the centre's row to the middle of the two rows where `w^2 = 0`.
    middle: S::f32s,
    /// Distance, in rows, from that middle to each of the two rows where `w^2 = 0`.
    half: S::f32s,
    reach: S::f32s,
    /// Upper bound of `inverse S`, the part of |e| that the root contributes.
    of_root: S::f32s,
    /// Upper bound of the part of |e| that varies with row and column.
    of_position: S::f32s,
    /// The relative error of `t`, in units of `2^-24`, before the last rounding.
    error: S::f32s,
}

impl<S: Simd> Bounds<S> {
    /// Computes the bounds. The factor [`UP`] covers the rounding errors of all operations together. For
    /// the error of t, see [`Runs::t`](crate::render::rows::small_spheres::Runs::t).
    ///
    /// The error bound of `w^2` in [`Outlines::find`](crate::render::outline::Outlines::find) holds
    /// here, too. Each coefficient is the result of at most 64 rounded operations, in none of which
    /// anything cancels, because `a = r / Z < 1/16`; then `8 k + 4 < 4.1`.
    #[inline(always)]
    fn new(simd: S, space: &CameraSpace, low: &Doubles<S>, high: &Doubles<S>) -> Self {
        let splat = |x: f32| S::f32s::splat(simd, x);
        let up = splat(UP);
        let square0 = low.square0.narrow(high.square0);
        let square1 = low.square1.narrow(high.square1);
        let inverse2 = splat(1.0) / low.minus_square2.narrow(high.minus_square2);
        let size = (square0 + square1 * square1 * inverse2) * up;
        let widest = size.sqrt() * up;
        let (xc, yc) = (low.xc.narrow(high.xc).abs(), low.yc.narrow(high.yc).abs());
        let eta_by_r = (xc + yc + splat(1.0)) / low.a.narrow(high.a) + splat(1.0);
        let share = splat(64.0 * 1.2e-16) + eta_by_r * splat((4.1 * space.doubt) as f32) * up;
        let square_doubt = share * (splat(4.0) * size) * up;
        let middle = square1 * inverse2 * splat(0.5);
        // Sums of rows in `f32` are off by less than a thousandth, or by a fraction that UP covers.
        let half =
            ((square0 + square_doubt) * inverse2 + middle * middle).sqrt() * up + splat(1e-3);
        let rows = middle.abs() + half;
        let shear = low.shear.narrow(high.shear).abs();
        let offset = low.offset.narrow(high.offset).abs();
        let reach = (widest + offset + shear * rows + splat(1.0)) * up;
        let slope = low.slope.narrow(high.slope).abs();
        let row_slope = low.row_slope.narrow(high.row_slope).abs();
        let of_position = (slope * reach + row_slope * rows) * up;
        let of_root = (size * low.inverse_squared.narrow(high.inverse_squared)).sqrt() * up;
        let along_row = slope * widest;
        let error =
            splat(9.8) * of_root + splat(7.8) * of_position + splat(4.6) * along_row + splat(0.07);
        Bounds { size, square_doubt, middle, half, reach, of_root, of_position, error }
    }

    /// Finds the value [`SmallOutlines::thin`], as
    /// [`Outlines::find`](crate::render::outline::Outlines::find) does, with the upper bound
    /// `1.005 h / Z^2` of `h / c`. `g` is `h / Z^2`.
    #[inline(always)]
    fn thin(&self, simd: S, space: &CameraSpace, g: S::f32s) -> S::f32s {
        let splat = |x: f32| S::f32s::splat(simd, x);
        let up = splat(UP);
        let square_doubt = self.square_doubt;
        let slope = (1.005 * space.column_slope * space.column_slope) as f32;
        let by_b = g * splat(slope) * up;
        let keep = (square_doubt * splat((16.0 * KEEP) as f32) * by_b * up).max(splat(32.0));
        let root = square_doubt * keep * splat((1.0 / MARGIN) as f32);
        (root * root).max(splat(32.0) * square_doubt) * up
    }
}

impl SmallOutlines {
    /// Finds the outlines of the spheres in `low` and `high`, which together fill a SIMD vector of
    /// `f32`.
    #[inline(always)]
    pub(crate) fn find<S: Simd>(
        &mut self,
        simd: S,
        space: &CameraSpace,
        [low, high]: &[SphereSlots; 2],
    ) {
        let (n, half) = (S::f32s::LEN, S::f64s::LEN);
        let low = Doubles::<S>::new(simd, space, low);
        let high = Doubles::<S>::new(simd, space, high);
        let bounds = Bounds::new(simd, space, &low, &high);
        let thin = bounds.thin(simd, space, low.g.narrow(high.g));
        let quotient = low.quotient.narrow(high.quotient);
        let splat = |x: f32| S::f32s::splat(simd, x);
        let nearest = quotient * (splat(1.0 - 1e-5) - (bounds.of_root + bounds.of_position));

        let (a, far) = (low.a.narrow(high.a), splat(131_072.0));
        let is_small = a.simd_lt(splat(1.0 / 16.0))
            & a.simd_gt(splat(1e-8))
            & bounds.error.simd_lt(splat(0.5))
            & thin.simd_lt(splat(32.0))
            & nearest.simd_gt(splat(1e-20))
            & quotient.simd_lt(splat(1e20))
            & bounds.size.simd_gt(splat(1e-10))
            & bounds.size.simd_lt(splat(MOST_SIZE))
            & low.column.narrow(high.column).abs().simd_lt(far)
            & low.row.narrow(high.row).abs().simd_lt(far);
        self.is_small = if space.is_plain { is_small.to_bitmask() } else { 0 };
        let not_seen = low.centers.not_seen(simd, space);
        let not_seen_high = high.centers.not_seen(simd, space);
        self.is_behind = not_seen.0 | not_seen_high.0 << half;
        self.is_outside = not_seen.1 | not_seen_high.1 << half;

        // Whole numbers and fractions are kept apart: `f32` holds the sums of whole numbers exactly.
        let rounding = S::f64s::splat(simd, 0.5);
        self.middle_row = space.middle_row;
        let center = S::f64s::splat(simd, space.middle_row);
        let (low_row, high_row) = (center + low.row, center + high.row);
        let (whole, whole_high) = ((low_row + rounding).floor(), (high_row + rounding).floor());
        let row = whole.narrow(whole_high);
        let middle = (low_row - whole).narrow(high_row - whole_high) + bounds.middle;
        (row + (middle - bounds.half).ceil()).store_slice(&mut self.first_row[..n]);
        (row + (middle + bounds.half).floor()).store_slice(&mut self.last_row[..n]);
        nearest.store_slice(&mut self.nearest[..n]);
        bounds.reach.store_slice(&mut self.reach[..n]);
        low.slope.narrow(high.slope).store_slice(&mut self.rounded_slope[..n]);
        let inverse_squared = low.inverse_squared.narrow(high.inverse_squared);
        inverse_squared.store_slice(&mut self.inverse_squared[..n]);
        let (rounded, rounded_high) = quotient.widen();
        let rest = (low.quotient - rounded).narrow(high.quotient - rounded_high);
        quotient.store_slice(&mut self.quotient[0][..n]);
        rest.store_slice(&mut self.quotient[1][..n]);
        let (thin, thin_high) = thin.widen();
        low.store(thin, self, 0);
        high.store(thin_high, self, 1);
    }
}

impl SmallOutlines {
    /// Returns a mask of the spheres with a row between the first and the last of these rows of the
    /// raster.
    #[inline(always)]
    pub(crate) fn rows_meet<S: Simd>(&self, simd: S, axes: &RasterAxes, rows: Range<usize>) -> u64 {
        let load = |x: &Singles| S::f32s::from_slice(simd, &x[..S::f32s::LEN]);
        let number = |row: usize| S::f32s::splat(simd, axes.row_numbers[row] as f32);
        let (above, below) = (number(rows.start), number(rows.end - 1));
        let (first, last) = (load(&self.first_row), load(&self.last_row));
        (last.simd_ge(above) & first.simd_le(below) & first.simd_le(last)).to_bitmask()
    }

    /// Returns the rows and columns of the raster that a sphere can cover.
    #[inline(always)]
    pub(crate) fn extent(
        &self,
        (lane, lanes): (usize, usize),
        axes: &RasterAxes,
    ) -> (Range<usize>, Range<usize>) {
        let half = if lane < lanes { (0, lane) } else { (1, lane - lanes) };
        let (column, reach) = (self.column[half.0][half.1], f64::from(self.reach[lane]));
        let (left, right) = ((column - reach).floor(), (column + reach).ceil());
        let rows =
            axes.rows_between(f64::from(self.first_row[lane]), f64::from(self.last_row[lane]));
        (rows, axes.columns_range(left, right))
    }
}

impl<S: Simd> Doubles<S> {
    #[inline(always)]
    fn store(&self, thin: S::f64s, outlines: &mut SmallOutlines, half: usize) {
        let n = S::f64s::LEN;
        thin.store_slice(&mut outlines.thin[half][..n]);
        self.column.store_slice(&mut outlines.column[half][..n]);
        self.slope.store_slice(&mut outlines.slope[half][..n]);
        self.row_slope.store_slice(&mut outlines.row_slope[half][..n]);
        self.row.store_slice(&mut outlines.row[half][..n]);
        (self.column + self.offset).store_slice(&mut outlines.middle[half][..n]);
        self.shear.store_slice(&mut outlines.shear[half][..n]);
        self.square0.store_slice(&mut outlines.square[0][half][..n]);
        self.square1.store_slice(&mut outlines.square[1][half][..n]);
        (-self.minus_square2).store_slice(&mut outlines.square[2][half][..n]);
    }
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;

    use fearless_simd::{Level, dispatch};

    use super::*;
    use crate::camera::Camera;
    use crate::camera::viewport::ImageSize;
    use crate::camera::viewport::Viewport;
    use crate::render::outline::{Outline, Outlines};

    /// Spheres by coordinate: x, y, z and the radius.
    type Spheres = [[f64; MOST_SINGLE_LANES]; 4];

    /// Finds the outlines of spheres both as [`SmallOutlines`] and as [`Outlines`]. Also returns the
    /// number of lanes of a SIMD vector of `f64`.
    #[inline(always)]
    fn both<S: Simd>(
        simd: S,
        space: &CameraSpace,
        spheres: &Spheres,
    ) -> (SmallOutlines, [Outlines; 2], usize) {
        let n = S::f64s::LEN;
        let half = |k: usize| spheres.each_ref().map(|x| &x[k * n..(k + 1) * n]);
        let mut small = SmallOutlines::default();
        small.find(simd, space, &[half(0), half(1)]);
        let mut outlines = [Outlines::default(), Outlines::default()];
        for (k, outlines) in outlines.iter_mut().enumerate() {
            outlines.find(simd, space, &half(k));
        }
        (small, outlines, n)
    }

    fn assert_near(name: &str, a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance, "{name}: {a} and {b}");
    }

    /// Asserts that two outlines of one sphere are the same.
    fn assert_same(small: &SmallOutlines, lane: usize, n: usize, outline: &Outline) {
        let get = |x: &Halves| x[lane / n][lane % n];
        let (column, j) = (get(&small.column), 0.37);
        assert_near("row", get(&small.row), outline.row, 1e-9);
        assert_near("middle", get(&small.middle), outline.column, 1e-9);
        assert_near("shear", get(&small.shear), outline.shear, 1e-12);
        for (a, b) in small.square.iter().zip(outline.square) {
            assert_near("w^2", get(a), b, 1e-9 * outline.square[0]);
        }
        assert!(f64::from(small.first_row[lane]) <= outline.first_row);
        assert!(f64::from(small.last_row[lane]) >= outline.last_row);

        let c = column + 0.21;
        let [square0, square1, square2] = outline.square;
        let across = c - (outline.column + outline.shear * j);
        let root = (square0 + (square1 + square2 * j) * j - across * across).max(0.0).sqrt();
        let b = outline.b0 + outline.b_column * c + outline.b_row * j;
        let t = outline.numerator / (b + root);
        let inverse = f64::from(small.inverse_squared[lane]).sqrt();
        let e = get(&small.slope) * (c - column) + get(&small.row_slope) * j + inverse * root;
        let quotient = f64::from(small.quotient[0][lane]) + f64::from(small.quotient[1][lane]);
        assert_near("t", quotient / (1.0 + e), t, 1e-8 * t);
        assert!(f64::from(small.nearest[lane]) <= t && outline.nearest <= t);
    }

    #[test]
    fn a_small_sphere_has_the_same_outline_as_any_other() {
        let image = ImageSize::new(400, 300).expect("a size");
        let viewport = Viewport { width: 2.0, height: 1.1, distance: 0.8 };
        let camera = Camera { image, viewport, ..Camera::CANONICAL };
        let space = CameraSpace::new(&camera.resolve().expect("a camera"));
        let mut compared = 0;
        for seed in 0..40 {
            let between = |k: usize, low: f64, high: f64| {
                let turn = (f64::from(seed * 100 + k as i32) * 0.754_877_666).fract();
                low + (high - low) * turn
            };
            let depth = |lane| between(lane, 2.0, 40.0);
            let spheres = [
                from_fn(|lane| between(2 * lane, -1.0, 1.0) * depth(lane)),
                from_fn(|lane| between(3 * lane, -0.6, 0.6) * depth(lane)),
                from_fn(|lane| -depth(lane)),
                from_fn(|lane| between(5 * lane, 0.002, 0.03) * depth(lane)),
            ];
            let (small, outlines, n) =
                dispatch!(Level::new(), simd => both(simd, &space, &spheres));
            for lane in (0..2 * n).filter(|lane| small.is_small >> lane & 1 == 1) {
                let outlines = &outlines[lane / n];
                if outlines.is_plain >> (lane % n) & 1 == 1 {
                    assert_same(&small, lane, n, &outlines.one(lane % n));
                    compared += 1;
                }
            }
        }
        assert!(compared > 100, "{compared}");
    }
}
