//! Draws the highlighted parts of the figure as the camera sees them. Seen from there, w points at the observer, and
//! all that lies on a ray is a single point.

use pinhole_core::{DVec2, DVec3, Object, Outputs, Pixel, Raster, Scene, Sphere, trace};

use crate::observer::Place;
use crate::overlay::{
    CameraSketch, CameraView, DrawnPart, Emphasis, Figure, Form, Highlighted, LabelFont, LineStyle,
    POINT, Screen, Shape, When, cased, dim, dot, first, position_of, silhouette,
};
use crate::{Concept, Item, Observer, OverlayItems};

/// Length at which a unit vector in the image plane is drawn, as a fraction of the picture's shorter side.
const ARROW: f64 = 0.3;

/// Maximum length in the picture, in screen pixels, of an arrow along the line of sight.
const END_ON: f64 = 1e-3;

/// Distance between two strokes of a plane's hatching, in points.
const HATCH: f64 = 20.0;
/// Distance between the positions along a stroke at which it is tested whether the plane is visible, in points.
const CELL: f64 = 3.0;

/// The direction from a point to its label.
const BELOW: DVec2 = DVec2::new(0.6, 1.0);

impl CameraSketch<'_> {
    /// Draws the highlighted parts on top of everything already drawn. Does nothing if the camera cannot see them.
    pub(super) fn highlight(&mut self, highlighted: Highlighted, scene: &Scene) {
        if let Concept::Object(index) = highlighted.concept
            && let Some(Object::Plane(_)) = scene.object(index)
        {
            if highlighted.dims {
                self.highlight_plane(scene, index);
            }
            return;
        }
        let view = self.view;
        let mut parts = Figure {
            resolved: Some(view.resolved),
            inspection: view.inspection.clone(),
            highlighted: Some(highlighted),
            is_flat: true,
            style: view.style,
            ..Figure::new(highlighted.camera, Observer::new(view.resolved.eye(), 0.0, 0.0, 1.0))
        }
        .parts(scene, &[]);
        parts.sort_by_key(|drawn| drawn.emphasis != Emphasis::Strong);
        let mut lit = CameraSketch::new(view, OverlayItems::ALL);
        parts.iter().for_each(|drawn| lit.lit_part(drawn));
        if !lit.drawing.marks.is_empty() {
            dim(&mut self.drawing, &mut self.requests, highlighted, self.colors);
        }
        self.drawing.marks.append(&mut lit.drawing.marks);
        self.requests = first(lit.requests, std::mem::take(&mut self.requests));
    }

    fn lit_part(&mut self, DrawnPart { part, emphasis, .. }: &DrawnPart) {
        let accompanies = *emphasis == Emphasis::Accompanying;
        let pen = part.pen;
        let (text, font) = part.label.as_ref().map_or(("", POINT), |l| (&*l.text, l.font));
        match (part.form, &part.places[..]) {
            (Form::Arrow(_), [from, to]) => {
                let Some(ends) = self.ends(from, to) else { return };
                let is_end_on = ends[0].distance(ends[1]) <= END_ON;
                let vector = to.at + to.along - from.at - from.along;
                if !is_end_on {
                    self.arrow(ends, pen, (text, font));
                } else if vector != DVec3::ZERO && !(accompanies && part.when == When::Lit) {
                    let is_away = vector.dot(self.view.resolved.basis().w) < 0.0;
                    self.end_on(is_away, ends[1], pen, (text, font));
                }
            }
            (Form::Line, [from, .., to]) => match self.ends(from, to) {
                Some([start, end]) if start.distance(end) > 1.0 => self.line(&[start, end], pen),
                Some([_, at])
                    if at.distance(0.5 * self.view.extent()) < 1.0 && !text.is_empty() =>
                {
                    self.end_on(true, at, pen, (text, font));
                }
                Some([_, at]) if !text.is_empty() => self.point(at, pen, (text, font)),
                _ => {}
            },
            (Form::Sides, corners) => {
                let inset = DVec2::splat(0.4 * f64::from(pen.width * self.view.scale));
                let most = self.view.extent() - inset;
                let spots = corners.iter().chain(corners.first()).map(|place| self.spot(place));
                let spots = spots.map(|spot| Some(spot?.max(inset).min(most)));
                if let Some(spots) = spots.collect::<Option<Vec<_>>>() {
                    self.line(&spots, pen);
                }
            }
            (Form::Point(_), [at]) if at.at == self.view.resolved.eye() => {
                // All rays begin at the eye, which is straight behind the middle of the picture.
                let text = format!("{text}: straight behind this point");
                self.end_on(false, 0.5 * self.view.extent(), pen, (&text, font));
            }
            (Form::Point(_), [at]) => {
                if let Some(spot) = self.spot(at) {
                    self.point(spot, pen, (text, font));
                }
            }
            (Form::Outline(sphere), _) => self.outline(&sphere, pen),
            _ => {}
        }
    }

    /// Returns where a place is in the picture; `None` if it is not in front of the camera. An arrow from the eye starts
    /// in the middle of the picture.
    fn spot(&self, place: &Place) -> Option<DVec2> {
        let (resolved, size) = (&self.view.resolved, self.view.size);
        let basis = resolved.basis();
        let along = place.along.clamp_length_max(1.0);
        let in_image = DVec2::new(basis.u.dot(along), -basis.v.dot(along));
        let from = if place.at == resolved.eye() {
            0.5 * self.view.extent()
        } else {
            let seen = resolved.project(place.at);
            (seen.depth > 0.0).then(|| position_of(resolved, size, seen.uv))?
        };
        Some(from + ARROW * self.view.extent().min_element() * in_image)
    }

    /// Returns the ends of a line in the picture. A line from the eye is a single point.
    fn ends(&self, from: &Place, to: &Place) -> Option<[DVec2; 2]> {
        let end = self.spot(to)?;
        let eye = Place::from(self.view.resolved.eye());
        let is_ray = *from == eye && to.along == DVec3::ZERO;
        Some([if is_ray { end } else { self.spot(from)? }, end])
    }

    pub(super) fn arrow(&mut self, ends: [DVec2; 2], pen: LineStyle, label: (&str, LabelFont)) {
        let [start, tip] = ends;
        let along = tip - start;
        let direction = along.normalize_or_zero();
        let head = f64::from(self.view.scale * (4.0 + 2.6 * pen.width)).min(0.8 * along.length());
        let (back, side) = (tip - head * direction, 0.42 * head * direction.perp());
        self.line(&[start, tip - 0.7 * head * direction], pen);
        self.add(pen, Shape::polygon(&[tip, back + side, back - side]));
        if !label.0.is_empty() {
            self.label(pen, label.0, tip, direction, label.1);
        }
    }

    fn point(&mut self, at: DVec2, pen: LineStyle, label: (&str, LabelFont)) {
        self.add(pen, Shape::Disc { center: dot(at), radius: 6.0 * self.view.scale });
        self.label(pen, label.0, at, BELOW, label.1);
    }

    /// Draws the symbol of a vector along the line of sight: a ring with a dot if the vector points towards the
    /// observer, or with a cross if it points away. Another symbol in the same place has precedence.
    fn end_on(&mut self, away: bool, at: DVec2, pen: LineStyle, label: (&str, LabelFont)) {
        let scale = f64::from(self.view.scale);
        let ring = LineStyle { width: 2.4, ..pen };
        let radius = 9.0 * scale;
        let shape = Shape::ring(at, radius, 32, ring.width * self.view.scale);
        if self.drawing.marks.iter().any(|mark| mark.shape == shape) {
            return;
        }
        self.add(ring, shape);
        if away {
            let arm = radius * std::f64::consts::FRAC_1_SQRT_2 * DVec2::ONE;
            self.line(&[at - arm, at + arm], ring);
            self.line(&[at - arm.perp(), at + arm.perp()], ring);
        } else {
            self.add(ring, Shape::Disc { center: dot(at), radius: (3.6 * scale) as f32 });
        }
        self.label(pen, label.0, at, BELOW, label.1);
    }

    fn outline(&mut self, sphere: &Sphere, pen: LineStyle) {
        let CameraView { resolved, scale, .. } = self.view;
        let unit = (sphere.center - resolved.eye()).length();
        let screen = Screen::of_size(resolved, self.view.extent(), unit, *scale);
        let outline = silhouette(sphere, resolved.eye()).unwrap_or_default();
        for pen in cased(pen, self.colors.background) {
            for cut in outline.windows(2).filter_map(|pair| screen.line(pair[0], pair[1])) {
                self.line(&[cut.from.at, cut.to.at], pen);
            }
        }
    }

    /// Hatches the pixels that show a plane. The hatching is drawn below all other marks: the plane may
    /// fill the picture, and the marks on it must stay visible and respond to the pointer.
    fn highlight_plane(&mut self, scene: &Scene, index: u32) {
        let pen = LineStyle::new(Item::Ray, self.colors.hit, 1.5);
        let (resolved, extent) = (&self.view.resolved, self.view.extent());
        let (scale, per_pixel) = (f64::from(self.view.scale), self.view.dots_per_pixel());
        // The objects are traced only at the resolution that the hatching needs.
        let [columns, rows] = (extent / (CELL * scale)).to_array().map(|cells| cells.ceil() as u32);
        let raster = Raster::shown_on(resolved.image(), columns, rows);
        let frame = trace(scene, resolved, &raster, Outputs { object: true, ..Outputs::NONE });
        let shows_plane = |at: DVec2| {
            let cell = at / per_pixel;
            // The cast saturates, so positions left of or above the picture give index 0.
            let pixel = Pixel { row: cell.y as u32, column: cell.x as u32 };
            let offset = raster.nearest_to(pixel);
            offset.and_then(|offset| frame.object.get(offset)) == Some(&index)
        };
        let strokes = hatch(extent, HATCH * scale, CELL * scale, shows_plane);
        let mut hatching = CameraSketch::new(self.view, OverlayItems::ALL);
        for pen in cased(pen, self.colors.background.gamma_multiply(0.6)) {
            strokes.iter().for_each(|stroke| hatching.line(stroke, pen));
        }
        self.drawing.marks.splice(..0, hatching.drawing.marks);
    }
}

