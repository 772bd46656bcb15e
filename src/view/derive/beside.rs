//! A picture beside the camera's own, of the same image and with the image's overlay items.

use pinhole_core::ResolvedCamera;

use super::{Shown, ViewSizes, blank};
use crate::model::inspection::Inspection;
use crate::model::overlay_items::OverlayItems;
use crate::view::overlay;
use crate::view::overlay::{CameraView, Picture};

/// Shows a picture in `size` dots, with the overlay items of the camera it belongs to.
pub(super) fn shown_beside(
    picture: &Picture,
    (resolved, inspection): (&ResolvedCamera, &Inspection),
    items: OverlayItems,
    size: [u32; 2],
    sizes: &ViewSizes,
) -> Shown {
    let view = CameraView {
        picture,
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
    Shown::new(size, pixels, drawing)
}
