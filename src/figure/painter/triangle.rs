//! Draws triangles row by row, filling the pixels whose centres lie inside.
//!
//! Most of egui's output consists of axis-aligned rectangles: fills, glyphs and pictures. [`Rectangle`]
//! draws two triangles that form a rectangle with less work per pixel and exactly the same result.

use egui::epaint::Vertex;
use egui::{Color32, Rect, TextureFilter, pos2};

use crate::painter::texture::{
    Coordinate, ONE_TEXEL, Rgba, Texture, all_opaque, fill, modulate, over, pack, unpack,
};
use crate::painter::{Band, PixelRect, STEPS, first_centre, limit, snap};

/// Position of a vertex, snapped to [`STEPS`].
type SnappedPoint = [i64; 2];

/// A linear function of the pixel position.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelPlane {
    /// Value at the centre of pixel (0, 0).
    pub(super) origin: f64,
    /// Increment per pixel to the right.
    pub(super) across: f64,
    /// Increment per pixel down.
    pub(super) down: f64,
}

impl PixelPlane {
    /// Returns the linear function that has the given values at three points. `area` is twice the area of
    /// their triangle, in square sub-pixel steps.
    fn through(points: &[SnappedPoint; 3], area: f64, values: [f64; 3]) -> Self {
        let [p, q, r] = points;
        let (qx, qy) = ((q[0] - p[0]) as f64, (q[1] - p[1]) as f64);
        let (rx, ry) = ((r[0] - p[0]) as f64, (r[1] - p[1]) as f64);
        let (to_q, to_r) = (values[1] - values[0], values[2] - values[0]);
        let across = (to_q * ry - to_r * qy) / area;
        let down = (to_r * qx - to_q * rx) / area;
        let half = STEPS as f64 / 2.0;
        let origin = values[0] + across * (half - p[0] as f64) + down * (half - p[1] as f64);
        Self { origin, across: across * STEPS as f64, down: down * STEPS as f64 }
    }

    /// Returns the value at column 0 of a row and the increment per column, both in fixed point with 32
    /// fractional bits.
    ///
    /// The result depends only on the row, not on how the picture is divided into pieces.
    #[inline(always)]
    pub(super) fn stepped(self, row: usize) -> (i64, i64) {
        let start = self.origin + self.down * row as f64;
        ((start * ONE_TEXEL) as i64, (self.across * ONE_TEXEL) as i64)
    }
}

/// Samples a texture over a triangle or a rectangle.
#[derive(Clone, Copy)]
pub(super) struct Sampling<'a> {
    pub(super) texture: &'a Texture,
    pub(super) filter: TextureFilter,
    pub(super) u: PixelPlane,
    pub(super) v: PixelPlane,
}

impl<'a> Sampling<'a> {
    /// Creates a sampling of a texture. `u` and `v` are texture coordinates in texels, as functions of the
    /// pixel.
    pub(super) fn new(texture: &'a Texture, u: PixelPlane, v: PixelPlane) -> Self {
        let texels_per_pixel = u.across.hypot(v.across).max(u.down.hypot(v.down));
        Self { texture, filter: texture.filter(texels_per_pixel), u, v }
    }

    /// Blends the texture over some pixels of a row, of which `first` is the first column. `color` returns
    /// the vertex colour at a column.
    pub(super) fn draw(
        &self,
        pixels: &mut [egui::Color32],
        row: usize,
        first: usize,
        color: impl Fn(usize) -> Rgba,
    ) {
        let ((u, u_step), (v, v_step)) = (self.u.stepped(row), self.v.stepped(row));
        for (offset, pixel) in pixels.iter_mut().enumerate() {
            let column = first + offset;
            let at = |start: i64, step: i64| {
                Coordinate::new(start.wrapping_add(step.wrapping_mul(column as i64)))
            };
            let texel = self.texture.sample(at(u, u_step), at(v, v_step), self.filter);
            if texel != [0.0; 4] {
                *pixel = over(*pixel, modulate(color(column), texel));
            }
        }
    }
}

/// One side of a triangle, as a linear function of the pixel position that is at least 0 on the inner side.
struct Side {
    /// Decrement per pixel to the right.
    slope: i64,
    /// Value at the first column of row 0.
    start: i64,
    /// Increment per row.
    per_row: i64,
}

impl Side {
    fn new(from: SnappedPoint, to: SnappedPoint) -> Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        // A pixel centre exactly on a side belongs to the triangle to its right or below it, so
        // adjacent triangles draw each pixel exactly once.
        let owned = dy < 0 || (dy == 0 && dx > 0);
        let half = STEPS / 2;
        let start = dx * (half - from[1]) - dy * (half - from[0]) - i64::from(!owned);
        Self { slope: dy * STEPS, start, per_row: dx * STEPS }
    }

    /// Narrows the range `first..end` of columns of a row to those on the inner side.
    #[inline(always)]
    fn narrow(&self, row: i64, first: &mut i64, end: &mut i64) {
        let value = self.start + self.per_row * row;
        if self.slope > 0 {
            *end = (*end).min(value.div_euclid(self.slope) + 1);
        } else if self.slope < 0 {
            *first = (*first).max(-value.div_euclid(-self.slope));
        } else if value < 0 {
            *end = *first;
        }
    }
}

