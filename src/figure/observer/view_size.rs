//! The size of the world view, and which parts of it an observer may fill.

use pinhole_core::extent_of_fov;

use crate::observer::FOV;

/// Minimum and maximum length of the basis arrows on the screen, in points. Between these limits, the
/// arrows are one world unit long.
const ARROW_POINTS: (f64, f64) = (62.0, 125.0);

/// Minimum length of the basis arrows in a small view, as a fraction of the smaller of its height and
/// width.
const ARROW_SHARE: f64 = 0.28;

/// Maximum length of the basis arrows in a view that is directed to them, as such a fraction.
const DIRECTED_SHARE: f64 = 0.51;

/// Minimum width and height of a part of the view in which something is shown, as a fraction of the view's.
const LEAST_SHARE: f64 = 0.25;

/// The size of the world view on the screen, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewSize {
    /// The width.
    pub width: f64,
    /// The height.
    pub height: f64,
    /// True if the view is directed to a part of the figure, whose arrows may then be longer.
    pub is_directed: bool,
    /// What an inset and a line of numbers cover. Both lie in the lower right corner.
    pub covered: [Option<Area>; 2],
}

/// A rectangle of a view: left, top, right and bottom, in points from the view's top left corner.
pub type Area = [f64; 4];

impl ViewSize {
    /// Creates the size of a view of which nothing is covered.
    pub fn new(width: f64, height: f64) -> ViewSize {
        ViewSize { width, height, is_directed: false, covered: [None; 2] }
    }

    /// Returns the size of a view that has the usual height and this aspect ratio (width to height).
    pub fn of_aspect(aspect: f64) -> ViewSize {
        ViewSize::new(480.0 * tame_aspect(aspect), 480.0)
    }

    /// Returns the ratio of width to height, clamped to a sensible range.
    pub fn aspect(self) -> f64 {
        tame_aspect(self.width / self.height)
    }

    /// Returns the minimum and maximum length of the basis arrows in this view, in points. Normals are
    /// drawn with the minimum length.
    pub fn arrow_points(self) -> (f64, f64) {
        let (least, most) = ARROW_POINTS;
        let shorter = self.width.min(self.height);
        let most = if self.is_directed { most.max(DIRECTED_SHARE * shorter) } else { most };
        (least.min(ARROW_SHARE * shorter).max(1.0), most)
    }

    /// Returns the length in the world that one point of the screen covers at this depth in front of the
    /// observer.
    pub(super) fn world_per_point(self, depth: f64) -> f64 {
        extent_of_fov(FOV, depth) / self.height.max(1.0)
    }

    /// Returns the area of the whole view.
    pub(super) fn whole(self) -> Area {
        [0.0, 0.0, self.width, self.height]
    }

    /// Returns the largest rectangles of which nothing is covered, beside and above what is covered.
    pub(super) fn free_areas(self) -> impl Iterator<Item = Area> {
        let mut free = vec![self.whole()];
        for covered in self.covered.into_iter().flatten() {
            let beside = |[left, top, right, bottom]: Area| {
                let is_apart = right <= covered[0] || bottom <= covered[1];
                let cut = [
                    [left, top, right.min(covered[0]), bottom],
                    [left, top, right, bottom.min(covered[1])],
                ];
                cut.into_iter().skip(usize::from(is_apart))
            };
            free = free.into_iter().flat_map(beside).collect();
        }
        free.retain(|[left, top, right, bottom]| {
            right - left >= LEAST_SHARE * self.width && bottom - top >= LEAST_SHARE * self.height
        });
        free.into_iter()
    }

    /// Returns true if a rectangle overlaps what is covered.
    pub(super) fn covers(self, [left, top, right, bottom]: Area) -> bool {
        self.covered.into_iter().flatten().any(|covered| {
            left < covered[2] && covered[0] < right && top < covered[3] && covered[1] < bottom
        })
    }
}

pub(super) fn tame_aspect(aspect: f64) -> f64 {
    if aspect.is_finite() { aspect.clamp(0.1, 10.0) } else { 1.0 }
}
