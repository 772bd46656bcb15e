//! The strip of numbers below the views: the basis, the selected ray and its first hit, in one line.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Label, Ui};
use pinhole_exchange::document::Document;

use super::pointed_number;
use super::readouts::{self, NumberStyle};
use crate::model::inspection::Inspection;
use crate::model::session::presenting::WRITTEN;
use crate::model::symbols::meaning_of_readout;
use crate::ui::widgets::fault::fault_text;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;

/// Height of the strip with the sentence and the buttons below it, in points.
pub(crate) const WITH_BUTTONS: f32 = 66.0;
/// Height of the strip while presenting, in points: two rows.
pub(crate) const PRESENTED: f32 = 44.0;

/// Maximum number of significant digits: more do not fit in a line.
const DIGITS: usize = 4;
/// Sizes of the text while presenting, in points: the largest at which a row has room.
const PRESENTED_SIZES: [f32; 3] = [16.0, 14.0, WRITTEN];

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
    let [basis, ray] = numbers(derived, document, style);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = GAP * size;
        for (name, value) in basis.into_iter().chain(ray) {
            number(ui, name, &value, size);
        }
    });
}

/// Shows the strip before an audience: the basis in one row, the ray in the other. The reason why there
/// are no numbers stands on the picture.
pub(crate) fn presented(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    if derived.fault.is_some() {
        return;
    }
    for row in numbers(derived, document, style) {
        let letters: usize = row.iter().map(|(name, value)| name.len() + 3 + value.len()).sum();
        let width = |size: f32| size * (LETTER * letters as f32 + GAP * row.len() as f32);
        let fits = |size: &f32| width(*size) <= ui.available_width();
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

/// Distance between two numbers, and the mean width of a letter; of the text's size.
const GAP: f32 = 1.2;
const LETTER: f32 = 0.56;

/// Names and values.
type Numbers = Vec<(&'static str, String)>;

/// Returns the numbers of the basis, and those of the ray up to its hit.
fn numbers(derived: &Derived, document: &Document, style: NumberStyle) -> [Numbers; 2] {
    let style = NumberStyle { digits: style.digits.min(DIGITS), ..style };
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

/// Shows `name = value`, the name in the colour that the views give it.
fn number(ui: &mut Ui, name: &'static str, value: &str, size: f32) {
    let mut job: LayoutJob = readouts::name_of(ui, name, true, size);
    let text = TextFormat::simple(FontId::proportional(size), ui.visuals().strong_text_color());
    job.append(&format!(" = {value}"), 0.0, text);
    let label = ui.add(Label::new(job).extend()).spoken(format!("{name} = {value}"));
    pointed_number::point(&label, name);
    if let Some(words) = meaning_of_readout(name) {
        label.on_hover_text(words);
    }
}
