//! General triangles: row by row, the pixels whose centres are inside.

use egui::TextureFilter;
use egui::epaint::Vertex;

use super::Band;
use super::blend::{self, Rgba, modulate, over, pack, unpack};
use super::geometry::{STEPS, limit, snap};
use super::texture::{Coordinate, ONE_TEXEL, Texture};

/// Position of a vertex, snapped to [`STEPS`].
type SnappedPoint = [i64; 2];

/// A linear function over the pixels: its value at the centre of pixel (0, 0), and its increments
/// per pixel to the right and down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// Value at the centre of pixel (0, 0).
    pub(super) origin: f64,
    /// Increment per pixel to the right.
    pub(super) across: f64,
    /// Increment per pixel down.
    pub(super) down: f64,
}

impl Plane {
    /// Returns the plane through three values at three positions; `area` is twice the triangle's,
    /// in square steps.
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

    /// Returns the value at a row's first pixel, and the step to the next, with 32 binary places.
    ///
    /// The result depends on the row alone, not on how the picture is divided into pieces.
    #[inline(always)]
    pub(super) fn stepped(self, row: usize) -> (i64, i64) {
        let start = self.origin + self.down * row as f64;
        ((start * ONE_TEXEL) as i64, (self.across * ONE_TEXEL) as i64)
    }
}

/// The sampling of a texture over a triangle or rectangle.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a> {
    pub(super) texture: &'a Texture,
    pub(super) filter: TextureFilter,
    pub(super) u: Plane,
    pub(super) v: Plane,
}

impl<'a> Reading<'a> {
    /// Creates a reading; `u` and `v` are in texels.
    pub(super) fn new(texture: &'a Texture, u: Plane, v: Plane) -> Self {
        let texels_per_pixel = u.across.hypot(v.across).max(u.down.hypot(v.down));
        Self { texture, filter: texture.filter(texels_per_pixel), u, v }
    }

    /// Blends a run of pixels of one row; `color` returns the vertex colour at a column.
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

/// One side of a triangle, as a function of the pixel that is not negative inside.
struct Side {
    /// Decrement per pixel to the right.
    slope: i64,
    /// Value at the first column in row 0, and the increment per row.
    start: i64,
    per_row: i64,
}

impl Side {
    fn new(from: SnappedPoint, to: SnappedPoint) -> Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        // A centre exactly on a side belongs to the triangle on the right of it or below, so that
        // neighbours draw each pixel exactly once.
        let owned = dy < 0 || (dy == 0 && dx > 0);
        let half = STEPS / 2;
        let start = dx * (half - from[1]) - dy * (half - from[0]) - i64::from(!owned);
        Self { slope: dy * STEPS, start, per_row: dx * STEPS }
    }

    /// Narrows a range of columns to the inner side.
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

/// Draws a triangle; vertices are in points, `scale` is pixels per point.
pub(super) fn draw(band: &mut Band<'_>, texture: &Texture, vertices: [&Vertex; 3], scale: f32) {
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
            rows(band, &points, |pixels, _, _| blend::fill(pixels, color));
        } else {
            let gradient = Gradient::new(&points, area, colors.map(|c| modulate(c, texel)));
            rows(band, &points, |pixels, row, first| gradient.draw(pixels, row, first));
        }
        return;
    }
    let [width, height] = texture.size.map(|n| n as f64);
    let across = [p, q, r].map(|uv| f64::from(uv.x) * width);
    let down = [p, q, r].map(|uv| f64::from(uv.y) * height);
    let u = Plane::through(&points, area, across);
    let v = Plane::through(&points, area, down);
    let reading = Reading::new(texture, u, v);
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

/// Returns the vertices ordered so that the area is positive, their snapped positions, and twice
/// the area; `None` for a triangle without area or with a coordinate that is not a number.
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

/// Calls `draw` with the inside pixels of each row, the row, and their first column.
fn rows(
    band: &mut Band<'_>,
    points: &[SnappedPoint; 3],
    mut draw: impl FnMut(&mut [egui::Color32], usize, usize),
) {
    let [p, q, r] = *points;
    let clip = band.clip;
    let extent = |axis: usize| {
        let (low, high) = (p[axis].min(q[axis]).min(r[axis]), p[axis].max(q[axis]).max(r[axis]));
        (super::geometry::first_centre(low), super::geometry::first_centre(high) + 1)
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
    channels: [Plane; 4],
    across: Rgba,
    /// The column from which a row's colours are counted. It is near the triangle: far from it, a
    /// steep gradient would lose significant digits.
    base: usize,
}

impl Gradient {
    fn new(points: &[SnappedPoint; 3], area: f64, colors: [Rgba; 3]) -> Self {
        let channels = [0, 1, 2, 3].map(|channel| {
            Plane::through(points, area, colors.map(|color| f64::from(color[channel])))
        });
        let left = points[0][0].min(points[1][0]).min(points[2][0]);
        Self {
            channels,
            across: channels.map(|plane| plane.across as f32),
            base: (left / STEPS).max(0) as usize,
        }
    }

    /// Returns the colour at the base column of a row.
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
