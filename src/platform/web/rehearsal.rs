//! What a first drag runs, run before it. WebKit compiles a function that has vector instructions when it is
//! first called, and everything waits: for that, and for whatever else is being compiled.

use std::cell::RefCell;

use egui::{
    Context, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, ViewportId, pos2, vec2,
};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Remembered;
use crate::platform::start;
use crate::ui::app::App;

thread_local! {
    /// A copy of the program that nobody sees.
    static UNSEEN: RefCell<Option<(Context, App)>> = const { RefCell::new(None) };
}

/// Makes a copy of the program or, if there is one, runs its next frame, with the pointer at a place of its window
/// of 1600 x 900 points. There, the left or the right button may be pressed or released. With the last frame, the
/// copy is gone, and what a screen reader would hear of it is returned.
#[wasm_bindgen]
pub fn rehearse(
    x: f32,
    y: f32,
    is_left: Option<bool>,
    pressed: bool,
    last: bool,
) -> Option<String> {
    let Some((ctx, mut app)) = UNSEEN.take() else {
        let (ctx, remembered) = (Context::default(), Remembered::default());
        App::set_up(&ctx, &remembered.settings);
        ctx.run_ui(RawInput::default(), |_| {}).drop_without_applying_deltas();
        UNSEEN.set(start(None, None, None, remembered).ok().map(|app| (ctx, app)));
        return None;
    };
    let pos = pos2(x, y);
    let button =
        is_left.map(|left| if left { PointerButton::Primary } else { PointerButton::Secondary });
    let change = |button| Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE };
    let mut input = RawInput {
        screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(1600.0, 900.0))),
        events: [Event::PointerMoved(pos)].into_iter().chain(button.map(change)).collect(),
        ..RawInput::default()
    };
    // Few pixels are drawn by the same functions as many.
    input.viewports.entry(ViewportId::ROOT).or_default().native_pixels_per_point = Some(0.25);
    let mut output = ctx.run_ui(input, |ui| app.ui(ui));
    output.textures_delta.clear();
    ctx.tessellate(output.shapes, output.pixels_per_point);
    if last {
        return Some(app.spoken());
    }
    UNSEEN.set(Some((ctx, app)));
    None
}
