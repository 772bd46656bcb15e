//! The accuracy page: next to the camera's picture, the error map of another method of intersection. Below
//! the pictures, the error of every method is shown against its run time, as a plot and a table. `Measuring`
//! takes the measurements for the current scene, a small part in each frame, so that the window never stalls.

#[cfg(feature = "report")]
use std::sync::Arc;
use std::sync::Weak;

use egui::accesskit::Role;
use egui::epaint::shape_transform::adjust_colors;
use egui::layers::ShapeIdx;
use egui::{
    Color32, Context, Grid, Painter, ProgressBar, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2,
};
use pinhole_core::methods::{Method, trace_by};
use pinhole_core::{Camera, NO_OBJECT, Outputs, Raster, Scene, trace};
use pinhole_exchange::document::Document;
use pinhole_figure::typesetting::theme::{self, error_color};
use pinhole_lecture::numbers::{grouped, short, written_whole};

use crate::features::accuracy::comparison::{
    Comparison, DECADES, PixelError, WRONG, color_of_ulps,
};
use crate::model::files::title_of;
use crate::model::session::Session;
use crate::report::model::{Case, MethodRow, NO_DIGIT, Report};
use crate::report::plot::marker::marker_of;
use crate::report::plot::panels;
use crate::report::summary::Summary;
use crate::ui::PageContext;
use crate::ui::scene::readouts;
use crate::ui::scene::view_rects::strip_above;
use crate::ui::widgets::{ResponseExt as _, clipped, combo, inside};
use crate::view::derive::{Compared, Derived, SecondPicture};

#[cfg(feature = "report")]
use crate::report::measure::Measurement;
#[cfg(feature = "report")]
use std::time::Duration;

/// Height of the map's legend, in points.
pub(crate) const LEGEND: f32 = 44.0;

/// Maximum width of the table, in points; the plot gets the rest of the width.
const TABLE: f32 = 560.0;

/// Returns a method's description and, on the next line, its source.
fn hint(method: Method) -> String {
    format!("{}\n{}", method.about(), method.source())
}

/// Shows a line above the error map: the title, and a drop-down list of the methods. The map shows the errors
/// of the method that the user chooses there.
pub(crate) fn strip(ui: &mut Ui, area: Rect, chosen: &mut Method) {
    strip_above(ui, area, |ui| {
        ui.label(SecondPicture::ErrorMap.name());
        combo(ui, "error map of", 150.0, chosen.name(), |ui| {
            for method in Method::of_frames() {
                let choice = ui.selectable_value(chosen, method, method.name());
                choice.on_hover_text(hint(method));
            }
        });
    });
}

/// Shows, below the map, the legend of its colours and the number of wrong pixels.
pub(crate) fn legend(ui: &mut Ui, area: Rect, compared: &Compared) {
    let size = vec2(area.width(), LEGEND - 2.0);
    let below = Rect::from_min_size(area.left_bottom() + vec2(0.0, 2.0), size);
    clipped(ui, below, |ui| {
        ui.horizontal(|ui| {
            let (mark, _) = ui.allocate_exact_size(vec2(12.0, 12.0), egui::Sense::hover());
            let wrong = theme::finished(ui, WRONG);
            ui.painter().rect_filled(mark, 0.0, Color32::WHITE);
            ui.painter().rect_filled(mark.shrink(1.5), 0.0, wrong);
            ui.strong(summary(compared));
        });
        ui.horizontal(|ui| {
            ui.label("t off by 1 ulp of f64");
            color_bar(ui);
            ui.label("10¹⁶");
        });
    });
}

/// Shows the colours of the error map as a bar, from an error in t of 1 ulp to the largest error.
fn color_bar(ui: &mut Ui) {
    let width = (ui.available_width() - 50.0).clamp(40.0, 240.0);
    let (bar, _) = ui.allocate_exact_size(vec2(width, 12.0), egui::Sense::hover());
    let slices = width as usize;
    for slice in 0..slices {
        let left = bar.left() + slice as f32;
        let area = Rect::from_min_max(pos2(left, bar.top()), pos2(left + 1.5, bar.bottom()));
        let share = (slice as f64 + 0.5) / slices as f64;
        let color = color_of_ulps(10_f64.powf(DECADES * share));
        ui.painter().rect_filled(area, 0.0, theme::finished(ui, color));
    }
}

/// Returns a summary such as `textbook-f32: 12 of 90000 pixels shown wrong, t off up to 3e9 ulps`.
pub(crate) fn summary(compared: &Compared) -> String {
    let Compared { method, comparison, .. } = compared;
    let [wrong, all] = [comparison.wrong, comparison.errors.len()].map(|n| grouped(n as u64));
    let errors = match comparison.largest {
        Some(NO_DIGIT..) => ", at worst no digit of t right".to_owned(),
        Some(ulps) => format!(", t off up to {} ulps", short(ulps)),
        None => String::new(),
    };
    format!("{method}: {wrong} of {all} screen pixels wrong{errors}")
}

