//! Hits as colours.

use pinhole_core::*;

use crate::common::{camera, plane, shade_pixel, sphere, vec3};

const ORANGE: Rgb = [0xe6, 0x9f, 0x00];
const BLUE: Rgb = [0x00, 0x72, 0xb2];

fn color_of(object: u32) -> Rgb {
    if object == 0 { ORANGE } else { BLUE }
}

/// Returns a scene of a ball in front of a wall that is tilted by 45 degrees.
fn scene() -> Scene {
    let wall = plane([0.0, 0.0, -8.0], [0.0, 1.0, 1.0]);
    Scene::new(vec![sphere([0.0, 0.0, -5.0], 1.0)], vec![wall]).unwrap()
}

/// Returns a function from row and column to the colour in a picture of 41 x 41 pixels along -z.
fn picture(scene: &Scene, how: Shade) -> impl Fn(usize, usize) -> Rgb + use<> {
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 41, 41).resolve().unwrap();
    let frame = trace(scene, &camera, &Raster::full(camera.image()), Outputs::default());
    let colors = shade(&frame, scene, how, color_of, |rgb| rgb);
    assert_eq!(colors.len(), 41 * 41);
    move |row, column| colors[row * 41 + column]
}

#[test]
fn lit_from_the_eye() {
    let at = picture(&scene(), Shade::Lambert);
    // Where the ray hits the ball perpendicularly, the ball has its full colour.
    assert_eq!(at(20, 20), ORANGE);
    // At the outline, 15 % of the light is left, and it decreases monotonically towards it.
    let reds: Vec<u8> = (20..29).map(|column| at(20, column)[0]).take_while(|r| *r != 0).collect();
    assert!(reds.is_sorted_by(|a, b| a >= b) && *reds.last().unwrap() < ORANGE[0] - 60, "{reds:?}");
    assert_eq!(at(20, 16), at(20, 24));
    assert_eq!(at(16, 20), at(24, 20));
}

/// The light is `0.15 + 0.85 cos` in linear light, where cos is `sqrt(2) / 2` for a plane at 45
/// degrees.
#[test]
fn light_falls_with_the_cosine() {
    let wall = Scene::new(vec![], vec![plane([0.0, 0.0, -5.0], [1.0, 0.0, 1.0])]).unwrap();
    let gray = |object| [[188_u8; 3], [0; 3], [255; 3]][object as usize];
    let ray = Ray { origin: DVec3::ZERO, direction: vec3(0.0, 0.0, -3.0) };
    // 188 is 0.5029 of white; times 0.7510 is 0.3777, which is 165.
    assert_eq!(shade_pixel(&wall, Shade::Lambert, &ray, 1.0, gray), [165; 3]);
    // A plane whose normal points away from the eye is lit as well.
    let turned = Scene::new(vec![], vec![plane([0.0, 0.0, -5.0], [-1.0, 0.0, -1.0])]).unwrap();
    assert_eq!(shade_pixel(&turned, Shade::Lambert, &ray, 1.0, gray), [165; 3]);
}

#[test]
fn every_byte_is_kept_in_full_light() {
    let wall = Scene::new(vec![], vec![plane([0.0, 0.0, -5.0], [0.0, 0.0, 1.0])]).unwrap();
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
    for byte in 0..=255 {
        let seen = shade_pixel(&wall, Shade::Lambert, &ray, 1.0, |_| [byte, 255 - byte, byte]);
        assert_eq!(seen, [byte, 255 - byte, byte]);
    }
}

#[test]
fn normals_as_colors() {
    let at = picture(&scene(), Shade::Normal);
    // (0, 0, 1): -1..1 is 0..255, and 0 is 127.5, rounded up.
    assert_eq!(at(20, 20), [128, 128, 255]);
    let (left, right) = (at(20, 17), at(20, 23));
    assert!(
        left[0] <= 90 && left[0] + right[0] == 255 && left[1] == 128 && right[1] == 128,
        "{left:?} {right:?}"
    );
    let (above, below) = (at(17, 20), at(23, 20));
    assert!(below[1] <= 90 && above[1] + below[1] == 255, "{above:?} {below:?}");
    // The wall's (0, s, s).
    assert_eq!(at(40, 0), [128, 218, 218]);
}

