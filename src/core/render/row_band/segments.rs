//! Passes spheres over by segments of pixels: one comparison decides that a sphere is hidden in all pixels
//! of a segment.

use std::ops::Range;

use crate::render::frame::NO_OBJECT;
use crate::render::plan::Plan;
use crate::render::row_band::fallback::{KnownObjects, order_after, seen_sphere};
use crate::render::row_band::rough_hits::{HitBounds, KeptHit};

/// Number of pixels in a segment: so few that the order of nearly equal spheres mostly is the same in all
/// of them.
const SEGMENT: usize = 8;

/// The object of a pixel without a kept hit, different from any that a pixel shows.
const NOT_KEPT: u32 = NO_OBJECT - 1;

/// The hits kept for a band's pixels, with bounds for each segment of the pixels, which are computed when
/// they are needed.
pub(crate) struct Segments<'a> {
    plan: &'a Plan<'a>,
    hits: &'a [Option<KeptHit>],
    /// The object of each pixel's kept hit.
    objects: Vec<u32>,
    known_objects: &'a mut KnownObjects,
    /// For each segment, `Some` if its bounds have been computed: `None` if its hits have none.
    bounds: Vec<Option<Option<HitBounds>>>,
}

impl<'a> Segments<'a> {
    pub(crate) fn new(
        plan: &'a Plan<'a>,
        hits: &'a [Option<KeptHit>],
        known_objects: &'a mut KnownObjects,
    ) -> Segments<'a> {
        let kept = |kept: &Option<KeptHit>| kept.map_or(NOT_KEPT, |kept| kept.hit.object);
        let objects = hits.iter().map(kept).collect();
        let bounds = vec![None; hits.len().div_ceil(SEGMENT)];
        Segments { plan, hits, objects, known_objects, bounds }
    }

    /// Returns the first run of pixels in which `f64` is not certain that the objects that they show hide a
    /// sphere; empty if there are none.
    pub(crate) fn unhidden(
        &mut self,
        index: u32,
        pixels: Range<usize>,
        object: &[u32],
    ) -> Range<usize> {
        let mut run = pixels.start..pixels.start;
        while run.end < pixels.end {
            let segment = run.end / SEGMENT;
            let part = run.end..pixels.end.min((segment + 1) * SEGMENT);
            let is_kept = self.objects[part.clone()] == object[part.clone()];
            let is_hidden = is_kept && self.hides(index, segment).unwrap_or(false);
            if is_hidden && !run.is_empty() {
                break;
            }
            run = if is_hidden { part.end..part.end } else { run.start..part.end };
        }
        run
    }

    /// Returns whether the kept hits of a segment hide a sphere; `None` if they have no bounds.
    fn hides(&mut self, index: u32, segment: usize) -> Option<bool> {
        let (plan, hits) = (self.plan, self.hits);
        let bounds = self.bounds[segment].get_or_insert_with(|| {
            let hits = &hits[segment * SEGMENT..hits.len().min((segment + 1) * SEGMENT)];
            let mut all = hits.iter().flatten().map(|kept| kept.bounds);
            let first = all.next()?;
            all.try_fold(first, HitBounds::with)
        });
        let bounds = bounds.as_ref()?;
        let order = self.known_objects.order([bounds.reference, index], || {
            order_after(plan, bounds.reference, &seen_sphere(plan, index))
        })?;
        Some(bounds.are_before(order))
    }
}
