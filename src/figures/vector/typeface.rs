//! The fonts that the program's letters come from, and which letter comes from which.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use egui::{FontDefinitions, FontFamily};
use skrifa::instance::{LocationRef, Size};
use skrifa::raw::TableProvider as _;
use skrifa::{FontRef, GlyphId, MetadataProvider as _};
use subsetter::GlyphRemapper;
use write_fonts::FontBuilder;
use write_fonts::tables::cmap::Cmap;
use write_fonts::types::Tag;

use crate::view::typesetting::fonts;

/// The fonts of plain text: the program's own, then what looks much the same.
pub(super) const SANS: &str = "Noto Sans, DejaVu Sans, Helvetica, Arial, sans-serif";

/// Tables that a font needs outside of PDF, and that the subset of one for PDF lacks. The names have
/// the licence in them.
const KEPT: [&[u8; 4]; 2] = [b"OS/2", b"name"];

/// The fonts as egui has them.
static FONTS: LazyLock<FontDefinitions> = LazyLock::new(fonts::definitions);

/// One of the fonts, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Face(&'static str);

impl Face {
    /// Returns the font that egui takes a letter of this family from: the first that has it.
    pub(super) fn for_letter(family: &FontFamily, letter: char) -> Face {
        let chain = FONTS.families.get(family).map(Vec::as_slice).unwrap_or_default();
        let found = chain.iter().find(|name| Face(name).glyph(letter).is_some());
        Face(found.or(chain.first()).map_or("", String::as_str))
    }

    /// Returns the font's file.
    pub(super) fn data(self) -> &'static [u8] {
        FONTS.font_data.get(self.0).map_or(&[], |data| (*data.font).as_ref())
    }

    fn font(self) -> Option<FontRef<'static>> {
        FontRef::new(self.data()).ok()
    }

    /// Returns the glyph of a letter, if the font has one.
    pub(super) fn glyph(self, letter: char) -> Option<GlyphId> {
        self.font()?.charmap().map(letter)
    }

    /// Returns the width of a letter, in ems.
    pub(super) fn advance(self, letter: char) -> f32 {
        let width = || {
            let metrics = self.font()?.glyph_metrics(Size::new(1.0), LocationRef::default());
            metrics.advance_width(self.glyph(letter)?)
        };
        width().unwrap_or_default()
    }

    /// Returns the family that style sheets know it by.
    pub(super) fn family(self) -> &'static str {
        self.0.strip_suffix(" Bold").unwrap_or(self.0)
    }

    /// Returns the family with what may stand in for it.
    pub(super) fn families(self) -> String {
        if SANS.starts_with(&format!("{},", self.family())) {
            return SANS.to_owned();
        }
        format!("{}, {SANS}", self.family())
    }

    /// Returns true if the font is bold.
    pub(super) fn is_bold(self) -> bool {
        self.0.ends_with(" Bold")
    }

    /// Returns the font's file with some of its letters alone, as browsers take it.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the bytes are no font.
    pub(super) fn subset(self, letters: &BTreeSet<char>) -> Result<Vec<u8>, String> {
        let problem = |error: &dyn std::fmt::Display| format!("the font {}: {error}", self.0);
        let mut glyphs = GlyphRemapper::new();
        let mappings = letters.iter().filter_map(|letter| {
            let glyph = u16::try_from(self.glyph(*letter)?.to_u32()).ok()?;
            Some((*letter, GlyphId::from(glyphs.remap(glyph))))
        });
        let cmap = Cmap::from_mappings(mappings).map_err(|error| problem(&error))?;
        let outlines =
            subsetter::subset(self.data(), 0, &glyphs).map_err(|error| problem(&error))?;
        let outlines = FontRef::new(&outlines).map_err(|error| problem(&error))?;
        let whole = FontRef::new(self.data()).map_err(|error| problem(&error))?;
        let mut font = FontBuilder::new();
        font.add_table(&cmap).map_err(|error| problem(&error))?;
        for tag in KEPT.map(Tag::new) {
            if let Some(table) = whole.data_for_tag(tag) {
                font.add_raw(tag, table.as_bytes());
            }
        }
        // Version 3 of the table says that glyphs have no names, and nothing else.
        font.add_raw(Tag::new(b"post"), [&[0, 3], &[0; 30][..]].concat());
        Ok(font.copy_missing_tables(outlines).build())
    }
}
