//! Compares this crate's decisions, which escalate from `f64` through double-double to exact integers
//! (the ladder), with the reference: in every stress family, no decision may be wrong, and t must be
//! correctly rounded.

use pinhole_core::*;
use pinhole_reference::{Family, Hit, Orientation as Given, RayCase, Status, angle_between};

use crate::common::bases::{self, BasisCase};
use crate::common::frames::{self, FrameCase};
use crate::common::seed::seed;
use crate::common::{given, oracle, roots_of};

/// Maximum error of t in ulps: it is the exact value, rounded to the nearest `f64`.
const T_ULPS: f64 = 0.5;

/// Asserts that a root is the reference's hit: object, t, normal and point.
#[track_caller]
fn assert_hit(found: Option<&Root>, expected: Option<&Hit>, case: &dyn std::fmt::Debug) {
    let (Some(found), Some(expected)) = (found, expected) else {
        assert!(
            found.is_none() && expected.is_none(),
            "found {found:?}, expected {:?} in {case:?}",
            expected.map(|hit| (hit.object, hit.t.to_f64()))
        );
        return;
    };
    assert_eq!(found.object as usize, expected.object, "{found:?} in {case:?}");
    if expected.t.is_representable() {
        let ulps = expected.t.ulps_from(found.t);
        assert!(ulps <= T_ULPS, "t {} is {ulps} ulp off in {case:?}", found.t);
    } else {
        assert!(found.t > 0.0, "{found:?} in {case:?}");
    }
    let angle = angle_between(&expected.normal, found.normal.to_array());
    assert!(angle <= 3e-16, "normal {} is {angle:e} rad off in {case:?}", found.normal);
}

fn check_ray(case: &RayCase) -> Steps {
    let scene = given::scene(&case.objects);
    let ray = Ray { origin: case.origin.into(), direction: case.direction.into() };
    let mut steps = Steps::default();
    let exact = ExactRay::from_ray(&ray).unwrap();
    let found = scene.first_hit_counting(&exact, &mut steps);
    let expected = pinhole_reference::first_hit(&case.objects, case.origin, case.direction);
    assert_hit(found.as_ref(), expected.as_ref(), case);
    assert_eq!(roots_of(&scene, &ray).into_iter().find(|root| root.t > 0.0), found);
    for (index, object) in case.objects.iter().enumerate() {
        let found = scene.object(index as u32).unwrap().roots(&ray);
        let expected = pinhole_reference::roots(object, case.origin, case.direction);
        let found: Vec<f64> = found.iter().collect();
        assert_eq!(found.len(), expected.len(), "object {index} of {case:?}");
        for (t, real) in found.into_iter().zip(expected) {
            if real.is_representable() {
                assert!(real.ulps_from(t) <= T_ULPS, "object {index} of {case:?}");
            }
        }
    }
    steps
}

#[test]
fn any_rays() {
    let seed = seed();
    let mut cases = 0;
    for family in Family::all() {
        let mut steps = Steps::default();
        for knob in family.knobs {
            for case in family.rays(*knob, seed, 200) {
                steps = steps + check_ray(&case);
                cases += 1;
            }
        }
        if steps.total() > 0 {
            println!("{}: {steps:?}", family.name);
        }
    }
    assert!(cases > 5000, "{cases}");
}

fn status_of(result: &Result<Basis, BasisError>) -> Option<Status> {
    match result {
        Ok(_) => None,
        Err(BasisError::EyeIsAt { .. }) => Some(Status::EyeIsAt),
        Err(BasisError::ViewIsZero) => Some(Status::ViewIsZero),
        Err(BasisError::UpIsZero) => Some(Status::UpIsZero),
        Err(BasisError::UpParallelToView { .. }) => Some(Status::UpParallelToView),
        Err(other) => panic!("{other}"),
    }
}

