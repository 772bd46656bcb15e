//! The painter: against exact expectations, against a naive rasteriser, against itself without
//! its fast paths, and against itself drawing only what changed.

mod support;

use egui::epaint::{
    ClippedPrimitive, ImageDelta, Primitive, Vertex, WHITE_UV, textures::TexturesDelta,
};
use egui::{Color32, ColorImage, Mesh, Pos2, Rect, TextureId, TextureOptions, pos2, vec2};
use pinhole::present::painter::{Canvas, Painter};
use proptest::prelude::*;
use support::naive;

const WHITE_TEXTURE: TextureId = TextureId::Managed(0);
const PICTURE: TextureId = TextureId::Managed(1);

/// A painter with a white texture, and a picture.
fn painter(mut painter: Painter, picture: &ColorImage, options: TextureOptions) -> Painter {
    let mut delta = TexturesDelta::default();
    let white = ColorImage::filled([4, 4], Color32::WHITE);
    delta.push(WHITE_TEXTURE, ImageDelta::full(white, TextureOptions::LINEAR));
    delta.push(PICTURE, ImageDelta::full(picture.clone(), options));
    painter.set_textures(&mut delta);
    painter
}

fn plain() -> Painter {
    painter(Painter::new(), &ColorImage::filled([1, 1], Color32::WHITE), TextureOptions::NEAREST)
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
    painter: &Painter,
    size: [usize; 2],
    ground: Color32,
    primitives: &[ClippedPrimitive],
) -> Vec<Color32> {
    let mut pixels = vec![ground; size[0] * size[1]];
    painter.paint(&mut pixels, size, 1.0, primitives);
    pixels
}

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

/// The picture that textures are tested with: red and green above blue and white.
fn four_texels() -> ColorImage {
    ColorImage::new([2, 2], vec![Color32::RED, Color32::GREEN, Color32::BLUE, Color32::WHITE])
}

fn pictured(rect: Rect, uv: Rect, tint: Color32) -> ClippedPrimitive {
    let mut mesh = Mesh::with_texture(PICTURE);
    mesh.add_rect_with_uv(rect, uv, tint);
    clipped(Rect::EVERYTHING, mesh)
}

const WHOLE: Rect = Rect { min: Pos2::ZERO, max: pos2(1.0, 1.0) };

#[test]
fn nearest_texels_are_blocks() {
    let painter = painter(Painter::new(), &four_texels(), TextureOptions::NEAREST);
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
    let painter = painter(Painter::new(), &four_texels(), TextureOptions::LINEAR);
    let place = rect(1.0, 1.0, 3.0, 3.0);
    let pixels = draw(&painter, [4, 4], Color32::BLACK, &[pictured(place, WHOLE, Color32::WHITE)]);
    assert_eq!(text(&pixels, 4, &NAMES), ["....", ".rg.", ".bw.", "...."]);
    let mirrored = rect(1.0, 0.0, 0.0, 1.0);
    let pixels =
        draw(&painter, [4, 4], Color32::BLACK, &[pictured(place, mirrored, Color32::WHITE)]);
    assert_eq!(text(&pixels, 4, &NAMES), ["....", ".gr.", ".wb.", "...."]);
}

#[test]
fn linear_texels_are_mixed() {
    let picture = ColorImage::new([2, 1], vec![Color32::BLACK, Color32::from_gray(200)]);
    let painter = painter(Painter::new(), &picture, TextureOptions::LINEAR);
    let primitives = [pictured(rect(0.0, 0.0, 4.0, 1.0), WHOLE, Color32::WHITE)];
    let pixels = draw(&painter, [4, 1], Color32::RED, &primitives);
    assert_eq!(pixels, [0, 50, 150, 200].map(Color32::from_gray));
}

#[test]
fn texels_are_tinted() {
    let painter = painter(Painter::new(), &four_texels(), TextureOptions::NEAREST);
    let tint = Color32::from_rgba_premultiplied(128, 64, 0, 128);
    let primitives = [pictured(rect(0.0, 0.0, 2.0, 2.0), WHOLE, tint)];
    let pixels = draw(&painter, [2, 2], Color32::BLACK, &primitives);
    let rgb = Color32::from_rgb;
    assert_eq!(pixels, [rgb(128, 0, 0), rgb(0, 64, 0), rgb(0, 0, 0), rgb(128, 64, 0)]);
}

