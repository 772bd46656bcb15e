//! Textures, stored as egui sends them and sampled texel by texel; also the colour arithmetic of a GPU with
//! an `Rgba8Unorm` target and egui's blend state.

use std::sync::Arc;

use egui::epaint::{ImageData, ImageDelta};
use egui::{Color32, ColorImage, TextureFilter, TextureOptions};

/// A texture.
#[derive(Debug)]
pub(super) struct Texture {
    pub(super) size: [usize; 2],
    /// The image as egui sent it. It is shared with egui, and copied only when a part of it is replaced.
    image: Arc<ColorImage>,
    pub(super) options: TextureOptions,
}

impl Texture {
    /// Creates a texture from its whole image.
    pub(super) fn new(image: ImageData, options: TextureOptions) -> Self {
        let ImageData::Color(image) = image;
        Self { size: image.size, image, options }
    }

    /// Returns the texels, row by row from the top.
    #[inline(always)]
    pub(super) fn texels(&self) -> &[Color32] {
        &self.image.pixels
    }

    /// Replaces a part of the texture. Ignores an update that extends beyond the texture or has the wrong
    /// number of pixels: such a mistake in what egui sends should not end the program.
    pub(super) fn update(&mut self, [left, top]: [usize; 2], delta: &ImageDelta) {
        let ImageData::Color(image) = &delta.image;
        let [width, height] = image.size;
        if left + width > self.size[0]
            || top + height > self.size[1]
            || image.pixels.len() != width * height
            || width == 0
        {
            return;
        }
        self.options = delta.options;
        if image.size == self.size {
            self.image = Arc::clone(image);
            return;
        }
        let texels = &mut Arc::make_mut(&mut self.image).pixels;
        for (row, source) in image.pixels.chunks_exact(width).enumerate() {
            let start = (top + row) * self.size[0] + left;
            texels[start..start + width].copy_from_slice(source);
        }
    }

    /// Returns the filter (for minification or magnification) that a GPU would use for this number of
    /// texels per pixel.
    pub(super) fn filter(&self, texels_per_pixel: f64) -> TextureFilter {
        if texels_per_pixel > 1.0 + 1e-6 {
            self.options.minification
        } else {
            self.options.magnification
        }
    }

    /// Returns the index of the texel, or of the nearest one at the texture's edge: egui repeats no texture.
    /// `axis` is 0 for columns and 1 for rows.
    #[inline(always)]
    pub(super) fn clamped(&self, index: i64, axis: usize) -> usize {
        index.clamp(0, self.size[axis] as i64 - 1) as usize
    }

    #[inline(always)]
    fn texel(&self, across: usize, down: usize) -> Rgba {
        unpack(self.texels()[down * self.size[0] + across])
    }

    /// Returns the filtered colour at a position in texels.
    #[inline(always)]
    pub(super) fn sample(&self, u: Coordinate, v: Coordinate, filter: TextureFilter) -> Rgba {
        match filter {
            TextureFilter::Nearest => {
                self.texel(self.clamped(u.nearest(), 0), self.clamped(v.nearest(), 1))
            }
            TextureFilter::Linear => {
                let ((u, across), (v, down)) = (u.linear(), v.linear());
                let (left, right) = (self.clamped(u, 0), self.clamped(u + 1, 0));
                let (above, below) = (self.clamped(v, 1), self.clamped(v + 1, 1));
                let top = mix(self.texel(left, above), self.texel(right, above), across);
                if down == 0.0 {
                    return top;
                }
                let bottom = mix(self.texel(left, below), self.texel(right, below), across);
                mix(top, bottom, down)
            }
        }
    }

    /// Returns the filtered colour at a position in egui's texture coordinates, from 0 to 1.
    pub(super) fn sample_at(&self, uv: egui::Pos2, filter: TextureFilter) -> Rgba {
        let texel = |x: f32, axis: usize| {
            Coordinate::new((f64::from(x) * self.size[axis] as f64 * ONE_TEXEL) as i64)
        };
        self.sample(texel(uv.x, 0), texel(uv.y, 1), filter)
    }
}

/// The number 1 (one texel) in fixed point with 32 fractional bits, the format in which positions in a
/// texture are stepped along a row.
pub(super) const ONE_TEXEL: f64 = (1_u64 << 32) as f64;

/// A coordinate in a texture, in 1/65536 of a texel.
///
/// Rounding to this grid makes positions on the border between two texels consistent: they fall on the same
/// side whether they were computed from one of a rectangle's two triangles or from the whole rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Coordinate(i64);

impl Coordinate {
    /// Converts a fixed-point number with 32 fractional bits.
    #[inline(always)]
    pub(super) fn new(stepped: i64) -> Self {
        Self(stepped.wrapping_add(1 << 15) >> 16)
    }

