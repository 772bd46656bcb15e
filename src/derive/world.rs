//! What the observer sees, before anything is drawn over it.

use std::borrow::Cow;
use std::sync::Arc;

use egui::Color32;
use pinhole_core::{DVec3, Frame, Outputs, PosedCamera, Raster, Rgb, Scene, Shade};

use super::GoodWorld;
use super::memo::Memo;
use super::watch::{Watch, picture};
use crate::observer::{enclosing, seen_scene};

/// Indices of the spheres that would hide the camera from the observer.
type Enclosing = Arc<Vec<u32>>;

/// The scene as the observer sees it.
#[derive(Debug)]
pub(super) struct WorldPicture {
    /// With `t` and object, which the overlay reads.
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) pixels: Vec<Color32>,
    pub(super) enclosing: Enclosing,
}

/// Remembers what the observer saw.
#[derive(Debug, Default)]
pub(super) struct WorldPictures {
    enclosing: Memo<(u64, DVec3, DVec3), Enclosing>,
    seen_scene: Memo<(u64, Enclosing), Arc<Scene>>,
    picture: Memo<(PosedCamera, u64, Enclosing), Arc<WorldPicture>>,
    made: u64,
}

impl WorldPictures {
    /// How many pictures were made so far.
    pub(super) fn made(&self) -> u64 {
        self.made
    }

    /// What the observer sees of the objects, but for those that would hide a camera at `eye`.
    pub(super) fn of(
        &mut self,
        good: &GoodWorld,
        eye: DVec3,
        observer: PosedCamera,
        color_of: impl Fn(u32) -> Rgb + Sync,
        watch: Watch<'_>,
    ) -> Arc<WorldPicture> {
        let GoodWorld { scene, generation, .. } = good;
        let enclosing = self.enclosing.get((*generation, eye, observer.eye()), |_| {
            Arc::new(enclosing(scene, eye, observer.eye()))
        });
        let seen =
            self.seen_scene.get((*generation, Arc::clone(&enclosing)), |_| {
                match seen_scene(scene, &enclosing) {
                    Cow::Borrowed(_) => Arc::clone(scene),
                    Cow::Owned(seen) => Arc::new(seen),
                }
            });
        let made = &mut self.made;
        self.picture.get((observer, *generation, enclosing), |(.., enclosing)| {
            *made += 1;
            let raster = Raster::full(observer.image());
            let colors = (Shade::Lambert, color_of);
            let (frame, pixels) =
                picture(&seen, &observer, &raster, Outputs::default(), colors, watch);
            Arc::new(WorldPicture {
                frame: Arc::new(frame),
                pixels,
                enclosing: Arc::clone(enclosing),
            })
        })
    }
}
