//! Marks that tell methods apart: a shape and a colour for each formula, hollow in `f32`, filled in
//! `f64`, filled and framed in double-double.

use egui::Color32;

use crate::figures::chart::{Chart, Point};
use crate::report::model::Digits;

/// A shape and a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Marker {
    pub(crate) color: Color32,
    shape: Shape,
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    /// A polygon of so many equal sides, the first corner so many degrees from straight up.
    Regular(usize, f64),
    Star,
}

/// Half the width of a mark, in points.
const RADIUS: f64 = 6.0;

/// Wrong decisions, wherever they are shown.
pub(crate) const WRONG: Color32 = Color32::from_rgb(0xb0, 0x00, 0x20);

/// Colours after Okabe and Ito, "Color Universal Design" (2008), which readers who do not see red
/// or green can tell apart; yellow, too light for white paper, is wine instead (Tol 2021).
const MARKERS: [(&str, Marker); 8] = [
    ("ladder", Marker { color: Color32::BLACK, shape: Shape::Star }),
    ("textbook", marker([0xd5, 0x5e, 0x00], 24, 0.0)),
    ("half-b", marker([0xe6, 0x9f, 0x00], 4, 45.0)),
    ("kahan", marker([0x00, 0x9e, 0x73], 3, 0.0)),
    ("perpendicular", marker([0x00, 0x72, 0xb2], 4, 0.0)),
    ("closest-point", marker([0x56, 0xb4, 0xe9], 3, 180.0)),
    ("recentred", marker([0xcc, 0x79, 0xa7], 5, 0.0)),
    ("lagrange", marker([0x88, 0x22, 0x55], 3, 90.0)),
];

/// What each formula does, in half a line.
const IN_WORDS: [(&str, &str); 8] = [
    ("ladder", "certified: where f64 leaves doubt, more digits, up to exact"),
    ("textbook", "(-b ± sqrt(b² - 4ac)) / 2a"),
    ("half-b", "half of b, and first the root that does not cancel"),
    ("kahan", "b² - ac with fused multiply-adds"),
    ("perpendicular", "discriminant from the perpendicular, centre to ray"),
    ("closest-point", "half a chord from the ray's point closest to the centre"),
    ("recentred", "the origin moved to that point first"),
    ("lagrange", "discriminant as r²a - |oc × d|²"),
];

/// What a formula does, in half a line; empty for one that came later.
pub(crate) fn in_words(formula: &str) -> &'static str {
    IN_WORDS.iter().find(|(name, _)| *name == formula).map_or("", |(_, words)| *words)
}

/// A method that came later, in grey.
const STRANGER: Marker = marker([0x44, 0x44, 0x44], 3, 270.0);

const fn marker([r, g, b]: [u8; 3], sides: usize, turned: f64) -> Marker {
    Marker { color: Color32::from_rgb(r, g, b), shape: Shape::Regular(sides, turned) }
}

/// The mark of a formula.
pub(crate) fn marker_of(formula: &str) -> Marker {
    MARKERS.iter().find(|(name, _)| *name == formula).map_or(STRANGER, |(_, marker)| *marker)
}

/// Draws the sign of methods that decided wrong: one ring around their marks, which stand beside each
/// other.
pub(crate) fn ring_around(chart: &mut Chart, centers: &[Point]) {
    const RING: f64 = 1.5 * RADIUS;
    const WIDTH: f64 = 1.5;
    let over = |i: usize| {
        let values = centers.iter().map(|center| center[i]);
        values.map(|x| [x, x]).reduce(|[low, high], [x, _]| [low.min(x), high.max(x)])
    };
    let (Some([left, right]), Some([top, bottom])) = (over(0), over(1)) else { return };
    if let [center] = centers {
        chart.ring(*center, RING, WRONG, WIDTH);
        return;
    }
    let corner = |(quarter, [x, y]): (usize, Point)| {
        (0..=6).map(move |k| {
            let (sin, cos) = (90.0 * quarter as f64 + 15.0 * f64::from(k)).to_radians().sin_cos();
            [x + RING * cos, y + RING * sin]
        })
    };
    let corners = [[right, bottom], [left, bottom], [left, top], [right, top]];
    let outline: Vec<Point> = corners.into_iter().enumerate().flat_map(corner).collect();
    chart.outline(&outline, WRONG, WIDTH);
}

impl Marker {
    /// Returns the colour on light or dark ground: what would be lost on dark is lightened.
    pub(crate) fn color_on(&self, dark: bool) -> Color32 {
        if !dark {
            return self.color;
        }
        if self.shape == Shape::Star {
            return Color32::WHITE;
        }
        let [r, g, b, _] = self.color.to_array();
        let luma: f64 =
            [0.299, 0.587, 0.114].iter().zip([r, g, b]).map(|(k, c)| k * f64::from(c)).sum();
        // How far to go to white, so that the darkest are as light as a mid grey at least.
        let part = ((130.0 - luma) / (255.0 - luma)).max(0.0);
        let [r, g, b] =
            [r, g, b].map(|c| (f64::from(c) + part * (255.0 - f64::from(c))).round() as u8);
        Color32::from_rgb(r, g, b)
    }

    /// Draws the mark.
    pub(crate) fn draw(&self, chart: &mut Chart, center: Point, digits: Digits) {
        let corners = self.corners(center, 1.0);
        if digits == Digits::Single {
            chart.fill(&corners, Color32::WHITE);
            chart.outline(&corners, self.color, 2.0);
            return;
        }
        chart.fill(&corners, self.color);
        // A line of white keeps a filled mark apart from what lies under it.
        chart.outline(&corners, Color32::WHITE, 1.0);
        if digits == Digits::DoubleDouble {
            chart.outline(&self.corners(center, 1.55), self.color, 1.5);
        }
    }

    /// The corners around a center. Triangles and stars are drawn larger, to look as large.
    fn corners(&self, [x, y]: Point, scale: f64) -> Vec<Point> {
        let corner = |degrees: f64, radius: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [x + scale * radius * sin, y - scale * radius * cos]
        };
        match self.shape {
            Shape::Star => {
                (0..10_usize).map(|k| corner(36.0 * k as f64, [1.6, 0.7][k % 2] * RADIUS)).collect()
            }
            Shape::Regular(sides, turned) => {
                let size = [1.35, 1.15, 1.1, 1.0][sides.clamp(3, 6) - 3] * RADIUS;
                (0..sides).map(|k| corner(turned + 360.0 * k as f64 / sides as f64, size)).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_methods_look_alike() {
        for (index, (name, marker)) in MARKERS.iter().enumerate() {
            for (other, later) in &MARKERS[index + 1..] {
                assert_ne!(marker.color, later.color, "{name} and {other}");
                assert_ne!(marker.shape, later.shape, "{name} and {other}");
            }
            assert_ne!(*marker, STRANGER, "{name}");
        }
    }
}
