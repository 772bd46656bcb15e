//! Colours that tell objects and vectors apart.

use pinhole_core::Rgb;
use pinhole_exchange::document::default_color;
use serde::{Deserialize, Serialize};

/// The greys in which the objects are drawn in turn. Successive greys differ clearly.
const GREYS: [u8; 6] = [0xb8, 0x5c, 0xe8, 0x8a, 0x34, 0xd0];

pinhole_core::texts! {
    /// A colour scheme that distinguishes objects and vectors, with its label and its description.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
    pub enum Scheme[2];
    {
        /// Returns the scheme's name in a menu.
        label,
        /// Returns a description of the scheme.
        about,
    }
    /// Objects in their own colours; u, v, w in different hues, as everywhere in the lecture.
    #[default]
    Standard: "Standard colours", "Objects in their own colours, vectors by hue";
    /// Colours that viewers with any kind of colour blindness can distinguish, by hue and by
    /// lightness.
    ColourBlind: "Colour-blind safe",
        "Colours that colour-blind viewers can tell apart; objects take them in turn";
    /// Greys only, for print: u, v, w differ in their dashes, arrowheads and names.
    Grey: "Greys for print", "Only greys; vectors differ by dashes, heads and names";
}

impl Scheme {
    /// Returns the colour in which the object with this index is drawn; `own` is its colour in the scene. A
    /// grey object keeps its colour, because floors and walls need not be distinguished.
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
