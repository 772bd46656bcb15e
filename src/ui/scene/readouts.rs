//! The numbers: the basis, the selected ray, and all its intersections. All of them can be selected
//! and copied.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Grid, Label, Response, RichText, ScrollArea, Ui};
use pinhole_core::{DVec3, Pixel, ResolvedCamera, Steps, UpAngle, shortest};
use pinhole_exchange::document::Document;

use super::pointed_number;
use crate::model::inspection::{Inspection, LISTED_OBJECTS, ObjectTerms};
use crate::model::number::written;
use crate::model::session::Settings;
use crate::model::symbols::{Kind, meaning, meaning_of_readout};
use crate::ui::widgets::fault::fault_text;
use crate::ui::widgets::number::vector_color;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;
use crate::view::typesetting::fonts;
use crate::view::typesetting::notation::{self, formula};

/// The number format.
#[derive(Clone, Copy)]
pub(crate) struct NumberStyle {
    /// Number of significant digits.
    pub digits: usize,
    /// True if rows and columns are counted from 1, as in the course.
    pub count_from_one: bool,
    /// True for all digits and the minus sign that programs read: for the clipboard.
    pub exact: bool,
}

impl NumberStyle {
    /// The format that the settings ask for.
    pub(crate) fn new(settings: &Settings) -> NumberStyle {
        NumberStyle {
            digits: settings.digits,
            count_from_one: settings.count_from_one,
            exact: false,
        }
    }

    fn for_programs(self) -> NumberStyle {
        NumberStyle { exact: true, ..self }
    }

    pub(crate) fn number(self, x: f64) -> String {
        if self.exact && x.is_finite() {
            return shortest(x);
        }
        written(x, self.digits)
    }

    pub(crate) fn vector(self, v: DVec3) -> String {
        format!("({}, {}, {})", self.number(v.x), self.number(v.y), self.number(v.z))
    }

    pub(super) fn pixel(self, pixel: Pixel) -> String {
        let from = u32::from(self.count_from_one);
        let counted = if self.count_from_one { " (from 1)" } else { "" };
        format!("row {}, column {}{counted}", pixel.row + from, pixel.column + from)
    }
}

/// Minimum width of the hits, in points.
const HITS: f32 = 280.0;

/// Shows the three blocks side by side.
pub(crate) fn ui(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    if let Some(fault) = derived.fault {
        ui.label(fault_text(ui, fault).strong());
    }
    ScrollArea::vertical().id_salt("readouts scrolled").auto_shrink(false).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            // As wide as the widest numbers, so that nothing moves sideways while they change.
            let vector = 3.0 * (style.digits as f32 + 4.6) * 7.0;
            let block = |ui: &mut Ui, names: f32, content: &mut dyn FnMut(&mut Ui)| {
                ui.vertical(|ui| {
                    ui.set_width(names + vector);
                    content(ui);
                });
                ui.separator();
            };
            // Without room for three columns, the ray is shown below the basis.
            let is_narrow = ui.available_width() < 160.0 + 2.0 * vector + HITS;
            let seen = derived.inspection.as_ref().zip(derived.resolved.as_ref());
            if let Some(resolved) = &derived.resolved {
                block(ui, 110.0, &mut |ui| {
                    basis(ui, resolved, derived.up_angle, style);
                    if let Some(steps) = derived.steps {
                        ui.weak(self::steps(steps)).on_hover_text(STEPS);
                    }
                    if let (true, Some((inspection, resolved))) = (is_narrow, seen) {
                        ui.add_space(6.0);
                        ray(ui, inspection, resolved, style);
                    }
                });
            }
            if let Some((inspection, resolved)) = seen {
                if !is_narrow {
                    block(ui, 50.0, &mut |ui| ray(ui, inspection, resolved, style));
                }
                ui.vertical(|ui| hits(ui, inspection, derived, document, style));
            }
        });
    });
}

/// The meaning of that text.
pub(crate) const STEPS: &str = "How often the picture had to decide whether a ray hits, and how \
                                exactly: f64 has 16 digits, double-double 32";

/// Returns the text about the steps of the ladder that the picture needed.
pub(crate) fn steps(steps: Steps) -> String {
    let [f64, double_double, exact] = [steps.f64, steps.double_double, steps.exact];
    if steps.beyond_f64() == 0 {
        return format!("Hit or miss: {f64} decisions, all in f64");
    }
    format!("Hit or miss: {f64} decisions in f64, {double_double} in double-double, {exact} exact")
}

/// Shows a block's title with a button that copies its lines.
fn title(ui: &mut Ui, text: &str, lines: impl FnOnce() -> String) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(text).strong());
        if ui.small_button("Copy").named(format!("Copy {text}")).clicked() {
            ui.ctx().copy_text(lines());
        }
    });
}

