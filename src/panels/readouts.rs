//! The numbers: the basis, the selected ray, and everything that the ray meets. All of it can be
//! selected and copied.

use egui::{Grid, Label, RichText, ScrollArea, Ui};
use pinhole_core::{DVec3, Pixel, PosedCamera, Root, Steps, UpAngle, shortest};

use super::number::{error_color, vector_color};
use crate::derive::Derived;
use crate::document::Document;
use crate::inspection::{Inspection, LISTED_OBJECTS, Parts};
use crate::number::written;

/// How numbers are written.
#[derive(Clone, Copy)]
pub(crate) struct NumberStyle {
    /// Significant digits.
    pub digits: usize,
    /// Rows and columns counted from 1, as the course does.
    pub count_from_one: bool,
    /// Every digit, and the minus sign that programs read: for the clipboard.
    pub exact: bool,
}

impl NumberStyle {
    fn for_programs(self) -> NumberStyle {
        NumberStyle { exact: true, ..self }
    }

    pub(super) fn number(self, x: f64) -> String {
        if self.exact && x.is_finite() {
            return shortest(x);
        }
        written(x, self.digits)
    }

    pub(super) fn vector(self, v: DVec3) -> String {
        format!("({}, {}, {})", self.number(v.x), self.number(v.y), self.number(v.z))
    }

    fn pixel(self, pixel: Pixel) -> String {
        let from = u32::from(self.count_from_one);
        format!("row {}, column {}", pixel.row + from, pixel.column + from)
    }
}

/// Shows the three blocks side by side.
pub(crate) fn ui(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    if let Some(fault) = derived.fault {
        ui.label(RichText::new(fault.to_string()).strong().color(error_color(ui)));
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            // As wide as the widest numbers: nothing moves sideways while they change.
            let vector = 3.0 * (style.digits as f32 + 4.6) * 7.0;
            let block = |ui: &mut Ui, names: f32, content: &mut dyn FnMut(&mut Ui)| {
                ui.vertical(|ui| {
                    ui.set_width(names + vector);
                    content(ui);
                });
                ui.separator();
            };
            if let Some(posed) = &derived.posed {
                block(ui, 110.0, &mut |ui| {
                    basis(ui, posed, derived.up_angle, style);
                    if let Some(steps) = derived.steps {
                        ui.weak(self::steps(steps));
                    }
                });
            }
            if let (Some(inspection), Some(posed)) = (&derived.inspection, &derived.posed) {
                block(ui, 50.0, &mut |ui| ray(ui, inspection, posed, style));
                ui.vertical(|ui| hits(ui, inspection, derived, document, style));
            }
        });
    });
}

/// How far up the ladder the picture had to go.
pub(crate) fn steps(steps: Steps) -> String {
    let Steps { f64, double_double, exact } = steps;
    if steps.beyond_f64() == 0 {
        return format!("Decisions in the picture: {f64}, all by f64");
    }
    format!(
        "Decisions in the picture: {f64} by f64, {double_double} by double-double, {exact} exactly"
    )
}

/// A block's title with a button that copies its lines.
fn title(ui: &mut Ui, text: &str, lines: impl FnOnce() -> String) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(text).strong());
        let copy = ui.small_button("Copy");
        ui.ctx().accesskit_node_builder(copy.id, |node| node.set_label(format!("Copy {text}")));
        if copy.clicked() {
            ui.ctx().copy_text(lines());
        }
    });
}

/// One line `name = value`, the name in the vector's own colour.
fn line(ui: &mut Ui, name: &str, value: String) {
    let color = vector_color(ui, name);
    let name_text = RichText::new(name).strong();
    ui.label(match color {
        Some(color) => name_text.color(color),
        None => name_text,
    });
    let response = ui.label(RichText::new(format!("= {value}")));
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_value(format!("{name} = {value}")));
    ui.end_row();
}

fn basis_lines(
    posed: &PosedCamera,
    angle: Option<UpAngle>,
    style: NumberStyle,
) -> Vec<(&'static str, String)> {
    let basis = posed.basis();
    let mut lines = vec![
        ("u", style.vector(basis.u)),
        ("v", style.vector(basis.v)),
        ("w", style.vector(basis.w)),
    ];
    if let Some(UpAngle { angle, conditioning }) = angle {
        lines.push(("angle(up, view)", format!("{}°", style.number(angle.to_degrees()))));
        lines.push(("conditioning", style.number(conditioning)));
    }
    lines
}

fn joined(lines: &[(&str, String)]) -> String {
    lines.iter().map(|(name, value)| format!("{name} = {value}\n")).collect()
}

fn basis(ui: &mut Ui, posed: &PosedCamera, angle: Option<UpAngle>, style: NumberStyle) {
    let lines = basis_lines(posed, angle, style);
    title(ui, "Basis", || joined(&basis_lines(posed, angle, style.for_programs())));
    Grid::new("basis").num_columns(2).show(ui, |ui| {
        for (name, value) in lines {
            line(ui, name, value);
        }
    });
    if let Some(UpAngle { conditioning, .. }) = angle {
        let text = if conditioning < 1.5 {
            "up is well away from view".to_owned()
        } else {
            format!("1° of up tipped sideways rolls the camera {}°", style.number(conditioning))
        };
        ui.weak(text);
    }
}

