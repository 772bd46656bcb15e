//! The groups and blocks (two levels of boxes around nearby spheres) of the sphere index that a camera
//! can see.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};
use rayon::prelude::*;

use crate::render::outline::raster_axes::{CameraSpace, RasterAxes};
use crate::render::outline::small_outlines::SmallOutlines;
use crate::render::outline::{Extent, Extents, Outlines};
use crate::scene::sphere_index::{Bound, NO_SPHERE, SphereIndex};

/// A group or a block of the sphere index, and the part of the raster that its spheres can cover.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisibleBox {
    /// The number of the group or block in the sphere index.
    pub(crate) id: u32,
    /// Lower bound of `t` of all hits of its spheres.
    pub(crate) nearest: f32,
    pub(crate) extent: Extent,
}

/// A visible group and its visible blocks.
pub(crate) struct VisibleGroup {
    pub(crate) bounds: VisibleBox,
    pub(crate) blocks: Vec<VisibleBox>,
    /// True if those spheres of the group that are drawn by polynomials, not by rows, are listed in
    /// [`VisibleSpheres::others`].
    pub(crate) has_others: bool,
}

/// The visible part of the sphere index, with the groups near to far.
pub(crate) struct VisibleSpheres<'a> {
    pub(crate) index: &'a SphereIndex,
    pub(crate) space: CameraSpace,
    pub(crate) groups: Vec<VisibleGroup>,
    /// True if spheres overlap so much in the picture that it pays to test whether each sphere is hidden
    /// by nearer ones.
    pub(crate) is_crowded: bool,
    /// The spheres that are not drawn by rows, in the groups that may contain such spheres.
    pub(crate) others: Vec<(u32, Extent)>,
    /// Number of spheres that were left out because their group or block cannot be seen.
    pub(crate) left_out: u64,
}

impl<'a> VisibleSpheres<'a> {
    pub(crate) fn new(
        level: Level,
        index: &'a SphereIndex,
        space: CameraSpace,
        (axes, extents): (&RasterAxes, &Extents),
    ) -> VisibleSpheres<'a> {
        /// Minimum average number of spheres that cover a pixel for which it pays to test whether
        /// spheres are hidden.
        const CROWDED: f64 = 2.5;
        let mut left_out = 0;
        let mut groups = Vec::new();
        let mut covered = 0.0;
        for group in 0..index.groups.len() {
            match seen(&index.groups, group, &space, axes) {
                Some((bounds, area)) => {
                    covered += area;
                    groups.push(bounds);
                }
                None => left_out += u64::from(index.groups[group].count),
            }
        }
        groups.sort_unstable_by(|a, b| a.nearest.total_cmp(&b.nearest));
        let is_crowded = covered > CROWDED * axes.pixels() as f64;
        let found: Vec<(VisibleGroup, u64)> = groups
            .into_par_iter()
            .with_min_len(16)
            .map(|bounds| {
                let (blocks, left_out) =
                    dispatch!(level, simd => seen_blocks(simd, index, &bounds, &space, axes, is_crowded));
                let has_others = may_have_others(&index.groups, &bounds, &space);
                (VisibleGroup { bounds, blocks, has_others }, left_out)
            })
            .collect();
        left_out += found.iter().map(|(_, left_out)| left_out).sum::<u64>();
        let groups = found.into_iter().map(|(group, _)| group).collect();
        let others = Vec::new();
        let mut visible = VisibleSpheres { index, space, groups, is_crowded, others, left_out };
        visible.others = dispatch!(level, simd => visible.find_others(simd, extents));
        visible
    }

    /// Finds the spheres that are not drawn by rows, in the groups that may contain such spheres.
    #[inline(always)]
    fn find_others<S: Simd>(&self, simd: S, extents: &Extents) -> Vec<(u32, Extent)> {
        let (mut small, mut outlines) = (SmallOutlines::default(), Outlines::default());
        let (n, index) = (S::f64s::LEN, self.index);
        let mut others = Vec::new();
        let groups = self.groups.iter().filter(|group| group.has_others);
        let blocks = groups.flat_map(|group| &group.blocks);
        let vectors =
            blocks.flat_map(|block| SphereIndex::slots_of(block.id as usize).step_by(2 * n));
        for from in vectors {
            let halves = [index.spheres(from..from + n), index.spheres(from + n..from + 2 * n)];
            small.find(simd, &self.space, &halves);
            for (half, slots) in halves.iter().enumerate() {
                outlines.find(simd, &self.space, slots);
                let drawn = small.is_small >> (half * n)
                    | outlines.is_plain
                    | outlines.is_behind
                    | outlines.is_outside;
                for lane in 0..n {
                    let slot = from + half * n + lane;
                    let id = index.ids[slot];
                    if id != NO_SPHERE && drawn >> lane & 1 == 0 {
                        let extent = extents.find(&index.sphere(slot));
                        others.extend(extent.map(|extent| (id, extent)));
                    }
                }
            }
        }
        others
    }
}

