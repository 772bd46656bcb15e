//! Decides individually, by the ladder of `f64`, double-double and exact numbers, the pixels that
//! drawing has left in doubt, with a cache of the values precomputed for objects and for pairs of them.
//! Also computes `t` in `f64` and normals for hits whose objects are known.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::mem;
use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use crate::exact::quadratic::DirectionTerms;
use crate::exact::scale::ldexp;
use crate::exact::steps::{Step, Steps};
use crate::render::frame::NO_OBJECT;
use crate::render::plan::Plan;
use crate::render::polynomial::object_kernel::factor;
use crate::render::polynomial::{T_SHARE, is_in_range, to_single};
use crate::render::row_band::RowBand;
use crate::render::row_band::rough_hits::{HitBounds, KeptHit, Rough, RoughHit};
use crate::render::rows::span::Doubt;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin, plane_normal};
use crate::scene::pair_order::PairOrder;
use crate::scene::plane_predicates::PlaneFromOrigin;
use crate::scene::sphere_predicates::SphereFromOrigin;

/// Minimum number of pixels in doubt for which it pays to cache each pixel's hit in `f64` and to divide
/// the pixels among threads.
pub(crate) const MANY: usize = 1024;

/// Number of parts into which a band's rows are divided for the threads.
const SHARES: usize = 4;

/// A pixel and an object that it may show.
#[derive(Clone, Copy)]
pub(crate) struct PixelQuery<'a> {
    pub(crate) index: u32,
    pub(crate) seen: &'a ObjectFromOrigin,
    /// The pixel's row in the raster.
    pub(crate) row: usize,
    /// The pixel's column in the raster.
    pub(crate) column: usize,
    /// `t`, if the object is known to be hit; otherwise `None`.
    pub(crate) t: Option<f32>,
}

/// Some rows of a frame with the hits known so far. Their pixels in doubt are decided one by one.
pub(crate) struct PixelLadder<'a> {
    plan: &'a Plan<'a>,
    rows: Range<usize>,
    t: &'a mut [f32],
    object: &'a mut [u32],
    /// The hit, in `f64`, of the sphere that each pixel shows; empty if few pixels are in doubt.
    hits: &'a mut [Option<KeptHit>],
    known_objects: &'a mut KnownObjects,
    steps: &'a mut Steps,
}

impl RowBand<'_> {
    /// Decides the pixels that [`RowBand::draw_rows`] has left in doubt.
    pub(crate) fn resolve_doubt(&mut self) {
        let doubts = mem::take(&mut self.doubts);
        if doubts.len() < MANY {
            self.ladder().resolve_all(&doubts);
        } else {
            let RowBand { plan, rows, t, object, hits, steps, .. } = self;
            hits.resize(t.len(), None);
            let count = rows.len().div_ceil(SHARES);
            let size = count * plan.axes.width;
            let pixels = t.par_chunks_mut(size).zip(object.par_chunks_mut(size));
            let shares = pixels.zip(hits.par_chunks_mut(size)).enumerate();
            let resolved = shares.map(|(share, ((t, object), hits))| {
                let first = rows.start + share * count;
                let rows = first..rows.end.min(first + count);
                let (mut steps, mut known_objects) = Default::default();
                let (steps, known_objects) = (&mut steps, &mut known_objects);
                PixelLadder { plan, rows, t, object, hits, known_objects, steps }
                    .resolve_all(&doubts);
                *steps
            });
            *steps = *steps + resolved.reduce(Steps::default, |a, b| a + b);
        }
        self.doubts = doubts;
        self.doubts.clear();
    }

    /// Decides one pixel by the ladder. The caller has counted it as decided in `f64`; now it is counted
    /// at the step that decides it.
    #[cold]
    pub(crate) fn resolve_exactly(&mut self, query: &PixelQuery) {
        self.steps.f64 -= 1;
        self.asked += 1;
        if self.asked == MANY {
            self.hits.resize(self.t.len(), None);
        }
        self.ladder().resolve(query);
    }

    fn ladder(&mut self) -> PixelLadder<'_> {
        let RowBand { plan, rows, t, object, hits, known_objects, steps, .. } = self;
        PixelLadder { plan, rows: rows.clone(), t, object, hits, known_objects, steps }
    }
}

