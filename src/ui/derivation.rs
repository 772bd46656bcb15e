//! The derivation panel, which shows how the camera's vectors, the selected ray and its hits are computed,
//! line by line. Hovering a line highlights its concept (the vector, point or object that the line is about)
//! in the views, and hovering a concept in a view highlights its line. The user can drag the input numbers in
//! the formulas, or type new ones.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{
    Align, CornerRadius, Id, Rect, Response, RichText, ScrollArea, Sense, Stroke, Tooltip, Ui,
    pos2, vec2,
};
use pinhole_exchange::document::Document;
use pinhole_figure::derivation::{Derivation, DerivedLine, DerivedSection, left_out};
use pinhole_figure::formula::GivenBox;
use pinhole_figure::typesetting::derivation::{
    BEFORE_SECTION, BETWEEN_LINES, Inks, LaidLine, NOTE, SIZE, baseline_of, laid_lines, meaning_at,
    paint_line,
};
use pinhole_figure::typesetting::theme;
use pinhole_figure::{Concept, DerivationSection, Givens, HoverSource};

use crate::model::{Session, Shown, ViewLayout};
use crate::ui::PageContext;
use crate::ui::action::{Action, request};
use crate::ui::widgets::{NumberField, ResponseExt as _, is_about};

/// The derivation's layout, and what was shown of it last.
#[derive(Default)]
pub(crate) struct DerivationPanel {
    laid: Option<Laid>,
    /// The concept that the panel scrolled to last.
    scrolled_to: Option<Concept>,
    /// The number of lines that were revealed in the last egui pass; `None` if lines are not revealed one by
    /// one.
    revealed: Option<usize>,
}

/// The state while the lines are drawn from top to bottom: the inputs that all lines share, and the values
/// that drawing them updates.
struct DerivationPass<'a> {
    givens: Givens<'a>,
    inks: Inks,
    highlighted: Option<Concept>,
    /// The concept to scroll to.
    goal: Option<Concept>,
    /// The number of revealed lines; `None` if all lines are visible.
    revealed: Option<usize>,
    /// The line to scroll to.
    goal_line: Option<usize>,
    /// The number of lines shown so far.
    line: usize,
    /// True if the user can change the given numbers.
    is_editable: bool,
}

/// All lines with their layout.
struct Laid {
    derivation: Arc<Derivation>,
    width: f32,
    size: f32,
    per_point: f32,
    lines: Vec<Vec<LaidLine>>,
}

impl<'a> DerivationPass<'a> {
    fn new(ui: &Ui, document: &'a Document, session: &Session) -> DerivationPass<'a> {
        DerivationPass {
            givens: Givens {
                document,
                selection: session.shown_selection().inside(document.camera.image),
                from_one: session.shown.setup.count_from_one,
            },
            inks: Inks::from_ui(ui),
            highlighted: session.highlighted(),
            goal: None,
            revealed: session.shown.revealed_lines,
            goal_line: None,
            line: 0,
            // The numbers that an exercise gives stay as they are.
            is_editable: session.shown.setup.layout != ViewLayout::Exercises,
        }
    }
}

impl DerivationPanel {
    /// Returns the width of the panel when it was last shown, in points.
    pub(crate) fn width(&self) -> Option<f32> {
        self.laid.as_ref().map(|laid| laid.width)
    }

    /// Shows the lines of the derivation. The user can change the input numbers; each change requests an action.
    fn ui(&mut self, ui: &mut Ui, lines: &Arc<Derivation>, document: &Document, session: &Session) {
        // Scrolls only once to the line of a concept that is hovered in a view, and once to a newly revealed
        // line.
        let by_view = session.live.hovered.filter(|hovered| hovered.by == HoverSource::View);
        let goal = by_view.map(|hovered| hovered.concept);
        let goal = goal.filter(|goal| self.scrolled_to != Some(*goal));
        self.scrolled_to = by_view.map(|hovered| hovered.concept);
        let revealed = session.shown.revealed_lines;
        let is_new = std::mem::replace(&mut self.revealed, revealed) != revealed;
        let mut frame = DerivationPass {
            goal,
            goal_line: revealed.filter(|_| is_new).and_then(|count| count.checked_sub(1)),
            ..DerivationPass::new(ui, document, session)
        };
        ScrollArea::vertical().id_salt("derivation scrolled").auto_shrink(false).show(ui, |ui| {
            self.lay_out(ui, lines, SIZE);
            ui.spacing_mut().item_spacing.y = BETWEEN_LINES;
            for (k, section) in lines.sections.iter().enumerate() {
                self.section(ui, k, section, &mut frame);
            }
            let is_all = revealed.is_none_or(|count| count >= frame.line);
            if lines.left_out > 0 && is_all {
                ui.add_space(BEFORE_SECTION);
                ui.label(RichText::new(left_out(lines.left_out)).size(NOTE));
            }
            ui.add_space(12.0);
        });
    }

