//! Dragged numbers that stay readable: snapped to a step, or rounded to what a pixel can tell.

use super::steered::{SteerError, check_finite, check_positive};

/// The multiple of `step` nearest to a value. Of a decimal step such as 0.05 it is the decimal itself
/// (0.15, not 0.15000000000000002).
///
/// ```
/// use pinhole_core::steering::snapped;
/// assert_eq!(snapped(0.16, 0.05)?, 0.15);
/// assert_eq!(snapped(-40.0, 15.0)?, -45.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if the value is not finite or the step not positive and finite.
pub fn snapped(value: f64, step: f64) -> Result<f64, SteerError> {
    check_finite("value", value)?;
    check_positive("step", step)?;
    let count = (value / step).round();
    if !count.is_finite() || count.abs() > 2_f64.powi(53) {
        // The step is finer than the value's last digit.
        return Ok(value);
    }
    // A step that is one part of a whole: the quotient of two whole numbers is rounded once.
    let parts = (1.0 / step).round();
    let is_part = step < 1.0 && parts <= 1e22 && 1.0 / parts == step;
    // Added to 0, a negative zero is 0.
    Ok(if is_part { count / parts } else { count * step } + 0.0)
}

/// The smallest of 1, 2, 5 times a power of ten that is not less than `at_least`: a step to snap to,
/// where `at_least` is so many pixels in the world.
///
/// ```
/// use pinhole_core::steering::nice_step;
/// assert_eq!(nice_step(0.013)?, 0.02);
/// assert_eq!(nice_step(50.0)?, 50.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if `at_least` is not positive and finite, or there is no such number.
pub fn nice_step(at_least: f64) -> Result<f64, SteerError> {
    check_positive("step", at_least)?;
    let power = at_least.log10().floor() as i32;
    // One power to either side, for rounding of the logarithm.
    let steps =
        (power - 1..=power + 1).flat_map(|k| [1, 2, 5].map(|m| decimal(&format!("{m}e{k}"))));
    steps
        .filter(|step| step.is_finite())
        .find(|step| *step >= at_least)
        .ok_or(SteerError::NotPositive { field: "step", value: f64::INFINITY })
}

/// The decimal with the fewest digits that is within a tenth of a pixel of a value, and of those the
/// nearest: `pixel` is what a pixel measures in the world there.
///
/// ```
/// use pinhole_core::steering::rounded_to;
/// assert_eq!(rounded_to(1.2296875, 0.01)?, 1.23);
/// assert_eq!(rounded_to(-0.0004, 0.01)?, 0.0);
/// # Ok::<(), pinhole_core::steering::SteerError>(())
/// ```
///
/// # Errors
/// Returns an error if the value is not finite or the pixel not positive and finite.
pub fn rounded_to(value: f64, pixel: f64) -> Result<f64, SteerError> {
    check_finite("value", value)?;
    check_positive("pixel", pixel)?;
    let near = 0.1 * pixel;
    if value.abs() <= near {
        return Ok(0.0);
    }
    // 17 digits tell every f64 apart.
    let rounded = (0..17).map(|digits| decimal(&format!("{value:.digits$e}")));
    Ok(rounded.into_iter().find(|x| (x - value).abs() <= near).unwrap_or(value))
}

/// A decimal as the nearest `f64`; written by `format!`, it is always one.
fn decimal(text: &str) -> f64 {
    text.parse().unwrap_or(f64::NAN)
}
