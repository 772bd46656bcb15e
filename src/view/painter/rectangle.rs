//! Axis-aligned rectangles, which are most of egui's output: fills, glyphs, pictures.
//!
//! The result is the same, pixel for pixel, as that of the two triangles, with less work per pixel.

use egui::epaint::Vertex;
use egui::{Color32, Rect, TextureFilter, pos2};

use super::Band;
use super::blend::{self, Rgba, modulate, over, unpack};
use super::geometry::{PixelRect, STEPS, first_centre, limit, snap};
use super::texture::{Coordinate, Texture};
use super::triangle::{Plane, Reading};

/// Two triangles that make up an axis-aligned rectangle of one vertex colour, with texture
/// coordinates that run along its sides.
#[derive(Debug, PartialEq)]
pub(super) struct Rectangle {
    /// Position and size in points.
    rect: Rect,
    /// Texture coordinates at the left top and the right bottom corner.
    uv: Rect,
    color: Color32,
}

impl Rectangle {
    /// Returns the rectangle that two successive triangles make up, if they do.
    #[inline]
    pub(super) fn new(vertices: [&Vertex; 6]) -> Option<Self> {
        let [a, b, c, ..] = vertices;
        let low = pos2(a.pos.x.min(b.pos.x).min(c.pos.x), a.pos.y.min(b.pos.y).min(c.pos.y));
        let high = pos2(a.pos.x.max(b.pos.x).max(c.pos.x), a.pos.y.max(b.pos.y).max(c.pos.y));
        let size = high - low;
        if !(size.x > 0.0 && size.y > 0.0 && size.is_finite()) {
            return None;
        }
        let mut corners = [usize::MAX; 6];
        for (corner, vertex) in corners.iter_mut().zip(vertices) {
            let (x, y) = (vertex.pos.x, vertex.pos.y);
            let on_corner = (x == low.x || x == high.x) && (y == low.y || y == high.y);
            if !on_corner || vertex.color != a.color {
                return None;
            }
            *corner = usize::from(x == high.x) + 2 * usize::from(y == high.y);
        }
        let seen = |corners: &[usize]| corners.iter().fold(0, |seen, &corner| seen | 1 << corner);
        let (first, second) = (missing(seen(&corners[..3]))?, missing(seen(&corners[3..]))?);
        // Otherwise the two triangles overlap.
        if first ^ second != 3 {
            return None;
        }
        let uv = texture_corners(&vertices, &corners)?;
        Some(Self { rect: Rect::from_min_max(low, high), uv, color: a.color })
    }

    /// Draws it; `scale` is pixels per point.
    pub(super) fn draw(&self, band: &mut Band<'_>, texture: &Texture, scale: f32) {
        if self.color == Color32::TRANSPARENT {
            return;
        }
        let rect = self.rect * scale;
        let (left, right) = (snap(rect.min.x), snap(rect.max.x));
        let (top, bottom) = (snap(rect.min.y), snap(rect.max.y));
        let clip = band.clip;
        let (first, end) = limit(first_centre(left), first_centre(right), clip.left, clip.right);
        let (from, to) = limit(first_centre(top), first_centre(bottom), clip.top, clip.bottom);
        let area = PixelRect { left: first, top: from, right: end, bottom: to };
        if area.is_empty() {
            return;
        }
        let color = unpack(self.color);
        if self.uv.min == self.uv.max {
            let texel = texture.sample_at(self.uv.min, texture.filter(0.0));
            let source = modulate(color, texel);
            for row in from..to {
                blend::fill(band.run(row, first, end), source);
            }
            return;
        }
        let [width, height] = texture.size.map(|n| n as f64);
        let u = along(left, right, self.uv.min.x, self.uv.max.x, width);
        let v = along(top, bottom, self.uv.min.y, self.uv.max.y, height);
        let v = Plane { across: 0.0, down: v.across, ..v };
        draw_textured(band, area, &Reading::new(texture, u, v), color);
    }
}

