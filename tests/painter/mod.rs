//! The painter: against exact expectations, against a naive rasteriser, against itself without
//! its fast paths, against itself drawing only what changed, and drawing an interface.

mod exact;
mod interface;
mod random;

use egui::epaint::{ClippedPrimitive, ImageDelta, Primitive, Vertex, textures::TexturesDelta};
use egui::{Color32, ColorImage, Mesh, Pos2, Rect, TextureId, TextureOptions, pos2};
use pinhole_figure::painter::SoftwarePainter;

const WHITE_TEXTURE: TextureId = TextureId::Managed(0);
const PICTURE: TextureId = TextureId::Managed(1);

/// A painter with a white texture, and a picture.
fn painter(
    mut painter: SoftwarePainter,
    picture: &ColorImage,
    options: TextureOptions,
) -> SoftwarePainter {
    let mut delta = TexturesDelta::default();
    let white = ColorImage::filled([4, 4], Color32::WHITE);
    delta.push(WHITE_TEXTURE, ImageDelta::full(white, TextureOptions::LINEAR));
    delta.push(PICTURE, ImageDelta::full(picture.clone(), options));
    painter.set_textures(&mut delta);
    painter
}

fn plain() -> SoftwarePainter {
    painter(
        SoftwarePainter::default(),
        &ColorImage::filled([1, 1], Color32::WHITE),
        TextureOptions::NEAREST,
    )
}

fn clipped(clip_rect: Rect, mesh: Mesh) -> ClippedPrimitive {
    ClippedPrimitive { clip_rect, primitive: Primitive::Mesh(mesh) }
}

fn rectangle(rect: Rect, color: Color32) -> Mesh {
    let mut mesh = Mesh::default();
    mesh.add_colored_rect(rect, color);
    mesh
}

fn rect(left: f32, top: f32, right: f32, bottom: f32) -> Rect {
    Rect::from_min_max(pos2(left, top), pos2(right, bottom))
}

/// Draws on a ground of one colour.
fn draw(
    painter: &SoftwarePainter,
    size: [usize; 2],
    ground: Color32,
    primitives: &[ClippedPrimitive],
) -> Vec<Color32> {
    let mut pixels = vec![ground; size[0] * size[1]];
    painter.paint(&mut pixels, size, 1.0, primitives);
    pixels
}

/// The picture that textures are tested with: red and green above blue and white.
fn four_texels() -> ColorImage {
    ColorImage::new([2, 2], vec![Color32::RED, Color32::GREEN, Color32::BLUE, Color32::WHITE])
}

const WHOLE: Rect = Rect { min: Pos2::ZERO, max: pos2(1.0, 1.0) };

fn mesh_of(vertices: &[Vertex], texture_id: TextureId) -> Mesh {
    let indices = (0..vertices.len() as u32).collect();
    Mesh { indices, vertices: vertices.to_vec(), texture_id }
}
