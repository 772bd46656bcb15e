//! The order in which spheres are indexed: those of about one size that lie together stand together.

use std::ops::Range;

use crate::exact::scale::exponent;
use crate::scene::sphere::Sphere;

/// Slots in a block.
pub(crate) const BLOCK: usize = 16;

/// Blocks in a group at most.
pub(crate) const GROUP: usize = 64;

/// A sphere's centre and number, which is all that is moved while ordering.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    pub(crate) center: [f64; 3],
    pub(crate) id: u32,
}

/// Number of spheres from which on the two halves of a split may be ordered by two threads.
const SHARED_FROM: usize = 8192;

/// Classes that radii from 2^-1074 to 2^1024 fall into.
const CLASSES: usize = (1074 + 1024) / 2;

/// A radius's size class: the power of 4 that it has reached.
fn class_of(radius: f64) -> usize {
    ((exponent(radius) + 1074) / 2) as usize
}

/// All spheres in the order of the index, and the ranges of the size classes.
///
/// Within a class, halves by the median along the longest axis of the centres; each cut lies at a
/// whole number of groups, within a group at a whole number of blocks, so that only the last block
/// of a class is not full. The order depends on the spheres alone, not on the number of threads.
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

/// Brings the `middle` smallest of an axis to the front.
fn select<const AXIS: usize>(keys: &mut [Key], middle: usize) {
    keys.select_nth_unstable_by(middle, |a, b| a.center[AXIS].total_cmp(&b.center[AXIS]));
}

/// The axis along which the centres are spread the widest.
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
