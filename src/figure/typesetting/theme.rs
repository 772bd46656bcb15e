//! The look of the window: bundled fonts, font sizes, colours and the focus ring.
//!
//! The fonts are bundled so that text looks the same on every machine and the signs of the formulas (⟂,
//! ‖, ⟨, θ) are available. Vectors are written in bold, not with an arrow above (U+20D7): a letter and
//! its combining characters must come from one font, and Noto Sans lacks that arrow, so it would
//! silently be dropped. Every font except the one for code can put a circumflex on u.

use std::sync::Arc;

use egui::{
    Color32, Context, FontData, FontDefinitions, FontFamily, FontId, FontSelection, Id, Stroke,
    StrokeKind, TextStyle, Theme, Ui, Visuals,
};
use pinhole_core::Rgb;
use pinhole_exchange::document::Document;

use crate::Scheme;
use crate::overlay::Style;

/// The settings that determine the window's look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// The colour scheme.
    pub scheme: Scheme,
    /// True while presenting, when text is larger and has more contrast.
    pub presenting: bool,
    /// True if the last pointer was a finger, for which buttons and fields are larger.
    pub by_touch: bool,
    /// True if animations are turned off.
    pub reduced_motion: bool,
    /// Number of significant digits in number fields.
    pub digits: usize,
}

impl Default for Look {
    fn default() -> Look {
        Look {
            scheme: Scheme::default(),
            presenting: false,
            by_touch: false,
            reduced_motion: false,
            digits: DIGITS,
        }
    }
}

/// Number of significant digits, unless the user chooses another one.
pub const DIGITS: usize = 5;

/// Size of the smallest text in the window without zoom, in points: that of a subscript in a fraction.
pub const WRITTEN: f32 = 12.0;

/// Width of an area, in points, below which what is usually side by side is stacked.
pub const STACKED: f32 = 480.0;

/// Minimum height of buttons and fields for a finger, in points. egui accepts a press up to 5 points beside
/// them.
const FINGER: f32 = 36.0;

fn key() -> Id {
    Id::unique("look")
}

/// Returns the look that is installed in a context.
pub fn installed(ctx: &Context) -> Look {
    ctx.data(|data| data.get_temp(key())).unwrap_or_default()
}

/// Returns the style of the overlay in this window.
pub fn style(ui: &Ui) -> Style {
    Style::new(installed(ui.ctx()).scheme, ui.visuals().dark_mode)
}

/// Converts a colour to this window's style; in a grey style, it loses its hue.
pub fn finished(ui: &Ui, color: Color32) -> Color32 {
    let mut dots = [color];
    style(ui).finish(&mut dots);
    dots[0]
}

/// Returns the colour in which the window shows an object.
pub fn object_color(ui: &Ui, document: &Document, index: u32) -> Rgb {
    installed(ui.ctx()).scheme.object(index, document.color_of(index))
}

/// Returns the size of a label's text, in points.
pub fn text_size(ui: &Ui) -> f32 {
    FontSelection::Default.resolve(ui.style()).size
}

/// Makes rows of text as tall as for a mouse: they are no buttons, which a finger needs taller.
pub fn rows_of_text(ui: &mut Ui) {
    ui.spacing_mut().interact_size.y = egui::style::Spacing::default().interact_size.y;
}

/// Installs a look in a context, where it takes effect at the next pass. Does nothing if it is already
/// installed.
pub fn install(ctx: &Context, look: Look) {
    if ctx.data(|data| data.get_temp::<Look>(key())) == Some(look) {
        return;
    }
    let before = installed(ctx);
    ctx.data_mut(|data| data.insert_temp(key(), look));
    for theme in [Theme::Dark, Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            let cursor = style.visuals.text_cursor.clone();
            style.visuals = Visuals { text_cursor: cursor, ..visuals(theme, look) };
            style.text_styles = text_styles(look.presenting);
            let usual = egui::style::Spacing::default().interact_size.y;
            style.spacing.interact_size.y = if look.by_touch { FINGER } else { usual };
            // A finger that moves over a text swipes or scrolls.
            style.interaction.selectable_labels = !look.by_touch;
            if look.reduced_motion {
                style.animation_time = 0.0;
                style.scroll_animation = egui::style::ScrollAnimation::none();
            } else if before.reduced_motion {
                let usual = egui::Style::default();
                style.animation_time = usual.animation_time;
                style.scroll_animation = usual.scroll_animation;
            }
        });
    }
}

