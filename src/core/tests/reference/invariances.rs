//! Tests of the reference: changes of a case that must not change the answer, and properties that all
//! answers must have.

use std::cmp::Ordering;

use pinhole_reference::{
    Camera, Family, Hit, Object, Orientation, RayCase, Real, angle_between, basis, first_hit, roots,
};

use crate::common::frames::{FrameCase, FrameFamily};
use crate::common::{bases, margins};

type Map<'a> = &'a dyn Fn([f64; 3]) -> [f64; 3];

/// Returns the families of rays in which all lengths can be multiplied by 2^20 without leaving the
/// range of `f64`.
fn everyday_ray_families() -> impl Iterator<Item = &'static Family> {
    let is_extreme = |name: &str| name.ends_with("-range");
    Family::all().filter(move |family| !is_extreme(family.name))
}

fn all_rays(count: usize) -> impl Iterator<Item = RayCase> {
    everyday_ray_families().flat_map(move |family| {
        family.knobs.iter().flat_map(move |&knob| family.rays(knob, 11, count))
    })
}

/// Returns the objects with each point and each normal mapped by these functions, and each radius
/// multiplied by `scale`.
fn mapped(objects: &[Object], point_map: Map, vector_map: Map, scale: f64) -> Vec<Object> {
    let one = |object: &Object| match *object {
        Object::Sphere { center, radius } => {
            Object::Sphere { center: point_map(center), radius: radius * scale }
        }
        Object::Plane { point, normal } => {
            Object::Plane { point: point_map(point), normal: vector_map(normal) }
        }
    };
    objects.iter().map(one).collect()
}

/// Permutes the coordinate axes by a rotation, which keeps a camera's basis right-handed.
fn permuted([x, y, z]: [f64; 3]) -> [f64; 3] {
    [z, -x, -y]
}

fn permuted_back([x, y, z]: [f64; 3]) -> [f64; 3] {
    [-y, -z, x]
}

/// Returns true if two numbers are equal to the last of their 440 bits.
fn is_same(a: &Real, b: &Real) -> bool {
    let near = Real::from(a.to_f64());
    a.minus(&near).to_f64() == b.minus(&near).to_f64()
}

#[test]
fn axes_may_be_permuted() {
    for case in all_rays(15) {
        let objects = mapped(&case.objects, &permuted, &permuted, 1.0);
        let before = first_hit(&case.objects, case.origin, case.direction);
        let after = first_hit(&objects, permuted(case.origin), permuted(case.direction));
        match (before, after) {
            (None, None) => {}
            (Some(before), Some(after)) => {
                assert!(before.object == after.object && is_same(&before.t, &after.t), "{case:?}");
                let normal = permuted(before.normal.map(|x| x.to_f64()));
                assert_eq!(after.normal.map(|x| x.to_f64()), normal);
                let point = permuted(before.point.map(|x| x.to_f64()));
                assert_eq!(after.point.map(|x| x.to_f64()), point);
            }
            different => panic!("{different:?}: {case:?}"),
        }
    }
}

#[test]
fn lengths_may_be_in_other_units() {
    let scale = 2.0_f64.powi(20);
    let larger = |v: [f64; 3]| v.map(|x| x * scale);
    for case in all_rays(15) {
        let objects = mapped(&case.objects, &larger, &|v| v.map(|x| x * 4.0), scale);
        let before = first_hit(&case.objects, case.origin, case.direction);
        // The direction is twice as long: t grows by half of what lengths do.
        let after = first_hit(&objects, larger(case.origin), case.direction.map(|x| x * 2.0));
        assert_eq!(before.is_some(), after.is_some(), "{case:?}");
        if let (Some(before), Some(after)) = (before, after) {
            assert_eq!(before.object, after.object);
            assert_eq!(before.t.to_f64() * scale / 2.0, after.t.to_f64());
            assert_eq!(before.normal.map(|x| x.to_f64()), after.normal.map(|x| x.to_f64()));
        }
    }
}

fn length(v: &[Real; 3]) -> f64 {
    margins::dot(v, v).over(&Real::from(1.0)).sqrt()
}

