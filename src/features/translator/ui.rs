//! The translator: the camera in another program's format, the differences between the conventions, and the
//! numbers whose sign changes.

use std::time::Duration;

use egui::text::{LayoutJob, TextFormat};
use egui::{
    Align2, Area, FontId, Frame, Id, Label, Order, RichText, ScrollArea, Stroke, Ui, WidgetText,
    vec2,
};
use pinhole_core::{Camera, Pixel};
use pinhole_exchange::code::LANGUAGES;
use pinhole_exchange::document::Document;
use pinhole_exchange::format::{Format, Text};
use pinhole_exchange::programs::FORMATS;
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::typesetting::theme::error_color;

use crate::features::translator::state::{
    ConventionRow, MOST_OBJECTS, Notice, Translation, Translator,
};
use crate::ui::PageContext;
use crate::ui::action::{Action, FileUse};
use crate::ui::widgets::{ResponseExt as _, cell};

/// Sizes of text, in points.
const TEXT: f32 = 15.0;
const CODE: f32 = 15.0;
/// Minimum size of code, in points. Lines that are too long are first set smaller and only then wrapped,
/// because the rows of a matrix are read in columns.
const SMALL_CODE: f32 = 12.0;

/// Time to read one line of a notice, in seconds.
const READING: f64 = 6.0;
/// Distance of a notice from the edges of the page, in points.
const EDGE: f32 = 12.0;

/// Width of the table's first column, in points.
const ABOUT: f32 = 118.0;

/// Shows the translator.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { open, session, .. } = context;
    let document = &open.document;
    let (choice, digits) = (&mut session.translator, session.shown.setup.digits);
    ui.style_mut().override_font_id = Some(FontId::proportional(TEXT));
    let resolved = document.camera.resolve().ok();
    let pixel = resolved.and_then(|resolved| session.shown.selection.pixel(&resolved));
    let pixel = pixel.unwrap_or(Pixel { row: 0, column: 0 });
    targets(ui, choice);
    // If the objects are not written, it does not matter whether they are valid.
    let subject = match choice.objects {
        true => document.clone(),
        false => Document { camera: document.camera, ..Document::default() },
    };
    let translation = Translation::new(&subject, choice.chosen(), choice.objects, pixel, digits);
    ui.horizontal_wrapped(|ui| {
        let can = translation.written.is_ok();
        if ui.add_enabled(can, egui::Button::new("Copy")).clicked()
            && let Ok(written) = &translation.written
        {
            ui.ctx().copy_text(written.text.text.clone());
        }
        let save = ui.add_enabled(can, egui::Button::new("Save as a file…"));
        save.asks(FileUse::SaveCamera);
        ui.button("Paste a camera").asks(Action::AskPaste);
        let few = document.object_count() <= MOST_OBJECTS;
        let objects = egui::Checkbox::new(&mut choice.objects, "objects, too");
        let many = "There are too many to show: pinhole export writes them";
        ui.add_enabled(few, objects).on_disabled_hover_text(many);
    });
    ui.separator();
    ScrollArea::vertical().id_salt("translation").auto_shrink(false).show(ui, |ui| {
        text(ui, &translation);
        ui.add_space(6.0);
        table(ui, &translation.rows, choice.chosen().short);
    });
}

/// Shows a button for each program's format; below them, one for each programming language.
fn targets(ui: &mut Ui, translator: &mut Translator) {
    let mut row = |ui: &mut Ui, title: &str, formats: &'static [Format]| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(4.0, 2.0);
            ui.label(RichText::new(title).weak());
            for format in formats {
                let target = &mut translator.target;
                let button = ui.selectable_value(target, format.name, format.short);
                button.on_hover_text(format.label);
            }
        });
    };
    row(ui, "program", &FORMATS);
    row(ui, "code", LANGUAGES);
}

/// Shows the translated text, in which numbers with changed signs are underlined, and the notes about what
/// the format cannot express.
fn text(ui: &mut Ui, translation: &Translation) {
    let written = match &translation.written {
        Ok(written) => written,
        Err(error) => {
            ui.label(RichText::new(sentence(error)).strong().color(error_color(ui)));
            return;
        }
    };
    Frame::new().fill(ui.visuals().extreme_bg_color).inner_margin(6.0).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let exact = written.text.text.trim_end();
        let size = code_size(ui, exact);
        let response = ui.add(Label::new(marked(ui, &written.text, size)).wrap());
        let response = response.with_role(egui::accesskit::Role::Code);
        response.named("translation").spoken(exact);
    });
    if !written.text.flipped.is_empty() || translation.rows.iter().any(|row| row.flipped) {
        ui.horizontal_wrapped(|ui| {
            let format = underlined(ui, FontId::proportional(TEXT));
            ui.label(LayoutJob::single_section("underlined".to_owned(), format));
            ui.label("opposite sign to Pinhole's u, v, w");
        });
    }
    for note in &written.notes {
        ui.label(format!("• {}", sentence(note)));
    }
}

