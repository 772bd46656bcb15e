//! Tests that the reference's families of difficult cases have the properties that they claim.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use pinhole_reference::{
    Camera, Family, Object, Orientation, RayCase, Real, Status, View, angle_between, basis,
    first_hit, roots,
};

use crate::common::bases::{self, BasisCase, BasisFamily};
use crate::common::frames::{self, FrameCase, FrameFamily};
use crate::common::invalid;

const SEED: u64 = 20;
const COUNT: usize = 60;

fn rays(name: &str, knob: f64) -> Vec<RayCase> {
    Family::named(name).unwrap().rays(knob, SEED, COUNT)
}

fn frames(name: &str, knob: f64, count: usize) -> Vec<FrameCase> {
    FrameFamily::named(name).cases(knob, SEED, count)
}

fn bases(name: &str) -> &'static BasisFamily {
    bases::FAMILIES.iter().find(|family| family.name == name).unwrap()
}

#[derive(Debug)]
enum Case {
    Ray(RayCase),
    Basis(BasisCase),
    Frame(FrameCase),
}

fn is_valid(object: &Object) -> bool {
    let are_finite = |v: &[f64; 3]| v.iter().all(|x| x.is_finite());
    match object {
        Object::Sphere { center, radius } => {
            are_finite(center) && radius.is_finite() && *radius > 0.0
        }
        Object::Plane { point, normal } => {
            are_finite(point) && are_finite(normal) && *normal != [0.0; 3]
        }
    }
}

fn first_object(objects: &[Object], origin: [f64; 3], direction: [f64; 3]) -> Option<usize> {
    first_hit(objects, origin, direction).map(|hit| hit.object)
}

fn object_of_pixel(view: &View, row: u32, column: u32) -> Option<usize> {
    view.first_hit_of_pixel(row, column).map(|hit| hit.object)
}

fn object_roots(case: &RayCase) -> Vec<Real> {
    roots(&case.objects[0], case.origin, case.direction)
}

fn numbers_of_object(object: &Object) -> Vec<f64> {
    match object {
        Object::Sphere { center, radius } => [center.as_slice(), &[*radius]].concat(),
        Object::Plane { point, normal } => [*point, *normal].concat(),
    }
}

fn numbers_of_orientation(orientation: &Orientation) -> Vec<f64> {
    match orientation {
        Orientation::At { at: a, up } | Orientation::View { view: a, up } => [*a, *up].concat(),
        Orientation::Basis { u, v, w } => [*u, *v, *w].concat(),
    }
}

fn numbers(case: &Case) -> Vec<f64> {
    match case {
        Case::Ray(case) => {
            let objects = case.objects.iter().flat_map(numbers_of_object);
            objects.chain(case.origin).chain(case.direction).collect()
        }
        Case::Basis(case) => {
            numbers_of_orientation(&case.orientation).into_iter().chain(case.eye).collect()
        }
        Case::Frame(FrameCase { camera, objects }) => {
            let Camera { eye, orientation, width, height, distance, columns, rows } = camera;
            let size = [*width, *height, *distance, f64::from(*columns), f64::from(*rows)];
            let objects = objects.iter().flat_map(numbers_of_object);
            let camera = numbers_of_orientation(orientation).into_iter().chain(*eye).chain(size);
            objects.chain(camera).collect()
        }
    }
}

/// Calls `visit` for some cases of each family and each value of its knob.
fn some_of_all(mut visit: impl FnMut(&str, f64, &Case)) {
    let mut some_of = |name: &str, knobs: &[f64], cases: &dyn Fn(f64) -> Vec<Case>| {
        for &knob in knobs {
            cases(knob).iter().for_each(|case| visit(name, knob, case));
        }
    };
    for family in Family::all() {
        some_of(family.name, family.knobs, &|knob| {
            family.rays(knob, SEED, 24).into_iter().map(Case::Ray).collect()
        });
    }
    for family in &bases::FAMILIES {
        some_of(family.name, family.knobs, &|knob| {
            family.cases(knob, SEED, 24).into_iter().map(Case::Basis).collect()
        });
    }
    for family in &frames::FAMILIES {
        some_of(family.name, family.knobs, &|knob| {
            family.cases(knob, SEED, 24).into_iter().map(Case::Frame).collect()
        });
    }
}

