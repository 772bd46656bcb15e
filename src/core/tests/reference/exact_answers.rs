//! Tests of the reference with answers that were found by hand: the lecture's, and those of small
//! integers.

use pinhole_reference::{Object, Real, first_hit, roots};

fn sphere(center: [f64; 3], radius: f64) -> Object {
    Object::Sphere { center, radius }
}

fn plane(point: [f64; 3], normal: [f64; 3]) -> Object {
    Object::Plane { point, normal }
}

fn values(roots: Vec<Real>) -> Vec<f64> {
    roots.iter().map(Real::to_f64).collect()
}

#[test]
fn the_lectures_sphere_and_planes() {
    let ball = sphere([0.0, 0.0, -5.0], 1.0);
    assert_eq!(values(roots(&ball, [0.0; 3], [0.0, 0.0, -1.0])), [4.0, 6.0]);
    assert_eq!(roots(&ball, [0.0; 3], [0.2, -0.1, -1.0]), vec![]);
    let wall = plane([0.0, 0.0, -6.0], [0.0, 0.0, 1.0]);
    let hit = first_hit(&[wall], [0.0; 3], [0.2, -0.1, -1.0]).unwrap();
    assert_eq!(hit.t.to_f64(), 6.0);
    assert_eq!(hit.point.map(|x| x.to_f64()), [6.0 * 0.2, 6.0 * -0.1, -6.0]);
    assert_eq!(hit.normal.map(|x| x.to_f64()), [0.0, 0.0, 1.0]);
    // In the plane, the 2-D lines x + y - 2 = 0 and 2x - y + 1 = 0.
    let line = plane([2.0, 0.0, 0.0], [1.0, 1.0, 0.0]);
    assert_eq!(values(roots(&line, [0.0; 3], [1.0, 1.0, 0.0])), [1.0]);
    let behind = plane([0.0, 1.0, 0.0], [2.0, -1.0, 0.0]);
    assert_eq!(values(roots(&behind, [0.0; 3], [1.0, 1.0, 0.0])), [-1.0]);
    assert_eq!(first_hit(&[behind], [0.0; 3], [1.0, 1.0, 0.0]), None);
}

#[test]
fn what_a_hit_is() {
    let ball = sphere([0.0; 3], 1.0);
    let t = |origin, direction| first_hit(&[ball], origin, direction).map(|hit| hit.t.to_f64());
    // From inside, the far root.
    assert_eq!(t([0.5, 0.0, 0.0], [1.0, 0.0, 0.0]), Some(0.5));
    // On the sphere, t = 0 is none: outward nothing, inward the other end.
    assert_eq!(t([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), None);
    assert_eq!(t([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]), Some(1.0));
    assert_eq!(t([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), None);
    // A tangent is one.
    assert_eq!(t([1.0, -3.0, 0.0], [0.0, 1.0, 0.0]), Some(3.0));
    assert_eq!(t([1.0 + f64::EPSILON, -3.0, 0.0], [0.0, 1.0, 0.0]), None);
    // In a plane, and beside it.
    let floor = plane([0.0; 3], [0.0, 2.0, 0.0]);
    assert_eq!(first_hit(&[floor], [0.0; 3], [1.0, 0.0, 0.0]), None);
    assert_eq!(first_hit(&[floor], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]), None);
    assert_eq!(first_hit(&[floor], [0.0, 1.0, 0.0], [1.0, f64::MIN_POSITIVE, 0.0]), None);
}

#[test]
fn among_ties_the_first_listed_wins() {
    let (ball, wall) = (sphere([0.0, 0.0, -5.0], 1.0), plane([0.0, 0.0, -4.0], [0.0, 0.0, 3.0]));
    for objects in [[ball, wall], [wall, ball], [ball, ball]] {
        let hit = first_hit(&objects, [0.0; 3], [0.0, 0.0, -0.5]).unwrap();
        assert_eq!((hit.object, hit.t.to_f64()), (0, 8.0));
    }
    // Off the axis, t of the sphere has a root in it.
    let hit = first_hit(&[ball, wall], [0.0; 3], [1e-9, 0.0, -1.0]).unwrap();
    assert_eq!(hit.object, 1);
}

#[test]
fn normals_and_points_are_exact_where_they_are_short() {
    let ball = sphere([1.0, 2.0, 3.0], 5.0);
    // The point (1, 2, 3) + (3, 0, 4), from above.
    let hit = first_hit(&[ball], [4.0, 2.0, 17.0], [0.0, 0.0, -1.0]).unwrap();
    assert_eq!(hit.t.to_f64(), 10.0);
    assert_eq!(hit.point.map(|x| x.ulps_from(x.to_f64())), [0.0; 3]);
    assert_eq!(hit.normal.clone().map(|x| x.to_f64()), [0.6, 0.0, 0.8]);
    // 0.6 is no double: the truth is 3/5, and the double beside it.
    assert!(hit.normal[0].ulps_from(0.6) > 0.0 && hit.normal[0].ulps_from(0.6) < 0.5);
}
