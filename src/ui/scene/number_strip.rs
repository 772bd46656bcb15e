//! The strip of numbers below the views: the basis, the selected ray and its first hit, in one line.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Label, Ui};
use pinhole_exchange::document::Document;

use super::readouts::{self, NumberStyle};
use crate::model::inspection::Inspection;
use crate::model::symbols::meaning_of_readout;
use crate::ui::widgets::fault::fault_text;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;

/// Maximum number of significant digits: more do not fit in a line.
const DIGITS: usize = 4;

/// Shows the strip with text of this size.
pub(crate) fn ui(
    ui: &mut Ui,
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
    size: f32,
) {
    if let Some(fault) = derived.fault {
        ui.label(fault_text(ui, fault).strong());
        return;
    }
    let style = NumberStyle { digits: style.digits.min(DIGITS), ..style };
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 1.2 * size;
        for (name, value) in numbers(derived, document, style) {
            number(ui, name, &value, size);
        }
    });
}

/// Returns the names and values, from the basis to the hit.
fn numbers(
    derived: &Derived,
    document: &Document,
    style: NumberStyle,
) -> Vec<(&'static str, String)> {
    let Some(resolved) = &derived.resolved else { return Vec::new() };
    let basis = resolved.basis();
    let mut numbers = vec![
        ("u", style.vector(basis.u)),
        ("v", style.vector(basis.v)),
        ("w", style.vector(basis.w)),
    ];
    let Some(inspection) = &derived.inspection else { return numbers };
    let uv = inspection.uv;
    numbers.push(("(u, v)", format!("({}, {})", style.number(uv.x), style.number(uv.y))));
    numbers.push(("d", style.vector(inspection.ray.direction)));
    match inspection.first_hit() {
        Some(hit) => {
            numbers.push(("t", style.number(hit.t)));
            numbers.push(("hit", document.title_of(hit.object as usize)));
        }
        None => numbers.push(("hit", "nothing".to_owned())),
    }
    numbers
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

/// Shows `name = value`, the name in the colour that the views give it.
fn number(ui: &mut Ui, name: &str, value: &str, size: f32) {
    let mut job: LayoutJob = readouts::name_of(ui, name, true, size);
    let text = TextFormat::simple(FontId::proportional(size), ui.visuals().strong_text_color());
    job.append(&format!(" = {value}"), 0.0, text);
    let label = ui.add(Label::new(job).extend()).spoken(format!("{name} = {value}"));
    if let Some(words) = meaning_of_readout(name) {
        label.on_hover_text(words);
    }
}
