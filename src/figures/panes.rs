//! Figures of what stands in the window's panels: the derivation, and the lab of lines.

use egui::{Context, Pos2, Rect, Theme, Ui, Vec2, vec2};

use super::figure::{Figure, Look};
use crate::model::lines::LinesLab;
use crate::view::derivation::{Derivation, Section};
use crate::view::headless::UiPass;
use crate::view::lines as lines_lab;
use crate::view::overlay::Style;
use crate::view::typesetting::{derivation, theme};

/// Left and right of the derivation, and above and below it, in points.
pub const MARGIN: f32 = 12.0;

/// Height that nothing set on a page reaches, in points.
const HIGHEST: f32 = 1e6;

/// The derivation, so many points wide with its margins; of a section that `is_folded` only the title.
pub(super) fn derivation(
    derivation: &Derivation,
    width: f32,
    look: Look,
    is_folded: impl Fn(&Section) -> bool,
) -> Figure {
    let column = vec2((width - 2.0 * MARGIN).max(60.0), HIGHEST);
    let column = Rect::from_min_size(Pos2::new(MARGIN, MARGIN), column);
    let mut height = 0.0;
    let mut draw = |ui: &mut Ui| height = derivation::draw(ui, derivation, column, &is_folded);
    // How high it is shows when it is drawn.
    UiPass::draw(&context(look.style), [1, 1], look.scale, &mut draw);
    let page = vec2(width, height + 2.0 * MARGIN);
    let (ctx, size) = (context(look.style), dots(page, look.scale));
    let drawn = UiPass::draw(&ctx, size, look.scale, |ui| {
        derivation::draw(ui, derivation, column, &is_folded);
    });
    let ground = ctx.style_of(egui_theme(look.style)).visuals.panel_fill;
    figure("Derivation", size, look, ground, drawn)
}

/// The lab of lines, so many points wide and high.
pub(super) fn lines(lab: &LinesLab, digits: usize, size: [f32; 2], look: Look) -> Figure {
    let ctx = context(look.style);
    let page = Rect::from_min_size(Pos2::ZERO, size.into());
    let size = dots(page.size(), look.scale);
    let drawn = UiPass::draw(&ctx, size, look.scale, |ui| {
        lines_lab::draw(ui, page, lab, digits);
    });
    figure("Lines", size, look, look.style.colors().background, drawn)
}

fn context(style: Style) -> Context {
    let ctx = Context::default();
    theme::install_base(&ctx);
    theme::install(&ctx, theme::Look::in_scheme(style.scheme()));
    ctx.set_theme(egui_theme(style));
    ctx
}

fn egui_theme(style: Style) -> Theme {
    if style.is_dark() { Theme::Dark } else { Theme::Light }
}

fn dots(points: Vec2, scale: f32) -> [usize; 2] {
    let dots = (points * scale).round().max(Vec2::splat(1.0));
    [dots.x as usize, dots.y as usize]
}

fn figure(
    title: &str,
    size: [usize; 2],
    look: Look,
    ground: egui::Color32,
    drawn: UiPass,
) -> Figure {
    Figure {
        title: title.to_owned(),
        size,
        ground: (!look.transparent).then_some(ground),
        picture: None,
        paths: Vec::new(),
        drawn,
    }
}
