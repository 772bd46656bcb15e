//! The text about handles: beside the pointer, and for screen readers.

use egui::accesskit::Role;
use egui::{
    Align, Align2, CursorIcon, Id, PopupAnchor, Pos2, Rect, RectAlign, RichText, Sense, Ui, Vec2,
    vec2,
};
use pinhole_core::DVec2;
use pinhole_core::steering::Keep;
use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::written;

use super::{HandInput, View, id_of};
use crate::model::concept::{HoverSource, Hovered};
use crate::model::letters::bold;
use crate::model::session::Session;
use crate::model::session::hand::{Along, Axis, Handle};
use crate::ui::widgets::fault::fault_text;
use crate::ui::widgets::spoken::{Spoken as _, keep_arrows};
use crate::view::derive::Derived;
use crate::view::handles::{HandleValues, grips, label, value};

/// Sizes of the text, in points: of the value, and of the rest.
const VALUE: f32 = 19.0;
const REST: f32 = 15.0;

/// Distance from the pointer to the text, in points, across and down.
const GAP: f32 = 20.0;

/// Time until the hint appears that explains how a hovered handle is dragged, in seconds.
const HINT: f64 = 0.7;

impl HandInput {
    /// Shows the text about the handles in the world view, which is at `view` now.
    pub(crate) fn tell(
        &mut self,
        ui: &Ui,
        view: Option<(Rect, Id)>,
        shown: &Derived,
        document: &Document,
        session: &Session,
    ) {
        self.view = view;
        let (Some((rect, id)), Some(frame)) = (view, shown.world_frame.as_deref()) else { return };
        let scale = ui.ctx().pixels_per_point();
        let view = View { rect, id, observer: frame.camera(), scale };
        nodes(ui, &view, shown, document, session);
        let hand = &session.hand;
        let Some(handle) = hand.over else { return };
        let by_pointer = hand.held.is_some() || hand.together > 0;
        if by_pointer {
            let held = hand.held.is_some();
            ui.ctx().set_cursor_icon(if held { CursorIcon::Grabbing } else { CursorIcon::Grab });
        }
        let all = grips(&view.stage(document, shown.resolved.as_ref(), session), hand);
        let point = |spot: DVec2| rect.min + vec2(spot.x as f32, spot.y as f32) / scale;
        let own = all.iter().find(|grip| grip.handle == handle).map(|grip| point(grip.spot));
        // A held handle may have no place for a while, when the viewport has no area.
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| by_pointer);
        let Some(spot) = pointer.or(own) else { return };
        let others: Vec<_> = all.iter().filter(|g| g.handle.object().is_none()).collect();
        let middle =
            others.iter().map(|grip| grip.spot).sum::<DVec2>() / others.len().max(1) as f64;
        let lines = self.lines(ui, handle, document, session);
        // Away from the camera, so that the text does not cover it.
        say(ui, id, spot, spot - point(middle), &lines, self.refused.as_deref());
    }

    fn lines(
        &self,
        ui: &Ui,
        handle: Handle,
        document: &Document,
        session: &Session,
    ) -> Vec<String> {
        let settings = &session.settings;
        let part = HandleValues::read(handle, document, session.selection);
        let text = value(handle, &part, settings.digits.min(6), settings.count_from_one);
        let mut lines = vec![match handle.object() {
            Some(object) => format!("{}: {text}", document.title_of(object)),
            None => text,
        }];
        if session.hand.held.is_some() {
            self.say_held(&mut lines, handle, session);
        } else {
            if let Some(Hovered { concept, by: HoverSource::View }) = session.hovered {
                lines.push(concept.description(|object| document.title_of(object as usize)));
            }
            let rested = ui.input(|i| i.time) - self.over_since;
            if rested >= HINT {
                say_hint(&mut lines, handle, session);
            } else {
                let left = std::time::Duration::from_secs_f64(HINT - rested);
                ui.ctx().request_repaint_after(left);
            }
        }
        lines
    }

    fn say_held(&self, lines: &mut Vec<String>, handle: Handle, session: &Session) {
        let last = self.last.as_ref();
        if handle.is_free() {
            match session.hand.along {
                Along::View => {}
                Along::Axis(axis) => lines.push(format!("along {}", written_axis(axis))),
                Along::Without(axis) => {
                    let [a, b] = axis.others().map(written_axis);
                    lines.push(format!("in the plane of {a} and {b}"));
                }
            }
        }
        if let Some(degrees) = last.and_then(|last| last.rolled) {
            lines.push(format!("rolled by {}°", written(degrees, 4)));
        }
        if let Some(step) = last.and_then(|last| last.step) {
            let unit = if handle == Handle::Roll { "°" } else { "" };
            lines.push(format!("in steps of {}{unit}", written(step, 3)));
        }
        if handle == Handle::Eye {
            lines.push(eye_keeps(session.settings.eye_keeps).to_owned());
        }
        if matches!(handle, Handle::Corner(_) | Handle::Distance) && session.settings.keep_picture {
            lines.push("the picture stays".to_owned());
        }
        if last.is_some_and(|last| last.up_went_along) {
            lines.push("up turns with the camera".to_owned());
        }
    }
}

