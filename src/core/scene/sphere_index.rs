//! An index over a scene's spheres: what of it can be seen is found without a look at every sphere.
//! It depends on the spheres alone, not on a camera, and is kept until they change.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use crate::scene::boxes::Bound;
use crate::scene::sphere::Sphere;
use crate::scene::sphere_order::{BLOCK, GROUP, ordered};

/// The id of a slot that holds no sphere of its own.
pub(crate) const NO_SPHERE: u32 = u32::MAX;

/// Spheres side by side, as many as a vector has lanes: x, y and z of the centres, and the radii.
pub(crate) type SphereSlots<'a> = [&'a [f64]; 4];

fn columns_of(sphere: &Sphere) -> [f64; 4] {
    [sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius]
}

/// Spheres in slots, slots in blocks of [`BLOCK`], blocks in groups of up to [`GROUP`], each with a
/// box around it.
///
/// Spheres of one block, and of one group, have radii of the same power of 4 and lie together, until
/// [one is replaced](SphereIndex::replace). Slots of a block that no sphere is left for repeat the
/// block's first one; their id is [`NO_SPHERE`], and block and group do not count them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SphereIndex {
    /// x, y and z of the centres and the radii, slot by slot.
    pub(crate) columns: [Vec<f64>; 4],
    /// The sphere of the scene in the slot; [`NO_SPHERE`] where the slot only fills up.
    pub(crate) ids: Vec<u32>,
    /// The slot of each sphere of the scene.
    slot_of: Vec<u32>,
    pub(crate) blocks: Vec<Bound>,
    pub(crate) groups: Vec<Bound>,
    /// The first block of each group; at the end, the number of blocks.
    first_block: Vec<u32>,
}

impl SphereIndex {
    /// The index of these spheres, each of which passes [`Sphere::check`]: O(n log n), two halves of
    /// the spheres at a time. The same for any number of threads.
    pub(crate) fn new(spheres: &[Sphere]) -> SphereIndex {
        let (keys, classes) = ordered(spheres);
        let blocks: usize = classes.iter().map(|class| class.len().div_ceil(BLOCK)).sum();
        let columns = [(); 4].map(|()| Vec::with_capacity(blocks * BLOCK));
        let ids = Vec::with_capacity(blocks * BLOCK);
        let (slot_of, first_block) = (vec![0; spheres.len()], Vec::new());
        let mut index = SphereIndex {
            columns,
            ids,
            slot_of,
            blocks: Vec::new(),
            groups: Vec::new(),
            first_block,
        };
        for class in classes {
            let first = index.ids.len() / BLOCK;
            for key in &keys[class.clone()] {
                index.slot_of[key.id as usize] = index.ids.len() as u32;
                index.push(&spheres[key.id as usize], key.id);
            }
            index.fill_up();
            let end = index.ids.len() / BLOCK;
            index.first_block.extend((first..end).step_by(GROUP).map(|block| block as u32));
        }
        let groups = index.first_block.len();
        index.first_block.push(blocks as u32);
        index.blocks =
            (0..blocks).into_par_iter().map(|block| index.bound_of_block(block)).collect();
        index.groups = (0..groups).map(|group| index.bound_of_group(group)).collect();
        index
    }

    /// Puts another sphere in place of one, wherever it lies: O([`BLOCK`] + [`GROUP`]).
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

    /// The blocks of a group.
    pub(crate) fn blocks_of(&self, group: usize) -> Range<usize> {
        self.first_block[group] as usize..self.first_block[group + 1] as usize
    }

    /// The spheres of some slots.
    pub(crate) fn spheres(&self, slots: Range<usize>) -> SphereSlots<'_> {
        let [x, y, z, radius] = &self.columns;
        [&x[slots.clone()], &y[slots.clone()], &z[slots.clone()], &radius[slots]]
    }

    /// One slot's sphere.
    pub(crate) fn sphere(&self, slot: usize) -> Sphere {
        let [x, y, z, radius] = self.columns.each_ref().map(|column| column[slot]);
        Sphere { center: DVec3::new(x, y, z), radius }
    }

    /// The slots of a block.
    pub(crate) fn slots_of(block: usize) -> Range<usize> {
        block * BLOCK..(block + 1) * BLOCK
    }

    /// The spheres of which `may` says so of group, block and themselves, each given by the middle and
    /// the half extents of its box; ascending.
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

    fn push(&mut self, sphere: &Sphere, id: u32) {
        for (column, value) in self.columns.iter_mut().zip(columns_of(sphere)) {
            column.push(value);
        }
        self.ids.push(id);
    }

    fn put(&mut self, slot: usize, sphere: &Sphere) {
        for (column, value) in self.columns.iter_mut().zip(columns_of(sphere)) {
            column[slot] = value;
        }
    }

    /// Fills the last block up with its first sphere.
    fn fill_up(&mut self) {
        let first = (self.ids.len() - 1) / BLOCK * BLOCK;
        while !self.ids.len().is_multiple_of(BLOCK) {
            self.push(&self.sphere(first), NO_SPHERE);
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
