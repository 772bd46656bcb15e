//! Pixels that are known beforehand.

use pinhole_figure::painter::Canvas;

use super::*;

/// A picture of characters: what each colour is called.
fn text(pixels: &[Color32], width: usize, names: &[(Color32, char)]) -> Vec<String> {
    let name = |pixel: &Color32| {
        names.iter().find(|(color, _)| color == pixel).map_or('?', |(_, name)| *name)
    };
    pixels.chunks(width).map(|row| row.iter().map(name).collect()).collect()
}

const NAMES: [(Color32, char); 5] = [
    (Color32::BLACK, '.'),
    (Color32::RED, 'r'),
    (Color32::GREEN, 'g'),
    (Color32::BLUE, 'b'),
    (Color32::WHITE, 'w'),
];

#[test]
fn a_rectangle_has_the_pixels_whose_centres_it_contains() {
    let mesh = rectangle(rect(1.0, 0.5, 3.5, 2.49), Color32::RED);
    let pixels = draw(&plain(), [5, 3], Color32::BLACK, &[clipped(Rect::EVERYTHING, mesh)]);
    assert_eq!(text(&pixels, 5, &NAMES), [".rr..", ".rr..", "....."]);
}

#[test]
fn neighbouring_rectangles_share_no_pixel_and_leave_no_gap() {
    let half = Color32::from_rgba_premultiplied(128, 0, 0, 128);
    for border in [1.0, 1.3, 1.5, 1.501, 2.0] {
        let primitives = [
            clipped(Rect::EVERYTHING, rectangle(rect(0.0, 0.0, border, 1.0), half)),
            clipped(Rect::EVERYTHING, rectangle(rect(border, 0.0, 4.0, 1.0), half)),
        ];
        let pixels = draw(&plain(), [4, 1], Color32::BLACK, &primitives);
        assert!(pixels.iter().all(|&pixel| pixel == pixels[0]), "at {border}: {pixels:?}");
    }
}

#[test]
fn half_transparent_colours_are_blended_as_they_are() {
    let half = Color32::from_rgba_premultiplied(100, 0, 50, 128);
    let ground = Color32::from_rgb(10, 200, 255);
    let mesh = rectangle(rect(0.0, 0.0, 1.0, 1.0), half);
    let pixels = draw(&plain(), [1, 1], ground, &[clipped(Rect::EVERYTHING, mesh)]);
    // 100 + 10 * 127/255, 0 + 200 * 127/255, 50 + 255 * 127/255
    assert_eq!(pixels, [Color32::from_rgb(105, 100, 177)]);
}

#[test]
fn additive_colours_saturate() {
    let glow = Color32::from_rgb_additive(100, 0, 0);
    let mesh = rectangle(rect(0.0, 0.0, 1.0, 1.0), glow);
    let ground = Color32::from_rgb(200, 7, 9);
    let pixels = draw(&plain(), [1, 1], ground, &[clipped(Rect::EVERYTHING, mesh)]);
    assert_eq!(pixels, [Color32::from_rgb(255, 7, 9)]);
}

#[test]
fn clip_rectangles_are_rounded_to_whole_pixels() {
    let mesh = rectangle(rect(-10.0, -10.0, 50.0, 50.0), Color32::GREEN);
    let clip = rect(0.6, 0.4, 3.4, 1.5);
    let pixels = draw(&plain(), [5, 3], Color32::BLACK, &[clipped(clip, mesh)]);
    assert_eq!(text(&pixels, 5, &NAMES), [".gg..", ".gg..", "....."]);
}

#[test]
fn points_are_scaled_to_pixels() {
    let mut pixels = vec![Color32::BLACK; 12];
    let mesh = rectangle(rect(0.5, 0.0, 1.5, 1.0), Color32::BLUE);
    plain().paint(&mut pixels, [4, 3], 2.0, &[clipped(rect(0.0, 0.0, 2.0, 0.5), mesh)]);
    assert_eq!(text(&pixels, 4, &NAMES), [".bb.", "....", "...."]);
}

