//! The readouts: the numbers beside or below the views, shown either as blocks that can be selected and copied,
//! or in short: a line each in the column, or in one row at a figure's foot. Hovering a number highlights what it is about, such as a vector or an
//! object, in both views.

use std::f64::consts::FRAC_1_SQRT_2;

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, FontId, Grid, Label, Layout, Response, RichText, ScrollArea, TextStyle, Ui};
use pinhole_core::{Counts, DVec2, DVec3, ResolvedCamera, Steps};
use pinhole_exchange::document::Document;
use pinhole_figure::Item;
use pinhole_figure::concept::HoverSource;
use pinhole_figure::inspection::Inspection;
use pinhole_figure::readings::{NumberStyle, Reading, ReadingValue, of_basis};
use pinhole_figure::typesetting::notation::{self, formula};
use pinhole_figure::typesetting::theme::{self, WRITTEN};
use pinhole_lecture::numbers::grouped;

use crate::ui::PageContext;
use crate::ui::widgets::{ResponseExt as _, is_about, vector_color};
use crate::view::derive::Derived;

/// Minimum width of the block that lists the hits, in points.
const HITS: f32 = 280.0;

/// Shows the blocks Basis, Ray and Hits side by side, or one below another where there is no space.
pub(crate) fn ui(ui: &mut Ui, context: &PageContext<'_>) {
    let PageContext { open, derived, style, .. } = *context;
    ScrollArea::vertical().id_salt("readouts scrolled").auto_shrink(false).show(ui, |ui| {
        // This is as wide as the widest numbers, so that nothing moves sideways while they change.
        let vector = 3.0 * (style.digits as f32 + 4.6) * 7.0;
        let is_narrow = ui.available_width() < 160.0 + 2.0 * vector + HITS;
        let block = |ui: &mut Ui, names: f32, content: &mut dyn FnMut(&mut Ui)| {
            ui.vertical(|ui| {
                if !is_narrow {
                    ui.set_width(names + vector);
                }
                content(ui);
            });
            ui.separator();
        };
        let layout = match is_narrow {
            true => Layout::top_down(Align::LEFT),
            false => Layout::left_to_right(Align::TOP),
        };
        ui.with_layout(layout, |ui| {
            let Some(resolved) = &derived.resolved else { return };
            block(ui, 110.0, &mut |ui| {
                self::block(ui, "Basis", &of_basis(resolved, derived.up_angle), style);
            });
            let Some(inspection) = &derived.inspection else { return };
            block(ui, 50.0, &mut |ui| ray(ui, inspection, resolved, style));
            ui.vertical(|ui| hits(ui, derived, &open.document, style));
        });
    });
}

/// Shows, in the row above the blocks, how many hit-or-miss decisions of the picture each kind of arithmetic
/// made, and how much the renderer skipped.
pub(crate) fn work(ui: &mut Ui, derived: &Derived) {
    if derived.fault.is_some() {
        return;
    }
    if let Some(counted) = derived.steps {
        ui.add_space(12.0);
        ui.weak(steps(counted)).on_hover_text(STEPS);
    }
    ui.add_space(12.0);
    left_out(ui, derived);
}

/// Shows how many spheres and rows the renderer skipped in the camera's picture. Shows nothing if the camera
/// or the scene is invalid.
pub(crate) fn left_out(ui: &mut Ui, derived: &Derived) {
    let Some(counts) = derived.counts.filter(|_| derived.fault.is_none()) else { return };
    let Counts { spheres, spheres_left_out, rows, rows_untouched, .. } = counts;
    let [out, spheres] = [spheres_left_out, spheres].map(grouped);
    let text = format!("Left out: {out} of {spheres} spheres, {rows_untouched} of {rows} rows");
    ui.weak(text).on_hover_text(LEFT_OUT);
}

/// Tooltip of the text that [`steps`] returns.
pub(crate) const STEPS: &str = "The number of decisions on whether a ray hits, by the arithmetic that \
                                they needed: f64 has 16 digits, double-double 32";

