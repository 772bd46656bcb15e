//! The limit: storing t and object of every pixel and doing nothing else.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch};
use pinhole_core::ImageSize;
use rayon::prelude::*;

use crate::frames::Buffers;

/// Number of bytes that no cache holds.
const BEYOND_CACHES: usize = 256 << 20;

/// Stores over the same buffers again, or over several sets of buffers in turn.
#[derive(Clone, Debug)]
pub struct Stores {
    sets: Vec<Buffers>,
    level: Level,
    frame: usize,
}

impl Stores {
    /// Over the same buffers again: they stay in the caches as far as they fit, as a tracer's do.
    pub fn again(image: ImageSize, level: Level) -> Stores {
        Stores { sets: vec![Buffers::new(image)], level, frame: 0 }
    }

    /// Over so many buffers in turn that none is in a cache any more: to memory.
    pub fn to_memory(image: ImageSize, level: Level) -> Stores {
        let bytes = 8 * image.width() as usize * image.height() as usize;
        let count = BEYOND_CACHES.div_ceil(bytes).max(2);
        Stores { sets: vec![Buffers::new(image); count], level, frame: 0 }
    }

    /// Stores a frame: each thread a part of it, in vectors of the level. Returns its buffers.
    pub fn run(&mut self) -> &Buffers {
        self.frame += 1;
        let (t, object) = (self.frame as f32, self.frame as u32);
        let count = self.sets.len();
        let buffers = &mut self.sets[self.frame % count];
        let part = buffers.t.len().div_ceil(rayon::current_num_threads()).next_multiple_of(16);
        let level = self.level;
        let parts = buffers.t.par_chunks_mut(part).zip(buffers.object.par_chunks_mut(part));
        parts
            .for_each(|(ts, objects)| dispatch!(level, simd => fill(simd, ts, t, objects, object)));
        buffers
    }
}

#[inline(always)]
fn fill<S: Simd>(simd: S, ts: &mut [f32], t: f32, objects: &mut [u32], object: u32) {
    let (wide_t, wide_object) = (S::f32s::splat(simd, t), S::u32s::splat(simd, object));
    let mut t_chunks = ts.chunks_exact_mut(S::f32s::LEN);
    let mut object_chunks = objects.chunks_exact_mut(S::u32s::LEN);
    for (ts, objects) in (&mut t_chunks).zip(&mut object_chunks) {
        wide_t.store_slice(ts);
        wide_object.store_slice(objects);
    }
    t_chunks.into_remainder().fill(t);
    object_chunks.into_remainder().fill(object);
}