/// Returns an axis's letter; a vector's is bold.
fn written_axis(axis: Axis) -> String {
    let is_vector = matches!(axis, Axis::U | Axis::V | Axis::W);
    axis.name().chars().map(|letter| if is_vector { bold(letter) } else { letter }).collect()
}

fn eye_keeps(keep: Keep) -> &'static str {
    match keep {
        Keep::At => "orbit: at stays",
        Keep::View => "travel: view stays",
    }
}

fn say_hint(lines: &mut Vec<String>, handle: Handle, session: &Session) {
    let what = match handle {
        Handle::Eye => {
            let keeps = session.settings.eye_keeps;
            let other = match keeps {
                Keep::At => "travel",
                Keep::View => "orbit",
            };
            format!("{}; K or Alt: {other}", eye_keeps(keeps))
        }
        Handle::At => "the camera turns to it".to_owned(),
        Handle::Up => "the tip of up".to_owned(),
        Handle::Roll => "roll: around 𝐰".to_owned(),
        Handle::Dolly => "dolly: the eye along 𝐰".to_owned(),
        Handle::Corner(_) => "the viewport's corner; U: width; V: height".to_owned(),
        Handle::Distance => "along 𝐰".to_owned(),
        Handle::Pixel => "the selected pixel, on the viewport".to_owned(),
        Handle::Center(_) | Handle::Radius(_) | Handle::Point(_) => String::new(),
        Handle::Normal(_) => "the tip of the normal".to_owned(),
    };
    lines.extend((!what.is_empty()).then_some(what));
    if handle.is_free() {
        lines.push(
            "X Y Z U V W: along that axis; with Shift: in the plane of the other two".to_owned(),
        );
    }
    if session.hand.together > 1 {
        lines.push(format!("{} handles are here; click for the next", session.hand.together));
    }
}

/// Shows lines of text beside a position, on the side to which `away` points.
pub(crate) fn say(
    ui: &Ui,
    id: Id,
    view: Pos2,
    away: Vec2,
    lines: &[String],
    refused: Option<&str>,
) {
    let side = |right: bool, below: bool| {
        let align = |far: bool| if far { Align::Max } else { Align::Min };
        let parent = Align2([align(right), align(below)]);
        RectAlign { parent, child: Align2([align(!right), align(!below)]) }
    };
    let (right, below) = (away.x >= 0.0, away.y >= 0.0);
    let anchor = PopupAnchor::ParentRect(Rect::from_center_size(view, Vec2::splat(2.0 * GAP)));
    let id = id.with("said");
    let mut tooltip =
        egui::Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, anchor).gap(0.0);
    let others = [side(right, !below), side(!right, below), side(!right, !below)];
    tooltip.popup = tooltip.popup.align(side(right, below)).align_alternatives(&others);
    tooltip.show(|ui| {
        let mut line = |text: RichText| {
            ui.add(egui::Label::new(text).wrap_mode(egui::TextWrapMode::Extend));
        };
        for (k, text) in lines.iter().enumerate() {
            match k {
                0 => line(RichText::new(text).size(VALUE).strong()),
                _ => line(RichText::new(text).size(REST)),
            }
        }
        if let Some(reason) = refused {
            ui.label(fault_text(ui, reason).size(REST));
        }
    });
}

/// Makes every handle focusable, with a label and a description for screen readers.
fn nodes(ui: &Ui, view: &View, shown: &Derived, document: &Document, session: &Session) {
    let settings = &session.settings;
    for grip in grips(&view.stage(document, shown.resolved.as_ref(), session), &session.hand) {
        let spot = view.rect.min + vec2(grip.spot.x as f32, grip.spot.y as f32) / view.scale;
        let rect = Rect::from_center_size(spot, Vec2::splat(2.0 * super::REACH as f32));
        let id = id_of(view.id, grip.handle);
        let part = HandleValues::read(grip.handle, document, session.selection);
        let value = value(grip.handle, &part, settings.digits, settings.count_from_one);
        let response = ui.interact(rect, id, Sense::focusable_noninteractive());
        keep_arrows(&response, true, true);
        let response = response.with_role(Role::Slider).described(value);
        response.named(format!("{} handle", label(grip.handle, document)));
    }
}