#[test]
fn the_table_is_complete() {
    let of_bases = bases::FAMILIES.iter().map(|family| family.name);
    let of_frames = frames::FAMILIES.iter().map(|family| family.name);
    let names = Family::all().map(|family| family.name).chain(of_bases).chain(of_frames);
    let names: Vec<&str> = names.collect();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
    for family in Family::all() {
        let is_kebab = |c: char| c.is_ascii_lowercase() || c == '-';
        assert!(family.name.chars().all(is_kebab), "{}", family.name);
        assert!(!family.knob_name.is_empty());
        assert!(family.about.ends_with(['.', '?']), "{}", family.name);
        assert!(family.knobs.is_sorted() && family.knobs.len() > 1, "{}", family.name);
    }
}

#[test]
fn every_number_is_finite_and_every_object_valid() {
    some_of_all(|name, knob, case| {
        for x in numbers(case) {
            assert!(x.is_finite(), "{name} {knob}: {case:?}");
        }
        let (objects, direction): (&[Object], _) = match case {
            Case::Ray(case) => (&case.objects, case.direction),
            Case::Frame(case) => (&case.objects, [case.camera.width; 3]),
            Case::Basis(_) => (&[], [1.0; 3]),
        };
        assert!(direction != [0.0; 3], "{name} {knob}: {case:?}");
        assert!(objects.iter().all(is_valid), "{name} {knob}: {case:?}");
        // Spheres are listed before planes.
        assert!(objects.is_sorted_by_key(|object| matches!(object, Object::Plane { .. })));
    });
}

#[test]
fn the_same_seed_gives_the_same_cases_everywhere() {
    let mut sum: u64 = 0;
    some_of_all(|_, _, case| {
        for x in numbers(case) {
            sum = sum.rotate_left(5).wrapping_mul(0x100_0000_01b3) ^ x.to_bits();
        }
    });
    assert_eq!(format!("{sum:016x}"), "321cb77cbdf6084b", "a recorded case has changed");
    let family = Family::named("ordinary").unwrap();
    assert_eq!(family.rays(0.5, 7, 9)[..4], family.rays(0.5, 7, 4));
    assert_ne!(family.rays(0.5, 7, 1), family.rays(0.5, 8, 1));
}

#[test]
fn tangents_touch_exactly_and_an_ulp_decides() {
    for case in rays("tangent", 0.0) {
        assert!(object_roots(&case).len() == 1, "{case:?}");
    }
    for case in rays("tangent", -1.0) {
        assert!(object_roots(&case).is_empty(), "{case:?}");
    }
    for case in rays("tangent", 1.0) {
        assert!(object_roots(&case).len() == 2, "{case:?}");
    }
}

#[test]
fn eyes_are_where_they_are_said_to_be() {
    for (knob, side) in [(-1.0, Ordering::Greater), (0.0, Ordering::Equal), (1.0, Ordering::Less)] {
        for case in rays("eye-on-surface", knob) {
            assert_eq!(case.objects[0].side_of(case.origin), side, "{case:?}");
        }
    }
    for &knob in Family::named("eye-inside").unwrap().knobs {
        for case in rays("eye-inside", knob) {
            assert_eq!(case.objects[0].side_of(case.origin), Ordering::Less);
        }
    }
    for case in rays("planet", 8.0) {
        assert_eq!(case.objects[0].side_of(case.origin), Ordering::Greater);
    }
    let floor = Object::Sphere { center: [0.0, -5001.0, 0.0], radius: 5000.0 };
    let family = Family::named("course-floor").unwrap();
    for case in family.knobs.iter().flat_map(|&knob| rays("course-floor", knob)) {
        assert_eq!((case.objects.as_slice(), case.origin), ([floor].as_slice(), [0.0; 3]));
        assert_eq!(first_object(&case.objects, [0.0; 3], case.direction).is_some(), {
            let [x, y, z] = case.direction;
            y < -0.02 * (x * x + z * z).sqrt()
        });
    }
}

