//! Tests of the derivation of a ray's intersection with an object.

use pinhole_core::*;
use pinhole_lecture::{
    ObjectDerivation, PlaneDerivation, PlaneMeeting, SphereDerivation, SphereMeeting,
};
use pinhole_reference::{Family, roots};
use proptest::prelude::*;

use super::{AT_45_DEGREES, vector};
use crate::common::oracle::{Big3, big, near};
use crate::common::{assert_ulps, assert_ulps3, given, plane, sphere, ulps, vec3};
use crate::config;

fn derived(object: Object, ray: &Ray) -> ObjectDerivation {
    ObjectDerivation::new(&object, 0, &ExactRay::from_ray(ray).unwrap()).unwrap()
}

fn on_sphere(
    center: [f64; 3],
    radius: f64,
    origin: [f64; 3],
    direction: [f64; 3],
) -> SphereDerivation {
    let ray = Ray::new(origin, direction).unwrap();
    match derived(Object::Sphere(sphere(center, radius)), &ray) {
        ObjectDerivation::Sphere(derived) => derived,
        ObjectDerivation::Plane(_) => panic!("a sphere"),
    }
}

fn on_plane(point: [f64; 3], normal: [f64; 3], ray: &ExactRay) -> PlaneDerivation {
    let object = Object::Plane(plane(point, normal));
    match ObjectDerivation::new(&object, 3, ray).unwrap() {
        ObjectDerivation::Plane(derived) => derived,
        ObjectDerivation::Sphere(_) => panic!("a plane"),
    }
}

const BALL: ([f64; 3], f64) = ([0.0, 0.0, -5.0], 1.0);
const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];

#[test]
fn the_lecture_s_sphere_line_by_line() {
    let found = on_sphere(BALL.0, BALL.1, [0.0; 3], AHEAD);
    assert_eq!(found.from_center, vec3(0.0, 0.0, 5.0));
    let SphereQuadratic { a, b, c, discriminant } = found.quadratic;
    assert_eq!((a, b, c, discriminant), (1.0, -5.0, 24.0, 1.0));
    assert_eq!((found.meeting, found.first), (SphereMeeting::Through, Some(0)));
    let [near, far] = found.roots.map(Option::unwrap);
    assert_eq!((near.t, near.point, near.normal), (4.0, vec3(0.0, 0.0, -4.0), DVec3::Z));
    assert_eq!((far.t, far.point, far.normal), (6.0, vec3(0.0, 0.0, -6.0), DVec3::NEG_Z));

    let missed = on_sphere(BALL.0, BALL.1, [0.0; 3], [0.2, -0.1, -1.0]);
    assert_eq!(missed.meeting, SphereMeeting::Missed);
    assert!((missed.quadratic.discriminant + 0.2).abs() < 1e-15);
    assert_eq!((missed.roots, missed.first), ([None; 2], None));
}

#[test]
fn every_way_to_meet_a_sphere() {
    let cases = [
        ([0.0, 0.0, 0.0], AHEAD, SphereMeeting::Through, vec![4.0, 6.0], Some(0)),
        ([1.0, 0.0, 0.0], AHEAD, SphereMeeting::Tangent, vec![5.0], Some(0)),
        ([1.5, 0.0, 0.0], AHEAD, SphereMeeting::Missed, vec![], None),
        ([0.0, 0.0, -5.0], AHEAD, SphereMeeting::FromInside, vec![-1.0, 1.0], Some(1)),
        ([0.0, 0.0, -4.0], AHEAD, SphereMeeting::FromSurface, vec![0.0, 2.0], Some(1)),
        ([0.0, 0.0, -6.0], AHEAD, SphereMeeting::Behind, vec![-2.0, 0.0], None),
        ([0.0, 0.0, -7.0], AHEAD, SphereMeeting::Behind, vec![-3.0, -1.0], None),
        ([1.0, 0.0, -9.0], AHEAD, SphereMeeting::Behind, vec![-4.0], None),
        ([1.0, 0.0, -5.0], AHEAD, SphereMeeting::Behind, vec![0.0], None),
    ];
    for (origin, direction, meeting, expected, first) in cases {
        let found = on_sphere(BALL.0, BALL.1, origin, direction);
        assert_eq!((found.meeting, found.first), (meeting, first), "from {origin:?}");
        let times: Vec<f64> = found.roots.iter().flatten().map(|root| root.t).collect();
        assert_eq!(times, expected, "from {origin:?}");
        assert_eq!(found.hit().map(|hit| hit.t), first.map(|first| expected[first]));
    }
}