/// Shows the plot and the table; above them, the progress of measuring and the results at the selected pixel.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { open, session, derived, tools, .. } = context;
    let (document, measuring) = (&open.document, &mut tools.measuring);
    measuring.step(ui.ctx(), &title_of(open.origin()), &document.camera, derived);
    // This is always a single line, so that the content below does not jump during a drag.
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
        // The user could mistake another scene's numbers for this one's.
        return;
    }
    let report = measuring.report.as_ref();
    let Some(case) = report.and_then(|report| report.cases.first()) else { return };
    let area = ui.available_rect_before_wrap();
    let middle = area.left() + (0.42 * area.width()).max(area.width() - TABLE);
    let left = Rect::from_min_max(area.min, pos2(middle - 6.0, area.bottom()));
    let right = Rect::from_min_max(pos2(middle + 6.0, area.top()), area.max);
    inside(ui, left, |ui| plot(ui, case));
    inside(ui, right, |ui| {
        ScrollArea::both().auto_shrink(false).show(ui, |ui| {
            table(ui, case, &mut session.preferences.compared);
        });
    });
}

/// Shows the progress of measuring. Once measuring is finished, shows on which processor and against
/// which reference it was done.
fn progress(ui: &mut Ui, measuring: &Measuring, derived: &Derived) {
    if !cfg!(feature = "report") {
        ui.label("Nothing is measured: this build has no feature `report`");
    } else if derived.fault.is_some() {
        ui.weak("Nothing is measured while the scene has an error: these are the last valid scene's numbers");
    } else if let Some(why) = derived.too_many {
        ui.label(format!("Nothing is measured: {why}"));
    } else if let Some(share) = measuring.share {
        ui.label("Measuring: so far");
        let bar = ProgressBar::new(share).desired_width(180.0).show_percentage();
        ui.add(bar).named(format!("measured {:.0} %", 100.0 * share));
        if measuring.report.is_some() && !measuring.is_current {
            ui.weak("until then, the last scene's numbers are shown");
        }
    } else if let Some(report) = &measuring.report {
        let text = format!("Measured on {}, against {}", report.cpu, report.reference);
        ui.add(egui::Label::new(text).truncate());
    }
}

/// Returns the results, at the selected pixel, of the ladder (the exact method) and of the method whose
/// errors the map shows, even if the map does not show that pixel.
fn selected(derived: &Derived, document: &Document, session: &Session) -> Option<RichText> {
    if derived.too_many.is_some() {
        return None;
    }
    let (resolved, scene) = (derived.resolved.as_ref()?, derived.scene.as_deref()?);
    let pixel = session.shown.selection.pixel(resolved)?;
    let from = u32::from(session.shown.setup.count_from_one);
    let position = format!("row {}, column {}", pixel.row + from, pixel.column + from);
    let method = session.preferences.compared;
    let raster = Raster::part(pixel.row..pixel.row + 1, pixel.column..pixel.column + 1);
    let truth = trace(scene, resolved, &raster, Outputs::default());
    let traced = trace_by(method, scene, resolved, &raster);
    let says = |object: u32, t: f64| match object {
        NO_OBJECT => "hits nothing".to_owned(),
        // All digits are shown, because the difference is in the last ones.
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

/// The columns' names and their explanations.
const COLUMNS: [(&str, &str); 7] = [
    (
        "wrong",
        "Decisions (hit or miss, which object is first, which of its roots) that differ from exact arithmetic",
    ),
    ("share", "Wrong decisions as a share of all"),
    ("median", "Error in t, in ulps of f64: half are at most this"),
    ("p99", "Error in t, in ulps of f64: 99 of 100 are at most this"),
    ("max ulps", "Error in t, in ulps of f64: all are at most this"),
    ("rad", "The largest angle between its normal and the true one, in radians"),
    ("ns", "Nanoseconds a pixel, the shortest of interleaved rounds, on one thread"),
];

/// Shows the plot of the measured scene.
fn plot(ui: &mut Ui, case: &Case) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::CLICK).with_role(Role::Image);
    response.named("Every method's error against its time");
    let summary = Summary::new(vec![case]);
    on_paper(ui, rect, |painter| panels(painter, rect.shrink(4.0), &summary, false));
}

/// Runs a function that draws on white paper, which fills `rect`, and converts the colours of what it has
/// drawn to the window's scheme.
fn on_paper(ui: &Ui, rect: Rect, draw: impl FnOnce(&Painter)) {
    let (painter, style) = (ui.painter(), theme::style(ui));
    let next_shape =
        || ui.ctx().graphics_mut(|graphics| graphics.entry(painter.layer_id()).next_idx().0);
    painter.rect_filled(rect, 2.0, Color32::WHITE);
    let first = next_shape();
    draw(painter);
    let drawn = first..next_shape();
    let recolor = move |color: &mut Color32| style.finish(std::slice::from_mut(color));
    ui.ctx().graphics_mut(|graphics| {
        let list = graphics.entry(painter.layer_id());
        for k in drawn {
            list.mutate_shape(ShapeIdx(k), |clipped| adjust_colors(&mut clipped.shape, recolor));
        }
    });
}

