//! The derivation of every number, line by line. Hovering a line highlights its concept in the
//! views, and hovering a concept in a view highlights its line.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{
    Align, Context, CornerRadius, Id, Rect, Response, RichText, ScrollArea, Sense, Tooltip, Ui,
    pos2, vec2,
};

use crate::model::concept::{Concept, HoverSource, Hovered};
use crate::model::derivation_sections::{DerivationSection, DerivationSections};
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derivation::{Derivation, Line, Markup, Section, left_out};
use crate::view::typesetting::derivation::{
    BEFORE_SECTION, BETWEEN_LINES, LaidLine, NOTE, SIZE, baseline_of, laid_line, paint,
};
use crate::view::typesetting::formula::{self, Inks};
use crate::view::typesetting::theme;

/// The derivation's layout, and its folded sections.
#[derive(Default)]
pub(crate) struct DerivationPanel {
    laid: Option<Laid>,
    folded: Vec<(DerivationSection, Option<u32>)>,
    /// The concept that the panel scrolled to last.
    scrolled_to: Option<Concept>,
}

/// All lines with their layout.
struct Laid {
    derivation: Arc<Derivation>,
    width: f32,
    per_point: f32,
    lines: Vec<Vec<LaidLine>>,
}

impl DerivationPanel {
    /// Returns the concept in the last frame's derivation that the mouse or the keyboard focus is
    /// on.
    pub(crate) fn hovered(&self, ctx: &Context) -> Option<Hovered> {
        let laid = self.laid.as_ref()?;
        let focused = ctx.memory(|memory| memory.focused());
        let (mut hovered, mut has_focus) = (None, None);
        for (section, lines) in laid.derivation.sections.iter().zip(&laid.lines) {
            for (line, laid) in section.lines.iter().zip(lines) {
                if focused == Some(laid.id) {
                    has_focus = line.concept;
                }
                if ctx.read_response(laid.id).is_some_and(|response| response.hovered()) {
                    hovered = line.concept;
                }
            }
        }
        let concept = hovered.or(has_focus)?;
        Some(Hovered { concept, by: HoverSource::Derivation })
    }

    /// Returns the panel's width when it was last shown, in points.
    pub(crate) fn width(&self) -> Option<f32> {
        self.laid.as_ref().map(|laid| laid.width)
    }

    /// Returns true if only the section's title is shown.
    pub(crate) fn is_folded(&self, section: &Section) -> bool {
        self.folded.contains(&(section.section, section.object))
    }

    /// Shows the derivation.
    pub(crate) fn ui(
        &mut self,
        ui: &mut Ui,
        derivation: &Arc<Derivation>,
        sections: &mut DerivationSections,
        hovered: Option<Hovered>,
        highlighted: Option<Concept>,
    ) {
        if !theme::installed(ui.ctx()).presenting {
            self.head(ui, derivation, sections);
        }
        // The panel scrolls only once to a concept that is hovered in a view.
        let by_view = hovered.filter(|hovered| hovered.by == HoverSource::View);
        let goal = by_view.map(|hovered| hovered.concept);
        let goal = goal.filter(|goal| self.scrolled_to != Some(*goal));
        self.scrolled_to = by_view.map(|hovered| hovered.concept);
        ScrollArea::vertical().id_salt("derivation scrolled").auto_shrink(false).show(ui, |ui| {
            self.lay_out(ui, derivation);
            ui.spacing_mut().item_spacing.y = BETWEEN_LINES;
            let inks = Inks::from_ui(ui);
            let mut goal = goal;
            for (k, section) in derivation.sections.iter().enumerate() {
                self.section(ui, k, section, inks, highlighted, &mut goal);
            }
            if derivation.left_out > 0 {
                ui.add_space(BEFORE_SECTION);
                ui.label(RichText::new(left_out(derivation.left_out)).size(NOTE));
            }
            ui.add_space(12.0);
        });
    }

    /// Shows the title, a checkbox for each section, and buttons that copy the derivation.
    fn head(&self, ui: &mut Ui, derivation: &Derivation, sections: &mut DerivationSections) {
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new("Derivation").strong().size(SIZE));
            if ui.button("Copy").named("Copy the derivation").clicked() {
                ui.ctx().copy_text(derivation.to_string());
            }
            let menu = ui.menu_button("Copy as", |ui| {
                for (name, markup) in [("LaTeX", Markup::Latex), ("Markdown", Markup::Markdown)] {
                    if ui.button(name).clicked() {
                        ui.ctx().copy_text(derivation.written_in(markup));
                    }
                }
            });
            menu.response.named("Copy the derivation as");
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