/// Returns a sphere with the values that all rays from the eye share.
pub(crate) fn seen_sphere(plan: &Plan, index: u32) -> ObjectFromOrigin {
    let sphere = Object::Sphere(plan.scene.spheres()[index as usize]);
    ObjectFromOrigin::new(&sphere, plan.rays.camera.eye())
}

/// Returns the order of a sphere, given by its index, and another object.
pub(crate) fn order_after(plan: &Plan, sphere: u32, other: &ObjectFromOrigin) -> Option<PairOrder> {
    PairOrder::new(&seen_sphere(plan, sphere), other, plan.rays.camera.eye())
}

impl PixelLadder<'_> {
    /// Decides those of the pixels in doubt that lie in these rows.
    fn resolve_all(&mut self, doubts: &[Doubt]) {
        // Consecutive pixels in doubt mostly concern the same sphere.
        let mut last: Option<(u32, ObjectFromOrigin)> = None;
        for doubt in doubts {
            let Doubt { index, row, column, t } = *doubt;
            let (row, column) = (row as usize, column as usize);
            if !self.rows.contains(&row) {
                continue;
            }
            let seen = match &last {
                Some((known, seen)) if *known == index => seen,
                _ => &last.insert((index, seen_sphere(self.plan, index))).1,
            };
            self.resolve(&PixelQuery { index, seen, row, column, t });
        }
    }

    fn resolve(&mut self, query: &PixelQuery) {
        let is_decided = match query.seen {
            ObjectFromOrigin::Sphere(sphere) => self.decide_roughly(query, sphere),
            ObjectFromOrigin::Plane(plane) => self.decide_planes_roughly(query, plane),
        };
        if is_decided {
            self.steps.f64 += 1;
        } else {
            self.decide_exactly(query);
        }
    }

    /// Returns the pixel's position in the buffers.
    fn offset(&self, query: &PixelQuery) -> usize {
        (query.row - self.rows.start) * self.plan.rays.n.len() + query.column
    }

    /// Tries to decide a pixel in `f64`; returns whether `f64` is certain.
    fn decide_roughly(&mut self, query: &PixelQuery, seen: &SphereFromOrigin) -> bool {
        let PixelQuery { index, row, column, t, .. } = *query;
        let (plan, offset) = (self.plan, self.offset(query));
        let after = |sphere: u32| move || order_after(plan, sphere, query.seen);
        if !plan.rays.is_plain {
            return false;
        }
        let known = self.object[offset];
        let known_sphere = plan.scene.spheres().get(known as usize);
        if known_sphere == Some(&seen.sphere) {
            // The same sphere is listed twice, with the same t.
            self.object[offset] = known.min(index);
            return true;
        }
        // Most hits are farther than the known one.
        if let Some(Some(kept)) = self.hits.get(offset)
            && kept.hit.object == known
            && let Some(order) = self
                .known_objects
                .order([kept.bounds.reference, index], after(kept.bounds.reference))
            && kept.bounds.are_before(order)
        {
            return true;
        }
        let direction = plan.rays.rough_direction(row, column);
        let hit = match Rough::new(index, seen, &direction) {
            Rough::Doubt => return false,
            Rough::Miss => return true,
            Rough::Hit(hit) => hit,
        };
        if known != NO_OBJECT {
            let Some(shown) = self.known_hit(offset, known, &direction) else { return false };
            let order = shown.compare_t(&hit).or_else(|| {
                let order = self.known_objects.order([known, index], after(known))?;
                order.compare(&direction, Some(shown.root))
            });
            match order {
                Some(Ordering::Greater) => {}
                Some(Ordering::Less) => return true,
                _ => return false,
            }
        }
        let Some(t) = t.or_else(|| self.single_t(&hit)) else { return false };
        self.object[offset] = index;
        self.t[offset] = to_single(f64::from(t));
        self.keep(offset, hit, query.seen, &direction);
        true
    }

    /// Tries to decide in `f64` which of two planes a pixel shows; returns whether `f64` is certain.
    fn decide_planes_roughly(&mut self, query: &PixelQuery, plane: &PlaneFromOrigin) -> bool {
        let PixelQuery { index, row, column, .. } = *query;
        let (plan, offset) = (self.plan, self.offset(query));
        let known = self.object[offset];
        let first = plan.scene.spheres().len() as u32;
        let known_plane = known.checked_sub(first).and_then(|k| plan.planes.get(k as usize));
        let Some(Some(known_seen)) = known_plane else { return false };
        let Some(factor) = factor(&plan.rays, plane.scale) else { return false };
        let direction = plan.rays.rough_direction(row, column);
        let Some((t, share)) = plane.rough_t(&direction) else { return false };
        if t > 0.0 {
            let order = self.known_objects.order([index, known], || {
                PairOrder::new(query.seen, known_seen, plan.rays.camera.eye())
            });
            match order.and_then(|order| order.compare(&direction, None)) {
                Some(Ordering::Greater) => {}
                Some(Ordering::Less) if share <= T_SHARE && is_in_range(t * factor) => {
                    (self.object[offset], self.t[offset]) = (index, to_single(t * factor));
                }
                _ => return false,
            }
        }
        true
    }

    /// Returns the hit on the sphere that a pixel shows. Returns `None` if the pixel shows no sphere, or
    /// if `f64` is not certain of the hit.
    fn known_hit(
        &mut self,
        offset: usize,
        object: u32,
        direction: &DirectionTerms<f64>,
    ) -> Option<RoughHit> {
        if let Some(Some(kept)) = self.hits.get(offset)
            && kept.hit.object == object
        {
            return Some(kept.hit);
        }
        if object as usize >= self.plan.scene.spheres().len() {
            return None;
        }
        let seen = self.known_objects.get(object, || seen_sphere(self.plan, object));
        let ObjectFromOrigin::Sphere(seen) = seen else { return None };
        let Rough::Hit(hit) = Rough::new(object, seen, direction) else { return None };
        if let Some(kept) = self.hits.get_mut(offset) {
            *kept = Some(KeptHit { hit, bounds: HitBounds::new(&hit, direction, None) });
        }
        Some(hit)
    }

    /// Keeps the hit on the sphere that a pixel shows from now on, with the reference of the one before.
    fn keep(
        &mut self,
        offset: usize,
        hit: RoughHit,
        seen: &ObjectFromOrigin,
        direction: &DirectionTerms<f64>,
    ) {
        let (plan, Some(kept)) = (self.plan, self.hits.get_mut(offset)) else { return };
        let reference = kept.map(|kept| kept.bounds.reference).and_then(|reference| {
            let after = || order_after(plan, reference, seen);
            Some((reference, self.known_objects.order([reference, hit.object], after)?))
        });
        *kept = Some(KeptHit { hit, bounds: HitBounds::new(&hit, direction, reference) });
    }

    /// Returns `t` in the frame's precision; `None` if `f64` does not give it accurately enough.
    fn single_t(&self, hit: &RoughHit) -> Option<f32> {
        let (rays, root) = (&self.plan.rays, hit.root);
        let t = ldexp(root.t * rays.stretch, hit.scale - rays.scale);
        (root.share <= T_SHARE && is_in_range(t)).then(|| to_single(t))
    }

    /// Decides a pixel by all steps of the ladder.
    fn decide_exactly(&mut self, query: &PixelQuery) {
        let PixelQuery { index, seen, row, column, t } = *query;
        let (camera, offset) = (self.plan.rays.camera, self.offset(query));
        let ray = camera.exact_ray(self.plan.rays.pixel(row, column));
        let Some(root) = seen.first_root(&ray, self.steps) else { return };
        let hit = Hit { index, object: Cow::Borrowed(seen), root };
        let known = self.object[offset];
        if known != NO_OBJECT
            && let Some(object) = self.plan.scene.object(known)
        {
            let make = || ObjectFromOrigin::new(&object, camera.eye());
            let known_seen = self.known_objects.get(known, make).clone();
            // The ray hits the object that the pixel shows.
            let pair = self
                .known_objects
                .order([known, index], || PairOrder::new(&known_seen, seen, camera.eye()));
            let root = match &known_seen {
                ObjectFromOrigin::Sphere(known) => known.fine_hit(&ray),
                ObjectFromOrigin::Plane(_) => None,
            };
            let fine = pair.and_then(|pair| pair.compare(&ray.fine, root));
            let order = if let Some(order) = fine {
                self.steps.count(Step::DoubleDouble);
                order.reverse()
            } else {
                let (object, root) = (Cow::Borrowed(&known_seen), known_seen.root_of_hit());
                hit.compare(&Hit { index: known, object, root }, &ray, self.steps)
            };
            if order.then(index.cmp(&known)) == Ordering::Greater {
                return;
            }
        }
        self.object[offset] = index;
        let t = t.unwrap_or_else(|| to_single(seen.t_within(&ray, root, T_SHARE).to_f64()));
        self.t[offset] = to_single(f64::from(t));
    }
}

