//! Random triangles, rectangles and frames.

use egui::epaint::WHITE_UV;
use egui::vec2;
use pinhole_figure::painter::Canvas;
use proptest::prelude::*;

use super::*;
use crate::support::naive;

const SIDE: usize = 24;

fn position() -> impl Strategy<Value = Pos2> {
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
    let uv = (0.013..0.987_f32, 0.013..0.987_f32);
    (position(), color(), uv).prop_map(move |(pos, color, (u, v))| {
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

/// Often the whole picture, as most of a panel has the panel's own clip rectangle.
fn clip() -> impl Strategy<Value = Rect> {
    let part = (0.0..12.0_f32, 0.0..12.0_f32, 6.0..24.0_f32, 6.0..24.0_f32)
        .prop_map(|(left, top, right, bottom)| rect(left, top, right, bottom));
    prop_oneof![Just(rect(1.0, 1.0, 23.0, 22.0)), part]
}

/// The largest difference in a channel.
fn difference(a: Color32, b: Color32) -> u8 {
    a.to_array().into_iter().zip(b.to_array()).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// The nine ways to look a texture up within 1/4096 of a texel. On the border of two texels, rounding
/// decides which one is taken, and either is right.
fn lookup_shifts() -> impl Iterator<Item = [f64; 2]> {
    let shifts = [-1.0, 0.0, 1.0].map(|x| x / 4096.0);
    shifts.into_iter().flat_map(move |x| shifts.map(|y| [x, y]))
}

/// A rectangle as the two triangles that egui makes of it, anywhere on the picture, its pixels a
/// whole multiple of the texels or not.
fn any_rectangle() -> impl Strategy<Value = Mesh> {
    let corner = position();
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
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn triangles_are_as_the_naive_rasteriser_draws_them(
        vertices in any::<bool>().prop_flat_map(triangle),
        picture in picture(),
        options in options(),
        ground in color(),
    ) {
        let ground = ground.to_opaque();
        let painter = painter(SoftwarePainter::default(), &picture, options);
        let mesh = mesh_of(&vertices, PICTURE);
        let pixels = draw(&painter, [SIDE, SIDE], ground, &[clipped(Rect::EVERYTHING, mesh)]);
        let [a, b, c] = [&vertices[0], &vertices[1], &vertices[2]];
        let expected: Vec<_> = lookup_shifts().map(|shift| {
            let mut canvas = ColorImage::filled([SIDE, SIDE], ground);
            naive::draw(&mut canvas, &picture, options.magnification, shift, [a, b, c]);
            canvas.pixels
        }).collect();
        for (i, pixel) in pixels.into_iter().enumerate() {
            // A half rounds up here and down there.
            let one_is_near = expected.iter().any(|e| difference(pixel, e[i]) <= 1);
            prop_assert!(one_is_near, "pixel {i} is {pixel:?}, not {:?}", expected[4][i]);
        }
    }

    #[test]
    fn rectangles_are_the_pixels_of_their_triangles(
        meshes in prop::collection::vec(any_rectangle(), 1..4),
        picture in picture(),
        options in options(),
    ) {
        let primitives: Vec<_> =
            meshes.into_iter().map(|mesh| clipped(rect(2.0, 1.0, 22.6, 23.0), mesh)).collect();
        let draw = |made| draw(&painter(made, &picture, options), [SIDE, SIDE], Color32::BLACK, &primitives);
        prop_assert_eq!(draw(SoftwarePainter::default()), draw(SoftwarePainter::triangles_only()));
    }

    #[test]
    fn what_changed_is_all_that_needs_drawing(
        frames in prop::collection::vec(
            prop::collection::vec((prop::collection::vec(any_rectangle(), 1..4), clip()), 0..4),
            2..6,
        ),
        keep in prop::collection::vec(any::<bool>(), 24),
    ) {
        let painter = painter(SoftwarePainter::default(), &four_texels(), TextureOptions::NEAREST);
        let mut canvas = Canvas::default();
        let mut last: Vec<ClippedPrimitive> = Vec::new();
        let mut keep = keep.iter().cycle();
        for frame in frames {
            let mut primitives: Vec<_> = frame.iter().map(|(meshes, clip)| {
                let mut all = Mesh::with_texture(PICTURE);
                meshes.iter().for_each(|mesh| all.append_ref(mesh));
                clipped(*clip, all)
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
