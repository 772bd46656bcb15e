//! A scene's spheres, and the index over them. The index stores spheres of similar size that are close
//! together in common boxes, so that the visible ones are found without examining every sphere. The
//! index depends on the spheres alone, not on a camera; it is updated when a sphere is replaced.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::DVec3;
use rayon::prelude::*;

use crate::exact::scale::exponent;
use crate::scene::sphere::Sphere;

/// The id of an empty slot.
pub(crate) const NO_SPHERE: u32 = u32::MAX;

/// Several spheres as a structure of arrays for SIMD: x, y and z of the centres, and the radii.
pub(crate) type SphereSlots<'a> = [&'a [f64]; 4];

fn columns_of(sphere: &Sphere) -> [f64; 4] {
    [sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius]
}

/// The index over a scene's spheres, a bounding volume hierarchy of two levels. Each sphere has a slot;
/// [`BLOCK`] slots form a block, and up to [`GROUP`] blocks form a group. Each block and each group has
/// a box around its spheres.
///
/// The spheres of a group have radii between the same two powers of 4 and lie close together, until [one
/// is replaced](SphereIndex::replace). Empty slots at the end of a block repeat the block's first
/// sphere; their id is [`NO_SPHERE`], and the bounds of the block and the group do not count them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SphereIndex {
    /// x, y and z of the centres and the radii, slot by slot.
    pub(crate) columns: [Vec<f64>; 4],
    /// The scene's index of the sphere in each slot; [`NO_SPHERE`] for an empty slot.
    pub(crate) ids: Vec<u32>,
    /// The slot of each sphere of the scene.
    slot_of: Vec<u32>,
    pub(crate) blocks: Vec<Bound>,
    pub(crate) groups: Vec<Bound>,
    /// The first block of each group, followed by the number of blocks.
    first_block: Vec<u32>,
}

impl SphereIndex {
    /// Makes the index of n spheres in O(n log n), in parallel. Each sphere must pass [`Sphere::check`].
    /// The result is the same for any number of threads.
    pub(crate) fn new(spheres: &[Sphere]) -> SphereIndex {
        let (keys, classes) = ordered(spheres);
        let count = classes.iter().map(|class| class.len().div_ceil(BLOCK)).sum::<usize>();
        let (mut ids, mut first_block) = (Vec::with_capacity(count * BLOCK), Vec::new());
        for class in classes {
            let first = ids.len() / BLOCK;
            ids.extend(keys[class].iter().map(|key| key.id));
            ids.resize(ids.len().next_multiple_of(BLOCK), NO_SPHERE);
            first_block.extend((first..ids.len() / BLOCK).step_by(GROUP).map(|block| block as u32));
        }
        first_block.push(count as u32);
        // The keys take as much memory as the columns.
        drop(keys);
        let mut columns = [(); 4].map(|()| Vec::with_capacity(ids.len()));
        let mut slot_of = vec![0; spheres.len()];
        for (slot, &id) in ids.iter().enumerate() {
            let shown = if id == NO_SPHERE { ids[slot / BLOCK * BLOCK] } else { id } as usize;
            if id != NO_SPHERE {
                slot_of[shown] = slot as u32;
            }
            for (column, value) in columns.iter_mut().zip(columns_of(&spheres[shown])) {
                column.push(value);
            }
        }
        let (blocks, groups) = (Vec::new(), Vec::new());
        let mut index = SphereIndex { columns, ids, slot_of, blocks, groups, first_block };
        index.blocks =
            (0..count).into_par_iter().map(|block| index.bound_of_block(block)).collect();
        index.groups =
            (0..index.first_block.len() - 1).map(|group| index.bound_of_group(group)).collect();
        index
    }

    /// Replaces a sphere by another one, which may lie anywhere, in O([`BLOCK`] + [`GROUP`]).
    pub(crate) fn replace(&mut self, index: u32, sphere: &Sphere) {
        let slot = self.slot_of[index as usize] as usize;
        self.put(slot, sphere);
        let block = slot / BLOCK;
        let slots = SphereIndex::slots_of(block);
        if slot == slots.start {
            for padded in slots.filter(|slot| self.ids[*slot] == NO_SPHERE).collect::<Vec<_>>() {
                self.put(padded, sphere);
            }
        }
        self.blocks[block] = self.bound_of_block(block);
        let group = self.first_block.partition_point(|first| *first as usize <= block) - 1;
        self.groups[group] = self.bound_of_group(group);
    }

    /// Returns the range of a group's blocks.
    pub(crate) fn blocks_of(&self, group: usize) -> Range<usize> {
        self.first_block[group] as usize..self.first_block[group + 1] as usize
    }