/// Returns the index of the object hit first, with the two objects in their order and with them
/// exchanged.
fn both_ways(case: &RayCase) -> [usize; 2] {
    let reversed: Vec<Object> = case.objects.iter().rev().copied().collect();
    let first = |objects: &[Object]| first_object(objects, case.origin, case.direction).unwrap();
    [first(&case.objects), first(&reversed)]
}

#[test]
fn ties_are_exact_and_an_ulp_breaks_them() {
    for family in Family::all().filter(|family| family.name.starts_with("ties-")) {
        for case in family.rays(0.0, SEED, COUNT) {
            // Whichever is listed first wins.
            assert_eq!(both_ways(&case), [0, 0], "{}: {case:?}", family.name);
        }
        let is_broken = |case: &RayCase| both_ways(case) != [0, 0];
        for knob in [-1.0, 1.0] {
            let broken =
                family.rays(knob, SEED, COUNT).iter().filter(|case| is_broken(case)).count();
            assert!(broken > COUNT / 2, "{} {knob}: {broken}", family.name);
        }
    }
}

#[test]
fn parallel_means_parallel() {
    for case in rays("parallel-plane", 0.0) {
        assert!(object_roots(&case).is_empty(), "{case:?}");
    }
    let meets = |knob| {
        let cases = rays("parallel-plane", knob);
        cases.iter().filter(|case| !object_roots(case).is_empty()).count()
    };
    assert!(meets(1.0) > COUNT / 2 && meets(-1.0) > COUNT / 2);
    let inside = rays("parallel-plane", 0.0);
    assert!(inside.iter().any(|case| case.objects[0].side_of(case.origin) == Ordering::Equal));
}

#[test]
fn bases_are_there_or_not_as_said() {
    let statuses = |name: &str, knob: f64| -> BTreeSet<String> {
        let cases = bases(name).cases(knob, SEED, COUNT);
        let status = cases.iter().map(|case| basis(case.eye, &case.orientation).err());
        status.map(|status| format!("{status:?}")).collect()
    };
    let set = |status: Option<Status>| BTreeSet::from([format!("{status:?}")]);
    assert_eq!(statuses("up-parallel", 0.0), set(Some(Status::UpParallelToView)));
    assert!(statuses("up-parallel", 1.0).contains("None"));
    let expected =
        [Status::EyeIsAt, Status::ViewIsZero, Status::UpIsZero, Status::UpParallelToView];
    for (knob, status) in [0.0, 1.0, 2.0, 3.0].into_iter().zip(expected) {
        assert_eq!(statuses("no-basis", knob), set(Some(status)));
    }
    for name in ["basis-ordinary", "up-near-view", "view-length", "up-length"] {
        for &knob in bases(name).knobs {
            assert_eq!(statuses(name, knob), set(None), "{name} {knob}");
        }
    }
}

#[test]
fn up_is_as_near_to_the_view_as_said() {
    for &knob in bases("up-near-view").knobs {
        for case in bases("up-near-view").cases(knob, SEED, COUNT) {
            let (Orientation::At { up, .. } | Orientation::View { up, .. }) = case.orientation
            else {
                panic!("{case:?} has no up");
            };
            let [_, _, w] = basis(case.eye, &case.orientation).unwrap();
            let angle = angle_between(&w, up);
            let angle = angle.min(std::f64::consts::PI - angle).max(1e-18);
            // The rounding of up's coordinates is about 1e-16.
            let log10 = (angle - 1.5e-16).max(1e-17).log10()..=(angle + 1.5e-16).log10();
            assert!(*log10.start() < knob + 0.6 && *log10.end() > knob - 0.6, "{knob}: {angle}");
        }
    }
}

#[test]
fn outlines_go_through_pixel_centres() {
    let touching = |case: &FrameCase| -> usize {
        let view = case.camera.prepare(&case.objects).unwrap();
        let pixels = (0..case.camera.rows)
            .flat_map(|row| (0..case.camera.columns).map(move |column| (row, column)));
        let touches = |&(row, column): &(u32, u32)| {
            (0..case.objects.len())
                .any(|object| view.roots_of_pixel(object, row, column).len() == 1)
        };
        pixels.filter(touches).count()
    };
    for case in frames("frame-tangent", 0.0, 8) {
        assert!(touching(&case) > 0, "{case:?}");
    }
    for case in frames("frame-tangent", 1.0, 4) {
        assert_eq!(touching(&case), 0, "{case:?}");
    }
}

