//! The Help menu's contents: the list of all keys, the lecture's conventions, and the text about the program.

use egui::{Align, Context, Id, Key, Layout, Modal, Modifiers, RichText, ScrollArea, Ui, vec2};
use pinhole_figure::typesetting::theme::WRITTEN;

use crate::ui::commands_table::{Group, sheet};
use crate::ui::dialogs::Dialog;
use crate::ui::widgets::{cell, column_of};

/// Minimum and maximum size of the text, in points; the largest size at which the text fits is used.
const TEXT: (f32, f32) = (WRITTEN + 0.5, 21.0);
/// Width of a column, relative to the text's size.
const COLUMN: f32 = 21.0;
/// Height of a row, relative to the text's size.
const ROW: f32 = 1.64;
/// Fraction of a column's width for the keys.
const KEYS: f32 = 0.44;
/// Margin between the list and the window's edge, in points.
const EDGE: f32 = 16.0;
/// Height of the heading, in points.
const HEAD: f32 = 46.0;

/// A group with the keys and names of its entries.
type Entries = (Group, Vec<(String, String)>);

/// Shows the list of keys. Returns true if it stays open.
pub(crate) fn ui(ctx: &Context) -> bool {
    let keys = [Key::Questionmark, Key::F1];
    let again = keys.iter().any(|key| ctx.input_mut(|i| i.consume_key(Modifiers::NONE, *key)));
    let mut is_open = !again;
    let response = Modal::new(Id::unique("keys")).show(ctx, |ui| {
        let size = ctx.content_rect().size() - vec2(2.0 * EDGE + 12.0, 2.0 * EDGE + 12.0);
        ui.set_min_size(size);
        ui.set_max_size(size);
        let groups = sheet();
        let room = vec2(size.x, size.y - HEAD);
        let (columns, text) = fitting(&groups, room);
        ui.horizontal(|ui| {
            ui.label(RichText::new("Keys").size(text + 6.0).strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let button = ui.button(RichText::new("Close (Escape)").size(text));
                is_open &= !button.clicked();
            });
        });
        ui.separator();
        ScrollArea::vertical().max_height(room.y).auto_shrink(false).show(ui, |ui| {
            scroll(ui, room.y);
            ui.columns(columns, |columns| {
                for (k, entries) in groups.iter().enumerate() {
                    let column = column_of(&heights(&groups), k, columns.len());
                    group(&mut columns[column], entries, text);
                }
            });
        });
    });
    is_open && !response.should_close()
}

/// Scrolls with the arrow and page keys if not everything fits.
fn scroll(ui: &mut Ui, page: f32) {
    let keys = [
        (Key::ArrowDown, -40.0),
        (Key::ArrowUp, 40.0),
        (Key::PageDown, -0.8 * page),
        (Key::PageUp, 0.8 * page),
    ];
    let presses = |key| ui.input(|i| i.num_presses(key)) as f32;
    let by: f32 = keys.into_iter().map(|(key, by)| by * presses(key)).sum();
    if by != 0.0 {
        ui.scroll_with_delta(vec2(0.0, by));
    }
}

/// Returns the height of each group in rows; a heading counts as two rows.
fn heights(groups: &[Entries]) -> Vec<usize> {
    groups.iter().map(|(_, rows)| rows.len() + 2).collect()
}

/// Returns the number of columns and the largest text size at which all groups fit; the smallest
/// size if none fits.
fn fitting(groups: &[Entries], room: egui::Vec2) -> (usize, f32) {
    let columns = |text: f32| ((room.x / (COLUMN * text)) as usize).clamp(1, 4);
    let fits = |text: f32| {
        let (columns, heights) = (columns(text), heights(groups));
        let mut rows = vec![0; columns];
        for (k, height) in heights.iter().enumerate() {
            rows[column_of(&heights, k, columns)] += height;
        }
        rows.into_iter().max().unwrap_or(0) as f32 * ROW * text <= room.y
    };
    let steps = (2.0 * (TEXT.1 - TEXT.0)) as usize;
    let sizes = (0..=steps).map(|step| TEXT.1 - 0.5 * step as f32);
    let text = sizes.into_iter().find(|text| fits(*text)).unwrap_or(TEXT.0);
    (columns(text), text)
}

fn group(ui: &mut Ui, (group, entries): &Entries, text: f32) {
    ui.add_space(0.5 * text);
    ui.label(RichText::new(group.label()).size(text + 1.0).strong().underline());
    ui.spacing_mut().item_spacing.y = 0.2 * text;
    let width = ui.available_width();
    for (keys, name) in entries {
        ui.horizontal_top(|ui| {
            for (share, words) in
                [(KEYS, RichText::new(keys).strong()), (1.0 - KEYS, RichText::new(name))]
            {
                let words = egui::Label::new(words.size(text)).wrap();
                cell(ui, share * (width - 12.0), |ui| ui.add(words));
            }
        });
    }
}

/// The lecture's conventions, which the program follows.
const CONVENTIONS: &str = "\
The camera's basis is right-handed. 𝐮 points right in the image, 𝐯 up in the image, 𝐰 backwards, away \
from the viewport: 𝐰 = −view/|view|, 𝐮 = normalize(up × 𝐰), 𝐯 = 𝐰 × 𝐮.

up is a hint that keeps the camera level. It is not 𝐯.

A view ray is 𝐩 + 𝑡 𝐝 with 𝐩 = eye and 𝐝 = 𝑢 𝐮 + 𝑣 𝐯 − distance 𝐰. 𝐝 is not normalized: 𝑡 = 1 is on the \
viewport, and the distance along the ray is 𝑡 |𝐝|.

Row 0 is on top, column 0 on the left. A pixel's ray goes through its centre: \
𝑢 = width ((column + ½)/W − ½), 𝑣 = height (½ − (row + ½)/H). The course counts from 1: \
The menu View has a switch for that, under Numbers.

A hit is the smallest 𝑡 > 0. Touching a sphere is a hit; a plane parallel to the ray is none. Of objects \
at the same 𝑡, the one listed first is hit.";

/// Returns the dialog with the conventions.
pub(crate) fn conventions() -> Dialog {
    Dialog::message("The lecture's conventions", CONVENTIONS)
}

/// Returns the dialog about the program.
pub(crate) fn about() -> Dialog {
    let text = format!(
        "Version {}\n\nPinhole shows what a pinhole camera sees, and why: how eye, at and up make u, v, w, \
         and how a pixel's ray finds what it hits. Every hit or miss in its pictures is the one \
         that exact arithmetic gives.\n\nLicences: {}. The fonts have their own, which come with the program.",
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_LICENSE"),
    );
    Dialog::message("Pinhole", text)
}
