//! Fields for numbers: drag, type, or type arithmetic. Each has a name for screen readers and
//! tests, and says so where what was typed is no number.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{Color32, Context, DragValue, FontId, Id, Response, RichText, Ui};
use pinhole_core::{DVec3, shortest};

use crate::model::expression::evaluate;
pub(crate) use crate::model::number::significant;
use crate::view::typesetting::theme::{self, error_color};

/// Significant digits shown in a field that is not being typed in.
const FIELD_DIGITS: usize = 5;

/// And these in any case.
const LEAST_DIGITS: usize = 2;

/// One number to edit.
pub(crate) struct NumberField<'a> {
    name: &'a str,
    value: &'a mut f64,
    suffix: &'a str,
    width: f32,
    range: RangeInclusive<f64>,
}

impl<'a> NumberField<'a> {
    /// A field whose accessible name is `name`.
    pub(crate) fn new(name: &'a str, value: &'a mut f64) -> Self {
        NumberField { name, value, suffix: "", width: 78.0, range: f64::MIN..=f64::MAX }
    }

    /// A unit behind the number.
    pub(crate) fn suffix(mut self, suffix: &'a str) -> Self {
        self.suffix = suffix;
        self
    }

    /// Which numbers it takes: a drag stops at the ends, and what is typed beyond them is refused.
    pub(crate) fn within(mut self, range: RangeInclusive<f64>) -> Self {
        self.range = range;
        self
    }

    /// How wide the field is, in points.
    pub(crate) fn width(mut self, width: f32) -> Self {
        self.width = width;
        self
    }

    /// Shows the field; the response says whether the number changed.
    pub(crate) fn show(self, ui: &mut Ui) -> Response {
        let id = ui.next_auto_id();
        let typing = ui.memory(|memory| memory.has_focus(id));
        let speed = drag_speed(ui, id, *self.value);
        let fault: RefCell<Option<String>> = RefCell::new(None);
        let exact = *self.value;
        let room = self.width - 2.0 * ui.spacing().button_padding.x;
        let font = ui.style().drag_value_text_style.resolve(ui.style());
        let short = |value: f64| fitting(ui.ctx(), value, self.suffix, &font, room);
        let shown_whole = short(exact) == shortest(exact);
        let (ctx, suffix) = (ui.ctx().clone(), self.suffix);
        let field = DragValue::new(self.value)
            .speed(speed)
            .range(self.range.clone())
            .clamp_existing_to_range(false)
            .suffix(if typing { "" } else { self.suffix })
            .clip_text(true)
            // While `0.5` is typed, the camera need not go through `0`.
            .update_while_editing(false)
            .min_size(egui::vec2(self.width, ui.spacing().interact_size.y))
            .custom_formatter(|value, _| match typing {
                true => shortest(value),
                false => fitting(&ctx, value, suffix, &font, room),
            })
            .custom_parser(|text| match evaluate(text).and_then(|x| in_range(x, &self.range)) {
                Ok(value) => {
                    *fault.borrow_mut() = Some(String::new());
                    Some(value)
                }
                Err(reason) => {
                    *fault.borrow_mut() = Some(reason);
                    None
                }
            });
        let response = ui.add(field);
        if response.clicked() && !typing {
            select_all(ui, &response, &shortest(exact));
        }
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(self.name));
        show_fault(ui, id, fault.into_inner(), &response);
        if typing || shown_whole || response.dragged() {
            response
        } else {
            response.on_hover_text(format!("{} = {}{}", self.name, shortest(exact), self.suffix))
        }
    }
}

/// The number with as many digits as there is room for, in points: a field that grew with its number
/// would push the views aside, under the hand that drags in them.
fn fitting(ctx: &Context, value: f64, suffix: &str, font: &FontId, room: f32) -> String {
    let fits = |text: &String| {
        let whole = format!("{text}{suffix}");
        // Most are short: no letter is wider than the font is high.
        let is_short = whole.chars().count() as f32 * font.size <= room;
        let laid_out = |fonts: &mut egui::epaint::FontsView<'_>| {
            fonts.layout_no_wrap(whole.clone(), font.clone(), Color32::WHITE).size().x
        };
        is_short || ctx.fonts_mut(laid_out) <= room
    };
    let mut texts = (LEAST_DIGITS..=FIELD_DIGITS).rev().map(|digits| rounded(value, digits));
    texts.find(fits).unwrap_or_else(|| rounded(value, LEAST_DIGITS))
}

/// The number, or which ones would do.
fn in_range(value: f64, range: &RangeInclusive<f64>) -> Result<f64, String> {
    if range.contains(&value) {
        return Ok(value);
    }
    let [value, from, to] = [value, *range.start(), *range.end()].map(shortest);
    Err(format!("{value} is not between {from} and {to}"))
}

