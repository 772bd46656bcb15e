//! The hint in the world view that the camera is too small on the screen for handles, and the
//! button that frames it.

use egui::{Align2, Button, FontId, Rect, RichText, Ui, vec2};
use pinhole_core::DVec2;
use pinhole_exchange::document::Document;

use crate::model::overlay_items::Item;
use crate::model::session::Session;
use crate::ui::action::Observe;
use crate::ui::commands_table::shortcut;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derive::Derived;
use crate::view::handles::{Stage, grips};

/// Size of the text, in points.
const TEXT: f32 = 15.0;

/// Distance from the view's edges and from handles, in points.
const GAP: f32 = 10.0;

/// The text, whose first part is left out if there is no room.
const WHY: &str = "Viewport too small for handles: ";
const DO: &str = "frame the camera";

/// Shows the hint in the world view, which fills `rect`. Returns true if the camera should be
/// framed.
pub(crate) fn hint(
    ui: &mut Ui,
    rect: Rect,
    shown: &Derived,
    document: &Document,
    session: &Session,
) -> bool {
    let items = session.settings.items;
    let is_wanted = items.shows(Item::Handles) && items.shows(Item::Viewport);
    let (Some(frame), true) = (shown.world_frame.as_deref(), is_wanted) else { return false };
    let scale = ui.ctx().pixels_per_point();
    let stage = Stage {
        document,
        resolved: shown.resolved.as_ref(),
        selection: session.selection,
        items,
        observer: frame.camera(),
        scale,
    };
    if session.hand.held.is_some() || !stage.is_viewport_small() {
        return false;
    }
    let keys = shortcut(Observe::FrameCamera);
    let texts = [format!("{WHY}{DO} ({keys})"), format!("Frame the camera ({keys})")];
    let fitting = texts.into_iter().find_map(|text| {
        let galley = ui.painter().layout_no_wrap(
            text.clone(),
            FontId::proportional(TEXT),
            ui.visuals().text_color(),
        );
        let size = galley.size() + 2.0 * ui.spacing().button_padding + vec2(2.0, 4.0);
        (size.x + 2.0 * GAP <= rect.width()).then_some((text, size))
    });
    let Some((text, size)) = fitting else { return false };
    let spots: Vec<_> = grips(&stage, &session.hand)
        .iter()
        .map(|grip| rect.min + points(grip.spot) / scale)
        .collect();
    // No handle may lie under the hint.
    let corners = [Align2::LEFT_BOTTOM, Align2::RIGHT_BOTTOM, Align2::LEFT_TOP, Align2::RIGHT_TOP];
    let clear = corners
        .map(|corner| corner.align_size_within_rect(size, rect.shrink(GAP)))
        .into_iter()
        .find(|clear| !spots.iter().any(|spot| clear.expand(2.0 * GAP).contains(*spot)));
    let Some(clear) = clear else { return false };
    let button = Button::new(RichText::new(text).size(TEXT));
    let why = "Its handles would lie over each other: they come with a larger picture of it";
    let response = ui.put(clear, button).on_hover_text(why).named("Frame the camera");
    response.clicked()
}

fn points(dots: DVec2) -> egui::Vec2 {
    vec2(dots.x as f32, dots.y as f32)
}
