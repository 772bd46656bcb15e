//! Marks that explain the camera as a lecturer draws them on a whiteboard: the order of u, v, w and their
//! right angles, the areas of both cross products, view from the eye to at, the viewport's measures, and the
//! selected point's u and v.

use pinhole_core::{DVec2, DVec3, Orientation, ResolvedCamera};
use pinhole_lecture::Cross;

use crate::model::observer::{VIEW_LENGTH, side_length};
use crate::model::{Concept, Inspection, Item};
use crate::view::overlay::{
    Head, Highlighted, LABEL_DIGITS, LineStyle, NUMBER, POINT, Request, Sketch, corners, cross_of,
    equals, half_extent, numbers, unit,
};

/// Radius of the ring of arcs from u to v, v to w and w to u, and side of the squares that mark their right
/// angles, as fractions of the basis arrows' length.
const RING: f64 = 0.55;
const RIGHT_ANGLE: f64 = 0.17;

/// Angles at which the arcs of the ring pass, in degrees from the vector at which they begin. The arrowhead
/// is on the last piece.
const ARC: [f64; 7] = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 80.0];

/// Distance of a dimension line from the viewport's edge, as a fraction of the viewport's shorter side.
const BESIDE: f64 = 0.14;

/// Distance between the viewport and the numbers of its rows and columns, in points.
const NUMBER_GAP: f64 = 2.0;

/// Distance between the arrows of view and -view, and between a line and its dimension line, in points.
pub(crate) const APART: f64 = 14.0;

