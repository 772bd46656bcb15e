//! The page about a class's answers: on the left the codes that students have sent, on the right how many
//! answers are right, and how many show which mistake.

use egui::accesskit::Role;
use egui::{
    Align, Align2, CornerRadius, FontId, Layout, Rect, RichText, ScrollArea, Sense, Stroke,
    StrokeKind, TextEdit, Ui, WidgetInfo, vec2,
};
use pinhole_figure::typesetting::theme::{self, STACKED, error_color};

use crate::features::class::state::{ClassAnswers, ClassExercise, RIGHT};
use crate::model::Session;
use crate::ui::PageContext;
use crate::ui::widgets::{ResponseExt as _, clipped, fault_text, marked_text};

/// Size of the text, in points, and of the labels of the bars.
const TEXT: f32 = 15.0;
const LABEL: f32 = 18.0;

/// Share of the page's width for the codes or, where the answers are below them, of its height.
const SHARE: f32 = 0.38;
/// Distance of codes and answers from the edges of their areas, and space between two exercises, in points.
const MARGIN: f32 = 8.0;
const GAP: f32 = 24.0;

/// Height of a bar with the space around it, in points.
const ROW: f32 = 32.0;
/// Share of a row's width for its label.
const NAMED: f32 = 0.42;
/// Space for the number after the longest bar, in points.
const COUNT: f32 = 48.0;

/// Tells where codes come from: the lecturer and, while there are none on the stage, the class.
const HINT: &str = "In an exercise, Copy my answer puts a code on the clipboard, which students send the \
                    lecturer in any way. The codes are pasted into this page. Any other text is ignored.";

/// Shows the page. While presenting, it hides the codes, since names may stand beside them.
pub(crate) fn ui(ui: &mut Ui, PageContext { session, .. }: &mut PageContext<'_>) {
    ui.style_mut().override_font_id = Some(FontId::proportional(TEXT));
    let whole = ui.available_rect_before_wrap();
    if session.presenting.is_some() {
        return clipped(ui, whole, |ui| answers(ui, &session.class.answers));
    }
    let (codes_area, area) = match whole.width() < STACKED {
        true => whole.split_top_bottom_at_fraction(SHARE),
        false => whole.split_left_right_at_fraction(SHARE),
    };
    clipped(ui, codes_area.shrink(MARGIN), |ui| codes(ui, session));
    clipped(ui, area.shrink(MARGIN), |ui| answers(ui, &session.class.answers));
}

/// Returns the page's contents for screen readers.
pub(crate) fn spoken(class: &ClassAnswers) -> Vec<String> {
    let counts = |(outcome, count): &(String, usize)| format!("{outcome}: {count}");
    let exercise = |own: &ClassExercise| {
        let counts = own.tally.counts.iter().map(counts);
        [own.title.clone()].into_iter().chain(counts).collect::<Vec<_>>()
    };
    class.exercises.iter().flat_map(exercise).chain(class.problems()).collect()
}

fn codes(ui: &mut Ui, session: &mut Session) {
    ui.heading("Codes of a class");
    ui.label(HINT);
    ui.add_space(6.0);
    let class = &mut session.class;
    let is_removed = class.text.is_empty() && !class.removed.is_empty();
    let verb = if is_removed { "Bring the codes back" } else { "Remove all codes" };
    if ui.add_enabled(is_removed || !class.text.is_empty(), egui::Button::new(verb)).clicked() {
        class.remove_or_bring_back();
    }
    ui.add_space(6.0);
    ScrollArea::vertical().id_salt("codes").show(ui, |ui| {
        let field = TextEdit::multiline(&mut class.text).desired_width(f32::INFINITY);
        let field = field.desired_rows(12).hint_text("answer1/sphere/lecture/…");
        if ui.add(field).named("codes").changed() {
            class.update();
        }
    });
}

/// Shows how many answers are right, how many show which mistake, and which codes cannot be read.
fn answers(ui: &mut Ui, class: &ClassAnswers) {
    let presenting = theme::installed(ui.ctx()).presenting;
    ScrollArea::vertical().id_salt("class").auto_shrink(false).show(ui, |ui| {
        if presenting && class.exercises.is_empty() {
            marked_text::label(ui, HINT, LABEL);
        }
        for own in &class.exercises {
            ui.heading(RichText::new(&own.title).size(LABEL).strong());
            for (outcome, count) in &own.tally.counts {
                bar(ui, own.answers, outcome, *count);
            }
            for line in &own.tally.explanations {
                ui.label(line);
            }
            ui.add_space(GAP);
        }
        if !class.not_readable.is_empty() {
            let title = format!("Not readable: {}", class.not_readable.len());
            ui.heading(RichText::new(title).size(LABEL).strong());
        }
        // The class need not see whose code is broken.
        let shown = class.problems().filter(|_| !presenting);
        for problem in shown.collect::<Vec<_>>() {
            ui.label(fault_text(ui, problem));
        }
    });
}

/// Shows the number of answers with an outcome, of all answers, as a bar.
fn bar(ui: &mut Ui, all: usize, outcome: &str, count: usize) {
    let visuals = ui.visuals();
    let color = if outcome == RIGHT { visuals.selection.bg_fill } else { error_color(ui) };
    let ink = visuals.strong_text_color();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let from = rect.left() + NAMED * rect.width();
    let length = (rect.right() - COUNT - from).max(0.0) * count as f32 / all as f32;
    let drawn = Rect::from_x_y_ranges(from..=from + length, rect.y_range()).shrink2(vec2(0.0, 4.0));
    let name = format!("{outcome}: {count}");
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
    let named = RichText::new(outcome).size(LABEL).color(ink);
    clipped(ui, rect.with_max_x(from - 8.0), |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add(egui::Label::new(named).truncate());
        });
    });
    let edge = Stroke::new(1.5, ink);
    ui.painter().rect(drawn, CornerRadius::ZERO, color, edge, StrokeKind::Inside);
    let at = drawn.right_center() + vec2(8.0, 0.0);
    let font = FontId::proportional(LABEL);
    ui.painter().text(at, Align2::LEFT_CENTER, count.to_string(), font, ink);
}
