//! The lecture's answers, to 2 ulp.

use std::f64::consts::{FRAC_1_SQRT_2 as S, SQRT_2};

use pinhole_core::*;

use crate::common::{assert_ulps, assert_ulps3, exact, plane, root_on, roots_on, sphere, vec3};

const BACK_WALL: Plane = Plane { point: DVec3::new(0.0, 0.0, -6.0), normal: DVec3::Z };
const WARM_UP: DVec2 = DVec2::new(0.2, -0.1);

fn with_distance(distance: f64) -> ResolvedCamera {
    let viewport = Viewport { distance, ..Viewport::CANONICAL };
    Camera { viewport, ..Camera::CANONICAL }.resolve().unwrap()
}

fn first_hit(planes: Vec<Plane>, ray: &Ray) -> Root {
    Scene::new(vec![], planes).unwrap().first_hit(ray).unwrap()
}

#[test]
fn warm_up_1a_the_view_ray() {
    let ray = with_distance(1.0).ray(WARM_UP);
    assert_eq!(ray, Ray { origin: DVec3::ZERO, direction: vec3(0.2, -0.1, -1.0) });
}

#[test]
fn warm_up_1b_the_back_wall() {
    let hit = first_hit(vec![BACK_WALL], &with_distance(1.0).ray(WARM_UP));
    assert_ulps(hit.t, 6.0, 0);
    assert_ulps3(hit.point, vec3(1.2, -0.6, -6.0), 2);
    assert_eq!(hit.normal, DVec3::Z);
}

#[test]
fn at_distance_two_z_becomes_minus_two() {
    let ray = with_distance(2.0).ray(WARM_UP);
    assert_eq!(ray.direction, vec3(0.2, -0.1, -2.0));
    let hit = first_hit(vec![BACK_WALL], &ray);
    assert_ulps(hit.t, 3.0, 0);
    assert_ulps3(hit.point, vec3(0.6, -0.3, -6.0), 2);
}

fn assert_forty_five(orientation: Orientation) {
    let camera = Camera { orientation, ..Camera::CANONICAL }.resolve().unwrap();
    let Basis { u, v, w } = *camera.basis();
    assert_ulps3(u, vec3(S, 0.0, -S), 2);
    assert_ulps3(v, DVec3::Y, 2);
    assert_ulps3(w, vec3(S, 0.0, S), 2);
    let ray = camera.ray(WARM_UP);
    assert_ulps3(ray.direction, vec3(-0.8 * S, -0.1, -1.2 * S), 2);
    let hit = first_hit(vec![BACK_WALL], &ray);
    assert_ulps(hit.t, 5.0 * SQRT_2, 2);
    assert_ulps3(hit.point, vec3(-4.0, -SQRT_2 / 2.0, -6.0), 2);
}

#[test]
fn forty_five_degrees_however_it_is_given() {
    let by_hand = Basis { u: vec3(S, 0.0, -S), v: DVec3::Y, w: vec3(S, 0.0, S) };
    assert_forty_five(Orientation::Basis(by_hand));
    assert_forty_five(Orientation::View { view: vec3(-1.0, 0.0, -1.0), up: DVec3::Y });
    assert_forty_five(Orientation::At { at: vec3(-3.0, 0.0, -3.0), up: vec3(0.0, 2.0, 0.0) });
}

#[test]
fn the_warm_ups_uv_is_the_corner_of_four_pixels() {
    let camera = with_distance(1.0);
    let position = camera.pixel_of_uv(WARM_UP).unwrap();
    assert_eq!((position.column_edge, position.row_edge), (Some(280), Some(240)));
    assert_eq!(position.pixel, Pixel { row: 240, column: 280 });
    let touching = [(239, 279), (239, 280), (240, 279), (240, 280)];
    assert_eq!(
        position.touching(camera.image()),
        touching.map(|(row, column)| Pixel { row, column })
    );
}

#[test]
fn the_courses_pixel_100_200() {
    let pixel = Pixel { row: 99, column: 199 };
    let uv = with_distance(1.0).uv_of_pixel(pixel);
    assert_ulps(uv.x, -1.0 / 800.0, 0);
    assert_ulps(uv.y, 201.0 / 800.0, 0);
}

#[test]
fn a_sphere_through_the_middle() {
    let ball = sphere([0.0, 0.0, -5.0], 1.0);
    let camera = with_distance(1.0);
    assert_eq!(ball.roots(&camera.ray(DVec2::ZERO)), Roots::Two(4.0, 6.0));
    assert_eq!(ball.roots(&camera.ray(WARM_UP)), Roots::None);
    let quadratic = SphereQuadratic { a: 1.0, b: -5.0, c: 24.0, discriminant: 1.0 };
    assert_eq!(ball.quadratic_of(&exact(&camera.ray(DVec2::ZERO))), quadratic);
}

#[test]
fn looking_down_with_up_aslant() {
    let basis = Basis::from_view_up(vec3(0.0, -1.0, 0.0), vec3(1.0, 1.0, 0.0)).unwrap();
    assert_eq!(basis, Basis { u: DVec3::Z, v: DVec3::X, w: DVec3::Y });
}