/// A cache of objects with the values that all rays from the eye share, keyed by the object's index, and
/// of the orders in which rays hit pairs of objects.
#[derive(Debug, Default)]
pub(crate) struct KnownObjects {
    objects: Vec<Option<(u32, ObjectFromOrigin)>>,
    orders: Vec<Option<([u32; 2], Option<PairOrder>)>>,
}

/// Number of slots of a cache. In a slot, a new value replaces the one before it.
const SLOTS: usize = 256;

/// Returns the value of a key from a cache, or the newly computed one.
fn cached<K: Clone + PartialEq, V: Clone>(
    cache: &mut Vec<Option<(K, V)>>,
    slot: usize,
    key: K,
    make: impl FnOnce() -> V,
) -> &V {
    cache.resize(SLOTS, None);
    let slot = &mut cache[slot % SLOTS];
    if slot.as_ref().is_none_or(|(known, _)| *known != key) {
        *slot = None;
    }
    &slot.get_or_insert_with(|| (key, make())).1
}

impl KnownObjects {
    /// Returns an object with the values that all rays from the eye share, from the cache or newly
    /// computed.
    pub(crate) fn get(
        &mut self,
        index: u32,
        make: impl FnOnce() -> ObjectFromOrigin,
    ) -> &ObjectFromOrigin {
        cached(&mut self.objects, index as usize, index, make)
    }

