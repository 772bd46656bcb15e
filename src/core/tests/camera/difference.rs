//! Differences of two cameras, in numbers that are known.

use pinhole_core::*;

const ONE: Camera = Camera::CANONICAL;

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * b.abs().max(1.0)
}

#[test]
fn no_difference_is_nothing() {
    let CameraDifference { eye, at, up, basis, turn, roll, distance, extent, .. } =
        ONE.difference_from(&ONE).unwrap();
    assert_eq!((eye, at, roll), (DVec3::ZERO, Some(DVec3::ZERO), Some(0.0)));
    assert_eq!((up, basis, turn, distance, extent), (0.0, [0.0; 3], 0.0, 0.0, [0.0; 2]));
}

#[test]
fn a_swing_is_a_roll_and_nothing_else() {
    for degrees in [1e-5, 30.0, 90.0, 179.0, -45.0] {
        let difference = ONE.swung(degrees).unwrap().difference_from(&ONE).unwrap();
        let expected = f64::abs(degrees);
        assert!(near(difference.roll.unwrap(), degrees), "{difference:?}");
        assert!(near(difference.turn, expected) && near(difference.up, expected));
        let [u, v, w] = difference.basis;
        assert!(near(u, expected) && near(v, expected) && w == 0.0, "{difference:?}");
        assert_eq!(difference.eye, DVec3::ZERO);
    }
    // Half a turn is the same both ways.
    assert_eq!(ONE.swung(180.0).unwrap().difference_from(&ONE).unwrap().roll.unwrap().abs(), 180.0);
}

#[test]
fn a_level_turn_is_no_roll() {
    let turned = ONE.orbited(0.5, 0.0).unwrap().orbited(0.0, -0.3).unwrap();
    let difference = turned.difference_from(&ONE).unwrap();
    assert!(difference.roll.unwrap().abs() < 1e-13, "{difference:?}");
    let [u, v, w] = difference.basis;
    assert!(near(u, 0.5_f64.to_degrees()) && near(v, 0.3_f64.to_degrees()) && w > u);
    assert!(difference.turn >= w);
    assert_eq!((difference.at, difference.up), (Some(DVec3::ZERO), 0.0));
    assert_eq!(difference.eye, turned.eye);
}

#[test]
fn lengths_are_differences() {
    let eye = DVec3::new(1.0, 2.0, 3.0);
    let viewport = Viewport { width: 2.0, height: 0.5, distance: 4.0 };
    let orientation = Orientation::View { view: DVec3::NEG_Z, up: DVec3::Y };
    let other = Camera { eye, viewport, orientation, ..ONE };
    let difference = other.difference_from(&ONE).unwrap();
    assert_eq!((difference.eye, difference.at), (eye, None));
    assert_eq!((difference.distance, difference.extent), (3.0, [1.0, -0.5]));
    assert_eq!(ONE.difference_from(&other).unwrap().eye, -eye);
}

#[test]
fn without_a_level_there_is_no_roll_and_without_a_basis_no_difference() {
    let down = Orientation::View { view: DVec3::NEG_Y, up: DVec3::NEG_Z };
    let down = Camera { orientation: down, ..ONE };
    assert_eq!(down.difference_from(&ONE).unwrap().roll, None);
    let none = Camera { orientation: Orientation::At { at: ONE.eye, up: DVec3::Y }, ..ONE };
    assert!(none.difference_from(&ONE).is_err() && ONE.difference_from(&none).is_err());
}
