//! Error maps: the picture of an intersection method is compared, pixel by pixel, with that of the exact
//! method (called the ladder), and the errors are shown as colours. All functions here are pure.

use egui::Color32;
use pinhole_core::methods::Traced;
use pinhole_core::{Frame, NO_OBJECT, Raster};
use pinhole_figure::overlay::opaque;

/// The error of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PixelError {
    /// The ray hits nothing, and the method agrees.
    Miss,
    /// Both methods find the same object. The value is the difference of their t, in ulps of `f64` and at
    /// most [`f64::MAX`].
    Ulps(f64),
    /// The method finds the wrong object: another one, one where there is none, or none where there is one.
    Wrong,
}

/// The errors of a method's picture, compared with the answers of the exact method (the ladder).
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The error at every traced pixel, row by row.
    pub errors: Vec<PixelError>,
    /// Number of pixels that are [`PixelError::Wrong`].
    pub wrong: usize,
    /// Largest error of t in ulps, over all pixels where both methods hit the same object; `None` if there
    /// are none.
    pub largest: Option<f64>,
}

impl Comparison {
    /// Compares the exact answers in `truth` with another method's answers at the same pixels.
    pub fn new(truth: &Frame, traced: &Traced) -> Comparison {
        let hits = truth.object.iter().zip(&truth.t).zip(traced.object.iter().zip(&traced.t));
        let errors: Vec<PixelError> =
            hits.map(|((object, t), (by, t_by))| error_of(*object, *t, *by, *t_by)).collect();
        let wrong = errors.iter().filter(|error| **error == PixelError::Wrong).count();
        let largest = errors
            .iter()
            .filter_map(|error| match error {
                PixelError::Ulps(ulps) => Some(*ulps),
                _ => None,
            })
            .reduce(f64::max);
        Comparison { errors, wrong, largest }
    }
}

fn error_of(object: u32, t: f64, by: u32, t_by: f64) -> PixelError {
    if object != by || (by != NO_OBJECT && !t_by.is_finite()) {
        return PixelError::Wrong;
    }
    if object == NO_OBJECT {
        return PixelError::Miss;
    }
    PixelError::Ulps(((t_by - t).abs() / ulp(t)).min(f64::MAX))
}

/// Returns the difference between a positive number and the next larger `f64`.
fn ulp(t: f64) -> f64 {
    (t.next_up() - t).max(f64::from_bits(1))
}

/// Upper end of the colour scale, as the exponent of a power of ten: an error of 10^16 ulps of `f64` leaves
/// no correct digit of t.
pub(crate) const DECADES: f64 = 16.0;

/// Colour of pixels where nothing is hit.
const NOTHING: Color32 = Color32::from_rgb(0x2a, 0x2d, 0x33);

/// Colour of wrong pixels, in the error map and in its legend.
pub(crate) const WRONG: Color32 = Color32::from_rgb(0xff, 0x2d, 0x55);

/// The colour map Viridis (van der Walt and Smith 2015). It is perceptually uniform, even for colour-blind
/// viewers, and its brightness increases steadily.
const VIRIDIS: [[u8; 3]; 10] = [
    [68, 1, 84],
    [72, 40, 120],
    [62, 73, 137],
    [49, 104, 142],
    [38, 130, 142],
    [31, 158, 137],
    [53, 183, 121],
    [109, 205, 89],
    [180, 222, 44],
    [253, 231, 37],
];

/// Returns the colour of an error of t: the darkest for one ulp or less, the brightest if no digit is
/// correct.
pub(crate) fn color_of_ulps(ulps: f64) -> Color32 {
    let share = (ulps.max(1.0).log10() / DECADES).clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let index = (share as usize).min(VIRIDIS.len() - 2);
    let part = share - index as f64;
    opaque(std::array::from_fn(|k| {
        let [low, high] = [VIRIDIS[index][k], VIRIDIS[index + 1][k]].map(f64::from);
        (low + part * (high - low)).round() as u8
    }))
}