    /// Returns the order in which rays hit two objects, from the cache or newly computed; `None` if they
    /// have none.
    pub(crate) fn order(
        &mut self,
        pair: [u32; 2],
        make: impl FnOnce() -> Option<PairOrder>,
    ) -> Option<&PairOrder> {
        let [one, other] = pair.map(|index| index as usize);
        cached(&mut self.orders, 31 * one + other, pair, make).as_ref()
    }
}

/// Computes `t` and normals of the pixels in some rows, given their objects. An empty buffer is skipped.
/// Returns how many values of `t` each step of the ladder computed.
pub(crate) fn fill_exactly(
    plan: &Plan,
    rows: Range<usize>,
    object: &[u32],
    t: &mut [f64],
    normals: &mut [DVec3],
) -> Steps {
    let mut steps = Steps::default();
    if t.is_empty() && normals.is_empty() {
        return steps;
    }
    let (camera, width) = (plan.rays.camera, plan.axes.width);
    let mut known: Option<(u32, ObjectFromOrigin)> = None;
    for (offset, object) in object.iter().copied().enumerate() {
        if known.as_ref().is_none_or(|(index, _)| *index != object) {
            let given = plan.scene.object(object);
            known = given.map(|given| (object, ObjectFromOrigin::new(&given, camera.eye())));
        }
        let pixel = plan.rays.pixel(rows.start + offset / width, offset % width);
        let hit = known.as_ref().map(|(_, seen)| (seen, camera.exact_ray(pixel)));
        if let Some(t) = t.get_mut(offset) {
            *t = hit.map_or(f64::INFINITY, |(seen, ray)| {
                seen.rounded_t(&ray, seen.root_of_hit(), &mut steps)
            });
        }
        if let Some(normal) = normals.get_mut(offset) {
            *normal = match hit {
                None => DVec3::ZERO,
                Some((ObjectFromOrigin::Plane(seen), _)) => plane_normal(seen.plane.normal),
                Some((ObjectFromOrigin::Sphere(seen), ray)) => {
                    seen.normal(&ray, seen.root_of_hit())
                }
            };
        }
    }
    steps
}
