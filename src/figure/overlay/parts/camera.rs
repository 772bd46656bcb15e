//! The parts of the edited camera: the eye, the arrows, the frustum, the viewport, and the marks that explain it as a
//! lecturer draws them on a whiteboard: the order of u, v, w and their right angles, the areas of both cross
//! products, view from the eye to at, and the viewport's measures.

use pinhole_core::{DVec2, DVec3, Orientation, ResolvedCamera};
use pinhole_lecture::numbers::{Rounding, written};
use pinhole_lecture::{BasisDerivation, Cross};

use super::{ASKED_SPHERES, Form, Length, Parts, Place, Toward, When};
use crate::overlay::{
    ACCOMPANYING, BUD, FINE, Head, LABEL_DIGITS, LineStyle, MEDIUM, POINT, THICK, THIN, VECTOR,
    equals, unit,
};
use crate::{Concept, Item, OverlayItems};

/// Length of the up arrow, as a multiple of the basis arrows' length.
pub const UP_LENGTH: f64 = 1.35;

/// Length of the view arrow, as a multiple of the basis arrows' length. It differs from the up arrow's, so that arrows
/// with the same direction do not hide each other.
const VIEW_LENGTH: f64 = 1.6;

/// Length of the arrows of the world's axes, as a multiple of the basis arrows' length.
const AXIS_LENGTH: f64 = 1.6;

/// Opacity of the sides of the frustum, up to the viewport.
const SOLID: f32 = 0.1;

/// Radius of the ring of arcs from u to v, v to w and w to u, and side of the squares that mark their right angles, as
/// multiples of the basis arrows' length.
const RING: f64 = 0.55;
const RIGHT_ANGLE: f64 = 0.17;

/// Where an arc from one vector to another passes, as shares of the angle between them. The arrowhead is on the last
/// piece.
const ARC: [f64; 10] = [0.1, 0.17, 0.24, 0.31, 0.38, 0.45, 0.52, 0.59, 0.66, 8.0 / 9.0];

/// Distance of a dimension line from the viewport's edge, as a fraction of the viewport's shorter side.
const BESIDE: f64 = 0.14;

/// The concepts, the names and the arrowheads of u, v and w.
pub(crate) const BASIS: [(Concept, &str, Head); 3] = [
    (Concept::U, "u", Head::Filled),
    (Concept::V, "v", Head::Open),
    (Concept::W, "w", Head::Double),
];

/// Returns true if arrows or the frustum show where the camera looks, so that it needs no body.
pub(crate) fn shows_where_it_looks(items: OverlayItems) -> bool {
    items.shows_any(&[Item::Basis, Item::ViewAndUp, Item::Frustum])
}

/// Returns the (u, v) of the viewport's corners, clockwise in the image, starting at the corner of pixel (0, 0).
pub(crate) fn corners(resolved: &ResolvedCamera) -> [DVec2; 4] {
    let half = 0.5 * DVec2::new(resolved.viewport().width, resolved.viewport().height);
    [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, y)| half * DVec2::new(x, y))
}

/// Returns the length at which a factor of a cross product is drawn, as a multiple of the basis arrows' length: its
/// own, but 1 if it is much shorter or longer than they are.
fn side_length(length: f64) -> f64 {
    if (0.4..=2.0).contains(&length) { length } else { 1.0 }
}

