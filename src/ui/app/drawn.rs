//! What a pass began to draw, to tell at its end whether anything on the screen is older than the rest.

use pinhole_core::Camera;
use pinhole_exchange::document::Document;

use super::scene::OpenScene;
use crate::model::session::Session;

/// The document and the session as the panels of a pass began to draw them.
pub(super) struct Drawn {
    document: Document,
    session: Session,
    marks: [bool; 2],
}

impl OpenScene {
    /// Returns what the panels are about to draw.
    pub(super) fn drawn(&self) -> Drawn {
        Drawn {
            document: self.open.document.clone(),
            session: self.session.clone(),
            marks: self.marks(),
        }
    }

    /// Returns true if something that was `drawn` has changed since in a way that is seen above the
    /// views: the pass runs again before anything is presented.
    pub(super) fn is_newer_than(&self, drawn: Drawn) -> bool {
        let (before, now) = (&drawn.document, &self.open.document);
        // The views take these in before they are derived, and nothing else shows them.
        let session = Session {
            observer: self.session.observer,
            pointed_ray: self.session.pointed_ray,
            hovered: self.session.hovered,
            alt_dims: self.session.alt_dims,
            handles: self.session.handles.clone(),
            pen: self.session.pen.clone(),
            ..drawn.session
        };
        !is_same_but_for_pose(&before.camera, &now.camera)
            || before.spheres != now.spheres
            || before.planes != now.planes
            || drawn.marks != self.marks()
            || session != self.session
    }
}

/// Returns true if the cameras differ in eye and orientation alone, which only their own fields and the
/// views show.
fn is_same_but_for_pose(before: &Camera, now: &Camera) -> bool {
    let moved = Camera { eye: now.eye, orientation: now.orientation, ..*before };
    let is_same_kind = before.orientation.kind() == now.orientation.kind();
    let can_see = || before.resolve().is_ok() && now.resolve().is_ok();
    before == now || (moved == *now && is_same_kind && can_see())
}
