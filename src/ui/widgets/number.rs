//! Number fields, which the user edits by dragging, by typing a number, or by typing arithmetic. Each has a
//! name for screen readers and tests, and shows an error if the typed text is not a number.

use std::cell::{Cell, RefCell};
use std::ops::RangeInclusive;

use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{
    Color32, Context, DragValue, FontId, Id, Rect, Response, RichText, Ui, UiBuilder, Vec2, vec2,
};
use pinhole_core::{DVec3, shortest};
use pinhole_figure::typesetting::theme::{self, error_color};
use pinhole_lecture::numbers::{written, written_whole};

use super::ResponseExt as _;
use crate::model::expression::evaluate;

/// Minimum number of significant digits.
const LEAST_DIGITS: usize = 2;

/// A field that edits one number.
pub(crate) struct NumberField<'a> {
    /// The accessible name.
    pub(crate) name: &'a str,
    /// The name before the number in the tooltip.
    pub(crate) hint: &'a str,
    pub(crate) value: &'a mut f64,
    /// The unit after the number.
    pub(crate) suffix: &'a str,
    /// The width of the field, in points.
    pub(crate) width: f32,
    /// The valid numbers. A drag stops at the ends of the range, and a typed number outside it is rejected.
    pub(crate) range: RangeInclusive<f64>,
    /// True if only whole numbers are valid.
    pub(crate) is_whole: bool,
    /// Where a typed pair such as `640 x 360` goes; `None` if the field is of a single number.
    pub(crate) pair: Option<&'a Cell<Option<[f64; 2]>>>,
    /// True if the field is invisible until the user types into it, because it lies over a number that
    /// the caller paints.
    pub(crate) is_over: bool,
}

impl<'a> NumberField<'a> {
    /// Creates a field with the accessible name `name`.
    pub(crate) fn new(name: &'a str, value: &'a mut f64) -> Self {
        let (suffix, width, range) = ("", 78.0, f64::MIN..=f64::MAX);
        let (is_whole, is_over) = (false, false);
        NumberField { name, hint: name, value, suffix, width, range, is_whole, pair: None, is_over }
    }

    /// Shows the field in `rect`, over a number that the caller paints. Until the user types into the
    /// field, it is invisible except for a tint under the pointer. `id` must be unique and the same in
    /// every pass.
    pub(crate) fn show_over(self, ui: &mut Ui, id: Id, rect: Rect, size: f32) -> Response {
        let known = ui.data(|data| data.get_temp::<Id>(id));
        let is_typed = known.is_some_and(|id| ui.memory(|memory| memory.has_focus(id)));
        let rect = if is_typed {
            let room = vec2(rect.width().max(3.5 * size) + 12.0, rect.height());
            Rect::from_min_size(rect.min - vec2(6.0, 0.0), room)
        } else {
            rect
        };
        let mut inside = ui.new_child(UiBuilder::new().scope_id(id).max_rect(rect));
        inside.spacing_mut().interact_size.y = rect.height();
        let style = inside.style_mut();
        let font = FontId::proportional(size);
        style.text_styles.insert(style.drag_value_text_style.clone(), font);
        if !is_typed {
            style.spacing.button_padding = Vec2::ZERO;
            let tint = style.visuals.selection.bg_fill.gamma_multiply(0.4);
            let widgets = &mut style.visuals.widgets;
            for (visuals, fill) in [
                (&mut widgets.inactive, Color32::TRANSPARENT),
                (&mut widgets.hovered, tint),
                (&mut widgets.active, tint),
            ] {
                visuals.weak_bg_fill = fill;
                visuals.bg_stroke = egui::Stroke::NONE;
                visuals.expansion = 1.0;
            }
        }
        let field = NumberField { is_over: true, width: rect.width(), ..self };
        let response = field.show(&mut inside);
        ui.data_mut(|data| data.insert_temp(id, response.id));
        response
    }

