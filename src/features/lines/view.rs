//! The page *Lines*, the lines lab: draws an implicit and a parametric line in the plane, with their
//! handles, and shows step by step, in words and numbers, how the parametric line is substituted into the
//! implicit one.

use std::cmp::Ordering;
use std::ops::Range;

use egui::text::{LayoutJob, LayoutSection};
use egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, RichText, Shape, Stroke, StrokeKind, Ui,
    UiBuilder, Vec2, pos2, vec2,
};
use pinhole_core::DVec2;
use pinhole_figure::chart::{self, SOLID, Scale, Tick};
use pinhole_figure::overlay::Colors;
use pinhole_figure::symbols::typeset_message;
use pinhole_figure::typesetting::labels::{Font, LabelLayout, around};
use pinhole_figure::typesetting::notation;
use pinhole_figure::typesetting::theme::{self, error_color, text_size};
use pinhole_lecture::Rounding;
use pinhole_lecture::lines::{Crossing, ImplicitLine, Meeting, ParametricLine, Substitution};
use pinhole_lecture::numbers::{equated, sum, written as number};

use crate::features::lines::state::{LineHandle, LinesLab, ShownLines, Window};

/// Text size in points, legible from the back row.
pub(crate) const TEXT: f32 = 16.5;

/// Maximum width of the column of numbers to the right of the drawing: in points, and as a fraction of the
/// total width.
pub(crate) const NUMBERS: (f32, f32) = (400.0, 0.46);

/// Writes a line of text of the font's size, with its formulas typeset.
pub(crate) fn text(ui: &mut Ui, text: &str) {
    notation::label(ui, text, text_size(ui), ui.visuals().text_color());
}

/// Draws the plane with both lines, and the steps of the substitution. Draws no background and ignores
/// input.
pub(crate) fn draw(ui: &mut Ui, area: Rect, lab: &LinesLab, digits: usize) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let (left, right) = chart::beside(area, NUMBERS);
    PlaneView::new(ui, left, lab.window).paint(lab, |_| false, digits);
    let right = right.shrink2(Vec2::new(2.0, 14.0));
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| substitution(ui, lab, digits));
}

/// Shows the steps by which the parametric line is substituted into the implicit one, the point where the
/// lines meet, and the value of f at the current t. If only one line is drawn, shows only its equation.
pub(crate) fn substitution(ui: &mut Ui, lab: &LinesLab, digits: usize) {
    let substitution = match Substitution::new(lab.line(), lab.ray) {
        Ok(substitution) => substitution,
        Err(error) => {
            let text = RichText::new(typeset_message(error)).size(TEXT + 2.0).strong();
            ui.label(text.color(error_color(ui)));
            return;
        }
    };
    show_steps(ui, &steps(&substitution, lab.shown, digits));
    if lab.shown != ShownLines::Both {
        return;
    }
    ui.add_space(6.0);
    let verdict = verdict(&substitution, digits);
    notation::label(ui, &verdict, text_size(ui) + 1.0, ui.visuals().strong_text_color());
    ui.add_space(4.0);
    let (f, sign) = substitution.f(lab.t);
    let compared = match sign {
        Ordering::Less => " < 0",
        Ordering::Equal => ", on the line",
        Ordering::Greater => " > 0",
    };
    let (t, f) = (equated(lab.t, digits), equated(f, digits));
    text(ui, &format!("at t {t}:  f {f}{compared}"));
}

/// The steps of the substitution that lead to t, without t itself, and to the point.
pub(crate) const TO_T: Range<usize> = 2..5;
pub(crate) const TO_POINT: Range<usize> = 1..2;

/// Shows these steps of the substitution.
pub(crate) fn hint(ui: &mut Ui, lab: &LinesLab, digits: usize, which: Range<usize>) {
    if let Ok(substitution) = Substitution::new(lab.line(), lab.ray) {
        show_steps(ui, &steps(&substitution, lab.shown, digits)[which]);
    }
}

fn show_steps(ui: &mut Ui, steps: &[(&str, String)]) {
    for (what, formula) in steps {
        let job = job_of(ui, what, formula, text_size(ui));
        let (id, spoken) =
            (ui.label(job).id, notation::without_marks(&format!("{what}: {formula}")));
        ui.ctx().accesskit_node_builder(id, |node| node.set_value(spoken));
    }
}

