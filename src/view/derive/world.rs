//! The observer's picture, before the overlay is drawn over it.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{DVec3, Frame, Outputs, ResolvedCamera, Shade};

use super::derived::Inputs;
use super::key_light;
use super::memo::{Fineness, Memo, Same};
use super::objects::{Enclosing, Objects};
use super::watch::{Watch, Work, picture, repainted, watched};
use crate::model::observer::enclosing;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::overlay::Backdrop;

/// The scene as the observer sees it.
#[derive(Debug)]
pub(super) struct WorldPicture {
    /// The frame with `t` and object, which the overlay reads.
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) pixels: Vec<Color32>,
    pub(super) enclosing: Enclosing,
    /// The picture's subsampling.
    pub(super) subsampling: Subsampling,
}

/// The inputs of a trace: the observer, the generation of the objects, and the hidden spheres.
type TraceKey = (ResolvedCamera, u64, Enclosing);

/// A cache of the observer's pictures.
#[derive(Debug, Default)]
pub(super) struct WorldPictures {
    enclosing: Memo<(u64, DVec3, DVec3), Enclosing>,
    fineness: Fineness<TraceKey>,
    /// Frames that can be recoloured without a trace.
    frame: Memo<(TraceKey, Subsampling), Arc<Frame<f32>>>,
    /// The picture; the last part of the key is the palette's number.
    picture: Memo<(TraceKey, Subsampling, u64), Arc<WorldPicture>>,
    backdrop: Memo<(Same<WorldPicture>, Backdrop), Arc<Vec<Color32>>>,
    /// Number of times the observer's view was traced.
    pub(super) traced: u64,
}

impl WorldPictures {
    /// Returns the observer's picture of the good objects, without those that would hide the camera;
    /// `None` if there have been no good objects yet.
    pub(super) fn get(
        &mut self,
        Inputs { document, sizes, watch, .. }: Inputs<'_>,
        objects: &mut Objects,
        observer: ResolvedCamera,
    ) -> Option<Arc<WorldPicture>> {
        let (good, eye) = (objects.good()?.clone(), document.camera.eye);
        let enclosing = self.enclosing.get((good.generation, eye, observer.eye()), |_| {
            Arc::new(enclosing(&good.scene, eye, observer.eye()))
        });
        let scene = objects.observed(&enclosing)?;
        let color_of = |i: u32| good.colors[i as usize];
        let colors = (Shade::Object, color_of);
        let (frame, traced) = (&mut self.frame, &mut self.traced);
        let seen = (observer, good.generation, enclosing);
        let subsampling = self.fineness.at_most(seen.clone(), sizes.subsampling);
        Some(self.picture.get((seen, subsampling, good.palette), |(seen, ..)| {
            let mut fresh = None;
            let frame = frame.get((seen.clone(), subsampling), |_| {
                *traced += 1;
                let image = observer.image();
                let raster = subsampling.raster(image, [image.width(), image.height()]);
                let mut traced =
                    picture(&scene, &observer, &raster, Outputs::default(), colors, (None, watch));
                watched(watch, Work::Trace, || {
                    key_light::paint(&traced.0, &scene, color_of, &mut traced.1);
                });
                if subsampling == Subsampling::NONE {
                    fresh = Some(traced.1);
                    return Arc::new(traced.0);
                }
                // The overlay looks up the object at every dot.
                fresh = Some(raster.spread(image, &traced.1));
                Arc::new(traced.0.spread())
            });
            let pixels = fresh.unwrap_or_else(|| {
                let mut pixels = repainted(&frame, &scene, colors, watch);
                key_light::paint(&frame, &scene, color_of, &mut pixels);
                pixels
            });
            let enclosing = Arc::clone(&seen.2);
            Arc::new(WorldPicture { frame, pixels, enclosing, subsampling })
        }))
    }

    /// Returns the observer's picture with a backdrop painted over it.
    pub(super) fn painted(
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
