//! The text beside the plot while presenting: the position on the ray, and a paragraph for each curve,
//! at the largest size at which all of it has room.

use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Id, Rect, Role, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use super::{TEXT, drawing, objects_at, point, said_id};
use crate::model::inspection::Inspection;
use crate::model::session::presenting::WRITTEN;
use crate::view::plot::Plot;
use crate::view::typesetting::notation::{formula, plain, unbroken};
use crate::view::typesetting::theme;

/// Sizes of the text, in points, from the largest.
const SIZES: [f32; 3] = [TEXT, 13.5, WRITTEN];
/// Length of a curve's line sample, in points.
const SAMPLE: f32 = 34.0;
/// Distance between two paragraphs, in points.
const GAP: f32 = 3.0;

/// A paragraph: the curve that it is about, and its text in two parts, of which the first is bold.
struct Paragraph {
    curve: Option<usize>,
    bold: String,
    text: String,
}

/// Shows the text.
pub(super) fn ui(
    ui: &mut Ui,
    plot: &Plot,
    inspection: &Inspection,
    first: Option<(u32, f64)>,
    digits: usize,
) {
    let paragraphs = paragraphs(plot, inspection, first, digits);
    let (width, height) = (ui.available_width(), ui.available_height());
    let fits = |size: &f32| {
        let heights = paragraphs.iter().map(|one| {
            let job = one.laid_out(ui, *size, width);
            ui.painter().layout_job(job).size().y + GAP
        });
        heights.sum::<f32>() <= height
    };
    let size = SIZES.into_iter().find(fits).unwrap_or(WRITTEN);
    ScrollArea::vertical().id_salt("plot words scrolled").auto_shrink(false).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = GAP;
        for one in &paragraphs {
            one.ui(ui, plot, size);
        }
    });
}

fn paragraphs(
    plot: &Plot,
    inspection: &Inspection,
    first: Option<(u32, f64)>,
    digits: usize,
) -> Vec<Paragraph> {
    let walked = plot.ray_point_t.iter().map(|(t, values)| Paragraph {
        curve: None,
        bold: String::new(),
        text: format!("{}: {}", point(inspection, *t, digits), objects_at(plot, values)),
    });
    let curves = plot.curves.iter().enumerate().map(|(k, curve)| {
        let hit = first.is_some_and(|(hit, _)| hit == curve.named.object);
        let hit = if hit { "the first hit; " } else { "" };
        let text = format!(": {hit}{}", curve.description(digits));
        Paragraph { curve: Some(k), bold: curve.named.name.clone(), text }
    });
    walked.chain(curves).collect()
}

impl Paragraph {
    fn indent(&self) -> f32 {
        if self.curve.is_some() { SAMPLE + 8.0 } else { 0.0 }
    }

    fn laid_out(&self, ui: &Ui, size: f32, width: f32) -> LayoutJob {
        let color = ui.visuals().text_color();
        let bold = FontId::new(size, theme::bold());
        let mut job = LayoutJob::default();
        job.append(&self.bold, 0.0, TextFormat::simple(bold, ui.visuals().strong_text_color()));
        let rest = formula(&unbroken(&self.text), size, color);
        for part in rest.sections {
            let text = &rest.text[part.byte_range.start.0..part.byte_range.end.0];
            job.append(text, part.leading_space, part.format);
        }
        job.wrap.max_width = width - self.indent();
        job
    }

    fn ui(&self, ui: &mut Ui, plot: &Plot, size: f32) {
        let job = self.laid_out(ui, size, ui.available_width());
        let galley = ui.painter().layout_job(job);
        let row = ui.available_width();
        let (rect, _) = ui.allocate_exact_size(vec2(row, galley.size().y), Sense::hover());
        let spoken = format!("{}{}", self.bold, plain(&self.text));
        let id = match self.curve {
            Some(k) => said_id(plot.curves[k].named.object),
            None => Id::unique("position on the ray"),
        };
        let response = ui.interact(rect, id, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &spoken));
        if let Some(k) = self.curve {
            let line = vec2(SAMPLE, 1.2 * size);
            drawing::sample(ui, Rect::from_min_size(rect.min, line), &plot.curves[k]);
        }
        let color = ui.visuals().text_color();
        ui.painter().galley(rect.min + vec2(self.indent(), 0.0), galley, color);
    }
}