/// Lays out what a step does, and its formula. A formula that does not fit into a row is broken between its parts.
fn job_of(ui: &Ui, what: &str, formula: &str, size: f32) -> LayoutJob {
    let mut job = notation::formula(&format!("{what}: "), size, ui.visuals().weak_text_color());
    let parts = notation::formula(&notation::unbroken(formula), size, ui.visuals().text_color());
    for LayoutSection { byte_range, format, .. } in parts.sections {
        job.append(&parts.text[byte_range.start.0..byte_range.end.0], 0.0, format);
    }
    job
}

/// Distance between two steps on a lesson's card, in points.
const ON_CARD: f32 = 4.0;

/// Returns what a lesson's card says of the lines, of which its text gives the equations: where they meet or, of
/// one that is drawn alone, its equation.
fn of_card(lab: &LinesLab, digits: usize, in_words: bool) -> Vec<(&'static str, String)> {
    let substitution = match Substitution::new(lab.line(), lab.ray) {
        Ok(substitution) => substitution,
        Err(error) => return vec![("no line", typeset_message(error))],
    };
    let mut steps = steps(&substitution, lab.shown, digits);
    if lab.shown == ShownLines::Both {
        let left_out = ["implicit", "parametric", "sorted by t"];
        steps.retain(|(name, _)| !left_out.contains(name));
        steps.extend(in_words.then(|| ("in words", verdict(&substitution, digits))));
    }
    steps
}

/// Returns how many lines of a lesson's card are revealed one by one: none if a line is drawn alone.
pub(crate) fn line_count(lab: &LinesLab) -> usize {
    if lab.shown == ShownLines::Both { 3 } else { 0 }
}

/// Returns true if all lines of a lesson's card are revealed.
pub(crate) fn is_whole(lab: &LinesLab, revealed_lines: Option<usize>) -> bool {
    revealed_lines.is_none_or(|count| count >= line_count(lab))
}

/// Shows a lesson's card, with as many lines as are revealed. `in_words` adds where the lines meet as a sentence.
pub(crate) fn card(
    ui: &mut Ui,
    lab: &LinesLab,
    (digits, in_words): (usize, bool),
    revealed_lines: Option<usize>,
) {
    ui.spacing_mut().item_spacing.y = ON_CARD;
    let lines = of_card(lab, digits, in_words);
    let revealed = revealed_lines.filter(|_| lab.shown == ShownLines::Both);
    let count = revealed.map_or(lines.len(), |count| count.min(lines.len()));
    show_steps(ui, &lines[..count]);
}

/// Returns the height of a lesson's card of this width and with text of this size.
pub(crate) fn card_height(
    ui: &Ui,
    (lab, digits, in_words): (&LinesLab, usize, bool),
    [width, size]: [f32; 2],
) -> f32 {
    let height = |(what, formula): (&str, String)| {
        let mut job = job_of(ui, what, &formula, size);
        job.wrap.max_width = width;
        ui.painter().layout_job(job).size().y + ON_CARD
    };
    of_card(lab, digits, in_words).into_iter().map(height).sum()
}

/// Formats a number as a factor after a multiplication sign: in parentheses if it is negative.
fn factor(x: f64, digits: usize) -> String {
    let text = number(x, digits);
    if text.starts_with('−') { format!("({text})") } else { text }
}

/// Returns ` + x` or ` − |x|`, or nothing for 0.
fn added(x: f64, digits: usize) -> String {
    let sign = if x < 0.0 { '−' } else { '+' };
    if x == 0.0 { String::new() } else { format!(" {sign} {}", number(x.abs(), digits)) }
}

/// Returns the name of a sum's term whose factor multiplies `text`: in parentheses where they are needed.
fn multiplied(factor: f64, text: &str) -> String {
    let is_bare = text == "t" || factor.abs() == 1.0 && !text.contains(['+', '−']);
    if is_bare { format!(" {text}") } else { format!(" ({text})") }
}

