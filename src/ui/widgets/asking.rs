//! Buttons that ask for an action.

use egui::Response;

use crate::ui::action::Action;

/// A widget that asks for an action.
pub(crate) trait Asking {
    /// Adds the action if the widget was clicked.
    fn asks(self, action: impl Into<Action>, actions: &mut Vec<Action>);
}

impl Asking for Response {
    fn asks(self, action: impl Into<Action>, actions: &mut Vec<Action>) {
        actions.extend(self.clicked().then(|| action.into()));
    }
}