#[test]
fn look_at() {
    let (eye, at) = (vec3(20.0, 4.0, 10.0), vec3(-1.0, 0.0, -5.0));
    let Basis { u, v, w } = Basis::from_eye_at_up(eye, at, DVec3::Y).unwrap();
    assert_ulps3(u, vec3(5.0, 0.0, -7.0) / 74_f64.sqrt(), 2);
    assert_ulps3(w, vec3(21.0, 4.0, 15.0) / 682_f64.sqrt(), 2);
    // w x u, over the common denominator sqrt(682 * 74).
    assert_ulps3(v, vec3(-28.0, 222.0, -20.0) / 50_468_f64.sqrt(), 2);
}

/// Tests the lecture's examples of lines in two dimensions, as planes parallel to the z axis.
#[test]
fn lines_in_two_dimensions() {
    let ray = Ray { origin: DVec3::ZERO, direction: vec3(1.0, 1.0, 0.0) };
    let ahead = plane([2.0, 0.0, 0.0], [1.0, 1.0, 0.0]);
    assert_eq!(ahead.roots(&ray), Roots::One(1.0));
    assert_eq!(root_on(ahead, &ray).point, vec3(1.0, 1.0, 0.0));

    let behind = plane([0.0, 1.0, 0.0], [2.0, -1.0, 0.0]);
    assert_eq!(behind.roots(&ray), Roots::One(-1.0));
    assert_eq!(behind.roots(&ray).first_positive(), None);
    assert_eq!(Scene::new(vec![], vec![behind]).unwrap().first_hit(&ray), None);
}

/// The ray straight down from the eye hits the lecture's floor, a huge sphere, at t = 1 exactly.
#[test]
fn the_planet_under_the_eye() {
    let planet = sphere([0.0, -5001.0, 0.0], 5000.0);
    let down = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Y };
    assert_eq!(planet.roots(&down), Roots::Two(1.0, 10_001.0));
    let hit = roots_on(planet, &down)[0];
    assert_eq!((hit.t, hit.point, hit.normal), (1.0, DVec3::NEG_Y, DVec3::Y));
}

/// Where the middle ray of a camera hits an object at its `at`, the origin, the hit's coordinates are
/// exactly 0, although t is rounded.
#[test]
fn coordinates_that_cancel_are_zero() {
    let orientation = Orientation::At { at: DVec3::ZERO, up: DVec3::Y };
    let camera = Camera { eye: vec3(0.0, 6.0, 4.0), orientation, ..Camera::CANONICAL };
    let resolved = camera.resolve().unwrap();
    let ray = resolved.exact_ray_at(DVec2::ZERO).unwrap();
    let objects = (vec![sphere([0.0, 0.3, 0.0], 0.3)], vec![plane([0.0; 3], [0.0, 1.0, 1.0])]);
    let ranked = Scene::new(objects.0, objects.1).unwrap().ranked_roots_of(&ray);
    let roots: Vec<Root> = ranked.into_iter().map(|ranked| ranked.root).collect();
    let at_origin: Vec<_> = roots.iter().filter(|root| root.t > 7.0).collect();
    assert_eq!(at_origin.len(), 2);
    for root in at_origin {
        assert_ulps(root.t, 52_f64.sqrt(), 0);
        assert_eq!(root.point, DVec3::ZERO);
    }
    assert_eq!(
        roots.iter().find(|root| root.t > 7.0 && root.object == 0).unwrap().normal,
        -DVec3::Y
    );
}

/// The exact t lies halfway between two `f64` numbers and is rounded to the even one. It is `s - q` for
/// a ray through the centre of a ball, where s is the centre's t, and q, the radius in units of t, is
/// an odd number of half ulps.
#[test]
fn a_root_half_way_between_two_numbers_is_the_even_one() {
    let half_ulp = f64::EPSILON / 2.0;
    for k in 1..2000_u64 {
        let digits = k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 16;
        let (s, q) = ((1 << 52) + (digits >> 1) * 32, 2 * (digits % 1000) + 1);
        let direction = vec3(3.0, 4.0, 12.0);
        let ball = Sphere {
            center: s as f64 * half_ulp * 2.0 * direction,
            radius: 13.0 * q as f64 * half_ulp,
        };
        let ray = Ray { origin: DVec3::ZERO, direction };
        let scene = Scene::new(vec![ball], vec![]).unwrap();
        let near = scene.ranked_roots_of(&ExactRay::from_ray(&ray).unwrap())[0];
        // The exact t in half ulps. Converting the integer to `f64` rounds to even, too.
        let t = 2 * s - q;
        let expected = [t, 13 * t].map(|whole| whole as f64 * half_ulp);
        assert_eq!([near.root.t, near.distance], expected, "{s} {q}");
    }
}

#[test]
fn a_point_has_the_eye_s_coordinate_where_the_ray_has_no_part_of_it() {
    let ball = sphere([0.0, -3.0, -5.0], 5.0);
    let ray = Ray { origin: DVec3::ZERO, direction: vec3(0.25, 0.0, -1.0) };
    assert_eq!(Scene::new(vec![ball], vec![]).unwrap().first_hit(&ray).unwrap().point.y, 0.0);
}