/// Returns the name and the formula of each step of the substitution, with the current numbers. The
/// formulas are in the notation of [`notation::formula`], with two spaces between their parts. Of a line that is
/// shown alone, there is only its equation, which has the letters, too.
fn steps(s: &Substitution, shown: ShownLines, digits: usize) -> Vec<(&'static str, String)> {
    let n = |x| number(x, digits);
    let is = |shown: &[f64]| Rounding::Significant(digits).relation(shown);
    let (ImplicitLine { a, b, c }, ParametricLine { p, d }) = (s.line, s.ray);
    let [x, y] = [(p.x, d.x), (p.y, d.y)].map(|(p, d)| sum([(p, ""), (d, " t")], n));
    let [of_x, of_y] = [(a, &x), (b, &y)].map(|(factor, text)| multiplied(factor, text));
    let all = is(&[a, b, c, p.x, p.y, d.x, d.y]);
    let products = |of: DVec2| {
        let [x, y] = [of.x, of.y].map(|x| factor(x, digits));
        let sign = if b < 0.0 { '−' } else { '+' };
        format!("{}·{x} {sign} {}·{y}", n(a), n(b.abs()))
    };
    let (implicit, put_in) = ([(a, " x"), (b, " y"), (c, "")], [(a, &*of_x), (b, &of_y), (c, "")]);
    let added_up = sum([(s.rate, " t"), (s.offset, "")], n);
    let letters = |text: &'static str| if shown == ShownLines::Both { "" } else { text };
    let [general, of_t_x, of_t_y] =
        [" = a x + b y + c", " = p_x + t d_x", " = p_y + t d_y"].map(letters);
    let implicit =
        ("implicit", format!("f(x, y){general} {} {}", is(&[a, b, c]), sum(implicit, n)));
    let [x, y] = [(of_t_x, [p.x, d.x], x), (of_t_y, [p.y, d.y], y)]
        .map(|(letters, pair, text)| format!("{letters} {} {text}", is(&pair)));
    let parametric = ("parametric", format!("x{x},  y{y}"));
    match shown {
        ShownLines::Implicit => return vec![implicit],
        ShownLines::Parametric => return vec![parametric],
        ShownLines::Both => {}
    }
    vec![
        implicit,
        parametric,
        ("substituted", format!("f(p + t d)  {all} {}", sum(put_in, n))),
        (
            "sorted by t",
            format!("{all} ({}) t  + ({}{})", products(d), products(p), added(c, digits)),
        ),
        ("added up", format!("{} {added_up}", is(&[s.rate, s.offset]))),
        ("zero where", zero(s, digits)),
    ]
}

fn zero(s: &Substitution, digits: usize) -> String {
    let minus_offset = 0.0 - s.offset;
    let quotient = || {
        let is = Rounding::Significant(digits).relation(&[s.rate, s.offset]);
        format!("t {is} {} / {}", number(minus_offset, digits), factor(s.rate, digits))
    };
    match s.meeting {
        Meeting::Parallel => format!("0 t {}: for no t", equated(minus_offset, digits)),
        Meeting::Coincident => "0 t = 0: for every t".to_owned(),
        Meeting::At(Crossing { t, .. }) if s.rate == 1.0 => format!("t {}", equated(t, digits)),
        Meeting::At(Crossing { t, .. }) => format!("{} {}", quotient(), equated(t, digits)),
        Meeting::TooFar { .. } => format!("{}, too large", quotient()),
    }
}

/// Describes whether and where the lines meet.
fn verdict(s: &Substitution, digits: usize) -> String {
    let n = |x| number(x, digits);
    match s.meeting {
        Meeting::Parallel => {
            format!("Parallel: f(p + t d) is {} at every t, never 0. They never meet.", n(s.offset))
        }
        Meeting::Coincident => {
            "Coincident: f(p + t d) is 0 at every t. Both are the same line.".to_owned()
        }
        Meeting::At(Crossing { t, point, ray_hits }) => {
            let (is, x, y) = (equated(t, digits), n(point.x), n(point.y));
            if ray_hits {
                format!("They meet at t {is}, at ({x}, {y}). t > 0: the ray hits.")
            } else if t.partial_cmp(&0.0) == Some(Ordering::Less) {
                format!("They meet at t {is}, at ({x}, {y}). t < 0, behind p: the ray misses.")
            } else {
                format!("They meet at p itself, ({x}, {y}): t = 0 is no hit.")
            }
        }
        Meeting::TooFar { ray_hits } => {
            let side = if ray_hits { "ahead of p" } else { "behind p" };
            format!("They meet {side}, too far away to compute.")
        }
    }
}

/// Text size of coordinates, in points.
const SMALL: f32 = 15.0;
/// Text size of names, in points.
const NAMES: f32 = 19.0;
/// Text size of the labels of regions, in points.
const REGIONS: f32 = 23.0;

/// Half the side of the square around a handle that reacts to the pointer, in points.
pub(crate) const GRASP: f32 = 13.0;

/// Maximum number of generated points that are drawn.
const MOST_POINTS: usize = 400;

/// A part of the plane, drawn in a rectangle with y pointing up and the same scale on both axes.
pub(crate) struct PlaneView {
    painter: Painter,
    pub(crate) rect: Rect,
    x: Scale,
    y: Scale,
    colors: &'static Colors,
    /// True if the point where both lines meet is drawn.
    pub(crate) shows_meeting: bool,
}

