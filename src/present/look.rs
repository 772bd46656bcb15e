//! Fonts and the colours of text: the same in the window and in figures.

use egui::{Color32, Context, Theme, Visuals};

use super::fonts;

/// Gives a context the program's look, from its next pass on.
pub(crate) fn install(ctx: &Context) {
    fonts::install(ctx);
    for theme in [Theme::Dark, Theme::Light] {
        ctx.style_mut_of(theme, |style| style.visuals = visuals(theme));
    }
}

/// The program's colours.
pub(crate) fn visuals(theme: Theme) -> Visuals {
    let mut visuals = theme.default_visuals();
    // egui's greys are for one reader near the screen, not for the back row.
    let text = Color32::from_gray(if theme == Theme::Dark { 0xea } else { 0x10 });
    visuals.widgets.noninteractive.fg_stroke.color = text;
    visuals.widgets.inactive.fg_stroke.color = text;
    visuals.weak_text_alpha = 0.75;
    visuals
}
