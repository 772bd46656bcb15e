//! The fonts that the program's letters come from, and which letter comes from which.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock};

use egui::FontFamily;
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, GlyphId, MetadataProvider as _};

use crate::view::typesetting::fonts;

/// The fonts of plain text: the program's own, then what looks much the same.
pub(super) const SANS: &str = "Noto Sans, DejaVu Sans, Helvetica, Arial, sans-serif";

/// One of the fonts: a number that stands for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Face(usize);

struct Typeface {
    name: String,
    data: Arc<dyn AsRef<[u8]> + Send + Sync>,
}

struct Typefaces {
    all: Vec<Typeface>,
    /// The order in which the fonts of a family are asked for a letter.
    chains: HashMap<FontFamily, Vec<Face>>,
}

/// The typefaces as egui has them.
static TYPEFACES: LazyLock<Typefaces> = LazyLock::new(|| {
    let definitions = fonts::definitions();
    let mut all: Vec<Typeface> = (definitions.font_data.iter())
        .map(|(name, data)| Typeface { name: name.clone(), data: Arc::clone(&data.font) })
        .collect();
    all.sort_by(|a, b| a.name.cmp(&b.name));
    let face = |name: &String| all.iter().position(|face| face.name == *name).map(Face);
    let chains = definitions.families.iter();
    let chains = chains
        .map(|(family, names)| (family.clone(), names.iter().filter_map(face).collect()))
        .collect();
    Typefaces { all, chains }
});

impl Face {
    /// The font that a letter of this family is taken from, as egui chooses it: the first that has it.
    pub(super) fn for_letter(family: &FontFamily, letter: char) -> Face {
        let chain = TYPEFACES.chains.get(family).map(Vec::as_slice).unwrap_or_default();
        let found = chain.iter().find(|face| face.glyph(letter).is_some());
        *found.or(chain.first()).unwrap_or(&Face(0))
    }

    fn typeface(self) -> &'static Typeface {
        &TYPEFACES.all[self.0]
    }

    /// The font's file.
    pub(super) fn data(self) -> &'static [u8] {
        (*self.typeface().data).as_ref()
    }

    /// The font's file, to share.
    pub(super) fn shared(self) -> Arc<dyn AsRef<[u8]> + Send + Sync> {
        Arc::clone(&self.typeface().data)
    }

    fn font(self) -> Option<FontRef<'static>> {
        FontRef::new(self.data()).ok()
    }

    /// The glyph of a letter, if the font has one.
    pub(super) fn glyph(self, letter: char) -> Option<GlyphId> {
        self.font()?.charmap().map(letter)
    }

    /// Width of a letter, in ems.
    pub(super) fn advance(self, letter: char) -> f32 {
        let width = || {
            let font = self.font()?;
            let metrics = font.glyph_metrics(Size::new(1.0), LocationRef::default());
            metrics.advance_width(font.charmap().map(letter)?)
        };
        width().unwrap_or_default()
    }

    /// The family that style sheets know it by.
    pub(super) fn family(self) -> &'static str {
        self.typeface().name.strip_suffix(" Bold").unwrap_or(&self.typeface().name)
    }

    /// The family with what may stand in for it.
    pub(super) fn families(self) -> String {
        if SANS.starts_with(&format!("{},", self.family())) {
            return SANS.to_owned();
        }
        format!("{}, {SANS}", self.family())
    }

    /// Returns whether it is bold.
    pub(super) fn is_bold(self) -> bool {
        self.typeface().name.ends_with(" Bold")
    }
}