/// Draws the lines while a lesson asks the class where they meet, but nothing that shows it: the trail of points may
/// end there.
pub(crate) fn draw_question(ui: &Ui, lab: &LinesLab) {
    let plane = PlaneView::new(ui, ui.available_rect_before_wrap(), lab.window);
    plane.background();
    plane.grid();
    if lab.shown != ShownLines::Parametric {
        plane.implicit(&lab.line());
    }
    if lab.shown != ShownLines::Implicit {
        plane.parametric(&lab.ray, None);
    }
    let mut labels = plane.labels();
    plane.names(lab, &mut labels, None);
    plane.coordinates(&mut labels);
}

/// Draws the plane for an exercise: the implicit line, the point p of the parametric one, and a ring at
/// each point that was typed as an answer. Draws the solution only if `may_be_seen` is true.
pub(crate) fn draw_exercise(
    ui: &Ui,
    rect: Rect,
    lab: &LinesLab,
    typed: &[(String, DVec2)],
    (may_be_seen, digits): (bool, usize),
) {
    let plane = PlaneView::new(ui, rect, lab.window);
    plane.background();
    let mut labels = plane.labels();
    let (painter, ray) = (&plane.painter, plane.colors.ray);
    if may_be_seen {
        plane.paint(lab, |_| false, digits);
    } else {
        plane.grid();
        plane.implicit(&lab.line());
        plane.direction(&lab.ray);
        plane.handle(LineHandle::P, plane.to_screen(lab.ray.p), false);
        plane.names(lab, &mut labels, None);
    }
    for (name, at) in typed {
        let at = plane.to_screen(*at);
        painter.circle_stroke(at, 9.0, Stroke::new(3.0, ray));
        let font = Font { size: NAMES, color: ray, bold: true };
        labels.write(name, font, around(at, vec2(1.0, -1.0), 15.0));
    }
    if !may_be_seen {
        plane.regions(&lab.line(), &mut labels);
        plane.coordinates(&mut labels);
    }
}

impl PlaneView {
    pub(crate) fn new(ui: &Ui, rect: Rect, window: Window) -> PlaneView {
        let half = DVec2::new(rect.width().into(), rect.height().into())
            * (window.half_extent / f64::from(rect.size().min_elem()));
        let (low, high) = (window.center - half, window.center + half);
        PlaneView {
            painter: ui.painter_at(rect),
            rect,
            x: Scale::even([low.x, high.x], [rect.left(), rect.right()]),
            y: Scale::even([low.y, high.y], [rect.bottom(), rect.top()]),
            colors: theme::style(ui).colors(),
            shows_meeting: true,
        }
    }

    pub(crate) fn background(&self) {
        self.painter.rect_filled(self.rect, 0.0, self.colors.background);
    }

    pub(crate) fn to_screen(&self, point: DVec2) -> Pos2 {
        pos2(self.x.position(point.x), self.y.position(point.y))
    }

    pub(crate) fn to_plane(&self, position: Pos2) -> DVec2 {
        DVec2::new(self.x.value_at(position.x), self.y.value_at(position.y))
    }

    /// Returns the length of a unit of the plane, in points.
    pub(crate) fn unit(&self) -> f64 {
        self.x.unit()
    }

    fn center(&self) -> DVec2 {
        self.to_plane(self.rect.center())
    }

    /// Returns the distance, in the plane, from the centre of the drawing to a corner. All visible points
    /// lie within it.
    fn reach(&self) -> f64 {
        0.5 * f64::from(self.rect.size().length()) / self.unit()
    }

    /// Returns the layout of the labels, with the names of the axes, which all others keep clear of.
    fn labels(&self) -> LabelLayout {
        let halo = self.colors.background;
        let mut labels = LabelLayout::new(self.painter.clone(), halo, self.rect.shrink(3.0));
        let (axes, font) = (self.axes(), Font { size: NAMES, color: self.colors.ink, bold: false });
        let right = pos2(self.rect.right() - 6.0, axes.y - 3.0);
        labels.write("x", font, [(right, Align2::RIGHT_BOTTOM)]);
        let top = pos2(axes.x + 7.0, self.rect.top() + 4.0);
        labels.write("y", font, [(top, Align2::LEFT_TOP)]);
        let both = Rect::from_center_size(self.to_screen(DVec2::ZERO), Vec2::splat(2.0));
        labels.keep_free(both.with_min_x(self.rect.left()).with_max_x(self.rect.right()));
        labels.keep_free(both.with_min_y(self.rect.top()).with_max_y(self.rect.bottom()));
        labels
    }