    fn lay_out(&mut self, ui: &Ui, derivation: &Arc<Derivation>, size: f32) {
        let (width, per_point) = (ui.available_width(), ui.ctx().pixels_per_point());
        let known = self.laid.as_ref().is_some_and(|laid| {
            Arc::ptr_eq(&laid.derivation, derivation)
                && laid.width == width
                && laid.size == size
                && laid.per_point == per_point
        });
        if known {
            return;
        }
        let id = |section: &DerivedSection, k: usize| {
            Id::unique(("derivation line", section.section, section.object, k))
        };
        let lines = laid_lines(ui, derivation, [width, size], id);
        self.laid =
            Some(Laid { derivation: Arc::clone(derivation), width, size, per_point, lines });
    }

    fn section(
        &mut self,
        ui: &mut Ui,
        k: usize,
        section: &DerivedSection,
        frame: &mut DerivationPass<'_>,
    ) {
        let is_lit =
            |line: &DerivedLine| frame.highlighted.is_some_and(|concept| line.is_about(concept));
        let is_hidden = |line: usize| frame.revealed.is_some_and(|count| line >= count);
        ui.add_space(BEFORE_SECTION);
        if is_hidden(frame.line) {
            ui.allocate_space(vec2(0.0, ui.spacing().interact_size.y));
        } else {
            let title = RichText::new(&section.title).strong().size(SIZE);
            ui.horizontal(|ui| ui.label(title));
        }
        let Some(lines) = self.laid.as_ref().and_then(|laid| laid.lines.get(k)) else { return };
        for (line, laid) in section.lines.iter().zip(lines) {
            let number = frame.line;
            frame.line += 1;
            if is_hidden(number) {
                // Space is reserved for hidden lines, so that the lines above stay in place.
                ui.allocate_space(vec2(ui.available_width(), laid.height));
                continue;
            }
            let response = show(ui, line, laid, frame, is_lit(line));
            let is_goal = frame.goal.is_some_and(|goal| line.is_about(goal));
            if is_goal {
                frame.goal = None;
            }
            if (is_goal || frame.goal_line == Some(number))
                && !ui.clip_rect().contains_rect(response.rect)
            {
                response.scroll_to_me(Some(Align::Center));
            }
        }
    }
}

/// Shows the derivation with its title and its options.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { open, session, derived, tools, .. } = context;
    let Some(lines) = &derived.derivation else { return };
    head(ui, lines, session);
    tools.derivation.ui(ui, lines, &open.document, session);
}

/// Returns the height of all lines without titles at this size and width, in points.
pub(crate) fn card_height(ui: &Ui, derivation: &Derivation, width: f32, size: f32) -> f32 {
    let laid = laid_lines(ui, derivation, [width, size], |_, _| Id::NULL);
    laid.iter().flatten().map(|laid| laid.height + BETWEEN_LINES).sum()
}

/// Shows these lines without titles and without scrolling, with the newest one lit. If they do not all fit, the
/// last ones are shown. While the step's question is open, none is shown.
pub(crate) fn card(ui: &mut Ui, context: &mut PageContext<'_>, all: &Arc<Derivation>, size: f32) {
    let PageContext { open, session, tools, .. } = context;
    tools.derivation.lay_out(ui, all, size);
    let laid = tools.derivation.laid.as_ref().filter(|_| !session.shown.is_asking);
    let Some(laid) = laid else { return };
    let frame = DerivationPass::new(ui, &open.document, session);
    let lines = all.sections.iter().flat_map(|section| &section.lines);
    let lines: Vec<(&DerivedLine, &LaidLine)> = lines.zip(laid.lines.iter().flatten()).collect();
    let shown = &lines[..frame.revealed.unwrap_or(lines.len()).min(lines.len())];
    let newest = frame.revealed.and(shown.len().checked_sub(1));
    // Of the lines about what the newest one directs to, only that one is lit, and none that the step highlights.
    let hovered = session.live.hovered.map(|hovered| hovered.concept);
    let highlighted = hovered.or(session.shown.highlighted.filter(|_| newest.is_none()));
    let mut room = ui.available_height();
    let fits = |(_, laid): &&(&DerivedLine, &LaidLine)| {
        room -= laid.height + BETWEEN_LINES;
        room >= -1.0
    };
    let first = shown.len() - shown.iter().rev().take_while(fits).count();
    ui.spacing_mut().item_spacing.y = BETWEEN_LINES;
    for (k, (line, laid)) in shown.iter().enumerate().skip(first) {
        let is_about = |concept| line.is_about(concept);
        let is_lit = newest == Some(k) || highlighted.is_some_and(is_about);
        show(ui, line, laid, &frame, is_lit);
    }
}