/// Shows one row per method. Clicking a row shows its method in the error map.
fn table(ui: &mut Ui, case: &Case, compared: &mut Method) {
    // All methods and all columns must fit into the space below two pictures.
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(13.0));
    ui.spacing_mut().interact_size.y = 17.0;
    ui.spacing_mut().button_padding = vec2(4.0, 0.0);
    let grid = Grid::new("methods").striped(true).num_columns(COLUMNS.len() + 1);
    grid.spacing([10.0, 1.0]).show(ui, |ui| {
        ui.strong("method");
        for (name, hint) in COLUMNS {
            ui.strong(name).on_hover_text(hint);
        }
        ui.end_row();
        for row in &case.methods {
            line(ui, row, compared);
            ui.end_row();
        }
    });
    for row in &case.methods {
        if let Some(text) = row.decided() {
            ui.label(text);
        }
    }
}

fn line(ui: &mut Ui, row: &MethodRow, compared: &mut Method) {
    ui.horizontal(|ui| {
        let (mark, _) = ui.allocate_exact_size(vec2(20.0, 12.0), Sense::hover());
        on_paper(ui, mark, |painter| {
            marker_of(row.formula()).draw(painter, mark.center(), row.digits());
        });
        match Method::from_name(&row.name) {
            Some(method) => {
                let name = ui.selectable_value(compared, method, &row.name);
                name.named(format!("error map of {}", row.name)).on_hover_text(hint(method));
            }
            None => drop(ui.label(&row.name)),
        }
    });
    let wrong = RichText::new(grouped(row.wrong));
    ui.label(if row.wrong > 0 { wrong.strong().color(error_color(ui)) } else { wrong });
    let number = |x: Option<f64>| x.map_or("-".to_owned(), short).replace('-', "−");
    ui.label(row.wrong_share.map_or(String::new(), |share| format!("{} %", short(100.0 * share))));
    let ulps = row.ulp_f64;
    for x in [ulps.median, ulps.p99, ulps.max, row.normal_error_max] {
        ui.label(number(x));
    }
    ui.label(number(row.ns_per_pixel.min));
}

/// Time without changes before measuring starts, in seconds. During a drag, every frame has a different
/// scene.
#[cfg(feature = "report")]
const REST: f64 = 0.5;

/// Time between two reports while measuring, in seconds.
#[cfg(feature = "report")]
const BETWEEN: f64 = 0.3;

/// The current measurement and the last report.
#[derive(Default)]
#[cfg_attr(not(feature = "report"), expect(dead_code, reason = "nothing is measured"))]
pub(crate) struct Measuring {
    /// The camera and the scene that are measured. The scene is identified by its address, without a
    /// reference that keeps it alive: a second owner would force the next change of the scene to copy
    /// it.
    subject: Option<(Camera, Weak<Scene>)>,
    /// Time at which the subject was first seen, in the context's seconds.
    since: f64,
    #[cfg(feature = "report")]
    run: Option<Measurement>,
    /// Progress of the run, 0 to 1; `None` if nothing is left to measure.
    share: Option<f32>,
    /// The last report, which may be about a previous scene.
    report: Option<Report>,
    /// Time when the report was made, in the context's seconds.
    made_at: f64,
    /// True if the report is about the subject.
    is_current: bool,
}

impl Measuring {
    /// Does nothing in a build without the feature `report`.
    #[cfg(not(feature = "report"))]
    pub(crate) fn step(&mut self, _: &Context, _: &str, _: &Camera, _: &Derived) {}

    /// Measures the next part, if any is left, and requests the next frame.
    #[cfg(feature = "report")]
    pub(crate) fn step(&mut self, ctx: &Context, name: &str, camera: &Camera, derived: &Derived) {
        // Like the error map, the report tests every object at every pixel, so neither is made if there
        // are too many.
        let why_not = (derived.fault, derived.too_many);
        let (Some(scene), (None, None)) = (&derived.scene, why_not) else { return };
        let now = ctx.input(|input| input.time);
        let subject = self.subject.as_ref();
        let address = Arc::as_ptr(scene);
        if subject.is_none_or(|(known, objects)| known != camera || objects.as_ptr() != address) {
            self.subject = Some((*camera, Arc::downgrade(scene)));
            self.share = Some(0.0);
            (self.since, self.run, self.is_current) = (now, None, false);
        }
        if self.share.is_none() {
            return;
        }
        let left = REST - (now - self.since);
        if self.run.is_none() && left > 0.0 {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
            return;
        }
        if self.run.is_none() {
            // An invalid camera is a fault, and this function has already returned above.
            self.run = Measurement::of_scene(name, scene, camera).ok();
        }
        let Some(run) = &mut self.run else { return };
        run.step();
        let share = run.done() as f32 / run.total().max(1) as f32;
        self.share = (!run.is_done()).then_some(share);
        if run.is_done() || now - self.made_at >= BETWEEN {
            self.report = Some(run.report());
            (self.made_at, self.is_current) = (now, true);
        }
        if self.share.is_some() {
            ctx.request_repaint();
        }
    }
}