    /// Returns where the axes cross, or the point inside nearest to it.
    fn axes(&self) -> Pos2 {
        let (origin, rect) = (self.to_screen(DVec2::ZERO), self.rect);
        pos2(
            origin.x.min(rect.right() - 4.0).max(rect.left() + 40.0),
            origin.y.min(rect.bottom() - 26.0).max(rect.top() + 2.0),
        )
    }

    /// Paints everything except the background. Returns a description of the points along the parametric
    /// line, or `None` if that line is invalid.
    pub(crate) fn paint(
        &self,
        lab: &LinesLab,
        is_held: impl Fn(LineHandle) -> bool,
        digits: usize,
    ) -> Option<String> {
        let line = lab.line();
        let is_line = lab.shown != ShownLines::Parametric && line.check().is_ok();
        if is_line {
            let [negative, _, positive] = self.colors.basis;
            self.half_plane(&line, 1.0, positive.gamma_multiply(0.13));
            self.half_plane(&line, -1.0, negative.gamma_multiply(0.13));
        }
        self.grid();
        if is_line {
            self.signs(&line);
            self.implicit(&line);
        }
        let mut labels = self.labels();
        for position in LineHandle::ALL.into_iter().filter_map(|handle| lab.position_of(handle)) {
            labels.keep_free(Rect::from_center_size(self.to_screen(position), Vec2::splat(15.0)));
        }
        let is_ray = lab.shown != ShownLines::Implicit && lab.ray.check().is_ok();
        if is_ray {
            self.parametric(&lab.ray, Some(lab));
        }
        for handle in LineHandle::ALL {
            if let Some(at) = self.in_sight(lab, handle) {
                self.handle(handle, at, is_held(handle));
            }
        }
        self.meeting(lab, &mut labels, digits);
        self.names(lab, &mut labels, Some(digits));
        let description = is_ray.then(|| {
            let description = self.trail(lab, &mut labels);
            self.sides(lab, &mut labels);
            description
        });
        if is_line {
            self.regions(&line, &mut labels);
        }
        self.coordinates(&mut labels);
        description
    }

    /// Fills the visible part of the plane where f, the implicit line's function, has the given sign.
    fn half_plane(&self, line: &ImplicitLine, sign: f64, fill: Color32) {
        let rect = self.rect;
        let corners = [rect.left_bottom(), rect.right_bottom(), rect.right_top(), rect.left_top()];
        let mut inside = Vec::new();
        for k in 0..4 {
            let ends = [corners[k], corners[(k + 1) % 4]];
            let [f, g] = ends.map(|corner| sign * line.f(self.to_plane(corner)));
            if f >= 0.0 {
                inside.push(ends[0]);
            }
            if (f < 0.0) != (g < 0.0) {
                inside.push(ends[0].lerp(ends[1], (f / (f - g)) as f32));
            }
        }
        if inside.len() > 2 {
            self.painter.add(Shape::convex_polygon(inside, fill, Stroke::NONE));
        }
    }

    /// Draws the visible part of the line segment between two points of the plane.
    fn line(&self, from: DVec2, to: DVec2, stroke: Stroke, dashes: [f32; 2]) {
        for part in chart::parts_inside(self.rect, &[from, to].map(|end| self.to_screen(end))) {
            chart::line(&self.painter, &part, stroke, dashes);
        }
    }

    fn ticks(&self) -> [Vec<Tick>; 2] {
        [self.x, self.y].map(|scale| scale.ticks(52.0))
    }

    fn grid(&self) {
        let (ink, [across, up]) = (self.colors.ink, self.ticks());
        let stroke = |tick: &Tick| match tick.value {
            0.0 => Stroke::new(2.0, ink),
            _ => Stroke::new(1.0, ink.gamma_multiply(0.22)),
        };
        for tick in &across {
            self.painter.vline(tick.at, self.rect.y_range(), stroke(tick));
        }
        for tick in &up {
            self.painter.hline(self.rect.x_range(), tick.at, stroke(tick));
        }
    }

    /// Draws the sign of f, the implicit line's function, in the middle of every cell of the grid.
    fn signs(&self, line: &ImplicitLine) {
        let [xs, ys] = self.ticks().map(|ticks| {
            let middle = |pair: &[Tick]| 0.5 * (pair[0].value + pair[1].value);
            ticks.windows(2).map(middle).collect::<Vec<f64>>()
        });
        for at in xs.iter().flat_map(|x| ys.iter().map(|y| DVec2::new(*x, *y))) {
            let (sign, color) = match line.side(at) {
                Ordering::Less => ("−", self.colors.basis[0]),
                Ordering::Equal => continue,
                Ordering::Greater => ("+", self.colors.basis[2]),
            };
            let font = FontId::proportional(SMALL);
            self.painter.text(self.to_screen(at), Align2::CENTER_CENTER, sign, font, color);
        }
    }