/// Names of vectors, which are bold. Other names are typeset as formulas.
const VECTORS: [&str; 7] = ["u", "v", "w", "p", "d", "point", "normal"];

/// Lays out a name, in the vector's own colour if the views show the vector.
pub(super) fn name_of(ui: &Ui, name: &str, strong: bool, size: f32) -> LayoutJob {
    let visuals = ui.visuals();
    let plain = if strong { visuals.strong_text_color() } else { visuals.text_color() };
    if !VECTORS.contains(&name) {
        return formula(name, size, plain);
    }
    let color = vector_color(ui, name).unwrap_or(plain);
    LayoutJob::simple_singleline(name.to_owned(), FontId::new(size, fonts::bold()), color)
}

/// Shows a line `name = value`.
fn line(ui: &mut Ui, name: &'static str, value: String) {
    let size = egui::TextStyle::Body.resolve(ui.style()).size;
    let label = ui.label(name_of(ui, name, true, size));
    pointed_number::point(&label, name);
    if let Some(words) = meaning_of_readout(name) {
        label.on_hover_text(words);
    }
    let label = ui.label(RichText::new(format!("= {value}")));
    pointed_number::point(&label, name);
    label.spoken(format!("{name} = {value}"));
    ui.end_row();
}

fn basis_lines(
    resolved: &ResolvedCamera,
    angle: Option<UpAngle>,
    style: NumberStyle,
) -> Vec<(&'static str, String)> {
    let basis = resolved.basis();
    let mut lines = vec![
        ("u", style.vector(basis.u)),
        ("v", style.vector(basis.v)),
        ("w", style.vector(basis.w)),
    ];
    if let Some(angle) = angle {
        lines.push(("angle(up, view)", degrees(angle, style)));
        lines.push(("sensitivity", style.number(angle.conditioning)));
    }
    lines
}

/// Returns the angle in degrees. Where there is a camera, it is below 180, so what is rounded to that
/// is told by what is missing.
fn degrees(UpAngle { angle, conditioning }: UpAngle, style: NumberStyle) -> String {
    let text = style.number(angle.to_degrees());
    if text != style.number(180.0) {
        return format!("{text}°");
    }
    let missing = (1.0 / conditioning).asin().to_degrees();
    format!("180° − {}°", style.number(missing))
}

/// Shows a remark with typeset formulas.
fn weak(ui: &mut Ui, text: &str) -> Response {
    let size = egui::TextStyle::Body.resolve(ui.style()).size;
    notation::label(ui, text, size, ui.visuals().weak_text_color())
}

fn joined(lines: &[(&str, String)]) -> String {
    lines.iter().map(|(name, value)| format!("{name} = {value}\n")).collect()
}

fn basis(ui: &mut Ui, resolved: &ResolvedCamera, angle: Option<UpAngle>, style: NumberStyle) {
    let lines = basis_lines(resolved, angle, style);
    title(ui, "Basis", || joined(&basis_lines(resolved, angle, style.for_programs())));
    Grid::new("basis").num_columns(2).show(ui, |ui| {
        for (name, value) in lines {
            line(ui, name, value);
        }
    });
    if let Some(UpAngle { conditioning, .. }) = angle {
        let text = if conditioning < 1.5 {
            "up and view are well apart".to_owned()
        } else {
            let roll = style.number(conditioning);
            format!("{roll}° of roll for each degree that up is tipped sideways, for small angles")
        };
        ui.weak(text);
    }
}

fn ray_lines(
    inspection: &Inspection,
    resolved: &ResolvedCamera,
    style: NumberStyle,
) -> Vec<(&'static str, String)> {
    let position = match inspection.image_position {
        None => "outside the image".to_owned(),
        Some(position) => match inspection.pixel() {
            Some(pixel) => style.pixel(pixel),
            None => match position.touching(resolved.image()).len() {
                4 => "the corner of four pixels".to_owned(),
                _ => "on an edge between pixels".to_owned(),
            },
        },
    };
    let (u, v) = (style.number(inspection.uv.x), style.number(inspection.uv.y));
    let length = inspection.ray.distance_along(1.0);
    vec![
        ("pixel", position),
        ("(u, v)", format!("({u}, {v})")),
        ("p", style.vector(inspection.ray.origin)),
        ("d", style.vector(inspection.ray.direction)),
        ("|d|", style.number(length)),
    ]
}

fn ray(ui: &mut Ui, inspection: &Inspection, resolved: &ResolvedCamera, style: NumberStyle) {
    let lines = ray_lines(inspection, resolved, style);
    title(ui, "Ray", || joined(&ray_lines(inspection, resolved, style.for_programs())));
    Grid::new("ray").num_columns(2).show(ui, |ui| {
        for (name, value) in lines {
            line(ui, name, value);
        }
    });
    weak(ui, "p + t d, t = 1 on the viewport");
}

