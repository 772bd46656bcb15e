//! Tables of the sRGB transfer curve (IEC 61966-2-1).

use std::sync::LazyLock;

/// The curve both ways.
pub(crate) struct Srgb {
    /// Byte to linear light, in [parts](PARTS).
    linear: [f32; 256],
    /// The curve from parts to the byte nearest in linear light. Where the curve is steepest, at 0,
    /// a byte has 20 parts.
    bytes: Vec<u8>,
}

/// Full light. A power of two, so that light in parts has the digits of light in parts of 1.
pub(crate) const PARTS: usize = 1 << 16;

static SRGB: LazyLock<Srgb> = LazyLock::new(Srgb::new);

impl Srgb {
    /// The only one.
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

    /// The byte's light, in parts.
    #[inline(always)]
    pub(crate) fn linear_of(&self, byte: u8) -> f32 {
        self.linear[usize::from(byte)]
    }

    /// The byte of so much light, in parts; at most full light.
    #[inline(always)]
    pub(crate) fn byte_of(&self, linear: u32) -> u8 {
        self.bytes[(linear as usize).min(PARTS)]
    }
}
