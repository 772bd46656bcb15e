//! The camera view, and the error map beside it.

use std::sync::Arc;

use egui::Color32;
use pinhole_core::methods::Method;
use pinhole_core::{ResolvedCamera, Selection};

use super::buffers::Buffers;
use super::derived::{Derived, Inputs, Purpose, Shown};
use super::memo::Memo;
use super::picture::GoodPicture;
use super::watch::{Work, watched};
use super::{HighlightKey, blank, highlight_key};
use crate::model::overlay_items::OverlayItems;
use crate::view::accuracy;
use crate::view::overlay::{self, CameraView, Highlighted, Loupe, Picture, Style};

/// Caches of both views.
#[derive(Debug, Default)]
pub(super) struct CameraViews {
    camera: Memo<Key, Shown>,
    error_map: Memo<(Method, Key), Shown>,
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
    /// Returns the camera view and the error map, as far as they are shown, of the `number`th good
    /// picture.
    pub(super) fn get(
        &mut self,
        derived: &Derived,
        inputs: Inputs<'_>,
        (good, number): (&GoodPicture, u64),
    ) -> [Option<Shown>; 2] {
        let Inputs { document, session, sizes, watch } = inputs;
        // A highlighted concept belongs to the current document; an older picture does not show it.
        let highlighted = highlight_key(session).filter(|_| derived.fault.is_none());
        let scene = derived.scene.as_deref();
        let key = |size: [u32; 2]| Key {
            picture: number,
            scanned_pixels: session.scanned_pixels,
            resolved: good.resolved,
            size,
            selection: good.selection,
            items: session.settings.items,
            highlighted,
            loupe: good.loupe.clone(),
            scale: sizes.scale,
            style: sizes.style,
            purpose: sizes.purpose,
        };
        let draw = |picture: &Picture, key: &Key, pixels: &mut [Color32]| {
            let view = CameraView {
                picture,
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
            match key.purpose {
                Purpose::Window => overlay::camera(&view, pixels),
                Purpose::Figure { .. } => overlay::camera_apart(&view, pixels),
            }
        };
        let buffers = &mut self.buffers;
        let camera = sizes.camera.map(|size| {
            self.camera.get(key(size), |key| {
                watched(watch, Work::Overlay, || {
                    let mut pixels = buffers.take(size);
                    let drawing = draw(&good.picture, key, &mut pixels);
                    key.style.finish(&mut pixels);
                    buffers.shown(size, pixels, drawing)
                })
            })
        });
        let error_map = good.map.as_ref().zip(sizes.map).map(|((compared, map), size)| {
            self.error_map.get((compared.method, Key { loupe: None, ..key(size) }), |(_, key)| {
                let mut pixels = blank(size);
                let drawing = draw(map, key, &mut pixels);
                let (comparison, width) = (&compared.comparison, size[0] as usize);
                accuracy::mark_wrong(comparison, &map.raster, width, key.scale, &mut pixels);
                key.style.finish(&mut pixels);
                Shown::new(size, pixels, drawing)
            })
        });
        [camera, error_map]
    }
}
