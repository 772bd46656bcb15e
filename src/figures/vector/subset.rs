//! A font with some of its letters, as browsers take it.

use std::collections::BTreeSet;

use skrifa::GlyphId;
use skrifa::raw::TableProvider as _;
use subsetter::GlyphRemapper;
use write_fonts::FontBuilder;
use write_fonts::read::FontRef;
use write_fonts::tables::cmap::Cmap;
use write_fonts::types::Tag;

use super::typeface::Face;

/// Tables that a font needs outside of PDF, and that the subset of one for PDF lacks. The names have
/// the licence in them.
const KEPT: [&[u8; 4]; 2] = [b"OS/2", b"name"];

/// The font's file with these letters alone.
///
/// # Errors
/// Returns an error, as a sentence, if the bytes are no font.
pub(super) fn subset(face: Face, letters: &BTreeSet<char>) -> Result<Vec<u8>, String> {
    let mut glyphs = GlyphRemapper::new();
    let mut mappings = Vec::new();
    for letter in letters {
        if let Some(glyph) =
            face.glyph(*letter).and_then(|glyph| u16::try_from(glyph.to_u32()).ok())
        {
            mappings.push((*letter, GlyphId::from(glyphs.remap(glyph))));
        }
    }
    let problem = |error: &dyn std::fmt::Display| format!("the font {}: {error}", face.family());
    let outlines = subsetter::subset(face.data(), 0, &glyphs).map_err(|error| problem(&error))?;
    let whole = FontRef::new(face.data()).map_err(|error| problem(&error))?;
    let outlines = FontRef::new(&outlines).map_err(|error| problem(&error))?;
    let cmap = Cmap::from_mappings(mappings).map_err(|error| problem(&error))?;
    let mut font = FontBuilder::new();
    font.add_table(&cmap).map_err(|error| problem(&error))?;
    for tag in KEPT.map(Tag::new) {
        if let Some(table) = whole.data_for_tag(tag) {
            font.add_raw(tag, table.as_bytes());
        }
    }
    font.add_raw(Tag::new(b"post"), nameless_post());
    Ok(font.copy_missing_tables(outlines).build())
}

/// The table `post` of a font whose glyphs have no names: version 3, and nothing else.
fn nameless_post() -> Vec<u8> {
    let mut table = vec![0; 32];
    table[1] = 3;
    table
}
