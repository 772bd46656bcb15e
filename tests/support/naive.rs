//! A rasteriser that is slow and short: the rules of drawing a triangle written down pixel by
//! pixel, to compare the program's painter with.

use egui::epaint::Vertex;
use egui::{Color32, ColorImage, TextureFilter};

/// Draws a triangle, vertices in pixels, over the pixels of `canvas`; the texture is clamped at its
/// edges, and looked up `shift` texels beside where the vertices say.
pub(crate) fn draw(
    canvas: &mut ColorImage,
    texture: &ColorImage,
    filter: TextureFilter,
    shift: [f64; 2],
    t: [&Vertex; 3],
) {
    // Places in 1/256 of a pixel, as GPUs snap them; of the two orders, the one that turns right.
    let snap = |v: &Vertex| [v.pos.x, v.pos.y].map(|x| (f64::from(x) * 256.0).round());
    let mut t = t;
    if cross(snap(t[0]), snap(t[1]), snap(t[2])) < 0.0 {
        t.swap(1, 2);
    }
    let [p, q, r] = t.map(snap);
    let area = cross(p, q, r);
    if area == 0.0 {
        return;
    }
    let [width, height] = canvas.size;
    for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
        let centre = [column as f64 * 256.0 + 128.0, row as f64 * 256.0 + 128.0];
        if !(inside(p, q, centre) && inside(q, r, centre) && inside(r, p, centre)) {
            continue;
        }
        let parts = [cross(q, r, centre), cross(r, p, centre), cross(p, q, centre)];
        let mean = |value: &dyn Fn(&Vertex) -> f64| -> f64 {
            (0..3).map(|i| value(t[i]) * parts[i] / area).sum()
        };
        let [u, v] = [mean(&|v| v.uv.x.into()), mean(&|v| v.uv.y.into())];
        let [texture_width, texture_height] = texture.size.map(|n| n as f64);
        let texel =
            sample(texture, filter, u * texture_width + shift[0], v * texture_height + shift[1]);
        let source: [f64; 4] = std::array::from_fn(|channel| {
            mean(&|v| v.color.to_array()[channel].into()) * texel[channel] / 255.0
        });
        let pixel = &mut canvas[(column, row)];
        let below = pixel.to_array();
        let blended: [u8; 4] = std::array::from_fn(|channel| {
            let keep = 1.0 - source[3] / 255.0;
            (source[channel] + f64::from(below[channel]) * keep).round() as u8
        });
        let [r, g, b, a] = blended;
        *pixel = Color32::from_rgba_premultiplied(r, g, b, a);
    }
}

/// Twice the area of a triangle, positive if it turns right on a screen.
fn cross(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}

/// On the inner side of an edge; on the edge itself, if it is a left or a top one.
fn inside(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> bool {
    let side = cross(from, to, point);
    let left_or_top = to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
    side > 0.0 || (side == 0.0 && left_or_top)
}

/// Returns the colour at `x`, `y`, in texels.
fn sample(texture: &ColorImage, filter: TextureFilter, x: f64, y: f64) -> [f64; 4] {
    let [width, height] = texture.size;
    let texel = |x: f64, y: f64| {
        let x = x.clamp(0.0, width as f64 - 1.0) as usize;
        let y = y.clamp(0.0, height as f64 - 1.0) as usize;
        texture[(x, y)].to_array().map(f64::from)
    };
    if filter == TextureFilter::Nearest {
        return texel(x.floor(), y.floor());
    }
    // GPUs have eight bits for the position between two texels.
    let [x, y] = [x, y].map(|x| ((x - 0.5) * 256.0).round() / 256.0);
    let (left, top) = (x.floor(), y.floor());
    let mix = |a: [f64; 4], b: [f64; 4], part: f64| -> [f64; 4] {
        std::array::from_fn(|i| a[i] + (b[i] - a[i]) * part)
    };
    mix(
        mix(texel(left, top), texel(left + 1.0, top), x - left),
        mix(texel(left, top + 1.0), texel(left + 1.0, top + 1.0), x - left),
        y - top,
    )
}