/// Returns the size at which the longest line fits, or the smallest legible size.
fn code_size(ui: &Ui, text: &str) -> f32 {
    let letter = ui.ctx().fonts_mut(|fonts| fonts.glyph_width(&FontId::monospace(CODE), '0'));
    let longest = text.lines().map(|line| line.chars().count()).max().unwrap_or_default();
    // A point less, to allow for rounding.
    let fits = CODE * (ui.available_width() - 1.0) / (letter * longest.max(1) as f32);
    (2.0 * fits).floor().clamp(2.0 * SMALL_CODE, 2.0 * CODE) / 2.0
}

fn underlined(ui: &Ui, font: FontId) -> TextFormat {
    let color = error_color(ui);
    TextFormat { underline: Stroke::new(1.5, color), ..TextFormat::simple(font, color) }
}

fn marked(ui: &Ui, written: &Text, size: f32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let font = FontId::monospace(size);
    let plain = TextFormat::simple(font.clone(), ui.visuals().text_color());
    let text = written.text.trim_end();
    let mut from = 0;
    for mark in &written.flipped {
        job.append(&text[from..mark.start], 0.0, plain.clone());
        job.append(&text[mark.clone()], 0.0, underlined(ui, font.clone()));
        from = mark.end;
    }
    job.append(&text[from..], 0.0, plain);
    job
}

/// Shows a table that compares Pinhole with the format, with one row per property.
fn table(ui: &mut Ui, rows: &[ConventionRow], label: &str) {
    if rows.is_empty() {
        return;
    }
    let width = ui.available_width();
    let side = ((width - ABOUT - 16.0) / 2.0).max(80.0);
    let line = |ui: &mut Ui, cells: [WidgetText; 3]| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            for (text, width) in cells.into_iter().zip([ABOUT, side, side]) {
                cell(ui, width, |ui| ui.add(Label::new(text).wrap()));
            }
        });
    };
    let head = |text: &str| WidgetText::from(RichText::new(text).strong());
    line(ui, [head(""), head("Pinhole"), head(label)]);
    ui.separator();
    for row in rows {
        let theirs = RichText::new(&row.theirs);
        let theirs = match (row.flipped, row.differs) {
            (true, _) => theirs.color(error_color(ui)).underline(),
            (false, true) => theirs.strong(),
            (false, false) => theirs,
        };
        let about = RichText::new(row.about).weak();
        line(ui, [about.into(), RichText::new(&row.ours).into(), theirs.into()]);
    }
}

fn sentence(text: &str) -> String {
    let text = typeset_message(text);
    // A name such as zNear keeps its case.
    let word = text.split_whitespace().next().unwrap_or_default();
    if word.contains(|c: char| c.is_uppercase() || c == '_') {
        return format!("{}.", text.trim_end_matches('.'));
    }
    let mut chars = text.chars();
    let first = chars.next().map_or_else(String::new, |c| c.to_uppercase().collect());
    format!("{first}{}.", chars.as_str().trim_end_matches('.'))
}

/// Shows the notice below the bars, until the time to read it is over or the user closes it. At the lower edge
/// are the buttons of a lesson and of an exercise. A notice about another camera than this one disappears.
pub(crate) fn notice(ui: &Ui, notice: &mut Option<Notice>, camera: &Camera) {
    notice.take_if(|notice| notice.camera.is_some_and(|own| own != *camera));
    let Some(shown) = notice else { return };
    let (ctx, page) = (ui.ctx(), ui.max_rect().shrink(EDGE));
    let now = ctx.input(|i| i.time);
    let left = *shown.shown_at.get_or_insert(now) + READING * (1 + shown.notes.len()) as f64 - now;
    // A failure stays until the user closes it.
    let mut close = shown.worked && left <= 0.0;
    if shown.worked && !close {
        ctx.request_repaint_after(Duration::from_secs_f64(left));
    }
    let area = Area::new(Id::unique("notice")).order(Order::Foreground);
    area.pivot(Align2::CENTER_TOP).fixed_pos(page.center_top()).show(ctx, |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.set_max_width(page.width().min(560.0));
            ui.style_mut().override_font_id = Some(FontId::proportional(TEXT));
            let title = RichText::new(&shown.title).strong();
            ui.label(if shown.worked { title } else { title.color(error_color(ui)) });
            for note in &shown.notes {
                ui.label(sentence(note));
            }
            close |= ui.button("Close").clicked();
        });
    });
    if close {
        *notice = None;
    }
}
