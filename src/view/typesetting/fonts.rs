//! The bundled fonts: text looks the same on every machine, and the formulas' signs (⟂, ‖, ⟨, θ)
//! are available.
//!
//! Vectors are written in bold, not with an arrow above (U+20D7): a letter and its combining
//! characters come from one font, and Noto Sans has no such arrow, so it would silently be left
//! out. The circumflex of û exists in all fonts except the one for code.

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily};

/// Name of the bold family.
const BOLD: &str = "bold";

const SANS: &str = "Noto Sans";
const SANS_BOLD: &str = "Noto Sans Bold";
const MATH: &str = "Noto Sans Math";

/// Returns the bold variant of the proportional family, for `FontId::new(size, fonts::bold())`.
pub fn bold() -> FontFamily {
    FontFamily::Name(BOLD.into())
}

/// Installs the bundled fonts in a context, from its next pass on.
pub fn install(ctx: &egui::Context) {
    ctx.set_fonts(definitions());
}

/// Returns the bundled fonts: Noto Sans, Noto Sans Math for signs that it lacks, then egui's own
/// fonts; for code Hack first, as in egui.
pub fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let files: [(&str, &'static [u8]); 3] = [
        (SANS, include_bytes!("../../../assets/fonts/NotoSans-Regular.ttf")),
        (SANS_BOLD, include_bytes!("../../../assets/fonts/NotoSans-Bold.ttf")),
        (MATH, include_bytes!("../../../assets/fonts/NotoSansMath-Regular.ttf")),
    ];
    for (name, file) in files {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(file)));
    }
    let defaults = fonts.families.get(&FontFamily::Proportional).cloned().unwrap_or_default();
    let chain = |names: &[&str]| -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).chain(defaults.iter().cloned()).collect()
    };
    fonts.families.insert(bold(), chain(&[SANS_BOLD, SANS, MATH]));
    fonts.families.insert(FontFamily::Proportional, chain(&[SANS, MATH]));
    let monospace = fonts.families.entry(FontFamily::Monospace).or_default();
    let after_first = monospace.len().min(1);
    monospace.splice(after_first..after_first, [MATH.to_owned(), SANS.to_owned()]);
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::FontId;

    /// The signs that formulas and labels use.
    const SIGNS: &str = "→←↑↓·⟂∥‖⟨⟩×−√²₀₁₂ₓθπ°½∞≈≤≥±≠⁻…•𝐮𝐯𝐰𝐝𝐩𝑢𝑣𝑖𝑗𝑊𝐻\u{302}";

    #[test]
    fn every_sign_has_a_glyph_in_every_family() {
        let ctx = egui::Context::default();
        install(&ctx);
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
        let fonts = definitions();
        let first = |family: &FontFamily| fonts.families[family][0].clone();
        assert_eq!(first(&FontFamily::Proportional), SANS);
        assert_eq!(first(&bold()), SANS_BOLD);
        assert_eq!(first(&FontFamily::Monospace), "Hack");
    }
}