/// Returns the fonts of the text styles. While presenting, none is smaller than the size from which the
/// window's zoom is computed.
fn text_styles(presenting: bool) -> std::collections::BTreeMap<TextStyle, FontId> {
    let mut styles = egui::style::default_text_styles();
    if presenting {
        for font in styles.values_mut() {
            font.size = font.size.max(WRITTEN + 1.0);
        }
        styles.insert(TextStyle::Heading, FontId::new(19.0, FontFamily::Proportional));
    }
    styles
}

fn visuals(theme: Theme, look: Look) -> Visuals {
    let mut visuals = theme.default_visuals();
    let is_dark = theme == Theme::Dark;
    // egui's own greys are legible near the screen, but not from the back row.
    let mut text = Color32::from_gray(if is_dark { 0xea } else { 0x10 });
    visuals.weak_text_alpha = 0.75;
    visuals.disabled_alpha = 0.6;
    if look.presenting {
        let [ground, strong] = match is_dark {
            true => [Color32::BLACK, Color32::WHITE],
            false => [Color32::WHITE, Color32::BLACK],
        };
        text = strong;
        visuals.weak_text_alpha = 0.88;
        visuals.panel_fill = ground;
        visuals.window_fill = ground;
    }
    visuals.widgets.noninteractive.fg_stroke.color = text;
    visuals.widgets.inactive.fg_stroke.color = text;
    if look.scheme == Scheme::Grey {
        let (fill, edge) = if is_dark { (0x50, 0xff) } else { (0xc8, 0x00) };
        visuals.selection.bg_fill = Color32::from_gray(fill);
        visuals.selection.stroke.color = Color32::from_gray(edge);
        visuals.hyperlink_color = Color32::from_gray(edge);
    }
    visuals
}

/// Returns the colours of the focus ring and of its casing (a wider ring below it). On any background, at
/// least one of the two has enough contrast.
fn ring(visuals: &Visuals, scheme: Scheme) -> (Color32, Color32) {
    match (visuals.dark_mode, scheme) {
        (true, Scheme::Grey) => (Color32::WHITE, Color32::BLACK),
        (false, Scheme::Grey) => (Color32::BLACK, Color32::WHITE),
        (true, _) => (Color32::from_rgb(0xff, 0xd5, 0x4a), Color32::BLACK),
        (false, _) => (Color32::from_rgb(0x0b, 0x57, 0xd0), Color32::WHITE),
    }
}

/// Draws a ring around the focused widget, above everything else in its layer.
pub fn focus_ring(ui: &Ui) {
    let ctx = ui.ctx();
    let Some(focused) = ctx.memory(|memory| memory.focused()) else { return };
    let Some(response) = ctx.read_response(focused) else { return };
    let (color, casing) = ring(ui.visuals(), installed(ctx).scheme);
    // A widget that is scrolled out of sight gets no ring. At the edge of the window, the ring is moved
    // inwards.
    let visible = response.interact_rect.expand(3.0).intersect(ctx.content_rect().shrink(1.0));
    if response.interact_rect.is_negative() || !visible.is_positive() {
        return;
    }
    let painter = ctx.layer_painter(response.layer_id).with_clip_rect(ctx.content_rect());
    painter.rect_stroke(visible, 4.0, Stroke::new(4.5, casing), StrokeKind::Middle);
    painter.rect_stroke(visible, 4.0, Stroke::new(2.5, color), StrokeKind::Middle);
}

