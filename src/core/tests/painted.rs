//! Tests that a frame contains only the requested outputs, and that colours computed while tracing
//! equal those computed from the whole frame.

use pinhole_core::*;

use crate::common::levels::levels;
use crate::common::{Numbers, camera, plane, shade_pixel, sphere, vec3};

/// Returns scenes that exercise all code of the shading: spheres seen from near, from far, from inside,
/// and from so far that exact arithmetic is needed; planes; runs of a single pixel; background.
fn scenes() -> Vec<(&'static str, Scene, ResolvedCamera)> {
    let looking = |eye, view| camera(eye, view, DVec3::Y, 131, 75).resolve().unwrap();
    let ahead = looking(DVec3::ZERO, vec3(0.1, -0.05, -1.0));
    let mut numbers = Numbers(5);
    let many: Vec<Sphere> = (0..800)
        .map(|_| Sphere {
            center: vec3(0.0, 0.0, -40.0) + numbers.point(12.0),
            radius: numbers.between(0.02, 1.5),
        })
        .collect();
    let zoomed = Viewport { width: 4e-8, height: 2e-8, distance: 1.0 };
    let image = ahead.image();
    let zoomed = Camera { viewport: zoomed, image, ..Camera::CANONICAL }.resolve().unwrap();
    let minute = Viewport { width: 1e-70, height: 1e-70, distance: 1e-70 };
    let minute = Camera { viewport: minute, image, ..Camera::CANONICAL }.resolve().unwrap();
    let scene = |spheres, planes| Scene::new(spheres, planes).unwrap();
    let floor = plane([0.0, -1.0, 0.0], [0.0, 2.0, 0.1]);
    let balls = vec![sphere([-0.5, 0.0, -5.0], 1.0), sphere([1.0, 0.0, -30.0], 2.5)];
    vec![
        ("balls and a floor", scene(balls.clone(), vec![floor]), ahead),
        ("no plane", scene(balls.clone(), vec![]), ahead),
        ("inside", scene(vec![sphere([0.0, 0.1, 0.2], 3.0)], vec![]), ahead),
        ("many", scene(many, vec![]), ahead),
        ("nothing", scene(vec![], vec![]), ahead),
        ("far for its size", scene(vec![sphere([0.0, 0.0, -1e9], 12.0)], vec![]), zoomed),
        ("rays that need scaling", scene(balls, vec![floor]), minute),
    ]
}

fn color_of(object: u32) -> Rgb {
    [[0xe6, 0x9f, 0x00], [0x00, 0x72, 0xb2], [0x33, 0xcc, 0x77]][object as usize % 3]
}

fn of_four([r, g, b]: Rgb) -> [u8; 4] {
    [r, g, b, 255]
}

fn rasters(camera: &ResolvedCamera) -> [Raster; 2] {
    [Raster::full(camera.image()), Raster::shown_on(camera.image(), 50, 41)]
}

fn on_threads<R: Send>(count: usize, run: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(run)
}

/// All eight choices.
fn all_outputs() -> impl Iterator<Item = Outputs> {
    (0..8_u8).map(|k| Outputs { t: k & 1 != 0, object: k & 2 != 0, normal: k & 4 != 0 })
}

fn outputs_are_parts_of_the_whole<T: Depth>() {
    for (name, scene, camera) in scenes() {
        for raster in rasters(&camera) {
            let all = Outputs { t: true, object: true, normal: true };
            let whole = trace_as::<T>(&scene, &camera, &raster, all);
            assert_eq!(whole.normal.len(), raster.len());
            for outputs in all_outputs() {
                let part = trace_as::<T>(&scene, &camera, &raster, outputs);
                let mut expected = whole.clone();
                if !outputs.t {
                    expected.t.clear();
                    expected.steps_of_t = Steps::default();
                }
                if !outputs.object {
                    expected.object.clear();
                }
                if !outputs.normal {
                    expected.normal.clear();
                }
                assert!(part == expected, "{name}, {outputs:?}");
            }
        }
    }
}