#[test]
fn t_as_gray() {
    let scene = scene();
    let at = picture(&scene, Shade::T);
    // The nearest hit, the middle of the ball, is white.
    let ray = |row, column| {
        let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 41, 41).resolve().unwrap();
        scene.first_hit_of(&camera.exact_ray(Pixel { row, column })).unwrap().t
    };
    let nearest = (0..41).map(|column| ray(20, column)).fold(f64::INFINITY, f64::min);
    assert_eq!(nearest, 4.0);
    assert_eq!(at(20, 20), [255; 3]);
    let expected = (255.0 * 4.0 / ray(40, 0)).round() as u8;
    assert_eq!(at(40, 0), [expected; 3]);
}

#[test]
fn all_at_the_same_t_is_white() {
    let wall = Scene::new(vec![], vec![plane([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])]).unwrap();
    let at = picture(&wall, Shade::T);
    assert_eq!((at(0, 0), at(20, 20), at(40, 7)), ([255; 3], [255; 3], [255; 3]));
}

#[test]
fn objects_flat() {
    let at = picture(&scene(), Shade::Object);
    assert_eq!((at(20, 20), at(20, 23), at(40, 0)), (ORANGE, ORANGE, BLUE));
}

#[test]
fn nothing_hit_is_the_background_in_every_mode() {
    for how in Shade::ALL {
        let at = picture(&Scene::default(), how);
        assert_eq!((at(0, 0), at(20, 20)), (BACKGROUND, BACKGROUND), "{}", how.name());
        // The ray away from the wall.
        let ray = Ray { origin: DVec3::ZERO, direction: DVec3::Z };
        assert_eq!(shade_pixel(&Scene::default(), how, &ray, 1.0, color_of), BACKGROUND);
    }
}

#[test]
fn a_pixel_alone_has_the_pictures_color() {
    let scene = scene();
    let camera = camera(vec3(0.1, 0.2, 0.3), vec3(0.1, -0.1, -1.0), DVec3::Y, 41, 41);
    let camera = camera.resolve().unwrap();
    let raster = Raster::shown_on(camera.image(), 17, 23);
    let frame = trace(&scene, &camera, &raster, Outputs::default());
    let nearest = frame.t.iter().copied().fold(f64::INFINITY, f64::min);
    for how in Shade::ALL {
        let colors = shade(&frame, &scene, how, color_of, |rgb| rgb);
        for (index, color) in colors.into_iter().enumerate() {
            let pixel = frame.at(index / 17, index % 17).pixel;
            let ray = camera.ray_of_pixel(pixel);
            assert_eq!(shade_pixel(&scene, how, &ray, nearest, color_of), color, "{pixel:?}");
        }
    }
}

/// The pixel form is the caller's.
#[test]
fn other_pixel_forms() {
    let scene = scene();
    let camera = camera(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 3, 2).resolve().unwrap();
    let frame = trace(&scene, &camera, &Raster::full(camera.image()), Outputs::default());
    let packed = shade(&frame, &scene, Shade::Object, color_of, |[r, g, b]| {
        u32::from_be_bytes([0, r, g, b])
    });
    assert_eq!(packed.len(), 6);
    assert!(packed.iter().all(|p| [0xe69f00, 0x0072b2, 0xc9d3df].contains(p)), "{packed:x?}");
}

/// Extremely long and short lengths and directions give the same colours as ordinary ones.
#[test]
fn extreme_lengths() {
    for scale in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
        let ball = Sphere { center: vec3(0.0, 0.0, -5.0 * scale), radius: scale };
        let scene = Scene::new(vec![ball], vec![]).unwrap();
        for step in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
            if !(1e-290..1e290).contains(&(scale / step)) {
                continue;
            }
            let ray = Ray { origin: DVec3::ZERO, direction: vec3(0.0, 0.0, -step) };
            let lit = shade_pixel(&scene, Shade::Lambert, &ray, 1.0, color_of);
            assert_eq!(lit, ORANGE, "{scale:e} {step:e}");
            let normal = shade_pixel(&scene, Shade::Normal, &ray, 1.0, color_of);
            assert_eq!(normal, [128, 128, 255], "{scale:e} {step:e}");
        }
    }
}

#[test]
fn names() {
    assert_eq!(Shade::ALL.map(Shade::name), ["lambert", "normal", "t", "object"]);
    assert_eq!(Shade::default(), Shade::Lambert);
}
