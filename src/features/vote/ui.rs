//! A classroom vote with large options, a bar for the hands that were raised for each, and two rounds: a page of its
//! own that asks which mistake made the wrong picture and says why, or the place below a step's question.

use egui::accesskit::Role;
use egui::epaint::TextShape;
use egui::{
    Align2, Color32, Context, CornerRadius, Event, FontId, Id, Pos2, Rect, RichText, ScrollArea,
    Sense, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use pinhole_figure::typesetting::theme::{WRITTEN, error_color};
use pinhole_lecture::mistakes::{ComparedCamera, Vote};

use crate::features::mistakes::MistakesView;
use crate::features::vote::state::{OpenVote, VoteOption};
use crate::model::session::Session;
use crate::ui::PageContext;
use crate::ui::action::{LookAction, VoteAction};
use crate::ui::commands_table::hint;
use crate::ui::widgets::{
    ResponseExt as _, clipped, cross, fault_text, inside, largest_size, line_field, marked_text,
    text_width, tick,
};
use crate::view::derive::Derived;

/// The question's text.
pub(crate) const ASKED: &str = "Which mistake made the wrong picture?";
/// Size of the question's text, in points.
const QUESTION: f32 = 20.0;
/// Size of an option's letter, in points.
const LETTER: f32 = 30.0;
/// Size of a mistake's name, in points.
const NAME: f32 = 20.0;
/// Size of a formula, in points.
const FORMULA: f32 = 15.0;
/// Size of the reason's text, in points.
const REASON: f32 = 16.0;

/// Height of the question, in points.
const HEAD: f32 = 28.0;
/// Minimum height of the reason, in points: below the options, and beside them.
const WHY: [f32; 2] = [96.0, 36.0];
/// Space above and below a row of buttons, in points.
const AROUND_BUTTONS: f32 = 12.0;

/// Minimum and maximum height of an option, in points.
const OPTION: [f32; 2] = [37.0, 104.0];

/// Aspect ratio of the page from which on the options stand in two columns.
const WIDE: f32 = 1.6;

/// Space between the options, in points.
const GAP: f32 = 8.0;

/// Width of a letter's column, in points.
const LETTER_WIDTH: f32 = 46.0;
/// Width of the column for the sign that marks right and wrong, in points.
const SIGN_WIDTH: f32 = 44.0;

/// Height of an option, in points, above which its bars are below its text.
const BARS_BELOW: f32 = 54.0;

/// Width of the field for the hands, in points.
const HANDS: f32 = 96.0;
/// Share of an option's text that is its name, if it has bars.
const NAMED: f32 = 0.5;
/// The same if the bars are beside it.
const BESIDE_BARS: f32 = 0.72;
/// Space between two bars, in points.
const BETWEEN: f32 = 3.0;
/// Maximum size of the number of hands, in points.
const COUNT: f32 = 26.0;

/// Applies a key of the open vote.
pub(crate) fn apply(ctx: &Context, session: &mut Session, action: VoteAction) {
    let (view, of_step) = (&mut session.shown.mistakes_view, &mut session.live.vote);
    let is_of_step = of_step.is_some();
    let Some(open) = of_step.as_mut().or(view.open_vote.as_mut()) else { return };
    match action {
        VoteAction::Choose(option) => open.choose(option),
        VoteAction::NextRound => open.begin_round(),
        VoteAction::Reveal => open.is_revealed = true,
        VoteAction::End if is_of_step => *of_step = None,
        VoteAction::End => view.close_vote(),
        VoteAction::Another => {
            view.close_vote();
            view.wants_vote = true;
        }
        VoteAction::CountHands => {
            ctx.memory_mut(|memory| memory.request_focus(hands_id()));
            // The key's own letter is not for the field.
            ctx.input_mut(|input| input.events.retain(|event| !matches!(event, Event::Text(_))));
        }
    }
}

fn hands_id() -> Id {
    Id::unique("hands of the vote")
}

/// Shows the button that opens a vote, if there is a picture to vote on.
pub(crate) fn button(ui: &mut Ui, view: &MistakesView, can: bool) {
    let hint = "Shows a wrong picture without its name, and four mistakes to choose from";
    let button = ui.add_enabled(can, egui::Button::new("Guess which"));
    button.on_hover_text(hint).asks(LookAction::Vote);
    if view.nothing_shows {
        ui.label("No two mistakes look different in this picture: bring an object into view.");
    }
    ui.add_space(3.0);
}

/// Returns true if there is a picture to vote on.
pub(crate) fn can_ask(derived: &Derived) -> bool {
    derived.resolved.is_some() && derived.scene.is_some()
}

/// Shows the vote.
pub(crate) fn ui(ui: &mut Ui, PageContext { session, derived, .. }: &mut PageContext<'_>) {
    let (view, wrong) = (&mut session.shown.mistakes_view, derived.wrong_camera.as_deref());
    let whole = ui.available_rect_before_wrap().shrink2(vec2(10.0, 6.0));
    let Some(open) = &mut view.open_vote else { return };
    let is_wide = whole.width() > WIDE * whole.height();
    let (head, rest) = whole.split_top_bottom_at_y(whole.top() + HEAD);
    let bar = ui.spacing().interact_size.y + AROUND_BUTTONS;
    let (above, bar) =
        rest.split_top_bottom_at_y(rest.bottom() - if is_wide { 1.0 } else { 2.0 } * bar);
    let rows = if is_wide { 2 } else { open.options.len() };
    let room = (above.height() - WHY[usize::from(is_wide)]) / rows as f32 - GAP;
    let option = room.clamp(OPTION[0], OPTION[1]) + GAP;
    let (tiles, why) = above.split_top_bottom_at_y(above.top() + option * rows as f32);
    question(ui, head);
    options(ui, tiles, rows, open, NAME);
    clipped(ui, why, |ui| {
        // In a low window the reason scrolls, so that the options stay legible.
        let area = ScrollArea::vertical().id_salt("why").auto_shrink(false);
        area.show(ui, |ui| reason(ui, open, wrong));
    });
    inside(ui, bar, |ui| buttons(ui, view, can_ask(derived), is_wide));
}

fn question(ui: &mut Ui, rect: Rect) {
    let fits = |size: &f32| text_width(ui, ASKED, FontId::proportional(*size)) <= rect.width();
    let text = RichText::new(ASKED).size(largest_size(QUESTION, fits)).strong();
    inside(ui, rect, |ui| ui.add(egui::Label::new(text).truncate()));
}

/// Minimum height of an option, in points.
const LEAST_HEIGHT: f32 = 8.0;

/// Shows the vote on a step's question below it, with texts of this size.
pub(crate) fn below_question(ui: &mut Ui, area: Rect, open: &mut OpenVote, size: f32) {
    let row = ui.spacing().interact_size.y + BETWEEN;
    let bar = 2.0 * row + AROUND_BUTTONS;
    let tiles = area.with_max_y(area.bottom() - bar);
    let count = open.options.len();
    let height = |rows: usize| tiles.height() / rows as f32 - GAP;
    let rows = if height(count) >= OPTION[0] { count } else { count.div_ceil(2) };
    let height = (height(rows).min(OPTION[1]) + GAP) * rows as f32;
    let (tiles, below) = area.split_top_bottom_at_y(tiles.top() + height);
    options(ui, tiles, rows, open, size);
    inside(ui, below.with_max_y(below.top() + bar), |ui| {
        ui.spacing_mut().item_spacing.y = BETWEEN;
        ui.horizontal(|ui| hands(ui, open));
        ui.horizontal(|ui| match problem(ui, open) {
            Some(problem) => drop(ui.add(egui::Label::new(fault_text(ui, problem)).wrap())),
            None => {
                reveal(ui, open.is_revealed);
                let close = ui.button("End the vote").on_hover_text("The question stays open");
                close.asks(VoteAction::End);
            }
        });
    });
}

/// Returns what is wrong with the typed hands, once they are typed.
fn problem(ui: &Ui, open: &OpenVote) -> Option<String> {
    let is_typing = ui.ctx().memory(|memory| memory.has_focus(hands_id()));
    let is_shown = !is_typing && !open.is_revealed && !open.typed.trim().is_empty();
    open.read_typed().err().filter(|_| is_shown)
}

/// Shows the options in this many rows, with texts of this size.
fn options(ui: &mut Ui, area: Rect, rows: usize, open: &mut OpenVote, size: f32) {
    let count = open.options.len();
    let columns = count.div_ceil(rows);
    let cells = vec2(columns as f32, rows as f32);
    let cell = (area.size() + vec2(GAP, 0.0)) / cells;
    let size = common_size(ui, open, cell - vec2(GAP, GAP), size);
    for index in 0..count {
        let place = vec2((index % columns) as f32, (index / columns) as f32);
        let rect = Rect::from_min_size(area.min + place * cell, cell - vec2(GAP, GAP));
        // In the pass in which the vote opens, its area may still be too small.
        let has_room = rect.width() > LETTER_WIDTH + SIGN_WIDTH && rect.height() > LEAST_HEIGHT;
        if has_room && option(ui, rect, index, open, size) {
            open.choose(index);
        }
    }
}

/// Returns the largest size of at most `most` at which the texts of all options fit into their tiles.
fn common_size(ui: &Ui, open: &OpenVote, tile: Vec2, most: f32) -> f32 {
    let tile = Rect::from_min_size(Pos2::ZERO, tile - vec2(LETTER_WIDTH + SIGN_WIDTH, 0.0));
    let (room, _) = parts(tile, open.counted().next().is_some());
    let fits = |size: &f32| {
        let height =
            |option: &VoteOption| marked_text::height_within(ui, &option.text, *size, room.width());
        open.options.iter().all(|option| height(option) <= room.height())
    };
    largest_size(most, fits)
}

/// Shows an option. Returns true if the user votes for it.
fn option(ui: &Ui, rect: Rect, index: usize, open: &OpenVote, size: f32) -> bool {
    let id = ui.scope_id().with(("option", index));
    let response = ui.interact(rect, id, Sense::click());
    let response = response.with_role(Role::Button).named(open.named(index));
    let is_right = index == open.right;
    let is_chosen = open.answer == Some(index);
    let visuals = ui.visuals();
    let strong = visuals.strong_text_color();
    let edge = match (open.is_revealed, is_right, is_chosen) {
        (true, true, _) => Stroke::new(4.0, strong),
        (true, false, true) => Stroke::new(3.0, error_color(ui)),
        (true, false, false) => visuals.widgets.inactive.bg_stroke,
        (false, _, true) => Stroke::new(4.0, visuals.selection.stroke.color),
        (false, ..) => Stroke::new(1.0, visuals.weak_text_color()),
    };
    // What fades has no colours of its own.
    let faded = (open.is_revealed && !is_right).then_some(visuals.weak_text_color());
    let ink = faded.unwrap_or(strong);
    let fill = match response.hovered() && !open.is_revealed {
        true => visuals.widgets.hovered.weak_bg_fill,
        false => visuals.widgets.inactive.weak_bg_fill,
    };
    let painter = ui.painter_at(rect.expand(2.0));
    painter.rect(rect, 6.0, fill, edge, StrokeKind::Inside);
    let letter = pos2(rect.left() + 0.5 * LETTER_WIDTH, rect.center().y);
    let font = FontId::proportional(LETTER.min(0.75 * rect.height()));
    painter.text(letter, Align2::CENTER_CENTER, Vote::LETTERS[index], font, ink);
    let right = rect.right() - SIGN_WIDTH;
    let text = Rect::from_x_y_ranges(rect.left() + LETTER_WIDTH..=right, rect.y_range());
    let (named, drawn) = parts(text, open.counted().next().is_some());
    texts(ui, named, &open.options[index], size, faded);
    bars(ui, drawn, index, open, ink);
    if open.is_revealed && (is_right || is_chosen) {
        let center = rect.right_center() - vec2(0.5 * SIGN_WIDTH, 0.0);
        let sign = Rect::from_center_size(center, vec2(26.0, 26.0));
        if is_right { tick(&painter, sign, strong) } else { cross(&painter, sign, error_color(ui)) }
    }
    response.clicked()
}

/// Divides the area of an option's text between name and bars, if there are bars: one above the other or, in a
/// low option, side by side.
fn parts(text: Rect, has_bars: bool) -> (Rect, Rect) {
    if !has_bars {
        return (text, Rect::NOTHING);
    }
    let (named, drawn) = match text.height() >= BARS_BELOW {
        true => text.split_top_bottom_at_fraction(NAMED),
        false => text.split_left_right_at_fraction(BESIDE_BARS),
    };
    (named, drawn.shrink2(vec2(0.0, BETWEEN)))
}

/// Writes an option's text and, if it fits, the formula of a mistake below it.
fn texts(ui: &Ui, rect: Rect, option: &VoteOption, size: f32, faded: Option<Color32>) {
    let line = |text: &str, size: f32| marked_text::galley(ui, text, size, rect.width());
    let mut shown = vec![line(&option.text, size)];
    let mut height = shown[0].size().y;
    if let Some(mistake) = option.mistake {
        let formula = mistake.formula().split(" Right:").next().unwrap_or_default();
        let formula = line(formula, FORMULA);
        if height + formula.size().y <= rect.height() {
            height += formula.size().y;
            shown.push(formula);
        }
    }
    let mut at = pos2(rect.left(), rect.center().y - 0.5 * height);
    let painter = ui.painter_at(rect);
    for galley in shown {
        let (below, ink) = (galley.size().y, ui.visuals().strong_text_color());
        painter.add(TextShape { override_text_color: faded, ..TextShape::new(at, galley, ink) });
        at.y += below;
    }
}

/// Draws a bar for the hands of each round that were counted, with its number at its end: filled for the last
/// round, hollow for the one before. The longest of all bars takes the whole width.
fn bars(ui: &Ui, rect: Rect, index: usize, open: &OpenVote, ink: Color32) {
    let rounds: Vec<_> = open.counted().collect();
    let all = rounds.iter().flat_map(|(_, hands)| hands).copied();
    let Some(most) = all.max() else { return };
    let height = rect.height() / rounds.len() as f32;
    let font = FontId::proportional((0.8 * height).clamp(WRITTEN, COUNT));
    let room = rect.width() - text_width(ui, &format!(" {most}"), font.clone());
    for (k, (round, hands)) in rounds.iter().enumerate() {
        let count = hands[index];
        let min = rect.min + vec2(0.0, k as f32 * height);
        let length = room * count as f32 / most.max(1) as f32;
        let bar = Rect::from_min_size(min, vec2(length, height - BETWEEN));
        if count > 0 {
            let is_last = k + 1 == rounds.len();
            let fill = if is_last { ui.visuals().selection.bg_fill } else { Color32::TRANSPARENT };
            let edge = Stroke::new(1.5, ink);
            ui.painter().rect(bar, CornerRadius::ZERO, fill, edge, StrokeKind::Inside);
        }
        let text = format!(" {count}");
        ui.painter().text(bar.right_center(), Align2::LEFT_CENTER, text, font.clone(), ink);
        let row = Rect::from_min_size(min, vec2(rect.width(), height));
        let id = ui.scope_id().with(("hands", index, round));
        let name = format!("{}: {count} hands in round {}", Vote::LETTERS[index], round + 1);
        let response = ui.interact(row, id, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
    }
}

/// Shows the voting instructions or, once the answer is revealed, the reason why the right option is
/// right, in the largest text that fits.
fn reason(ui: &mut Ui, open: &OpenVote, wrong: Option<&ComparedCamera>) {
    let lines = if open.is_revealed { explanation(open, wrong) } else { vec![instructions(open)] };
    if let Some(problem) = problem(ui, open) {
        ui.label(fault_text(ui, problem).size(REASON));
        return;
    }
    ui.spacing_mut().item_spacing.y = BETWEEN;
    let room = ui.available_size();
    let fits = |size: &f32| {
        let height = |line: &String| marked_text::height_within(ui, line, *size, room.x) + BETWEEN;
        lines.iter().map(height).sum::<f32>() <= room.y
    };
    let size = largest_size(REASON, fits);
    for (k, line) in lines.iter().enumerate() {
        let text = RichText::new(line).size(size);
        ui.label(if k == 0 && open.is_revealed { text.strong() } else { text });
    }
}

fn instructions(open: &OpenVote) -> String {
    let hollow = "Filled bars are the second round, hollow ones the first. ";
    let bars = if open.counted().count() > 1 { hollow } else { "" };
    let letters = letters(open, "or");
    format!(
        "{bars}Compare it with the correct picture on its left. Vote, {letters}; then reveal it."
    )
}

/// Returns the letters of the options in words, such as `A, B, C or D`.
fn letters(open: &OpenVote, last: &str) -> String {
    let [letters @ .., end] = &Vote::LETTERS[..open.options.len()] else { return String::new() };
    format!("{} {last} {end}", letters.join(", "))
}

/// Returns the verdict, the formula, and the checks that catch the mistake.
fn explanation(open: &OpenVote, wrong: Option<&ComparedCamera>) -> Vec<String> {
    let Some(mistake) = open.options[open.right].mistake else { return Vec::new() };
    let verdict = format!("{}. {}", open.named(open.right), mistake.shows());
    let failing = wrong.into_iter().flat_map(ComparedCamera::failing);
    let catching: Vec<&str> = failing.map(|checked| checked.check.formula()).collect();
    let checks = match &catching[..] {
        [] => None,
        [one] => Some(format!("The check that catches it: {one}.")),
        many => Some(format!("The checks that catch it: {}.", many.join("; "))),
    };
    [verdict, mistake.formula().to_owned()].into_iter().chain(checks).collect()
}

/// Shows the field for the hands and the buttons: in two rows, or in one if the page is wide.
fn buttons(ui: &mut Ui, view: &mut MistakesView, can_ask: bool, is_wide: bool) {
    ui.horizontal(|ui| {
        let Some(open) = &mut view.open_vote else { return };
        hands(ui, open);
        if is_wide {
            ways_on(ui, view, can_ask);
        }
    });
    if !is_wide {
        ui.horizontal(|ui| ways_on(ui, view, can_ask));
    }
}

/// Shows the field for the hands of the current round, and the button for the next round.
fn hands(ui: &mut Ui, open: &mut OpenVote) {
    let about = format!("The hands raised for {}, drawn as bars", letters(open, "and"));
    ui.label("Hands").on_hover_text(&about);
    let field = line_field(&mut open.typed)
        .id(hands_id())
        .hint_text(Vote::LETTERS[..open.options.len()].join(", "));
    let response = ui.add_enabled(!open.is_revealed, field.desired_width(HANDS));
    let name = format!("hands in round {}", open.round + 1);
    let response = response.on_hover_text(about).named(name);
    if response.lost_focus() {
        open.count_typed();
    }
    let next = ui.add_enabled(open.has_another_round(), egui::Button::new("Second round"));
    next.on_hover_text(hint(VoteAction::NextRound)).asks(VoteAction::NextRound);
}

/// Shows the button that reveals the right option.
fn reveal(ui: &mut Ui, is_revealed: bool) {
    let reveal = egui::Button::new(RichText::new("Reveal").strong());
    let response = ui.add_enabled(!is_revealed, reveal);
    response.on_hover_text(hint(VoteAction::Reveal)).asks(VoteAction::Reveal);
}

/// Shows the buttons that reveal the right option, ask again or end the vote.
fn ways_on(ui: &mut Ui, view: &MistakesView, can_ask: bool) {
    reveal(ui, view.is_revealed());
    ui.add_enabled(can_ask, egui::Button::new("Another one")).asks(VoteAction::Another);
    ui.button("All mistakes").on_hover_text("Ends the vote").asks(VoteAction::End);
}
