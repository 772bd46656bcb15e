//! Pictures beside the camera's own, of the same image and with the image's overlay items.

use std::borrow::Borrow;

use pinhole_core::{ResolvedCamera, Selection};

use super::derived::Inputs;
use super::memo::Memo;
use super::watch::{Work, watched};
use super::{Shown, blank};
use crate::model::inspection::Inspection;
use crate::model::overlay_items::OverlayItems;
use crate::view::overlay::{self, CameraView, Picture, Style};

/// The inputs of a view: the picture by number, the ray, the size, and the overlay.
type Key = ((u64, bool), Selection, [u32; 2], OverlayItems, f32, Style);

/// A cache of the view of a picture.
#[derive(Debug, Default)]
pub(super) struct BesideView(Memo<Key, Option<Shown>>);

impl BesideView {
    /// Shows a picture in `size` dots, with the overlay items of the camera it belongs to. `number`
    /// distinguishes the picture from the next one.
    pub(super) fn get<P: Borrow<Picture>>(
        &mut self,
        Inputs { sizes, watch, .. }: Inputs<'_>,
        (number, size): ((u64, bool), [u32; 2]),
        (resolved, inspection, selection): (&ResolvedCamera, &Inspection, Selection),
        items: OverlayItems,
        picture: impl FnOnce() -> Option<P>,
    ) -> Option<Shown> {
        let key = (number, selection, size, items, sizes.scale, sizes.style);
        self.0.get(key, |_| {
            watched(watch, Work::Overlay, || {
                let picture = picture()?;
                let view = CameraView {
                    picture: picture.borrow(),
                    resolved,
                    inspection: Some(inspection),
                    items,
                    size: size.map(|n| n as usize),
                    scale: sizes.scale,
                    style: sizes.style,
                    highlighted: None,
                    loupe: None,
                };
                let mut pixels = blank(size);
                let drawing = overlay::camera(&view, &mut pixels);
                sizes.style.finish(&mut pixels);
                Some(Shown::new(size, pixels, drawing))
            })
        })
    }
}
