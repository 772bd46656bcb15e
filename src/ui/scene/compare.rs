//! The comparison with the ghost: next to the camera view, the ghost's picture or the differences; below
//! them, the numbers of both cameras.

use egui::{Grid, Rect, RichText, ScrollArea, Ui};
use pinhole_core::{DVec3, Orientation, ResolvedCamera, Root};
use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::percent;

use super::view_rects::strip_above;
use super::views;
use crate::model::inspection::Inspection;
use crate::model::readings::NumberStyle;
use crate::model::session::Ghost;
use crate::ui::action::{Action, GhostAction};
use crate::ui::widgets::Asking as _;
use crate::ui::widgets::Spoken as _;
use crate::ui::widgets::number::vector_color;
use crate::view::derive::{AgainstGhost, Derived};

/// Size of the text, in points.
const TEXT: f32 = 15.5;

/// Maximum number of significant digits.
const DIGITS: usize = 4;

/// The text if there is no ghost.
const NO_GHOST: &str = "Press G to freeze the camera as a ghost, then change it and compare.";

/// Shows, above the picture, the choice between the ghost's picture and the differences.
pub(crate) fn strip(ui: &mut Ui, area: Rect, ghost: &mut Option<Ghost>) {
    strip_above(ui, area, |ui| match ghost {
        None => {
            ui.strong(views::GHOST);
        }
        Some(Ghost { shows_differences, .. }) => {
            ui.selectable_value(shows_differences, false, views::GHOST);
            ui.selectable_value(shows_differences, true, "Differences");
        }
    });
}

/// Returns the description of the picture for screen readers.
pub(crate) fn spoken(against: Option<&AgainstGhost>) -> String {
    against.map_or_else(|| NO_GHOST.to_owned(), seen)
}

/// Returns the reason why there is no picture.
pub(crate) fn why_not(ghost: Option<&Ghost>) -> String {
    match ghost.map(|ghost| ghost.camera.resolve()) {
        None => NO_GHOST.to_owned(),
        Some(Err(error)) => format!("The ghost sees nothing: {error}"),
        Some(Ok(_)) => "There are no two cameras to compare.".to_owned(),
    }
}

/// Returns `33 % of the picture shows another object`.
fn seen(against: &AgainstGhost) -> String {
    let seen = &against.seen;
    format!("{} of the picture shows another object", percent(seen.differing, seen.pixels))
}

/// Shows the ghost's buttons, and the numbers of both cameras.
pub(crate) fn ui(
    ui: &mut Ui,
    derived: &Derived,
    document: &Document,
    ghost: Option<&Ghost>,
    style: NumberStyle,
    actions: &mut Vec<Action>,
) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    let against = derived.against_ghost.as_deref();
    // More digits do not fit side by side.
    let style = NumberStyle { digits: style.digits.min(DIGITS), ..style };
    ui.horizontal(|ui| {
        buttons(ui, ghost.is_some(), actions);
        if let Some(against) = against {
            ui.add_space(8.0);
            ui.strong(seen(against));
            ui.add_space(8.0);
            turns(ui, against, style);
        }
    });
    let (Some(against), Some(ghost), Some(now)) = (against, ghost, &derived.resolved) else {
        return;
    };
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            vectors(ui, "turned", &turned(now, against, style), style);
            ui.separator();
            vectors(ui, "moved", &moved(document, ghost, against, style), style);
            ui.separator();
            let here = derived.inspection.as_deref();
            let mut lines = numbers(document, ghost, against, style);
            lines.extend(hits(here, &against.inspection, document, style));
            scalars(ui, &lines, style);
        });
    });
}

/// Shows the menu's commands as a row of buttons.
fn buttons(ui: &mut Ui, has_ghost: bool, actions: &mut Vec<Action>) {
    for (text, name, ghost, needs_one) in [
        ("Freeze (G)", "Freeze the camera as a ghost", GhostAction::Freeze, false),
        ("Swap", "Swap with the ghost", GhostAction::Swap, true),
        ("Remove", "Remove the ghost", GhostAction::Drop, true),
    ] {
        let button = egui::Button::new(text);
        ui.add_enabled(has_ghost || !needs_one, button).named(name).asks(ghost, actions);
    }
}

/// A quantity of the ghost and of the current camera, with their difference.
#[derive(Clone)]
struct ComparedLine {
    name: &'static str,
    ghost: String,
    now: String,
    between: String,
}

impl ComparedLine {
    fn new(name: &'static str, ghost: String, now: String, between: String) -> ComparedLine {
        ComparedLine { name, ghost, now, between }
    }

    /// Shows the name in the vector's colour; screen readers read the whole line.
    fn name(&self, ui: &mut Ui) {
        let ComparedLine { name, ghost, now, between } = self;
        let spoken = format!("{name}: ghost {ghost}, now {now}, difference {between}");
        let text = RichText::new(*name).strong();
        let text = match vector_color(ui, name) {
            Some(color) => text.color(color),
            None => text,
        };
        ui.label(text).spoken(spoken);
    }
}

/// Shows text in a field that is this number of characters wide, so that nothing moves sideways while the
/// numbers change.
fn wide(ui: &mut Ui, characters: f32, text: RichText) {
    let response = ui.label(text);
    let width = 8.2 * characters;
    ui.add_space((width - response.rect.width()).max(0.0));
}