fn check_basis(case: &BasisCase) {
    let camera = Camera {
        eye: case.eye.into(),
        orientation: given::orientation(&case.orientation),
        ..Camera::CANONICAL
    };
    if matches!(case.orientation, Given::Basis { .. }) {
        return;
    }
    let found = camera.basis();
    let expected = pinhole_reference::basis(case.eye, &case.orientation);
    assert_eq!(status_of(&found), expected.as_ref().err().copied(), "{case:?}");
    let (Ok(found), Ok(expected)) = (found, expected) else { return };
    let Basis { u, v, w } = found;
    for (found, expected) in [u, v, w].iter().zip(&expected) {
        let angle = angle_between(expected, found.to_array());
        assert!(angle <= 1.2e-16, "{angle:e} rad off in {case:?}");
    }
    // How far the rounded vectors are from orthonormal, computed with exact products.
    for (a, b, right) in
        [(u, v, 0.0), (v, w, 0.0), (w, u, 0.0), (u, u, 1.0), (v, v, 1.0), (w, w, 1.0)]
    {
        let dot = oracle::Big3::from(a).dot(&oracle::Big3::from(b)) - oracle::big(right);
        let dot = oracle::near(&dot);
        let defect = if right == 1.0 { 0.5 * dot.abs() } else { dot.abs() };
        assert!(defect <= 2e-16, "{defect:e} in {case:?}");
    }
}

#[test]
fn bases() {
    let seed = seed();
    let mut cases = 0;
    for family in &bases::FAMILIES {
        for knob in family.knobs {
            for case in family.cases(*knob, seed, 100) {
                check_basis(&case);
                cases += 1;
            }
        }
    }
    assert!(cases > 1000, "{cases}");
}

fn check_frame(case: &FrameCase) -> Steps {
    let scene = given::scene(&case.objects);
    let camera = given::camera(&case.camera).resolve().unwrap();
    let raster = Raster::full(camera.image());
    let frame = trace(&scene, &camera, &raster, Outputs { normal: true, ..Outputs::default() });
    let single = trace_as::<f32>(&scene, &camera, &raster, Outputs::default());
    assert_eq!(frame.object, single.object, "{case:?}");
    let view = case.camera.prepare(&case.objects).unwrap();
    let mut index = 0;
    for row in 0..camera.image().height() {
        for column in 0..camera.image().width() {
            let (t, object, normal) = (frame.t[index], frame.object[index], frame.normal[index]);
            let single_t = single.t[index];
            index += 1;
            let found =
                (object != NO_OBJECT).then_some(Root { object, t, point: DVec3::ZERO, normal });
            let expected = view.first_hit_of_pixel(row, column);
            let context = (row, column, case);
            assert_hit(found.as_ref(), expected.as_ref(), &context);
            if let Some(hit) = expected
                && hit.t.is_representable_f32()
            {
                let ulps = hit.t.ulps_from_f32(single_t);
                assert!(ulps <= 1.0, "{single_t} is {ulps} ulp off at {context:?}");
            }
        }
    }
    frame.steps
}

#[test]
fn whole_frames() {
    let seed = seed();
    let mut pixels = 0;
    for family in &frames::FAMILIES {
        let mut steps = Steps::default();
        for knob in family.knobs {
            for case in family.cases(*knob, seed, 2) {
                steps = steps + check_frame(&case);
                pixels += case.camera.columns * case.camera.rows;
            }
        }
        if steps.total() > 0 {
            println!("{}: {steps:?}", family.name);
        }
    }
    println!("{pixels} pixels");
    assert!(pixels > 10_000, "{pixels}");
}

/// However close the eye is to a surface, on either side, only one decision, on which side it is, needs
/// exact integers; t is found in double-double. Otherwise, a picture from there would take seconds.
#[test]
fn eyes_next_to_a_surface() {
    let balls = [([0.0, 0.0, -1.0], 1.0), ([0.0, -8.0, 0.0], 8.0), ([-5e-21, 0.0, 0.0], 5e-21)];
    let toward = [[0.1, -0.1, -1.0], [0.3, -0.7, -0.2], [-1.0, 1e-3, 2.0], [1.0, 1.0, 1.0]];
    for (center, radius) in balls {
        for away in [1e-40, 3e-90, 1e-99, 1e-100, 7e-121, 1e-155, 2e-162, 1e-200, 1e-310, 5e-324] {
            for direction in toward.iter().flat_map(|d| [*d, d.map(|x| -x)]) {
                for origin in [[away, 0.0, 0.0], [0.0, away, away], [0.0, -away, -away]] {
                    let objects = vec![pinhole_reference::Object::Sphere { center, radius }];
                    let case = RayCase { objects, origin, direction };
                    assert!(check_ray(&case).exact <= 1, "{case:?}");
                }
            }
        }
    }
}
