//! The ghost's picture beside the camera's.

use std::sync::Arc;

use pinhole_core::{Camera, Outputs, Raster, ResolvedCamera, Shade};
use pinhole_exchange::document::Document;

use super::beside::shown_beside;
use super::memo::Memo;
use super::objects::GoodWorld;
use super::watch::{Watch, Work, picture, watched};
use super::{Derived, Shown, ViewSizes};
use crate::model::overlay_items::{Item, OverlayItems};
use crate::model::session::ghost::{Beside, Ghost, resolve};
use crate::model::session::{Selection, Session};
use crate::view::ghost::{AgainstGhost, difference_map};
use crate::view::overlay::{Picture, Style};

/// The inputs of a comparison: both cameras, the objects and colours by number, the pixels, and the
/// ray.
type Key = (Camera, Camera, u64, u64, Raster, Shade, Selection);

/// The inputs of the overlay on it.
type ViewKey = (u64, Beside, Selection, [u32; 2], OverlayItems, f32, Style);

/// The camera compared with the ghost, the ghost's picture, and the map of differences.
type Made = Option<(Arc<AgainstGhost>, [Arc<Picture>; 2])>;

/// A cache of the ghost's picture.
#[derive(Debug, Default)]
pub(super) struct GhostPictures {
    made: Memo<Key, Made>,
    view: Memo<ViewKey, Shown>,
    count: u64,
}

impl GhostPictures {
    /// Returns how many times the ghost's picture was traced so far.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// Compares the cameras, if the layout shows it and there are two.
    pub(super) fn update(
        &mut self,
        derived: &mut Derived,
        document: &Document,
        world: Option<&GoodWorld>,
        session: &Session,
        sizes: &ViewSizes,
        watch: Watch<'_>,
    ) {
        let ghost = session.ghost.as_ref();
        derived.ghost = ghost.and_then(|ghost| resolve(&ghost.camera, &document.camera).ok());
        let (Some(ghost), Some(size), Some(now), Some(seen), Some(world)) =
            (ghost, sizes.ghost, &derived.resolved, derived.ghost, world)
        else {
            return;
        };
        let raster = derived.subsampling[0].raster(now.image(), size);
        let made =
            self.compared((&document.camera, now), (ghost, &seen), world, session, raster, watch);
        let Some((against, pictures)) = made else { return };
        let view = self.shown(&against, &pictures, ghost, session, (size, sizes), watch);
        (derived.against_ghost, derived.ghost_view) = (Some(against), Some(view));
    }

    fn compared(
        &mut self,
        (camera, now): (&Camera, &ResolvedCamera),
        (ghost, seen): (&Ghost, &ResolvedCamera),
        world: &GoodWorld,
        session: &Session,
        raster: Raster,
        watch: Watch<'_>,
    ) -> Made {
        let mode = session.settings.shade;
        let (generation, palette) = (world.generation, world.palette);
        let key = (*camera, ghost.camera, generation, palette, raster, mode, session.selection);
        let count = &mut self.count;
        self.made.get(key, |(camera, then, _, _, raster, mode, selection)| {
            *count += 1;
            let colors = (*mode, |i: u32| world.colors[i as usize]);
            let outputs = Outputs { object: true, ..Outputs::NONE };
            let trace = |camera| picture(&world.scene, camera, raster, outputs, colors, watch);
            let ((now_frame, _), (frame, pixels)) = (trace(now), trace(seen));
            let then = (then, seen, &frame);
            let against =
                AgainstGhost::new((camera, &now_frame), then, &world.scene, *selection).ok()?;
            let map = difference_map(&now_frame, &frame);
            let picture =
                |pixels| Arc::new(Picture { raster: raster.clone(), image: now.image(), pixels });
            Some((Arc::new(against), [picture(pixels), picture(map)]))
        })
    }

    fn shown(
        &mut self,
        against: &AgainstGhost,
        pictures: &[Arc<Picture>; 2],
        ghost: &Ghost,
        session: &Session,
        (size, sizes): ([u32; 2], &ViewSizes),
        watch: Watch<'_>,
    ) -> Shown {
        let mut items = session.settings.items;
        items.set(Item::Hit, items.shows(Item::Hit) && ghost.beside == Beside::Picture);
        let (scale, style) = (sizes.scale, sizes.style);
        let key = (self.count, ghost.beside, session.selection, size, items, scale, style);
        self.view.get(key, |_| {
            watched(watch, Work::Overlay, || {
                let picture = &pictures[usize::from(ghost.beside == Beside::Differences)];
                let camera = (&against.ghost, &against.inspection);
                shown_beside(picture, camera, items, size, sizes)
            })
        })
    }
}
