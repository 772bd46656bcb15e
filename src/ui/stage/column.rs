//! The column of the stage: the step's title and text, its question, the room for the answer, the card of
//! formulas, and the way through the lessons.

use egui::accesskit::Role;
use egui::{
    Align, Color32, FontId, Frame, Id, Label, Layout, Margin, Rect, RichText, Sense, Ui, Vec2,
    WidgetInfo,
};
use pinhole_figure::typesetting::theme::{self, WRITTEN};

use super::{Stage, navigation};
use crate::features::{exercises, lines, mistakes, vote};
use crate::model::lessons::OpenLesson;
use crate::model::{Session, ViewLayout};
use crate::ui::widgets::{SIZES, inside, largest_size, marked_text};
use crate::ui::{PageContext, derivation};

/// Distance between the column's edge and its contents, in points.
const MARGIN: [f32; 2] = [14.0, 6.0];
/// Distance between two texts, in points.
const GAP: f32 = 6.0;
/// Padding around the answer, in points.
const PADDING: f32 = 5.0;
/// Height of the row with the buttons, in points.
const FOOT: f32 = 30.0;
/// Height of the row with the step's number alone, in points.
const NUMBER: f32 = 17.0;
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
    let has_buttons = context.session.shows_exercise() || !theme::installed(ui.ctx()).presenting;
    let foot = match (has_foot, has_buttons) {
        (false, _) => 0.0,
        (true, false) => NUMBER,
        (true, true) => FOOT.max(ui.spacing().interact_size.y),
    };
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
    let [of_words, of_card] = sizes_that_fit(ui, context, texts, card);
    let mut end = texts.top();
    inside(ui, texts, |ui| {
        ui.set_clip_rect(stage.column.intersect(ui.clip_rect()));
        words(ui, context, of_words);
        end = ui.cursor().top();
    });
    let card = card.unwrap_or_else(|| above.with_min_y(end.min(above.bottom())));
    inside(ui, card, |ui| {
        ui.set_clip_rect(card.intersect(ui.clip_rect()));
        match &mut context.session.live.vote {
            Some(open) => vote::ui::below_question(ui, card, open, of_words),
            None => formulas(ui, context, of_card),
        }
    });
    inside(ui, foot, |ui| bottom(ui, context));
}

/// Returns the largest sizes at which the texts and the card fit, in points. `card` is the card's own area, if it is not
/// below the texts. What is changed in a step, as by a drag, leaves the texts as large as they are: only the card
/// becomes smaller where its numbers get longer, and does not grow again under the hand.
fn sizes_that_fit(ui: &mut Ui, context: &PageContext, texts: Rect, card: Option<Rect>) -> [f32; 2] {
    let (width, height) = (texts.width().to_bits(), texts.height().to_bits());
    let Session { shown, preferences, .. } = &*context.session;
    let written = (&shown.formulas, context.style.digits, preferences.exact_forms);
    let step = Id::unique((paragraphs(context), width, height, written));
    let slot = Id::unique("sizes of the column's text");
    let last = ui.data(|data| data.get_temp::<(Id, [f32; 2], bool)>(slot));
    let last = last.filter(|last| last.0 == step);
    let of_words = |ui: &Ui, size: f32| words_height(ui, context, texts.width(), size);
    let of_card =
        |ui: &mut Ui, size: f32| formulas_height(ui, context, card.unwrap_or(texts).width(), size);
    let room = |ui: &Ui, size: f32| match card {
        Some(card) => card.height(),
        None => texts.height() - of_words(ui, size),
    };
    let is_changed = context.step.as_ref().is_some_and(|step| step.is_changed);
    let words = match last {
        Some((_, [words, _], is_own)) if is_own || is_changed => words,
        _ => largest_size(SIZES[0], |size| {
            of_words(ui, *size) <= texts.height() && of_card(ui, *size) <= room(ui, *size)
        }),
    };
    let is_held = ui.input(|input| input.pointer.any_down());
    let most = last.filter(|_| is_held).map_or(words, |(_, [_, card], _)| card);
    let room = room(ui, words);
    let card = largest_size(most, |size| of_card(ui, *size) <= room);
    // True if the texts have the size that fits the step as it was opened.
    let is_own = !is_changed || last.is_some_and(|(.., is_own)| is_own);
    ui.data_mut(|data| data.insert_temp(slot, (step, [words, card], is_own)));
    [words, card]
}

/// Returns the height of the title, the texts and the room for the answer.
fn words_height(ui: &Ui, context: &PageContext<'_>, width: f32, size: f32) -> f32 {
    let open = context.step.map(|step| step.open);
    let height = |text: &str, size: f32, inset: f32| {
        marked_text::height_within(ui, text, size, width - inset) + GAP + inset
    };
    let title = open.map_or(0.0, |open| height(&title(open), title_size(size), 0.0));
    let texts: f32 = paragraphs(context).iter().map(|text| height(text, size, 0.0)).sum();
    title + texts + open.and_then(answer).map_or(0.0, |answer| height(answer, size, 2.0 * PADDING))
}

/// Returns the texts below the title: the step's text and question, or the question of an exercise and the step's
/// advice.
fn paragraphs(context: &PageContext<'_>) -> Vec<String> {
    let step = context.step.map(|step| step.open.step());
    let asked = step.and_then(|step| step.question.as_ref()).map(|question| &question.ask);
    let of_step = step.map(|step| &step.text).filter(|_| advice(context).is_none());
    let own = of_step.into_iter().chain(asked).cloned();
    own.chain(exercises::ui::texts(context.session)).chain(advice(context).cloned()).collect()
}

/// Returns the step's advice on its exercise, of which the solution takes the place.
fn advice<'a>(context: &PageContext<'a>) -> Option<&'a String> {
    let step = context.step.filter(|_| context.session.shows_exercise())?;
    Some(&step.open.step().text)
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
    let texts = paragraphs(context);
    let is_solved = advice(context).is_some() && context.session.exercises.is_solved;
    for text in &texts[..texts.len() - usize::from(is_solved)] {
        marked_text::label(ui, text, size);
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
        let advice = advice(context)
            .map_or(0.0, |text| marked_text::height_within(ui, text, size, width) + GAP);
        let at = ([width, size], advice);
        return exercises::ui::height(ui, context.session, context.derived, at);
    }
    match (context.session.shown.setup.layout, &context.derived.derivation) {
        (ViewLayout::Lines, _) => {
            let of_card = (&context.session.shown.lines, context.style.digits, false);
            lines::view::card_height(ui, of_card, [width, size])
        }
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
            let shown = &session.shown;
            lines::view::card(ui, &shown.lines, (style.digits, false), shown.revealed_lines);
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
                let session = &*context.session;
                let has_solution = session.shows_exercise() && !session.exercises.is_solved;
                if session.shown.is_asking || has_solution {
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