/// Draws a triangle. The vertices are in points, and `scale` is in pixels per point.
pub(super) fn draw_triangle(
    band: &mut Band<'_>,
    texture: &Texture,
    vertices: [&Vertex; 3],
    scale: f32,
) {
    let Some((vertices, points, area)) = oriented(vertices, scale) else { return };
    let colors = vertices.map(|vertex| unpack(vertex.color));
    if colors == [[0.0; 4]; 3] {
        return;
    }
    let flat_color = colors[0] == colors[1] && colors[0] == colors[2];
    let [p, q, r] = vertices.map(|vertex| vertex.uv);
    if p == q && p == r {
        let texel = texture.sample_at(p, texture.filter(0.0));
        if flat_color {
            let color = modulate(colors[0], texel);
            rows(band, &points, |pixels, _, _| fill(pixels, color));
        } else {
            let gradient = Gradient::new(&points, area, colors.map(|c| modulate(c, texel)));
            rows(band, &points, |pixels, row, first| gradient.draw(pixels, row, first));
        }
        return;
    }
    let [width, height] = texture.size.map(|n| n as f64);
    let across = [p, q, r].map(|uv| f64::from(uv.x) * width);
    let down = [p, q, r].map(|uv| f64::from(uv.y) * height);
    let u = PixelPlane::through(&points, area, across);
    let v = PixelPlane::through(&points, area, down);
    let reading = Sampling::new(texture, u, v);
    if flat_color {
        rows(band, &points, |pixels, row, first| {
            reading.draw(pixels, row, first, |_| colors[0]);
        });
    } else {
        let gradient = Gradient::new(&points, area, colors);
        rows(band, &points, |pixels, row, first| {
            let at = gradient.row(row);
            reading.draw(pixels, row, first, |column| gradient.at(at, column));
        });
    }
}

/// Orders the vertices so that the area is positive. Returns the vertices, their snapped positions, and
/// twice the area. Returns `None` if the triangle has no area or if a coordinate is not finite.
fn oriented([a, b, c]: [&Vertex; 3], scale: f32) -> Option<([&Vertex; 3], [SnappedPoint; 3], f64)> {
    let sum = a.pos.to_vec2() + b.pos.to_vec2() + c.pos.to_vec2();
    if !(sum.x + sum.y).is_finite() {
        return None;
    }
    let snapped = |v: &Vertex| [snap(v.pos.x * scale), snap(v.pos.y * scale)];
    let (p, q, r) = (snapped(a), snapped(b), snapped(c));
    let area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
    match area.signum() {
        1 => Some(([a, b, c], [p, q, r], area as f64)),
        -1 => Some(([a, c, b], [p, r, q], -area as f64)),
        _ => None,
    }
}

/// Calls `draw` for each row of a triangle with the pixels inside, the row, and the first column.
fn rows(
    band: &mut Band<'_>,
    points: &[SnappedPoint; 3],
    mut draw: impl FnMut(&mut [egui::Color32], usize, usize),
) {
    let [p, q, r] = *points;
    let clip = band.clip;
    let extent = |axis: usize| {
        let (low, high) = (p[axis].min(q[axis]).min(r[axis]), p[axis].max(q[axis]).max(r[axis]));
        (first_centre(low), first_centre(high) + 1)
    };
    let (left, right) = extent(0);
    let (top, bottom) = extent(1);
    let (left, right) = limit(left, right, clip.left, clip.right);
    let (top, bottom) = limit(top, bottom, clip.top, clip.bottom);
    if left >= right {
        return;
    }
    let sides = [Side::new(p, q), Side::new(q, r), Side::new(r, p)];
    for row in top..bottom {
        let (mut first, mut end) = (left as i64, right as i64);
        for side in &sides {
            side.narrow(row as i64, &mut first, &mut end);
        }
        if first < end {
            let (first, end) = (first as usize, end as usize);
            draw(band.run(row, first, end), row, first);
        }
    }
}

/// A linearly varying colour.
struct Gradient {
    channels: [PixelPlane; 4],
    across: Rgba,
    /// The column from which a row's columns are counted. It is near the triangle, because over a long
    /// distance a steep gradient would lose significant digits.
    base: usize,
}

impl Gradient {
    fn new(points: &[SnappedPoint; 3], area: f64, colors: [Rgba; 3]) -> Self {
        let channels = [0, 1, 2, 3].map(|channel| {
            PixelPlane::through(points, area, colors.map(|color| f64::from(color[channel])))
        });
        let left = points[0][0].min(points[1][0]).min(points[2][0]);
        Self {
            channels,
            across: channels.map(|plane| plane.across as f32),
            base: (left / STEPS).max(0) as usize,
        }
    }

