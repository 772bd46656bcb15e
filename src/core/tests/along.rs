//! Tests of [`AlongRay`], an object's implicit function f along a ray.

use pinhole_core::*;
use pinhole_reference::Family;
use proptest::prelude::*;

use crate::common::oracle::{Big, Big3, big, near};
use crate::common::seed::config;
use crate::common::{assert_ulps, given, plane, sphere, ulps, vec3, vector};

/// The lecture's camera that looks halfway between -x and -z, given by its view direction.
const AT_45_DEGREES: Camera = Camera {
    orientation: Orientation::View { view: DVec3::new(-1.0, 0.0, -1.0), up: DVec3::Y },
    ..Camera::CANONICAL
};

fn of_ray<'a>(object: &Object, ray: &Ray) -> AlongRay<'a> {
    AlongRay::new(object, ExactRay::from_ray(ray).unwrap()).unwrap()
}

/// Returns f(t) computed with 1200 binary digits.
fn truth(object: &Object, ray: &Ray, t: f64) -> Big {
    let point = |from: DVec3| {
        let along = Big3::from(ray.direction).times(&big(-t));
        Big3::from(ray.origin).minus(&along).minus(&from.into())
    };
    match object {
        Object::Sphere(Sphere { center, radius }) => {
            let offset = point(*center);
            offset.dot(&offset) - big(*radius) * big(*radius)
        }
        Object::Plane(plane) => point(plane.point).dot(&plane.normal.into()),
    }
}

/// Asserts that f(t) is within an ulp of the `f64` nearest to the exact value, has its sign, and is 0
/// if and only if it is 0.
fn assert_right(object: &Object, ray: &Ray, along: &AlongRay, t: f64) -> Result<(), TestCaseError> {
    let (found, exact) = (along.value(t), truth(object, ray, t));
    let (nearest, zero) = (near(&exact), Big::ZERO);
    prop_assert_eq!(found > 0.0, exact > zero, "{} for {} at {}", found, nearest, t);
    prop_assert_eq!(found < 0.0, exact < zero, "{} for {} at {}", found, nearest, t);
    prop_assert!(ulps(found, nearest) <= 1, "{} for {} at {}", found, nearest, t);
    Ok(())
}