    /// Returns the index of the texel that contains the coordinate.
    #[inline(always)]
    pub(super) fn nearest(self) -> i64 {
        self.0 >> 16
    }

    /// Returns the last texel whose centre is not after this coordinate, and how far the coordinate is from
    /// there to the next centre: a fraction in steps of 1/256, as on GPUs. It is 0 for glyphs at whole
    /// pixels.
    #[inline(always)]
    pub(super) fn linear(self) -> (i64, f32) {
        let steps = (self.0 - (1 << 15) + (1 << 7)) >> 8;
        (steps >> 8, (steps & 255) as f32 * (1.0 / 256.0))
    }
}

#[inline(always)]
fn mix(from: Rgba, to: Rgba, part: f32) -> Rgba {
    [
        from[0] + (to[0] - from[0]) * part,
        from[1] + (to[1] - from[1]) * part,
        from[2] + (to[2] - from[2]) * part,
        from[3] + (to[3] - from[3]) * part,
    ]
}

/// Returns true if all texels are opaque, so that copying them gives the same result as blending them.
pub(super) fn all_opaque(texels: &[Color32]) -> bool {
    // The bits are combined chunk by chunk so that the compiler can vectorize the loop.
    let common = |piece: &[Color32]| {
        piece.iter().fold(u32::MAX, |bits, texel| bits & u32::from_le_bytes(texel.to_array()))
    };
    texels.chunks(256).all(|piece| common(piece) >> 24 == 255)
}

/// Red, green, blue and alpha, premultiplied, each from 0 to 255.
pub(crate) type Rgba = [f32; 4];

/// Factor that converts a channel from 0..=255 to 0..=1. `255.0 * UNIT` is exactly 1, so a white texel does
/// not change the vertex colour.
pub(crate) const UNIT: f32 = 1.0 / 255.0;

/// Number that rounds: added to a number from 0 to 255, it leaves the nearest integer in the lowest bits of
/// the sum. Without SSE 4.1, `round` would call the C library for each channel.
const ROUNDING: f32 = 12_582_912.0;

/// Converts a colour to floating-point numbers.
#[inline(always)]
pub(crate) fn unpack(color: Color32) -> Rgba {
    let [r, g, b, a] = color.to_array();
    [f32::from(r), f32::from(g), f32::from(b), f32::from(a)]
}

/// Converts floating-point channels to a colour, clamped to 0..=255 and rounded to the nearest integers.
#[inline(always)]
pub(super) fn pack(color: Rgba) -> Color32 {
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 255.0) + ROUNDING).to_bits() as u8);
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// Returns the product of the vertex colour and the texel.
#[inline(always)]
pub(super) fn modulate(color: Rgba, texel: Rgba) -> Rgba {
    [
        color[0] * (texel[0] * UNIT),
        color[1] * (texel[1] * UNIT),
        color[2] * (texel[2] * UNIT),
        color[3] * (texel[3] * UNIT),
    ]
}

/// Blends `source` over `below`: source + (1 - source alpha) * below.
#[inline(always)]
pub(crate) fn over(below: Color32, source: Rgba) -> Color32 {
    let keep = 1.0 - source[3] * UNIT;
    let below = unpack(below);
    pack([
        source[0] + below[0] * keep,
        source[1] + below[1] * keep,
        source[2] + below[2] * keep,
        source[3] + below[3] * keep,
    ])
}

/// Blends a single colour over a run of pixels.
pub(crate) fn fill(pixels: &mut [Color32], source: Rgba) {
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

    fn texture(options: TextureOptions) -> Texture {
        let pixels = vec![Color32::from_gray(0), Color32::from_gray(200)];
        Texture::new(ColorImage::new([2, 1], pixels).into(), options)
    }

    #[test]
    fn linear_is_exact_on_centres_and_halfway_between() {
        let texture = texture(TextureOptions::LINEAR);
        let at = |u: f32| texture.sample_at(egui::pos2(u, 0.5), TextureFilter::Linear)[0];
        assert_eq!(at(0.25), 0.0);
        assert_eq!(at(0.5), 100.0);
        assert_eq!(at(0.75), 200.0);
        assert_eq!((at(-1.0), at(2.0)), (0.0, 200.0));
    }

    #[test]
    fn a_part_outside_is_ignored() {
        let mut texture = texture(TextureOptions::NEAREST);
        let part = ColorImage::filled([2, 1], Color32::WHITE);
        let delta = ImageDelta::partial([1, 0], part, TextureOptions::NEAREST);
        texture.update([1, 0], &delta);
        assert_eq!(texture.texels()[1], Color32::from_gray(200));
    }
}

#[cfg(test)]
mod blend_tests {
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
