//! How a method is told from the others: a shape and a colour each, hollow in single precision,
//! filled in double.

use super::figure::{Figure, Ink, Place, Shape};

/// Wrong decisions, wherever they are shown.
pub(crate) const WRONG: Ink = [0xb0, 0x00, 0x20];

/// The mark of a method, in any precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Marker {
    pub(crate) color: Ink,
    outline: Outline,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Outline {
    /// So many equal sides, the first corner so many degrees from straight up.
    Regular(usize, f64),
    Star,
}

/// Colours after Okabe and Ito, "Color Universal Design" (2008), which readers who do not see red
/// or green can tell apart; yellow, too light for white paper, is wine instead (Tol 2021).
const MARKERS: [(&str, Marker); 9] = [
    ("ladder", Marker { color: [0x00, 0x00, 0x00], outline: Outline::Star }),
    ("double-double", marker([0x77, 0x77, 0x77], 6, 0.0)),
    ("textbook", marker([0xd5, 0x5e, 0x00], 24, 0.0)),
    ("half-b", marker([0xe6, 0x9f, 0x00], 4, 45.0)),
    ("kahan", marker([0x00, 0x9e, 0x73], 3, 0.0)),
    ("perpendicular", marker([0x00, 0x72, 0xb2], 4, 0.0)),
    ("closest-point", marker([0x56, 0xb4, 0xe9], 3, 180.0)),
    ("recentred", marker([0xcc, 0x79, 0xa7], 5, 0.0)),
    ("lagrange", marker([0x88, 0x22, 0x55], 3, 90.0)),
];

/// A method that came later, in grey.
const STRANGER: Marker = marker([0x44, 0x44, 0x44], 3, 270.0);

const fn marker(color: Ink, sides: usize, turned: f64) -> Marker {
    Marker { color, outline: Outline::Regular(sides, turned) }
}

/// The mark of a method, by its name without the precision.
pub(crate) fn of(family: &str) -> Marker {
    MARKERS.iter().find(|(name, _)| *name == family).map_or(STRANGER, |(_, marker)| *marker)
}

/// Half the width of a mark, in points.
const RADIUS: f64 = 7.0;

impl Marker {
    /// Its colour on light or dark ground: what would be lost on dark is lightened.
    pub(crate) fn ink_on(&self, dark: bool) -> Ink {
        if !dark {
            return self.color;
        }
        let luma = [0.299, 0.587, 0.114].iter().zip(self.color).map(|(k, c)| k * f64::from(c));
        // How far to go to white, so that the darkest are as light as a mid grey at least.
        let luma: f64 = luma.sum();
        let part = ((130.0 - luma) / (255.0 - luma)).max(0.0);
        if self.outline == Outline::Star {
            return [0xff; 3];
        }
        self.color.map(|c| (f64::from(c) + part * (255.0 - f64::from(c))).round() as u8)
    }

    /// Draws the mark.
    pub(crate) fn draw(&self, figure: &mut Figure, center: Place, hollow: bool) {
        let points = self.corners(center);
        // A line of white keeps a filled mark apart from what lies under it.
        let (fill, stroke) = if hollow {
            (None, Some((self.color, 2.5)))
        } else {
            (Some(self.color), Some(([0xff; 3], 1.0)))
        };
        figure.shapes.push(Shape::Polygon { points, fill, stroke });
    }

    /// The corners around a center. Triangles and stars are drawn larger, to look as large.
    fn corners(&self, [x, y]: Place) -> Vec<Place> {
        let corner = |degrees: f64, radius: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [x + radius * sin, y - radius * cos]
        };
        match self.outline {
            Outline::Star => (0..10)
                .map(|k| corner(36.0 * f64::from(k), [1.6, 0.7][k as usize % 2] * RADIUS))
                .collect(),
            Outline::Regular(sides, turned) => {
                let size = [1.35, 1.15, 1.1, 1.0][sides.clamp(3, 6) - 3] * RADIUS;
                (0..sides).map(|k| corner(turned + 360.0 * k as f64 / sides as f64, size)).collect()
            }
        }
    }
}

/// The mark of a method that decided wrong: a ring around its own.
pub(crate) fn ring(figure: &mut Figure, center: Place) {
    figure.shapes.push(Shape::Ring { center, radius: 1.65 * RADIUS, color: WRONG, width: 2.5 });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_methods_look_alike() {
        for (index, (name, marker)) in MARKERS.iter().enumerate() {
            for (other, later) in &MARKERS[index + 1..] {
                assert_ne!(marker.color, later.color, "{name} and {other}");
                assert_ne!(marker.outline, later.outline, "{name} and {other}");
            }
            assert_ne!(*marker, STRANGER, "{name}");
        }
    }
}
