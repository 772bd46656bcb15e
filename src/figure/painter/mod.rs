//! A software painter: draws egui's tessellated shapes into pixels, without a graphics driver.
//!
//! It follows the rules of egui's GPU renderer on an `Rgba8Unorm` target: colours are premultiplied and
//! blended in gamma space, a pixel is drawn if its centre is inside the shape, and clip rectangles are
//! rounded to whole pixels. A window therefore looks the same with either renderer.
//!
//! [`SoftwarePainter`] holds the textures and draws; [`Canvas`] holds the pixels of the last frame and
//! redraws only the parts that change. This file also contains rectangles of pixels and the sub-pixel grid
//! to which vertices are snapped.

use std::collections::{HashMap, HashSet};

use egui::epaint::textures::TexturesDelta;
use egui::epaint::{ClippedPrimitive, Primitive};
use egui::{Color32, Mesh, Rect, TextureId};
use rayon::prelude::*;
use texture::Texture;

pub use canvas::Canvas;
pub(crate) use texture::{Rgba, UNIT, fill, over, unpack};

mod canvas;
mod texture;
mod triangle;

/// Number of pixels below which drawing on a single thread is faster than on several.
const WORTH_SHARING: usize = 1 << 14;

/// Draws textured triangles. Keeps the textures, since egui sends each of them only once.
#[derive(Debug, Default)]
pub struct SoftwarePainter {
    textures: HashMap<TextureId, Texture>,
    triangles_only: bool,
}

impl SoftwarePainter {
    /// Creates a painter that draws every rectangle as two triangles, like a GPU. The pixels are the same,
    /// but drawing is slower. Tests compare both ways.
    pub fn triangles_only() -> Self {
        Self { triangles_only: true, ..Self::default() }
    }

    /// Stores new and changed textures, and returns their ids. Must be called before drawing.
    pub fn set_textures(&mut self, delta: &mut TexturesDelta) -> HashSet<TextureId> {
        let mut changed = HashSet::new();
        for (id, deltas) in delta.set.drain() {
            for delta in deltas {
                match (delta.pos, self.textures.get_mut(&id)) {
                    (None, _) => {
                        self.textures.insert(id, Texture::new(delta.image, delta.options));
                    }
                    (Some(region), Some(texture)) => texture.update(region, &delta),
                    (Some(_), None) => continue,
                }
                changed.insert(id);
            }
        }
        changed
    }

    /// Removes the textures that are no longer needed. Must be called after drawing.
    pub fn free_textures(&mut self, delta: &mut TexturesDelta) {
        for id in delta.free.drain() {
            self.textures.remove(&id);
        }
    }

    /// Draws over `pixels`, rows of length `size[0]` from top to bottom. Does nothing if the length of
    /// `pixels` does not match `size`.
    pub fn paint(
        &self,
        pixels: &mut [Color32],
        size: [usize; 2],
        pixels_per_point: f32,
        primitives: &[ClippedPrimitive],
    ) {
        let whole = [PixelRect::whole(size)];
        self.paint_within(pixels, size, pixels_per_point, primitives, &whole, None);
    }

    /// Draws only inside disjoint rectangles: over a background of the colour `ground` or, if that is
    /// `None`, over the existing pixels.
    pub(crate) fn paint_within(
        &self,
        pixels: &mut [Color32],
        size: [usize; 2],
        pixels_per_point: f32,
        primitives: &[ClippedPrimitive],
        rects: &[PixelRect],
        ground: Option<Color32>,
    ) {
        let rects: Vec<_> = rects.iter().map(|r| r.intersect(PixelRect::whole(size))).collect();
        let Some(all) = rects.iter().copied().reduce(PixelRect::union) else { return };
        if all.is_empty() || pixels.len() != size[0] * size[1] {
            return;
        }
        let scene = Scene::new(self, pixels_per_point, primitives, size);
        let pixels = &mut pixels[all.top * size[0]..all.bottom * size[0]];
        let rows = all.bottom - all.top;
        // There are more pieces than threads to balance the load: text is rarely distributed evenly.
        let pieces = if all.area() < WORTH_SHARING { 1 } else { 4 * rayon::current_num_threads() };
        let rows_per_piece = rows.div_ceil(pieces).max(8);
        let draw = |(piece, pixels): (usize, &mut [Color32])| {
            let top = all.top + piece * rows_per_piece;
            let bottom = top + pixels.len() / size[0];
            let whole = PixelRect { left: 0, top, right: size[0], bottom };
            let mut band = Band { pixels, width: size[0], top, clip: whole };
            for rect in &rects {
                scene.draw(&mut band, rect.intersect(whole), ground);
            }
        };
        if pieces == 1 {
            draw((0, pixels));
        } else {
            pixels.par_chunks_mut(rows_per_piece * size[0]).enumerate().for_each(draw);
        }
    }
}

