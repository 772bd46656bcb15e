//! The window's panels, with one `ui` function per file. Each function edits its arguments in place, and
//! requests [actions](super::action) for everything else.

pub(crate) mod camera;
pub(crate) mod objects;
mod teaching;
pub(crate) mod top_bar;

use egui::text::{LayoutJob, TextWrapping};
use egui::{Button, CollapsingHeader, FontId, Response, RichText, TextStyle, Ui, pos2, vec2};

use crate::model::lessons::{StepId, Which};
use crate::model::session::ViewLayout;
use crate::ui::action::{Leave, LookAction};
use crate::ui::widgets::{ResponseExt as _, text_width};

/// Size of a section's heading, in points.
const HEADING: f32 = 16.0;

/// Shows a section below a heading. A click on the heading folds or unfolds the section. While it is folded,
/// its heading also shows the values in it. Returns the heading.
pub(crate) fn section(
    ui: &mut Ui,
    title: &str,
    values: &str,
    is_open: &mut bool,
    content: impl FnOnce(&mut Ui),
) -> Response {
    let font = FontId::proportional(HEADING);
    let text = RichText::new(title).size(HEADING);
    let shown = CollapsingHeader::new(text).open(Some(*is_open)).show_unindented(ui, content);
    let header = shown.header_response;
    if !*is_open {
        let left = header.rect.left() + ui.spacing().indent + text_width(ui, title, font) + 8.0;
        let font = TextStyle::Body.resolve(ui.style());
        let color = ui.visuals().weak_text_color();
        let mut job = LayoutJob::simple_singleline(values.to_owned(), font, color);
        let right = ui.max_rect().right();
        job.wrap = TextWrapping::truncate_at_width((right - left).max(0.0));
        let galley = ui.painter().layout_job(job);
        let size = galley.size();
        let at = pos2(right - size.x, header.rect.center().y - 0.5 * size.y);
        ui.painter().galley(at, galley, color);
    }
    if header.clicked() {
        *is_open = !*is_open;
    }
    header.described(if *is_open { "" } else { values })
}

/// Shows the buttons that start something.
pub(crate) fn start_buttons(ui: &mut Ui) {
    let lecture = StepId { lesson: Which::Builtin(0), step: 0 };
    let (fill, text) = (ui.visuals().selection.stroke.color, ui.visuals().panel_fill);
    let lead = Button::new(RichText::new("Start the lecture").color(text)).fill(fill);
    let width = ui.available_width();
    ui.add_sized(vec2(width, 30.0), lead).asks(Leave::GoTo(lecture));
    ui.horizontal(|ui| {
        let half = vec2(0.5 * (width - ui.spacing().item_spacing.x), 24.0);
        let practise = LookAction::Layout(ViewLayout::Exercises);
        ui.add_sized(half, Button::new("Practise")).asks(practise);
        ui.add_sized(half, Button::new("Present")).asks(LookAction::Present);
    });
}
