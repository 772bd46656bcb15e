//! Helpers of several tests.
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod bases;
pub(crate) mod frames;
pub(crate) mod given;
pub(crate) mod invalid;
pub(crate) mod levels;
pub(crate) mod margins;
pub(crate) mod oracle;
pub(crate) mod seed;

use pinhole_core::methods::{Method, MethodHit, ray_kernel};
use pinhole_core::*;
use proptest::prelude::*;

/// A point or direction.
pub(crate) fn vec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Generates vectors of any direction whose length is about 10 to a power in the range.
pub(crate) fn vector(powers: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    let coordinate = || -1.0..1.0_f64;
    ((coordinate(), coordinate(), coordinate()), powers)
        .prop_map(|((x, y, z), power)| DVec3::new(x, y, z) * 10_f64.powf(power))
        .prop_filter("a zero vector points nowhere", |v| *v != DVec3::ZERO)
}

/// A sphere.
pub(crate) fn sphere(center: [f64; 3], radius: f64) -> Sphere {
    Sphere { center: DVec3::from_array(center), radius }
}

/// A plane.
pub(crate) fn plane(point: [f64; 3], normal: [f64; 3]) -> Plane {
    Plane { point: DVec3::from_array(point), normal: DVec3::from_array(normal) }
}

/// Number of `f64`s between two numbers, counted across 0.
pub(crate) fn ulps(a: f64, b: f64) -> u64 {
    assert!(!a.is_nan() && !b.is_nan(), "{a} against {b}");
    let rank = |x: f64| {
        let bits = x.to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    rank(a).abs_diff(rank(b))
}

/// Asserts that two numbers are at most `most` ulps apart.
#[track_caller]
pub(crate) fn assert_ulps(actual: f64, expected: f64, most: u64) {
    let apart = ulps(actual, expected);
    assert!(apart <= most, "{actual:?} is {apart} ulp from {expected:?}");
}

/// [`assert_ulps`] of each coordinate.
#[track_caller]
pub(crate) fn assert_ulps3(actual: DVec3, expected: DVec3, most: u64) {
    for axis in 0..3 {
        let apart = ulps(actual[axis], expected[axis]);
        assert!(apart <= most, "{actual:?} is {apart} ulp from {expected:?} in coordinate {axis}");
    }
}

/// Returns all roots of a ray with a scene's objects; none for an invalid ray.
pub(crate) fn roots_of(scene: &Scene, ray: &Ray) -> Vec<Root> {
    let Ok(ray) = ExactRay::from_ray(ray) else { return Vec::new() };
    scene.ranked_roots_of(&ray).into_iter().map(|ranked| ranked.root).collect()
}

/// Returns the roots of a ray with one sphere, with their points and normals.
pub(crate) fn roots_on(sphere: Sphere, ray: &Ray) -> Vec<Root> {
    roots_of(&Scene::new(vec![sphere], vec![]).unwrap(), ray)
}

/// Returns the root of a ray with one plane, with its point and normal.
pub(crate) fn root_on(plane: Plane, ray: &Ray) -> Root {
    roots_of(&Scene::new(vec![], vec![plane]).unwrap(), ray)[0]
}

/// The first hit of one ray by a method.
pub(crate) fn first_hit_by(method: Method, scene: &Scene, ray: &Ray) -> Option<MethodHit> {
    let mut kernel = ray_kernel(method, &[(scene.clone(), *ray)])?;
    kernel.run();
    kernel.hit(0)
}

/// Returns the colour of one ray's first hit. `nearest` is the `t` that is white in the shading
/// [`Shade::T`].
pub(crate) fn shade_pixel(
    scene: &Scene,
    shade: Shade,
    ray: &Ray,
    nearest: f64,
    color_of: impl Fn(u32) -> Rgb,
) -> Rgb {
    let color = |hit: Root| {
        HitShader::new(scene, shade, nearest).color(ray, hit.object, hit.t, color_of(hit.object))
    };
    scene.first_hit(ray).map_or(BACKGROUND, color)
}

/// A ray with all its digits.
pub(crate) fn exact(ray: &Ray) -> ExactRay<'static> {
    ExactRay::from_ray(ray).unwrap()
}

/// The angle between up and view.
pub(crate) fn up_angle(view: DVec3, up: DVec3) -> Result<UpAngle, BasisError> {
    Camera { orientation: Orientation::View { view, up }, ..Camera::CANONICAL }.up_angle()
}

/// Returns a camera at `eye` that looks along `view`, with the canonical viewport.
pub(crate) fn camera(eye: DVec3, view: DVec3, up: DVec3, width: u32, height: u32) -> Camera {
    Camera {
        eye,
        orientation: Orientation::View { view, up },
        image: ImageSize::new(width, height).unwrap(),
        ..Camera::CANONICAL
    }
}

/// A generator of pseudorandom numbers in `[0, 1)`, the same in every run (Knuth's MMIX generator).
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    /// The next number in `[0, 1)`.
    pub(crate) fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The next number in `[from, to)`.
    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }

    /// A point in the cube from `-reach` to `reach`.
    pub(crate) fn point(&mut self, reach: f64) -> DVec3 {
        let mut x = || self.between(-reach, reach);
        DVec3::new(x(), x(), x())
    }
}
