//! A software painter: draws egui's tessellated shapes into pixels, without a graphics driver.
//!
//! It follows the rules of egui's GPU renderer on an `Rgba8Unorm` target: colours are premultiplied
//! and blended in gamma space, a pixel is drawn if its centre is inside, and clip rectangles are
//! rounded to whole pixels. So a window looks the same with either.
//!
//! [`Painter`] holds the textures and draws; [`Canvas`] remembers the last frame and redraws only
//! the parts that differ.

mod blend;
mod canvas;
mod geometry;
mod rectangle;
mod texture;
mod triangle;

pub use canvas::Canvas;
pub use geometry::PixelRect;

use std::collections::{HashMap, HashSet};

use egui::epaint::{ClippedPrimitive, Primitive, textures::TexturesDelta};
use egui::{Color32, Mesh, TextureId};
use rayon::prelude::*;

use texture::Texture;

/// Number of pixels below which one thread is faster than several.
const WORTH_SHARING: usize = 1 << 14;

/// Draws textured triangles. It holds the textures, which egui sends once and then refers to.
#[derive(Debug, Default)]
pub struct Painter {
    textures: HashMap<TextureId, Texture>,
    triangles_only: bool,
}

impl Painter {
    /// Creates a painter without textures.
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a painter that draws rectangles as two triangles, as a GPU does: slower, with the
    /// same pixels. For tests that compare the two.
    pub fn triangles_only() -> Self {
        Self { triangles_only: true, ..Self::default() }
    }

    /// Takes the new and changed textures, before drawing; returns their ids.
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

    /// Drops the textures that are no longer needed, after drawing.
    pub fn free_textures(&mut self, delta: &mut TexturesDelta) {
        for id in delta.free.drain() {
            self.textures.remove(&id);
        }
    }

    /// Draws over the pixels, which are rows of length `size[0]` from the top. A slice whose length
    /// does not fit `size` is left alone.
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

    /// Draws the parts inside some disjoint rectangles, over the given ground or over the pixels.
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
        // More pieces than threads, because text is seldom spread evenly.
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

/// Some rows of the picture, and the part of them that may be drawn on.
struct Band<'a> {
    pixels: &'a mut [Color32],
    width: usize,
    /// The picture's row at which `pixels` starts.
    top: usize,
    clip: PixelRect,
}

impl Band<'_> {
    /// Returns the pixels of one row from `first` to before `end`.
    #[inline(always)]
    fn run(&mut self, row: usize, first: usize, end: usize) -> &mut [Color32] {
        let start = (row - self.top) * self.width;
        &mut self.pixels[start + first..start + end]
    }
}

/// The meshes to draw, with the data that is computed once for all pieces of the picture.
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
        painter: &'a Painter,
        scale: f32,
        primitives: &'a [ClippedPrimitive],
        size: [usize; 2],
    ) -> Self {
        let meshes = primitives.iter().filter_map(|primitive| {
            // Callbacks need a graphics driver, which is absent here; the program creates none.
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
            // Most triangles are in other pieces of the picture.
            if (p < above && q < above && r < above) || (p > below && q > below && r > below) {
                continue;
            }
            if let ([d, e, f, tail @ ..], false) = (tail, self.triangles_only) {
                let [d, e, f] = [d, e, f].map(|&index| &mesh.vertices[index as usize]);
                let [a, b, c] = triangle;
                if let Some(rectangle) = rectangle::Rectangle::new([a, b, c, d, e, f]) {
                    rectangle.draw(band, texture, self.scale);
                    rest = tail;
                    continue;
                }
            }
            triangle::draw(band, texture, triangle, self.scale);
        }
    }
}
