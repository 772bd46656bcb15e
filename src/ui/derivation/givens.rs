//! The given numbers in the derivation: each can be dragged, or typed over, where it stands.

use egui::{Id, Rect, Response, Stroke, Ui, pos2, vec2};

use crate::model::given::{Given, Givens};
use crate::ui::action::Action;
use crate::ui::widgets::number::NumberField;
use crate::view::formula::GivenBox;

/// Distance of the dots below a given number, and their radius, in points.
const BETWEEN_DOTS: f32 = 3.0;
const DOT: f32 = 0.7;

/// Shows the field of a given number over its digits in a formula whose first baseline begins at
/// `baseline`. An edit becomes an action, which is carried out before the frame is presented.
pub(super) fn field(
    ui: &mut Ui,
    shown: &GivenBox,
    baseline: egui::Pos2,
    givens: &Givens,
    size: f32,
    actions: &mut Vec<Action>,
) -> Option<Response> {
    let given = shown.given;
    let mut value = givens.value(given)?;
    let start = baseline + vec2(shown.at[0], shown.at[1]);
    let rect = Rect::from_min_max(
        start - vec2(0.0, shown.ascent),
        start + vec2(shown.width, shown.descent),
    );
    underline(ui, rect);
    let name = givens.name(given);
    let spoken = format!("derivation {name}");
    let mut field = NumberField::new(&spoken, &mut value).hint(&name);
    if let Some(range) = givens.whole_range(given) {
        field = field.whole().within(range);
    }
    // One digit alone is too narrow for a hand.
    let rect = rect.expand2(vec2((0.5 * (size - rect.width())).max(0.0), 1.0));
    let response = field.show_over(ui, id_of(given), rect, size);
    if response.changed() {
        actions.push(Action::Give(given, value));
    }
    Some(response)
}

fn id_of(given: Given) -> Id {
    Id::unique(("derivation number", given))
}

/// Marks a number as one that can be changed.
fn underline(ui: &Ui, rect: Rect) {
    let color = ui.visuals().weak_text_color();
    let y = rect.bottom() - 1.0;
    let dots = ((rect.width() / BETWEEN_DOTS).round() as usize).max(2);
    for k in 0..dots {
        let share = (k as f32 + 0.5) / dots as f32;
        let center = pos2(egui::lerp(rect.x_range(), share), y);
        ui.painter().circle(center, DOT, color, Stroke::NONE);
    }
}