    /// Writes the numbers of the grid along the axes, or along the edge if an axis is not visible.
    fn coordinates(&self, labels: &mut LabelLayout) {
        let axis = self.axes();
        let font = Font { size: SMALL, color: self.colors.ink, bold: false };
        let [across, up] = self.ticks();
        for Tick { at, text, .. } in across.iter().filter(|tick| tick.value != 0.0) {
            labels.write(text, font, [(pos2(*at, axis.y + 3.0), Align2::CENTER_TOP)]);
        }
        for Tick { at, text, .. } in up.iter().filter(|tick| tick.value != 0.0) {
            labels.write(text, font, [(pos2(axis.x - 5.0, *at), Align2::RIGHT_CENTER)]);
        }
    }

    fn implicit(&self, line: &ImplicitLine) {
        let middle = line.nearest_to(self.center());
        let along = self.reach() * line.direction().normalize_or_zero();
        self.line(middle - along, middle + along, Stroke::new(3.5, self.colors.mark), SOLID);
    }

    /// Labels the regions where f is positive, negative and 0.
    fn regions(&self, line: &ImplicitLine, labels: &mut LabelLayout) {
        let direction = line.direction().normalize_or_zero();
        let normal = direction.perp();
        let middle = line.nearest_to(self.center());
        // Positions along the line, as fractions. The first ones are tried first and are far from the
        // handles.
        let shares = [-0.72, 0.72, -0.55, 0.55, -0.9, 0.9, -0.35, 0.35, 0.0];
        let anchors = |points: f64, way: f64| {
            let half = 0.5 * f64::from(self.rect.height()) / self.unit();
            shares.map(|share| {
                let on_line = middle + way * share * half * direction;
                (self.to_screen(on_line + points / self.unit() * normal), Align2::CENTER_CENTER)
            })
        };
        let at_side = |side: f64| {
            [46.0, 80.0, 120.0].into_iter().flat_map(move |points| anchors(side * points, 1.0))
        };
        let font = |color| Font { size: REGIONS, color, bold: true };
        labels.write("𝑓 > 0", font(self.colors.basis[2]), at_side(1.0));
        labels.write("𝑓 < 0", font(self.colors.basis[0]), at_side(-1.0));
        let font = Font { size: NAMES, color: self.colors.mark, bold: true };
        // At the other end of the line: beside another label, the two would look like one formula.
        let [low, high] = [anchors(-26.0, -1.0), anchors(26.0, -1.0)];
        labels.write("𝑓 = 0", font, high.into_iter().chain(low));
    }

    /// Draws the parametric line, dashed before p and solid after p; then the points of its trail, unless it
    /// is `None`; then the vector d.
    fn parametric(&self, line: &ParametricLine, trail: Option<&LinesLab>) {
        let ray = self.colors.ray;
        let (first, last) = self.range_of_t(line);
        if first < 0.0 {
            let stroke = Stroke::new(2.0, ray.gamma_multiply(0.75));
            self.line(line.at(last.min(0.0)), line.at(first), stroke, [9.0, 7.2]);
        }
        if last > 0.0 {
            let stroke = Stroke::new(3.0, ray);
            self.line(line.at(first.max(0.0)), line.at(last), stroke, SOLID);
        }
        for (_, at) in trail.into_iter().flat_map(|lab| self.generated(lab)) {
            let stroke = Stroke::new(1.5, self.colors.background);
            self.painter.circle(self.to_screen(at), 5.5, ray, stroke);
        }
        self.direction(line);
    }

    /// Draws d as an arrow from p; the size of its head is in points.
    fn direction(&self, line: &ParametricLine) {
        let (ParametricLine { p, d }, ray) = (*line, self.colors.ray);
        let [from, to] = [p, p + d].map(|end| self.to_screen(end));
        let size = 26.0_f32.min(0.8 * from.distance(to));
        let head = size * (to - from).normalized();
        self.painter.line_segment([from, to - 0.7 * head], Stroke::new(6.0, ray));
        chart::arrowhead(&self.painter, to, head, ray);
    }

