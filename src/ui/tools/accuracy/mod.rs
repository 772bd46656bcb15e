//! The accuracy view: another method's error map beside the camera's picture; below, error against
//! run time as plot and table.

mod methods;

use egui::{Color32, ComboBox, ProgressBar, Rect, RichText, ScrollArea, Ui, UiBuilder, pos2, vec2};
use pinhole_core::methods::{Method, trace_by};
use pinhole_core::{NO_OBJECT, Outputs, Pixel, Raster, ResolvedCamera, Selection, trace};
use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::{short, written_whole};

use crate::model::session::{Session, Settings};
use crate::report::model::NO_DIGIT;
use crate::ui::scene::readouts;
use crate::ui::scene::view_rects::strip_above;
use crate::ui::scene::views::MAP;
use crate::ui::tools::measuring::Measuring;
use crate::ui::widgets::Spoken as _;
use crate::view::accuracy::{self, Comparison, PixelError};
use crate::view::derive::{Compared, Derived};
use crate::view::typesetting::theme;

/// Height of the map's legend, in points.
pub(crate) const LEGEND: f32 = 44.0;

/// Maximum width of the table, in points; the plot gets the rest.
const TABLE: f32 = 560.0;

/// Shows the choice of a method; `name` is for screen readers.
pub(crate) fn method(ui: &mut Ui, name: &str, chosen: &mut Method) {
    let combo = ComboBox::from_id_salt(name).selected_text(chosen.name()).width(150.0);
    let response = combo
        .height(520.0)
        .show_ui(ui, |ui| {
            for method in Method::of_frames() {
                let hint = format!("{}\n{}", method.about(), method.source());
                ui.selectable_value(chosen, method, method.name()).on_hover_text(hint);
            }
        })
        .response;
    response.named(name);
}

/// Shows the name of the map above it, and the choice of its method.
pub(crate) fn strip(ui: &mut Ui, area: Rect, settings: &mut Settings) {
    strip_above(ui, area, |ui| {
        ui.label(MAP);
        method(ui, "error map of", &mut settings.compared);
    });
}

/// Shows the legend of the map's colours and the number of wrong pixels, below the map.
pub(crate) fn legend(ui: &mut Ui, area: Rect, compared: &Compared) {
    let below = Rect::from_min_size(
        pos2(area.left(), area.bottom() + 2.0),
        vec2(area.width(), LEGEND - 2.0),
    );
    ui.scope_builder(UiBuilder::new().max_rect(below), |ui| {
        ui.set_clip_rect(below);
        ui.horizontal(|ui| {
            let (mark, _) = ui.allocate_exact_size(vec2(12.0, 12.0), egui::Sense::hover());
            let wrong = theme::finished(ui, accuracy::WRONG);
            ui.painter().rect_filled(mark, 0.0, Color32::WHITE);
            ui.painter().rect_filled(mark.shrink(1.5), 0.0, wrong);
            ui.strong(summary(compared));
        });
        ui.horizontal(|ui| {
            ui.label("t off by 1 ulp of f64");
            let width = (ui.available_width() - 50.0).clamp(40.0, 240.0);
            color_bar(ui, width);
            ui.label("10¹⁶");
        });
    });
}

/// Shows the map's colours, from 1 ulp to the most.
fn color_bar(ui: &mut Ui, width: f32) {
    let (bar, _) = ui.allocate_exact_size(vec2(width, 12.0), egui::Sense::hover());
    let slices = width as usize;
    for slice in 0..slices {
        let left = bar.left() + slice as f32;
        let area = Rect::from_min_max(pos2(left, bar.top()), pos2(left + 1.5, bar.bottom()));
        let share = (slice as f64 + 0.5) / slices as f64;
        let color = accuracy::color_of_ulps(10_f64.powf(accuracy::DECADES * share));
        ui.painter().rect_filled(area, 0.0, theme::finished(ui, color));
    }
}

/// Returns `textbook-f32: 12 of 90000 pixels shown wrong, t off up to 3e9 ulps`.
pub(crate) fn summary(compared: &Compared) -> String {
    let Compared { method, comparison, .. } = compared;
    let (wrong, all) = (comparison.wrong, comparison.errors.len());
    let errors = match comparison.largest {
        Some(NO_DIGIT..) => ", at worst no digit of t right".to_owned(),
        Some(ulps) => format!(", t off up to {} ulps", short(ulps)),
        None => String::new(),
    };
    format!("{method}: {wrong} of {all} screen pixels wrong{errors}")
}

/// Returns the text on a picture that the ladder did not draw, or drew in place of the chosen
/// method.
pub(crate) fn drawn_by(derived: &Derived, chosen: Method) -> Option<String> {
    if let Some(why) = derived.too_many {
        return (chosen != Method::Ladder)
            .then(|| format!("drawn by the ladder, not by {chosen}: {why}"));
    }
    let Compared { method, comparison, .. } = derived.drawn_by.as_deref()?;
    Some(match comparison.wrong {
        1 => format!("drawn by {method}: 1 wrong screen pixel"),
        wrong => format!("drawn by {method}: {wrong} wrong screen pixels"),
    })
}