/// Returns the index of the missing corner, if exactly one of four is missing.
fn missing(seen: u8) -> Option<usize> {
    (0..4).find(|corner| seen == 0b1111 & !(1 << corner))
}

/// Returns the texture coordinates of the rectangle's corners, if they run along its sides.
fn texture_corners(vertices: &[&Vertex; 6], corners: &[usize; 6]) -> Option<Rect> {
    let mut uv = Rect::NAN;
    for (vertex, corner) in vertices.iter().zip(corners) {
        let x = if corner & 1 == 0 { &mut uv.min.x } else { &mut uv.max.x };
        if !x.is_nan() && *x != vertex.uv.x {
            return None;
        }
        *x = vertex.uv.x;
        let y = if corner & 2 == 0 { &mut uv.min.y } else { &mut uv.max.y };
        if !y.is_nan() && *y != vertex.uv.y {
            return None;
        }
        *y = vertex.uv.y;
    }
    Some(uv)
}

/// Returns a texture coordinate between two positions, in texels, as a plane that varies across.
fn along(from: i64, to: i64, uv_from: f32, uv_to: f32, texels: f64) -> Plane {
    let (start, end) = (f64::from(uv_from) * texels, f64::from(uv_to) * texels);
    let step = (end - start) / (to - from).max(1) as f64;
    let origin = start + step * (STEPS as f64 / 2.0 - from as f64);
    Plane { origin, across: step * STEPS as f64, down: 0.0 }
}

/// Draws an area of a texture in one vertex colour: copied or tinted where the area shows texel for
/// pixel, as pictures and glyphs do, and else sampled.
fn draw_textured(band: &mut Band<'_>, area: PixelRect, reading: &Reading<'_>, color: Rgba) {
    let PixelRect { left, top, right, bottom } = area;
    let texture = reading.texture;
    let (u, u_step) = reading.u.stepped(0);
    let u = |column: usize| Coordinate::new(u.wrapping_add(u_step.wrapping_mul(column as i64)));
    // The plane of v has one value for each row.
    let v = |row: usize| Coordinate::new(reading.v.stepped(row).0);
    let across = one_to_one(&u, (left, right), texture.size[0], reading.filter);
    let down = one_to_one(&v, (top, bottom), texture.size[1], reading.filter);
    for row in top..bottom {
        let pixels = band.run(row, left, right);
        let (Some(across), Some(down)) = (across, down) else {
            reading.draw(pixels, row, left, |_| color);
            continue;
        };
        let start = (down + row - top) * texture.size[0] + across;
        let texels = &texture.texels()[start..start + right - left];
        if texture.opaque && color == [255.0; 4] {
            pixels.copy_from_slice(texels);
        } else {
            pixels.iter_mut().zip(texels).for_each(|(pixel, texel)| tint(pixel, *texel, color));
        }
    }
}

/// Returns the first texel if a run of pixels reads successive texels exactly, with none outside.
fn one_to_one(
    coordinate: &impl Fn(usize) -> Coordinate,
    (first, end): (usize, usize),
    size: usize,
    filter: TextureFilter,
) -> Option<usize> {
    let texel = |pixel: usize| match filter {
        TextureFilter::Nearest => Some(coordinate(pixel).nearest()),
        TextureFilter::Linear => {
            let (texel, between) = coordinate(pixel).linear();
            (between == 0.0).then_some(texel)
        }
    };
    let (from, to) = (texel(first)?, texel(end - 1)?);
    let successive = to - from == (end - 1 - first) as i64;
    // For nearest texels, both ends are not enough: the steps between may be uneven.
    let even = filter == TextureFilter::Linear
        || (first..end).all(|pixel| texel(pixel) == Some(from + (pixel - first) as i64));
    (successive && even && from >= 0 && to < size as i64).then_some(from as usize)
}

#[inline(always)]
fn tint(pixel: &mut Color32, texel: Color32, color: Rgba) {
    if texel != Color32::TRANSPARENT {
        *pixel = over(*pixel, modulate(color, unpack(texel)));
    }
}
