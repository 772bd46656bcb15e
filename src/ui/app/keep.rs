//! The observer that a scene keeps: the one with which it opens.

use super::App;
use crate::ui::action::KeepAction;
use crate::ui::dialogs::Dialog;

impl App {
    /// Keeps the observer in the scene, or forgets the kept one. Returns a message if that is impossible.
    pub(super) fn keep(&mut self, action: KeepAction) -> Option<Dialog> {
        let stored = match action {
            KeepAction::Nowhere => None,
            KeepAction::InScene if self.question.is_some() => {
                let problem = "An exercise has a scene of its own: close it first.";
                return Some(Dialog::message("This view was not kept", problem));
            }
            KeepAction::InScene => Some(self.scene.session.observer?.stored()),
        };
        self.scene.open.document.observer = stored;
        let title = match stored {
            Some(_) => "The scene opens with this view once it is saved",
            None => "The scene opens with everything in view once it is saved",
        };
        self.say(title.to_owned(), Vec::new());
        None
    }
}
