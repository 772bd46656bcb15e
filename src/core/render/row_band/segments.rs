//! Passes spheres over by segments of pixels: one comparison decides that a sphere is hidden in all pixels
//! of a segment.

use crate::render::plan::Plan;
use crate::render::row_band::fallback::{KnownObjects, order_after, seen_sphere};
use crate::render::row_band::rough_hits::{HitBounds, KeptHit};

/// Number of pixels in a segment: so few that the order of nearly equal spheres mostly is the same in all
/// of them.
const SEGMENT: usize = 8;

/// The hits kept for a band's pixels, with bounds for each segment of the pixels, which are computed when
/// they are needed.
pub(crate) struct Segments<'a> {
    plan: &'a Plan<'a>,
    hits: &'a [Option<KeptHit>],
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
        let bounds = vec![None; hits.len().div_ceil(SEGMENT)];
        Segments { plan, hits, known_objects, bounds }
    }

    /// Returns whether `f64` is certain that these objects, shown by the pixels from `offset` on, hide a
    /// sphere.
    pub(crate) fn hide(&mut self, index: u32, offset: usize, objects: &[u32]) -> bool {
        let Some(hits) = self.hits.get(offset..offset + objects.len()) else { return false };
        let is_kept = |(kept, object): (&Option<KeptHit>, &u32)| {
            kept.as_ref().is_some_and(|kept| kept.hit.object == *object)
        };
        hits.iter().zip(objects).all(is_kept)
            && (offset / SEGMENT..=(offset + objects.len() - 1) / SEGMENT)
                .all(|segment| self.segment_hides(index, segment).unwrap_or(false))
    }

    fn segment_hides(&mut self, index: u32, segment: usize) -> Option<bool> {
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
