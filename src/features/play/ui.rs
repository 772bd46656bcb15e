//! The strip with the controls of the open animation.

use egui::{Checkbox, RichText, Slider, Ui};
use pinhole_figure::typesetting::theme::{STACKED, error_color};

use crate::features::play::Player;
use crate::features::play::state::Kind;
use crate::ui::action::{FigureAction, PlayAction, request};
use crate::ui::commands_table::hint;
use crate::ui::widgets::{ResponseExt as _, combo};

/// Size of the text, in points.
const TEXT: f32 = 15.5;

/// Width of the strip with the controls, in points, below which its right part moves to a second row.
const NARROW: f32 = 1180.0;

/// Width reserved for the animation's current position, in points.
const PLACE: f32 = 64.0;
/// Width reserved for the position of the animation that scans the pixels, in points.
const SCAN_PLACE: f32 = 196.0;

/// Shows the strip with the animation's controls. Changes that cannot be made in place are requested as
/// actions. While presenting, it is one thin line.
pub(crate) fn ui(ui: &mut Ui, player: &mut Player, is_presenting: bool) {
    ui.style_mut().override_font_id = Some(egui::FontId::proportional(TEXT));
    ui.add_space(3.0);
    let is_narrow = ui.available_width() < NARROW && !is_presenting;
    let right_to_left = egui::Layout::right_to_left(egui::Align::Center);
    ui.horizontal_wrapped(|ui| {
        if !is_presenting {
            kinds(ui, player.kind);
        }
        let (text, name) = if player.running { ("Pause", "Pause") } else { ("Play", "Resume") };
        button(ui, [text, name], PlayAction::Toggle);
        if !is_presenting {
            button(ui, ["← Step", "Step back"], PlayAction::Step(-1));
            button(ui, ["Step →", "Step forward"], PlayAction::Step(1));
            speed(ui, &mut player.speed);
            ui.add(Checkbox::new(&mut player.loops, "Loop")).on_hover_text(hint(PlayAction::Loop));
        }
        if !is_narrow {
            ui.with_layout(right_to_left, |ui| {
                ends(ui, is_presenting);
                position(ui, player);
            });
        }
    });
    if is_narrow {
        let row = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let is_stacked = row.x < STACKED && player.kind == Kind::Scan;
        ui.allocate_ui_with_layout(row, right_to_left, |ui| {
            ends(ui, false);
            if !is_stacked {
                position(ui, player);
            }
        });
        if is_stacked {
            ui.allocate_ui_with_layout(row, right_to_left, |ui| position(ui, player));
        }
    }
    if let Some(fault) = player.fault {
        ui.label(RichText::new(fault.to_string()).strong().color(error_color(ui)));
    }
    ui.add_space(2.0);
}

/// Shows a button with its text and its accessible name.
fn button(ui: &mut Ui, [text, name]: [&str; 2], play: PlayAction) {
    ui.button(text).on_hover_text(hint(play)).named(name).asks(play);
}

/// Shows, from right to left, the buttons that end or export the animation.
fn ends(ui: &mut Ui, is_presenting: bool) {
    button(ui, ["Stop", "Stop and go back"], PlayAction::Close);
    if is_presenting {
        return;
    }
    button(ui, ["Keep", "Keep this"], PlayAction::Keep);
    ui.button("Export…").asks(FigureAction::AskAnimation);
}

/// Shows the choice of animation.
fn kinds(ui: &mut Ui, now: Kind) {
    combo(ui, "what moves", 206.0, now.label(), |ui| {
        for kind in Kind::ALL {
            if ui.selectable_label(kind == now, kind.label()).clicked() && kind != now {
                request(ui.ctx(), PlayAction::Open(kind));
            }
        }
    });
}

fn speed(ui: &mut Ui, speed: &mut f64) {
    let text = |speed: f64| format!("{speed}×");
    combo(ui, "speed", 64.0, &text(*speed), |ui| {
        for choice in Player::SPEEDS {
            ui.selectable_value(speed, choice, text(choice));
        }
    });
}

/// Shows, from right to left, the animation's current position as text and as a slider. Dragging the slider
/// pauses the animation.
fn position(ui: &mut Ui, player: &mut Player) {
    let width = if player.kind == Kind::Scan { SCAN_PLACE } else { PLACE };
    let height = ui.spacing().interact_size.y;
    ui.allocate_ui(egui::vec2(width, height), |ui| {
        ui.set_min_width(width);
        ui.label(RichText::new(player.position()).strong());
    });
    ui.spacing_mut().slider_width = (ui.available_width() - 12.0).max(60.0);
    let response =
        ui.add(Slider::new(&mut player.phase, 0.0..=1.0).show_value(false)).named("position");
    if response.changed() || response.dragged() {
        (player.begun, player.running) = (true, false);
    }
}
