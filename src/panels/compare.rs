//! The comparison with the ghost: its picture or where it differs beside the camera view, and both
//! cameras in numbers below.

use egui::{Grid, Rect, RichText, ScrollArea, Ui, UiBuilder, pos2};
use pinhole_core::{DVec3, Orientation, PosedCamera};

use super::number::vector_color;
use super::places::STRIP;
use super::readouts::NumberStyle;
use super::views;
use crate::action::{Action, GhostMove};
use crate::derive::Derived;
use crate::document::Document;
use crate::ghost::{AgainstGhost, Beside, Ghost};
use crate::inspection::Inspection;
use crate::number::grouped;

/// Size of the text, in points.
const TEXT: f32 = 15.5;

/// What is said where there is no ghost.
const NO_GHOST: &str = "Freeze the camera to compare with it: press G.";

/// What can be done with the ghost, as a menu.
pub(crate) fn menu(ui: &mut Ui, has_ghost: bool, actions: &mut Vec<Action>) {
    for (text, keys, ghost, needs_one) in [
        ("Freeze the camera as ghost", "G", GhostMove::Freeze, false),
        ("Swap camera and ghost", "", GhostMove::Swap, true),
        ("Drop the ghost", "Shift+G", GhostMove::Drop, true),
    ] {
        let button = egui::Button::new(text).shortcut_text(keys);
        if ui.add_enabled(has_ghost || !needs_one, button).clicked() {
            actions.push(Action::Ghost(ghost));
        }
    }
}

/// Above the picture beside the camera view: which of the two it is.
pub(crate) fn strip(ui: &mut Ui, area: Rect, ghost: &mut Option<Ghost>) {
    let above = Rect::from_min_max(pos2(area.left(), area.top() - STRIP), area.right_top());
    ui.scope_builder(UiBuilder::new().max_rect(above), |ui| {
        ui.horizontal_centered(|ui| match ghost {
            None => {
                ui.strong(views::GHOST);
            }
            Some(Ghost { beside, .. }) => {
                ui.selectable_value(beside, Beside::Picture, views::GHOST);
                ui.selectable_value(beside, Beside::Differences, "Differences");
            }
        });
    });
}

/// What a screen reader says of it.
pub(crate) fn spoken(against: Option<&AgainstGhost>) -> String {
    against.map_or_else(|| NO_GHOST.to_owned(), seen)
}

/// Why there is no picture, in its place.
pub(crate) fn no_picture(ui: &mut Ui, rect: Rect, ghost: Option<&Ghost>) {
    ui.painter().rect_filled(rect, 4.0, ui.visuals().faint_bg_color);
    let text = match ghost.map(|ghost| ghost.camera.posed()) {
        None => NO_GHOST.to_owned(),
        Some(Err(error)) => format!("The ghost sees nothing: {error}"),
        Some(Ok(_)) => "There are no two cameras to compare.".to_owned(),
    };
    ui.scope_builder(UiBuilder::new().max_rect(rect.shrink(16.0)), |ui| {
        ui.add_space((0.5 * rect.height() - 40.0).max(0.0));
        ui.vertical_centered(|ui| ui.label(RichText::new(text).size(17.0).strong()));
    });
}

/// `12,345 of 90,000 pixels shown see another object`
fn seen(against: &AgainstGhost) -> String {
    let [differing, pixels] =
        [against.seen.differing, against.seen.pixels].map(|n| grouped(n as u64));
    format!("{differing} of {pixels} pixels shown see another object")
}

/// What is done with the ghost, and both cameras in numbers.
pub(crate) fn ui(
    ui: &mut Ui,
    derived: &Derived,
    document: &Document,
    ghost: Option<&Ghost>,
    style: NumberStyle,
    actions: &mut Vec<Action>,
) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        ui.horizontal(|ui| {
            menu(ui, ghost.is_some(), actions);
            if let Some(against) = &derived.against_ghost {
                ui.add_space(12.0);
                ui.strong(seen(against));
            }
        });
        let (Some(against), Some(ghost), Some(now)) =
            (derived.against_ghost.as_deref(), ghost, &derived.posed)
        else {
            return;
        };
        ui.horizontal_top(|ui| {
            table(ui, "turned", &turned(now, against, style));
            ui.separator();
            table(ui, "moved", &moved(document, ghost, against, style));
            ui.separator();
            let here = derived.inspection.as_deref();
            table(ui, "seen", &hits(here, &against.inspection, document, style));
        });
    });
}

/// A quantity of the ghost, of the camera at hand, and what lies between the two.
struct Line {
    name: &'static str,
    ghost: String,
    now: String,
    between: String,
}

