//! The viewport of an angle, in numbers with few digits.

use pinhole_core::{Viewport, extent_of_fov, fov_of_extent};

/// The width or height that is seen under this angle; of all that are, the one with fewest digits.
pub(crate) fn extent(degrees: f64, distance: f64) -> f64 {
    let near = extent_of_fov(degrees.to_radians(), distance);
    shortest_where(near, |x| fov_of_extent(x, distance).to_degrees() == degrees)
}

/// The number with fewest digits near `x` that still does what is asked; `x` where none does.
pub(crate) fn shortest_where(x: f64, fits: impl Fn(f64) -> bool) -> f64 {
    (0..17)
        .filter_map(|digits| format!("{x:.digits$e}").parse::<f64>().ok())
        .find(|x| fits(*x))
        .unwrap_or(x)
}

/// The number with fewest digits that is within the roundings from `x`.
pub(crate) fn settled(x: f64, roundings: f64) -> f64 {
    if x.abs() <= roundings {
        return 0.0;
    }
    shortest_where(x, |y| (y - x).abs() <= roundings)
}

/// `ratio` times as much, in as few digits as keep the ratio to its last one.
pub(crate) fn in_ratio(x: f64, ratio: f64) -> f64 {
    if ratio == 1.0 {
        return x;
    }
    shortest_where(x * ratio, |y| (y / x / ratio - 1.0).abs() <= 2.0 * f64::EPSILON)
}

/// The viewport at `distance` that is seen under this vertical angle and is `aspect` times as wide as
/// high.
pub(crate) fn viewport_of_angle(degrees: f64, aspect: f64, distance: f64) -> Viewport {
    let height = extent(degrees, distance);
    Viewport { width: in_ratio(height, aspect), height, distance }
}
