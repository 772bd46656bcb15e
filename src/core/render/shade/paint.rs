//! Colours, the ways in which hits become colours, and tables of the sRGB transfer curve (IEC
//! 61966-2-1).

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

/// A colour as sRGB bytes: red, green, blue.
pub type Rgb = [u8; 3];

/// The colour of a pixel whose ray hits nothing.
pub const BACKGROUND: Rgb = [0xc9, 0xd3, 0xdf];

crate::texts! {
    /// A way to make a colour from a hit.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Shade[1];
    {
        /// Returns `lambert`, `normal`, `t` or `object`.
        name,
    }
    /// Lit from the eye: the object's colour times `0.15 + 0.85 |n.d| / |d|` in linear light, with the
    /// unit normal n and the ray's direction d.
    #[default]
    Lambert: "lambert";
    /// The outward normal: its x, y, z from -1..1 become red, green, blue 0..255.
    Normal: "normal";
    /// Grey, `t_min / t` with the frame's smallest `t`: the nearest hit is white.
    T: "t";
    /// The object's own colour, unlit.
    Object: "object";
}

impl Shade {
    /// Returns whether the colours depend on `t`.
    pub fn needs_t(self) -> bool {
        matches!(self, Shade::Normal | Shade::T)
    }
}

/// A way to make pixels from hits.
#[derive(Clone, Copy, Debug)]
pub struct Paint<C, F> {
    /// The way to make a colour from a hit.
    pub shade: Shade,
    /// A function `Fn(u32) -> Rgb` that returns each object's own colour.
    pub color_of: C,
    /// A function `Fn(Rgb) -> P` that converts a colour to the form of pixels.
    pub to_pixel: F,
}

/// The sRGB curve in both directions, as tables.
pub(crate) struct Srgb {
    /// Table from bytes to linear light, from 0 to [`PARTS`].
    linear: [f32; 256],
    /// Table from linear light, from 0 to [`PARTS`], to the byte whose light is nearest. At 0, where
    /// the curve is steepest, 20 entries share a byte.
    bytes: Vec<u8>,
}

/// The value that stands for the brightest linear light, that of the byte 255. Linear light is
/// measured from 0 to `PARTS`, instead of 0 to 1, so that it can index a table. `PARTS` is a power of
/// two, so that this scaling rounds nothing.
pub(crate) const PARTS: usize = 1 << 16;

static SRGB: LazyLock<Srgb> = LazyLock::new(Srgb::new);

impl Srgb {
    /// Returns the only instance.
    pub(crate) fn get() -> &'static Srgb {
        &SRGB
    }

    fn new() -> Srgb {
        let linear: [f32; 256] = std::array::from_fn(|byte| {
            let s = byte as f32 / 255.0;
            if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
        });
        let half_way: Vec<f32> = linear.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let byte_of = |light: f32| half_way.partition_point(|end| *end <= light) as u8;
        let bytes = (0..=PARTS).map(|part| byte_of(part as f32 / PARTS as f32)).collect();
        Srgb { linear: linear.map(|light| light * PARTS as f32), bytes }
    }

    /// Returns the byte's linear light, from 0 to [`PARTS`].
    #[inline(always)]
    pub(crate) fn linear_of(&self, byte: u8) -> f32 {
        self.linear[usize::from(byte)]
    }

    /// Returns the byte whose linear light is nearest to this value, from 0 to [`PARTS`]. A larger
    /// value counts as `PARTS`.
    #[inline(always)]
    pub(crate) fn byte_of(&self, linear: u32) -> u8 {
        self.bytes[(linear as usize).min(PARTS)]
    }
}
