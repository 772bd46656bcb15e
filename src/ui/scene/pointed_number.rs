//! Pointing at a number below the views: what it is of becomes thicker in both views.

use egui::{Context, Id, Response};

use crate::model::concept::{Concept, HoverSource, Hovered};
use crate::view::derive::Derived;

/// The number that the mouse rested on in the last pass: its label's id, and its name.
#[derive(Clone, Copy, PartialEq)]
struct Pointed(Id, &'static str);

fn key() -> Id {
    Id::unique("number that is pointed at")
}

/// Takes note of the mouse on the label of the number with this name.
pub(super) fn point(response: &Response, name: &'static str) {
    if !response.hovered() {
        return;
    }
    let now = Pointed(response.id, name);
    if response.ctx.data(|data| data.get_temp(key())) != Some(now) {
        response.ctx.data_mut(|data| data.insert_temp(key(), now));
        // The views, which are derived before the numbers are shown, follow in the next pass.
        response.ctx.request_repaint();
    }
}

/// Returns the concept of the number under the mouse, if the views draw it.
pub(crate) fn hovered(ctx: &Context, derived: &Derived) -> Option<Hovered> {
    let Pointed(id, name) = ctx.data(|data| data.get_temp(key()))?;
    if !ctx.read_response(id).is_some_and(|response| response.hovered()) {
        ctx.data_mut(|data| data.remove::<Pointed>(key()));
        return None;
    }
    let inspection = derived.inspection.as_ref();
    let hit = || Some(inspection?.concept_of(inspection?.first_hit()?));
    let concept = match name {
        "u" => Concept::U,
        "v" => Concept::V,
        "w" => Concept::W,
        "angle(up, view)" | "sensitivity" => Concept::Up,
        "pixel" | "(u, v)" => Concept::Pixel,
        "p" => Concept::Eye,
        "d" | "|d|" => Concept::Direction,
        "t" | "hit" => hit()?,
        _ => return None,
    };
    Some(Hovered { concept, by: HoverSource::Numbers })
}
