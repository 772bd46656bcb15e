//! The names, values and descriptions of widgets, for screen readers and tests, and the arrow keys that a focused
//! widget keeps.

use egui::accesskit::Role;
use egui::{EventFilter, Response};

/// Accessible name, value, description and role of a widget.
pub(crate) trait Spoken: Sized {
    /// Sets the name.
    fn named(self, name: impl Into<String>) -> Self;

    /// Sets the value: of a text, what is read in its place.
    fn spoken(self, value: impl Into<String>) -> Self;

    /// Sets the description: what a picture shows, or where a handle is. Of those, screen readers get no
    /// value but a number (AT-SPI).
    fn described(self, text: impl Into<String>) -> Self;

    /// Sets the kind of widget.
    fn with_role(self, role: Role) -> Self;
}

impl Spoken for Response {
    fn named(self, name: impl Into<String>) -> Self {
        self.ctx.accesskit_node_builder(self.id, |node| node.set_label(name.into()));
        self
    }

    fn spoken(self, value: impl Into<String>) -> Self {
        self.ctx.accesskit_node_builder(self.id, |node| node.set_value(value.into()));
        self
    }

    fn described(self, text: impl Into<String>) -> Self {
        self.ctx.accesskit_node_builder(self.id, |node| node.set_description(text.into()));
        self
    }

    fn with_role(self, role: Role) -> Self {
        self.ctx.accesskit_node_builder(self.id, |node| node.set_role(role));
        self
    }
}

/// Keeps arrow keys from moving the focus away from a widget.
pub(crate) fn keep_arrows(response: &Response, horizontal: bool, vertical: bool) {
    let arrows = EventFilter {
        horizontal_arrows: horizontal,
        vertical_arrows: vertical,
        ..EventFilter::default()
    };
    response.ctx.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
}