/// Returns the colour of errors, legible on the theme's background.
pub fn error_color(ui: &Ui) -> Color32 {
    if style(ui).scheme() == Scheme::Grey {
        // Without hues, only the wording marks an error.
        ui.visuals().strong_text_color()
    } else if ui.visuals().dark_mode {
        Color32::from_rgb(0xff, 0x8a, 0x70)
    } else {
        Color32::from_rgb(0xb0, 0x20, 0x00)
    }
}

/// Installs the fonts and the default look in a context, where they take effect at the next pass.
pub fn install_base(ctx: &Context) {
    install_fonts(ctx);
    install(ctx, Look::default());
}

const SANS: &str = "Noto Sans";
const SANS_BOLD: &str = "Noto Sans Bold";
const MATH: &str = "Noto Sans Math";
const HACK: &str = "Hack";

/// Returns the bold font family, to be used as `FontId::new(size, theme::bold())`.
pub fn bold() -> FontFamily {
    FontFamily::Name("bold".into())
}

/// Installs the bundled fonts in a context, where they take effect at the next pass.
pub fn install_fonts(ctx: &egui::Context) {
    ctx.set_fonts(font_definitions());
}

/// Returns the bundled fonts: Noto Sans, then Noto Sans Bold, which has Unicode's mathematical bold letters, too, so
/// that a vector looks the same in both fonts, then Noto Sans Math for signs that Noto Sans lacks, then egui's own
/// fonts where they are built in: a page has its browser's fonts instead. Code uses Hack first.
pub fn font_definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let files: [(&str, &'static [u8]); 4] = [
        (SANS, include_bytes!("../../../assets/fonts/NotoSans-Regular.ttf")),
        (SANS_BOLD, include_bytes!("../../../assets/fonts/NotoSans-Bold.ttf")),
        (MATH, include_bytes!("../../../assets/fonts/NotoSansMath-Regular.ttf")),
        (HACK, include_bytes!("../../../assets/fonts/Hack-Regular.ttf")),
    ];
    for (name, file) in files {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(file)));
    }
    let defaults = fonts.families.get(&FontFamily::Proportional).cloned().unwrap_or_default();
    let chain = |names: &[&str]| -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).chain(defaults.iter().cloned()).collect()
    };
    fonts.families.insert(bold(), chain(&[SANS_BOLD, SANS, MATH]));
    fonts.families.insert(FontFamily::Proportional, chain(&[SANS, SANS_BOLD, MATH]));
    fonts.families.insert(FontFamily::Monospace, chain(&[HACK, MATH, SANS]));
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::FontId;

    /// The signs that formulas and labels use.
    const SIGNS: &str = "→←↑↓·⟂∥‖⟨⟩×−√²₀₁₂ₓθπ°½∞≈≤≥±∓≠⁻…•𝐮𝐯𝐰𝐝𝐩𝑢𝑣𝑖𝑗𝑊𝐻\u{302}";

    #[test]
    fn every_sign_has_a_glyph_in_every_family() {
        let ctx = egui::Context::default();
        install_fonts(&ctx);
        ctx.run_ui(egui::RawInput::default(), |_| {}).drop_without_applying_deltas();
        for family in [FontFamily::Proportional, FontFamily::Monospace, bold()] {
            let font = FontId::new(14.0, family);
            let missing: String = ctx
                .fonts_mut(|fonts| SIGNS.chars().filter(|&c| !fonts.has_glyph(&font, c)).collect());
            assert_eq!(missing, "", "missing in {font:?}");
        }
    }

    #[test]
    fn text_takes_the_bundled_font_and_code_takes_hack() {
        let fonts = font_definitions();
        let first = |family: &FontFamily| fonts.families[family][0].clone();
        assert_eq!(first(&FontFamily::Proportional), SANS);
        assert_eq!(first(&bold()), SANS_BOLD);
        assert_eq!(first(&FontFamily::Monospace), HACK);
    }
}