#[test]
fn a_hit_is_on_its_object() {
    for family in Family::all() {
        for &knob in family.knobs {
            for RayCase { objects, origin, direction } in family.rays(knob, 12, 10) {
                let Some(hit) = first_hit(&objects, origin, direction) else { continue };
                assert!((length(&hit.normal) - 1.0).abs() < 1e-15, "{}", family.name);
                match objects[hit.object] {
                    Object::Sphere { center, radius } => {
                        // The 440 bits of a point are too few to locate it on a tiny sphere that is
                        // extremely far away.
                        if center.iter().any(|x| x.abs() > 1e100 * radius) {
                            continue;
                        }
                        // At the distance of the radius from the centre, along the normal.
                        let outward = margins::minus(&hit.point, &center.map(Real::from));
                        let radii = Real::from(radius).times(&Real::from(radius));
                        let off = margins::dot(&outward, &outward).over(&radii).sqrt();
                        assert!((off - 1.0).abs() < 1e-15, "{}: {off}", family.name);
                        let outward = hit.point.clone().map(|x| x.to_f64());
                        let outward: [f64; 3] = std::array::from_fn(|i| outward[i] - center[i]);
                        let size =
                            center.into_iter().chain(outward).map(f64::abs).fold(0.0, f64::max);
                        if size < 1e3 * radius && radius > 1e-290 {
                            assert!(angle_between(&hit.normal, outward) < 1e-12);
                        }
                    }
                    Object::Plane { normal, .. } => {
                        assert!(angle_between(&hit.normal, normal) < 1e-125);
                    }
                }
            }
        }
    }
}

/// The points slightly before and slightly after a root lie on different sides of the sphere.
#[test]
fn the_object_is_crossed_at_the_root() {
    let family = Family::named("ordinary").unwrap();
    for case in family.rays(0.5, 13, 200) {
        let hit = first_hit(&case.objects, case.origin, case.direction).unwrap();
        let side = |t: f64| {
            let q = std::array::from_fn(|i| case.origin[i] + t * case.direction[i]);
            case.objects[0].side_of(q)
        };
        let t = hit.t.to_f64();
        assert_eq!(
            [side(t * (1.0 - 1e-12)), side(t * (1.0 + 1e-12))],
            [Ordering::Greater, Ordering::Less]
        );
    }
}

fn is_same_hit(a: &Option<Hit>, b: &Option<Hit>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => {
            let same = |a: &[Real; 3], b: &[Real; 3]| a.iter().zip(b).all(|(a, b)| is_same(a, b));
            a.object == b.object
                && is_same(&a.t, &b.t)
                && same(&a.point, &b.point)
                && same(&a.normal, &b.normal)
        }
        _ => false,
    }
}

#[test]
fn a_camera_along_the_axes_is_an_ordinary_ray() {
    let ways = [
        Orientation::View { view: [0.0, 0.0, -3.0], up: [0.0, 5.0, 1.0] },
        Orientation::Basis { u: [1.0, 0.0, 0.0], v: [0.0, 1.0, 0.0], w: [0.0, 0.0, 1.0] },
    ];
    let family = Family::named("several").unwrap();
    for case in family.rays(5.0, 14, 100) {
        let [x, y, z] = case.direction;
        let ray = first_hit(&case.objects, case.origin, case.direction);
        for orientation in ways {
            let camera = Camera {
                eye: case.origin,
                orientation,
                width: 1.0,
                height: 1.0,
                distance: -z,
                columns: 1,
                rows: 1,
            };
            let hit = camera.prepare(&case.objects).unwrap().first_hit_of_uv(x, y);
            assert!(is_same_hit(&hit, &ray), "{hit:?} {ray:?}");
        }
    }
}

