//! The window's panels, with one `ui` function per file. Each function edits its arguments in place, and
//! requests [actions](super::action) for everything else.

pub(crate) mod camera;
pub(crate) mod objects;
pub(crate) mod play;
mod teaching;
pub(crate) mod top_bar;

use egui::{CollapsingHeader, RichText, Ui};

/// Shows a section below a heading. A click on the heading folds or unfolds the section.
pub(crate) fn section(ui: &mut Ui, title: &str, is_open: &mut bool, content: impl FnOnce(&mut Ui)) {
    let size = egui::TextStyle::Heading.resolve(ui.style()).size;
    let title = RichText::new(title).size(size);
    let response = CollapsingHeader::new(title).open(Some(*is_open)).show_unindented(ui, content);
    if response.header_response.clicked() {
        *is_open = !*is_open;
    }
}
