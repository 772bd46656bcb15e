//! Readable numbers.

use pinhole_core::shortest;
use pinhole_core::steering::*;
use proptest::prelude::*;

use crate::common::seed::config;

#[test]
fn decimal_steps_give_decimals() {
    for (value, step, expected) in [
        (0.31, 0.1, "0.3"),
        (0.16, 0.05, "0.15"),
        (-1.234, 0.02, "-1.24"),
        (0.7, 0.001, "0.7"),
        (17.0, 5.0, "15"),
        (-0.01, 0.5, "0"),
        (1e300, 1e-300, "1e300"),
        (3.1e-7, 1e-7, "3e-7"),
    ] {
        assert_eq!(shortest(snapped(value, step).unwrap()), expected);
    }
    assert!(matches!(snapped(f64::NAN, 1.0), Err(SteerError::NotFinite { field: "value", .. })));
    for step in [0.0, -1.0, f64::NAN] {
        assert!(matches!(snapped(1.0, step), Err(SteerError::NotPositive { field: "step", .. })));
    }
}

#[test]
fn steps_are_one_two_five() {
    for (at_least, expected) in [
        (1.0, 1.0),
        (1.0001, 2.0),
        (2.5, 5.0),
        (7.0, 10.0),
        (0.1, 0.1),
        (3e-9, 5e-9),
        (999.9999, 1000.0),
        (6e20, 1e21),
    ] {
        assert_eq!(nice_step(at_least), Ok(expected));
    }
    assert!(nice_step(0.0).is_err() && nice_step(f64::MAX).is_err());
}

#[test]
fn dragged_numbers_stay_short() {
    for (value, pixel, expected) in [
        (1.2296875, 0.01, "1.23"),
        (-19.99987, 0.02, "-20"),
        (123456.789, 100.0, "123460"),
        (0.00012345, 1e-6, "0.0001234"),
        (9.96, 0.5, "10"),
        (-0.0004, 0.01, "0"),
    ] {
        assert_eq!(shortest(rounded_to(value, pixel).unwrap()), expected);
    }
    assert!(rounded_to(f64::INFINITY, 1.0).is_err() && rounded_to(1.0, 0.0).is_err());
}

/// Returns the number of digits of the shortest decimal form of a number.
fn digits(x: f64) -> usize {
    let text = format!("{x:e}");
    let mantissa = text.split('e').next().unwrap().trim_start_matches('-').replace('.', "");
    mantissa.len()
}

proptest! {
    #![proptest_config(config(4000))]

    #[test]
    fn rounding_is_within_a_tenth_of_a_pixel(
        value in -1.0..1.0_f64, size in -9.0..9.0_f64, finer in 0.0..14.0_f64,
    ) {
        let value = value * 10_f64.powf(size);
        let pixel = 10_f64.powf(size - finer);
        let rounded = rounded_to(value, pixel).unwrap();
        prop_assert!((rounded - value).abs() <= 0.1 * pixel);
        // A decimal with one digit less would be too far away.
        if rounded != 0.0 && digits(rounded) > 1 {
            let fewer: f64 = format!("{value:.0$e}", digits(rounded) - 2).parse().unwrap();
            prop_assert!((fewer - value).abs() > 0.1 * pixel);
        }
    }

    #[test]
    fn nice_steps_are_the_next(at_least in -300.0..300.0_f64) {
        let at_least = 10_f64.powf(at_least);
        let step = nice_step(at_least).unwrap();
        prop_assert!(step >= at_least && step < 2.5001 * at_least);
        prop_assert_eq!(digits(step), 1);
        let snap = snapped(0.3 * at_least, step).unwrap();
        prop_assert!(snap == 0.0 || snap == step);
    }
}
