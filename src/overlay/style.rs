//! The overlay's colours.
//!
//! Hues are Okabe and Ito's (*Color Universal Design*, 2008), darkened on a light background and
//! lightened on a dark one. No two things are told apart by colour alone: u, v, w are thick and
//! have three different heads, x, y, z are thin, and all have labels.

use egui::Color32;
use serde::{Deserialize, Serialize};

/// Colours for a light or for a dark window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Style {
    /// Dark lines on a light background.
    #[default]
    Light,
    /// Light lines on a dark background.
    Dark,
}

/// The colours of one [`Style`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    /// Where the observer sees nothing.
    pub background: Color32,
    /// Behind lines and text, so that they stand out from what they cross.
    pub halo: Color32,
    /// Eye, frustum, viewport outline.
    pub ink: Color32,
    /// The u, v, w arrows.
    pub basis: [Color32; 3],
    /// The x, y, z axes.
    pub axes: [Color32; 3],
    /// The at point, and view and up.
    pub given: Color32,
    /// The selected ray and pixel.
    pub ray: Color32,
    /// The hit and its normal.
    pub hit: Color32,
    /// The marks at the image's top edge and at pixel (0, 0).
    pub mark: Color32,
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

const LIGHT: Colors = Colors {
    background: rgb(0xf4f6f9),
    halo: rgb(0xffffff),
    ink: rgb(0x2b3038),
    basis: [rgb(0xc8480a), rgb(0x00805c), rgb(0x0062a8)],
    axes: [rgb(0x8d6a5c), rgb(0x5c7a70), rgb(0x5c6e86)],
    given: rgb(0x9c4480),
    ray: rgb(0xb8004e),
    hit: rgb(0x111111),
    mark: rgb(0x7a3cc2),
};

const DARK: Colors = Colors {
    background: rgb(0x171a20),
    halo: rgb(0x0c0e11),
    ink: rgb(0xd9dee6),
    basis: [rgb(0xff8a4c), rgb(0x2fd3a0), rgb(0x6cbcf5)],
    axes: [rgb(0xb89a8e), rgb(0x8fb0a5), rgb(0x93a7c2)],
    given: rgb(0xe59cc8),
    ray: rgb(0xff5c98),
    hit: rgb(0xffffff),
    mark: rgb(0xc39bff),
};

impl Style {
    /// Its colours.
    pub fn colors(self) -> &'static Colors {
        match self {
            Style::Light => &LIGHT,
            Style::Dark => &DARK,
        }
    }
}
