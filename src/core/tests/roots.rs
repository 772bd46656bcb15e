//! Tests of the roots of rays with spheres and planes: known roots are found, and roots that are found
//! lie on the surface.

use pinhole_core::*;
use proptest::prelude::*;

use crate::common::seed::config;
use crate::common::{assert_ulps, exact, oracle, plane, root_on, roots_of, roots_on, sphere, vec3};

fn point() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64].prop_map(DVec3::from_array)
}

fn direction() -> impl Strategy<Value = DVec3> {
    point().prop_filter("points somewhere", |d| d.length() > 1e-3)
}

fn unit() -> impl Strategy<Value = DVec3> {
    direction().prop_map(DVec3::normalize)
}

fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|e| 10_f64.powf(e))
}

/// Generates a sphere, and a ray whose origin is at a distance of up to a million radii from its
/// centre.
fn sphere_and_ray() -> impl Strategy<Value = (Sphere, Ray)> {
    let target = prop_oneof![point(), unit(), point().prop_map(|p| 2.0 * p)];
    (point(), magnitude(-3.0, 3.0), unit(), magnitude(-3.0, 6.0), target, magnitude(-9.0, 9.0))
        .prop_filter_map("has a direction", |(center, radius, from, away, target, length)| {
            let origin = center + radius * away * from;
            let toward = center + radius * target - origin;
            let direction = length * toward.normalize();
            direction.is_finite().then_some((Sphere { center, radius }, Ray { origin, direction }))
        })
}

/// Returns the maximum distance of a root's point from the surface: a few rounding errors of the
/// lengths from which it is computed.
fn reach_of_rounding(sphere: &Sphere, ray: &Ray) -> f64 {
    let away = ray.origin.distance(sphere.center);
    16.0 * f64::EPSILON * (away + sphere.radius + ray.origin.length())
}

