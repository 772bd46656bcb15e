//! Taking the camera and the scene in the hand, before anything is drawn.

use egui::{Context, Id, Rect, Ui};

use super::scene::OpenScene;
use crate::ui::scene::handles::{Edited, HandInput};
use crate::ui::scene::navigation::Navigation;
use crate::ui::scene::view_rects::ViewRects;
use crate::ui::scene::views;
use crate::view::derive::Derived;

/// Handles in the world view, and the camera view's navigation.
#[derive(Default)]
pub(super) struct InHand {
    handles: HandInput,
    pub(super) navigation: Navigation,
}

impl InHand {
    /// Takes what mouse and keys do to handles, and in the camera view; nothing where something lies
    /// over the window.
    pub(super) fn take(
        &mut self,
        ctx: &Context,
        scene: &mut OpenScene,
        shown: &Derived,
        is_covered: bool,
    ) {
        let OpenScene { open, session, chosen_object, .. } = scene;
        if is_covered {
            session.hand.is_busy = false;
            self.handles.let_go(session);
            self.navigation.let_go();
            return;
        }
        let mut edited = Edited { document: &mut open.document, session, chosen_object };
        self.handles.take(ctx, &mut edited, shown);
        self.navigation.take(ctx, &mut edited);
    }

    /// Tells what there is to say of that; takes note of where the views are now.
    pub(super) fn tell(&mut self, ui: &Ui, rects: &ViewRects, scene: &OpenScene, shown: &Derived) {
        let view = |rect: Option<Rect>, name: &str| -> Option<(Rect, Id)> {
            Some((rect?, ui.scope_id().with(name)))
        };
        let (document, session) = (&scene.open.document, &scene.session);
        self.handles.tell(ui, view(rects.world, views::WORLD), shown, document, session);
        let camera = view(rects.camera, views::CAMERA);
        self.navigation.tell(ui, camera, &document.camera, session);
    }
}
