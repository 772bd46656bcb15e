//! The contents of the adapter's textures, for the CPU to take over.

use std::collections::HashMap;

use egui::TextureId;
use egui::epaint::textures::TexturesDelta;
use egui::epaint::{ImageDelta, TextureAtlas};

/// egui's textures, apart from that of the glyphs. egui sends each change once.
///
/// The images are shared with the app, not copied.
#[derive(Default)]
pub(super) struct Textures(HashMap<TextureId, Vec<ImageDelta>>);

/// The texture of the glyphs, which egui keeps itself.
const GLYPHS: TextureId = TextureId::Managed(0);

impl Textures {
    /// Takes note of changes that the surface is about to take out.
    pub(super) fn note(&mut self, delta: &TexturesDelta) {
        let others = delta.set.iter().filter(|(id, _)| **id != GLYPHS);
        for (id, changes) in others {
            let sent = self.0.entry(*id).or_default();
            for change in changes {
                let size = sent.first().map(|first| first.image.size());
                let mut change = change.clone();
                if change.pos == Some([0, 0]) && size == Some(change.image.size()) {
                    change.pos = None;
                }
                if change.is_whole() {
                    sent.clear();
                }
                sent.push(change);
            }
        }
        for id in &delta.free {
            self.0.remove(id);
        }
    }

    /// Returns everything that a new surface needs.
    pub(super) fn all(&self, ctx: &egui::Context) -> TexturesDelta {
        let mut all = TexturesDelta::default();
        let glyphs = ctx.fonts(|fonts| fonts.image());
        all.push(GLYPHS, ImageDelta::full(glyphs, TextureAtlas::texture_options()));
        for (id, sent) in &self.0 {
            for change in sent {
                all.push(*id, change.clone());
            }
        }
        all
    }
}