#[test]
fn outputs_alone_and_together_are_those_of_the_whole_frame() {
    outputs_are_parts_of_the_whole::<f64>();
    outputs_are_parts_of_the_whole::<f32>();
}

#[test]
fn a_frame_without_buffers_is_traced_again_without_buffers() {
    let (_, scene, camera) = scenes().swap_remove(0);
    let raster = Raster::full(camera.image());
    let only_t = Outputs { object: false, ..Outputs::default() };
    let mut frame = trace_as::<f32>(&scene, &camera, &raster, only_t);
    let ball = Scene::new(vec![sphere([0.0, 0.0, -3.0], 1.0)], vec![]).unwrap();
    retrace(&mut frame, &ball, &camera);
    assert!(frame == trace_as::<f32>(&ball, &camera, &raster, only_t));
}

fn painted_as_shaded<T: Depth>(outputs: Outputs) {
    for (name, scene, camera) in scenes() {
        for raster in rasters(&camera) {
            let frame = trace_as::<T>(&scene, &camera, &raster, outputs);
            let whole = trace_as::<T>(&scene, &camera, &raster, Outputs::default());
            for how in Shade::ALL {
                let expected = shade(&whole, &scene, how, color_of, of_four);
                let paint = Paint { shade: how, color_of, to_pixel: of_four };
                for threads in [1, 2] {
                    let mut pixels = vec![[0; 4]; raster.len()];
                    let to = &mut pixels;
                    let traced: Frame<T> = on_threads(threads, || {
                        trace_painted(&scene, &camera, &raster, outputs, &paint, to)
                    });
                    assert!(traced == frame, "{name}, {}, {outputs:?}", how.name());
                    assert!(pixels == expected, "{name}, {}, {outputs:?}", how.name());
                }
            }
        }
    }
}

#[test]
fn a_frame_painted_again_is_as_if_painted_anew() {
    let outputs = Outputs { t: true, object: true, normal: true };
    let scenes = scenes();
    // From inside a ball, every pixel has a normal.
    let other = &Scene::new(vec![sphere([0.0; 3], 1e3)], vec![]).unwrap();
    for (name, scene, camera) in &scenes {
        let raster = Raster::full(camera.image());
        for how in Shade::ALL {
            let paint = Paint { shade: how, color_of, to_pixel: of_four };
            let mut expected = vec![[0; 4]; raster.len()];
            let new: Frame<f32> =
                trace_painted(scene, camera, &raster, outputs, &paint, &mut expected);
            let mut again = trace_as::<f32>(other, camera, &raster, outputs);
            let mut pixels = vec![[7; 4]; raster.len()];
            retrace_painted(&mut again, scene, camera, &paint, &mut pixels);
            assert!(again == new && pixels == expected, "{name}, {}", how.name());
        }
    }
}

#[test]
fn pixels_painted_while_tracing_are_those_of_the_shaded_frame() {
    for outputs in [Outputs::NONE, Outputs::default(), Outputs { normal: true, ..Outputs::NONE }] {
        painted_as_shaded::<f64>(outputs);
        painted_as_shaded::<f32>(outputs);
    }
}

#[test]
fn colors_are_the_same_on_every_level_and_those_of_each_pixel_alone() {
    let levels = levels();
    for (name, scene, camera) in scenes() {
        let raster = Raster::full(camera.image());
        let frame = trace(&scene, &camera, &raster, Outputs::default());
        let nearest = frame.t.iter().copied().fold(f64::INFINITY, f64::min);
        for how in Shade::ALL {
            let paint = Paint { shade: how, color_of, to_pixel: |rgb| rgb };
            let alone: Vec<Rgb> = (0..raster.len())
                .map(|index| {
                    let (row, column) = (index / 131, index % 131);
                    match (frame.at(row, column).object, how) {
                        (None, _) => BACKGROUND,
                        (Some(object), Shade::Object) => color_of(object),
                        _ => {
                            let ray = camera.ray_of_pixel(frame.at(row, column).pixel);
                            shade_pixel(&scene, how, &ray, nearest, color_of)
                        }
                    }
                })
                .collect();
            for (level_name, level) in &levels {
                let colors = shade_at_level(*level, &frame, &scene, &paint);
                // At an outline, the rounded ray may miss, or hit another object.
                let apart = colors.iter().zip(&alone).filter(|(a, b)| a != b).count();
                let most = if name == "many" { 4 } else { 0 };
                assert!(apart <= most, "{name}, {}, {level_name}: {apart}", how.name());
                let best = shade(&frame, &scene, how, color_of, |rgb| rgb);
                assert!(colors == best, "{name}, {}, {level_name}", how.name());
            }
        }
    }
}