/// A band of rows of the picture, and the rectangle to which drawing is limited.
struct Band<'a> {
    pixels: &'a mut [Color32],
    width: usize,
    /// The row of the picture that is the first row of `pixels`.
    top: usize,
    clip: PixelRect,
}

impl Band<'_> {
    /// Returns the pixels of a row in the columns `first..end`.
    #[inline(always)]
    fn run(&mut self, row: usize, first: usize, end: usize) -> &mut [Color32] {
        let start = (row - self.top) * self.width;
        &mut self.pixels[start + first..start + end]
    }
}

/// The meshes to draw, and other data that all pieces of the picture share.
struct Scene<'a> {
    scale: f32,
    triangles_only: bool,
    meshes: Vec<ClippedMesh<'a>>,
}

struct ClippedMesh<'a> {
    mesh: &'a Mesh,
    texture: &'a Texture,
    clip: PixelRect,
}

impl<'a> Scene<'a> {
    fn new(
        painter: &'a SoftwarePainter,
        scale: f32,
        primitives: &'a [ClippedPrimitive],
        size: [usize; 2],
    ) -> Self {
        let meshes = primitives.iter().filter_map(|primitive| {
            // Callbacks need a graphics driver, so they are skipped. The program creates none.
            let Primitive::Mesh(mesh) = &primitive.primitive else { return None };
            let texture = painter.textures.get(&mesh.texture_id)?;
            if !mesh.is_valid() || texture.texels().is_empty() {
                return None;
            }
            let extent = PixelRect::around(mesh.calc_bounds(), scale, size);
            let clip = PixelRect::scissor(primitive.clip_rect, scale, size).intersect(extent);
            (!clip.is_empty()).then_some(ClippedMesh { mesh, texture, clip })
        });
        Self { scale, triangles_only: painter.triangles_only, meshes: meshes.collect() }
    }

    fn draw(&self, band: &mut Band<'_>, rect: PixelRect, ground: Option<Color32>) {
        if rect.is_empty() {
            return;
        }
        if let Some(ground) = ground {
            for row in rect.top..rect.bottom {
                band.run(row, rect.left, rect.right).fill(ground);
            }
        }
        for mesh in &self.meshes {
            band.clip = mesh.clip.intersect(rect);
            if !band.clip.is_empty() {
                self.draw_mesh(band, mesh);
            }
        }
    }

    fn draw_mesh(&self, band: &mut Band<'_>, &ClippedMesh { mesh, texture, .. }: &ClippedMesh<'_>) {
        let (above, below) = (
            (band.clip.top as f32 - 1.0) / self.scale,
            (band.clip.bottom as f32 + 1.0) / self.scale,
        );
        let mut rest = mesh.indices.as_slice();
        while let [a, b, c, tail @ ..] = rest {
            rest = tail;
            let triangle = [a, b, c].map(|&index| &mesh.vertices[index as usize]);
            let [p, q, r] = triangle.map(|vertex| vertex.pos.y);
            // Most triangles lie in other pieces of the picture.
            if (p < above && q < above && r < above) || (p > below && q > below && r > below) {
                continue;
            }
            if let ([d, e, f, tail @ ..], false) = (tail, self.triangles_only) {
                let [d, e, f] = [d, e, f].map(|&index| &mesh.vertices[index as usize]);
                let [a, b, c] = triangle;
                if let Some(rectangle) = triangle::Rectangle::new([a, b, c, d, e, f]) {
                    rectangle.draw(band, texture, self.scale);
                    rest = tail;
                    continue;
                }
            }
            triangle::draw_triangle(band, texture, triangle, self.scale);
        }
    }
}

/// Number of sub-pixel steps per pixel to which vertices are snapped, as on GPUs. With integer coordinates,
/// the test whether a pixel's centre lies inside a triangle is exact, so adjacent triangles neither overlap
/// nor leave gaps.
const STEPS: i64 = 256;

