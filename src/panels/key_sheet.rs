//! All keys on one sheet over the window.

use egui::{Context, Id, Key, Modal, Modifiers, RichText, ScrollArea, Ui, vec2};

use crate::verbs::{Group, sheet};

/// Of names and keys, in points.
const TEXT: f32 = 16.0;
/// A column is at least this wide, in points.
const COLUMN: f32 = 330.0;
/// What names leave for keys of a column's width.
const KEYS: f32 = 0.42;

/// Shows the sheet; whether it stays open.
pub(crate) fn ui(ctx: &Context) -> bool {
    let keys = [Key::Questionmark, Key::F1];
    let again = keys.iter().any(|key| ctx.input_mut(|i| i.consume_key(Modifiers::NONE, *key)));
    let mut is_open = !again;
    let response = Modal::new(Id::unique("keys")).show(ctx, |ui| {
        let size = ctx.content_rect().size() - vec2(40.0, 40.0);
        ui.set_width(size.x);
        ui.horizontal(|ui| {
            ui.label(RichText::new("Keys").size(TEXT + 6.0).strong());
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let button = ui.button(RichText::new("Close (Escape)").size(TEXT));
                is_open &= !button.clicked();
            });
        });
        ui.separator();
        ScrollArea::vertical()
            .max_height((size.y - 50.0).max(60.0))
            .auto_shrink(false)
            .show(ui, |ui| columns(ui, &sheet()));
    });
    is_open && !response.should_close()
}

/// The groups, in as many columns as there is room for, each about as high as the others.
fn columns(ui: &mut Ui, groups: &[(Group, Vec<(String, String)>)]) {
    let count = ((ui.available_width() / COLUMN) as usize).clamp(1, 3);
    // A heading takes about two rows.
    let rows = |groups: &[(Group, Vec<_>)]| -> usize {
        groups.iter().map(|(_, rows)| rows.len() + 2).sum()
    };
    let all = rows(groups).max(1);
    ui.columns(count, |columns| {
        for (k, (group, entries)) in groups.iter().enumerate() {
            let middle = rows(&groups[..k]) + entries.len() / 2;
            let column = &mut columns[(count * middle / all).min(count - 1)];
            one(column, *group, entries);
        }
    });
}

fn one(ui: &mut Ui, group: Group, entries: &[(String, String)]) {
    ui.add_space(6.0);
    ui.label(RichText::new(group.label()).size(TEXT + 1.0).strong());
    let width = ui.available_width();
    egui::Grid::new(("keys", group.label())).num_columns(2).spacing(vec2(12.0, 3.0)).show(
        ui,
        |ui| {
            for (keys, name) in entries {
                let cell = |ui: &mut Ui, share: f32, text: RichText| {
                    ui.set_max_width(share * (width - 12.0));
                    ui.add(egui::Label::new(text).wrap());
                };
                ui.vertical(|ui| cell(ui, KEYS, RichText::new(keys).size(TEXT).strong()));
                ui.vertical(|ui| cell(ui, 1.0 - KEYS, RichText::new(name).size(TEXT)));
                ui.end_row();
            }
        },
    );
}