/// The lines of one root.
struct RootLines {
    object: String,
    verdict: &'static str,
    numbers: [(&'static str, String); 4],
}

impl RootLines {
    fn new(
        index: usize,
        inspection: &Inspection,
        document: &Document,
        style: NumberStyle,
    ) -> RootLines {
        let root = &inspection.roots[index];
        RootLines {
            object: document.title_of(root.object as usize),
            verdict: inspection.verdict(index),
            numbers: [
                ("t", style.number(root.t)),
                ("distance", style.number(inspection.distances[index])),
                ("point", style.vector(root.point)),
                ("normal", style.vector(root.normal)),
            ],
        }
    }

    fn joined(&self) -> String {
        let numbers = self.numbers.each_ref().map(|(name, value)| format!("{name} = {value}"));
        format!("{}\t{}\t{}\n", self.object, numbers.join("\t"), self.verdict)
    }

    fn show(&self, ui: &mut Ui, first: bool) {
        let visuals = ui.visuals();
        let color = if first { visuals.strong_text_color() } else { visuals.text_color() };
        let font = egui::TextStyle::Body.resolve(ui.style());
        let text = |text: &str| if first { RichText::new(text).strong() } else { text.into() };
        ui.horizontal_wrapped(|ui| {
            ui.label(text(&self.object));
            notation::label(ui, self.verdict, font.size, color);
        });
        ui.horizontal_wrapped(|ui| {
            ui.add_space(12.0);
            for (name, value) in &self.numbers {
                let mut job = name_of(ui, name, first, font.size);
                let format = TextFormat::simple(font.clone(), color);
                job.append(&format!(" = {value}"), 0.0, format);
                let response = ui.add(Label::new(job).extend());
                let response = response.spoken(format!("{name} = {value}"));
                if let Some(words) = meaning_of_readout(name) {
                    response.on_hover_text(words);
                }
            }
        });
    }
}

fn hits(
    ui: &mut Ui,
    inspection: &Inspection,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) {
    let roots: Vec<RootLines> = (0..inspection.roots.len())
        .map(|index| RootLines::new(index, inspection, document, style))
        .collect();
    title(ui, "Hits", || copied_hits(inspection, derived, document, style.for_programs()));
    if roots.is_empty() {
        ui.label("The ray meets nothing.");
    }
    for (index, root) in roots.iter().enumerate() {
        root.show(ui, inspection.first == Some(index));
    }
    ui.add_space(4.0);
    for (title, parts) in listed_parts(inspection, derived, document, style) {
        ui.horizontal_wrapped(|ui| {
            ui.weak(format!("{title}:"));
            let response = weak(ui, &parts);
            if let Some(words) = parts.contains("D =").then(|| meaning(Kind::Scalar, "D")).flatten()
            {
                response.on_hover_text(words);
            }
        });
    }
}

/// Returns the numbers that decide hit or miss, for each object if the objects are few.
fn listed_parts(
    inspection: &Inspection,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) -> Vec<(String, String)> {
    let scene = derived.scene.as_deref().filter(|scene| scene.len() <= LISTED_OBJECTS);
    let listed = scene.into_iter().flat_map(|_| inspection.terms.iter().enumerate());
    listed.map(|(index, found)| (document.title_of(index), terms(found, style))).collect()
}

fn copied_hits(
    inspection: &Inspection,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) -> String {
    let roots = (0..inspection.roots.len())
        .map(|index| RootLines::new(index, inspection, document, style).joined());
    let parts = listed_parts(inspection, derived, document, style);
    roots.chain(parts.into_iter().map(|(title, parts)| format!("{title}:  {parts}\n"))).collect()
}

/// Returns the numbers that decide hit or miss for one object.
fn terms(found: &ObjectTerms, style: NumberStyle) -> String {
    let number = |x| style.number(x);
    match found {
        ObjectTerms::Sphere(q) => {
            let (a, b, c, d) = (number(q.a), number(q.b), number(q.c), number(q.discriminant));
            let meaning = match q.discriminant {
                d if d < 0.0 => "< 0: missed",
                0.0 => ": tangent",
                _ => "> 0: two roots",
            };
            format!("a = {a},  b = {b},  c = {c},  D = b² − a c = {d} {meaning}")
        }
        ObjectTerms::Plane(terms) => {
            let (rate, offset) = (number(terms.rate), number(terms.offset));
            let meaning = if terms.rate == 0.0 { ": parallel, no hit" } else { "" };
            format!("n·d = {rate},  n·(point − p) = {offset}{meaning}")
        }
    }
}
