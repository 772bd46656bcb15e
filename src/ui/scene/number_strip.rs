//! The strip of numbers below the views: the basis, the selected ray and its first hit, in one line.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Label, TextStyle, Ui};
use pinhole_exchange::document::Document;

use super::pointed_number;
use super::readouts::{self, NumberStyle};
use crate::model::inspection::Inspection;
use crate::model::session::presenting::WRITTEN;
use crate::model::symbols::meaning_of_readout;
use crate::ui::widgets::fault::fault_text;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;

/// Returns the height of the strip with the sentence and the buttons below it, in points.
pub(crate) fn height(width: f32) -> f32 {
    if is_narrow(width) { 92.0 } else { 66.0 }
}

/// Height of the strip while presenting, in points: two rows.
pub(crate) const PRESENTED: f32 = 48.0;

/// Maximum number of significant digits: more do not fit in a line.
const DIGITS: usize = 4;
/// Sizes of the text while presenting, in points: the largest at which a row has room.
const PRESENTED_SIZES: [f32; 3] = [16.0, 14.0, WRITTEN];

/// Shows the strip, as large and with as many digits as there is room for.
pub(crate) fn ui(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    if let Some(fault) = derived.fault {
        ui.label(fault_text(ui, fault).strong());
        return;
    }
    let size = TextStyle::Body.resolve(ui.style()).size;
    let rows = |digits: usize| -> Vec<Numbers> {
        let style = NumberStyle { digits: style.digits.min(digits), ..style };
        let [basis, ray] = numbers(derived, document, style);
        let ray = ray.into_iter().filter(|(name, _)| *name != "d");
        match is_narrow(ui.available_width()) {
            true => vec![basis, ray.collect()],
            false => vec![basis.into_iter().chain(ray).collect()],
        }
    };
    let choices = [(DIGITS, size + 1.0), (DIGITS, size - 1.0), (DIGITS - 1, size - 1.0)];
    let fits = |&(digits, size): &(usize, f32)| {
        rows(digits).iter().all(|row| width(ui, row, size) <= ui.available_width())
    };
    let (digits, size) = choices.into_iter().find(fits).unwrap_or(choices[2]);
    for row in rows(digits) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP * size;
            for (name, value) in row {
                number(ui, name, &value, size);
            }
        });
    }
}

/// Returns true if the strip needs two rows.
fn is_narrow(width: f32) -> bool {
    width < 780.0
}

/// Returns the width of a line of numbers with text of this size.
fn width(ui: &Ui, line: &Numbers, size: f32) -> f32 {
    let laid = line.iter().map(|(name, value)| {
        ui.painter().layout_job(written(ui, name, value, size)).size().x + GAP * size
    });
    laid.sum()
}

/// Shows the strip before an audience: the basis in one row, the ray in the other. The reason why there
/// are no numbers stands on the picture.
pub(crate) fn presented(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    if derived.fault.is_some() {
        return;
    }
    let style = NumberStyle { digits: style.digits.min(DIGITS), ..style };
    ui.spacing_mut().item_spacing.y = 0.0;
    for row in numbers(derived, document, style) {
        let fits = |size: &f32| width(ui, &row, *size) <= ui.available_width();
        let size = PRESENTED_SIZES.into_iter().find(fits).unwrap_or(WRITTEN);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP * size;
            ui.set_height(0.5 * PRESENTED);
            for (name, value) in row {
                number(ui, name, &value, size);
            }
        });
    }
}

/// Distance between two numbers, as a share of the text's size.
const GAP: f32 = 1.2;

/// Names and values.
type Numbers = Vec<(&'static str, String)>;

/// Returns the numbers of the basis, and those of the ray up to its hit.
fn numbers(derived: &Derived, document: &Document, style: NumberStyle) -> [Numbers; 2] {
    let Some(resolved) = &derived.resolved else { return Default::default() };
    let basis = resolved.basis();
    let vectors = [("u", basis.u), ("v", basis.v), ("w", basis.w)];
    let basis = vectors.map(|(name, vector)| (name, style.vector(vector))).to_vec();
    let Some(inspection) = &derived.inspection else { return [basis, Vec::new()] };
    let uv = inspection.uv;
    let mut ray = vec![
        ("(u, v)", format!("({}, {})", style.number(uv.x), style.number(uv.y))),
        ("d", style.vector(inspection.ray.direction)),
    ];
    match inspection.first_hit() {
        Some(hit) => {
            ray.push(("t", style.number(hit.t)));
            ray.push(("hit", document.title_of(hit.object as usize)));
        }
        None => ray.push(("hit", "nothing".to_owned())),
    }
    [basis, ray]
}

/// Returns the numbers of a ray in two lines: its pixel and (u, v); what it hits and where.
pub(crate) fn ray_text(inspection: &Inspection, document: &Document, style: NumberStyle) -> String {
    let style = NumberStyle { digits: style.digits.min(DIGITS), ..style };
    let (u, v) = (style.number(inspection.uv.x), style.number(inspection.uv.y));
    let pixel = inspection.pixel().map(|pixel| format!("{}   ", style.pixel(pixel)));
    let hit = match inspection.first_hit() {
        Some(hit) => {
            format!("{}   𝑡 = {}", document.title_of(hit.object as usize), style.number(hit.t))
        }
        None => "hits nothing".to_owned(),
    };
    format!("{}(𝑢, 𝑣) = ({u}, {v})\n{hit}", pixel.unwrap_or_default())
}

/// Lays out `name = value`.
fn written(ui: &Ui, name: &str, value: &str, size: f32) -> LayoutJob {
    let mut job = readouts::name_of(ui, name, true, size);
    let text = TextFormat::simple(FontId::proportional(size), ui.visuals().strong_text_color());
    job.append(&format!(" = {value}"), 0.0, text);
    job
}

/// Shows `name = value`, the name in the colour that the views give it.
fn number(ui: &mut Ui, name: &'static str, value: &str, size: f32) {
    let label = ui
        .add(Label::new(written(ui, name, value, size)).extend())
        .spoken(format!("{name} = {value}"));
    pointed_number::point(&label, name);
    if let Some(words) = meaning_of_readout(name) {
        label.on_hover_text(words);
    }
}