    /// Returns the spheres of some slots.
    pub(crate) fn spheres(&self, slots: Range<usize>) -> SphereSlots<'_> {
        let [x, y, z, radius] = &self.columns;
        [&x[slots.clone()], &y[slots.clone()], &z[slots.clone()], &radius[slots]]
    }

    /// Returns one slot's sphere.
    pub(crate) fn sphere(&self, slot: usize) -> Sphere {
        let [x, y, z, radius] = self.columns.each_ref().map(|column| column[slot]);
        Sphere { center: DVec3::new(x, y, z), radius }
    }

    /// Returns the range of a block's slots.
    pub(crate) fn slots_of(block: usize) -> Range<usize> {
        block * BLOCK..(block + 1) * BLOCK
    }

    /// Returns, in ascending order, the indices of the spheres for which `may` is true of the sphere's
    /// box, its block's box and its group's box. `may` is called with the centre and the half extents of
    /// a box.
    pub(crate) fn spheres_where(&self, may: impl Fn([f64; 3], [f64; 3]) -> bool) -> Vec<u32> {
        let may_be_in = |bound: &Bound| may(bound.middle, bound.half);
        let groups = (0..self.groups.len()).filter(|group| may_be_in(&self.groups[*group]));
        let blocks = groups.flat_map(|group| self.blocks_of(group));
        let slots = blocks
            .filter(|block| may_be_in(&self.blocks[*block]))
            .flat_map(SphereIndex::slots_of)
            .filter(|slot| self.ids[*slot] != NO_SPHERE)
            .filter(|slot| {
                let Sphere { center, radius } = self.sphere(*slot);
                may(center.to_array(), [radius; 3])
            });
        let mut found: Vec<u32> = slots.map(|slot| self.ids[slot]).collect();
        found.sort_unstable();
        found
    }

    fn put(&mut self, slot: usize, sphere: &Sphere) {
        for (column, value) in self.columns.iter_mut().zip(columns_of(sphere)) {
            column[slot] = value;
        }
    }

    fn bound_of_block(&self, block: usize) -> Bound {
        let own = SphereIndex::slots_of(block).filter(|slot| self.ids[*slot] != NO_SPHERE);
        Bound::around(own.map(|slot| Bound::of_sphere(&self.sphere(slot))))
    }

    fn bound_of_group(&self, group: usize) -> Bound {
        Bound::around(self.blocks_of(group).map(|block| self.blocks[block]))
    }
}

/// An axis-aligned box around some spheres, with totals over these spheres.
///
/// On each axis the box is `middle - half ..= middle + half`. It contains the spheres whether its ends
/// are computed exactly or in rounded arithmetic. A half extent beyond the range of `f64` is infinite.
/// Of the other fields, only the sum of squares may be infinite; none is NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bound {
    pub(crate) middle: [f64; 3],
    pub(crate) half: [f64; 3],
    /// The sum of r^2 of the spheres inside.
    pub(crate) area: f64,
    /// The largest r of the spheres inside.
    pub(crate) radius: f64,
    /// Number of spheres inside.
    pub(crate) count: u32,
}

impl Bound {
    /// Returns the box of one sphere, not rounded outward. [`Bound::around`], which makes a box around
    /// several, rounds it outward.
    pub(crate) fn of_sphere(sphere: &Sphere) -> Bound {
        let Sphere { center, radius } = *sphere;
        let (middle, half) = (center.to_array(), [radius; 3]);
        Bound { middle, half, area: radius * radius, radius, count: 1 }
    }

    /// Returns the box around boxes.
    pub(crate) fn around(boxes: impl Iterator<Item = Bound>) -> Bound {
        let mut all = Bound::default();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for bound in boxes {
            for axis in 0..3 {
                low[axis] = low[axis].min(bound.middle[axis] - bound.half[axis]);
                high[axis] = high[axis].max(bound.middle[axis] + bound.half[axis]);
            }
            all.area += bound.area;
            all.radius = all.radius.max(bound.radius);
            all.count += bound.count;
        }
        if all.count > 0 {
            for axis in 0..3 {
                // Each end was rounded once, so the next `f64` beyond it is outside the spheres.
                let ends = (low[axis].next_down(), high[axis].next_up());
                (all.middle[axis], all.half[axis]) = middle_and_half(ends);
            }
        }
        all
    }
}

/// Returns `(middle, half)` with `middle - half <= low` and `high <= middle + half`.
fn middle_and_half((low, high): (f64, f64)) -> (f64, f64) {
    // The ends are halved first, so that their sum cannot overflow.
    let middle = 0.5 * low.max(f64::MIN) + 0.5 * high.min(f64::MAX);
    (middle, (high - middle).max(middle - low).next_up())
}

/// Minimum number of spheres for which an index is made. Fewer spheres are examined one by one just as
/// fast.
pub(crate) const INDEX_FROM: usize = 256;

