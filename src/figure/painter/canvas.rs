//! The pixels of the window, and how a new frame changes them.

use std::collections::HashSet;

use egui::epaint::{ClippedPrimitive, Primitive, Vertex};
use egui::{Color32, Mesh, Rect, TextureId};

use super::{PixelRect, SoftwarePainter};

/// Maximum number of rectangles that are redrawn separately. More of them would cost more to draw than the
/// whole picture.
const MANY: usize = 16;

/// The pixels of the window, and the frame that they show.
///
/// Of a new frame, only the parts that differ from the last frame are drawn. If the pointer moves over a
/// button, only the button is redrawn.
#[derive(Debug, Default)]
pub struct Canvas {
    pixels: Vec<Color32>,
    size: [usize; 2],
    shown: Option<ShownFrame>,
}

/// The inputs from which the pixels were drawn, except for the textures.
#[derive(Debug)]
struct ShownFrame {
    primitives: Vec<ClippedPrimitive>,
    pixels_per_point: f32,
    ground: Color32,
}

impl Canvas {
    /// Returns the pixels, row by row from the top.
    pub fn pixels(&self) -> &[Color32] {
        &self.pixels
    }

    /// Returns width and height in pixels.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Draws a frame on an opaque background. Returns the rectangles in which pixels may have changed.
    ///
    /// `changed` contains the textures that were set since the last call.
    pub fn show(
        &mut self,
        painter: &SoftwarePainter,
        changed: &HashSet<TextureId>,
        size: [usize; 2],
        pixels_per_point: f32,
        ground: Color32,
        primitives: Vec<ClippedPrimitive>,
    ) -> Vec<PixelRect> {
        let frame = ShownFrame { primitives, pixels_per_point, ground };
        let whole = PixelRect::whole(size);
        let rects = match &self.shown {
            Some(last) if self.size == size => last.difference(&frame, changed, size),
            _ => None,
        }
        .unwrap_or_else(|| vec![whole]);
        if self.size != size {
            self.size = size;
            self.pixels.resize(size[0] * size[1], ground);
        }
        painter.paint_within(
            &mut self.pixels,
            size,
            pixels_per_point,
            &frame.primitives,
            &rects,
            Some(ground),
        );
        self.shown = Some(frame);
        rects
    }
}

impl ShownFrame {
    /// Returns disjoint rectangles that contain all differences between two frames; `None` if the whole
    /// picture must be redrawn. `changed` are the textures that were set between them.
    fn difference(
        &self,
        new: &Self,
        changed: &HashSet<TextureId>,
        size: [usize; 2],
    ) -> Option<Vec<PixelRect>> {
        if self.pixels_per_point != new.pixels_per_point || self.ground != new.ground {
            return None;
        }
        let mut areas = ChangedAreas { rects: Vec::new(), scale: new.pixels_per_point, size };
        let (old, new) = (self.primitives.as_slice(), new.primitives.as_slice());
        let shared = old.len().min(new.len());
        let (start, end) = if old.len() == new.len() {
            (shared, 0)
        } else {
            let start = old.iter().zip(new).take_while(|(a, b)| same(a, b)).count();
            let ends = old.iter().rev().zip(new.iter().rev());
            (start, ends.take(shared - start).take_while(|(a, b)| same(a, b)).count())
        };
        for primitive in old[start..old.len() - end].iter().chain(&new[start..new.len() - end]) {
            areas.add(primitive.clip_rect, bounds(primitive));
        }
        for (old, new) in old[..start].iter().zip(new) {
            areas.compare(old, new);
        }
        for primitive in new {
            if texture(primitive).is_some_and(|id| changed.contains(&id)) {
                areas.add(primitive.clip_rect, bounds(primitive));
            }
        }
        areas.disjoint()
    }
}

fn same(a: &ClippedPrimitive, b: &ClippedPrimitive) -> bool {
    match (&a.primitive, &b.primitive) {
        (Primitive::Mesh(p), Primitive::Mesh(q)) => a.clip_rect == b.clip_rect && p == q,
        _ => false,
    }
}

fn bounds(primitive: &ClippedPrimitive) -> Rect {
    match &primitive.primitive {
        Primitive::Mesh(mesh) => mesh.calc_bounds(),
        Primitive::Callback(callback) => callback.rect,
    }
}

fn texture(primitive: &ClippedPrimitive) -> Option<TextureId> {
    match &primitive.primitive {
        Primitive::Mesh(mesh) => Some(mesh.texture_id),
        Primitive::Callback(_) => None,
    }
}

/// The areas in which two frames are known to differ.
struct ChangedAreas {
    rects: Vec<PixelRect>,
    scale: f32,
    size: [usize; 2],
}

impl ChangedAreas {
    fn add(&mut self, clip: Rect, bounds: Rect) {
        let clip = PixelRect::scissor(clip, self.scale, self.size);
        let rect = clip.intersect(PixelRect::around(bounds, self.scale, self.size));
        if !rect.is_empty() {
            self.rects.push(rect);
        }
    }

    /// Adds the area in which a primitive of the new frame differs from the old frame's primitive at the
    /// same index.
    fn compare(&mut self, old: &ClippedPrimitive, new: &ClippedPrimitive) {
        if same(old, new) {
            return;
        }
        match (&old.primitive, &new.primitive) {
            (Primitive::Mesh(a), Primitive::Mesh(b))
                if old.clip_rect == new.clip_rect && a.texture_id == b.texture_id =>
            {
                self.add(new.clip_rect, changed_triangles(a, b));
            }
            _ => {
                self.add(old.clip_rect, bounds(old));
                self.add(new.clip_rect, bounds(new));
            }
        }
    }

    /// Merges overlapping rectangles. Returns `None` if it is better to redraw the whole picture.
    fn disjoint(mut self) -> Option<Vec<PixelRect>> {
        let mut disjoint: Vec<PixelRect> = Vec::new();
        while let Some(mut rect) = self.rects.pop() {
            while let Some(i) = disjoint.iter().position(|r| !r.intersect(rect).is_empty()) {
                rect = rect.union(disjoint.swap_remove(i));
            }
            disjoint.push(rect);
        }
        let area: usize = disjoint.iter().map(|rect| rect.area()).sum();
        (disjoint.len() <= MANY && area < self.size[0] * self.size[1]).then_some(disjoint)
    }
}

/// Returns the bounding box of the triangles in which two meshes differ. Equal triangles at the start and
/// at the end are skipped, since a change usually affects only the triangles between them.
fn changed_triangles(old: &Mesh, new: &Mesh) -> Rect {
    let count = |mesh: &Mesh| mesh.indices.len() / 3;
    let (old_count, new_count) = (count(old), count(new));
    if !old.is_valid() || !new.is_valid() {
        return Rect::EVERYTHING;
    }
    let equal = |i: usize, j: usize| triangle(old, i) == triangle(new, j);
    let shared = old_count.min(new_count);
    let start = (0..shared).take_while(|&i| equal(i, i)).count();
    let end = (1..=shared - start).take_while(|&i| equal(old_count - i, new_count - i)).count();
    let mut extent = Rect::NOTHING;
    for (mesh, triangles) in [(old, start..old_count - end), (new, start..new_count - end)] {
        for vertex in triangles.flat_map(|i| triangle(mesh, i)) {
            extent.extend_with(vertex.pos);
        }
    }
    extent
}

fn triangle(mesh: &Mesh, index: usize) -> [&Vertex; 3] {
    [0, 1, 2].map(|corner| &mesh.vertices[mesh.indices[3 * index + corner] as usize])
}
