//! An index over a scene's spheres: what of it can be seen is found without a look at every sphere.
//! It depends on the spheres alone, not on a camera, and is kept until they change.

use std::ops::Range;

use rayon::prelude::*;

use crate::boxes::{BOX_LANES, Bound, Boxes};
use crate::outline::Spheres;
use crate::sphere::Sphere;
use crate::sphere_order::ordered;

/// Slots in a block.
pub(crate) const BLOCK: usize = 16;

/// Blocks in a group at most.
pub(crate) const GROUP: usize = 64;

/// The id of a slot that holds no sphere of its own.
pub(crate) const NO_SPHERE: u32 = u32::MAX;

/// Spheres in slots, slots in blocks of [`BLOCK`], blocks in groups of up to [`GROUP`], each with a
/// box around it.
///
/// Spheres of one block, and of one group, have radii of the same power of 4 and lie together, until
/// [one is replaced](SphereIndex::replace). Slots of a block that no sphere is left for repeat the
/// block's first one; their id is [`NO_SPHERE`], and block and group do not count them.
///
/// A group's first block, and how many it has, are multiples of [`BOX_LANES`]: blocks that only fill
/// up have count 0, and their slots are zeros without a sphere. So are there as many groups as a
/// multiple of [`BOX_LANES`]; those that only fill up have count 0 and no blocks.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SphereIndex {
    /// The centres, slot by slot.
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) z: Vec<f64>,
    /// The radii, slot by slot.
    pub(crate) radius: Vec<f64>,
    /// Which sphere of the scene is in the slot; [`NO_SPHERE`] where the slot only fills up.
    pub(crate) ids: Vec<u32>,
    /// By sphere of the scene, its slot.
    slot_of: Vec<u32>,
    pub(crate) blocks: Boxes,
    pub(crate) groups: Boxes,
    /// By group, its first block; at the end, how many blocks there are.
    first_block: Vec<u32>,
}

impl SphereIndex {
    /// The index of these spheres, each of which passes [`Sphere::check`]: O(n log n), two halves of
    /// the spheres at a time. The same for any number of threads.
    pub(crate) fn new(spheres: &[Sphere]) -> SphereIndex {
        let (keys, classes) = ordered(spheres);
        let blocks_in = |count: usize| count.div_ceil(BLOCK).next_multiple_of(BOX_LANES);
        let blocks: usize = classes.iter().map(|class| blocks_in(class.len())).sum();
        let [x, y, z, radius] = [(); 4].map(|()| Vec::with_capacity(blocks * BLOCK));
        let ids = Vec::with_capacity(blocks * BLOCK);
        let (slot_of, first_block) = (vec![0; spheres.len()], Vec::new());
        let (groups, none) = (Boxes::default(), Boxes::default());
        let mut index =
            SphereIndex { x, y, z, radius, ids, slot_of, blocks: none, groups, first_block };
        for class in classes {
            let first = index.ids.len() / BLOCK;
            for key in &keys[class.clone()] {
                index.slot_of[key.id as usize] = index.ids.len() as u32;
                index.push(key.center, spheres[key.id as usize].radius, key.id);
            }
            index.fill_up();
            let end = first + blocks_in(class.len());
            index.first_block.extend((first..end).step_by(GROUP).map(|block| block as u32));
            index.resize(end * BLOCK);
        }
        let groups = index.first_block.len();
        index.first_block.resize(groups.next_multiple_of(BOX_LANES) + 1, blocks as u32);
        let bounds = (0..blocks).into_par_iter().map(|block| index.bound_of_block(block));
        index.blocks = Boxes::new(&bounds.collect::<Vec<Bound>>());
        let bounds = (0..groups).map(|group| index.bound_of_group(group));
        index.groups = Boxes::new(&bounds.collect::<Vec<Bound>>());
        index
    }

