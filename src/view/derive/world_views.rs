//! The world view: the observer's picture with the camera and everything else drawn in it.

use std::sync::Arc;

use pinhole_core::{Camera, Frame, Selection};

use super::buffers::Buffers;
use super::derived::{Derived, Inputs, Purpose, Shown};
use super::memo::{Memo, Same};
use super::objects::Objects;
use super::picture::GoodPicture;
use super::watch::{Work, watched};
use super::world::{WorldPicture, WorldPictures};
use super::{HighlightKey, answer_marks, highlight_key};
use crate::model::observer::Observer;
use crate::model::overlay_items::OverlayItems;
use crate::model::practice::answer_marks::AnswerMark;
use crate::view::adaptive_resolution::Subsampling;
use crate::view::handles::{self, Stage};
use crate::view::overlay::{
    self, Backdrop, Below, GhostCamera, Handles, Highlighted, Style, WorldView,
};

/// Caches of the world view and of the pictures it is drawn over.
#[derive(Debug, Default)]
pub(super) struct WorldViews {
    pub(super) pictures: WorldPictures,
    view: Memo<Key, Shown>,
    buffers: Buffers,
}

/// The world view, with what it was drawn from.
pub(super) struct SeenWorld {
    pub(super) frame: Arc<Frame<f32>>,
    pub(super) subsampling: Subsampling,
    pub(super) view: Shown,
}

#[derive(Debug, PartialEq)]
struct Key {
    world: Same<WorldPicture>,
    camera: Camera,
    observer: Observer,
    size: [u32; 2],
    picture: Option<u64>,
    scanned_pixels: Option<u64>,
    selection: Selection,
    items: OverlayItems,
    highlighted: Option<HighlightKey>,
    ray_point_t: Option<f64>,
    handles: Handles,
    ghost: Option<GhostCamera>,
    answer_marks: Arc<[AnswerMark]>,
    scale: f32,
    style: Style,
    purpose: Purpose,
    names_all: bool,
}

impl WorldViews {
    /// Returns the world view with the `number`th good picture on its viewport; `None` where it is
    /// not shown.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        objects: &mut Objects,
        last_good: Option<(&GoodPicture, u64)>,
    ) -> Option<SeenWorld> {
        let Inputs { document, session, sizes, watch } = inputs;
        let (size, observer, good) = (sizes.world?, session.observer?, objects.good()?.clone());
        let observer_camera = observer.camera(size[0], size[1]).resolve().ok()?;
        let color_of = |i: u32| good.colors.get(i as usize).copied().unwrap_or_default();
        let WorldViews { pictures, view, buffers } = self;
        let world = pictures.get(inputs, objects, observer_camera)?;
        let seen = last_good.filter(|_| derived.fault.is_none());
        let stage = Stage {
            document,
            resolved: derived.resolved.as_ref(),
            selection: session.shown_selection(),
            items: session.settings.items,
            observer: world.frame.camera(),
            scale: sizes.scale,
        };
        let key = Key {
            world: Same(Arc::clone(&world)),
            camera: document.camera,
            observer,
            size,
            picture: seen.map(|(_, number)| number),
            scanned_pixels: session.scanned_pixels,
            selection: session.shown_selection(),
            items: session.settings.items,
            highlighted: highlight_key(session),
            ray_point_t: session.ray_point_t,
            handles: handles::drawn(&stage, &session.handles, &session.spoken_of()),
            ghost: answer_marks::ghost(inputs, derived),
            answer_marks: Arc::clone(&derived.answer_marks),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
            names_all: session.spoken.is_some() || sizes.purpose != Purpose::Window,
        };
        let (resolved, inspection) = (derived.resolved, derived.inspection.as_deref());
        let view = view.get(key, |key| {
            let view = WorldView {
                camera: &document.camera,
                resolved: resolved.as_ref(),
                picture: seen.map(|(seen, _)| &*seen.picture),
                inspection,
                scene: &good.scene,
                enclosing: &world.enclosing,
                color_of: &color_of,
                observer: &observer,
                frame: &world.frame,
                items: key.items,
                scale: key.scale,
                style: key.style,
                highlighted: key.highlighted.map(|(concept, digits, dims)| Highlighted {
                    concept,
                    camera: &document.camera,
                    scene: &good.scene,
                    digits,
                    dims,
                }),
                ray_point_t: key.ray_point_t,
                handles: &key.handles,
                ghost: key.ghost.as_ref(),
                answer_marks: &key.answer_marks,
                is_clear: key.purpose.is_clear(),
                names_all: key.names_all,
            };
            let backdrop = Backdrop::new(&view);
            let painted = pictures.painted(&world, &backdrop, watch);
            watched(watch, Work::Overlay, || {
                let mut pixels = buffers.take(size);
                let below = Below { traced: &world.pixels, painted: &painted };
                let draw = match key.purpose {
                    Purpose::Window => overlay::world,
                    Purpose::Figure { .. } => overlay::world_apart,
                };
                let drawing = draw(&view, &backdrop, below, &mut pixels);
                key.style.finish(&mut pixels);
                buffers.shown(size, pixels, drawing)
            })
        });
        Some(SeenWorld { frame: Arc::clone(&world.frame), subsampling: world.subsampling, view })
    }
}
