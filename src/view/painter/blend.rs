//! Colour arithmetic, as on a GPU with an `Rgba8Unorm` target and egui's blend state.

use egui::Color32;

/// Red, green, blue and alpha, premultiplied, each from 0 to 255.
pub(super) type Rgba = [f32; 4];

/// Factor from 0..=255 to 0..=1. `255.0 * UNIT` is exactly 1, so a white texel leaves a colour
/// exactly as it is.
pub(super) const UNIT: f32 = 1.0 / 255.0;

/// Adding this to a number from 0 to 255 leaves its nearest integer in the low bits of the sum.
/// Without SSE 4.1 a call of `round` would be a call into the C library, for each channel.
const ROUNDING: f32 = 12_582_912.0;

/// Unpacks a colour into numbers.
#[inline(always)]
pub(super) fn unpack(color: Color32) -> Rgba {
    let [r, g, b, a] = color.to_array();
    [f32::from(r), f32::from(g), f32::from(b), f32::from(a)]
}

/// Packs numbers into a colour: clamps them and rounds them to the nearest.
#[inline(always)]
pub(super) fn pack(color: Rgba) -> Color32 {
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 255.0) + ROUNDING).to_bits() as u8);
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// Returns the vertex colour times the texel.
#[inline(always)]
pub(super) fn modulate(color: Rgba, texel: Rgba) -> Rgba {
    [
        color[0] * (texel[0] * UNIT),
        color[1] * (texel[1] * UNIT),
        color[2] * (texel[2] * UNIT),
        color[3] * (texel[3] * UNIT),
    ]
}

/// Draws `source` over `below`: source + (1 - source alpha) * below.
#[inline(always)]
pub(super) fn over(below: Color32, source: Rgba) -> Color32 {
    let keep = 1.0 - source[3] * UNIT;
    let below = unpack(below);
    pack([
        source[0] + below[0] * keep,
        source[1] + below[1] * keep,
        source[2] + below[2] * keep,
        source[3] + below[3] * keep,
    ])
}

/// Draws one colour over a run of pixels.
pub(super) fn fill(pixels: &mut [Color32], source: Rgba) {
    if source == [0.0; 4] {
        return;
    }
    if source[3] >= 255.0 {
        pixels.fill(pack(source));
    } else {
        for pixel in pixels {
            *pixel = over(*pixel, source);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_one() {
        assert_eq!(255.0 * UNIT, 1.0);
    }

    #[test]
    fn packing_inverts_unpacking_and_saturates() {
        for byte in 0..=255 {
            let color = Color32::from_rgba_premultiplied(byte, 0, 255 - byte, byte);
            assert_eq!(pack(unpack(color)), color);
        }
        assert_eq!(
            pack([-3.0, 300.0, 0.49, 254.51]),
            Color32::from_rgba_premultiplied(0, 255, 0, 255)
        );
    }

    #[test]
    fn half_transparent_white_over_black() {
        let half = [128.0; 4];
        assert_eq!(over(Color32::BLACK, half), Color32::from_rgb(128, 128, 128));
        let expected = (128.0_f32 + 100.0 * (127.0 / 255.0)).round() as u8;
        assert_eq!(over(Color32::from_gray(100), half), Color32::from_gray(expected));
    }
}