/// Maximum coordinate of a vertex, in pixels. Coordinates are clamped to it so that their products fit
/// into an `i64`.
const FAR: f32 = 1_000_000.0;

/// A rectangle of pixels; the right and bottom edges are exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
    /// The column after the last.
    pub right: usize,
    /// The row after the last.
    pub bottom: usize,
}

impl PixelRect {
    /// Returns the rectangle that covers a whole picture.
    pub fn whole([width, height]: [usize; 2]) -> Self {
        Self { left: 0, top: 0, right: width, bottom: height }
    }

    /// Converts egui's clip rectangle to a GPU's scissor rectangle, rounded to whole pixels and clipped
    /// to the picture.
    fn scissor(clip: Rect, scale: f32, size: [usize; 2]) -> Self {
        Self::rounded(clip * scale, size, f32::round, f32::round)
    }

    /// Returns all pixels that a rectangle can touch, with a margin of one pixel on each side.
    fn around(rect: Rect, scale: f32, size: [usize; 2]) -> Self {
        Self::rounded(rect * scale, size, |x| x.floor() - 1.0, |x| x.ceil() + 1.0)
    }

    /// Rounds a rectangle in pixels and clips it to the picture.
    fn rounded(
        Rect { min, max }: Rect,
        [width, height]: [usize; 2],
        low: impl Fn(f32) -> f32,
        high: impl Fn(f32) -> f32,
    ) -> Self {
        // The cast saturates, so a negative number becomes 0.
        let to = |x: f32, limit: usize| (x as usize).min(limit);
        let (left, top) = (to(low(min.x), width), to(low(min.y), height));
        Self { left, top, right: to(high(max.x), width), bottom: to(high(max.y), height) }
    }

    /// Returns the intersection of two rectangles, which may be empty.
    pub fn intersect(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// Returns the smallest rectangle that contains both rectangles.
    pub fn union(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// Returns true if the rectangle contains no pixels.
    pub fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// Returns the number of pixels.
    pub fn area(self) -> usize {
        self.right.saturating_sub(self.left) * self.bottom.saturating_sub(self.top)
    }
}

/// Converts a coordinate in pixels to sub-pixel steps, rounded to the nearest step.
#[inline(always)]
fn snap(pixels: f32) -> i64 {
    // For a positive number, truncation equals the floor and does not call the C library.
    const SHIFT: i64 = 1 << 40;
    let steps = f64::from(pixels.clamp(-FAR, FAR)) * STEPS as f64;
    (steps + (SHIFT as f64 + 0.5)) as i64 - SHIFT
}

/// Returns the first pixel whose centre is at or after a position in sub-pixel steps.
#[inline(always)]
fn first_centre(steps: i64) -> i64 {
    (steps + STEPS / 2 - 1).div_euclid(STEPS)
}

/// Clips the range of pixels `first..end` to `from..to`.
#[inline(always)]
fn limit(first: i64, end: i64, from: usize, to: usize) -> (usize, usize) {
    let first = first.clamp(from as i64, to as i64);
    let end = end.clamp(first, to.max(from) as i64);
    (first as usize, end as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_rounds_to_the_nearest_step() {
        assert_eq!(snap(0.0), 0);
        assert_eq!(snap(1.5), 384);
        assert_eq!(snap(-1.5), -384);
        assert_eq!(snap(1.0 / 512.0), 1);
        assert_eq!(snap(-1.0 / 1024.0), 0);
        assert_eq!(snap(f32::INFINITY), 256_000_000);
    }

    #[test]
    fn centres() {
        assert_eq!(first_centre(0), 0);
        assert_eq!(first_centre(128), 0);
        assert_eq!(first_centre(129), 1);
        assert_eq!(first_centre(-129), -1);
        assert_eq!(first_centre(-127), 0);
    }

    #[test]
    fn scissors_round_and_stay_inside() {
        let clip = Rect::from_min_max(egui::pos2(-5.0, 0.4), egui::pos2(1e9, 2.5));
        let rect = PixelRect::scissor(clip, 1.0, [10, 10]);
        assert_eq!(rect, PixelRect { left: 0, top: 0, right: 10, bottom: 3 });
        assert!(PixelRect::scissor(Rect::NOTHING, 1.0, [10, 10]).is_empty());
    }
}
