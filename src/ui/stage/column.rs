//! The column of the stage: the step's title and text, its question, the room for the answer, the card of
//! formulas, and the way through the lessons.

use egui::accesskit::Role;
use egui::{
    Align, Color32, FontId, Frame, Id, Label, Layout, Margin, Rect, RichText, Sense, Ui, Vec2,
    WidgetInfo,
};
use pinhole_figure::typesetting::theme::{self, WRITTEN};

use super::{Stage, navigation};
use crate::features::lines::view::substitution;
use crate::features::{exercises, mistakes, vote};
use crate::model::ViewLayout;
use crate::model::lessons::OpenLesson;
use crate::ui::widgets::{SIZES, inside, marked_text};
use crate::ui::{PageContext, derivation};

/// Distance between the column's edge and its contents, in points.
const MARGIN: [f32; 2] = [14.0, 6.0];
/// Distance between two texts, in points.
const GAP: f32 = 6.0;
/// Padding around the answer, in points.
const PADDING: f32 = 5.0;
/// Height of the row with the buttons or the step's number, in points.
const FOOT: f32 = 30.0;
/// Space between the step's number and an exercise's buttons, in points.
const BEFORE_BUTTONS: f32 = 12.0;
/// Radius of the dot for the lecturer, in points.
const DOT: f32 = 3.0;

/// Shows the column.
pub(crate) fn show(ui: &mut Ui, stage: &Stage, context: &mut PageContext<'_>) {
    let fill = ui.visuals().panel_fill;
    ui.painter().rect_filled(stage.column, 0.0, fill);
    let whole = stage.column.shrink2(MARGIN.into());
    navigation::swipe(ui, stage.column);
    let has_foot = context.step.is_some() || theme::installed(ui.ctx()).presenting;
    let foot = if has_foot { FOOT.max(ui.spacing().interact_size.y) } else { 0.0 };
    let (above, foot) = whole.split_top_bottom_at_y(whole.bottom() - foot);
    let choice = exercises::ui::choice_height(ui, context);
    let (choice, above) = above.split_top_bottom_at_y(above.top() + choice);
    if choice.height() > 0.0 {
        inside(ui, choice, |ui| exercises::ui::choice(ui, context));
    }
    let is_below_figure = stage.column.top() > stage.main.top();
    let has_two_parts = is_below_figure
        && whole.width() > whole.height()
        && formulas_height(ui, context, whole.width(), WRITTEN) > 0.0;
    let (texts, card) = if has_two_parts {
        let (left, right) = above.split_left_right_at_x(above.center().x);
        (left.with_max_x(left.right() - MARGIN[0]), Some(right))
    } else {
        (above, None)
    };
    let size = size_that_fits(ui, context, texts, card);
    let mut end = texts.top();
    inside(ui, texts, |ui| {
        ui.set_clip_rect(stage.column.intersect(ui.clip_rect()));
        words(ui, context, size);
        end = ui.cursor().top();
    });
    let card = card.unwrap_or_else(|| above.with_min_y(end.min(above.bottom())));
    inside(ui, card, |ui| {
        ui.set_clip_rect(card.intersect(ui.clip_rect()));
        match &mut context.session.live.vote {
            Some(open) => vote::ui::below_question(ui, card, open, size),
            None => formulas(ui, context, size),
        }
    });
    inside(ui, foot, |ui| bottom(ui, context));
}

/// Returns the largest size at which the texts and the card fit. `card` is the card's own area, if it is not
/// below the texts. In one step and one area it never grows again, so that the text stands still under the
/// hand while numbers get shorter and longer.
fn size_that_fits(ui: &mut Ui, context: &PageContext, texts: Rect, card: Option<Rect>) -> f32 {
    let (width, height) = (texts.width().to_bits(), texts.height().to_bits());
    let written = (&context.session.shown.formulas, context.style.digits);
    let step = Id::unique((paragraphs(context), width, height, written));
    let slot = Id::unique("size of the column's text");
    let last = ui.data(|data| data.get_temp::<(Id, f32)>(slot)).filter(|last| last.0 == step);
    let mut fits = |size: &f32| {
        let words = words_height(ui, context, texts.width(), *size);
        // Laying out the formulas costs more, and a drag changes them in each frame.
        if words > texts.height() {
            return false;
        }
        let formulas = formulas_height(ui, context, card.unwrap_or(texts).width(), *size);
        match card {
            Some(card) => formulas <= card.height(),
            None => words + formulas <= texts.height(),
        }
    };
    let largest = SIZES.partition_point(|size| last.is_some_and(|last| *size > last.1));
    // Usually the largest; a new step finds its size by halves, because each costs a layout of all texts.
    let size = match SIZES[largest..].split_first() {
        Some((size, smaller)) if !fits(size) => {
            smaller.get(smaller.partition_point(|size| !fits(size)))
        }
        first => first.map(|(size, _)| size),
    };
    let size = size.copied().unwrap_or(WRITTEN);
    ui.data_mut(|data| data.insert_temp(slot, (step, size)));
    size
}

/// Returns the height of the title, the texts and the room for the answer.
fn words_height(ui: &Ui, context: &PageContext<'_>, width: f32, size: f32) -> f32 {
    let open = context.step.map(|step| step.open);
    let height = |text: &str, width: f32| marked_text::height_within(ui, text, size, width);
    let title = open.map_or(0.0, |open| {
        marked_text::height_within(ui, &title(open), title_size(size), width) + GAP
    });
    let texts: f32 = paragraphs(context).iter().map(|text| height(text, width) + GAP).sum();
    let answer = open
        .and_then(answer)
        .map_or(0.0, |answer| height(answer, width - 2.0 * PADDING) + GAP + 2.0 * PADDING);
    title + texts + answer
}