    /// Returns the colour at the base column of a row, not clamped to the range of colours.
    #[inline(always)]
    fn row(&self, row: usize) -> Rgba {
        self.channels.map(|plane| {
            (plane.origin + plane.down * row as f64 + plane.across * self.base as f64) as f32
        })
    }

    #[inline(always)]
    fn at(&self, row: Rgba, column: usize) -> Rgba {
        let columns = (column - self.base) as f32;
        let channel = |i: usize| (row[i] + self.across[i] * columns).clamp(0.0, 255.0);
        [channel(0), channel(1), channel(2), channel(3)]
    }

    fn draw(&self, pixels: &mut [egui::Color32], row: usize, first: usize) {
        let start = self.row(row);
        for (offset, pixel) in pixels.iter_mut().enumerate() {
            let color = self.at(start, first + offset);
            *pixel = if color[3] >= 255.0 { pack(color) } else { over(*pixel, color) };
        }
    }
}

/// Two triangles that form an axis-aligned rectangle of a single vertex colour, with texture
/// coordinates that are linear along its sides.
#[derive(Debug, PartialEq)]
pub(super) struct Rectangle {
    /// Position and size in points.
    rect: Rect,
    /// Texture coordinates at the upper left and at the lower right corner.
    uv: Rect,
    color: Color32,
}

impl Rectangle {
    /// Returns the rectangle formed by two successive triangles; `None` if they do not form one.
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
        let bits = |corners: &[usize]| corners.iter().fold(0, |bits, &corner| bits | 1 << corner);
        let (first, second) = (missing(bits(&corners[..3]))?, missing(bits(&corners[3..]))?);
        // Otherwise the two triangles would overlap.
        if first ^ second != 3 {
            return None;
        }
        let uv = texture_corners(&vertices, &corners)?;
        Some(Self { rect: Rect::from_min_max(low, high), uv, color: a.color })
    }

    /// Draws the rectangle; `scale` is in pixels per point.
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
                fill(band.run(row, first, end), source);
            }
            return;
        }
        let [width, height] = texture.size.map(|n| n as f64);
        let u = along(left, right, self.uv.min.x, self.uv.max.x, width);
        let v = along(top, bottom, self.uv.min.y, self.uv.max.y, height);
        let v = PixelPlane { across: 0.0, down: v.across, ..v };
        draw_textured(band, area, &Sampling::new(texture, u, v), color);
    }
}

/// Returns the index of the only corner whose bit is not set; `None` unless exactly one is missing.
fn missing(bits: u8) -> Option<usize> {
    (0..4).find(|corner| bits == 0b1111 & !(1 << corner))
}

/// Returns the texture coordinates of a rectangle's corners; `None` unless u depends only on x and v only
/// on y.
fn texture_corners(vertices: &[&Vertex; 6], corners: &[usize; 6]) -> Option<Rect> {
    let mut uv = Rect::NAN;
    for (vertex, corner) in vertices.iter().zip(corners) {
        let x = if corner & 1 == 0 { &mut uv.min.x } else { &mut uv.max.x };
        let y = if corner & 2 == 0 { &mut uv.min.y } else { &mut uv.max.y };
        for (known, own) in [(x, vertex.uv.x), (y, vertex.uv.y)] {
            if !known.is_nan() && *known != own {
                return None;
            }
            *known = own;
        }
    }
    Some(uv)
}

/// Returns a texture coordinate, in texels, as a linear function of the column. It is `uv_from` at the
/// position `from` and `uv_to` at the position `to`, which are in sub-pixel steps.
fn along(from: i64, to: i64, uv_from: f32, uv_to: f32, texels: f64) -> PixelPlane {
    let (start, end) = (f64::from(uv_from) * texels, f64::from(uv_to) * texels);
    let step = (end - start) / (to - from).max(1) as f64;
    let origin = start + step * (STEPS as f64 / 2.0 - from as f64);
    PixelPlane { origin, across: step * STEPS as f64, down: 0.0 }
}

/// Draws a rectangle of pixels with a texture and a single vertex colour. If each pixel shows exactly one
/// texel, as in most pictures and glyphs, the texels are copied or tinted; otherwise the texture is
/// sampled.
fn draw_textured(band: &mut Band<'_>, area: PixelRect, reading: &Sampling<'_>, color: Rgba) {
    let PixelRect { left, top, right, bottom } = area;
    let texture = reading.texture;
    let (u, u_step) = reading.u.stepped(0);
    let u = |column: usize| Coordinate::new(u.wrapping_add(u_step.wrapping_mul(column as i64)));
    // v is constant along a row.
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
        if color == [255.0; 4] && all_opaque(texels) {
            pixels.copy_from_slice(texels);
        } else {
            pixels.iter_mut().zip(texels).for_each(|(pixel, texel)| tint(pixel, *texel, color));
        }
    }
}

/// Returns the texel that the first of successive pixels reads. Returns `None` unless each pixel reads
/// exactly the texel after the previous one and all of these lie inside the texture.
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
    // With the nearest filter, texels may be skipped and repeated, so checking the two ends is not enough.
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
