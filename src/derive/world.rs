//! What the observer sees, before anything is drawn over it.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{DVec3, Frame, Outputs, PosedCamera, Raster, Shade};

use super::memo::{Memo, Same};
use super::objects::{Enclosing, Objects};
use super::watch::{Watch, Work, picture, repainted, watched};
use crate::observer::enclosing;
use crate::overlay::Backdrop;

/// The scene as the observer sees it.
#[derive(Debug)]
pub(super) struct WorldPicture {
    /// With `t` and object, which the overlay reads.
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) pixels: Vec<Color32>,
    pub(super) enclosing: Enclosing,
}

/// What is seen from where: the observer, the generation of the objects, and those left out.
type Seen = (PosedCamera, u64, Enclosing);

/// Remembers what the observer saw.
#[derive(Debug, Default)]
pub(super) struct WorldPictures {
    enclosing: Memo<(u64, DVec3, DVec3), Enclosing>,
    /// What other colours are made from without a trace.
    frame: Memo<Seen, Arc<Frame<f32>>>,
    /// With the palette's number.
    picture: Memo<(Seen, u64), Arc<WorldPicture>>,
    backdrop: Memo<(Same<WorldPicture>, Backdrop), Arc<Vec<Color32>>>,
    traced: u64,
}

impl WorldPictures {
    /// How many times the observer's view was traced so far.
    pub(super) fn traced(&self) -> u64 {
        self.traced
    }

    /// What the observer sees of the good objects, but for those that would hide a camera at `eye`;
    /// `None` where there were none yet.
    pub(super) fn of(
        &mut self,
        objects: &mut Objects,
        eye: DVec3,
        observer: PosedCamera,
        watch: Watch<'_>,
    ) -> Option<Arc<WorldPicture>> {
        let good = objects.good()?.clone();
        let enclosing = self.enclosing.get((good.generation, eye, observer.eye()), |_| {
            Arc::new(enclosing(&good.scene, eye, observer.eye()))
        });
        let scene = objects.seen(&enclosing)?;
        let colors = (Shade::Lambert, |i: u32| good.colors[i as usize]);
        let (frame, traced) = (&mut self.frame, &mut self.traced);
        let key = ((observer, good.generation, enclosing), good.palette);
        Some(self.picture.get(key, |(seen, _)| {
            let mut fresh = None;
            let frame = frame.get(seen.clone(), |_| {
                *traced += 1;
                let (raster, outputs) = (Raster::full(observer.image()), Outputs::default());
                let traced = picture(&scene, &observer, &raster, outputs, colors, watch);
                fresh = Some(traced.1);
                Arc::new(traced.0)
            });
            let pixels = fresh.unwrap_or_else(|| repainted(&frame, &scene, colors, watch));
            Arc::new(WorldPicture { frame, pixels, enclosing: Arc::clone(&seen.2) })
        }))
    }

    /// What the observer sees with a backdrop painted over it.
    pub(super) fn before(
        &mut self,
        world: &Arc<WorldPicture>,
        backdrop: &Backdrop,
        watch: Watch<'_>,
    ) -> Arc<Vec<Color32>> {
        let key = (Same(Arc::clone(world)), backdrop.clone());
        self.backdrop.get(key, |(world, backdrop)| {
            watched(watch, Work::Overlay, || {
                let mut dots = world.0.pixels.clone();
                backdrop.paint(&world.0.frame, &mut dots);
                Arc::new(dots)
            })
        })
    }
}
