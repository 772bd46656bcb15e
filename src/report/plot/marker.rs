//! Marks that distinguish methods in the plots: each formula has a shape and a colour. A mark is hollow
//! for `f32`, filled for `f64`, and filled with a frame for double-double.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2};

use crate::report::model::Digits;

/// A shape and a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Marker {
    pub(crate) color: Color32,
    /// Number of sides of the regular polygon; 0 for a star.
    sides: usize,
    /// Direction of the polygon's first corner from its centre: the angle from straight up, in degrees.
    turned: f32,
}

/// Half the width of a mark, in points.
const RADIUS: f32 = 6.0;

/// The colour of wrong decisions.
pub(crate) const WRONG: Color32 = Color32::from_rgb(0xb0, 0x00, 0x20);

/// The marker of each formula, and what it is in words. The colours are those of Okabe and Ito, "Color Universal Design" (2008),
/// which colour-blind readers can distinguish. Their yellow is too light for white paper and is
/// replaced by wine (Tol 2021).
const FORMULAS: [(&str, Marker, &str); 8] = [
    (
        "ladder",
        marker([0x00, 0x00, 0x00], 0, 0.0),
        "certified: where f64 leaves doubt, more digits, up to exact",
    ),
    ("textbook", marker([0xd5, 0x5e, 0x00], 24, 0.0), "(-b ± sqrt(b² - 4ac)) / 2a"),
    (
        "half-b",
        marker([0xe6, 0x9f, 0x00], 4, 45.0),
        "half of b, and first the root that does not cancel",
    ),
    ("kahan", marker([0x00, 0x9e, 0x73], 3, 0.0), "b² - ac with fused multiply-adds"),
    (
        "perpendicular",
        marker([0x00, 0x72, 0xb2], 4, 0.0),
        "discriminant from the perpendicular, centre to ray",
    ),
    (
        "closest-point",
        marker([0x56, 0xb4, 0xe9], 3, 180.0),
        "half a chord from the ray's point closest to the centre",
    ),
    ("recentred", marker([0xcc, 0x79, 0xa7], 5, 0.0), "the origin moved to that point first"),
    ("lagrange", marker([0x88, 0x22, 0x55], 3, 90.0), "discriminant as r²a - |oc × d|²"),
];

/// The grey marker of any formula that is not in [`FORMULAS`].
const STRANGER: Marker = marker([0x44, 0x44, 0x44], 3, 270.0);

const fn marker([r, g, b]: [u8; 3], sides: usize, turned: f32) -> Marker {
    Marker { color: Color32::from_rgb(r, g, b), sides, turned }
}

/// Returns the marker of a formula.
pub(crate) fn marker_of(formula: &str) -> Marker {
    FORMULAS.iter().find(|(name, ..)| *name == formula).map_or(STRANGER, |(_, marker, _)| *marker)
}

/// Returns a short description of a formula; empty if the formula is unknown.
pub(crate) fn in_words(formula: &str) -> &'static str {
    FORMULAS.iter().find(|(name, ..)| *name == formula).map_or("", |(.., words)| *words)
}

/// Draws the sign for wrong decisions: one ring around all these adjacent marks. Draws nothing if there
/// are none.
pub(crate) fn ring_around(painter: &Painter, centers: impl IntoIterator<Item = Pos2>) {
    const RING: f32 = 1.5 * RADIUS;
    let mut around = Rect::NOTHING;
    centers.into_iter().for_each(|center| around.extend_with(center));
    if around.is_finite() {
        let stroke = Stroke::new(1.5, WRONG);
        painter.rect_stroke(around.expand(RING), RING, stroke, StrokeKind::Middle);
    }
}

impl Marker {
    /// Draws the mark of a method with this precision.
    pub(crate) fn draw(&self, painter: &Painter, center: Pos2, digits: Digits) {
        let corners = self.corners(center, 1.0);
        let outlined = |corners: &[Pos2], width: f32, color| {
            painter.add(Shape::closed_line(corners.to_vec(), Stroke::new(width, color)));
        };
        if digits == Digits::Single {
            self.fill(painter, &corners, Color32::WHITE);
            outlined(&corners, 2.0, self.color);
            return;
        }
        self.fill(painter, &corners, self.color);
        // A white outline separates a filled mark from anything below it.
        outlined(&corners, 1.0, Color32::WHITE);
        if digits == Digits::DoubleDouble {
            outlined(&self.corners(center, 1.55), 1.5, self.color);
        }
    }

    /// Fills the outline. egui only fills convex shapes, so a star is drawn as five kites, each from a
    /// tip to the opposite notch.
    fn fill(&self, painter: &Painter, corners: &[Pos2], color: Color32) {
        let fill = |corners| painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
        if self.sides == 0 {
            for tip in (0..10).step_by(2) {
                fill([0, 1, 5, 9].map(|next| corners[(tip + next) % 10]).to_vec());
            }
        } else {
            fill(corners.to_vec());
        }
    }

    /// Returns the corners of the mark's outline. Triangles and stars are enlarged so that they look as
    /// large as the other shapes.
    fn corners(&self, center: Pos2, scale: f32) -> Vec<Pos2> {
        let corner = |degrees: f32, radius: f32| {
            center + scale * radius * Vec2::angled((degrees - 90.0).to_radians())
        };
        if self.sides == 0 {
            let tip_or_notch = |k: usize| corner(36.0 * k as f32, [1.6, 0.7][k % 2] * RADIUS);
            return (0..10).map(tip_or_notch).collect();
        }
        let size = [1.35, 1.15, 1.1, 1.0][self.sides.clamp(3, 6) - 3] * RADIUS;
        let angle = |k: usize| self.turned + 360.0 * k as f32 / self.sides as f32;
        (0..self.sides).map(|k| corner(angle(k), size)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_methods_look_alike() {
        for (index, (name, marker, _)) in FORMULAS.iter().enumerate() {
            for (other, later, _) in &FORMULAS[index + 1..] {
                assert_ne!(marker.color, later.color, "{name} and {other}");
                let is_same = (marker.sides, marker.turned) == (later.sides, later.turned);
                assert!(!is_same, "{name} and {other}");
            }
            assert_ne!(*marker, STRANGER, "{name}");
        }
    }
}