proptest! {
    #![proptest_config(config(5000))]

    #[test]
    fn planted_roots_of_a_sphere_are_found(
        center in point(), radius in magnitude(-3.0, 3.0), normal in unit(), toward in unit(),
        steps in magnitude(-3.0, 3.0), t in magnitude(-6.0, 6.0), behind in any::<bool>(),
    ) {
        // The ray must not be nearly tangent, so that rounding of the input hardly moves the root.
        let steepness = normal.dot(toward).abs();
        prop_assume!(steepness > 0.1);
        let on_sphere = center + radius * normal;
        let t = if behind { -t } else { t };
        let direction = toward * (steps * radius / t);
        let ray = Ray { origin: on_sphere - t * direction, direction };
        let sphere = Sphere { center, radius };
        let error = |root: f64| (root - t).abs() * direction.length();
        let tolerance = 4.0 * reach_of_rounding(&sphere, &ray) / steepness;
        let roots = sphere.roots(&ray);
        let nearest = roots.iter().map(error).fold(f64::INFINITY, f64::min);
        prop_assert!(nearest <= tolerance, "{nearest:e} > {tolerance:e}: {roots:?}, planted {t}");
    }

    #[test]
    fn roots_found_lie_on_the_sphere((sphere, ray) in sphere_and_ray()) {
        for Root { t, point, normal, .. } in roots_on(sphere, &ray) {
            let beside = ((ray.at(t) - sphere.center).length() - sphere.radius).abs();
            let rounding = reach_of_rounding(&sphere, &ray);
            prop_assert!(beside <= rounding, "{beside:e} beside, rounding {rounding:e}");
            let beside = ((point - sphere.center).length() - sphere.radius).abs();
            let rounding = 4.0 * f64::EPSILON * (sphere.radius + sphere.center.length());
            prop_assert!(beside <= rounding, "point {beside:e} beside");
            prop_assert!((normal.length() - 1.0).abs() <= 4.0 * f64::EPSILON);
        }
    }

    /// The ray enters the sphere at the first root and leaves it at the second, so the outward normal
    /// points against the ray there, and along it here.
    #[test]
    fn normals_point_outwards((sphere, ray) in sphere_and_ray()) {
        if let [enters, leaves] = roots_on(sphere, &ray)[..] {
            prop_assert!(enters.t <= leaves.t);
            let along = ray.direction.normalize();
            for (Root { t, point, normal, .. }, sign) in [(enters, -1.0), (leaves, 1.0)] {
                let slack = 1e-7;
                prop_assert!(sign * normal.dot(along) >= -slack, "{normal:?} at {t}");
                prop_assert!(normal.dot(point - sphere.center) > 0.0);
            }
        }
    }

    /// Compares with arithmetic of 1200 binary digits. The tolerance is a few rounding errors of the
    /// lengths involved, divided by the cosine at the surface. Hit or miss may be wrong only if the ray
    /// passes as close to the outline as this.
    #[test]
    fn roots_and_decisions_against_1200_digits((sphere, ray) in sphere_and_ray()) {
        let away = ray.origin.distance(sphere.center);
        // The distance, in radii, by which rounding may move the ray.
        let rounding = 16.0 * f64::EPSILON * (away + sphere.radius) / sphere.radius;
        let (found, exact) = (sphere.roots(&ray), oracle::sphere_roots(&sphere, &ray));
        let half_chord = exact.map_or(0.0, |[t0, t1]| {
            0.5 * (t1 - t0) * ray.direction.length() / sphere.radius
        });
        match (found, exact) {
            (Roots::Two(t0, t1), Some(exact)) => for (t, exact) in [(t0, exact[0]), (t1, exact[1])] {
                let error = (t - exact).abs() * ray.direction.length() / sphere.radius;
                let tolerance = rounding * (1.0 + 1.0 / half_chord.max(rounding.sqrt()));
                prop_assert!(error <= tolerance, "{t} against {exact}: {error:e} > {tolerance:e}");
            },
            (Roots::None, None) => {}
            // A half chord of h radii is h^2 / 2 away from the outline.
            (_, Some(_)) => prop_assert!(0.5 * half_chord * half_chord <= rounding, "{found:?}"),
            (_, None) => {
                let wider = Sphere { radius: sphere.radius * (1.0 + rounding), ..sphere };
                prop_assert!(oracle::sphere_roots(&wider, &ray).is_some(), "{found:?}");
            }
        }
    }

    /// For an eye close above a huge sphere, t is as accurate as the height of the eye is: the
    /// coefficient c loses no digits by cancellation.
    #[test]
    fn a_planet_from_just_above(
        radius in magnitude(3.0, 8.0), height in magnitude(-3.0, 1.0), aside in -1.0..1.0_f64,
        down in magnitude(-2.0, 0.0), eye in point(),
    ) {
        let planet = sphere([0.0, -radius - height, 0.0], radius);
        // Not at the origin: eye - centre is rounded, and its error is far larger than the height's.
        let origin = vec3(eye.x, eye.y.abs() * height, eye.z);
        let ray = Ray { origin, direction: vec3(aside, -down, -1.0) };
        // Well below the horizon.
        prop_assume!(down > 8.0 * (2.0 * height / radius).sqrt());
        let exact = oracle::sphere_roots(&planet, &ray).unwrap();
        let t = planet.roots(&ray).first_positive().unwrap();
        let tolerance = 16.0 * f64::EPSILON / down * exact[0];
        prop_assert!((t - exact[0]).abs() <= tolerance, "{t} against {}", exact[0]);
    }

    /// If all lengths, or the direction, are multiplied by a power of two, from 1e-250 to 1e250, the
    /// results are bit for bit the same, except for this factor.
    #[test]
    fn scaling_by_powers_of_two_changes_no_bit(
        (sphere, ray) in sphere_and_ray(), lengths in -800..800_i32, ratio in -899..900_i32,
    ) {
        let steps = (lengths - ratio).clamp(-800, 800);
        let (by, step) = (2_f64.powi(lengths), 2_f64.powi(steps));
        let large = Sphere { center: by * sphere.center, radius: by * sphere.radius };
        let scaled = Ray { origin: by * ray.origin, direction: step * ray.direction };
        let t = 2_f64.powi(lengths - steps);
        let (found, expected) = (large.roots(&scaled), sphere.roots(&ray));
        prop_assert!(found.iter().eq(expected.iter().map(|root| t * root)), "{found:?} {expected:?}");

        let wall = Plane { point: sphere.center, normal: sphere.center };
        let far_wall = Plane { point: large.center, normal: step * sphere.center };
        let (found, expected) = (far_wall.roots(&scaled), wall.roots(&ray));
        prop_assert!(found.iter().eq(expected.iter().map(|root| t * root)), "{found:?} {expected:?}");
    }

    #[test]
    fn planted_roots_of_a_plane_are_found(
        point in point(), normal in direction(), aside in point(), direction in direction(),
        t in magnitude(-6.0, 6.0), behind in any::<bool>(),
    ) {
        let steepness = normal.normalize().dot(direction.normalize()).abs();
        prop_assume!(steepness > 0.01);
        let t = if behind { -t } else { t };
        // A point of the plane, from any other.
        let n = normal.normalize();
        let on_plane = point + 10.0 * (aside - aside.dot(n) * n);
        let ray = Ray { origin: on_plane - t * direction, direction };
        let wall = Plane { point, normal };
        let Roots::One(found) = wall.roots(&ray) else { panic!("no root") };
        let reach = ray.origin.length() + 20.0;
        let tolerance = 16.0 * f64::EPSILON * reach / steepness;
        let error = (found - t).abs() * direction.length();
        prop_assert!(error <= tolerance, "{error:e} > {tolerance:e}");

        let Root { point: q, normal, .. } = root_on(wall, &ray);
        let beside = (q - point).dot(n).abs();
        let size = q.length() + point.length();
        prop_assert!(beside <= 4.0 * f64::EPSILON * size, "{beside:e} beside");
        prop_assert!((normal - n).length() <= 4.0 * f64::EPSILON);
        let PlaneTerms { rate, offset } = wall.terms_of(&exact(&ray));
        prop_assert!((offset / rate - found).abs() <= 3.0 * f64::EPSILON * found.abs());
    }

    #[test]
    fn the_first_hit_is_the_smallest_positive_root(
        objects in prop::collection::vec(sphere_and_ray(), 1..6), walls in prop::collection::vec(
            (point(), direction()), 0..3), ray in sphere_and_ray(),
    ) {
        let spheres = objects.into_iter().map(|(sphere, _)| sphere).chain([ray.0]).collect();
        let planes = walls.into_iter().map(|(point, normal)| Plane { point, normal }).collect();
        let scene = Scene::new(spheres, planes).unwrap();
        let ray = ray.1;
        let roots = roots_of(&scene, &ray);
        prop_assert!(roots.is_sorted_by(|a, b| a.t <= b.t));
        prop_assert_eq!(scene.first_hit(&ray), roots.into_iter().find(|root| root.t > 0.0));
    }

    /// The coefficients that are displayed are consistent with the roots: their discriminant is
    /// negative if and only if there is none.
    #[test]
    fn the_quadratics_parts((sphere, ray) in sphere_and_ray()) {
        let SphereQuadratic { a, b, c, discriminant } = sphere.quadratic_of(&exact(&ray));
        prop_assert_eq!(sphere.roots(&ray) == Roots::None, discriminant < 0.0);
        let (d, oc) = (ray.direction, ray.origin - sphere.center);
        let near = |x: f64, y: f64, size: f64| (x - y).abs() <= 8.0 * f64::EPSILON * size;
        prop_assert!(near(a, d.length_squared(), a));
        prop_assert!(near(b, d.dot(oc), d.length() * oc.length()));
        prop_assert_eq!(c, sphere.implicit(ray.origin));
        let rounding = 32.0 * f64::EPSILON * (b * b + (a * c).abs() + a * sphere.radius.powi(2));
        prop_assert!((b * b - a * c - discriminant).abs() <= rounding);
    }
}