    fn lay_out(&mut self, ui: &Ui, derivation: &Arc<Derivation>) {
        let (width, per_point) = (ui.available_width(), ui.ctx().pixels_per_point());
        let known = self.laid.as_ref().is_some_and(|laid| {
            Arc::ptr_eq(&laid.derivation, derivation)
                && laid.width == width
                && laid.per_point == per_point
        });
        if known {
            return;
        }
        let lines = derivation.sections.iter().map(|section| {
            let line = |(k, line): (usize, &Line)| {
                let id = Id::unique(("derivation line", section.section, section.object, k));
                laid_line(ui, line, id, width)
            };
            section.lines.iter().enumerate().map(line).collect()
        });
        self.laid = Some(Laid {
            derivation: Arc::clone(derivation),
            width,
            per_point,
            lines: lines.collect(),
        });
    }

    fn section(
        &mut self,
        ui: &mut Ui,
        k: usize,
        section: &Section,
        inks: Inks,
        highlighted: Option<Concept>,
        goal: &mut Option<Concept>,
    ) {
        let key = (section.section, section.object);
        let is_folded = self.is_folded(section);
        let is_lit = |line: &Line| highlighted.is_some_and(|concept| line.is_about(concept));
        ui.add_space(BEFORE_SECTION);
        let head = ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            let (rect, _) = ui.allocate_exact_size(vec2(12.0, SIZE), Sense::hover());
            triangle(ui, rect.center(), is_folded);
            let title = RichText::new(&section.title).strong().size(SIZE);
            ui.add(egui::Label::new(title).selectable(false).sense(Sense::click()))
        });
        let verb = if is_folded { "Unfold" } else { "Fold" };
        let name = format!("{verb}: {}", section.title);
        let head = head.inner.with_role(Role::Button).named(name);
        if head.clicked() {
            self.folded.retain(|folded| *folded != key);
            if !is_folded {
                self.folded.push(key);
            }
        }
        if is_folded {
            if section.lines.iter().any(is_lit) {
                band(ui, head.rect);
            }
            return;
        }
        let Some(lines) = self.laid.as_ref().and_then(|laid| laid.lines.get(k)) else { return };
        for (line, laid) in section.lines.iter().zip(lines) {
            let response = show(ui, line, laid, inks, is_lit(line));
            if goal.is_some_and(|goal| line.is_about(goal)) {
                if !ui.clip_rect().contains_rect(response.rect) {
                    response.scroll_to_me(Some(Align::Center));
                }
                *goal = None;
            }
        }
    }
}

/// Draws a triangle that points down if the section is unfolded, and right if it is folded.
fn triangle(ui: &Ui, center: egui::Pos2, is_folded: bool) {
    let corners = [vec2(-5.0, -3.0), vec2(5.0, -3.0), vec2(0.0, 4.5)];
    let turned = |corner: egui::Vec2| if is_folded { vec2(corner.y, corner.x) } else { corner };
    let points = corners.map(|corner| center + turned(corner)).to_vec();
    let color = ui.visuals().text_color();
    ui.painter().add(egui::Shape::convex_polygon(points, color, egui::Stroke::NONE));
}

/// Paints the background of a highlighted line.
fn band(ui: &Ui, rect: Rect) {
    let color = ui.visuals().selection.bg_fill.gamma_multiply(0.55);
    let edge = Rect::from_min_max(rect.min, pos2(rect.left() + 4.0, rect.bottom()));
    ui.painter().rect_filled(rect, CornerRadius::same(3), color);
    ui.painter().rect_filled(edge, CornerRadius::same(2), ui.visuals().selection.stroke.color);
}

fn show(ui: &mut Ui, line: &Line, laid: &LaidLine, inks: Inks, is_lit: bool) -> Response {
    let size = vec2(ui.available_width(), laid.height);
    let (_, rect) = ui.allocate_space(size);
    // The accessible value of a plain text is the text.
    let response = ui.interact(rect, laid.id, Sense::click()).with_role(Role::Label);
    let response = response.spoken(laid.text.as_str());
    if response.clicked() {
        response.request_focus();
    }
    if is_lit {
        ui.ctx().accesskit_node_builder(laid.id, |node| node.set_description("highlighted"));
    }
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    if !ui.is_rect_visible(rect) {
        return response;
    }
    if is_lit {
        band(ui, rect);
    }
    paint(ui, rect, line, laid, inks);
    let hovered = response.hover_pos().filter(|_| response.hovered());
    let symbol = hovered
        .and_then(|at| formula::meaning_at(ui.ctx(), &laid.layout, at - baseline_of(rect, laid)));
    if let Some(words) = symbol {
        Tooltip::for_enabled(&response).at_pointer().gap(14.0).show(|ui| {
            let words = egui::Label::new(RichText::new(words).size(NOTE));
            ui.add(words.wrap_mode(egui::TextWrapMode::Extend))
        });
    }
    response
}