/// Tests the shading of frames with t in `f32` against the frame's own normals, which are within 3e-16
/// rad of the exact ones.
#[test]
fn light_and_normals_are_the_right_ones_to_the_nearest_byte() {
    for (name, scene, camera) in scenes() {
        let raster = Raster::full(camera.image());
        let outputs = Outputs { normal: true, ..Outputs::default() };
        let frame = trace_as::<f32>(&scene, &camera, &raster, outputs);
        let lit = shade(&frame, &scene, Shade::Lambert, |_| [255; 3], |[r, ..]| r);
        let normals = shade(&frame, &scene, Shade::Normal, color_of, |rgb| rgb);
        for index in (0..raster.len()).filter(|index| frame.object[*index] != NO_OBJECT) {
            let ray = camera.ray_of_pixel(frame.at(index / 131, index % 131).pixel);
            let n = frame.normal[index];
            let d = ray.direction / ray.direction.abs().max_element();
            let light = 0.15 + 0.85 * n.dot(d).abs() / d.length();
            let s = if light <= 0.0031308 {
                12.92 * light
            } else {
                1.055 * light.powf(1.0 / 2.4) - 0.055
            };
            let apart = (255.0 * s - f64::from(lit[index])).abs();
            assert!(apart < 0.6, "{name}, {index}: {apart}");
            for (byte, x) in normals[index].into_iter().zip(n.to_array()) {
                let apart = (127.5 * (x + 1.0) - f64::from(byte)).abs();
                assert!(apart < 0.51, "{name}, {index}: {apart}");
            }
        }
    }
}

#[test]
#[should_panic(expected = "a pixel for each")]
fn a_picture_of_another_size_is_refused() {
    let (_, scene, camera) = scenes().swap_remove(0);
    let raster = Raster::full(camera.image());
    let paint = Paint { shade: Shade::Lambert, color_of, to_pixel: of_four };
    let none = Outputs::NONE;
    let _: Frame = trace_painted(&scene, &camera, &raster, none, &paint, &mut [[0; 4]; 7]);
}

#[test]
fn a_coarse_frame_spread_over_the_image_says_of_each_pixel_what_the_nearest_traced_one_says() {
    let (_, scene, camera) = scenes().swap_remove(0);
    let image = camera.image();
    let coarse: Frame =
        trace(&scene, &camera, &Raster::shown_on(image, 30, 20), Outputs::default());
    let spread = coarse.spread();
    assert_eq!((spread.raster(), spread.steps), (&Raster::full(image), coarse.steps));
    let nearest = |traced: &[u32], own: u32| {
        (0..traced.len()).min_by_key(|k| traced[*k].abs_diff(own)).unwrap()
    };
    let mut hits = 0;
    for (row, column) in
        (0..image.height()).flat_map(|row| (0..image.width()).map(move |column| (row, column)))
    {
        let raster = coarse.raster();
        let shown = coarse.at(nearest(raster.rows(), row), nearest(raster.columns(), column));
        let at = spread.at(row as usize, column as usize);
        assert_eq!((at.t, at.object), (shown.t, shown.object), "row {row}, column {column}");
        hits += usize::from(at.object.is_some());
    }
    assert!(hits > 1000);
    assert!(spread.normal.is_empty());
}