#[test]
fn frames_have_a_basis_and_see_something() {
    for family in &frames::FAMILIES {
        for &knob in family.knobs {
            let cases = family.cases(knob, SEED, 4);
            let sees = |case: &FrameCase| {
                let Camera { rows, columns, .. } = case.camera;
                let view = case.camera.prepare(&case.objects).unwrap();
                (0..rows).step_by(1 + rows as usize / 40).any(|row| {
                    let mut columns = (0..columns).step_by(1 + columns as usize / 40);
                    columns.any(|column| object_of_pixel(&view, row, column).is_some())
                })
            };
            assert!(cases.iter().any(sees), "{} {knob}", family.name);
        }
    }
}

#[test]
fn in_frames_of_ties_the_first_listed_wins_in_every_pixel() {
    for case in frames("frame-ties", 0.0, 3) {
        let view = case.camera.prepare(&case.objects).unwrap();
        for row in 0..case.camera.rows {
            for column in 0..case.camera.columns {
                let object = object_of_pixel(&view, row, column);
                assert!(object.is_none_or(|object| object % 2 == 0), "{row} {column}: {case:?}");
            }
        }
    }
}

/// Returns the number of pixels in which the object listed first is hit, whichever of the two that is.
fn tied_pixels(camera: &Camera, [a, b]: [Object; 2]) -> usize {
    let [one, other] = [[a, b], [b, a]].map(|objects| camera.prepare(&objects).unwrap());
    let pixels =
        (0..camera.rows).flat_map(|row| (0..camera.columns).map(move |column| (row, column)));
    let is_tied = |&(row, column): &(u32, u32)| {
        [&one, &other].iter().all(|view| object_of_pixel(view, row, column) == Some(0))
    };
    pixels.filter(is_tied).count()
}

#[test]
fn in_frames_that_touch_a_pixel_is_tied_and_an_ulp_breaks_it() {
    for case in frames("frame-touching", 0.0, 8) {
        let [a, b, plane] = case.objects[..] else { panic!("{case:?}") };
        for pair in [[a, b], [a, plane], [b, plane]] {
            assert_eq!(tied_pixels(&case.camera, pair), 1, "{case:?}");
        }
    }
    for case in [-1.0, 1.0].into_iter().flat_map(|knob| frames("frame-touching", knob, 4)) {
        assert_eq!(tied_pixels(&case.camera, [case.objects[0], case.objects[1]]), 0, "{case:?}");
    }
}

#[test]
fn most_families_hit_and_miss() {
    for name in ["several", "tiny-far", "planet", "grazing", "world-offset", "extreme-range"] {
        for &knob in Family::named(name).unwrap().knobs {
            let hits = rays(name, knob);
            let hits = hits
                .iter()
                .filter_map(|case| first_hit(&case.objects, case.origin, case.direction));
            let hits = hits.count();
            assert!(hits > COUNT / 8 && hits < COUNT, "{name} {knob}: {hits} of {COUNT}");
        }
    }
}

#[test]
fn what_is_invalid_is_at_fault_in_one_way() {
    assert!(invalid::rays().len() > 50 && invalid::bases().len() > 50);
    for (what, case) in invalid::rays() {
        let is_finite = |v: [f64; 3]| v.iter().all(|x| x.is_finite());
        let is_valid = case.objects.iter().all(is_valid)
            && is_finite(case.origin)
            && is_finite(case.direction)
            && case.direction != [0.0; 3];
        assert!(!is_valid, "{what}");
    }
    for (what, case) in invalid::bases() {
        assert!(numbers(&Case::Basis(case)).iter().any(|x| !x.is_finite()), "{what}");
    }
    let is_size = |x: f64| x.is_finite() && x > 0.0;
    for (what, camera) in invalid::cameras() {
        let is_valid = [camera.width, camera.height, camera.distance].map(is_size) == [true; 3];
        assert!(!is_valid || camera.rows == 0 || camera.columns == 0, "{what}");
    }
}