/// Returns a text that says how many hit-or-miss decisions of the picture were made in `f64`, in
/// double-double and in exact arithmetic.
pub(crate) fn steps(steps: Steps) -> String {
    let [f64, double_double, exact] = [steps.f64, steps.double_double, steps.exact].map(grouped);
    if steps.beyond_f64() == 0 {
        return format!("Hit or miss: {f64} decisions, all in f64");
    }
    format!("Hit or miss: {f64} decisions in f64, {double_double} in double-double, {exact} exact")
}

/// Tooltip of the text about the spheres and rows that the renderer left out.
const LEFT_OUT: &str = "The renderer skips spheres that are behind the eye, outside the picture or too \
                        small to reach a pixel, and rows that no object reaches";

/// Lays out the name of a reading, a named quantity with its value. A vector that the views draw has its
/// colour from there.
fn name_of(ui: &Ui, reading: &Reading, strong: bool, size: f32) -> LayoutJob {
    let visuals = ui.visuals();
    let plain = if strong { visuals.strong_text_color() } else { visuals.text_color() };
    if !matches!(reading.value, ReadingValue::Vector(_)) {
        return formula(reading.name, size, plain);
    }
    let color = vector_color(ui, reading.name).unwrap_or(plain);
    LayoutJob::simple_singleline(reading.name.to_owned(), FontId::new(size, theme::bold()), color)
}

/// Lays out `name = value`, or `name ≈ value` if the value is rounded.
fn job_of(ui: &Ui, reading: &Reading, style: NumberStyle, strong: bool, size: f32) -> LayoutJob {
    let visuals = ui.visuals();
    let color = if strong { visuals.strong_text_color() } else { visuals.text_color() };
    let mut job = name_of(ui, reading, strong, size);
    let value = format!(" {}", style.equated_value(&reading.value));
    job.append(&value, 0.0, TextFormat::simple(FontId::proportional(size), color));
    job
}

/// Sets a label's text for screen readers and its tooltip to the text and the meaning of the reading that it
/// shows. Hovering the label highlights the reading's concept in the views.
fn explain(label: Response, reading: &Reading, style: NumberStyle) {
    is_about(&label, reading.concept, HoverSource::Numbers);
    let label = label.spoken(written(reading, style));
    if !reading.meaning().is_empty() {
        label.on_hover_text(reading.meaning());
    }
}

fn written(Reading { name, value, .. }: &Reading, style: NumberStyle) -> String {
    format!("{name} {}", style.equated_value(value))
}

/// Shows readings (named quantities) in a block, one per line.
fn block(ui: &mut Ui, title: &str, readings: &[Reading], style: NumberStyle) {
    ui.strong(title);
    let size = TextStyle::Body.resolve(ui.style()).size;
    Grid::new(title).num_columns(2).show(ui, |ui| {
        for reading in readings {
            let name = ui.label(name_of(ui, reading, true, size));
            is_about(&name, reading.concept, HoverSource::Numbers);
            name.on_hover_text(reading.meaning());
            let value = ui.label(style.equated_value(&reading.value));
            is_about(&value, reading.concept, HoverSource::Numbers);
            value.spoken(written(reading, style));
            ui.end_row();
        }
    });
}

fn ray(ui: &mut Ui, inspection: &Inspection, resolved: &ResolvedCamera, style: NumberStyle) {
    block(ui, "Ray", &inspection.ray_readings(resolved.image()), style);
    let size = TextStyle::Body.resolve(ui.style()).size;
    notation::label(ui, "p + t d, t = 1 on the viewport", size, ui.visuals().weak_text_color());
}