/// Shows vectors of both cameras, one above the other, and their difference.
fn vectors(ui: &mut Ui, name: &str, lines: &[ComparedLine], style: NumberStyle) {
    let characters = 3.0 * (style.digits as f32 + 2.8);
    Grid::new(name).num_columns(3).spacing([8.0, 2.0]).show(ui, |ui| {
        for head in ["", "now", "apart"] {
            ui.weak(head);
        }
        ui.end_row();
        for line in lines {
            line.name(ui);
            ui.horizontal(|ui| wide(ui, characters, RichText::new(&line.now)));
            ui.horizontal(|ui| wide(ui, 7.5, RichText::new(&line.between).strong()));
            ui.end_row();
            ui.weak(format!("{}′", line.name));
            ui.weak(&line.ghost);
            ui.end_row();
        }
    });
}

/// Shows numbers of both cameras, side by side.
fn scalars(ui: &mut Ui, lines: &[ComparedLine], style: NumberStyle) {
    let characters = style.digits as f32 + 2.6;
    Grid::new("scalars").num_columns(4).spacing([10.0, 2.0]).show(ui, |ui| {
        for head in ["", "ghost", "now", "difference"] {
            ui.weak(head);
        }
        ui.end_row();
        for line in lines {
            line.name(ui);
            for text in [&line.ghost, &line.now] {
                ui.horizontal(|ui| wide(ui, characters, RichText::new(text)));
            }
            ui.label(RichText::new(&line.between).strong());
            ui.end_row();
        }
    });
}

fn degrees(x: f64, style: NumberStyle) -> String {
    // A rounding error is not a turn.
    let x = if x.abs() < 1e-9 { 0.0 } else { x };
    format!("{}°", style.number(x))
}

fn signed(x: f64, style: NumberStyle) -> String {
    let sign = if x > 0.0 { "+" } else { "" };
    format!("{sign}{}", style.number(x))
}

/// Returns the lines of u, v, w.
fn turned(now: &ResolvedCamera, against: &AgainstGhost, style: NumberStyle) -> Vec<ComparedLine> {
    let (here, there, by) = (now.basis(), against.ghost.basis(), &against.difference);
    let vectors = [("u", here.u, there.u), ("v", here.v, there.v), ("w", here.w, there.w)];
    let line = |((name, here, there), angle)| {
        ComparedLine::new(name, style.vector(there), style.vector(here), degrees(angle, style))
    };
    vectors.into_iter().zip(by.basis).map(line).collect()
}

/// Returns the lines of eye, at, up.
fn moved(
    document: &Document,
    ghost: &Ghost,
    against: &AgainstGhost,
    style: NumberStyle,
) -> Vec<ComparedLine> {
    let (now, then, by) = (&document.camera, &ghost.camera, &against.difference);
    let vector = |v: DVec3| style.vector(v);
    let way = |v: DVec3| style.number(v.length());
    let at = |orientation: &Orientation| match orientation {
        Orientation::At { at, .. } => vector(*at),
        _ => "none".to_owned(),
    };
    let between = by.at.map(way).unwrap_or_default();
    vec![
        ComparedLine::new("eye", vector(then.eye), vector(now.eye), way(by.eye)),
        ComparedLine::new("at", at(&then.orientation), at(&now.orientation), between),
        ComparedLine::new("up", vector(then.up()), vector(now.up()), degrees(by.up, style)),
    ]
}

/// Shows the angles by which the camera is turned and rolled.
fn turns(ui: &mut Ui, against: &AgainstGhost, style: NumberStyle) {
    let by = &against.difference;
    let mut said = format!("turned by {}", degrees(by.turn, style));
    if let Some(roll) = by.roll {
        said += &format!(", rolled by {}", degrees(roll, style));
    }
    ui.strong(said);
}

/// Returns the lines of the viewport.
fn numbers(
    document: &Document,
    ghost: &Ghost,
    against: &AgainstGhost,
    style: NumberStyle,
) -> Vec<ComparedLine> {
    let by = &against.difference;
    let (old, new) = (ghost.camera.viewport, document.camera.viewport);
    let [width, height] = by.extent;
    let lines = [
        ("distance", old.distance, new.distance, by.distance),
        ("width", old.width, new.width, width),
        ("height", old.height, new.height, height),
    ];
    let line = |(name, old, new, by)| {
        ComparedLine::new(name, style.number(old), style.number(new), signed(by, style))
    };
    lines.map(line).to_vec()
}

/// Returns the lines about the first hit of the selected ray, for both cameras.
fn hits(
    now: Option<&Inspection>,
    ghost: &Inspection,
    document: &Document,
    style: NumberStyle,
) -> [ComparedLine; 2] {
    let (here, there) = (now.and_then(Inspection::first_hit), ghost.first_hit());
    // The names of objects do not fit; the list of objects shows their numbers as well.
    let kind = |hit: &Root| {
        let object = hit.object as usize;
        let kind = if object < document.sphere_count() { "sphere" } else { "plane" };
        format!("{kind} {object}")
    };
    let named = |hit: Option<&Root>| hit.map_or("nothing".to_owned(), kind);
    let t = |hit: Option<&Root>| hit.map_or("none".to_owned(), |hit| style.number(hit.t));
    let same = here.map(|hit| hit.object) == there.map(|hit| hit.object);
    let between = match (here, there) {
        (Some(here), Some(there)) => signed(here.t - there.t, style),
        _ => String::new(),
    };
    let hit = if same { "the same" } else { "another" };
    [
        ComparedLine::new("hit", named(there), named(here), hit.to_owned()),
        ComparedLine::new("t", t(there), t(here), between),
    ]
}