/// Returns the visible blocks of a group, near to far if the spheres are crowded, and the number of
/// spheres in the other blocks.
#[inline(always)]
fn seen_blocks<S: Simd>(
    _simd: S,
    index: &SphereIndex,
    group: &VisibleBox,
    space: &CameraSpace,
    axes: &RasterAxes,
    is_crowded: bool,
) -> (Vec<VisibleBox>, u64) {
    let mut left_out = 0;
    let range = index.blocks_of(group.id as usize);
    let mut blocks = Vec::with_capacity(range.len());
    for block in range {
        match seen(&index.blocks, block, space, axes) {
            Some((bounds, _)) => blocks.push(bounds),
            None => left_out += u64::from(index.blocks[block].count),
        }
    }
    if is_crowded {
        blocks.sort_unstable_by(|a, b| a.nearest.total_cmp(&b.nearest));
    }
    (blocks, left_out)
}

/// Returns whether a group may contain a sphere so near or so large that it is not drawn by rows.
fn may_have_others(groups: &[Bound], bounds: &VisibleBox, space: &CameraSpace) -> bool {
    /// Maximum distance from the eye, in radii, of a group that counts as near.
    const NEAR: f64 = 0.1;
    /// Minimum radius, in columns or rows, of a sphere that counts as large.
    const LARGE: f64 = 400.0;
    let (near, radius) =
        (f64::from(bounds.nearest) * space.distance, groups[bounds.id as usize].radius);
    let slope = space.row_slope.min(space.column_slope);
    near <= NEAR * radius || radius > LARGE * slope * near
}

/// Finds the part of the raster that a box can cover, and roughly how many pixels its spheres cover
/// together; returns `None` if no view ray can hit the box.
///
/// Each margin is 1e-9 of the quantity to which it is added: far more than the few roundings that it
/// covers, and too little to matter otherwise.
#[inline(always)]
fn seen(
    boxes: &[Bound],
    id: usize,
    space: &CameraSpace,
    axes: &RasterAxes,
) -> Option<(VisibleBox, f64)> {
    const SHARE: f64 = 1e-9;
    let Bound { middle, half, area, radius, .. } = boxes[id];
    let q: [f64; 3] = std::array::from_fn(|i| middle[i] - space.eye[i]);
    let along = |axis: [f64; 3]| q[0] * axis[0] + q[1] * axis[1] + q[2] * axis[2];
    let reach = |axis: [f64; 3]| {
        half[0] * axis[0].abs() + half[1] * axis[1].abs() + half[2] * axis[2].abs()
    };
    let margin = SHARE * (q[0].abs() + q[1].abs() + q[2].abs() + half[0] + half[1] + half[2]);
    let (x, y, z) = (along(space.u), along(space.v), -along(space.w));
    let [rx, ry, rz] = [space.u, space.v, space.w].map(|axis| reach(axis) + margin);
    let (near, far) = (z - rz, z + rz);
    let [wide, high] = space.widest;
    let is_beyond = |side: f64, reach: f64, widest: f64| side.abs() - reach > widest * far;
    // Behind the eye, or beyond a border of the image.
    if far < 0.0 || is_beyond(x, rx, wide) || is_beyond(y, ry, high) {
        return None;
    }
    let (rows, columns) = if near > 0.0 && near.is_finite() && far.is_finite() {
        let slopes = |side: f64, reach: f64| {
            let (low, high) = (side - reach, side + reach);
            let low = if low > 0.0 { low / far } else { low / near };
            (low, if high > 0.0 { high / near } else { high / far })
        };
        let (left, right) = slopes(x, rx);
        let (bottom, top) = slopes(y, ry);
        let row = |slope: f64| space.middle_row - slope / space.row_slope;
        let column = |slope: f64| space.middle_column + slope / space.column_slope;
        let columns =
            axes.columns_range((column(left) - 1e-3).ceil(), (column(right) + 1e-3).floor());
        (axes.rows_between((row(top) - 1e-3).ceil(), (row(bottom) + 1e-3).floor()), columns)
    } else {
        (0..axes.height, 0..axes.width)
    };
    if rows.is_empty() || columns.is_empty() {
        return None;
    }
    let depth = z.max(radius).max(1e-3 * rz);
    let area = std::f64::consts::PI * area / (depth * depth * space.row_slope * space.column_slope);
    let nearest = (near / space.distance).max(0.0) as f32 * (1.0 - 1e-6);
    let extent = Extent::new(rows, columns);
    Some((VisibleBox { id: id as u32, nearest, extent }, area))
}