/// A click starts typing with the exact number selected; egui would select only as much of it as
/// the rounded form is long.
fn select_all(ui: &Ui, response: &Response, exact: &str) {
    let mut state = TextEditState::load(ui.ctx(), response.id).unwrap_or_default();
    let end = CCursor::new(exact.chars().count());
    state.cursor.set_char_range(Some(CCursorRange::two(CCursor::default(), end)));
    state.store(ui.ctx(), response.id);
}

/// Under a field with something that is no number, the reason; until the next press of a button or
/// key, whatever it is for.
fn show_fault(ui: &Ui, id: Id, parsed: Option<String>, response: &Response) {
    let key = id.with("fault");
    let pressed = ui.input(|i| {
        i.pointer.any_pressed()
            || i.events.iter().any(|e| matches!(e, egui::Event::Key { pressed: true, .. }))
    });
    if let Some(reason) = parsed {
        ui.data_mut(|data| data.insert_temp(key, reason));
    } else if pressed {
        ui.data_mut(|data| data.remove::<String>(key));
    }
    let reason = ui.data(|data| data.get_temp::<String>(key)).unwrap_or_default();
    if !reason.is_empty() {
        let color = error_color(ui);
        let stroke = egui::Stroke::new(1.5, color);
        ui.painter().rect_stroke(response.rect, 2.0, stroke, egui::StrokeKind::Inside);
        let anchor = egui::PopupAnchor::from(response);
        egui::Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), key, anchor)
            .show(|ui| ui.label(RichText::new(reason).color(color)));
    }
}

/// A hundredth of the number's size a point, fixed when the drag begins: a speed that grew with the
/// value would run away under the hand.
fn drag_speed(ui: &Ui, id: Id, value: f64) -> f64 {
    let key = id.with("speed");
    let held = ui.ctx().is_being_dragged(id);
    if held && let Some(speed) = ui.data(|data| data.get_temp::<f64>(key)) {
        return speed;
    }
    let magnitude = value.abs();
    let speed = if magnitude == 0.0 || (0.1..10.0).contains(&magnitude) {
        0.01
    } else {
        10f64.powf(magnitude.log10().floor().clamp(-280.0, 280.0)) * 0.02
    };
    ui.data_mut(|data| data.insert_temp(key, speed));
    speed
}

/// `value` with at most that many significant digits, marked with `…` where digits are left out.
pub(crate) fn rounded(value: f64, digits: usize) -> String {
    let short = significant(value, digits);
    if short.parse() == Ok(value) { short } else { format!("{short}…") }
}

/// Three fields in a row, named `NAME x`, `NAME y`, `NAME z`. Whether one changed.
pub(crate) fn vector_row(ui: &mut Ui, name: &str, value: &mut DVec3) -> bool {
    let mut changed = false;
    let width = ((ui.available_width() - 2.0 * ui.spacing().item_spacing.x) / 3.0).max(56.0);
    for (axis, coordinate) in [("x", &mut value.x), ("y", &mut value.y), ("z", &mut value.z)] {
        let field = NumberField::new(&format!("{name} {axis}"), coordinate).width(width).show(ui);
        changed |= field.changed();
    }
    changed
}

/// The colour that a vector has in the views; `None` for the other names.
pub(crate) fn vector_color(ui: &Ui, name: &str) -> Option<Color32> {
    let style = theme::style(ui);
    let colors = style.colors();
    Some(match name {
        "u" => colors.basis[0],
        "v" => colors.basis[1],
        "w" => colors.basis[2],
        "at" | "view" | "up" => colors.given,
        "p" | "d" => colors.ray,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::rounded;
    use super::significant;

    #[test]
    fn rounded_numbers_say_so() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (0.1, "0.1"),
            (-0.25, "-0.25"),
            (0.7123456789012345, "0.712346…"),
            (1.0 / 3.0, "0.333333…"),
            (5000.0, "5000"),
            (-5001.25, "-5001.25"),
            (1e300, "1e300"),
            (1.5e-9, "1.5e-9"),
            (1234567.891, "1234568…"),
            (1e12, "1e12"),
            (123456.0, "123456"),
        ];
        for (value, text) in cases {
            assert_eq!(rounded(value, 6), text, "{value:?}");
        }
    }

    #[test]
    fn digits_are_significant_ones() {
        assert_eq!(significant(2f64.sqrt() * 5.0, 5), "7.0711");
        assert_eq!(significant(0.000123456, 3), "0.000123");
        assert_eq!(significant(-1.2 / 2f64.sqrt(), 12), "-0.848528137424");
        assert_eq!(significant(f64::NAN, 5), "beyond f64");
        assert_eq!(significant(f64::INFINITY, 5), "beyond f64");
    }
}
