//! The plot of f(p + t d) against t, where f(x) = 0 is an object's surface and p + t d the selected ray. It
//! is below both views, and has a curve for each object on a common t axis, and a point that the user moves
//! along the ray. On its right there is a text for each curve.

use egui::{
    Align2, Id, Label, Painter, Pos2, Rect, RichText, ScrollArea, Sense, Slider, Stroke, Ui, Vec2,
    pos2, vec2,
};
use pinhole_core::Root;
use pinhole_figure::chart::{self, GridInk, SOLID, Scale};
use pinhole_figure::overlay::Colors;
use pinhole_figure::typesetting::labels::{Font, LabelLayout, around};
use pinhole_figure::typesetting::notation::{self, formula};
use pinhole_figure::typesetting::theme;
use pinhole_figure::{Concept, HoverSource, Inspection};
use pinhole_lecture::numbers::{equated, equated_tuple, grouped, written as number};

use crate::features::plot::curves::{Curve, Plot};
use crate::ui::PageContext;
use crate::ui::scene::views;
use crate::ui::widgets::{NumberField, ResponseExt as _, arrows, inside, is_about, keep_arrows};

/// Size of the text, in points; it is legible from the back row of a classroom.
const TEXT: f32 = 15.5;
/// Maximum width of the text to the right of the plot, in points and as a fraction of the total width.
const WORDS: (f32, f32) = (430.0, 0.44);
/// Minimum width of the slider of t, in points.
const SLIDER: f32 = 72.0;

/// Shows only the graph, as on a lesson's stage.
pub(crate) fn graph(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    draw(ui, area.shrink(2.0), context);
}

/// Shows the plot, and the text on its right or, in a narrow area, below it.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let area = ui.available_rect_before_wrap();
    let (graph, words) = chart::beside(area, WORDS);
    draw(ui, graph.with_max_y(graph.bottom() - 4.0), context);
    inside(ui, words, |ui| {
        let scrolled = ScrollArea::vertical().id_salt("plot words scrolled").auto_shrink(false);
        scrolled.show(ui, |ui| self::words(ui, context));
    });
}

/// Shows the point that the user moves along the ray, and a text for each curve.
fn words(ui: &mut Ui, PageContext { session, derived, .. }: &mut PageContext<'_>) {
    let (Some(plot), Some(inspection)) = (&derived.plot, &derived.inspection) else { return };
    let (first, digits) = (inspection.first_hit(), session.shown.setup.digits);
    walk(ui, &mut session.shown.ray_point_t, plot, first.map_or(1.0, |hit| hit.t));
    if let Some(t) = plot.ray_point_t {
        text(ui, &point(inspection, t, digits));
        ui.label(RichText::new(objects_at_point(plot)).strong());
    }
    ui.separator();
    for curve in &plot.curves {
        curve_text(ui, plot, curve, first, digits);
    }
    match plot.left_out {
        0 if plot.curves.is_empty() => drop(ui.label("There is no object.")),
        0 => {}
        1 => drop(ui.label("1 more object is left out")),
        n => drop(ui.label(format!("{} more objects are left out", grouped(n as u64)))),
    }
}

fn text(ui: &mut Ui, text: &str) {
    notation::label(ui, text, TEXT, ui.visuals().text_color());
}

/// Shows the t of the point that the user moves along the ray, as a number and as a slider.
fn walk(ui: &mut Ui, ray_point_t: &mut Option<f64>, plot: &Plot, first_hit: f64) {
    ui.horizontal(|ui| {
        let mut walks = ray_point_t.is_some();
        if ui.checkbox(&mut walks, "Walk along the ray").changed() {
            *ray_point_t = walks.then_some(0.5 * first_hit);
        }
        let Some(t) = ray_point_t else { return };
        text(ui, "t =");
        NumberField { range: -1e9..=1e9, ..NumberField::new("walked t", t) }.show(ui);
        // If there is no space for a slider, the user can still drag the line in the plot.
        if ui.available_width() < SLIDER {
            return;
        }
        ui.spacing_mut().slider_width = ui.available_width() - 12.0;
        let slider = Slider::new(t, plot.range.clone()).show_value(false);
        ui.add(slider.clamping(egui::SliderClamping::Never)).named("walk to t");
    });
}