#[test]
fn values_of_the_lecture_s_scene() {
    let ball = Object::Sphere(sphere([0.0, 0.0, -5.0], 1.0));
    let ray = Ray::new([0.0; 3], [0.0, 0.0, -1.0]).unwrap();
    let along = of_ray(&ball, &ray);
    let times = [f64::NEG_INFINITY, 0.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    let values = [f64::INFINITY, 24.0, 3.0, 0.0, -1.0, 0.0, 3.0];
    assert_eq!(times.map(|t| along.value(t)), values);
    assert_eq!([4.0, 5.0, 6.0].map(|t| along.slope(t)), [-2.0, 0.0, 2.0]);
    let vertex = along.vertex().unwrap();
    assert_eq!((vertex.t, vertex.value), (5.0, -1.0));
    assert!(along.value(f64::NAN).is_nan());

    // The ray through (0.2, -0.1) misses the ball, so f has no zero.
    let ray = Ray::new([0.0; 3], [0.2, -0.1, -1.0]).unwrap();
    let vertex = of_ray(&ball, &ray).vertex().unwrap();
    assert_ulps(vertex.t, 5.0 / 1.05, 1);
    assert!((vertex.value - (24.0 - 25.0 / 1.05)).abs() < 1e-14 && vertex.value > 0.0);

    let wall = Object::Plane(plane([0.0, 0.0, -6.0], [0.0, 0.0, 2.0]));
    let along = of_ray(&wall, &ray);
    assert_eq!([0.0, 5.0, 6.0, 7.0].map(|t| along.value(t)), [12.0, 2.0, 0.0, -2.0]);
    assert_eq!((along.slope(3.0), along.vertex()), (-2.0, None));
    assert_eq!(along.value(f64::INFINITY), f64::NEG_INFINITY);
    let parallel = of_ray(&wall, &Ray::new([0.0; 3], [1.0, 0.0, 0.0]).unwrap());
    assert_eq!(
        (parallel.slope(0.0), parallel.value(1e9), parallel.value(f64::INFINITY)),
        (0.0, 12.0, 12.0)
    );
    assert!(
        AlongRay::new(&Object::Sphere(sphere([0.0; 3], 0.0)), ExactRay::from_ray(&ray).unwrap())
            .is_err()
    );
}

/// Along a line that touches a sphere, f is 0 at one t, and positive on both sides of it.
#[test]
fn a_tangent_touches_zero() {
    let ball = Object::Sphere(sphere([1.0, 0.0, -5.0], 1.0));
    let along = of_ray(&ball, &Ray::new([0.0; 3], [0.0, 0.0, -1.0]).unwrap());
    assert_eq!((along.value(5.0), along.slope(5.0)), (0.0, 0.0));
    assert!(along.value(5_f64.next_up()) > 0.0 && along.value(5_f64.next_down()) > 0.0);
    let vertex = along.vertex().unwrap();
    assert_eq!((vertex.t, vertex.value, vertex.value.is_sign_negative()), (5.0, 0.0, false));
}

/// f changes its sign at the roots of view rays, which are irrational, because the directions contain
/// square roots.
#[test]
fn the_sign_changes_at_certified_roots_of_view_rays() {
    let resolved = AT_45_DEGREES.resolve().unwrap();
    let objects = [
        Object::Plane(plane([0.0, 0.0, -6.0], [0.0, 0.0, 1.0])),
        Object::Sphere(sphere([-4.0, 0.0, -5.0], 2.0)),
        Object::Sphere(sphere([-0.5, 0.25, 0.125], 3.0)),
    ];
    let mut roots = 0;
    for row in (0..400).step_by(23) {
        for column in (0..400).step_by(23) {
            let ray = resolved.exact_ray(Pixel { row, column });
            for object in &objects {
                let along = AlongRay::new(object, ray).unwrap();
                for t in object.roots_of(&ray).iter() {
                    let slope = along.slope(t);
                    let (before, after) = (along.value(t.next_down()), along.value(t.next_up()));
                    assert!(before * slope < 0.0 && after * slope > 0.0, "{object:?} at {t}");
                    // The value of f at a distance of half an ulp of t from the root.
                    let step = t.abs().next_up() - t.abs();
                    assert!(along.value(t).abs() <= 0.51 * step * slope.abs());
                    roots += 1;
                }
            }
        }
    }
    assert!(roots > 300, "{roots}");
}

/// Tests f at and next to the roots of the reference's difficult rays: grazing, far from the origin,
/// and of extreme scale.
#[test]
fn right_next_to_the_roots_of_the_reference_s_rays() {
    let mut values = 0;
    for family in Family::all() {
        for &knob in family.knobs {
            for case in family.rays(knob, 5, 2) {
                let ray = Ray { origin: case.origin.into(), direction: case.direction.into() };
                for object in given::scene(&case.objects).objects() {
                    let along = of_ray(&object, &ray);
                    for t in object.roots(&ray).iter().filter(|t| t.is_finite()) {
                        for t in [t.next_down(), t, t.next_up(), 2.0 * t, 0.5 * t] {
                            let exact = truth(&object, &ray, t);
                            let nearest = near(&exact);
                            // 1200 binary digits are too few for the sum of 1 and the square of 1e-200.
                            let is_plain = t == 0.0 || t.abs() > 1e-150;
                            if is_plain
                                && nearest.is_finite()
                                && (nearest.is_normal() || exact == Big::ZERO)
                            {
                                assert_right(&object, &ray, &along, t).unwrap();
                                values += 1;
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(values > 1000, "{values}");
}

fn object() -> impl Strategy<Value = Object> {
    (vector(-2.0..3.0), vector(-2.0..2.0), -2.0..2.0_f64, any::<bool>()).prop_map(
        |(position, normal, power, is_sphere)| {
            if is_sphere {
                Object::Sphere(Sphere { center: position, radius: 10_f64.powf(power) })
            } else {
                Object::Plane(Plane { point: position, normal })
            }
        },
    )
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn right_at_any_time_and_next_to_roots(
        object in object(), origin in vector(-3.0..2.0), direction in vector(-3.0..3.0),
        t in -1e3..1e3_f64, scale in prop_oneof![Just(1.0), Just(1e-120), Just(1e120)],
    ) {
        // Everything but t grows: f by the square, or with the normal.
        let object = match object {
            Object::Sphere(Sphere { center, radius }) => {
                Object::Sphere(Sphere { center: center * scale, radius: radius * scale })
            }
            Object::Plane(Plane { point, normal }) => {
                Object::Plane(Plane { point: point * scale, normal: normal * scale })
            }
        };
        let ray = Ray { origin: origin * scale, direction: direction * scale };
        let along = of_ray(&object, &ray);
        for t in [t, 0.0, 1e-3 * t, 1e-150, -1e100 / scale.max(1.0)] {
            assert_right(&object, &ray, &along, t)?;
        }
        for t in object.roots(&ray).iter() {
            for t in [t, t.next_up(), t.next_down(), t * (1.0 + 1e-12), t * (1.0 - 1e-14)] {
                assert_right(&object, &ray, &along, t)?;
            }
        }
    }

    /// The slope is the derivative of f, and the vertex is the t at which f is smallest.
    #[test]
    fn slope_and_vertex_belong_to_the_parabola(
        object in object(), origin in vector(-3.0..2.0), direction in vector(-1.0..1.0), t in -10.0..10.0_f64,
    ) {
        let ray = Ray { origin, direction };
        let along = of_ray(&object, &ray);
        // For a polynomial of degree 2, the symmetric difference quotient equals the derivative.
        let (before, after) = (truth(&object, &ray, t - 1.0), truth(&object, &ray, t + 1.0));
        let width = (t + 1.0) - (t - 1.0);
        let difference = near(&((after - before) / big(width)));
        let size = along.value(t - 1.0).abs() + along.value(t + 1.0).abs();
        prop_assert!((along.slope(t) - difference).abs() <= 1e-14 * size);
        if let Some(vertex) = along.vertex() {
            prop_assert!(along.slope(vertex.t).abs() <= 4e-16 * along.slope(vertex.t + 1.0) * (1.0 + vertex.t.abs()));
            let least = along.value(vertex.t);
            prop_assert!((least - vertex.value).abs() <= 1e-15 * vertex.value.abs().max(1e-15 * along.value(0.0)));
            prop_assert!(along.value(vertex.t + 0.5) > least && along.value(vertex.t - 0.5) > least);
            let Object::Sphere(sphere) = object else { unreachable!("a plane has no vertex") };
            prop_assert!(vertex.value >= -sphere.radius * sphere.radius * (1.0 + 1e-15));
        }
    }
}

#[test]
fn far_out_it_is_infinite_and_not_nan() {
    let ball = Object::Sphere(sphere([0.0, 0.0, -5.0], 1.0));
    let along = of_ray(&ball, &Ray::new([0.0; 3], [0.0, 0.0, -1.0]).unwrap());
    assert_eq!([1e200, -1e200, f64::MAX].map(|t| along.value(t)), [f64::INFINITY; 3]);
    assert_eq!([1e200, -1e200].map(|t| along.slope(t)), [2e200, -2e200]);
    assert_eq!(along.slope(f64::NEG_INFINITY), f64::NEG_INFINITY);
    assert_eq!(along.value(1e-200), 24.0);
    assert_eq!(along.slope(1e-200), -10.0);
    let long = Ray { origin: vec3(1e-300, 0.0, 0.0), direction: vec3(0.0, 0.0, -1e300) };
    let along = of_ray(&ball, &long);
    assert!(along.value(4e-300).abs() < 1e-14);
    assert_eq!(along.value(5e-300).round(), -1.0);
}