impl Parts<'_> {
    /// Adds the whole camera and its selected ray, from back to front.
    pub(super) fn camera(&mut self) {
        self.axes();
        if let Some(resolved) = self.figure.resolved.as_ref() {
            self.frustum(resolved);
            self.viewport(resolved);
            if let Some(inspection) = self.figure.inspection.as_deref() {
                self.selected(resolved, inspection);
            }
        }
        for (concept, item) in
            [(Concept::UpCrossW, Item::UpCrossW), (Concept::WCrossU, Item::WCrossU)]
        {
            self.cross_product(concept, item);
        }
        self.view();
        self.up();
        if let Some(resolved) = self.figure.resolved.as_ref() {
            self.basis(resolved);
            self.order_and_angles(resolved);
            self.measures(resolved);
            let pen = LineStyle::new(Item::PixelNumbers, self.colors.ink, 1.0);
            self.add(Form::PixelNumbers, &[], pen);
        }
        self.eye_and_at();
    }

    fn axes(&mut self) {
        let names = ["x", "y", "z"];
        for ((axis, name), color) in DVec3::AXES.into_iter().zip(names).zip(self.colors.axes) {
            let pen = LineStyle::new(Item::Axes, color, THIN);
            self.arrow_from(DVec3::ZERO, AXIS_LENGTH * axis, Head::Open, pen).named(name, POINT);
        }
    }

    /// Returns the t up to which the frustum's edges are drawn. It lies beyond every sphere of ordinary size and
    /// distance.
    fn reach(&self, resolved: &ResolvedCamera) -> f64 {
        const LEAST: f64 = 2.2;
        let (scene, distance) = (self.scene, resolved.viewport().distance);
        let limit = 8.0 * self.figure.observer.distance() / distance;
        let far_sides = scene.spheres().iter().take(ASKED_SPHERES).filter_map(|sphere| {
            let depth = resolved.project(sphere.center).depth;
            (sphere.radius < depth).then_some((depth + sphere.radius) / distance)
        });
        let planes = if scene.planes().is_empty() { 1.0 } else { 1.2 };
        far_sides.filter(|t| *t < limit).fold(LEAST, f64::max) * 1.1 * planes
    }

    /// Adds the edges of the frustum, which are rays from the eye through the viewport's corners. Each edge ends at the
    /// nearest plane or, without one, beyond the spheres.
    fn frustum(&mut self, resolved: &ResolvedCamera) {
        if !self.figure.shows(Item::Frustum) {
            return;
        }
        let ink = self.colors.ink;
        let near = LineStyle::new(Item::Frustum, ink, THIN);
        let far = LineStyle::new(Item::Frustum, ink.gamma_multiply(0.55), FINE).without_halo();
        let (scene, reach) = (self.scene, self.reach(resolved));
        let rays = corners(resolved).map(|uv| resolved.ray(uv));
        let ends = rays.map(|ray| {
            let planes = scene.planes().iter().take(64);
            let hits = planes.filter_map(|plane| plane.roots(&ray).first_positive());
            let wall = hits.fold(f64::INFINITY, f64::min);
            (ray.at(wall.min(reach)), wall <= reach)
        });
        let (eye, viewport) = (resolved.eye(), rays.map(|ray| ray.at(1.0)));
        let inside = viewport.iter().sum::<DVec3>() / 4.0;
        let fill = LineStyle { color: ink.gamma_multiply(SOLID), ..far };
        for k in 0..4 {
            let next = (k + 1) % 4;
            let corners = [eye, eye, viewport[next], viewport[k]].map(Place::from);
            self.add(Form::Face(inside), &corners, fill);
        }
        for (corner, (end, _)) in viewport.into_iter().zip(ends) {
            self.line([eye, corner], near);
            self.line([corner, end], far).endless();
        }
        if ends.iter().all(|(_, on_plane)| *on_plane) {
            self.sides(ends.map(|(end, _)| end), far).endless();
        }
    }

    /// Adds the viewport's outline with its marks, and the camera's body.
    fn viewport(&mut self, resolved: &ResolvedCamera) {
        let ink = self.colors.ink;
        if !shows_where_it_looks(self.figure.items) && self.figure.shows(Item::Viewport) {
            let pen = LineStyle::new(Item::Eye, ink, THIN).about(Concept::Eye);
            self.add(Form::Body, &[], pen).when(When::Unlit);
        }
        let pen = LineStyle::new(Item::Viewport, ink, MEDIUM).about(Concept::Viewport);
        let outline = corners(resolved).map(|uv| resolved.viewport_point(uv));
        self.sides(outline, pen.on_viewport());
        let pen = LineStyle::new(Item::Marks, self.colors.mark, THICK).on_viewport();
        self.add(Form::Marks, &[], pen);
    }

    /// Adds the parallelogram that the factors of a cross product span, with its area, which is the length of the
    /// product since the second factor has length 1. While it is highlighted, the product is drawn, too.
    fn cross_product(&mut self, concept: Concept, item: Item) {
        let figure = self.figure;
        let BasisDerivation::FromUp(from_up) = BasisDerivation::new(&figure.camera) else { return };
        let [u, v, w] = self.colors.basis;
        let up = self.colors.given;
        let (cross, [of_a, of_b, color], names) = match concept {
            Concept::UpCrossW => (from_up.up_cross_w, [up, w, u], ["up", "w", "up × w"]),
            _ => (from_up.w_cross_u, [w, u, v], ["w", "u", "w × u = v"]),
        };
        let Some(cross) = cross else { return };
        let side = if figure.is_flat { 1.0 } else { side_length(cross.first.length) };
        let (Some(a), Some(b)) = (unit(cross.first.vector), unit(cross.second.vector)) else {
            return;
        };
        let eye = figure.camera.eye;
        let (a, b) = (side * a, b);
        let place = |along: DVec3| Place { at: eye, along, length: Length::Arrow };
        let corners = [eye.into(), place(a), place(a + b), place(b)];
        let pen = LineStyle::new(item, color, 1.6).about(concept).on_top();
        let lit = figure.highlighted.filter(|lit| lit.concept == concept);
        let digits = lit.map_or(LABEL_DIGITS, |lit| lit.digits.min(LABEL_DIGITS));
        let text = area_of(&cross, digits, names);
        let part = self.add(Form::Area, &corners, pen).as_wide();
        let Some(text) = text else { return };
        part.labelled(text, POINT, Toward::along(a + b)).label_at(place(a + b));
        // As a factor, up has the length of the parallelogram's side. The others are arrows of the basis, if there is one.
        for (vector, name, color) in [(a, names[0], of_a), (b, names[1], of_b)] {
            let font = if name == "up" { POINT } else { VECTOR };
            if name == "up" || figure.resolved.is_none() {
                let pen = LineStyle { color, width: ACCOMPANYING + 1.0, ..pen };
                let part = self.arrow_from(eye, vector, Head::Filled, pen).as_wide();
                part.named(name, font).when(When::Lit).bud = 1.0;
            }
        }
        if let (Some(product), Some(sine)) = (unit(cross.product), cross.sine) {
            let tip = side * sine * product;
            self.arrow_from(eye, tip, Head::Filled, pen).named(names[2], VECTOR).when(When::Lit);
            // The fingers of the right hand turn this way if its thumb is along the product.
            if lit.is_some() && !figure.is_flat {
                let pen = LineStyle::new(item, self.colors.ink, 2.2).about(concept).on_top();
                self.arc(eye, [a / side, b], pen);
            }
        }
    }

    /// Adds the view vector: from the eye to at, with -view beside it; or else at the eye, like up.
    fn view(&mut self) {
        let (figure, camera) = (self.figure, &self.figure.camera);
        let eye = camera.eye;
        let Some(forward) = unit(camera.view()) else { return };
        let pen = LineStyle::new(Item::ViewVector, self.colors.given, 2.6).about(Concept::View);
        let back = LineStyle { width: 2.0, ..pen }.about(Concept::Backwards);
        if let (Orientation::At { at, .. }, true) =
            (camera.orientation, figure.shows(Item::ViewVector))
        {
            let middle: Place = eye.midpoint(at).into();
            let part = self.arrow([eye, at], Head::Filled, pen);
            part.labelled("view = at − eye", POINT, Toward::Screen(DVec2::Y)).label_at(middle);
            if figure.is_lit(Concept::View) {
                return;
            }
            let part = self.arrow([at, eye], Head::Filled, back);
            part.labelled("−view", POINT, Toward::Onward).label_at(middle).beside =
                Some(DVec3::ZERO);
            return;
        }
        let is_named = figure.names_all
            || [Concept::View, Concept::Backwards]
                .into_iter()
                .any(|concept| figure.is_lit(concept));
        let is_given = camera.orientation.has_up();
        let pen = LineStyle { item: Item::ViewAndUp, width: MEDIUM, ..pen };
        let part = self.arrow_from(eye, VIEW_LENGTH * forward, Head::Filled, pen);
        part.when(if is_given { When::Shown } else { When::Lit });
        if is_named {
            part.named("view", POINT);
        }
        if !is_given {
            return;
        }
        let part = self.arrow_from(eye, -VIEW_LENGTH * forward, Head::Filled, back);
        let is_whole = matches!(camera.orientation, Orientation::View { .. });
        part.named("−view", POINT).when(if is_whole { When::Shown } else { When::Lit });
    }

    /// Adds the up vector as the user gives it.
    fn up(&mut self) {
        let (figure, eye) = (self.figure, self.figure.camera.eye);
        let (Orientation::At { up, .. } | Orientation::View { up, .. }) = figure.camera.orientation
        else {
            return;
        };
        let Some(direction) = unit(up) else { return };
        let pen = LineStyle::new(Item::ViewAndUp, self.colors.given, MEDIUM).about(Concept::Up);
        if let (Some(resolved), true) = (&figure.resolved, figure.up.is_some()) {
            // As long as the tip stays here, the camera does not move.
            let [v, w] = [1.6 * resolved.basis().v, 1.2 * resolved.basis().w];
            let corners = [w, w + v, v - w, -w];
            let place = |along: DVec3| Place { at: eye, along, length: Length::Arrow };
            let plane = LineStyle { width: FINE, color: pen.color.gamma_multiply(0.5), ..pen };
            self.add(Form::Area, &corners.map(place), LineStyle { concept: None, ..plane });
        }
        match figure.up {
            Some(length) => self.arrow([eye, eye + length * direction], Head::Filled, pen),
            None => self.arrow_from(eye, UP_LENGTH * direction, Head::Filled, pen),
        }
        .named("up", POINT);
    }

    /// Returns the length at which the vector is drawn that becomes u or w when its length is made 1.
    fn length_before(&self, concept: Concept) -> f64 {
        if self.figure.highlighted.is_none_or(|lit| lit.growth == 1.0) {
            return BUD;
        }
        match (concept, BasisDerivation::new(&self.figure.camera)) {
            (Concept::U, BasisDerivation::FromUp(from_up)) => {
                let length = |cross: Cross| Some(side_length(cross.first.length) * cross.sine?);
                from_up.up_cross_w.and_then(length).unwrap_or(BUD)
            }
            (Concept::W, BasisDerivation::FromUp(_)) => VIEW_LENGTH,
            _ => BUD,
        }
    }

    fn basis(&mut self, resolved: &ResolvedCamera) {
        let (eye, basis, colors) = (resolved.eye(), resolved.basis(), self.colors);
        let inks = colors.basis.into_iter().zip(colors.patterns).zip(self.figure.items.of_basis());
        let vectors = [basis.u, basis.v, basis.w].into_iter().zip(BASIS);
        for ((vector, (concept, name, head)), ((color, pattern), item)) in vectors.zip(inks) {
            let pen = LineStyle::new(item, color, THICK).about(concept).patterned(pattern);
            // The label of the lit product names v.
            let is_named = concept != Concept::V || !self.figure.is_lit(Concept::WCrossU);
            let bud = self.length_before(concept);
            let part = self.arrow_from(eye, vector, head, pen);
            part.bud = bud;
            if is_named {
                part.named(name, VECTOR);
            }
        }
    }

    /// Adds an arc with an arrowhead from one vector to another, both of length 1.
    fn arc(&mut self, at: DVec3, [from, to]: [DVec3; 2], pen: LineStyle) {
        let Some(across) = unit(to - from.dot(to) * from) else { return };
        let [line @ .., last, tip] = ARC.map(|share| {
            let (sin, cos) = (share * from.angle_between(to)).sin_cos();
            Place { at, along: RING * (cos * from + sin * across), length: Length::Arrow }
        });
        self.add(Form::Line, &[&line[..], &[last]].concat(), pen).as_wide().bud = 1.0;
        self.arrow([last, tip], Head::Filled, pen).as_wide().bud = 1.0;
    }

    /// Adds the arcs from u to v, from v to w and from w to u, and the right angles between these vectors.
    fn order_and_angles(&mut self, resolved: &ResolvedCamera) {
        let (eye, basis, ink) = (resolved.eye(), resolved.basis(), self.colors.ink);
        let arc = LineStyle::new(Item::Ring, ink, 1.8).on_top().without_halo();
        let square = LineStyle::new(Item::RightAngles, ink, 1.4).on_top();
        let place = |along: DVec3| Place { at: eye, along, length: Length::Arrow };
        // While a vector is made, the right angles are those that make it.
        let lit = self.figure.highlighted.filter(|lit| !lit.is_of_step).map(|lit| lit.concept);
        let made = match lit.filter(|_| self.figure.camera.orientation.has_up()) {
            Some(Concept::U | Concept::UpCrossW) => Some(basis.u),
            Some(Concept::V | Concept::WCrossU) => Some(basis.v),
            Some(Concept::W) => Some(basis.w),
            _ => None,
        };
        for (from, to) in [(basis.u, basis.v), (basis.v, basis.w), (basis.w, basis.u)] {
            self.arc(eye, [from, to], arc);
            if made.is_none_or(|made| made == from || made == to) {
                let [a, b] = [from, to].map(|axis| RIGHT_ANGLE * axis);
                self.line([a, a + b, b].map(place), square);
            }
        }
    }

    /// Adds dimension lines of the viewport's width, height and distance.
    fn measures(&mut self, resolved: &ResolvedCamera) {
        let (viewport, ink) = (resolved.viewport(), self.colors.ink);
        let half = 0.5 * DVec2::new(viewport.width, viewport.height);
        let beside = BESIDE * viewport.width.min(viewport.height);
        let at = |uv: DVec2| resolved.viewport_point(uv);
        let pen = LineStyle::new(Item::Measures, ink, 1.6).on_top();
        let edges = [
            ("width", viewport.width, [(-1.0, -1.0), (1.0, -1.0)], DVec2::NEG_Y),
            ("height", viewport.height, [(1.0, -1.0), (1.0, 1.0)], DVec2::X),
        ];
        for (name, length, corners, out) in edges {
            let ends = corners.map(|(x, y)| half * DVec2::new(x, y));
            for corner in ends {
                let thin = LineStyle { width: 1.0, ..pen }.without_halo();
                self.line([at(corner), at(corner + 1.3 * beside * out)], thin);
            }
            let outward = Toward::along(at(2.0 * beside * out) - at(DVec2::ZERO));
            let text = format!("{name} {}", equals(length));
            let ends = ends.map(|corner| at(corner + beside * out));
            let label = at((half + DVec2::splat(2.2 * beside)) * out);
            self.dimension(ends, pen).labelled(text, POINT, outward).label_at(label);
        }
        let ends = [resolved.eye(), at(DVec2::ZERO)];
        let lit = self.figure.highlighted.filter(|lit| lit.concept == Concept::Distance);
        let equation = lit.map_or(equals(viewport.distance), |lit| lit.equated(viewport.distance));
        let text = format!("distance {equation}");
        let outward = Toward::along(-resolved.basis().v);
        let pen = pen.about(Concept::Distance);
        self.dimension(ends, pen).labelled(&*text, POINT, outward).when(When::Unlit);
        let toward = Toward::Screen(DVec2::Y);
        self.line(ends, pen).labelled(text, POINT, toward).when(When::Lit);
    }

    fn eye_and_at(&mut self) {
        let (camera, colors) = (&self.figure.camera, self.colors);
        if let Orientation::At { at, .. } = camera.orientation {
            let pen = LineStyle::new(Item::At, colors.given, 2.0).about(Concept::At);
            self.point(at, 4.5, pen).named_toward("at", 0.5, 1.0);
        }
        let pen = LineStyle::new(Item::Eye, colors.ink, 2.0).about(Concept::Eye);
        self.point(camera.eye, 6.0, pen).named_toward("eye", -0.6, 1.0);
    }
}

/// Returns the equation of a parallelogram's area; `None` if a factor is zero.
fn area_of(cross: &Cross, digits: usize, names: [&str; 3]) -> Option<String> {
    let angle = cross.angle?;
    let number = |x: f64| written(x, digits);
    let relation = |shown: &[f64]| Rounding::Significant(digits).relation(shown);
    let sine_of = format!("sin({}°)", number(angle.to_degrees()));
    let length = cross.first.length;
    let is = relation(&[cross.area]);
    let substituted = relation(&[length, angle.to_degrees(), cross.area]);
    let factor = match number(length) {
        one if one == number(1.0) => String::new(),
        other => format!("{other} · "),
    };
    let (of, area) = (format!("|{} × {}|", names[0], names[1]), number(cross.area));
    Some(format!("{of} {is} {area} {substituted} {factor}{sine_of}"))
}