fn ray_lines(
    inspection: &Inspection,
    posed: &PosedCamera,
    style: NumberStyle,
) -> Vec<(&'static str, String)> {
    let place = match inspection.place {
        None => "outside the image".to_owned(),
        Some(place) => match inspection.pixel() {
            Some(pixel) => style.pixel(pixel),
            None => match place.touching(posed.image()).len() {
                4 => "the corner of four pixels".to_owned(),
                _ => "on the edge between pixels".to_owned(),
            },
        },
    };
    let (u, v) = (style.number(inspection.uv.x), style.number(inspection.uv.y));
    let length = inspection.ray.distance_along(1.0);
    vec![
        ("pixel", place),
        ("(u, v)", format!("({u}, {v})")),
        ("p", style.vector(inspection.ray.origin)),
        ("d", style.vector(inspection.ray.direction)),
        ("|d|", style.number(length)),
    ]
}

fn ray(ui: &mut Ui, inspection: &Inspection, posed: &PosedCamera, style: NumberStyle) {
    let lines = ray_lines(inspection, posed, style);
    title(ui, "Ray", || joined(&ray_lines(inspection, posed, style.for_programs())));
    Grid::new("ray").num_columns(2).show(ui, |ui| {
        for (name, value) in lines {
            line(ui, name, value);
        }
    });
    ui.weak("p + t d, t = 1 on the viewport");
}

/// Why a root is, or is not, the first hit.
fn verdict(root: &Root, index: usize, inspection: &Inspection) -> &'static str {
    match inspection.first {
        Some(first) if first == index => "first: smallest t > 0",
        _ if root.t < 0.0 => "behind the eye",
        _ if root.t == 0.0 => "at the eye: no hit",
        Some(first) if inspection.roots[first].t == root.t => "same t, listed later",
        _ => "farther",
    }
}

/// What is said of one root.
struct RootLines {
    object: String,
    verdict: &'static str,
    numbers: [(&'static str, String); 4],
}

impl RootLines {
    fn new(
        index: usize,
        root: &Root,
        inspection: &Inspection,
        document: &Document,
        style: NumberStyle,
    ) -> RootLines {
        RootLines {
            object: document.title_of(root.object as usize),
            verdict: verdict(root, index, inspection),
            numbers: [
                ("t", style.number(root.t)),
                ("distance", style.number(inspection.ray.distance_along(root.t))),
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
        let text = |text: &str| if first { RichText::new(text).strong() } else { text.into() };
        ui.horizontal_wrapped(|ui| {
            ui.label(text(&self.object));
            ui.label(text(self.verdict));
        });
        ui.horizontal_wrapped(|ui| {
            ui.add_space(12.0);
            for (name, value) in &self.numbers {
                ui.add(Label::new(text(&format!("{name} = {value}"))).extend());
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
    let roots: Vec<RootLines> = (inspection.roots.iter().enumerate())
        .map(|(index, root)| RootLines::new(index, root, inspection, document, style))
        .collect();
    title(ui, "Hits", || copied_hits(inspection, derived, document, style.for_programs()));
    if roots.is_empty() {
        ui.label("The ray meets nothing.");
    }
    for (index, root) in roots.iter().enumerate() {
        root.show(ui, inspection.first == Some(index));
    }
    ui.add_space(4.0);
    for line in listed_parts(inspection, derived, document, style) {
        ui.weak(line);
    }
}

/// The numbers that decide, of each object where they are few.
fn listed_parts(
    inspection: &Inspection,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) -> Vec<String> {
    let scene = derived.scene.as_deref().filter(|scene| scene.len() <= LISTED_OBJECTS);
    let listed = scene.into_iter().flat_map(|_| inspection.parts.iter().enumerate());
    listed.map(|(index, of)| parts(&document.title_of(index), of, style)).collect()
}

fn copied_hits(
    inspection: &Inspection,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) -> String {
    let roots = (inspection.roots.iter().enumerate())
        .map(|(index, root)| RootLines::new(index, root, inspection, document, style).joined());
    let parts = listed_parts(inspection, derived, document, style);
    roots.chain(parts.into_iter().map(|line| line + "\n")).collect()
}

/// The numbers that decide hit or miss for one object.
fn parts(title: &str, of: &Parts, style: NumberStyle) -> String {
    let number = |x| style.number(x);
    match of {
        Parts::Sphere(q) => {
            let (a, b, c, d) = (number(q.a), number(q.b), number(q.c), number(q.discriminant));
            let meaning = match q.discriminant {
                d if d < 0.0 => "< 0: missed",
                0.0 => ": tangent",
                _ => "> 0: two roots",
            };
            format!("{title}:  a = {a},  b = {b},  c = {c},  D = b² − ac = {d} {meaning}")
        }
        Parts::Plane(terms) => {
            let (rate, offset) = (number(terms.rate), number(terms.offset));
            let meaning = if terms.rate == 0.0 { ": parallel, no hit" } else { "" };
            format!("{title}:  n·d = {rate},  n·(point − p) = {offset}{meaning}")
        }
    }
}
