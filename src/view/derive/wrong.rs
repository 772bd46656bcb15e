//! The wrong camera's picture beside the right one.

use std::sync::Arc;

use pinhole_core::{Camera, Paint, Raster, Shade};
use pinhole_lecture::mistakes::{ComparedCamera, ComparedPicture, Mistake};

use super::beside::BesideView;
use super::derived::Inputs;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::picture::GoodPicture;
use super::watch::{Work, watched};
use super::{Derived, Shown, opaque};
use crate::model::overlay_items::Item;
use crate::view::ghost::difference_map;
use crate::view::overlay::Picture;

/// The inputs of a wrong picture: the camera, the objects and colours by number, and the rest.
type Key = (Camera, u64, u64, Raster, Shade, Mistake);

/// The wrong camera, its picture, and the map of the pixels that differ.
type Made = (Arc<ComparedCamera>, Option<[Arc<Picture>; 2]>);

/// A cache of the wrong camera and its picture; the last ones stay while the camera has a fault.
#[derive(Debug, Default)]
pub(super) struct WrongPictures {
    made: Memo<Key, Made>,
    view: BesideView,
    last: Option<(Arc<ComparedCamera>, Option<Shown>)>,
    /// Number of wrong pictures made so far.
    pub(super) count: u64,
}

impl WrongPictures {
    /// Updates the picture if the layout shows it. `good` is `None` if there is a fault.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        good: Option<(&GoodPicture, &GoodWorld)>,
    ) {
        let Some(size) = inputs.sizes.wrong else { return };
        if let Some((good, world)) = good {
            self.last = Some(self.compared(inputs, good, world, size));
        }
        // While there is a fault, an older picture must not be shown under another mistake's name.
        self.last.take_if(|(wrong, _)| wrong.mistake != inputs.session.mistakes_view.shown());
        if let Some((wrong, shown)) = &self.last {
            derived.wrong = Some(Arc::clone(wrong));
            derived.wrong_view.clone_from(shown);
        }
    }

    fn compared(
        &mut self,
        inputs: Inputs<'_>,
        good: &GoodPicture,
        world: &GoodWorld,
        size: [u32; 2],
    ) -> (Arc<ComparedCamera>, Option<Shown>) {
        let Inputs { document, session, watch, .. } = inputs;
        let image = good.resolved.image();
        let raster = good.subsampling.raster(image, size);
        let (mode, mistake) = (session.settings.shade, session.mistakes_view.shown());
        let key = (document.camera, world.generation, world.palette, raster, mode, mistake);
        let count = &mut self.count;
        let (wrong, pictures) = self.made.get(key, |(camera, _, _, raster, mode, mistake)| {
            *count += 1;
            watched(watch, Work::Trace, || {
                let paint = Paint {
                    shade: *mode,
                    color_of: |i: u32| world.colors[i as usize],
                    to_pixel: opaque,
                };
                let (wrong, compared) = ComparedCamera::new(
                    camera,
                    &good.resolved,
                    &world.scene,
                    *mistake,
                    raster,
                    paint,
                );
                let picture = |pixels| Arc::new(Picture { raster: raster.clone(), image, pixels });
                let pictures = compared.map(|ComparedPicture { pixels, wrong, right }| {
                    [picture(pixels), picture(difference_map(&wrong, &right))]
                });
                (Arc::new(wrong), pictures)
            })
        });
        // Both belong to the right camera; in this picture they would be elsewhere.
        let items = session.settings.items.with(Item::UvAxes, false).with(Item::Hit, false);
        let differences = session.mistakes_view.shows_differences();
        let number = ((self.count, differences), size);
        let camera = (&good.resolved, &*good.inspection, good.selection);
        let picture = || Some(&*pictures.as_ref()?[usize::from(differences)]);
        let view = self.view.get(inputs, number, camera, items, picture);
        (wrong, view)
    }
}