/// Returns the coordinates of the ray's point at t, as a formula.
fn point(inspection: &Inspection, t: f64, digits: usize) -> String {
    format!("p + t d {}", equated_tuple(&inspection.ray.at(t).to_array(), digits))
}

/// Returns a text that names the objects that contain the point marked on the ray, and those on whose surface it
/// is.
fn objects_at_point(plot: &Plot) -> String {
    let titles = |belongs: fn(&&Curve) -> bool| {
        let curves = plot.curves.iter().filter(belongs);
        curves.map(|curve| curve.named.title.as_str()).collect::<Vec<_>>().join(", ")
    };
    let inside = titles(|curve| curve.is_inside(curve.at_point));
    let on = titles(|curve| curve.at_point == 0.0);
    let said = [("inside", inside), ("on", on)].into_iter().filter(|(_, all)| !all.is_empty());
    let said: Vec<String> = said.map(|(how, all)| format!("{how} {all}")).collect();
    if said.is_empty() { "outside all objects".to_owned() } else { said.join("; ") }
}

/// Shows the text about a curve: a sample of its line, its title and description, and the value of f at the
/// point on the ray.
fn curve_text(ui: &mut Ui, plot: &Plot, curve: &Curve, first: Option<&Root>, digits: usize) {
    let object = curve.named.object;
    let title = ui.horizontal_wrapped(|ui| {
        let (sample, _) = ui.allocate_exact_size(vec2(34.0, 14.0), Sense::hover());
        stroke(ui.painter(), &[sample.left_center(), sample.right_center()], curve);
        ui.label(RichText::new(&curve.named.title).strong());
        if plot.unit().is_none() {
            text(ui, &curve.unit_words(digits));
        }
        if first.is_some_and(|hit| hit.object == object) {
            ui.add(Label::new(RichText::new("the first hit").strong()).extend());
        }
    });
    let words = ui.indent(("said", object), |ui| {
        text(ui, &curve.description(digits));
        if let Some(t) = plot.ray_point_t {
            let reading = curve.reading(curve.at_point, digits);
            text(ui, &format!("at t {}: {reading}", equated(t, digits)));
        }
    });
    let (area, id) = (title.response.rect | words.response.rect, ("said of a curve", object));
    let response = ui.interact(area, Id::unique(id), Sense::hover());
    is_about(&response, Some(Concept::Object(object)), HoverSource::Derivation);
}

/// Size of the text in the drawing, in points.
const DRAWN_TEXT: f32 = 15.0;

/// Minimum distance of the numbers of f, in points.
const ROWS_APART: f32 = 20.0;
/// Dash and gap of a curve's line, in points, by the curve's index.
const DASHES: [[f32; 2]; 4] = [SOLID, [11.0, 6.0], [3.0, 5.0], [20.0, 5.0]];

/// Vertical distance between two possible positions of a caption, in points.
const ROW: f32 = 20.0;

/// The plot on the screen.
struct PlotDrawing<'a> {
    painter: Painter,
    rect: Rect,
    t: Scale,
    height: Scale,
    plot: &'a Plot,
    first: Option<(u32, f64)>,
    colors: &'a Colors,
}

/// A curve on the screen.
struct DrawnCurve {
    /// The parts inside the plot.
    parts: Vec<Vec<Pos2>>,
    /// The points where the curve leaves the plot, each with the curve's direction there, down or up.
    exits: Vec<(Pos2, Vec2)>,
}