/// Normals of a sphere that is 10^12 radii away are correctly rounded, although `p + t d - center` in
/// `f64` has only about three digits.
#[test]
fn normals_of_tiny_far_spheres() {
    for offset in [0.0, 0.3, 0.7] {
        let origin = vec3(0.1, -0.2, 0.3);
        let ray = Ray { origin, direction: vec3(0.2, -0.1, -1.0) };
        let far = sphere([2e5, -1e5, -1e6], 1e-6);
        // The sphere is put so that the ray passes its centre at `offset` radii.
        let along = ray.direction.normalize();
        let aside = along.cross(DVec3::X).normalize();
        let center = ray.at(1e6) + offset * far.radius * aside;
        let far = Sphere { center, ..far };
        let from_center = oracle::Big3::from(ray.origin).minus(&far.center.into());
        let direction = oracle::Big3::from(ray.direction);
        let a = direction.dot(&direction);
        let b = direction.dot(&from_center);
        let r = oracle::big(far.radius);
        let c = from_center.dot(&from_center) - &r * &r;
        let swing = (&b * &b - &a * &c).sqrt();
        let roots = roots_on(far, &ray);
        for (swing, root) in [-swing.clone(), swing].into_iter().zip(&roots) {
            let t = (swing - &b) / &a;
            let at = from_center.minus(&direction.times(&-t));
            let exact = at.times(&(oracle::big(1.0) / &r));
            let error = exact.error_of(root.normal);
            assert!(error <= 1.2e-16, "{error:e}");
        }
    }
}

