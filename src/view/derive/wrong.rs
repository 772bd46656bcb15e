//! The wrong camera's picture beside the right one.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, Paint, Raster, ResolvedCamera, Rgb, Shade};
use pinhole_lecture::mistakes::{ComparedCamera, Mistake};

use super::beside::shown_beside;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::watch::{Watch, Work, watched};
use super::{Derived, Shown, ViewSizes};
use crate::model::inspection::Inspection;
use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::session::{Selection, Session};
use crate::view::adaptive_resolution::Subsampling;
use crate::view::overlay::{Picture, Style};

/// The inputs of a wrong picture: the camera, the objects and colours by number, and the rest.
type Key = (Camera, u64, u64, Raster, Shade, Mistake);

/// The inputs of the overlay on it.
type ViewKey = (u64, Selection, [u32; 2], OverlayItems, f32, Style);

/// A cache of the wrong camera and its picture; the last ones stay while the camera has a fault.
#[derive(Debug, Default)]
pub(super) struct WrongPictures {
    made: Memo<Key, (Arc<ComparedCamera>, Option<Arc<Picture>>)>,
    view: Memo<ViewKey, Shown>,
    last: Option<(Arc<ComparedCamera>, Option<Shown>)>,
    count: u64,
}

/// The right camera, with its selected ray.
pub(super) struct Right<'a> {
    pub(super) camera: &'a Camera,
    pub(super) resolved: &'a ResolvedCamera,
    pub(super) inspection: &'a Inspection,
    pub(super) selection: Selection,
    /// The coarseness of its picture.
    pub(super) subsampling: Subsampling,
}

impl WrongPictures {
    /// Returns the number of wrong pictures made so far.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// Updates the picture if the layout shows it. `right` is `None` if there is a fault.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        right: Option<(Right<'_>, &GoodWorld)>,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) {
        let Some(size) = sizes.wrong else { return };
        if let Some((right, world)) = right {
            self.last = Some(self.compared(&right, world, session, size, sizes, watch));
        }
        // While there is a fault, an older picture must not be shown under another mistake's name.
        self.last.take_if(|(wrong, _)| wrong.mistake != session.mistakes_view.shown());
        if let Some((wrong, shown)) = &self.last {
            derived.wrong = Some(Arc::clone(wrong));
            derived.wrong_view.clone_from(shown);
        }
    }

    fn compared(
        &mut self,
        right: &Right<'_>,
        world: &GoodWorld,
        session: &Session,
        size: [u32; 2],
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) -> (Arc<ComparedCamera>, Option<Shown>) {
        let image = right.resolved.image();
        let raster = right.subsampling.raster(image, size);
        let mode = session.settings.shade;
        let mistake = session.mistakes_view.shown();
        let key = (*right.camera, world.generation, world.palette, raster, mode, mistake);
        let count = &mut self.count;
        let (wrong, picture) = self.made.get(key, |(camera, _, _, raster, mode, mistake)| {
            *count += 1;
            watched(watch, Work::Trace, || {
                let paint = Paint {
                    shade: *mode,
                    color_of: |i: u32| world.colors[i as usize],
                    to_pixel: |[r, g, b]: Rgb| Color32::from_rgb(r, g, b),
                };
                let (wrong, pixels) = ComparedCamera::new(
                    camera,
                    right.resolved,
                    &world.scene,
                    *mistake,
                    raster,
                    paint,
                );
                let picture = |pixels| Picture { raster: raster.clone(), image, pixels };
                (Arc::new(wrong), pixels.map(|pixels| Arc::new(picture(pixels))))
            })
        });
        let Some(picture) = picture else { return (wrong, None) };
        let mut items = session.settings.items;
        // Both belong to the right camera; in this picture they would be elsewhere.
        items.set(Item::UvAxes, false);
        items.set(Item::Hit, false);
        let key = (self.count, right.selection, size, items, sizes.scale, sizes.style);
        let view = self.view.get(key, |_| {
            watched(watch, Work::Overlay, || {
                let camera = (right.resolved, right.inspection);
                shown_beside(&picture, camera, items, size, sizes)
            })
        });
        (wrong, Some(view))
    }
}