#[test]
fn a_camera_may_be_turned_with_its_world() {
    for FrameCase { camera, objects } in FrameFamily::named("frame-ordinary").cases(8.0, 15, 6) {
        let turned = |orientation| match orientation {
            Orientation::At { at, up } => Orientation::At { at: permuted(at), up: permuted(up) },
            Orientation::View { view, up } => {
                Orientation::View { view: permuted(view), up: permuted(up) }
            }
            Orientation::Basis { u, v, w } => {
                Orientation::Basis { u: permuted(u), v: permuted(v), w: permuted(w) }
            }
        };
        let other =
            Camera { eye: permuted(camera.eye), orientation: turned(camera.orientation), ..camera };
        let view = camera.prepare(&objects).unwrap();
        let other_view = other.prepare(&mapped(&objects, &permuted, &permuted, 1.0)).unwrap();
        for (row, column) in (0..camera.rows).zip((0..camera.columns).rev()) {
            let hit = view.first_hit_of_pixel(row, column);
            let other = other_view.first_hit_of_pixel(row, column);
            assert_eq!(hit.is_some(), other.is_some());
            if let (Some(hit), Some(other)) = (hit, other) {
                assert!(hit.object == other.object && is_same(&hit.t, &other.t));
                let back = permuted_back(other.normal.map(|x| x.to_f64()));
                assert_eq!(hit.normal.map(|x| x.to_f64()), back);
            }
        }
    }
}

#[test]
fn a_pixel_is_the_uv_of_its_centre() {
    let family = FrameFamily::named("frame-ordinary");
    for FrameCase { mut camera, objects } in family.cases(3.0, 16, 4) {
        // With powers of two the centre's position is a double.
        (camera.columns, camera.rows, camera.width, camera.height) = (16, 8, 1.0, 0.5);
        let view = camera.prepare(&objects).unwrap();
        for (row, column) in [(0, 0), (3, 7), (7, 15), (5, 2)] {
            let (u, v) =
                ((f64::from(column) + 0.5) / 16.0 - 0.5, 0.25 - (f64::from(row) + 0.5) / 16.0);
            let (by_pixel, by_uv) =
                (view.first_hit_of_pixel(row, column), view.first_hit_of_uv(u, v));
            assert!(is_same_hit(&by_pixel, &by_uv), "{by_pixel:?} {by_uv:?}");
        }
    }
}

#[test]
fn bases_are_orthonormal_and_right_handed() {
    for family in &bases::FAMILIES {
        for &knob in family.knobs {
            for case in family.cases(knob, 17, 20) {
                let Ok([u, v, w]) = basis(case.eye, &case.orientation) else { continue };
                for vector in [&u, &v, &w] {
                    assert!((length(vector) - 1.0).abs() < 1e-15);
                }
                let [rounded_u, rounded_v] = [&u, &v].map(|x| x.clone().map(|x| x.to_f64()));
                let quarter = std::f64::consts::FRAC_PI_2;
                assert!((angle_between(&v, rounded_u) - quarter).abs() < 1e-15);
                assert!((angle_between(&w, rounded_u) - quarter).abs() < 1e-15);
                let [a, b, c] = rounded_u;
                let [d, e, f] = rounded_v;
                let cross = [b * f - c * e, c * d - a * f, a * e - b * d];
                assert!(angle_between(&w, cross) < 1e-15, "{} {knob}", family.name);
                let (Orientation::View { up, .. } | Orientation::At { up, .. }) = case.orientation
                else {
                    continue;
                };
                // Up is at a right angle to u, and on v's side.
                assert!((angle_between(&u, up) - quarter).abs() < 1e-15);
                assert!(angle_between(&v, up) <= quarter);
            }
        }
    }
}

#[test]
fn what_is_out_of_f64s_range_is_answered_all_the_same() {
    let ball = Object::Sphere { center: [0.0, 0.0, -1e300], radius: 1e299 };
    let hit = first_hit(&[ball], [0.0; 3], [0.0, 0.0, -1e-300]).unwrap();
    assert!(hit.t.to_f64() == f64::INFINITY && !hit.t.is_representable());
    let dust = Object::Sphere { center: [0.0, 0.0, -5e-324 * 3.0], radius: 5e-324 };
    let hit = first_hit(&[dust], [0.0; 3], [0.0, 0.0, -5e-324]).unwrap();
    assert_eq!(hit.t.ulps_from(2.0), 0.0);
    assert!(roots(&dust, [1e308, 0.0, 0.0], [-1e308, 5e-324, 0.0]).is_empty());
}
