//! The comparison of the camera with the ghost, a frozen copy of it. Next to the camera view is the ghost's
//! picture or a map of the pixels that differ. Below the pictures are the numbers of both cameras.

use egui::{Align, Direction, Grid, Layout, Rect, RichText, ScrollArea, Ui};
use pinhole_core::{Camera, DVec3, Orientation, ResolvedCamera, Root};
use pinhole_exchange::document::Document;
use pinhole_figure::typesetting::theme::STACKED;
use pinhole_figure::{Inspection, NumberStyle};
use pinhole_lecture::numbers::percent;

use super::view_rects::strip_above;
use crate::model::Ghost;
use crate::ui::PageContext;
use crate::ui::action::Action;
use crate::ui::widgets::{ResponseExt as _, Words, cell, vector_color};
use crate::view::derive::{AgainstGhost, SecondPicture};

/// Size of the text, in points, where the tables are side by side and where they are stacked.
const TEXT: [f32; 2] = [15.5, 12.0];

/// Width of a character of a number, as a multiple of the text's size.
const LETTER: f32 = 0.53;

/// Maximum number of significant digits. More do not fit.
const DIGITS: usize = 4;

/// Shows the titles of both pictures on the stage.
pub(crate) fn headings(ui: &mut Ui, areas: [Rect; 2]) {
    for (area, title) in areas.into_iter().zip(["The camera", "The dashed camera"]) {
        strip_above(ui, area, |ui| drop(ui.strong(title)));
    }
}

/// Shows, above the second picture, the choice between the ghost's picture and the map of the pixels that
/// differ.
pub(crate) fn strip(ui: &mut Ui, area: Rect, ghost: &mut Option<Ghost>) {
    strip_above(ui, area, |ui| match ghost {
        None => {
            ui.strong(SecondPicture::Ghost.name());
        }
        Some(Ghost { shows_differences, .. }) => {
            ui.selectable_value(shows_differences, false, SecondPicture::Ghost.name());
            ui.selectable_value(shows_differences, true, "Differences");
        }
    });
}

/// Returns what is said about the picture.
pub(crate) fn words(against: Option<&AgainstGhost>, ghost: Option<&Ghost>) -> Words {
    let why_not = match ghost.map(|ghost| ghost.camera.resolve()) {
        None => "Freeze the camera as a ghost, then change it and compare.".to_owned(),
        Some(Err(error)) => format!("The ghost sees nothing: {error}"),
        Some(Ok(_)) => "There are no two cameras to compare.".to_owned(),
    };
    (against.map_or_else(|| why_not.clone(), share_that_differs), Some(why_not))
}

/// Returns a text such as `33 % of the picture shows another object`.
fn share_that_differs(against: &AgainstGhost) -> String {
    let shares = &against.seen;
    format!("{} of the picture shows another object", percent(shares.differing, shares.pixels))
}

/// Shows the ghost's buttons, and the numbers of both cameras.
pub(crate) fn ui(ui: &mut Ui, context: &mut PageContext<'_>) {
    let PageContext { open, session, derived, style, .. } = context;
    let (document, ghost) = (&open.document, session.shown.ghost.as_ref());
    let is_stacked = ui.available_width() < STACKED;
    let size = TEXT[usize::from(is_stacked)];
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(size));
    let against = derived.against_ghost.as_deref();
    let style = style.at_most(DIGITS);
    ui.horizontal_wrapped(|ui| {
        let freeze = ui.button("Freeze").named("Freeze the camera as a ghost");
        freeze.asks(Action::FreezeGhost);
        let remove = ui.add_enabled(ghost.is_some(), egui::Button::new("Remove"));
        remove.named("Remove the ghost").asks(Action::DropGhost);
        if let Some(against) = against {
            ui.add_space(8.0);
            ui.strong(share_that_differs(against));
            ui.add_space(8.0);
            let by = &against.difference;
            let roll = by.roll.map(|roll| format!(", rolled by {}", degrees(roll, style)));
            let turn = degrees(by.turn, style);
            ui.strong(format!("turned by {turn}{}", roll.unwrap_or_default()));
        }
    });
    let all = (against, ghost, &derived.resolved);
    let (Some(against), Some(ghost), Some(now)) = all else { return };
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        let way = if is_stacked { Direction::TopDown } else { Direction::LeftToRight };
        ui.with_layout(Layout::from_main_dir_and_cross_align(way, Align::Min), |ui| {
            let now = (now, derived.inspection.as_deref());
            let (vectors, scalars) = compared_lines(document, now, &ghost.camera, against, style);
            // As wide as the widest numbers, so that nothing moves sideways while they change.
            let digits = style.digits as f32;
            table(ui, "vectors", &vectors, LETTER * size * 3.0 * (digits + 2.8));
            ui.separator();
            table(ui, "scalars", &scalars, LETTER * size * (digits + 2.6));
        });
    });
}