/// Returns the error map's colours, one for each traced pixel.
pub(crate) fn colors(comparison: &Comparison) -> Vec<Color32> {
    let color = |error: &PixelError| match error {
        PixelError::Miss => NOTHING,
        PixelError::Ulps(ulps) => color_of_ulps(*ulps),
        PixelError::Wrong => WRONG,
    };
    comparison.errors.iter().map(color).collect()
}

/// Minimum size of a wrong pixel's mark, in points. It keeps the mark visible from the back row even if a
/// pixel of the image covers only one pixel of the screen.
const MARK: f32 = 5.0;

/// Marks the wrong pixels in a buffer of `width` screen pixels per row that shows the whole error map. The
/// marks are squares with a white edge, so they can be recognized by their shape as well as by their
/// colour.
pub(crate) fn mark_wrong(
    comparison: &Comparison,
    raster: &Raster,
    width: usize,
    scale: f32,
    dots: &mut [Color32],
) {
    let (columns, height) = (raster.columns().len(), dots.len().checked_div(width).unwrap_or(0));
    let least = (MARK * scale).round().max(1.0) as usize;
    let edge = scale.round().max(1.0) as usize;
    let across = |index: usize, count: usize, dots: usize| {
        let (start, end) = (index * dots / count, (index + 1) * dots / count);
        let missing = least.saturating_sub(end - start);
        (start.saturating_sub(missing / 2), (end + missing.div_ceil(2)).min(dots))
    };
    let wrong = comparison.errors.iter().enumerate().filter(|(_, e)| **e == PixelError::Wrong);
    let marks: Vec<_> = wrong
        .map(|(index, _)| {
            let rows = across(index / columns, raster.rows().len(), height);
            (rows, across(index % columns, columns, width))
        })
        .collect();
    // All edges are painted before the fills, so adjacent marks merge into one area with a single edge.
    for (grow, color) in [(edge, Color32::WHITE), (0, WRONG)] {
        for ((top, bottom), (left, right)) in &marks {
            let columns = left.saturating_sub(grow)..(right + grow).min(width);
            for row in top.saturating_sub(grow)..(bottom + grow).min(height) {
                dots[row * width..][columns.clone()].fill(color);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_missed_off_by_ulps_or_wrong() {
        let none = NO_OBJECT;
        assert_eq!(error_of(none, f64::INFINITY, none, f64::INFINITY), PixelError::Miss);
        assert_eq!(error_of(0, 4.0, 0, 4.0), PixelError::Ulps(0.0));
        assert_eq!(error_of(0, 4.0, 0, 4.0f64.next_up().next_up()), PixelError::Ulps(2.0));
        let single = f64::from(4.0f32.next_up());
        assert_eq!(error_of(0, 4.0, 0, single), PixelError::Ulps((1u64 << 29) as f64));
        for (object, by, t_by) in [(0, none, f64::INFINITY), (none, 0, 4.0), (0, 1, 4.0)] {
            assert_eq!(error_of(object, 4.0, by, t_by), PixelError::Wrong);
        }
        assert_eq!(error_of(0, 4.0, 0, f64::NAN), PixelError::Wrong);
        assert_eq!(error_of(0, 1e-310, 0, 4.0), PixelError::Ulps(f64::MAX));
    }

    #[test]
    fn brighter_is_worse() {
        let light = |ulps: f64| {
            let color = color_of_ulps(ulps);
            2 * u32::from(color.r()) + 5 * u32::from(color.g()) + u32::from(color.b())
        };
        let lights = [0.0, 1e2, 1e5, 1e8, 1e11, 1e14, 1e16].map(light);
        assert!(lights.is_sorted_by(|a, b| a < b), "{lights:?}");
        assert_eq!(color_of_ulps(0.0), color_of_ulps(1.0));
        assert_eq!(color_of_ulps(f64::MAX), color_of_ulps(1e16));
        assert_ne!(color_of_ulps(1.0), NOTHING);
    }
}