impl Sketch<'_> {
    /// Draws the areas of both cross products from which u and v come, except of the highlighted one, which
    /// is drawn with the highlight.
    pub(crate) fn areas(&mut self, arrow: f64) {
        let (camera, highlighted) = (self.view.camera, self.view.highlighted);
        for (concept, item) in
            [(Concept::UpCrossW, Item::UpCrossW), (Concept::WCrossU, Item::WCrossU)]
        {
            let shown = Highlighted { concept, camera, digits: LABEL_DIGITS, dims: false };
            let is_lit = highlighted.is_some_and(|lit| lit.concept == concept);
            let Some((cross, names, colors)) = cross_of(shown, self.colors).filter(|_| !is_lit)
            else {
                continue;
            };
            let pen = LineStyle::new(item, colors[2], 1.6).about(concept).on_top();
            self.cross_area((camera.eye, arrow), &cross, shown, pen, names);
        }
    }

    /// Draws the parallelogram that the factors of a cross product span, with its area, which is the length
    /// of the product since the second factor has length 1. `arrow` is the length at which a unit vector is
    /// drawn; a much shorter or longer first factor is drawn with that length, too. Returns both factors as
    /// they are drawn, and the product's length in such units.
    pub(crate) fn cross_area(
        &mut self,
        (eye, arrow): (DVec3, f64),
        cross: &Cross,
        highlighted: Highlighted,
        pen: LineStyle,
        names: [&str; 3],
    ) -> Option<([DVec3; 2], f64)> {
        let side = side_length(cross.first.length);
        let a = arrow * side * unit(cross.first.vector)?;
        let b = arrow * unit(cross.second.vector)?;
        let corners = [eye, eye + a, eye + a + b, eye + b];
        let fill = LineStyle { color: pen.color.gamma_multiply(0.3), ..pen }.without_halo();
        self.polygon(&corners, fill);
        self.sides(corners, LineStyle { width: 1.6, ..pen });
        let (angle, sine) = cross.angle.zip(cross.sine)?;
        let number = |x: f64| highlighted.number(x);
        let sine_of = format!("sin({}°)", number(angle.to_degrees()));
        let length = cross.first.length;
        let is = highlighted.relation(&[cross.area]);
        let substituted = highlighted.relation(&[length, angle.to_degrees(), cross.area]);
        let factor = match number(length) {
            one if one == number(1.0) => String::new(),
            other => format!("{other} · "),
        };
        let (of, area) = (format!("|{} × {}|", names[0], names[1]), number(cross.area));
        let text = format!("{of} {is} {area} {substituted} {factor}{sine_of}");
        let outward = self.on_screen(corners[2], a + b);
        self.label_at(corners[2], pen, &text, outward, POINT);
        Some(([a, b], side * sine))
    }

    /// Draws the arcs from u to v, from v to w and from w to u, and the right angles between these vectors.
    pub(crate) fn order_and_angles(&mut self, resolved: &ResolvedCamera, arrow: f64) {
        let (eye, basis) = (resolved.eye(), resolved.basis());
        let arc = LineStyle::new(Item::Ring, self.colors.ink, 1.8).on_top().without_halo();
        let square = LineStyle::new(Item::RightAngles, self.colors.ink, 1.4).on_top();
        for (from, to) in [(basis.u, basis.v), (basis.v, basis.w), (basis.w, basis.u)] {
            let points = ARC.map(|angle| {
                let (sin, cos) = angle.to_radians().sin_cos();
                eye + RING * arrow * (cos * from + sin * to)
            });
            let [.., last, end] = points;
            points[..ARC.len() - 1].windows(2).for_each(|ends| self.line(ends[0], ends[1], arc));
            self.arrow([last, end], Head::Filled, arc);
            let [a, b] = [from, to].map(|axis| RIGHT_ANGLE * arrow * axis);
            self.line(eye + a, eye + a + b, square.without_halo());
            self.line(eye + a + b, eye + b, square.without_halo());
        }
    }

    /// Draws view from the eye to at, with -view beside it. A camera that is given by its view direction has
    /// no at: then -view is drawn at the eye, like view itself.
    pub(crate) fn view_vector(&mut self, arrow: f64) {
        let camera = self.view.camera;
        let (eye, view) = (camera.eye, camera.view());
        let pen = LineStyle::new(Item::ViewVector, self.colors.given, 2.6).about(Concept::View);
        let back = LineStyle { width: 2.0, ..pen }.about(Concept::Backwards);
        let Some(forward) = unit(view) else { return };
        match camera.orientation {
            Orientation::At { at, .. } => {
                self.arrow([eye, at], Head::Filled, pen);
                self.label_middle([eye, at], pen, "view = at − eye");
                let middle = eye.midpoint(at);
                let sight = middle - self.view.frame.camera().eye();
                let Some(beside) = unit(forward.cross(sight)) else { return };
                let apart = self.screen.length_of_points(middle, (APART, APART)) * beside;
                self.arrow([at + apart, eye + apart], Head::Filled, back);
                let middle = middle + apart;
                self.label_at(middle, back, "−view", self.on_screen(middle, beside), POINT);
            }
            Orientation::View { .. } => {
                let tip = eye - arrow * VIEW_LENGTH * forward;
                self.named_arrow([eye, tip], Head::Filled, back, "−view", POINT);
            }
            Orientation::Basis(_) => {}
        }
    }

    /// Draws dimension lines of the viewport's width, height and distance.
    pub(crate) fn measures(&mut self, resolved: &ResolvedCamera) {
        let viewport = resolved.viewport();
        let half = 0.5 * DVec2::new(viewport.width, viewport.height);
        let beside = beside(resolved);
        let at = |u: f64, v: f64| resolved.viewport_point(DVec2::new(u, v));
        let pen = LineStyle::new(Item::Measures, self.colors.ink, 1.6).on_top();
        let edges = [
            ("width", viewport.width, [(-1.0, -1.0), (1.0, -1.0)], DVec2::NEG_Y),
            ("height", viewport.height, [(1.0, -1.0), (1.0, 1.0)], DVec2::X),
        ];
        for (name, length, corners, out) in edges {
            let [from, to] = corners.map(|(x, y)| half * DVec2::new(x, y));
            for corner in [from, to] {
                let far = corner + 1.3 * beside * out;
                let thin = LineStyle { width: 1.0, ..pen }.without_halo();
                self.line(at(corner.x, corner.y), at(far.x, far.y), thin);
            }
            let [from, to] = [from, to].map(|corner| corner + beside * out);
            let [from, to, outer] = [from, to, 2.0 * beside * out].map(|p| at(p.x, p.y));
            let outward = outer - at(0.0, 0.0);
            self.dimension([from, to], pen, &format!("{name} {}", equals(length)), outward);
        }
        let text = format!("distance {}", equals(viewport.distance));
        let ends = [resolved.eye(), at(0.0, 0.0)];
        let pen = pen.about(Concept::Distance);
        self.dimension(ends, pen, &text, -resolved.basis().v);
    }

    /// Writes the numbers of columns above the viewport and those of rows to its left, and W and H at the
    /// opposite sides.
    pub(crate) fn pixel_numbers(&mut self, resolved: &ResolvedCamera) {
        if !self.items.shows(Item::Labels) || !self.items.shows(Item::PixelNumbers) {
            return;
        }
        let (image, viewport, scale) = (resolved.image(), resolved.viewport(), self.screen.scale);
        let half = 0.5 * DVec2::new(viewport.width, viewport.height);
        let pen = LineStyle::new(Item::PixelNumbers, self.colors.ink, 1.0);
        let at = |uv: DVec2| resolved.viewport_point(uv);
        let sides = [(DVec2::Y, "W", image.width()), (DVec2::NEG_X, "H", image.height())];
        for (out, name, count) in sides {
            let outward = at(out) - at(DVec2::ZERO);
            let beside = |k: u32, text: &str| {
                let along = DVec2::new(resolved.u_of_column(k), resolved.v_of_row(k));
                let edge = at((DVec2::ONE - out.abs()) * along + out * half);
                let room = half_extent(text, scale) + NUMBER_GAP * scale;
                let direction = self.on_screen(edge, outward);
                Some(self.screen.spot(edge)?.at + direction * direction.abs().dot(room))
            };
            let placed = numbers(count, self.view.first_number, scale, beside);
            let fixed = |(text, at)| Request::fixed(pen, text, at, NUMBER, self.colors.halo);
            self.requests.extend(placed.into_iter().map(fixed).collect::<Vec<_>>());
            let middle = at(-out * half);
            let outward = self.on_screen(middle, -outward);
            self.label_at(middle, pen, &format!("{name} = {count}"), outward, POINT);
        }
    }

    /// Draws a line with an arrowhead at each end, and a label at its middle.
    pub(crate) fn dimension(&mut self, ends: [DVec3; 2], pen: LineStyle, text: &str, out: DVec3) {
        let middle = ends[0].midpoint(ends[1]);
        for end in ends {
            self.arrow([middle, end], Head::Filled, pen);
        }
        self.label_at(middle, pen, text, self.on_screen(middle, out), POINT);
    }

    /// Draws the selected point's u and v on the viewport, as two legs from its middle to the point.
    pub(crate) fn uv_legs(&mut self, resolved: &ResolvedCamera, inspection: &Inspection) {
        let at = |uv: DVec2| resolved.viewport_point(uv);
        for UvLeg { text, axis, ends, outward } in uv_legs(inspection.uv) {
            let pen = LineStyle::new(Item::UvLegs, self.colors.basis[axis], 3.2).on_top();
            let [from, to] = ends.map(at);
            self.line(from, to, pen);
            let middle = from.midpoint(to);
            let outward = self.on_screen(middle, at(outward) - at(DVec2::ZERO));
            self.label_at(middle, pen, &text, outward, POINT);
        }
    }
}

