//! Pixels that go up the ladder by themselves.

use std::cmp::Ordering;
use std::mem;

use crate::render::frame::NO_OBJECT;
use crate::render::polynomial::blend::{T_SHARE, is_in_range, to_single};
use crate::render::row_band::RowBand;
use crate::render::row_band::rough_hits::{Rough, RoughHit};
use crate::render::rows::span::Doubt;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin};
use crate::scene::sphere_predicates::SphereFromOrigin;

/// What a pixel of the band is asked about.
#[derive(Clone, Copy)]
struct Question<'a> {
    index: u32,
    seen: &'a ObjectFromOrigin,
    /// The pixel's row and column in the raster, and its position in the band.
    row: usize,
    column: usize,
    offset: usize,
    /// t, where it is known that the object is hit.
    t: Option<f32>,
}

impl RowBand<'_> {
    /// A sphere as the eye sees it.
    pub(crate) fn seen(&self, index: u32) -> ObjectFromOrigin {
        let sphere = Object::Sphere(self.plan.scene.spheres()[index as usize]);
        ObjectFromOrigin::new(&sphere, self.plan.rays.camera().eye())
    }

    /// Decides the pixels that the rows have left in doubt.
    pub(crate) fn resolve_doubt(&mut self) {
        let mut doubts = mem::take(&mut self.doubts);
        self.known.expect(doubts.len(), self.t.len());
        // They come sphere by sphere.
        let mut seen: Option<(u32, ObjectFromOrigin)> = None;
        for doubt in doubts.drain(..) {
            let index = doubt.index;
            let seen = match &seen {
                Some((known, seen)) if *known == index => seen,
                _ => &seen.insert((index, self.seen(index))).1,
            };
            self.resolve(&doubt, seen);
        }
        self.doubts = doubts;
    }

    /// A pixel that a sphere's row could not decide.
    fn resolve(&mut self, doubt: &Doubt, seen: &ObjectFromOrigin) {
        let Doubt { index, row, column, t } = *doubt;
        self.steps.f64 += 1;
        self.resolve_exactly(index, seen, row as usize, column as usize, t);
    }

    /// Decides one pixel by itself, up the ladder; its `t` may be known. It has been counted as decided in
    /// `f64`, and is counted at its own step instead.
    #[cold]
    pub(crate) fn resolve_exactly(
        &mut self,
        index: u32,
        seen: &ObjectFromOrigin,
        row: usize,
        column: usize,
        t: Option<f32>,
    ) {
        self.steps.f64 -= 1;
        let offset = (row - self.rows.start) * self.plan.rays.n.len() + column;
        let question = Question { index, seen, row, column, offset, t };
        let is_decided = match seen {
            ObjectFromOrigin::Sphere(sphere) => self.decide_roughly(&question, sphere),
            ObjectFromOrigin::Plane(_) => false,
        };
        if !is_decided {
            self.decide_exactly(&question);
        }
    }

    /// Decides a pixel in `f64`, if that is sure; returns whether it is.
    fn decide_roughly(&mut self, question: &Question, seen: &SphereFromOrigin) -> bool {
        let Question { index, row, column, offset, t, .. } = *question;
        let rays = &self.plan.rays;
        if !rays.is_plain() {
            return false;
        }
        let known = self.object[offset];
        let spheres = self.plan.scene.spheres();
        let known_sphere = spheres.get(known as usize);
        if known_sphere == Some(seen.sphere()) {
            // The same sphere given twice, at the same t; or this one, asked again.
            self.object[offset] = known.min(index);
            self.steps.f64 += 1;
            return true;
        }
        let direction = rays.rough_direction(row, column);
        let hit = match Rough::new(index, seen, &direction) {
            Rough::Doubt => return false,
            Rough::Miss => {
                self.steps.f64 += 1;
                return true;
            }
            Rough::Hit(hit) => hit,
        };
        if known != NO_OBJECT {
            let Some(known_sphere) = known_sphere else { return false };
            let eye = rays.camera().eye();
            let make = || ObjectFromOrigin::new(&Object::Sphere(*known_sphere), eye);
            let Some(known) = self.known.hit(offset, known, &direction, make) else { return false };
            // Asked of the known hit, which is at hand for the next sphere too.
            match known.compare(&hit, known_sphere, seen.sphere()) {
                None | Some(Ordering::Equal) => return false,
                Some(Ordering::Less) => {
                    self.steps.f64 += 1;
                    return true;
                }
                Some(Ordering::Greater) => {}
            }
        }
        let Some(t) = t.or_else(|| self.single_t(&hit)) else { return false };
        self.steps.f64 += 1;
        self.object[offset] = index;
        self.t[offset] = to_single(f64::from(t));
        self.known.keep(offset, hit);
        true
    }

    /// Returns t as the frame has it, if `f64` knows it well enough.
    fn single_t(&self, hit: &RoughHit) -> Option<f32> {
        let rays = &self.plan.rays;
        let t = hit.t_of(rays.stretch, rays.scale);
        (hit.share <= T_SHARE && is_in_range(t)).then(|| to_single(t))
    }

    /// Decides a pixel by all steps of the ladder.
    fn decide_exactly(&mut self, question: &Question) {
        let Question { index, seen, row, column, offset, t } = *question;
        let camera = self.plan.rays.camera();
        let ray = camera.exact_ray(self.plan.rays.pixel(row, column));
        let Some(root) = seen.first_root(&ray, &mut self.steps) else { return };
        let hit = Hit { index, seen, root };
        let known = self.object[offset];
        if known != NO_OBJECT
            && let Some(object) = self.plan.scene.object(known)
        {
            let make = || ObjectFromOrigin::new(&object, camera.eye());
            let known_seen = self.known.seen(known, make);
            // What a pixel shows is hit.
            let known_hit = Hit { index: known, seen: known_seen, root: known_seen.root_of_hit() };
            let order = hit.compare(&known_hit, &ray, &mut self.steps);
            if order.then(index.cmp(&known)) == Ordering::Greater {
                return;
            }
        }
        self.object[offset] = index;
        let t = t.unwrap_or_else(|| to_single(seen.t_within(&ray, root, T_SHARE).to_f64()));
        self.t[offset] = to_single(f64::from(t));
    }
}
