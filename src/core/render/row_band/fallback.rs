//! Pixels that go up the ladder by themselves.

use std::cmp::Ordering;

use crate::exact::steps::Steps;
use crate::render::frame::NO_OBJECT;
use crate::render::polynomial::blend::{T_SHARE, to_single};
use crate::render::row_band::RowBand;
use crate::render::rows::span::Doubt;
use crate::scene::object::Object;
use crate::scene::object_from_origin::{Hit, ObjectFromOrigin};

impl RowBand<'_> {
    /// A sphere as the eye sees it.
    pub(crate) fn seen(&self, index: u32) -> ObjectFromOrigin {
        let sphere = Object::Sphere(self.plan.scene.spheres()[index as usize]);
        ObjectFromOrigin::new(&sphere, self.plan.rays.camera().eye())
    }

    /// A pixel that a sphere's row could not decide.
    pub(crate) fn resolve(&mut self, doubt: &Doubt) {
        let Doubt { index, row, column, t } = *doubt;
        let (row, column) = (row as usize, column as usize);
        self.steps.f64 += 1;
        let sphere = self.plan.scene.spheres()[index as usize];
        let offset = (row - self.rows.start) * self.plan.rays.n.len() + column;
        let known = self.object[offset];
        let known_sphere = self.plan.scene.spheres().get(known as usize);
        if known_sphere == Some(&sphere) {
            // The same sphere given twice.
            self.object[offset] = known.min(index);
            return;
        }
        let seen = self.seen(index);
        self.resolve_exactly(index, &seen, row, column, t);
    }

    /// Decides one pixel by itself, up the ladder; its `t` may be known.
    #[cold]
    pub(crate) fn resolve_exactly(
        &mut self,
        index: u32,
        seen: &ObjectFromOrigin,
        row: usize,
        column: usize,
        t: Option<f32>,
    ) {
        let camera = self.plan.rays.camera();
        let ray = camera.exact_ray(self.plan.rays.pixel(row, column));
        let offset = (row - self.rows.start) * self.plan.rays.n.len() + column;
        // The ladder counts this decision at its own step.
        self.steps.f64 -= 1;
        let Some(root) = seen.first_root(&ray, &mut self.steps) else { return };
        let hit = Hit { index, seen, root };
        let known = self.object[offset];
        if known != NO_OBJECT
            && let Some(object) = self.plan.scene.object(known)
        {
            let known_seen = ObjectFromOrigin::new(&object, camera.eye());
            let known_root = known_seen.first_root(&ray, &mut Steps::default());
            let order = known_root.map_or(Ordering::Less, |root| {
                let known = Hit { index: known, seen: &known_seen, root };
                hit.compare(&known, &ray, &mut self.steps)
            });
            if order.then(index.cmp(&known)) == Ordering::Greater {
                return;
            }
        }
        self.object[offset] = index;
        if let Some(t) = t {
            self.t[offset] = to_single(f64::from(t));
            return;
        }
        let t = seen.t_within(&ray, root, T_SHARE);
        self.t[offset] = to_single(t.to_f64());
    }
}
