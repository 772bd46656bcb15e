//! How one row of points in a panel is told from the others: a shape and a colour each.

use super::figure::{Figure, Ink, Place, Shape};

/// A shape and a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Marker {
    pub(crate) color: Ink,
    pub(crate) outline: Outline,
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outline {
    /// So many equal sides, the first corner so many degrees from straight up.
    Regular(usize, f64),
    Star,
}

/// A mark of so many equal sides, turned by so many degrees.
pub(crate) const fn marker(color: Ink, sides: usize, turned: f64) -> Marker {
    Marker { color, outline: Outline::Regular(sides, turned) }
}

/// Half the width of a mark, in points.
pub(crate) const RADIUS: f64 = 7.0;

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
