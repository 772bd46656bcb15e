//! The plane on the screen: converts points of the plane to positions, and draws strokes there.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};
use pinhole_core::DVec2;
use pinhole_lecture::lines::ImplicitLine;

use crate::model::lines::Window;

/// A part of the plane shown in a rectangle, y upwards, both axes with the same scale.
pub(crate) struct Canvas {
    pub(crate) painter: Painter,
    pub(crate) rect: Rect,
    window: Window,
    /// Points of the screen per unit of the plane.
    pub(crate) scale: f64,
    /// Colour around strokes.
    pub(crate) halo: Color32,
}

impl Canvas {
    pub(crate) fn new(painter: Painter, rect: Rect, window: Window, halo: Color32) -> Canvas {
        let scale = 0.5 * f64::from(rect.size().min_elem()) / window.half_extent;
        Canvas { painter, rect, window, scale, halo }
    }

    pub(crate) fn to_screen(&self, point: DVec2) -> Pos2 {
        let offset = self.scale * (point - self.window.center);
        // Positions far outside look alike, and f32 has a limited range.
        let offset = offset.clamp(DVec2::splat(-1e6), DVec2::splat(1e6));
        self.rect.center() + Vec2::new(offset.x as f32, -offset.y as f32)
    }

    pub(crate) fn to_plane(&self, position: Pos2) -> DVec2 {
        let offset = position - self.rect.center();
        self.window.center + DVec2::new(offset.x.into(), (-offset.y).into()) / self.scale
    }

    /// Returns the lower left and upper right corners of the visible part.
    pub(crate) fn bounds(&self) -> (DVec2, DVec2) {
        (self.to_plane(self.rect.left_bottom()), self.to_plane(self.rect.right_top()))
    }

    /// Returns the distance from the centre to a corner: no visible point is farther from the
    /// centre.
    pub(crate) fn reach(&self) -> f64 {
        0.5 * f64::from(self.rect.size().length()) / self.scale
    }

    pub(crate) fn center(&self) -> DVec2 {
        self.window.center
    }

    /// Draws a straight line between two points of the plane; `dash` is in points, 0 for a solid
    /// line.
    pub(crate) fn line(&self, from: DVec2, to: DVec2, stroke: Stroke, dash: f32) {
        let ends = [self.to_screen(from), self.to_screen(to)];
        if dash > 0.0 {
            self.painter.extend(Shape::dashed_line(&ends, stroke, dash, 0.8 * dash));
        } else {
            self.painter.line_segment(ends, stroke);
        }
    }

    /// Fills the visible part of the plane where the line's f is positive, or negative.
    pub(crate) fn half_plane(&self, line: &ImplicitLine, positive: bool, fill: Color32) {
        let (low, high) = self.bounds();
        let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let sign = if positive { 1.0 } else { -1.0 };
        let mut inside = Vec::new();
        for k in 0..4 {
            let ends = [corners[k], corners[(k + 1) % 4]];
            let [f, g] = ends.map(|corner| sign * line.f(corner));
            if f >= 0.0 {
                inside.push(self.to_screen(ends[0]));
            }
            if (f < 0.0) != (g < 0.0) {
                inside.push(self.to_screen(ends[0].lerp(ends[1], f / (f - g))));
            }
        }
        if inside.len() > 2 {
            self.painter.add(Shape::convex_polygon(inside, fill, Stroke::NONE));
        }
    }

    /// Draws an arrow between two points of the plane; its head is sized in points of the screen.
    pub(crate) fn arrow(&self, from: DVec2, to: DVec2, stroke: Stroke) {
        let [from, to] = [self.to_screen(from), self.to_screen(to)];
        let along = to - from;
        let size = (5.0 + 3.5 * stroke.width).min(0.8 * along.length());
        let direction = along.normalized();
        let side = 0.45 * size * direction.rot90();
        let back = to - size * direction;
        self.painter.line_segment([from, to - 0.7 * size * direction], stroke);
        let head = vec![to, back + side, back - side];
        self.painter.add(Shape::convex_polygon(head, stroke.color, Stroke::NONE));
    }
}

/// Returns the least number of the form 1, 2 or 5 times a power of ten that is not less than
/// `least`.
pub(crate) fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= least).unwrap_or(power)
}

#[cfg(test)]
mod tests {
    #[test]
    fn steps_are_round() {
        for (least, step) in [(0.7, 1.0), (1.1, 2.0), (3.0, 5.0), (5.1, 10.0), (0.013, 0.02)] {
            assert!((super::round_step(least) / step - 1.0).abs() < 1e-12);
        }
    }
}