/// Shows the drawing, and handles drags of t in it; while the step's question is open, shows only the axes.
fn draw(ui: &Ui, rect: Rect, PageContext { session, derived, .. }: &mut PageContext<'_>) {
    let (Some(plot), Some(inspection)) = (&derived.plot, &derived.inspection) else { return };
    let first = inspection.first_hit().map(|hit| (hit.object, hit.t));
    let colors = theme::style(ui).colors();
    // Leaves space for the numbers of f on the left, those of t below, and the title above.
    let inner = Rect::from_min_max(rect.min + vec2(44.0, 28.0), rect.max - vec2(8.0, 26.0));
    let t = Scale::even([*plot.range.start(), *plot.range.end()], [inner.left(), inner.right()]);
    let height = Scale::even(plot.heights(), [inner.bottom(), inner.top()]);
    let painter = ui.painter_at(inner);
    let drawing = PlotDrawing { painter, rect: inner, t, height, plot, first, colors };
    drawing.axes(&ui.painter_at(rect), rect);
    let curves: Vec<DrawnCurve> =
        plot.curves.iter().map(|curve| drawing.drawn(&curve.samples)).collect();
    let mut words = LabelLayout::new(ui.painter_at(inner), colors.background, inner.shrink(2.0));
    for x in [0.0, 1.0].map(|t| drawing.t.position(t)) {
        words.keep_free(Rect::from_x_y_ranges(x - 1.0..=x + 1.0, inner.y_range()));
    }
    if session.shown.is_asking {
        return drawing.captions(&curves, &mut words);
    }
    input(ui, inner, &drawing.t, &mut session.shown.ray_point_t);
    drawing.curves(&curves);
    drawing.roots(&mut words);
    drawing.ray_point(&mut words);
    drawing.numbers(&curves, &mut words);
    drawing.captions(&curves, &mut words);
    drawing.names(&curves, &mut words);
}

/// Sets t when the user presses or drags in the plot, and changes it with the arrow keys.
fn input(ui: &Ui, rect: Rect, scale: &Scale, ray_point_t: &mut Option<f64>) {
    // Rounds t to a power of ten that is just fine enough for one point on the screen.
    let per_unit = 10_f64.powf(scale.unit().log10().ceil());
    let t_at = |x: f32| {
        let x = x.clamp(rect.left(), rect.right());
        (scale.value_at(x) * per_unit).round() / per_unit + 0.0
    };
    let response = views::view(ui, rect, "Plot of f(p + t d)");
    keep_arrows(&response, true, false);
    if (response.dragged() || response.clicked())
        && let Some(pointer) = response.interact_pointer_pos()
    {
        *ray_point_t = Some(t_at(pointer.x));
    }
    if response.has_focus()
        && let Some(t) = ray_point_t
    {
        let steps = arrows(ui.ctx()).x;
        if steps != 0.0 {
            *t = t_at(scale.position(*t) + 3.0 * steps);
        }
    }
    let text = ray_point_t
        .map_or("no point marked on the ray".to_owned(), |t| format!("point marked at t = {t}"));
    response.described(text);
}

/// Draws a line in a curve's color and dashes.
fn stroke(painter: &Painter, points: &[Pos2], curve: &Curve) {
    let dashes = DASHES[curve.index % DASHES.len()];
    chart::line(painter, points, (3.0, curve.named.color), dashes);
}