/// A ray that touches a sphere hits it. For a Pythagorean triple (x, y, z), the ray along `(x, 0, -y)`
/// exactly touches the sphere of radius x around `(0, 0, -z)`.
#[test]
fn a_tangent_is_a_hit() {
    for m in 2..40_i32 {
        for n in 1..m {
            let (x, y, z) = (m * m - n * n, 2 * m * n, m * m + n * n);
            for k in [-300, -40, 0, 7, 300] {
                let [x, y, z] = [x, y, z].map(|i| f64::from(i) * 2_f64.powi(k));
                let touched = sphere([0.0, 0.0, -z], x);
                let ray = Ray { origin: DVec3::ZERO, direction: vec3(x, 0.0, -y) };
                // Touched at y along a ray of length z: t = y / z.
                let Roots::One(t) = touched.roots(&ray) else {
                    panic!("{x} {y} {z}: {:?}", touched.roots(&ray))
                };
                assert_ulps(t, y / z, 1);
                let (smaller, larger) = (x * (1.0 - 1e-12), x * (1.0 + 1e-12));
                assert_eq!(Sphere { radius: smaller, ..touched }.roots(&ray), Roots::None);
                let larger = Sphere { radius: larger, ..touched }.roots(&ray);
                assert!(matches!(larger, Roots::Two(..)), "{larger:?}");
            }
        }
    }
}

