//! The ghost's picture beside the camera's.

use std::sync::Arc;

use pinhole_core::{Camera, Outputs, Raster, ResolvedCamera, Selection, Shade};

use super::Derived;
use super::beside::BesideView;
use super::derived::Inputs;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::watch::picture;
use crate::model::overlay_items::Item;
use crate::model::session::ghost::{Beside, Ghost, resolve};
use crate::view::ghost::{AgainstGhost, difference_map};
use crate::view::overlay::Picture;

/// The inputs of a comparison: both cameras, the objects and colours by number, the pixels, and the
/// ray.
type Key = (Camera, Camera, u64, u64, Raster, Shade, Selection);

/// The camera compared with the ghost, the ghost's picture, and the map of differences.
type Made = Option<(Arc<AgainstGhost>, [Arc<Picture>; 2])>;

/// A cache of the ghost's picture.
#[derive(Debug, Default)]
pub(super) struct GhostPictures {
    made: Memo<Key, Made>,
    view: BesideView,
    /// Number of times the ghost's picture was traced.
    pub(super) count: u64,
}

impl GhostPictures {
    /// Compares the cameras, if the layout shows it and there are two.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        inputs: Inputs<'_>,
        world: Option<&GoodWorld>,
    ) {
        let Inputs { document, session, sizes, .. } = inputs;
        let ghost = session.ghost.as_ref();
        derived.ghost = ghost.and_then(|ghost| resolve(&ghost.camera, &document.camera).ok());
        let (Some(ghost), Some(size), Some(now), Some(seen), Some(world)) =
            (ghost, sizes.ghost, &derived.resolved, derived.ghost, world)
        else {
            return;
        };
        let raster = derived.subsampling[0].raster(now.image(), size);
        let made = self.compared(inputs, now, (ghost, &seen), world, raster);
        let Some((against, pictures)) = made else { return };
        let shows_differences = ghost.beside == Beside::Differences;
        let items = session.settings.items;
        let items = items.with(Item::Hit, items.shows(Item::Hit) && !shows_differences);
        derived.ghost_view = self.view.get(
            inputs,
            ((self.count, shows_differences), size),
            (&against.ghost, &against.inspection, session.selection),
            items,
            || Some(&*pictures[usize::from(shows_differences)]),
        );
        derived.against_ghost = Some(against);
    }

    fn compared(
        &mut self,
        Inputs { document, session, watch, .. }: Inputs<'_>,
        now: &ResolvedCamera,
        (ghost, seen): (&Ghost, &ResolvedCamera),
        world: &GoodWorld,
        raster: Raster,
    ) -> Made {
        let (camera, mode) = (document.camera, session.settings.shade);
        let (generation, palette) = (world.generation, world.palette);
        let key = (camera, ghost.camera, generation, palette, raster, mode, session.selection);
        let count = &mut self.count;
        self.made.get(key, |(camera, then, _, _, raster, mode, selection)| {
            *count += 1;
            let colors = (*mode, |i: u32| world.colors[i as usize]);
            let outputs = Outputs { object: true, ..Outputs::NONE };
            let trace =
                |camera| picture(&world.scene, camera, raster, outputs, colors, (None, watch));
            let ((now_frame, _), (frame, pixels)) = (trace(now), trace(seen));
            let then = (then, seen, &frame);
            let against =
                AgainstGhost::new((camera, &now_frame), then, &world.scene, *selection).ok()?;
            let map = difference_map(&now_frame.object, &frame.object);
            let picture =
                |pixels| Arc::new(Picture { raster: raster.clone(), image: now.image(), pixels });
            Some((Arc::new(against), [picture(pixels), picture(map)]))
        })
    }
}