impl PlotDrawing<'_> {
    fn at(&self, t: f64, height: f64) -> Pos2 {
        pos2(self.t.position(t), self.height.position(height))
    }

    /// Draws the title, the numbers of t and f, the line f = 0, the grey area behind the eye, and the
    /// vertical lines t = 0 (the eye) and t = 1 (the viewport).
    fn axes(&self, around: &Painter, outer: Rect) {
        let (rect, ink) = (self.rect, self.colors.ink);
        around.rect_filled(rect, 0.0, self.colors.background);
        let behind = self.at(0.0, 0.0).x.clamp(rect.left(), rect.right());
        around.rect_filled(rect.with_max_x(behind), 0.0, ink.gamma_multiply(0.14));
        let grid = GridInk { line: ink.gamma_multiply(0.2), text: ink, size: DRAWN_TEXT };
        let unit = self.plot.unit().unwrap_or(1.0);
        let ends = self.plot.heights().map(|height| unit * height);
        let own = Scale::even(ends, [rect.bottom(), rect.top()]);
        let ticks = own.ticks(ROWS_APART);
        chart::rows(around, rect, &ticks, grid.line);
        chart::row_numbers(around, rect.left(), &ticks, grid);
        let mut ticks = self.t.ticks(62.0);
        // The last ticks get no numbers, because the name of the axis is there.
        let last = ticks.iter_mut().filter(|tick| tick.at > rect.right() - 30.0);
        last.for_each(|tick| tick.text.clear());
        chart::columns(around, rect, &ticks, grid);
        for (text, size, at) in [
            (self.plot.height_words().as_str(), DRAWN_TEXT + 0.5, outer.min + vec2(6.0, 2.0)),
            ("t", DRAWN_TEXT + 2.0, rect.right_bottom() + vec2(-14.0, 2.0)),
        ] {
            around.galley(at, around.layout_job(formula(text, size, ink)), ink);
        }
        self.painter.hline(rect.x_range(), self.at(0.0, 0.0).y, (2.5, ink));
        for (t, dashes) in [(0.0, SOLID), (1.0, [6.0; 2])] {
            let x = self.t.position(t);
            let ends = [pos2(x, rect.top()), pos2(x, rect.bottom())];
            chart::line(&self.painter, &ends, (2.0, ink), dashes);
        }
    }

    fn drawn(&self, samples: &[(f64, f64)]) -> DrawnCurve {
        let points: Vec<Pos2> = samples.iter().map(|(t, y)| self.at(*t, *y)).collect();
        let parts = chart::parts_inside(self.rect, &points);
        let (top, bottom) = (self.rect.top() + 0.1, self.rect.bottom() - 0.1);
        let exit = |at: Pos2| match at.y {
            y if y <= top => Some((at, Vec2::UP)),
            y if y >= bottom => Some((at, Vec2::DOWN)),
            _ => None,
        };
        let ends = parts.iter().flat_map(|part| [part[0], part[part.len() - 1]]);
        let mut exits: Vec<(Pos2, Vec2)> = ends.filter_map(exit).collect();
        if parts.is_empty() {
            // An arrow in the middle of the edge shows in which direction the curve lies.
            let edge = points.first().map(|at| at.y.clamp(self.rect.top(), self.rect.bottom()));
            exits.extend(edge.and_then(|y| exit(pos2(self.rect.center().x, y))));
        }
        DrawnCurve { parts, exits }
    }

    /// Draws the curves, with an arrowhead wherever one leaves the plot.
    fn curves(&self, curves: &[DrawnCurve]) {
        for (curve, drawn) in self.plot.curves.iter().zip(curves) {
            let dashes = DASHES[curve.index % DASHES.len()];
            // The casing is dashed like the curve, so that an equal curve below shows in the gaps.
            for stroke in
                [Stroke::new(5.0, self.colors.background), Stroke::new(3.0, curve.named.color)]
            {
                for part in &drawn.parts {
                    chart::line(&self.painter, part, stroke, dashes);
                }
            }
            for (at, direction) in &drawn.exits {
                chart::arrowhead(&self.painter, *at, 12.0 * *direction, curve.named.color);
            }
        }
    }

    /// Returns the curve and the t of every visible zero except the first hit.
    fn zeros(&self) -> impl Iterator<Item = (&Curve, f64)> {
        let curves = self.plot.curves.iter();
        let all =
            curves.flat_map(|curve| curve.derivation.roots().map(move |root| (curve, root.t)));
        let is_first = |curve: &Curve, t| self.first == Some((curve.named.object, t));
        all.filter(move |(curve, t)| self.plot.range.contains(t) && !is_first(curve, *t))
    }

    fn first_hit(&self) -> Option<(u32, f64)> {
        self.first.filter(|(_, t)| self.plot.range.contains(t))
    }

    /// Draws a ring at every zero, and a large disc at the first hit.
    fn roots(&self, words: &mut LabelLayout) {
        for (curve, t) in self.zeros() {
            let (at, stroke) = (self.at(t, 0.0), Stroke::new(3.0, curve.named.color));
            self.painter.circle(at, 5.5, self.colors.background, stroke);
            words.keep_free(Rect::from_center_size(at, Vec2::splat(13.0)));
        }
        if let Some((object, t)) = self.first_hit() {
            let curve = self.plot.curves.iter().find(|curve| curve.named.object == object);
            let color = curve.map_or(self.colors.ink, |curve| curve.named.color);
            let at = self.at(t, 0.0);
            self.painter.circle(at, 9.0, color, Stroke::new(3.0, self.colors.ink));
            words.keep_free(Rect::from_center_size(at, Vec2::splat(20.0)));
        }
    }

    /// Draws the vertical line at the t that the user drags, with a mark at each curve's value there.
    fn ray_point(&self, words: &mut LabelLayout) {
        let Some(t) = self.plot.ray_point_t else { return };
        let x = self.t.position(t);
        for stroke in [Stroke::new(6.0, self.colors.background), Stroke::new(3.0, self.colors.ray)]
        {
            self.painter.vline(x, self.rect.y_range(), stroke);
        }
        words.keep_free(Rect::from_x_y_ranges(x - 4.0..=x + 4.0, self.rect.y_range()));
        for curve in &self.plot.curves {
            let at = self.at(t, curve.height(curve.at_point));
            if self.rect.contains(at) {
                let stroke = Stroke::new(2.5, curve.named.color);
                self.painter.circle(at, 5.5, self.colors.ray, stroke);
            }
        }
    }

    /// Labels the vertical lines t = 0 (the eye) and t = 1 (the viewport), at positions where no curve runs
    /// through the words.
    fn captions(&self, curves: &[DrawnCurve], words: &mut LabelLayout) {
        let [eye, viewport] = [0.0, 1.0].map(|t| self.t.position(t));
        let (top, bottom) = (self.rect.top() + 24.0, self.rect.bottom() - 4.0);
        let count = ((bottom - top) / ROW).max(0.0) as usize + 1;
        let rows = |x: f32, align: Align2| {
            (0..count).map(move |k| (pos2(x, bottom - ROW * k as f32), align))
        };
        let left = |x: f32| rows(x - 5.0, Align2::RIGHT_BOTTOM);
        let right = |x: f32| rows(x + 5.0, Align2::LEFT_BOTTOM);
        let font = Font { size: DRAWN_TEXT, color: self.colors.ink, bold: false };
        let covered = self.covered(curves);
        let mut write = |text: &str, places: &mut dyn Iterator<Item = (Pos2, Align2)>| {
            words.write_clear_of(&covered, text, font, places).is_some()
        };
        if !write("behind the eye", &mut left(eye)) {
            write("behind\nthe eye", &mut left(eye));
        }
        write("viewport: t = 1", &mut right(viewport).chain(left(viewport)));
        write("eye: t = 0", &mut right(eye).chain(left(eye)));
    }

    /// Returns points on the lines that must not run through a word: the curves and the line f = 0.
    fn covered(&self, curves: &[DrawnCurve]) -> Vec<Pos2> {
        let y = self.height.position(0.0);
        let zero = vec![pos2(self.rect.left(), y), pos2(self.rect.right(), y)];
        let chains = curves.iter().flat_map(|drawn| &drawn.parts).chain([&zero]);
        chains.flat_map(|chain| closely(chain)).collect()
    }

    /// Writes t at the zeros. At the first hit, also writes that it is the hit, if there is room.
    fn numbers(&self, curves: &[DrawnCurve], words: &mut LabelLayout) {
        let ink = self.colors.ink;
        if let Some((_, t)) = self.first_hit() {
            let at = self.at(t, 0.0);
            let is = equated(t, 5);
            let texts = [format!("first hit: 𝑡 {is}"), format!("hit: 𝑡 {is}"), number(t, 5)];
            let font = Font { size: DRAWN_TEXT + 1.0, color: ink, bold: true };
            let places = || around(at, Vec2::DOWN, 15.0);
            let [covered, none] = [self.covered(curves), Vec::new()];
            let _ = [covered, none].iter().any(|covered| {
                let mut write = |text| words.write_clear_of(covered, text, font, places());
                texts.iter().any(|text| write(text).is_some())
            });
        }
        if let Some(t) = self.plot.ray_point_t {
            let (x, top) = (self.t.position(t), self.rect.top() + 3.0);
            let rows = (0..3).flat_map(|k| {
                let y = top + ROW * k as f32;
                [(pos2(x + 7.0, y), Align2::LEFT_TOP), (pos2(x - 7.0, y), Align2::RIGHT_TOP)]
            });
            let font = Font { size: DRAWN_TEXT + 2.0, color: self.colors.ray, bold: false };
            words.write(&format!("t {}", equated(t, 5)), font, rows);
        }
        // Objects that are hit at the same t share its number.
        let mut written: Vec<String> =
            self.first_hit().map(|(_, t)| number(t, 4)).into_iter().collect();
        for (_, t) in self.zeros() {
            let (at, text) = (self.at(t, 0.0), number(t, 4));
            if written.contains(&text) {
                continue;
            }
            let places = around(at, Vec2::DOWN, 8.0).chain(around(at, Vec2::DOWN, 27.0));
            words.write(&text, Font { size: DRAWN_TEXT, color: ink, bold: false }, places);
            written.push(text);
        }
    }

    /// Writes each curve's name, underlined in the curve's style.
    fn names(&self, curves: &[DrawnCurve], words: &mut LabelLayout) {
        let covered = self.covered(curves);
        let font = Font { size: DRAWN_TEXT, color: self.colors.ink, bold: true };
        for (curve, drawn) in self.plot.curves.iter().zip(curves) {
            let (name, places) = (&curve.named.name, self.places_at(drawn));
            let broken = name.replace(' ', "\n");
            let clear = [name, &broken].into_iter().find_map(|name| {
                words.write_clear_of(&covered, name, font, places.iter().copied())
            });
            if let Some(name) = clear.or_else(|| words.write(name, font, places)) {
                let y = name.bottom() - 1.0;
                stroke(&self.painter, &[pos2(name.left(), y), pos2(name.right(), y)], curve);
            }
        }
    }

    /// Returns the positions for a curve's name, next to points along the curve.
    fn places_at(&self, drawn: &DrawnCurve) -> Vec<(Pos2, Align2)> {
        let all: Vec<Pos2> = drawn.parts.iter().flat_map(|part| closely(part)).collect();
        let shares = [0.3, 0.22, 0.4, 0.15, 0.5, 0.6, 0.7, 0.08, 0.8, 0.9, 0.02, 0.98];
        let along = shares.iter().filter_map(|share| all.get((share * all.len() as f32) as usize));
        let exits = drawn.exits.iter().map(|(at, direction)| *at - 12.0 * *direction);
        along.copied().chain(exits).flat_map(|at| around(at, Vec2::RIGHT, 9.0).take(8)).collect()
    }
}

/// Returns points along a polyline that are at most four screen points apart.
fn closely(chain: &[Pos2]) -> impl Iterator<Item = Pos2> {
    chain.windows(2).flat_map(|ends| {
        let count = (ends[0].distance(ends[1]) / 4.0).ceil().max(1.0) as usize;
        (0..=count).map(move |k| ends[0].lerp(ends[1], k as f32 / count as f32))
    })
}