/// A quantity's name, its values for the ghost and for the current camera, and their difference.
type ComparedLine = (&'static str, String, String, String);

/// Shows a quantity's name; if it is a vector, in the colour that it has in the views. Screen readers read
/// the whole line instead of the name.
fn name_of(ui: &mut Ui, (name, ghost, now, between): &ComparedLine) {
    let color = vector_color(ui, name).unwrap_or(ui.visuals().strong_text_color());
    let spoken = format!("{name}: ghost {ghost}, now {now}, difference {between}");
    ui.label(RichText::new(*name).strong().color(color)).spoken(spoken);
}

/// Shows quantities of both cameras, one per line. The values have columns of this width, in points.
fn table(ui: &mut Ui, name: &str, lines: &[ComparedLine], width: f32) {
    let grid = Grid::new(name).num_columns(4).spacing([10.0, 2.0]);
    grid.min_col_width(0.0).min_row_height(0.0).show(ui, |ui| {
        for head in ["", "ghost", "now", "change"] {
            ui.weak(head);
        }
        ui.end_row();
        for line in lines {
            let (_, ghost, now, between) = line;
            name_of(ui, line);
            for value in [ghost, now] {
                cell(ui, width, |ui| ui.label(value));
            }
            ui.strong(between);
            ui.end_row();
        }
    });
}

fn degrees(x: f64, style: NumberStyle) -> String {
    // An angle that is only a rounding error is shown as 0.
    let x = if x.abs() < 1e-9 { 0.0 } else { x };
    format!("{}°", style.number(x))
}

fn signed(x: f64, style: NumberStyle) -> String {
    let sign = if x > 0.0 { "+" } else { "" };
    format!("{sign}{}", style.number(x))
}

/// Returns the lines that compare u, v, w, *eye*, *at* and *up*; and those that compare the viewports and the first
/// hit of the selected ray: the object and t. `resolved` and `inspection` are the current camera and its ray.
fn compared_lines(
    document: &Document,
    (resolved, inspection): (&ResolvedCamera, Option<&Inspection>),
    ghost: &Camera,
    against: &AgainstGhost,
    style: NumberStyle,
) -> ([ComparedLine; 6], [ComparedLine; 5]) {
    let (now, by) = (&document.camera, &against.difference);
    let (here, there) = (resolved.basis(), against.ghost.basis());
    let vector = |v: DVec3| style.vector(v);
    let turned =
        |name, there, here, angle| (name, vector(there), vector(here), degrees(angle, style));
    let way = |v: DVec3| style.number(v.length());
    let at = |camera: &Camera| match camera.orientation {
        Orientation::At { at, .. } => vector(at),
        _ => "none".to_owned(),
    };
    let vectors = [
        turned("u", there.u, here.u, by.basis[0]),
        turned("v", there.v, here.v, by.basis[1]),
        turned("w", there.w, here.w, by.basis[2]),
        ("eye", vector(ghost.eye), vector(now.eye), way(by.eye)),
        ("at", at(ghost), at(now), by.at.map(way).unwrap_or_default()),
        turned("up", ghost.up(), now.up(), by.up),
    ];
    let line = |name, old, new, by| (name, style.number(old), style.number(new), signed(by, style));
    let (old, new) = (ghost.viewport, now.viewport);
    let (here, there) =
        (inspection.and_then(Inspection::first_hit), against.inspection.first_hit());
    // Objects are shown by number, because their names do not fit. The list of objects shows the numbers
    // as well.
    let kind = |hit: &Root| format!("{} {}", document.kind_of(hit.object as usize), hit.object);
    let named = |hit: Option<&Root>| hit.map_or("nothing".to_owned(), kind);
    let t = |hit: Option<&Root>| hit.map_or("none".to_owned(), |hit| style.number(hit.t));
    let is_same = here.map(|hit| hit.object) == there.map(|hit| hit.object);
    let hit = if is_same { "the same" } else { "another" };
    let between = here.zip(there).map(|(here, there)| signed(here.t - there.t, style));
    let scalars = [
        line("distance", old.distance, new.distance, by.distance),
        line("width", old.width, new.width, by.extent[0]),
        line("height", old.height, new.height, by.extent[1]),
        ("hit", named(there), named(here), hit.to_owned()),
        ("t", t(there), t(here), between.unwrap_or_default()),
    ];
    (vectors, scalars)
}
