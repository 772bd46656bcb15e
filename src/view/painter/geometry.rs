//! Pixels, rectangles of them, and the sub-pixel grid that triangles are snapped to.

use egui::Rect;

/// Sub-pixel steps per pixel, to which vertices are snapped as on GPUs. The test whether a pixel's
/// centre is inside is then exact in integers, so neighbours neither overlap nor leave gaps.
pub(super) const STEPS: i64 = 256;

/// Greatest coordinate of a vertex, in pixels; farther ones are clamped to it, so that products of
/// coordinates fit into an `i64`.
const FAR: f32 = 1_000_000.0;

/// A rectangle of pixels, right and bottom exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
    /// The column after the last.
    pub right: usize,
    /// The row after the last.
    pub bottom: usize,
}

impl PixelRect {
    /// Returns the rectangle of a whole picture.
    pub fn whole([width, height]: [usize; 2]) -> Self {
        Self { left: 0, top: 0, right: width, bottom: height }
    }

    /// Converts egui's clip rectangle to a GPU's scissor: rounded to whole pixels, limited to the
    /// picture.
    pub(super) fn scissor(clip: Rect, scale: f32, size: [usize; 2]) -> Self {
        // The cast saturates, so a negative number becomes 0.
        let to = |x: f32, limit: usize| ((x * scale).round() as usize).min(limit);
        Self {
            left: to(clip.min.x, size[0]),
            top: to(clip.min.y, size[1]),
            right: to(clip.max.x, size[0]),
            bottom: to(clip.max.y, size[1]),
        }
    }

    /// Returns all pixels that a rectangle can touch, and one more on each side.
    pub(super) fn around(rect: Rect, scale: f32, size: [usize; 2]) -> Self {
        let down = |x: f32| ((x * scale).floor() - 1.0) as usize;
        let up = |x: f32, limit: usize| (((x * scale).ceil() + 1.0) as usize).min(limit);
        Self {
            left: down(rect.min.x),
            top: down(rect.min.y),
            right: up(rect.max.x, size[0]),
            bottom: up(rect.max.y, size[1]),
        }
    }

    /// Returns the intersection of both.
    pub fn intersect(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// Returns the smallest rectangle around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// Returns true if it has no pixels.
    pub fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// Returns the number of pixels.
    pub fn area(self) -> usize {
        self.right.saturating_sub(self.left) * self.bottom.saturating_sub(self.top)
    }
}

/// Converts pixels to steps.
#[inline(always)]
pub(super) fn snap(pixels: f32) -> i64 {
    // For a positive number truncation is the floor, and needs no call into the C library.
    const SHIFT: i64 = 1 << 40;
    let steps = f64::from(pixels.clamp(-FAR, FAR)) * STEPS as f64;
    (steps + (SHIFT as f64 + 0.5)) as i64 - SHIFT
}

/// Returns the first pixel whose centre is not before a position given in steps.
#[inline(always)]
pub(super) fn first_centre(steps: i64) -> i64 {
    (steps + STEPS / 2 - 1).div_euclid(STEPS)
}

/// Limits a range of pixels to `from..to`.
#[inline(always)]
pub(super) fn limit(first: i64, end: i64, from: usize, to: usize) -> (usize, usize) {
    let first = first.clamp(from as i64, to as i64);
    let end = end.clamp(first, to.max(from) as i64);
    (first as usize, end as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_rounds_to_the_nearest_step() {
        assert_eq!(snap(0.0), 0);
        assert_eq!(snap(1.5), 384);
        assert_eq!(snap(-1.5), -384);
        assert_eq!(snap(1.0 / 512.0), 1);
        assert_eq!(snap(-1.0 / 1024.0), 0);
        assert_eq!(snap(f32::INFINITY), 256_000_000);
    }

    #[test]
    fn centres() {
        assert_eq!(first_centre(0), 0);
        assert_eq!(first_centre(128), 0);
        assert_eq!(first_centre(129), 1);
        assert_eq!(first_centre(-129), -1);
        assert_eq!(first_centre(-127), 0);
    }

    #[test]
    fn scissors_round_and_stay_inside() {
        let clip = Rect::from_min_max(egui::pos2(-5.0, 0.4), egui::pos2(1e9, 2.5));
        let rect = PixelRect::scissor(clip, 1.0, [10, 10]);
        assert_eq!(rect, PixelRect { left: 0, top: 0, right: 10, bottom: 3 });
        assert!(PixelRect::scissor(Rect::NOTHING, 1.0, [10, 10]).is_empty());
    }
}