/// Returns the distance of a dimension line from the viewport's edge.
fn beside(resolved: &ResolvedCamera) -> f64 {
    BESIDE * resolved.viewport().width.min(resolved.viewport().height)
}

/// Returns the outer corners of the viewport with the dimension lines below it and to its right.
pub(crate) fn measured_points(resolved: &ResolvedCamera) -> [DVec3; 3] {
    let outer = corners(resolved)[1].abs() + 2.0 * beside(resolved);
    let corners = [outer, outer * DVec2::new(1.0, -1.0), -outer];
    corners.map(|corner| resolved.viewport_point(corner))
}

/// One of the two legs that lead from the middle of the viewport to the selected point.
#[derive(Clone, Debug)]
pub(crate) struct UvLeg {
    /// The label, such as `u = 0.2`.
    pub(crate) text: String,
    /// Index of the leg's axis: 0 for u, 1 for v.
    pub(crate) axis: usize,
    /// Both ends, as (u, v).
    pub(crate) ends: [DVec2; 2],
    /// The direction from the leg to its label.
    pub(crate) outward: DVec2,
}

/// Returns the legs of a point: along u first, then along v.
pub(crate) fn uv_legs(uv: DVec2) -> [UvLeg; 2] {
    let corner = DVec2::new(uv.x, 0.0);
    let side = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
    let leg = |axis: usize, ends, outward| {
        let text = format!("{} {}", ["u", "v"][axis], equals(uv[axis]));
        UvLeg { text, axis, ends, outward }
    };
    [
        leg(0, [DVec2::ZERO, corner], -side(uv.y) * DVec2::Y),
        leg(1, [corner, uv], side(uv.x) * DVec2::X),
    ]
}
