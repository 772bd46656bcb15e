//! A picture beside the camera's own: of the same image, with what belongs to the image drawn over it.

use pinhole_core::ResolvedCamera;

use super::{Shown, ViewSizes, blank};
use crate::inspection::Inspection;
use crate::overlay::{self, CameraView, OverlayItems, Picture};

/// Shows a picture in so many dots, with the items of the camera that it belongs to.
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
        lit: None,
        loupe: None,
    };
    let mut pixels = blank(size);
    let drawing = overlay::camera(&view, &mut pixels);
    sizes.style.finish(&mut pixels);
    Shown::new(size, pixels, drawing)
}