fn pictured(rect: Rect, uv: Rect, tint: Color32) -> ClippedPrimitive {
    let mut mesh = Mesh::with_texture(PICTURE);
    mesh.add_rect_with_uv(rect, uv, tint);
    clipped(Rect::EVERYTHING, mesh)
}

#[test]
fn nearest_texels_are_blocks() {
    let painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::NEAREST);
    let enlarged = [pictured(rect(1.0, 0.0, 5.0, 4.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [6, 4], Color32::BLACK, &enlarged);
    assert_eq!(text(&pixels, 6, &NAMES), [".rrgg.", ".rrgg.", ".bbww.", ".bbww."]);
    // Three pixels to two texels: the middle one's centre is on the border, and belongs to the
    // texel on the right.
    let uneven = [pictured(rect(0.0, 0.0, 3.0, 2.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [3, 2], Color32::BLACK, &uneven);
    assert_eq!(text(&pixels, 3, &NAMES), ["rgg", "bww"]);
}

#[test]
fn pictures_one_to_one_and_mirrored() {
    let painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::LINEAR);
    let area = rect(1.0, 1.0, 3.0, 3.0);
    let pixels = draw(&painter, [4, 4], Color32::BLACK, &[pictured(area, WHOLE, Color32::WHITE)]);
    assert_eq!(text(&pixels, 4, &NAMES), ["....", ".rg.", ".bw.", "...."]);
    let mirrored = rect(1.0, 0.0, 0.0, 1.0);
    let pixels =
        draw(&painter, [4, 4], Color32::BLACK, &[pictured(area, mirrored, Color32::WHITE)]);
    assert_eq!(text(&pixels, 4, &NAMES), ["....", ".gr.", ".wb.", "...."]);
}

#[test]
fn linear_texels_are_mixed() {
    let picture = ColorImage::new([2, 1], vec![Color32::BLACK, Color32::from_gray(200)]);
    let painter = painter(SoftwarePainter::default(), &picture, TextureOptions::LINEAR);
    let primitives = [pictured(rect(0.0, 0.0, 4.0, 1.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [4, 1], Color32::RED, &primitives);
    assert_eq!(pixels, [0, 50, 150, 200].map(Color32::from_gray));
}

#[test]
fn texels_are_tinted() {
    let painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::NEAREST);
    let tint = Color32::from_rgba_premultiplied(128, 64, 0, 128);
    let primitives = [pictured(rect(0.0, 0.0, 2.0, 2.0), WHOLE, tint)];
    let pixels = draw(&painter, [2, 2], Color32::BLACK, &primitives);
    let rgb = Color32::from_rgb;
    assert_eq!(pixels, [rgb(128, 0, 0), rgb(0, 64, 0), rgb(0, 0, 0), rgb(128, 64, 0)]);
}

#[test]
fn parts_of_textures_are_replaced_and_textures_are_freed() {
    let mut painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::NEAREST);
    let mut delta = TexturesDelta::default();
    let part = ColorImage::filled([1, 2], Color32::WHITE);
    delta.push(PICTURE, ImageDelta::partial([0, 0], part, TextureOptions::NEAREST));
    assert!(painter.set_textures(&mut delta).contains(&PICTURE));
    let primitives = [pictured(rect(0.0, 0.0, 2.0, 2.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [2, 2], Color32::BLACK, &primitives);
    assert_eq!(text(&pixels, 2, &NAMES), ["wg", "ww"]);
    delta.free(PICTURE);
    painter.free_textures(&mut delta);
    let pixels = draw(&painter, [2, 2], Color32::BLACK, &primitives);
    assert_eq!(text(&pixels, 2, &NAMES), ["..", ".."]);
}

#[test]
fn a_part_that_lets_through_makes_the_texture_let_through() {
    let mut painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::NEAREST);
    let mut delta = TexturesDelta::default();
    let part = ColorImage::filled([1, 1], Color32::TRANSPARENT);
    delta.push(PICTURE, ImageDelta::partial([1, 1], part, TextureOptions::NEAREST));
    painter.set_textures(&mut delta);
    let primitives = [pictured(rect(0.0, 0.0, 2.0, 2.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [2, 2], Color32::BLACK, &primitives);
    assert_eq!(text(&pixels, 2, &NAMES), ["rg", "b."]);
}

/// All that two triangles between the corners of one rectangle can be: only some of them are it.
#[test]
fn triangles_that_only_look_like_a_rectangle() {
    let corners = [pos2(1.0, 1.0), pos2(5.0, 1.0), pos2(1.0, 4.0), pos2(5.0, 4.0)];
    let half = Color32::from_rgba_premultiplied(100, 50, 0, 128);
    let corner = |digit: u32| Vertex::untextured(corners[digit as usize], half);
    for case in 0..4_u32.pow(6) {
        let vertices: Vec<_> = (0..6).map(|i| corner(case / 4_u32.pow(i) % 4)).collect();
        let primitives = [clipped(Rect::EVERYTHING, mesh_of(&vertices, WHITE_TEXTURE))];
        let [fast, general] =
            [SoftwarePainter::default(), SoftwarePainter::triangles_only()].map(|made| {
                let painter = painter(made, &four_texels(), TextureOptions::NEAREST);
                draw(&painter, [6, 5], Color32::BLACK, &primitives)
            });
        assert!(fast == general, "{vertices:?}");
    }
}

#[test]
fn broken_meshes_draw_nothing_and_do_not_panic() {
    let vertex = |x: f32, y: f32| Vertex::untextured(pos2(x, y), Color32::RED);
    let nan = Mesh {
        indices: vec![0, 1, 2],
        vertices: vec![vertex(f32::NAN, 0.0), vertex(9.0, 0.0), vertex(0.0, f32::INFINITY)],
        texture_id: WHITE_TEXTURE,
    };
    let outside = Mesh { indices: vec![0, 1, 7], ..nan.clone() };
    let mut incomplete = rectangle(rect(0.0, 0.0, 2.0, 2.0), Color32::RED);
    incomplete.indices.truncate(2);
    let missing = Mesh { texture_id: TextureId::User(5), ..nan.clone() };
    let primitives =
        [nan, outside, incomplete, missing].map(|mesh| clipped(Rect::EVERYTHING, mesh));
    let pixels = draw(&plain(), [2, 2], Color32::BLACK, &primitives);
    assert_eq!(text(&pixels, 2, &NAMES), ["..", ".."]);
    let mut too_few = vec![Color32::BLACK; 3];
    plain().paint(&mut too_few, [2, 2], 1.0, &[]);
}

#[test]
fn far_away_vertices_fill_the_picture() {
    let mesh = rectangle(rect(-1e30, -1e9, 1e30, 1e9), Color32::RED);
    let pixels = draw(&plain(), [2, 2], Color32::BLACK, &[clipped(Rect::EVERYTHING, mesh)]);
    assert_eq!(text(&pixels, 2, &NAMES), ["rr", "rr"]);
}

#[test]
fn a_frame_like_the_last_one_is_not_drawn() {
    let painter = plain();
    let mut canvas = Canvas::default();
    let frame = |x: f32| {
        [0.0, 4.0]
            .map(|y| {
                clipped(Rect::EVERYTHING, rectangle(rect(x, y, x + 2.0, y + 2.0), Color32::RED))
            })
            .to_vec()
    };
    let mut show = |changed: &[TextureId], primitives| {
        let changed = changed.iter().copied().collect();
        let size = [40, 40];
        let rects = canvas.show(&painter, &changed, size, 1.0, Color32::BLACK, primitives);
        rects.iter().map(|rect| rect.area()).sum::<usize>()
    };
    assert_eq!(show(&[], frame(1.0)), 1600);
    assert_eq!(show(&[], frame(1.0)), 0);
    let moved = show(&[], frame(3.0));
    assert!((1..100).contains(&moved), "{moved}");
    let texture_changed = show(&[WHITE_TEXTURE], frame(3.0));
    assert!((1..100).contains(&texture_changed), "{texture_changed}");
    assert_eq!(show(&[PICTURE], frame(3.0)), 0);
}
