//! The colours that things are told apart by.

use egui::Color32;
use pinhole_core::Rgb;
use serde::{Deserialize, Serialize};

use pinhole_exchange::document::default_color;

/// Greys of objects, neighbours far apart.
const GREYS: [u8; 6] = [0xb8, 0x5c, 0xe8, 0x8a, 0x34, 0xd0];

/// Which colours things are told apart by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Scheme {
    /// Objects in their own colours; u, v, w, as everywhere in the lecture, by hue.
    #[default]
    Standard,
    /// Told apart by all kinds of colour-blind viewers: by hue and by lightness.
    ColourBlind,
    /// Greys alone, for print: u, v, w by their dashes, heads and names.
    Grey,
}

impl Scheme {
    /// All of them.
    pub const ALL: [Scheme; 3] = [Scheme::Standard, Scheme::ColourBlind, Scheme::Grey];

    /// The grey of something that is counted so: neighbours are far apart.
    pub fn grey_of(index: usize) -> Color32 {
        Color32::from_gray(GREYS[index % GREYS.len()])
    }

    /// What a menu calls it.
    pub fn label(self) -> &'static str {
        match self {
            Scheme::Standard => "Standard colours",
            Scheme::ColourBlind => "Colour-blind safe",
            Scheme::Grey => "Greys for print",
        }
    }

    /// What it does.
    pub fn about(self) -> &'static str {
        match self {
            Scheme::Standard => "Objects in their own colours, vectors by hue",
            Scheme::ColourBlind => "Colours that colour-blind viewers tell apart, objects in turn",
            Scheme::Grey => "Greys alone: vectors by dashes, heads and names",
        }
    }

    /// The colour of the object with this index whose own colour is `own`. What is grey stays so:
    /// floors and walls are no objects to be told apart.
    pub fn object(self, index: u32, own: Rgb) -> Rgb {
        let hue = own.iter().max().zip(own.iter().min()).map_or(0, |(most, least)| most - least);
        match self {
            Scheme::Standard => own,
            _ if hue < 0x18 => own,
            Scheme::ColourBlind => default_color(index as usize),
            Scheme::Grey => [GREYS[index as usize % GREYS.len()]; 3],
        }
    }
}
