//! The text about a drag or a step: beside the pointer, and for screen readers.

use std::time::Duration;

use egui::accesskit::Role;
use egui::{
    Align, Align2, CursorIcon, Id, PopupAnchor, Pos2, Rect, RectAlign, RichText, Sense, Ui, Vec2,
    vec2,
};
use pinhole_exchange::document::Document;

use super::dragging::{Dragging, View};
use super::steps::Way;
use super::view_rects::ViewRects;
use super::views::{CAMERA, WORLD};
use crate::model::concept::{HoverSource, Hovered};
use crate::model::interaction::{HANDLE_REACH, PAUSE};
use crate::model::session::Session;
use crate::model::session::handles::{Corner, Grabbed, Handle, HandleValues};
use crate::ui::widgets::fault_text;
use crate::ui::widgets::{Spoken as _, keep_arrows};
use crate::view::derive::Derived;
use crate::view::handles::{PlacedHandle, label, value};

/// Sizes of the text, in points: of the first line, and of the rest.
const FIRST: f32 = 19.0;
const REST: f32 = 15.0;

/// Distance from the pointer to the text, in points, across and down.
const GAP: f32 = 20.0;

impl Dragging {
    /// Shows the text about handles and steps, and notes where the views are now.
    pub(crate) fn tell(
        &mut self,
        ui: &Ui,
        rects: &ViewRects,
        (document, session): (&Document, &Session),
        shown: &Derived,
    ) {
        let view = |rect: Option<Rect>, name: &str| Some((rect?, ui.scope_id().with(name)));
        (self.world, self.camera) = (view(rects.world, WORLD), view(rects.camera, CAMERA));
        if let Some(view) = self.world_view(ui.ctx(), shown) {
            self.tell_handles(ui, &view, document, session);
        }
        if let Some(view) = self.camera {
            self.tell_steps(ui, view, document, session);
        }
    }

    fn tell_handles(&self, ui: &Ui, view: &View, document: &Document, session: &Session) {
        let all = view.placed(document, session);
        let spot = |one: &PlacedHandle| {
            view.rect.min + vec2(one.spot.x as f32, one.spot.y as f32) / view.scale
        };
        for one in &all {
            node(ui, view, one.handle, spot(one), document, session);
        }
        let Some(handle) = session.handles.over else { return };
        let is_held = session.handles.drag.is_some();
        let by_pointer = is_held || self.by_pointer;
        if by_pointer {
            ui.ctx().set_cursor_icon(if is_held { CursorIcon::Grabbing } else { CursorIcon::Grab });
        }
        let own = all.iter().find(|one| one.handle == handle).map(spot);
        // A held handle may have no place for a while, when the viewport has no area.
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| by_pointer);
        let Some(at) = pointer.or(own) else { return };
        let text = value_of(handle, 6, document, session);
        let mut lines = vec![match handle.object() {
            Some(object) => format!("{}: {text}", document.title_of(object)),
            None => text,
        }];
        match session.hovered {
            Some(Hovered { concept, by: HoverSource::View }) if !is_held => {
                lines.push(concept.description(|object| document.title_of(object as usize)));
            }
            _ => {}
        }
        if self.up_went_along {
            lines.push("up turns with the camera".to_owned());
        }
        let refused = self.refused.filter(|_| is_held).map(|reason| reason.to_string());
        say(ui, view.id, at, at - view.rect.center(), &lines, refused);
    }

    /// Returns true if there is something to show about the camera view.
    pub(crate) fn has_word(&self, session: &Session, time: f64) -> bool {
        session.handles.drag.is_some_and(|drag| drag.handle().is_none())
            || self.recent.as_ref().is_some_and(|recent| recent.is_shown(time))
    }

    fn tell_steps(&self, ui: &Ui, (rect, id): (Rect, Id), document: &Document, session: &Session) {
        let time = ui.input(|i| i.time);
        let recent = self.recent.as_ref().filter(|recent| recent.is_shown(time));
        if let Some(recent) = recent {
            let left = Duration::from_secs_f64(PAUSE - (time - recent.time));
            ui.ctx().request_repaint_after(left);
        }
        let (way, by_keys) = match (session.handles.drag.map(|drag| drag.grabbed), recent) {
            (Some(Grabbed::Look), _) => (Way::Look, false),
            (Some(Grabbed::Orbit), _) => (Way::Orbit, false),
            (_, Some(recent)) => (recent.way, recent.by_keys),
            _ => return,
        };
        let by_at = document.camera.orientation.has_at();
        let corner = Handle::Corner(Corner { is_right: true, is_top: true });
        let (title, changed) = match way {
            Way::Look => ("look around", Handle::At),
            Way::Orbit if by_at => ("orbit around at", Handle::Eye),
            Way::Orbit => ("orbit", Handle::Eye),
            Way::Zoom => ("zoom: the field of view", corner),
            Way::Dolly => ("dolly: the eye along 𝐰", Handle::Dolly),
        };
        let lines = [title.to_owned(), value_of(changed, 5, document, session)];
        let pointer = ui.input(|i| i.pointer.latest_pos()).filter(|_| !by_keys);
        // The pointer has no part in key presses: show the text in the picture's lower left.
        let at = pointer.unwrap_or(rect.lerp_inside([0.0, 0.72]));
        let refused = self.refused.map(|reason| reason.to_string());
        say(ui, id, at, vec2(1.0, 1.0), &lines, refused);
    }
}

/// Returns a handle's value, with at most `digits` digits.
fn value_of(handle: Handle, digits: usize, document: &Document, session: &Session) -> String {
    let values = HandleValues::read(document, session.selection, handle.object());
    let settings = &session.settings;
    value(handle, &values, settings.digits.min(digits), settings.count_from_one)
}

/// Shows lines of text beside a position, on the side to which `away` points.
fn say(ui: &Ui, id: Id, at: Pos2, away: Vec2, lines: &[String], refused: Option<String>) {
    let align = |is_far: bool| if is_far { Align::Max } else { Align::Min };
    let side = RectAlign::outside(Align2([align(away.x >= 0.0), align(away.y >= 0.0)]));
    let anchor = PopupAnchor::ParentRect(Rect::from_center_size(at, Vec2::splat(2.0 * GAP)));
    let id = id.with("said");
    let mut tooltip =
        egui::Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, anchor).gap(0.0);
    tooltip.popup = tooltip.popup.align(side);
    tooltip.show(|ui| {
        for (k, text) in lines.iter().enumerate() {
            let text = match k {
                0 => RichText::new(text).size(FIRST).strong(),
                _ => RichText::new(text).size(REST),
            };
            ui.add(egui::Label::new(text).wrap_mode(egui::TextWrapMode::Extend));
        }
        if let Some(reason) = refused {
            ui.label(fault_text(ui, reason).size(REST));
        }
    });
}

/// Makes a handle focusable, with a name and a value for screen readers.
fn node(ui: &Ui, view: &View, handle: Handle, at: Pos2, document: &Document, session: &Session) {
    let rect = Rect::from_center_size(at, Vec2::splat(2.0 * HANDLE_REACH as f32));
    let response = ui.interact(rect, view.id_of(handle), Sense::focusable_noninteractive());
    keep_arrows(&response, true, true);
    let value = value_of(handle, usize::MAX, document, session);
    let response = response.with_role(Role::Slider).described(value);
    response.named(format!("{} handle", label(handle, document)));
}
