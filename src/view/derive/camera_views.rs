//! The camera view.

use std::sync::Arc;

use pinhole_core::{ResolvedCamera, Selection};

use super::buffers::Buffers;
use super::derived::{Derived, Inputs, Purpose, Shown};
use super::memo::Memo;
use super::picture::GoodPicture;
use super::watch::{Work, watched};
use super::{HighlightKey, highlight_key};
use crate::model::overlay_items::OverlayItems;
use crate::view::overlay::{self, CameraView, Highlighted, Loupe, Style};

/// A cache of the camera view.
#[derive(Debug, Default)]
pub(super) struct CameraViews {
    view: Memo<Key, Shown>,
    buffers: Buffers,
}

#[derive(Debug, PartialEq)]
struct Key {
    picture: u64,
    scanned_pixels: Option<u64>,
    resolved: ResolvedCamera,
    size: [u32; 2],
    selection: Selection,
    items: OverlayItems,
    highlighted: Option<HighlightKey>,
    loupe: Option<Arc<Loupe>>,
    scale: f32,
    style: Style,
    purpose: Purpose,
}

impl CameraViews {
    /// Returns the camera view, if it is shown, of the `number`th good picture.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        (good, number): (&GoodPicture, u64),
    ) -> Option<Shown> {
        let Inputs { document, session, sizes, watch } = inputs;
        let size = sizes.camera?;
        let key = Key {
            picture: number,
            scanned_pixels: session.scanned_pixels,
            resolved: good.resolved,
            size,
            selection: good.selection,
            items: session.settings.items,
            // A highlighted concept belongs to the current document; an older picture does not show
            // it.
            highlighted: highlight_key(session).filter(|_| derived.fault.is_none()),
            loupe: good.loupe.clone(),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
        };
        let (scene, buffers) = (derived.scene.as_deref(), &mut self.buffers);
        let mut draw = |key: &Key| {
            let view = CameraView {
                picture: &good.picture,
                resolved: &good.resolved,
                inspection: Some(&good.inspection),
                items: key.items,
                size: key.size.map(|n| n as usize),
                scale: key.scale,
                style: key.style,
                highlighted: scene.zip(key.highlighted).map(|(scene, (concept, digits, dims))| {
                    Highlighted { concept, camera: &document.camera, scene, digits, dims }
                }),
                loupe: key.loupe.as_deref(),
            };
            let mut pixels = buffers.take(size);
            let drawing = match key.purpose {
                Purpose::Window => overlay::camera(&view, &mut pixels),
                Purpose::Figure { .. } => overlay::camera_apart(&view, &mut pixels),
            };
            key.style.finish(&mut pixels);
            buffers.shown(size, pixels, drawing)
        };
        Some(self.view.get(key, |key| watched(watch, Work::Overlay, || draw(key))))
    }
}