/// Shows where the ray's line meets the objects. Each root t has its object and the reason why it is, or is
/// not, the first hit.
fn hits(ui: &mut Ui, derived: &Derived, document: &Document, style: NumberStyle) {
    let Some(inspection) = derived.inspection.as_deref() else { return };
    let object_of = |index: usize| document.title_of(inspection.roots[index].object as usize);
    ui.strong("Hits");
    if inspection.roots.is_empty() {
        ui.label("The ray meets nothing.");
    }
    let size = TextStyle::Body.resolve(ui.style()).size;
    for index in 0..inspection.roots.len() {
        let first = inspection.first == Some(index);
        let visuals = ui.visuals();
        let color = if first { visuals.strong_text_color() } else { visuals.text_color() };
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(object_of(index)).color(color));
            notation::label(ui, inspection.verdict(index), size, color);
        });
        ui.horizontal_wrapped(|ui| {
            ui.add_space(12.0);
            for reading in &inspection.root_readings(index) {
                let job = job_of(ui, reading, style, first, size);
                explain(ui.add(Label::new(job).extend()), reading, style);
            }
        });
    }
}

/// Number of significant digits below which the numbers do not go, even if they do not fit.
const FEWEST: usize = 3;

/// Distance between two numbers of a row, as a multiple of the text's size.
const GAP: f32 = 1.2;

/// Height of a line of the column, as a multiple of the text's size.
const LINE: f32 = 1.45;

/// Number of lines in the column.
const LINES: f32 = 8.0;

/// Sizes of the column's text, in points, of which the largest is chosen that fits.
const SIZES: [f32; 6] = [18.0, 17.0, 16.0, 15.0, 14.0, WRITTEN];

/// Shows the basis, the selected ray and its first hit, with one number or vector per line.
pub(crate) fn column(ui: &mut Ui, context: &PageContext<'_>) {
    let PageContext { open, derived, style, .. } = *context;
    let Some(resolved) = derived.resolved.as_ref().filter(|_| derived.fault.is_none()) else {
        return;
    };
    let mut readings = of_basis(resolved, None);
    if let Some(inspection) = &derived.inspection {
        let [_, uv, _, d, _] = inspection.ray_readings(resolved.image());
        readings.extend([uv, d]);
        // A miss has neither t nor point, so that they come last and nothing else moves.
        readings.extend(inspection.hit_readings(|k| open.document.title_of(k)).into_iter().rev());
        let point = inspection.first.map(|first| inspection.root_readings(first));
        readings.extend(point.map(|[_, _, point, _]| point));
    }
    let height = ui.available_height() / LINES;
    let fits: Vec<f32> = SIZES.into_iter().filter(|size| LINE * size <= height).collect();
    let lines: Vec<Vec<Reading>> = readings.into_iter().map(|reading| vec![reading]).collect();
    ui.spacing_mut().item_spacing.y = 0.0;
    // Texts are moved to whole pixels, which may be a little outside.
    ui.set_clip_rect(ui.clip_rect().expand(1.0));
    let sizes = if fits.is_empty() { &SIZES[SIZES.len() - 1..] } else { &fits };
    rows(ui, &lines, sizes, height, style);
}

/// Height of the line of numbers at the foot of the main figure, in points.
pub(crate) const BAND: f32 = 26.0;

/// Minimum width of the area with a choice between one line of numbers and all of them, in points.
pub(crate) const LEAST: f32 = 420.0;

/// Shows the selected ray and its first hit in one line, as far as they are drawn and there is room for
/// them.
pub(crate) fn band(ui: &mut Ui, context: &PageContext<'_>) {
    let PageContext { open, derived, style, .. } = *context;
    let items = context.session.shown.setup.items;
    let shown = derived.resolved.as_ref().zip(derived.inspection.as_ref());
    let Some((resolved, inspection)) = shown.filter(|_| derived.fault.is_none()) else { return };
    let [_, uv, _, d, _] = inspection.ray_readings(resolved.image());
    let mut row: Vec<Reading> = Vec::new();
    if items.shows_any(&[Item::Ray, Item::Direction]) {
        row.extend([uv, d]);
    }
    if items.shows_any(&[Item::Hit, Item::Roots, Item::SphereFigure]) {
        row.extend(inspection.hit_readings(|object| open.document.title_of(object)));
    }
    if row.is_empty() {
        return;
    }
    let smallest = (FEWEST.min(style.digits), WRITTEN);
    while row.len() > 1 && row_width(ui, &row, smallest, style) > ui.available_width() {
        row.pop();
    }
    rows(ui, &[row], &[16.0, 14.0, WRITTEN], ui.available_height(), style);
}