/// Checked spheres, with an index that is made when it is first needed, and then kept. The index depends
/// on the spheres alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spheres {
    pub(crate) list: Arc<Vec<Sphere>>,
    index: OnceLock<SphereIndex>,
}

impl Spheres {
    pub(crate) fn new(list: Arc<Vec<Sphere>>) -> Spheres {
        Spheres { list, index: OnceLock::new() }
    }

    /// Returns the index, or `None` if there are fewer than [`INDEX_FROM`] spheres.
    pub(crate) fn index(&self) -> Option<&SphereIndex> {
        if self.list.len() < INDEX_FROM {
            return None;
        }
        // The index is made outside the cell's initialisation, which would block other threads: if they
        // are needed to make the index, all would wait for ever. At worst two threads make an index
        // each, and one is used.
        if self.index.get().is_none() {
            let _ = self.index.set(SphereIndex::new(&self.list));
        }
        self.index.get()
    }

    /// Replaces a sphere by another checked one.
    pub(crate) fn replace(&mut self, index: u32, sphere: Sphere) {
        Arc::make_mut(&mut self.list)[index as usize] = sphere;
        if let Some(known) = self.index.get_mut() {
            known.replace(index, &sphere);
        }
    }
}

impl PartialEq for Spheres {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}

/// Number of slots in a block.
pub(crate) const BLOCK: usize = 16;

/// Maximum number of blocks in a group.
pub(crate) const GROUP: usize = 64;

/// A sphere's centre and index. These are sorted, instead of the spheres, to find the order of the
/// slots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    pub(crate) center: [f64; 3],
    pub(crate) id: u32,
}

/// Minimum number of spheres for which two threads may order the two halves of a split.
const SHARED_FROM: usize = 8192;

/// Number of size classes, for radii from 2^-1074 to 2^1024.
const CLASSES: usize = (1074 + 1024) / 2;

/// Returns the number of a radius's size class. A class contains the radii from one power of 4 up to the
/// next.
fn class_of(radius: f64) -> usize {
    ((exponent(radius) + 1074) / 2) as usize
}

/// Returns all spheres in the order of the index, and the range of each size class.
///
/// Each class is halved at the median along the axis along which its centres are spread the widest, and
/// each half likewise. Cuts lie between groups or, within a group, between blocks, so that only the last
/// block of a class may be partly empty. The order depends on the spheres alone, not on the number of
/// threads.
pub(crate) fn ordered(spheres: &[Sphere]) -> (Vec<Key>, Vec<Range<usize>>) {
    let mut counts = [0; CLASSES];
    for sphere in spheres {
        counts[class_of(sphere.radius)] += 1;
    }
    let mut classes = Vec::new();
    let mut next = counts.map(|_| 0);
    let mut start = 0;
    for (class, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        next[class] = start;
        classes.push(start..start + count);
        start += count;
    }
    let mut keys = vec![Key { center: [0.0; 3], id: 0 }; spheres.len()];
    for (id, sphere) in (0..).zip(spheres) {
        let slot = &mut next[class_of(sphere.radius)];
        keys[*slot] = Key { center: sphere.center.to_array(), id };
        *slot += 1;
    }
    for class in &classes {
        split(&mut keys[class.clone()]);
    }
    (keys, classes)
}

fn split(keys: &mut [Key]) {
    if keys.len() <= BLOCK {
        return;
    }
    let unit = if keys.len() > BLOCK * GROUP { BLOCK * GROUP } else { BLOCK };
    let middle = keys.len().div_ceil(unit) / 2 * unit;
    match longest_axis(keys) {
        0 => select::<0>(keys, middle),
        1 => select::<1>(keys, middle),
        _ => select::<2>(keys, middle),
    }
    let is_shared = keys.len() >= SHARED_FROM;
    let (left, right) = keys.split_at_mut(middle);
    if is_shared {
        rayon::join(|| split(left), || split(right));
    } else {
        split(left);
        split(right);
    }
}

/// Moves the `middle` smallest keys along an axis to the front.
fn select<const AXIS: usize>(keys: &mut [Key], middle: usize) {
    keys.select_nth_unstable_by(middle, |a, b| a.center[AXIS].total_cmp(&b.center[AXIS]));
}

/// Returns the axis along which the centres are spread the widest.
fn longest_axis(keys: &[Key]) -> usize {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for key in keys {
        for axis in 0..3 {
            low[axis] = low[axis].min(key.center[axis]);
            high[axis] = high[axis].max(key.center[axis]);
        }
    }
    let spread = |axis: usize| high[axis] - low[axis];
    let wider = |a: usize, b: usize| if spread(b) > spread(a) { b } else { a };
    wider(wider(0, 1), 2)
}