    /// Shows the field. The response is marked as changed if the number changed.
    pub(crate) fn show(self, ui: &mut Ui) -> Response {
        let id = ui.next_auto_id();
        let typing = ui.memory(|memory| memory.has_focus(id));
        if typing {
            ui.data_mut(|data| data.insert_temp(typed(), id));
        }
        let speed = if self.is_whole { 1.0 } else { drag_speed(ui, id, *self.value) };
        let begins = typing && ui.data(|data| data.get_temp::<bool>(id.with("typing"))).is_none();
        let is_given_up = is_given_up(ui, id);
        let fault: RefCell<Option<String>> = RefCell::new(None);
        let exact = *self.value;
        let room = self.width - 2.0 * ui.spacing().button_padding.x;
        let font = ui.style().drag_value_text_style.resolve(ui.style());
        let room = if self.is_over { f32::INFINITY } else { room };
        let short = |value: f64| fitting(ui.ctx(), value, self.suffix, &font, room);
        let rounded = short(exact);
        if begins && ui.data(|data| data.get_temp(id)).as_ref() == Some(&rounded) {
            // Tab has brought the focus, and egui has taken the rounded number for the text.
            ui.data_mut(|data| data.insert_temp(id, shortest(exact)));
            select_all(ui, id, &shortest(exact));
        }
        let shown_whole = rounded.replace('−', "-").parse() == Ok(exact);
        let (ctx, suffix, is_over) = (ui.ctx().clone(), self.suffix, self.is_over);
        let field = DragValue::new(&mut *self.value)
            .speed(speed)
            .range(self.range.clone())
            .clamp_existing_to_range(false)
            .suffix(if typing { "" } else { self.suffix })
            .clip_text(true)
            .max_decimals_opt(self.is_whole.then_some(0))
            // Typing `0.5` must not set the value to `0` after the first character.
            .update_while_editing(false)
            .min_size(egui::vec2(self.width, ui.spacing().interact_size.y))
            .custom_formatter(|value, _| match typing {
                true => shortest(value),
                false if is_over => String::new(),
                false => fitting(&ctx, value, suffix, &font, room),
            })
            .custom_parser(|text| {
                // The rounded number was not typed.
                if is_given_up || text == rounded {
                    return None;
                }
                let number = |text| in_range(evaluate(text)?, &self.range, self.is_whole);
                let parsed = match self.pair.zip(text.split_once(['x', '×'])) {
                    Some((pair, (first, second))) => number(first).and_then(|first| {
                        pair.set(Some([first, number(second)?]));
                        Ok(exact)
                    }),
                    None => number(text),
                };
                *fault.borrow_mut() = Some(parsed.clone().err().unwrap_or_default());
                parsed.ok()
            });
        let response = ui.add(field);
        if response.clicked() && !typing {
            select_all(ui, response.id, &shortest(exact));
        }
        let mut response = response.named(self.name);
        if is_over && !typing {
            response = response.spoken(written(*self.value, theme::installed(&ctx).digits));
        }
        show_fault(ui, id, fault.into_inner(), &response);
        if typing || shown_whole || response.dragged() {
            return response;
        }
        let (hint, exact) = (self.hint, written_whole(exact));
        response.on_hover_text(format!("{hint} = {exact}{suffix}"))
    }
}

fn typed() -> Id {
    Id::unique("the typed number")
}

/// Returns true if a number field has the focus.
pub fn is_typed(ctx: &Context) -> bool {
    let last = ctx.data(|data| data.get_temp::<Id>(typed()));
    last.is_some() && last == ctx.memory(|memory| memory.focused())
}

/// Formats the number with the settings' digits, or with as many as fit into `room`, in points. If the field
/// grew with its number, the views would move while the user drags in them.
fn fitting(ctx: &Context, value: f64, suffix: &str, font: &FontId, room: f32) -> String {
    let fits = |text: &String| {
        let whole = format!("{text}{suffix}");
        // Short texts need no layout, since no letter is wider than the height of the font.
        let is_short = whole.chars().count() as f32 * font.size <= room;
        let laid_out = |fonts: &mut egui::epaint::FontsView<'_>| {
            fonts.layout_no_wrap(whole.clone(), font.clone(), Color32::WHITE).size().x
        };
        is_short || ctx.fonts_mut(laid_out) <= room
    };
    let most = theme::installed(ctx).digits;
    let mut texts = (LEAST_DIGITS..=most).rev().map(|digits| written(value, digits));
    texts.find(fits).unwrap_or_else(|| written(value, LEAST_DIGITS))
}

/// Returns true if Escape ended the typing into a field. The typed text must then be discarded;
/// otherwise egui would accept it in the next pass, in which Escape is no longer pressed.
fn is_given_up(ui: &Ui, id: Id) -> bool {
    let key = id.with("typing");
    // True if Escape ended the typing in the last pass; false if the user was still typing.
    let before = ui.data_mut(|data| data.remove_temp::<bool>(key));
    let goes_on = ui.memory(|memory| memory.has_focus(id));
    let ends_now =
        !goes_on && before == Some(false) && ui.input(|input| input.key_pressed(egui::Key::Escape));
    if goes_on || ends_now {
        ui.data_mut(|data| data.insert_temp(key, ends_now));
    }
    ends_now || (!goes_on && before == Some(true))
}

/// Returns the number, or an error with the valid range.
fn in_range(value: f64, range: &RangeInclusive<f64>, is_whole: bool) -> Result<f64, String> {
    let is_in_range = range.contains(&value);
    if is_in_range && (!is_whole || value.fract() == 0.0) {
        return Ok(value);
    }
    let [value, from, to] = [value, *range.start(), *range.end()].map(written_whole);
    match is_in_range {
        true => Err(format!("{value} is not a whole number")),
        false => Err(format!("{value} is not between {from} and {to}")),
    }
}

/// Selects the whole exact number when typing starts. egui would select only as many characters as the
/// rounded number has.
fn select_all(ui: &Ui, id: Id, exact: &str) {
    let mut state = TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let end = CCursor::new(exact.chars().count());
    state.cursor.set_char_range(Some(CCursorRange::two(CCursor::default(), end)));
    state.store(ui.ctx(), id);
}

/// Shows the error below a field with invalid text, until the user next presses any button or key.
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

/// Returns the speed of a drag, which is about a hundredth of the number's magnitude per point. It is fixed
/// when the drag begins, because a speed that grew with the value would grow without limit.
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

/// Shows three fields in a row, named `NAME x`, `NAME y`, `NAME z`.
pub(crate) fn vector_row(ui: &mut Ui, name: &str, value: &mut DVec3) {
    let width = ((ui.available_width() - 2.0 * ui.spacing().item_spacing.x) / 3.0).max(56.0);
    for (axis, coordinate) in [("x", &mut value.x), ("y", &mut value.y), ("z", &mut value.z)] {
        let name = format!("{name} {axis}");
        NumberField { width, ..NumberField::new(&name, coordinate) }.show(ui);
    }
}

/// Returns the colour that a vector has in the views; `None` for other names.
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
