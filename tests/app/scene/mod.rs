//! The views: handles, labels, what covers what, and the camera beside its ghost.

mod by_keys;
mod compare;
mod composition;
mod covered;
pub(super) mod framing;
mod handles;
mod labels;
mod observing;
pub(super) mod overlaps;
use egui_kittest::Harness;
use pinhole::ui::app::App;
use pinhole_core::{Camera, DVec3, Orientation};

fn camera(harness: &Harness<'_, App>) -> Camera {
    harness.state().document().camera
}

fn at_of(camera: &Camera) -> DVec3 {
    match camera.orientation {
        Orientation::At { at, .. } => at,
        _ => panic!("not given by at: {camera:?}"),
    }
}
