//! The wrong camera's picture beside the right one.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::{Camera, Paint, PosedCamera, Raster, Rgb, Shade};
use pinhole_lecture::mistakes::{ComparedCamera, Mistake};

use super::beside::shown_beside;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::watch::{Watch, Work, watched};
use super::{Derived, Shown, ViewSizes};
use crate::coarseness::Coarseness;
use crate::inspection::Inspection;
use crate::overlay::{Item, OverlayItems, Picture, Style};
use crate::session::{Selection, Session};

/// What a wrong picture is made of: the camera, the objects and colours by number, and the rest.
type Key = (Camera, u64, u64, Raster, Shade, Mistake);

/// What is drawn over it.
type ViewKey = (u64, Selection, [u32; 2], OverlayItems, f32, Style);

/// Remembers the wrong camera and its picture; the last ones stay while the camera has a fault.
#[derive(Debug, Default)]
pub(super) struct WrongPictures {
    made: Memo<Key, (Arc<ComparedCamera>, Option<Arc<Picture>>)>,
    view: Memo<ViewKey, Shown>,
    last: Option<(Arc<ComparedCamera>, Option<Shown>)>,
    count: u64,
}

/// What the right camera saw.
pub(super) struct Right<'a> {
    pub(super) camera: &'a Camera,
    pub(super) posed: &'a PosedCamera,
    pub(super) inspection: &'a Inspection,
    pub(super) selection: Selection,
    /// How much coarser its picture is than it could be.
    pub(super) coarseness: Coarseness,
}

impl WrongPictures {
    /// How many wrong pictures were made so far.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// Makes what is new, if the layout shows it. `right` is `None` where there is a fault.
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
            self.last = Some(self.of(&right, world, session, size, sizes, watch));
        }
        // An older picture, while there is a fault, must not stand under another mistake's name.
        self.last.take_if(|(wrong, _)| wrong.mistake != session.gallery.shown());
        if let Some((wrong, shown)) = &self.last {
            derived.wrong = Some(Arc::clone(wrong));
            derived.wrong_view.clone_from(shown);
        }
    }

    fn of(
        &mut self,
        right: &Right<'_>,
        world: &GoodWorld,
        session: &Session,
        size: [u32; 2],
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) -> (Arc<ComparedCamera>, Option<Shown>) {
        let image = right.posed.image();
        let raster = right.coarseness.raster(image, size);
        let mode = Shade::from(session.settings.shade);
        let mistake = session.gallery.shown();
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
                let (wrong, pixels) =
                    ComparedCamera::new(camera, right.posed, &world.scene, *mistake, raster, paint);
                let picture = |pixels| Picture { raster: raster.clone(), image, pixels };
                (Arc::new(wrong), pixels.map(|pixels| Arc::new(picture(pixels))))
            })
        });
        let Some(picture) = picture else { return (wrong, None) };
        let mut items = session.settings.items;
        // They are the right camera's, and this picture is about their being elsewhere.
        items.set(Item::UvAxes, false);
        items.set(Item::Hit, false);
        let key = (self.count, right.selection, size, items, sizes.scale, sizes.style);
        let view = self.view.get(key, |_| {
            watched(watch, Work::Overlay, || {
                let camera = (right.posed, right.inspection);
                shown_beside(&picture, camera, items, size, sizes)
            })
        });
        (wrong, Some(view))
    }
}