/// Returns the width of a number with this number of digits, at this text size. It is the width of the widest
/// one of its kind, so that no other one moves while it changes.
fn width(ui: &Ui, reading: &Reading, (digits, size): (usize, f32), style: NumberStyle) -> f32 {
    let width = |reading| {
        let job = job_of(ui, reading, style.at_most(digits), true, size);
        ui.painter().layout_job(job).size().x
    };
    width(reading).max(width(&widest(reading)))
}

/// Width at which a name may be cut off, in points.
const NAME: f32 = 90.0;

/// Returns the least width of a row of numbers, in which names may be cut off.
fn row_width(ui: &Ui, row: &[Reading], choice: (usize, f32), style: NumberStyle) -> f32 {
    let widths = row.iter().map(|reading| {
        let width = width(ui, reading, choice, style);
        if is_text(reading) { width.min(NAME) } else { width }
    });
    widths.sum::<f32>() + GAP * choice.1 * (row.len() - 1) as f32
}

/// Shows rows of numbers, each at most `height` points high, with the most digits and then with the first
/// of the text sizes with which all numbers fit.
fn rows(ui: &mut Ui, rows: &[Vec<Reading>], sizes: &[f32], height: f32, style: NumberStyle) {
    let fits = |choice: &(usize, f32)| {
        rows.iter().all(|row| row_width(ui, row, *choice, style) <= ui.available_width())
    };
    let digits = (FEWEST.min(style.digits)..=style.digits).rev();
    let choices = digits.flat_map(|digits| sizes.iter().map(move |size| (digits, *size)));
    let choice = choices.clone().find(fits).or(choices.last()).unwrap_or((FEWEST, WRITTEN));
    let height = height.min(LINE * choice.1);
    theme::rows_of_text(ui);
    for row in rows {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.set_min_height(height);
            for reading in row {
                let end = ui.cursor().left() + width(ui, reading, choice, style) + GAP * choice.1;
                let style = style.at_most(choice.0);
                let label = Label::new(job_of(ui, reading, style, true, choice.1));
                let label = if is_text(reading) { label.truncate() } else { label.extend() };
                explain(ui.add(label), reading, style);
                ui.add_space((end - ui.cursor().left()).max(0.0));
            }
        });
    }
}

/// Returns true if a reading is a name rather than a number. A long one is cut off.
fn is_text(reading: &Reading) -> bool {
    matches!(reading.value, ReadingValue::Text(_))
}

/// Returns the reading with a value that takes as much space as usual values at most do.
fn widest(reading: &Reading) -> Reading {
    let value = match &reading.value {
        ReadingValue::Vector(_) => ReadingValue::Vector(DVec3::splat(-FRAC_1_SQRT_2)),
        ReadingValue::Uv(_) => ReadingValue::Uv(DVec2::splat(-FRAC_1_SQRT_2)),
        ReadingValue::Number(_) => ReadingValue::Number(-FRAC_1_SQRT_2),
        other => other.clone(),
    };
    Reading { value, ..*reading }
}

/// Returns the numbers of a ray in two lines: first its pixel and (u, v), then the object that it hits, and
/// t.
pub(crate) fn ray_text(inspection: &Inspection, document: &Document, style: NumberStyle) -> String {
    let pixel = inspection.pixel().map(|pixel| format!("{}   ", style.pixel(pixel)));
    let hit = match inspection.first_hit() {
        Some(hit) => {
            format!("{}   𝑡 {}", document.title_of(hit.object as usize), style.equated(hit.t))
        }
        None => "hits nothing".to_owned(),
    };
    let uv = style.equated_value(&ReadingValue::Uv(inspection.uv));
    format!("{}(𝑢, 𝑣) {uv}\n{hit}", pixel.unwrap_or_default())
}