    /// Returns the visible points of the trail, each with its t. If there are too many, returns only every
    /// n-th one.
    fn generated(&self, lab: &LinesLab) -> impl Iterator<Item = (f64, DVec2)> {
        let (trail, (low, high)) = (lab.trail, self.range_of_t(&lab.ray));
        let (first, last) = (trail.first.max(low), trail.last.min(high));
        let every = ((last - first) / trail.step / MOST_POINTS as f64).ceil().max(1.0);
        lab.ray.generated(every * trail.step, first, last, MOST_POINTS)
    }

    /// Returns a range of t that contains every visible point of the parametric line.
    fn range_of_t(&self, ray: &ParametricLine) -> (f64, f64) {
        let middle = ray.nearest_t(self.center());
        let reach = self.reach() / ray.d.length();
        (middle - reach, middle + reach)
    }

    /// Writes t at each point of the trail that has room for it. Returns a description of these points.
    fn trail(&self, lab: &LinesLab, labels: &mut LabelLayout) -> String {
        let font = Font { size: SMALL, color: self.colors.ray, bold: false };
        let left = left_of(lab.ray.d);
        let points: Vec<(f64, DVec2)> = self.generated(lab).collect();
        let description = match points.as_slice() {
            [] => "no points".to_owned(),
            [(t, _)] => format!("a point at t {}", equated(*t, 5)),
            [(from, _), .., (to, _)] => {
                format!("points from t {} to t {}", equated(*from, 5), equated(*to, 5))
            }
        };
        let is_whole = |t: f64| t.fract() == 0.0;
        let (first, then): (Vec<_>, Vec<_>) = points.into_iter().partition(|(t, _)| is_whole(*t));
        for (t, at) in first.into_iter().chain(then) {
            labels.write(&number(t, 5), font, around(self.to_screen(at), left, 10.0).take(1));
        }
        description
    }

    /// Labels the two parts of the parametric line: t < 0 and t > 0.
    fn sides(&self, lab: &LinesLab, labels: &mut LabelLayout) {
        let direction = lab.ray.d.normalize_or_zero();
        let font = Font { size: SMALL + 2.0, color: self.colors.ray, bold: false };
        for (text, sign) in [("t < 0", -1.0), ("t > 0", 1.0)] {
            let anchors = (0..3).flat_map(|turn| {
                [120.0, 170.0, 220.0, 90.0].map(|points| {
                    let at = lab.ray.p + sign * points / self.unit() * direction;
                    around(self.to_screen(at), left_of(-lab.ray.d), 10.0).nth(turn)
                })
            });
            labels.write(text, font, anchors.flatten());
        }
    }

    /// Draws a cross at the point where the two lines meet, and writes its t.
    fn meeting(&self, lab: &LinesLab, labels: &mut LabelLayout, digits: usize) {
        let both = Substitution::new(lab.line(), lab.ray);
        let both = both.ok().filter(|_| lab.shown == ShownLines::Both && self.shows_meeting);
        let Some(Substitution { meeting: Meeting::At(crossing), .. }) = both else { return };
        let at = self.to_screen(crossing.point);
        if !self.rect.contains(at) {
            return;
        }
        for (width, color) in [(7.0, self.colors.background), (4.0, self.colors.ink)] {
            for side in [vec2(9.0, 9.0), vec2(9.0, -9.0)] {
                self.painter.line_segment([at - side, at + side], Stroke::new(width, color));
            }
        }
        labels.keep_free(Rect::from_center_size(at, Vec2::splat(18.0)));
        let result = if crossing.ray_hits { "ray hits" } else { "ray misses" };
        let text = format!("{result}: 𝑡 {}", equated(crossing.t, digits));
        let font = Font { size: NAMES, color: self.colors.ink, bold: true };
        let below = |distance| around(at, vec2(0.0, 1.0), distance);
        labels.write(&text, font, below(17.0).chain(below(30.0)));
        // No other label stands near enough to be about this point.
        labels.keep_free(Rect::from_center_size(at, Vec2::splat(48.0)));
    }

    /// Returns the position of a handle on the screen; `None` if it is outside the drawing.
    pub(crate) fn in_sight(&self, lab: &LinesLab, handle: LineHandle) -> Option<Pos2> {
        let at = self.to_screen(lab.position_of(handle)?);
        self.rect.expand(GRASP).contains(at).then_some(at)
    }