/// Returns the texts below the title: the step's text and question, and the question of an exercise.
fn paragraphs(context: &PageContext<'_>) -> Vec<String> {
    let step = context.step.map(|step| step.open.step());
    let asked = step.and_then(|step| step.question.as_ref()).map(|question| &question.ask);
    let of_step = step.map(|step| &step.text).into_iter().chain(asked).cloned();
    of_step.chain(exercises::ui::texts(context.session)).collect()
}

/// Returns the answer to the step's question.
fn answer(open: &OpenLesson) -> Option<&str> {
    open.step().question.as_ref().map(|question| question.answer.as_str())
}

fn title(open: &OpenLesson) -> String {
    let steps = open.lesson().steps.len();
    format!("{} · {} of {steps} · {}", open.short_title(), open.id().step + 1, open.step().title)
}

/// Returns the size of the title above texts of this size.
fn title_size(size: f32) -> f32 {
    (0.75 * size).max(WRITTEN)
}

/// Shows the title, the text, the question, and the answer in its room.
fn words(ui: &mut Ui, context: &PageContext<'_>, size: f32) {
    let is_asking = context.session.shown.is_asking;
    let open = context.step.map(|step| step.open);
    ui.spacing_mut().item_spacing.y = GAP;
    if let Some(open) = open {
        let small = FontId::proportional(title_size(size));
        ui.add(Label::new(RichText::new(title(open)).font(small).weak()).wrap());
    }
    for text in paragraphs(context) {
        marked_text::label(ui, &text, size);
    }
    // A vote takes the answer's room.
    let is_voting = context.session.live.vote.is_some();
    let Some(answer) = open.and_then(answer).filter(|_| !is_voting) else { return };
    let fill = if is_asking { Color32::TRANSPARENT } else { ui.visuals().faint_bg_color };
    Frame::NONE.fill(fill).corner_radius(6.0).inner_margin(Margin::same(PADDING as i8)).show(
        ui,
        |ui| {
            ui.set_min_width(ui.available_width());
            if is_asking {
                // It takes its room already.
                ui.set_invisible();
            }
            marked_text::label(ui, answer, size);
        },
    );
}

/// Returns true if a layout's main figure has lines of the derivation beside it.
pub(crate) fn has_card(layout: ViewLayout) -> bool {
    use ViewLayout::{Both, Camera, Compare, Derivation, Plot, World};
    matches!(layout, Both | World | Camera | Compare | Derivation | Plot)
}

/// Returns the height of the card.
fn formulas_height(ui: &mut Ui, context: &PageContext<'_>, width: f32, size: f32) -> f32 {
    if context.session.shows_exercise() {
        return exercises::ui::height(ui, context.session, context.derived, [width, size]);
    }
    match (context.session.shown.setup.layout, &context.derived.derivation) {
        (ViewLayout::Lines, _) => exercises::ui::SUBSTITUTION * marked_text::row_height(ui, size),
        (ViewLayout::Mistakes, _) => context.derived.wrong_camera.as_ref().map_or(0.0, |wrong| {
            let rows = mistakes::ui::card_rows(wrong, context.session) as f32;
            rows * 1.2 * marked_text::row_height(ui, size)
        }),
        (layout, Some(derivation)) if has_card(layout) => {
            derivation::card_height(ui, derivation, width, size)
        }
        _ => 0.0,
    }
}

/// Shows the card: the lines of the derivation that the step names, the substitution of one line into the
/// other, or the checks that catch a mistake.
fn formulas(ui: &mut Ui, context: &mut PageContext<'_>, size: f32) {
    if context.session.shows_exercise() {
        return exercises::ui::ui(ui, context, size);
    }
    let PageContext { ref session, derived, style, .. } = *context;
    let is_asking = session.shown.is_asking;
    match (session.shown.setup.layout, &derived.derivation) {
        (ViewLayout::Lines, _) if !is_asking => {
            ui.style_mut().override_font_id = Some(FontId::proportional(size));
            substitution(ui, &session.shown.lines, style.digits);
        }
        (ViewLayout::Mistakes, _) if !is_asking => {
            if let Some(wrong) = &derived.wrong_camera {
                mistakes::ui::card(ui, context, wrong, size);
            }
        }
        (layout, Some(derivation)) if has_card(layout) => {
            derivation::card(ui, context, derivation, size);
        }
        _ => {}
    }
}

/// Shows the buttons that lead through the lessons. While presenting, shows the step's number instead, and the
/// buttons of an exercise.
fn bottom(ui: &mut Ui, context: &mut PageContext<'_>) {
    if theme::installed(ui.ctx()).presenting {
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            if let Some([number, all]) = context.step.and_then(|step| step.open.number_of_all()) {
                let text = RichText::new(format!("{number} of {all}")).size(WRITTEN).weak();
                let rect = ui.label(text).rect;
                if context.session.shown.is_asking {
                    dot(ui, rect);
                    navigation::vote(ui, context);
                }
            }
            if context.session.shows_exercise() {
                ui.add_space(BEFORE_BUTTONS);
                exercises::ui::buttons(ui, context);
            }
        });
        return;
    }
    let Some(step) = &context.step else { return };
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        navigation::buttons(ui, step, context.session.shown.is_asking);
        navigation::vote(ui, context);
    });
}

/// Draws a dot beside the step's number: the sign for the lecturer that the answer is hidden.
fn dot(ui: &mut Ui, number: Rect) {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(number.height()), Sense::hover());
    ui.painter().circle_filled(rect.center(), DOT, ui.visuals().weak_text_color());
    let words = "The answer is hidden";
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words));
}