#[test]
fn parts_of_textures_are_replaced_and_textures_are_freed() {
    let mut painter = painter(Painter::new(), &four_texels(), TextureOptions::NEAREST);
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

// ---- random scenes

const SIDE: usize = 24;

fn place() -> impl Strategy<Value = Pos2> {
    // Half of them on halves of pixels, where the rules for borders count.
    let exact = (-8..=56_i32).prop_map(|x| x as f32 / 2.0);
    let any = -6.0..30.0_f32;
    let coordinate = prop_oneof![exact, any];
    (coordinate.clone(), coordinate).prop_map(|(x, y)| pos2(x, y))
}

fn color() -> impl Strategy<Value = Color32> {
    let any = any::<[u8; 4]>().prop_map(|[r, g, b, a]| Color32::from_rgba_unmultiplied(r, g, b, a));
    prop_oneof![any, Just(Color32::WHITE), Just(Color32::from_rgb(200, 100, 50))]
}

fn vertex(textured: bool) -> impl Strategy<Value = Vertex> {
    // Odd factors keep texture coordinates off the borders of texels, where rounding decides.
    let uv = (0.013..0.987_f32, 0.013..0.987_f32);
    (place(), color(), uv).prop_map(move |(pos, color, (u, v))| {
        let uv = if textured { pos2(u, v) } else { WHITE_UV };
        Vertex { pos, uv, color }
    })
}

fn triangle(textured: bool) -> impl Strategy<Value = Vec<Vertex>> {
    (prop::collection::vec(vertex(textured), 3), any::<bool>()).prop_map(|(mut t, flat)| {
        if flat {
            let color = t[0].color;
            t.iter_mut().for_each(|vertex| vertex.color = color);
        }
        t
    })
}

fn picture() -> impl Strategy<Value = ColorImage> {
    (1..9_usize, 1..9_usize, any::<bool>()).prop_flat_map(|(width, height, opaque)| {
        prop::collection::vec(color(), width * height).prop_map(move |mut texels| {
            if opaque {
                texels.iter_mut().for_each(|texel| *texel = texel.to_opaque());
            }
            ColorImage::new([width, height], texels)
        })
    })
}

fn options() -> impl Strategy<Value = TextureOptions> {
    prop_oneof![Just(TextureOptions::NEAREST), Just(TextureOptions::LINEAR)]
}

fn mesh_of(vertices: &[Vertex], texture_id: TextureId) -> Mesh {
    let indices = (0..vertices.len() as u32).collect();
    Mesh { indices, vertices: vertices.to_vec(), texture_id }
}

/// The largest difference in a channel.
fn difference(a: &[Color32], b: &[Color32]) -> u8 {
    let channels =
        |pixels: &[Color32]| pixels.iter().flat_map(|p| p.to_array()).collect::<Vec<_>>();
    channels(a).iter().zip(channels(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// A rectangle as the two triangles that egui makes of it, anywhere on the picture, its pixels a
/// whole multiple of the texels or not.
fn any_rectangle() -> impl Strategy<Value = Mesh> {
    let corner = place();
    let size = prop_oneof![
        (1..20_u8, 1..20_u8).prop_map(|(w, h)| vec2(w.into(), h.into())),
        (0.1..25.0_f32, 0.1..25.0_f32).prop_map(|(w, h)| vec2(w, h)),
    ];
    let part = (0.0..0.5_f32, 0.5..1.0_f32);
    let uv = prop_oneof![
        Just(WHOLE),
        Just(Rect::from_min_max(WHITE_UV, WHITE_UV)),
        Just(rect(1.0, 0.0, 0.0, 1.0)),
        (part.clone(), part).prop_map(|((l, r), (t, b))| rect(l, t, r, b)),
    ];
    (corner, size, uv, color()).prop_map(|(min, size, uv, color)| {
        let mut mesh = Mesh::with_texture(PICTURE);
        mesh.add_rect_with_uv(Rect::from_min_size(min, size), uv, color);
        mesh
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn triangles_are_as_the_naive_rasteriser_draws_them(
        vertices in any::<bool>().prop_flat_map(triangle),
        picture in picture(),
        options in options(),
        ground in color(),
    ) {
        let ground = ground.to_opaque();
        let painter = painter(Painter::new(), &picture, options);
        let mesh = mesh_of(&vertices, PICTURE);
        let pixels = draw(&painter, [SIDE, SIDE], ground, &[clipped(Rect::EVERYTHING, mesh)]);
        let mut expected = ColorImage::filled([SIDE, SIDE], ground);
        let [a, b, c] = [&vertices[0], &vertices[1], &vertices[2]];
        naive::draw(&mut expected, &picture, options.magnification, [a, b, c]);
        // A half rounds up here and down there.
        prop_assert!(difference(&pixels, &expected.pixels) <= 1);
    }

    #[test]
    fn rectangles_are_the_pixels_of_their_triangles(
        meshes in prop::collection::vec(any_rectangle(), 1..4),
        picture in picture(),
        options in options(),
    ) {
        let primitives: Vec<_> =
            meshes.into_iter().map(|mesh| clipped(rect(2.0, 1.0, 22.6, 23.0), mesh)).collect();
        let draw = |of| draw(&painter(of, &picture, options), [SIDE, SIDE], Color32::BLACK, &primitives);
        prop_assert_eq!(draw(Painter::new()), draw(Painter::triangles_only()));
    }

    #[test]
    fn what_changed_is_all_that_needs_drawing(
        frames in prop::collection::vec(
            prop::collection::vec(prop::collection::vec(any_rectangle(), 1..4), 0..4), 2..6),
        keep in prop::collection::vec(any::<bool>(), 24),
    ) {
        let painter = painter(Painter::new(), &four_texels(), TextureOptions::NEAREST);
        let mut canvas = Canvas::new();
        let mut last: Vec<ClippedPrimitive> = Vec::new();
        let mut keep = keep.iter().cycle();
        for frame in frames {
            let mut primitives: Vec<_> = frame.iter().map(|meshes| {
                let mut all = Mesh::with_texture(PICTURE);
                meshes.iter().for_each(|mesh| all.append_ref(mesh));
                clipped(rect(1.0, 1.0, 23.0, 22.0), all)
            }).collect();
            // Most of a frame is what the last one was.
            for (primitive, old) in primitives.iter_mut().zip(&last) {
                if *keep.next().unwrap_or(&true) {
                    *primitive = old.clone();
                }
            }
            let size = [SIDE, SIDE];
            canvas.show(&painter, &Default::default(), size, 1.0, Color32::BLACK, primitives.clone());
            let expected = draw(&painter, size, Color32::BLACK, &primitives);
            prop_assert_eq!(canvas.pixels(), expected.as_slice());
            last = primitives;
        }
    }
}

#[test]
fn a_frame_like_the_last_one_is_not_drawn() {
    let painter = plain();
    let mut canvas = Canvas::new();
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