    /// Puts another sphere in the place of one, wherever it lies: O([`BLOCK`] + [`GROUP`]).
    pub(crate) fn replace(&mut self, index: u32, sphere: &Sphere) {
        let slot = self.slot_of[index as usize] as usize;
        self.put(slot, sphere.center.to_array(), sphere.radius);
        let block = slot / BLOCK;
        let slots = SphereIndex::slots_of(block);
        if slot == slots.start {
            for padded in slots.filter(|slot| self.ids[*slot] == NO_SPHERE).collect::<Vec<_>>() {
                self.put(padded, sphere.center.to_array(), sphere.radius);
            }
        }
        self.blocks.set(block, self.bound_of_block(block));
        let group = self.first_block.partition_point(|first| *first as usize <= block) - 1;
        self.groups.set(group, self.bound_of_group(group));
    }

    /// The blocks of a group, with those that only fill it up.
    pub(crate) fn blocks_of(&self, group: usize) -> Range<usize> {
        self.first_block[group] as usize..self.first_block[group + 1] as usize
    }

    /// Some slots' spheres.
    pub(crate) fn spheres(&self, slots: Range<usize>) -> Spheres<'_> {
        Spheres {
            x: &self.x[slots.clone()],
            y: &self.y[slots.clone()],
            z: &self.z[slots.clone()],
            radius: &self.radius[slots],
        }
    }

    /// The slots of a block.
    pub(crate) fn slots_of(block: usize) -> Range<usize> {
        block * BLOCK..(block + 1) * BLOCK
    }

    /// The spheres whose boxes a point lies in, by slot: all that it can be inside of.
    pub(crate) fn boxed_around(&self, point: [f64; 3]) -> impl Iterator<Item = u32> + '_ {
        let groups =
            (0..self.groups.len()).filter(move |group| self.groups.contains(*group, point));
        let blocks = groups.flat_map(|group| self.blocks_of(group));
        let blocks = blocks.filter(move |block| self.blocks.contains(*block, point));
        let slots = blocks.flat_map(SphereIndex::slots_of);
        let [x, y, z] = point;
        // Rounding keeps order: a rounded difference above r is of a true one above it.
        let is_near = move |slot: &usize| {
            let (slot, radius) = (*slot, self.radius[*slot]);
            self.ids[slot] != NO_SPHERE
                && (x - self.x[slot]).abs() <= radius
                && (y - self.y[slot]).abs() <= radius
                && (z - self.z[slot]).abs() <= radius
        };
        slots.filter(is_near).map(|slot| self.ids[slot])
    }

    fn push(&mut self, [x, y, z]: [f64; 3], radius: f64, id: u32) {
        self.x.push(x);
        self.y.push(y);
        self.z.push(z);
        self.radius.push(radius);
        self.ids.push(id);
    }

    fn put(&mut self, slot: usize, center: [f64; 3], radius: f64) {
        [self.x[slot], self.y[slot], self.z[slot]] = center;
        self.radius[slot] = radius;
    }

    /// Fills the last block up with its first sphere.
    fn fill_up(&mut self) {
        let first = (self.ids.len() - 1) / BLOCK * BLOCK;
        while !self.ids.len().is_multiple_of(BLOCK) {
            let center = [self.x[first], self.y[first], self.z[first]];
            self.push(center, self.radius[first], NO_SPHERE);
        }
    }

    /// Adds slots that only fill up.
    fn resize(&mut self, slots: usize) {
        for values in [&mut self.x, &mut self.y, &mut self.z, &mut self.radius] {
            values.resize(slots, 0.0);
        }
        self.ids.resize(slots, NO_SPHERE);
    }

    fn bound_of_block(&self, block: usize) -> Bound {
        let own = SphereIndex::slots_of(block).filter(|slot| self.ids[*slot] != NO_SPHERE);
        Bound::around(own.map(|slot| {
            let center = [self.x[slot], self.y[slot], self.z[slot]];
            Bound::of_sphere(center, self.radius[slot])
        }))
    }

    fn bound_of_group(&self, group: usize) -> Bound {
        Bound::around(self.blocks_of(group).map(|block| self.blocks.get(block)))
    }
}