/// Shows the derivation's title, the choice of how numbers are written, a checkbox for each section, and a
/// button that copies the derivation. Shows nothing in presenter mode.
fn head(ui: &mut Ui, derivation: &Derivation, session: &mut Session) {
    if theme::installed(ui.ctx()).presenting {
        return;
    }
    if session.shown.before_recap.is_some() && ui.button("All lines").clicked() {
        session.shown.end_recap();
    }
    let Session { shown: Shown { sections, .. }, preferences, .. } = session;
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new("Derivation").strong().size(SIZE));
        for (exact, label, hint) in [
            (true, "Exact", "Roots and fractions where they are short, such as 1/√2"),
            (false, "Decimals", "Only decimals; ≈ where they are rounded"),
        ] {
            ui.selectable_value(&mut preferences.exact_forms, exact, label).on_hover_text(hint);
        }
        ui.separator();
        if ui.button("Copy").named("Copy the derivation").clicked() {
            ui.ctx().copy_text(derivation.to_string());
        }
    });
    ui.horizontal_wrapped(|ui| {
        for section in DerivationSection::ALL {
            let mut shown = sections.shows(section);
            let name = format!("Derivation: {}", section.label());
            if ui.checkbox(&mut shown, section.label()).named(name).changed() {
                sections.set(section, shown);
            }
        }
    });
    ui.separator();
}

/// Paints the background of a highlighted line.
fn band(ui: &Ui, rect: Rect) {
    let color = ui.visuals().selection.bg_fill.gamma_multiply(0.3);
    let edge = Rect::from_min_max(rect.min, pos2(rect.left() + 4.0, rect.bottom()));
    ui.painter().rect_filled(rect, CornerRadius::same(3), color);
    ui.painter().rect_filled(edge, CornerRadius::same(2), ui.visuals().selection.stroke.color);
}

/// Shows a line with the fields of its input numbers.
fn show(
    ui: &mut Ui,
    line: &DerivedLine,
    laid: &LaidLine,
    frame: &DerivationPass<'_>,
    is_lit: bool,
) -> Response {
    let size = vec2(ui.available_width(), laid.height);
    let (_, rect) = ui.allocate_space(size);
    // The accessible value of a plain text is the text.
    let mut response = ui.interact(rect, laid.id, Sense::click()).with_role(Role::Label);
    response = response.spoken(laid.text.as_str());
    is_about(&response, line.concept, HoverSource::Derivation);
    if response.clicked() {
        response.request_focus();
    }
    if is_lit {
        response = response.described("highlighted");
    }
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    let baseline = baseline_of(rect, laid);
    if ui.is_rect_visible(rect) {
        if is_lit {
            band(ui, rect);
        }
        paint_line(ui, rect, line, laid, frame.inks);
    }
    let hovered = response.hover_pos().filter(|_| response.hovered());
    let symbol = hovered.and_then(|at| meaning_at(ui.ctx(), &laid.layout, at - baseline));
    if let Some(words) = symbol {
        Tooltip::for_enabled(&response).show(|ui| {
            let words = egui::Label::new(RichText::new(words).size(NOTE));
            ui.add(words.wrap_mode(egui::TextWrapMode::Extend))
        });
    }
    for given in laid.layout.givens.iter().filter(|_| frame.is_editable) {
        if let Some(field) = field(ui, given, baseline, laid.size, &frame.givens) {
            is_about(&field, line.concept, HoverSource::Derivation);
        }
    }
    response
}

/// Distance between the dots of the dotted underline of an editable number, in points.
const BETWEEN_DOTS: f32 = 3.0;
/// Radius of a dot of the dotted underline of an editable number, in points.
const DOT: f32 = 0.7;

/// Shows the field of an input number over the number's digits in a formula; `baseline` is where the
/// formula's first baseline begins. An edit requests an action, which is applied before the frame is
/// presented.
fn field(
    ui: &mut Ui,
    shown: &GivenBox,
    baseline: egui::Pos2,
    size: f32,
    givens: &Givens,
) -> Option<Response> {
    let given = shown.given;
    let mut value = givens.value(given)?;
    let start = baseline + vec2(shown.at[0], shown.at[1]);
    let rect = Rect::from_min_max(
        start - vec2(0.0, shown.ascent),
        start + vec2(shown.width, shown.descent),
    );
    underline(ui, rect);
    let name = givens.name(given);
    let spoken = format!("derivation {name}");
    let mut field = NumberField { hint: &name, ..NumberField::new(&spoken, &mut value) };
    if let Some(range) = givens.whole_range(given) {
        field = NumberField { is_whole: true, range, ..field };
    }
    // A single digit is too narrow to grab.
    let rect = rect.expand2(vec2((0.5 * (size - rect.width())).max(0.0), 1.0));
    let id = Id::unique(("derivation number", given));
    let response = field.show_over(ui, id, rect, size);
    if response.changed() {
        request(ui.ctx(), Action::Give(given, value));
    }
    Some(response)
}

/// Draws a dotted line below a number, which marks the number as editable.
fn underline(ui: &Ui, rect: Rect) {
    let color = ui.visuals().weak_text_color();
    let y = rect.bottom() - 1.0;
    let dots = ((rect.width() / BETWEEN_DOTS).round() as usize).max(2);
    for k in 0..dots {
        let share = (k as f32 + 0.5) / dots as f32;
        let center = pos2(egui::lerp(rect.x_range(), share), y);
        ui.painter().circle(center, DOT, color, Stroke::NONE);
    }
}
