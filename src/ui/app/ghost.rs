//! The ghost: freezing the camera, dropping the ghost, and changing places with it.

use egui::Context;

use super::App;
use crate::model::ghost::{Beside, Ghost};
use crate::ui::action::GhostAction;

/// What the step of the history is called that puts the camera where the ghost is.
const SWAP: &str = "swap with the ghost";

impl App {
    /// Does what a menu or a key asks for.
    pub(super) fn move_ghost(&mut self, ctx: &Context, ghost: GhostAction) {
        let camera = self.open.document.camera;
        match ghost {
            GhostAction::Freeze => {
                let beside = self.session.ghost.map_or(Beside::default(), |ghost| ghost.beside);
                self.session.ghost = Some(Ghost { camera, beside });
            }
            GhostAction::Drop => self.session.ghost = None,
            GhostAction::Swap => {
                let Some(ghost) = &mut self.session.ghost else { return };
                self.open.document.camera = std::mem::replace(&mut ghost.camera, camera);
                let selection = self.session.selection;
                let image = self.open.document.camera.image;
                self.session.selection = selection.in_another_image(camera.image, image);
                self.settle_as(ctx, Some(SWAP));
            }
        }
        ctx.request_repaint();
    }
}
