//! Tests that each step by which decisions escalate (`f64`, double-double, exact integers) is taken and
//! needed, in cases in which the steps before it alone would be wrong.

use pinhole_core::methods::{Formula, Method, Precision};
use pinhole_core::*;
use pinhole_reference::{Camera as GivenCamera, Hit, Object, Orientation as Given};

use crate::common::{exact, first_hit_by, frames, given};

/// The ray whose first hit is asked for.
#[derive(Clone, Debug)]
enum Asked {
    Ray {
        origin: DVec3,
        direction: DVec3,
    },
    /// The ray of the middle pixel of a 3 x 3 image, for a camera at the origin with this view and with
    /// y up.
    MiddlePixel {
        view: DVec3,
    },
}

#[derive(Clone, Debug)]
struct Case {
    objects: Vec<Object>,
    asked: Asked,
}

fn ball(center: DVec3, radius: f64) -> Object {
    Object::Sphere { center: center.to_array(), radius }
}

fn wall(point: DVec3, normal: DVec3) -> Object {
    Object::Plane { point: point.to_array(), normal: normal.to_array() }
}

fn whole(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn middle_camera(view: DVec3) -> GivenCamera {
    GivenCamera {
        eye: [0.0; 3],
        orientation: Given::View { view: view.to_array(), up: [0.0, 1.0, 0.0] },
        width: 1.0,
        height: 1.0,
        distance: 1.0,
        columns: 3,
        rows: 3,
    }
}

impl Case {
    fn ray(objects: &[Object], origin: DVec3, direction: DVec3) -> Case {
        Case { objects: objects.to_vec(), asked: Asked::Ray { origin, direction } }
    }

    fn middle_pixel(objects: &[Object], view: DVec3) -> Case {
        Case { objects: objects.to_vec(), asked: Asked::MiddlePixel { view } }
    }

    fn truth(&self) -> Option<Hit> {
        match self.asked {
            Asked::Ray { origin, direction } => {
                pinhole_reference::first_hit(&self.objects, origin.to_array(), direction.to_array())
            }
            Asked::MiddlePixel { view } => {
                middle_camera(view).prepare(&self.objects).ok()?.first_hit_of_pixel(1, 1)
            }
        }
    }

    /// Returns this crate's first hit, and by which steps its decisions were made.
    fn answer(&self) -> (Option<Root>, Steps) {
        let scene = given::scene(&self.objects);
        let mut steps = Steps::default();
        let hit = match self.asked {
            Asked::Ray { origin, direction } => {
                let ray = Ray::new(origin, direction).unwrap();
                scene.first_hit_counting(&exact(&ray), &mut steps)
            }
            Asked::MiddlePixel { view } => {
                let camera = given::camera(&middle_camera(view)).resolve().unwrap();
                let ray = camera.exact_ray(Pixel { row: 1, column: 1 });
                scene.first_hit_counting(&ray, &mut steps)
            }
        };
        (hit, steps)
    }

    /// Returns the first hit that a method without error bounds finds.
    fn rounded(&self, method: Method) -> Option<(u32, f64)> {
        let ray = match self.asked {
            Asked::Ray { origin, direction } => Ray::new(origin, direction).unwrap(),
            Asked::MiddlePixel { view } => {
                let camera = given::camera(&middle_camera(view)).resolve().unwrap();
                camera.ray_of_pixel(Pixel { row: 1, column: 1 })
            }
        };
        first_hit_by(method, &given::scene(&self.objects), &ray).map(|hit| (hit.object, hit.t))
    }
}

const BY_F64: Method = Method::Known(Formula::HalfB, Precision::F64);

/// The methods that are wrong in cases in which double-double fails, too. In other cases that need
/// exact integers, double-double happens to compute the right 0, but its error bound cannot prove it.
const BOTH: &[Method] = &[Method::DoubleDouble, BY_F64];

/// Returns true if the object is the right one, and t is about right. The tolerance is far above
/// rounding errors and far below the distance to the other root.
fn is_same(found: Option<(u32, f64)>, truth: Option<&Hit>) -> bool {
    match (found, truth) {
        (None, None) => true,
        (Some((object, found)), Some(truth)) => {
            let t = truth.t.to_f64();
            object as usize == truth.object && (found - t).abs() <= 1e-3 * t
        }
        _ => false,
    }
}

/// Asserts that this crate is right about all variants of a case and reports that it took this step,
/// and that each of the methods `wrong_alone` is wrong about at least one variant. (It need not be
/// wrong about all: a sign that is due to rounding is right half of the time.)
#[track_caller]
fn assert_takes(step: Step, wrong_alone: &[Method], variants: &[Case]) {
    let mut wrong = vec![0; wrong_alone.len()];
    for case in variants {
        let truth = case.truth();
        let (found, steps) = case.answer();
        let found_at = found.map(|hit| (hit.object, hit.t));
        assert!(is_same(found_at, truth.as_ref()), "{found:?} in {case:?}");
        if let (Some(found), Some(truth)) = (found, &truth) {
            assert!(truth.t.ulps_from(found.t) <= 0.5 + 1e-12, "{found:?} in {case:?}");
        }
        match step {
            Step::Exact => assert!(steps.exact > 0, "{steps:?} in {case:?}"),
            _ => assert!(steps.double_double > 0 && steps.exact == 0, "{steps:?} in {case:?}"),
        }
        for (method, wrong) in wrong_alone.iter().zip(&mut wrong) {
            *wrong += usize::from(!is_same(case.rounded(*method), truth.as_ref()));
        }
    }
    for (method, wrong) in wrong_alone.iter().zip(wrong) {
        assert!(wrong > 0, "{method} alone is right about all {} variants", variants.len());
    }
}

/// Returns a Pythagorean triple, `(m^2 - n^2, 2 m n, m^2 + n^2)`: the sides of a right triangle, all
/// integers.
fn triple(m: f64, n: f64) -> (f64, f64, f64) {
    (m * m - n * n, 2.0 * m * n, m * m + n * n)
}

/// Returns the ray along (a, b, 0), where (a, b, c) is a Pythagorean triple, and a sphere of radius `k
/// c` that it touches at `t = s`. The radius is then changed by `moved`.
fn tangent_by_triple((m, n): (f64, f64), s: f64, k: f64, moved: fn(f64) -> f64) -> Case {
    let (a, b, c) = triple(m, n);
    let center = whole(s * a - k * b, s * b + k * a, 0.0);
    Case::ray(&[ball(center, moved(k * c))], DVec3::ZERO, whole(a, b, 0.0))
}

const DISTANCES: [f64; 6] = [1.0, 3.0, 10.0, 30.0, 100.0, 1000.0];

/// Near tangents, whose radius is one unit in the last place from touching, are decided by
/// double-double; `f64` alone is wrong.
#[test]
fn one_ulp_beside_a_tangent_needs_double_double() {
    let beside = |s| {
        [f64::next_up, f64::next_down]
            .map(|moved| tangent_by_triple((20001.0, 5000.0), s, 1.0, moved))
    };
    assert_takes(Step::DoubleDouble, &[BY_F64], &DISTANCES.map(beside).concat());
}

/// Exact tangents need exact integers, because no error bound can prove that a value is 0.
#[test]
fn a_tangent_by_a_pythagorean_triple_needs_the_exact_step() {
    let exactly = |s| {
        [(10001.0, 1000.0), (20001.0, 5000.0)]
            .map(|sides| [1.0, 3.0, 7.0].map(|k| tangent_by_triple(sides, s, k, |r| r)))
            .concat()
    };
    assert_takes(Step::Exact, BOTH, &DISTANCES.map(exactly).concat());
}

/// Views with integer coordinates whose lengths, and whose distances from the y axis, are integers: 13,
/// 5; 145, 17; ...
const VIEWS: [DVec3; 5] = [
    DVec3::new(3.0, 12.0, 4.0),
    DVec3::new(4.0, 12.0, 3.0),
    DVec3::new(-3.0, 12.0, -4.0),
    DVec3::new(6.0, -24.0, 8.0),
    DVec3::new(8.0, 144.0, 15.0),
];

/// Returns `view x up` and `(view x up) x view` for up along y.
fn right_and_upward(view: DVec3) -> (DVec3, DVec3) {
    let right = view.cross(DVec3::Y);
    (right, right.cross(view))
}

/// The middle pixel's ray, whose direction is irrational and thus not exact in double-double, touches a
/// sphere.
#[test]
fn a_pixels_tangent_is_settled_exactly() {
    let tangents = |view: DVec3| {
        let (right, upward) = right_and_upward(view);
        [right, upward].map(|across| {
            let sphere = ball(10.0 * view + across, across.length());
            Case::middle_pixel(&[sphere], view)
        })
    };
    assert_takes(Step::Exact, &[BY_F64], &VIEWS.map(tangents).concat());
}

/// The rays of a tilted camera's middle row lie in a plane whose normal has integer coordinates, and
/// are exactly parallel to other planes with that normal, although the rounded dot product of normal
/// and direction is not 0.
#[test]
fn a_row_parallel_to_a_plane_is_settled_exactly() {
    let views = [whole(1.0, 2.0, 3.0), whole(1.0, -1.0, -3.0), whole(2.0, -1.0, -7.0)];
    let sides = |view: DVec3| {
        let (_, upward) = right_and_upward(view);
        [1.0, -1.0].map(|side| Case::middle_pixel(&[wall(side * upward, upward)], view))
    };
    assert_takes(Step::Exact, &[BY_F64], &views.map(sides).concat());
}

/// A ray with an integer direction is exactly perpendicular to a plane's normal. In `f64`, the rounded
/// terms of the dot product do not add up to 0, which gives a wrong hit.
#[test]
fn a_parallel_ray_is_beyond_f64() {
    let mut wrong = 0;
    for k in [100_000_007.0, 123_456_789.0, 987_654_321.0] {
        for side in [1.0, -1.0] {
            let normal = k * whole(1.0, 2.0, 2.0);
            let direction = normal.cross(whole(100_003.0, 7.0, 1.0));
            let case = Case::ray(&[wall(side * normal, normal)], DVec3::ZERO, direction);
            assert_eq!(case.truth(), None);
            let (found, steps) = case.answer();
            assert_eq!((found, steps.exact), (None, 1), "{case:?}");
            wrong += usize::from(case.rounded(BY_F64).is_some());
        }
    }
    assert!(wrong > 0);
}

/// One sphere touches another from inside, where the ray enters both. At this tie, the sphere listed
/// first is hit.
#[test]
fn touching_spheres_are_settled_exactly() {
    let touching = |view: DVec3| {
        let (contact, length) = (10.0 * view, view.length());
        let inner = ball(contact + view, length);
        let outer = ball(contact + 2.0 * view, 2.0 * length);
        [[inner, outer], [outer, inner]].map(|objects| Case::middle_pixel(&objects, view))
    };
    assert_takes(Step::Exact, &[BY_F64], &VIEWS.map(touching).concat());
}

/// Two touching spheres need exact integers even if the ray does not pass through their centres.
#[test]
fn touching_spheres_off_the_axis_need_the_exact_step() {
    let contact = 100_000_007.0 * whole(1.0, 2.0, 2.0);
    let asides = [whole(1.0, 1.0, 0.0), whole(1.0, -3.0, 5.0), whole(12345.0, 54321.0, 999.0)];
    let variants = asides.map(|aside| {
        let origin = 3.0 * contact + aside;
        let outer = ball(DVec3::ZERO, contact.length());
        let inner = ball(0.5 * contact, 0.5 * contact.length());
        [[inner, outer], [outer, inner]]
            .map(|objects| Case::ray(&objects, origin, contact - origin))
    });
    assert_takes(Step::Exact, BOTH, &variants.concat());
}

/// A ray meets the line in which two planes intersect, and thus both planes at the same t.
#[test]
fn planes_that_cross_on_the_ray_are_settled_exactly() {
    let crossing = |view: DVec3| {
        let (point, (_, upward)) = (10.0 * view, right_and_upward(view));
        let planes = [wall(point, view + upward), wall(point, view)];
        [planes, [planes[1], planes[0]]].map(|objects| Case::middle_pixel(&objects, view))
    };
    assert_takes(Step::Exact, &[BY_F64], &VIEWS.map(crossing).concat());
}

/// A ray that starts exactly on a sphere, and leaves it or runs along it, hits nothing. The squares
/// `|q|^2` (q from the centre to the origin) and `r^2` need more digits than `f64` has.
#[test]
fn an_origin_on_a_sphere_is_beyond_f64() {
    let mut wrong = 0;
    for k in [10_000_019.0, 100_000_007.0, 123_456_789.0] {
        let origin = k * whole(1.0, 2.0, 2.0);
        let sphere = ball(DVec3::ZERO, 3.0 * k);
        for direction in [origin, origin.cross(whole(1.0, -3.0, 5.0))] {
            let case = Case::ray(&[sphere], origin, direction);
            assert_eq!(case.truth(), None);
            let (found, steps) = case.answer();
            assert_eq!(found, None, "{case:?}");
            assert!(steps.exact > 0, "{steps:?} in {case:?}");
            wrong += usize::from(case.rounded(BY_F64).is_some());
        }
    }
    assert!(wrong > 0);
}

/// A ray that starts exactly in a plane does not hit it.
#[test]
fn an_origin_in_a_plane_is_beyond_f64() {
    let mut wrong = 0;
    for k in [10_000_019.0, 100_000_007.0, 987_654_321.0] {
        let (point, normal) = (k * whole(1.0, 2.0, 2.0), whole(12345.0, 54321.0, 999.0));
        let origin = point + point.cross(normal);
        for direction in [whole(0.3, 0.7, -1.0), whole(-0.3, -0.7, 1.0)] {
            let case = Case::ray(&[wall(point, normal)], origin, direction);
            assert_eq!(case.truth(), None);
            let (found, steps) = case.answer();
            assert_eq!((found, steps.exact), (None, 1), "{case:?}");
            wrong += usize::from(case.rounded(BY_F64).is_some());
        }
    }
    assert!(wrong > 0);
}

/// The decisions of whole frames take every step, too.
#[test]
fn frames_reach_every_step() {
    let mut steps = Steps::default();
    for family in &frames::FAMILIES {
        for knob in family.knobs {
            for case in family.cases(*knob, 7, 1) {
                if case.camera.rows.max(case.camera.columns) > 64 {
                    continue;
                }
                let camera = given::camera(&case.camera).resolve().unwrap();
                let raster = Raster::full(camera.image());
                let scene = given::scene(&case.objects);
                steps = steps + trace(&scene, &camera, &raster, Outputs::default()).steps;
            }
        }
    }
    assert!(steps.f64 > 1000 && steps.double_double > 0 && steps.exact > 0, "{steps:?}");
}