/// Shows plot and table, and above them the progress of measuring and the results at the selected
/// pixel.
pub(crate) fn ui(
    ui: &mut Ui,
    measuring: &Measuring,
    derived: &Derived,
    document: &Document,
    session: &mut Session,
) {
    // Always a single line: the content below must not jump during a drag.
    let text = selected(derived, document, session).unwrap_or_default();
    ui.add(egui::Label::new(text.clone()).truncate()).on_hover_text(text);
    ui.horizontal(|ui| {
        if let Some(steps) = derived.steps {
            ui.weak(readouts::steps(steps)).on_hover_text(readouts::STEPS);
            ui.separator();
        }
        progress(ui, measuring, derived);
    });
    if derived.too_many.is_some() {
        // The numbers of another scene could be mistaken for this one's.
        return;
    }
    let Some(report) = measuring.report().cloned() else { return };
    let Some(case) = report.cases.first() else { return };
    let area = ui.available_rect_before_wrap();
    let middle = area.left() + (0.42 * area.width()).max(area.width() - TABLE);
    let left = Rect::from_min_max(area.min, pos2(middle - 6.0, area.bottom()));
    let right = Rect::from_min_max(pos2(middle + 6.0, area.top()), area.max);
    ui.scope_builder(UiBuilder::new().max_rect(left), |ui| methods::plot(ui, case));
    ui.scope_builder(UiBuilder::new().max_rect(right), |ui| {
        ScrollArea::both().auto_shrink(false).show(ui, |ui| {
            methods::table(ui, case, &mut session.settings.compared);
        });
    });
}

/// Shows the progress of measuring, or the processor and reference of the numbers.
fn progress(ui: &mut Ui, measuring: &Measuring, derived: &Derived) {
    if !cfg!(feature = "report") {
        ui.label("Nothing is measured: this build has no feature `report`");
    } else if derived.fault.is_some() {
        ui.weak("nothing is measured while the camera sees nothing; the numbers are from before");
    } else if let Some(why) = derived.too_many {
        ui.label(format!("Nothing is measured: {why}"));
    } else if let Some(share) = measuring.share() {
        ui.label("Measuring: so far");
        let bar = ProgressBar::new(share).desired_width(180.0).show_percentage();
        ui.add(bar).named(format!("measured {:.0} %", 100.0 * share));
        if measuring.report().is_some() && !measuring.is_current() {
            ui.weak("until then the last scene's numbers");
        }
    } else if let Some(report) = measuring.report() {
        let text = format!("Measured on {}, against {}", report.cpu, report.reference);
        ui.add(egui::Label::new(text).truncate());
    }
}

/// Returns the results of the ladder and of the map's method at the selected pixel, whether or not
/// the map shows that pixel.
fn selected(derived: &Derived, document: &Document, session: &Session) -> Option<RichText> {
    if derived.too_many.is_some() {
        return None;
    }
    let (resolved, scene) = (derived.resolved.as_ref()?, derived.scene.as_deref()?);
    let pixel = pixel_of(session.selection, resolved)?;
    let from = u32::from(session.settings.count_from_one);
    let position = format!("row {}, column {}", pixel.row + from, pixel.column + from);
    let method = session.settings.compared;
    let raster = Raster::part(pixel.row..pixel.row + 1, pixel.column..pixel.column + 1);
    let truth = trace(scene, resolved, &raster, Outputs::default());
    let traced = trace_by(method, scene, resolved, &raster);
    let says = |object: u32, t: f64| match object {
        NO_OBJECT => "hits nothing".to_owned(),
        // Every digit: the difference is in the last ones.
        object => {
            format!("hits {} at t = {}", document.title_of(object as usize), written_whole(t))
        }
    };
    let verdict = match Comparison::new(&truth, &traced).errors[0] {
        PixelError::Wrong => "wrong".to_owned(),
        PixelError::Miss => "right".to_owned(),
        PixelError::Ulps(NO_DIGIT..) => "no digit of t right".to_owned(),
        PixelError::Ulps(ulps) => format!("{} ulps off", short(ulps)),
    };
    let (ladder, other) = (says(truth.object[0], truth.t[0]), says(traced.object[0], traced.t[0]));
    let text = format!("{position}: ladder {ladder}; {method} {other}: {verdict}");
    Some(RichText::new(text).strong())
}

fn pixel_of(selection: Selection, resolved: &ResolvedCamera) -> Option<Pixel> {
    match selection.inside(resolved.image()) {
        Selection::Pixel(pixel) => Some(pixel),
        Selection::Uv(uv) => resolved.pixel_of_uv(uv).map(|position| position.pixel),
    }
}