impl Line {
    fn new(name: &'static str, ghost: String, now: String, between: String) -> Line {
        Line { name, ghost, now, between }
    }

    fn of_number(name: &'static str, ghost: f64, now: f64, style: NumberStyle) -> Line {
        Line::new(name, style.number(ghost), style.number(now), signed(now - ghost, style))
    }
}

fn table(ui: &mut Ui, name: &str, lines: &[Line]) {
    Grid::new(name).num_columns(4).spacing([16.0, 3.0]).show(ui, |ui| {
        for head in ["", "ghost", "now", "difference"] {
            ui.weak(head);
        }
        ui.end_row();
        for Line { name, ghost, now, between } in lines {
            let text = RichText::new(*name).strong();
            let spoken = format!("{name}: ghost {ghost}, now {now}, difference {between}");
            let response = ui.label(match vector_color(ui, name) {
                Some(color) => text.color(color),
                None => text,
            });
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(spoken));
            ui.label(ghost);
            ui.label(now);
            ui.label(RichText::new(between).strong());
            ui.end_row();
        }
    });
}

fn degrees(x: f64, style: NumberStyle) -> String {
    // Rounding alone is no turn.
    let x = if x.abs() < 1e-9 { 0.0 } else { x };
    format!("{}°", style.number(x))
}

fn signed(x: f64, style: NumberStyle) -> String {
    let sign = if x > 0.0 { "+" } else { "" };
    format!("{sign}{}", style.number(x))
}

/// u, v, w and how the camera is turned and rolled.
fn turned(now: &PosedCamera, against: &AgainstGhost, style: NumberStyle) -> Vec<Line> {
    let (here, there, by) = (now.basis(), against.ghost.basis(), &against.difference);
    let vectors = [("u", here.u, there.u), ("v", here.v, there.v), ("w", here.w, there.w)];
    let mut lines: Vec<Line> = vectors
        .into_iter()
        .zip(by.basis)
        .map(|((name, here, there), angle)| {
            Line::new(name, style.vector(there), style.vector(here), degrees(angle, style))
        })
        .collect();
    let nothing = String::new;
    lines.push(Line::new("turned by", nothing(), nothing(), degrees(by.turn, style)));
    let roll = by.roll.map_or("up′ is along view".to_owned(), |roll| degrees(roll, style));
    lines.push(Line::new("rolled by", nothing(), nothing(), roll));
    lines
}

/// eye, at, up and the viewport.
fn moved(
    document: &Document,
    ghost: &Ghost,
    against: &AgainstGhost,
    style: NumberStyle,
) -> Vec<Line> {
    let (now, then, by) = (&document.camera, &ghost.camera, &against.difference);
    let vector = |v: DVec3| style.vector(v);
    let way = |v: DVec3| format!("{}, length {}", vector(v), style.number(v.length()));
    let mut lines = vec![Line::new("eye", vector(then.eye), vector(now.eye), way(by.eye))];
    let at = |orientation: &Orientation| match orientation {
        Orientation::At { at, .. } => vector(*at),
        _ => "none".to_owned(),
    };
    let between = by.at.map(way).unwrap_or_default();
    lines.push(Line::new("at", at(&then.orientation), at(&now.orientation), between));
    lines.push(Line::new("up", vector(then.up()), vector(now.up()), degrees(by.up, style)));
    let (old, new) = (then.viewport, now.viewport);
    for (name, old, new) in [
        ("distance", old.distance, new.distance),
        ("width", old.width, new.width),
        ("height", old.height, new.height),
    ] {
        lines.push(Line::of_number(name, old, new, style));
    }
    lines
}

/// What the selected ray hits, of both cameras.
fn hits(
    now: Option<&Inspection>,
    ghost: &Inspection,
    document: &Document,
    style: NumberStyle,
) -> Vec<Line> {
    let (here, there) = (now.and_then(Inspection::first_hit), ghost.first_hit());
    let named = |hit: Option<&pinhole_core::Root>| {
        hit.map_or("nothing".to_owned(), |hit| document.title_of(hit.object as usize))
    };
    let t =
        |hit: Option<&pinhole_core::Root>| hit.map_or("—".to_owned(), |hit| style.number(hit.t));
    let same = here.map(|hit| hit.object) == there.map(|hit| hit.object);
    let between = match (here, there) {
        (Some(here), Some(there)) => signed(here.t - there.t, style),
        _ => String::new(),
    };
    let hit = if same { "the same" } else { "another" };
    vec![
        Line::new("hit", named(there), named(here), hit.to_owned()),
        Line::new("t", t(there), t(here), between),
    ]
}