    fn handle(&self, handle: LineHandle, at: Pos2, is_held: bool) {
        let larger = if is_held { 1.3 } else { 1.0 };
        let (painter, Colors { ink, mark, ray, background: halo, .. }) =
            (&self.painter, self.colors);
        let (radius, fill, width, edge) = match handle {
            LineHandle::Move => {
                let square = Rect::from_center_size(at, Vec2::splat(15.0 * larger));
                painter.rect(square, 2.0, *mark, (2.0, *halo), StrokeKind::Outside);
                return;
            }
            LineHandle::Turn => (8.0 * larger, *halo, 4.0, *mark),
            LineHandle::P => (8.0 * larger, *ray, 2.0, *halo),
            LineHandle::Tip if is_held => (12.0, Color32::TRANSPARENT, 2.0, *ray),
            LineHandle::Tip => return,
            LineHandle::T => (7.0 * larger, *ink, 3.0, *ray),
        };
        painter.circle(at, radius, fill, Stroke::new(width, edge));
    }

    /// Writes the names of p and d at their handles, and t with this number of digits; `None` leaves t out.
    fn names(&self, lab: &LinesLab, labels: &mut LabelLayout, digits: Option<usize>) {
        let right = -left_of(lab.ray.d);
        let of_ray = Font { size: NAMES + 1.0, color: self.colors.ray, bold: true };
        let of_t = Font { size: NAMES, color: self.colors.ink, bold: false };
        let t = digits.map(|digits| format!("t {}", equated(lab.t, digits))).unwrap_or_default();
        for (handle, text, font, toward) in [
            // To the left of d, and towards its tail.
            (LineHandle::P, "p", of_ray, -right.rot90() - right),
            (LineHandle::T, t.as_str(), of_t, right),
            (LineHandle::Tip, "d", of_ray, right),
        ] {
            if let Some(position) = lab.position_of(handle).filter(|_| !text.is_empty()) {
                labels.write(text, font, around(self.to_screen(position), toward, 13.0));
            }
        }
    }
}

/// Returns the direction to the left of d on the screen, where y grows downwards.
fn left_of(d: DVec2) -> Vec2 {
    let d = d.normalize_or_zero();
    -vec2(d.y as f32, d.x as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::lines::state::LinesLab;

    fn said(example: usize) -> (Vec<String>, String) {
        let (_, lab) = &LinesLab::examples()[example];
        let s = Substitution::new(lab.line(), lab.ray).expect("two lines");
        let lines = steps(&s, lab.shown, 5).into_iter().map(|(_, text)| text).collect();
        (lines, verdict(&s, 5))
    }

    #[test]
    fn a_ray_that_misses_line_by_line() {
        let (lines, verdict) = said(1);
        assert_eq!(
            lines,
            [
                "f(x, y) = 2 x − y + 1",
                "x = t,  y = t",
                "f(p + t d)  = 2 t − t + 1",
                "= (2·1 − 1·1) t  + (2·0 − 1·0 + 1)",
                "= t + 1",
                "t = −1",
            ]
        );
        assert_eq!(verdict, "They meet at t = −1, at (−1, −1). t < 0, behind p: the ray misses.");
    }

    #[test]
    fn rounded_numbers_are_not_called_equal() {
        let ray = ParametricLine { p: DVec2::new(1.0, 0.0), d: DVec2::new(-1.0, 1.0 / 3.0) };
        let s =
            Substitution::new(ImplicitLine { a: 3.0, b: -1.0, c: 0.0 }, ray).expect("two lines");
        let lines: Vec<String> =
            steps(&s, ShownLines::Both, 5).into_iter().map(|(_, text)| text).collect();
        assert_eq!(
            lines,
            [
                "f(x, y) = 3 x − y",
                "x = 1 − t,  y ≈ 0.33333 t",
                "f(p + t d)  ≈ 3 (1 − t) − 0.33333 t",
                "≈ (3·(−1) − 1·0.33333) t  + (3·1 − 1·0)",
                "≈ −3.3333 t + 3",
                "t ≈ −3 / (−3.3333) = 0.9",
            ]
        );
    }

    #[test]
    fn the_other_verdicts() {
        assert_eq!(said(0).1, "They meet at t = 1, at (1, 1). t > 0: the ray hits.");
        let (lines, verdict) = said(2);
        assert_eq!(lines[5], "0 t = −2: for no t");
        assert_eq!(verdict, "Parallel: f(p + t d) is 2 at every t, never 0. They never meet.");
        let (lines, verdict) = said(3);
        assert_eq!(lines[2], "f(p + t d)  = (−2 + 2 t) − 2 t + 2");
        assert_eq!(lines[4], "= 0");
        assert_eq!(verdict, "Coincident: f(p + t d) is 0 at every t. Both are the same line.");
    }
}
