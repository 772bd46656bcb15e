//! Tests of bases for which the textbook's formula in `f64` is not accurate enough.

use pinhole_core::*;
use pinhole_reference::{Orientation as Given, Real, Status, angle_between};

use crate::common::{Numbers, vec3};

/// Returns a camera whose `at - eye` is exactly `factor * up` plus `aside` along x, which needs more
/// digits than an `f64` has.
fn looking_along_up(up: [u64; 3], factor: u64, aside: f64) -> Camera {
    let (mut eye, mut at) = ([0.0; 3], [0.0; 3]);
    for i in 0..3 {
        let view = u128::from(up[i]) * u128::from(factor);
        at[i] = view as f64;
        eye[i] = -((view as i128 - at[i] as i128) as f64);
    }
    eye[0] -= aside;
    let up = up.map(|x| x as f64).into();
    let orientation = Orientation::At { at: at.into(), up };
    Camera { eye: eye.into(), orientation, ..Camera::CANONICAL }
}

fn truth_of(camera: &Camera) -> Result<[[Real; 3]; 3], Status> {
    let orientation = match camera.orientation {
        Orientation::At { at, up } => Given::At { at: at.to_array(), up: up.to_array() },
        Orientation::View { view, up } => Given::View { view: view.to_array(), up: up.to_array() },
        Orientation::Basis(Basis { u, v, w }) => {
            Given::Basis { u: u.to_array(), v: v.to_array(), w: w.to_array() }
        }
    };
    pinhole_reference::basis(camera.eye.to_array(), &orientation)
}

/// Returns the largest angle between a vector of the basis and the true one.
fn turned(found: &Basis, truth: &[[Real; 3]; 3]) -> f64 {
    let angles = [found.u, found.v, found.w].into_iter().zip(truth);
    angles.map(|(found, truth)| angle_between(truth, found.to_array())).fold(0.0, f64::max)
}

/// Maximum angle between a vector whose coordinates are each rounded once and the exact vector.
const ROUNDING: f64 = 1.2e-16;

const UPS: [[u64; 3]; 4] = [
    [1 << 52 | 12345, 3 << 51 | 7, 1 << 52 | 987_654_321],
    [1 << 52 | 99991, 1 << 51 | 77_777_777, 1 << 51 | 1],
    [1 << 50 | 3, 1 << 52 | 31_415_926_535, 1 << 51 | 271_828_182_845],
    [1 << 52 | 1, 1 << 52 | 3, 1 << 52 | 5],
];

/// Computes the basis by the textbook's formula in `f64`.
fn by_textbook(camera: &Camera) -> Option<Basis> {
    let w = -camera.view().normalize();
    let u = camera.up().cross(w).try_normalize()?;
    Some(Basis { u, v: w.cross(u), w })
}

/// For ordinary cameras, the basis is more accurate than by the textbook's formula, which rounds each
/// coordinate several times.
#[test]
fn an_ordinary_basis_is_closer_than_the_textbook_gets() {
    let mut wrong = 0;
    let mut numbers = Numbers(3);
    for _ in 0..100 {
        let orientation = Orientation::At { at: numbers.point(5.0), up: DVec3::Y };
        let camera = Camera { eye: vec3(20.0, 4.0, 10.0), orientation, ..Camera::CANONICAL };
        let truth = truth_of(&camera).unwrap();
        assert!(turned(&camera.basis().unwrap(), &truth) <= ROUNDING, "{camera:?}");
        wrong += usize::from(turned(&by_textbook(&camera).unwrap(), &truth) > ROUNDING);
    }
    assert!(wrong > 0);
}

/// Tests up vectors that are parallel to the view to within 1e-16 rad and far less, for which the
/// formula in `f64` gives a camera with an arbitrary roll.
#[test]
fn up_nearly_parallel_to_view_is_beyond_f64() {
    let mut worst = 0.0_f64;
    for up in UPS {
        for aside in [1.0, 0.5_f64.powi(10), 0.5_f64.powi(20)] {
            let camera = looking_along_up(up, (1 << 30) + 3, aside);
            let truth = truth_of(&camera).unwrap();
            assert!(turned(&camera.basis().unwrap(), &truth) <= ROUNDING, "{camera:?}");
            let off = by_textbook(&camera).map(|basis| turned(&basis, &truth));
            worst = worst.max(off.unwrap_or(std::f64::consts::PI));
        }
    }
    assert!(worst > 1e-3, "{worst:?}");
}

/// If up is exactly parallel to the view, there is no basis, which cannot be recognised with rounded
/// numbers.
#[test]
fn up_exactly_parallel_to_view_is_beyond_f64() {
    let mut made_up = 0;
    for up in UPS {
        for factor in [(1 << 30) + 3, (1 << 29) + 12347, 3_u64.pow(19)] {
            let camera = looking_along_up(up, factor, 0.0);
            assert_eq!(truth_of(&camera), Err(Status::UpParallelToView));
            let found = camera.basis();
            assert!(matches!(found, Err(BasisError::UpParallelToView { .. })), "{found:?}");
            made_up += usize::from(by_textbook(&camera).is_some());
        }
    }
    assert!(made_up > 0);
}
