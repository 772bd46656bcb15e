//! The colours that tell objects and vectors apart.

use pinhole_core::Rgb;
use pinhole_exchange::document::default_color;
use serde::{Deserialize, Serialize};

/// The greys of objects; neighbours in the list differ clearly.
const GREYS: [u8; 6] = [0xb8, 0x5c, 0xe8, 0x8a, 0x34, 0xd0];

/// A choice of colours that tell objects and vectors apart, with its name in a menu and its
/// description.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Scheme {
    /// Objects in their own colours; u, v, w by hue, as everywhere in the lecture.
    #[default]
    Standard,
    /// Colours that all kinds of colour-blind viewers tell apart, by hue and by lightness.
    ColourBlind,
    /// Greys only, for print: u, v, w differ by their dashes, heads and names.
    Grey,
}

impl Scheme {
    /// All of them, in order.
    pub const ALL: [Scheme; 3] = [Scheme::Standard, Scheme::ColourBlind, Scheme::Grey];

    /// Returns the scheme's name in a menu.
    pub fn label(self) -> &'static str {
        match self {
            Scheme::Standard => "Standard colours",
            Scheme::ColourBlind => "Colour-blind safe",
            Scheme::Grey => "Greys for print",
        }
    }

    /// Returns a description of the scheme.
    pub fn about(self) -> &'static str {
        match self {
            Scheme::Standard => "Objects in their own colours, vectors by hue",
            Scheme::ColourBlind => {
                "Colours that colour-blind viewers can tell apart; objects take them in turn"
            }
            Scheme::Grey => "Only greys; vectors differ by dashes, heads and names",
        }
    }

    /// Returns the colour of the object with this index, whose own colour is `own`. A grey object
    /// stays grey: floors and walls need not be told apart.
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