/// Returns the strokes of a hatching, `apart` from each other and rising to the right. They cover the
/// positions for which `inside` returns true, which is tested at intervals of `step`.
fn hatch(extent: DVec2, apart: f64, step: f64, inside: impl Fn(DVec2) -> bool) -> Vec<[DVec2; 2]> {
    let mut strokes = Vec::new();
    let direction = DVec2::new(std::f64::consts::FRAC_1_SQRT_2, -std::f64::consts::FRAC_1_SQRT_2);
    let (reach, apart) = (extent.x + extent.y, apart * std::f64::consts::SQRT_2);
    for k in 1..(reach / apart).ceil() as u32 {
        // x + y is constant along a stroke, which starts at the left or at the lower edge.
        let sum = f64::from(k) * apart;
        let start = DVec2::new((sum - extent.y).max(0.0), sum.min(extent.y));
        let end = sum.min(extent.x) - start.x;
        let steps = (end / direction.x / step).floor() as u32;
        let mut open: Option<[DVec2; 2]> = None;
        for at in (0..=steps).map(|n| start + f64::from(n) * step * direction) {
            open = match (open, inside(at)) {
                (Some([from, _]), true) => Some([from, at]),
                (None, true) => Some([at, at]),
                (done, false) => {
                    strokes.extend(done);
                    None
                }
            };
        }
        strokes.extend(open);
    }
    strokes
}