#[test]
fn planes_of_the_lecture() {
    let wall = ([0.0, 0.0, -6.0], [0.0, 0.0, 1.0]);
    let ray = Ray::new([0.0; 3], [0.2, -0.1, -1.0]).unwrap();
    let found = on_plane(wall.0, wall.1, &ExactRay::from_ray(&ray).unwrap());
    assert_eq!((found.terms.rate, found.terms.offset), (-1.0, -6.0));
    assert_eq!(found.meeting, PlaneMeeting::Ahead);
    let hit = found.hit().unwrap();
    assert_eq!((hit.object, hit.t, hit.normal), (3, 6.0, DVec3::Z));
    assert_ulps3(hit.point, vec3(1.2, -0.6, -6.0), 1);

    let resolved = AT_45_DEGREES.resolve().unwrap();
    let ray = resolved.exact_ray_at(DVec2::new(0.2, -0.1)).unwrap();
    let hit = *on_plane(wall.0, wall.1, &ray).hit().unwrap();
    assert_ulps(hit.t, 50_f64.sqrt(), 1);
    assert_ulps3(hit.point, vec3(-4.0, -0.5_f64.sqrt(), -6.0), 1);
}

#[test]
fn every_way_to_meet_a_plane() {
    let cases = [
        ([0.0, 0.0, 0.0], AHEAD, PlaneMeeting::Ahead, Some(6.0)),
        ([0.0, 0.0, -8.0], AHEAD, PlaneMeeting::Behind, Some(-2.0)),
        ([3.0, 0.0, -6.0], AHEAD, PlaneMeeting::AtOrigin, Some(0.0)),
        ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], PlaneMeeting::Parallel, None),
        ([0.0, 0.0, -6.0], [1.0, 0.0, 0.0], PlaneMeeting::Within, None),
    ];
    for (origin, direction, meeting, t) in cases {
        let ray = Ray::new(origin, direction).unwrap();
        let found = on_plane([0.0, 0.0, -6.0], [0.0, 0.0, 2.0], &ExactRay::from_ray(&ray).unwrap());
        assert_eq!((found.meeting, found.root.map(|root| root.t)), (meeting, t));
        assert_eq!(found.hit().is_some(), meeting == PlaneMeeting::Ahead);
        let all = derived(Object::Plane(found.plane), &ray);
        assert_eq!(all.roots().count(), usize::from(t.is_some()));
    }
    let ray = Ray::new([0.0; 3], AHEAD).unwrap();
    let none = Object::Plane(plane([0.0; 3], [0.0; 3]));
    let error = ObjectDerivation::new(&none, 0, &ExactRay::from_ray(&ray).unwrap());
    assert_eq!(error, Err(ObjectError::NormalIsZero));
}

/// The derivation of an intersection agrees with the tracer, and its roots agree with the exact
/// reference.
#[test]
fn roots_and_hits_are_those_of_the_reference() {
    let mut seen = 0;
    for family in Family::all() {
        for &knob in family.knobs {
            for case in family.rays(knob, 11, 3) {
                let ray = Ray { origin: case.origin.into(), direction: case.direction.into() };
                let exact = ExactRay::from_ray(&ray).unwrap();
                for given_object in &case.objects {
                    let scene = given::scene(std::slice::from_ref(given_object));
                    let object = scene.object(0).unwrap();
                    let found = ObjectDerivation::new(&object, 0, &exact).unwrap();
                    assert_eq!(found.hit().copied(), scene.first_hit_of(&exact));
                    let times: Vec<f64> = found.roots().map(|root| root.t).collect();
                    let truth = roots(given_object, case.origin, case.direction);
                    assert_eq!(times.len(), truth.len(), "{object:?} {ray:?}");
                    for (t, truth) in times.iter().zip(&truth) {
                        assert!(!truth.is_representable() || truth.ulps_from(*t) <= 0.5001);
                    }
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 400, "{seen}");
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn the_parts_lead_to_the_roots(
        center in vector(-1.0..2.0), power in -2.0..2.0_f64, origin in vector(-1.0..2.0),
        direction in vector(-1.0..1.0), aim in 0.0..1.5_f64,
    ) {
        let radius = 10_f64.powf(power);
        // Half of them towards the sphere.
        let direction = direction * aim * radius / direction.length() + (center - origin);
        let ray = Ray { origin, direction };
        let object = Object::Sphere(Sphere { center, radius });
        let ObjectDerivation::Sphere(found) = derived(object, &ray) else {
            return Err(TestCaseError::fail("a sphere"));
        };
        let q = Big3::from(origin).minus(&center.into());
        let d = Big3::from(direction);
        for i in 0..3 {
            prop_assert!(ulps(found.from_center[i], near(&q.0[i])) == 0);
        }
        let discriminant = d.dot(&q) * d.dot(&q) - d.dot(&d) * (q.dot(&q) - big(radius) * big(radius));
        if let [Some(first), Some(far)] = found.roots {
            let (root, near) = (near(&discriminant.sqrt()), first);
            let SphereQuadratic { a, b, .. } = found.quadratic;
            let size = (b.abs() + root) / a;
            prop_assert!(((-b - root) / a - near.t).abs() <= 1e-15 * size);
            prop_assert!(((-b + root) / a - far.t).abs() <= 1e-15 * size);
            for hit in [near, far] {
                let normal = (hit.point - center) / radius;
                let cancelled = center.length().max(hit.point.length()) / radius;
                prop_assert!((normal - hit.normal).length() <= 1e-15 * (1.0 + cancelled));
            }
        }
    }
}
