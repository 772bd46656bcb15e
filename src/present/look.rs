//! Fonts and the colours of text: the same in the window and in figures.

use egui::{Color32, Context, Theme};

use super::fonts;

/// Gives a context the program's look, from its next pass on.
pub(crate) fn install(ctx: &Context) {
    fonts::install(ctx);
    // egui's greys are for one reader near the screen, not for the back row.
    for (theme, text) in [(Theme::Dark, 0xea), (Theme::Light, 0x10)] {
        ctx.style_mut_of(theme, |style| {
            let visuals = &mut style.visuals;
            visuals.widgets.noninteractive.fg_stroke.color = Color32::from_gray(text);
            visuals.widgets.inactive.fg_stroke.color = Color32::from_gray(text);
            visuals.weak_text_alpha = 0.75;
        });
    }
}