#[test]
fn t_zero_is_no_hit() {
    let ball = sphere([0.0, 0.0, -5.0], 5.0);
    let first_hit =
        |direction| ball.roots(&Ray { origin: DVec3::ZERO, direction }).first_positive();
    assert_eq!(first_hit(DVec3::NEG_Z), Some(10.0));
    assert_eq!(first_hit(vec3(1.0, 0.0, -1.0)), Some(5.0));
    assert_eq!(first_hit(DVec3::Z), None);
    assert_eq!(first_hit(DVec3::X), None);
    assert_eq!(ball.roots(&Ray { origin: DVec3::ZERO, direction: DVec3::X }), Roots::One(0.0));

    let floor = plane([3.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let on_floor = Ray { origin: vec3(7.0, 0.0, 1.0), direction: vec3(0.0, 1.0, 0.0) };
    assert_eq!(floor.roots(&on_floor), Roots::One(0.0));
    assert_eq!(floor.roots(&on_floor).first_positive(), None);
}

#[test]
fn from_inside_the_far_root_is_seen() {
    let around = sphere([0.0, 0.0, -1.0], 3.0);
    let ray = Ray { origin: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(around.roots(&ray), Roots::Two(-2.0, 4.0));
    let scene = Scene::new(vec![around], vec![]).unwrap();
    let hit = scene.first_hit(&ray).unwrap();
    assert_eq!((hit.t, hit.point, hit.normal), (4.0, vec3(0.0, 0.0, -4.0), DVec3::NEG_Z));
    // As close to the surface as f64 goes, along the surface, nothing is lost.
    let inside = Ray { origin: vec3(0.0, 3.0 - 4.0 * f64::EPSILON, -1.0), direction: DVec3::X };
    let t = around.roots(&inside).first_positive().unwrap();
    assert!((5e-8..2e-7).contains(&t), "{t:e}");
}

#[test]
fn a_parallel_plane_is_no_hit() {
    let floor = plane([0.0, -1.0, 0.0], [0.0, 2.0, 0.0]);
    let along = |origin| Ray { origin, direction: vec3(0.3, 0.0, -1.0) };
    assert_eq!(floor.roots(&along(DVec3::ZERO)), Roots::None);
    // Even inside the plane.
    assert_eq!(floor.roots(&along(vec3(0.0, -1.0, 0.0))), Roots::None);
    let terms = floor.terms_of(&exact(&along(DVec3::ZERO)));
    assert_eq!(terms, PlaneTerms { rate: 0.0, offset: -2.0 });
}

#[test]
fn a_planes_point_lies_in_the_plane() {
    let floor = plane([0.0, 0.1, 0.0], [0.0, 3.0, 0.0]);
    let ray = Ray { origin: vec3(1e9, 1e6, -1e9), direction: vec3(0.123, -0.77, 0.456) };
    assert_eq!(root_on(floor, &ray).point.y, 0.1);
    assert_eq!(root_on(floor, &ray).normal, DVec3::Y);
}

/// A t above the range of `f64` becomes infinite, and one below it the smallest positive number, so
/// that a hit remains a hit.
#[test]
fn roots_out_of_range() {
    let ball = sphere([0.0, 0.0, -5e200], 1e200);
    let ray = |z| Ray { origin: DVec3::ZERO, direction: vec3(0.0, 0.0, z) };
    assert_eq!(ball.roots(&ray(-1e-150)), Roots::Two(f64::INFINITY, f64::INFINITY));
    assert_eq!(ball.roots(&ray(1e-150)), Roots::Two(f64::NEG_INFINITY, f64::NEG_INFINITY));
    let Roots::Two(t0, t1) = ball.roots(&ray(-1e-107)) else { panic!("not two") };
    assert_ulps(t0, 4e307, 1);
    assert_ulps(t1, 6e307, 1);
    // Only the far root is out of range.
    let Roots::Two(t0, t1) = ball.roots(&ray(-2.5e-108)) else { panic!("not two") };
    assert_ulps(t0, 1.6e308, 1);
    assert_eq!(t1, f64::INFINITY);
    let wall = plane([0.0, 0.0, -5e200], [0.0, 0.0, 1.0]);
    assert_eq!(wall.roots(&ray(-1e-150)), Roots::One(f64::INFINITY));
    let near = plane([0.0, 0.0, -5e-200], [0.0, 0.0, 1.0]);
    assert_eq!(near.roots(&ray(-1e200)), Roots::One(5e-324));
    assert_eq!(near.roots(&ray(1e200)), Roots::One(-5e-324));
    let far_apart = plane([0.0, 0.0, -1.7e308], [0.0, 0.0, 1e-300]);
    let from = Ray { origin: vec3(0.0, 0.0, 1.7e308), direction: vec3(0.0, 0.0, -1e10) };
    assert_ulps(far_apart.roots(&from).first_positive().unwrap(), 3.4e298, 1);
}

/// A sphere's implicit function has a value at any point, which may be infinite, but is never NaN.
#[test]
fn implicit_functions() {
    let ball = sphere([1.0, 2.0, 3.0], 2.0);
    assert_eq!(ball.implicit(vec3(1.0, 2.0, 3.0)), -4.0);
    assert_eq!(ball.implicit(vec3(3.0, 2.0, 3.0)), 0.0);
    assert_eq!(ball.implicit(vec3(1.0, -1.0, 3.0)), 5.0);
    assert_eq!(sphere([-1.7e308, 0.0, 0.0], 1.0).implicit(vec3(1.7e308, 0.0, 0.0)), f64::INFINITY);
    assert_eq!(sphere([0.0; 3], 1e300).implicit(DVec3::ONE), f64::NEG_INFINITY);
}

#[test]
fn distance_along_a_ray() {
    let ray = Ray { origin: DVec3::ZERO, direction: vec3(0.0, 3.0, -4.0) };
    assert_eq!(ray.distance_along(2.0), 10.0);
    assert_eq!(ray.distance_along(-1.0), -5.0);
    let fast = Ray { direction: DVec3::splat(1.7e308), ..ray };
    assert_ulps(fast.distance_along(1e-300), 1.7e8 * 3_f64.sqrt(), 2);
}
