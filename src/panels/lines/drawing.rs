//! The drawing of the lab of lines: the plane with both lines in it, and handles to drag.

use std::cmp::Ordering;

use egui::{
    Align2, Color32, CursorIcon, EventFilter, Key, Pos2, Rect, Response, Sense, Stroke, Ui, Vec2,
    vec2,
};
use pinhole_core::DVec2;
use pinhole_core::lecture::lines::{ImplicitLine, Meeting, ParametricLine, Substitution};

use super::sheet::{Sheet, beside, round_step};
use super::steps::number;
use crate::lines::{Handle, LinesLab};
use crate::overlay::Style;

/// Sizes of text, in points: coordinates, names, regions.
const SMALL: f32 = 15.0;
const NAMES: f32 = 19.0;
const REGIONS: f32 = 22.0;

/// Half the side of what takes the pointer around a handle, in points.
const GRASP: f32 = 13.0;

/// More points than this are not left behind.
const MOST_POINTS: usize = 400;

/// Colours of the drawing.
struct Ink {
    text: Color32,
    implicit: Color32,
    ray: Color32,
    positive: Color32,
    negative: Color32,
    faint: Color32,
}

impl Ink {
    fn of(dark: bool) -> (Ink, Color32, Color32) {
        let colors = if dark { Style::Dark } else { Style::Light }.colors();
        let ink = Ink {
            text: colors.ink,
            implicit: colors.mark,
            ray: colors.ray,
            positive: colors.basis[2],
            negative: colors.basis[0],
            faint: colors.ink.gamma_multiply(0.22),
        };
        (ink, colors.background, colors.halo)
    }
}

/// Shows the drawing and takes what is dragged in it.
pub(super) fn ui(ui: &mut Ui, rect: Rect, lab: &mut LinesLab, digits: usize) {
    look_around(ui, rect, lab);
    let sheet = |lab: &LinesLab| {
        let (_, _, halo) = Ink::of(ui.visuals().dark_mode);
        Sheet::new(ui.painter_at(rect), rect, lab.window, halo)
    };
    let before = sheet(lab);
    let grabbed: Vec<(Handle, Response)> = Handle::ALL
        .into_iter()
        .filter_map(|handle| Some((handle, handle_input(ui, &before, lab, handle)?)))
        .collect();
    let sheet = sheet(lab);
    let (ink, background, _) = Ink::of(ui.visuals().dark_mode);
    sheet.painter.rect_filled(rect, 0.0, background);
    if let Ok(()) = lab.line().check() {
        sheet.half_plane(&lab.line(), true, ink.positive.gamma_multiply(0.13));
        sheet.half_plane(&lab.line(), false, ink.negative.gamma_multiply(0.13));
    }
    grid(&sheet, &lab.line(), &ink);
    implicit(&sheet, &lab.line(), &ink);
    if lab.ray.check().is_ok() {
        parametric(&sheet, lab, &ink);
    }
    meeting(&sheet, lab, &ink, digits);
    handles(&sheet, lab, &ink, &grabbed, digits);
}

/// Dragging beside all handles moves the window, the wheel zooms about the pointer.
fn look_around(ui: &Ui, rect: Rect, lab: &mut LinesLab) {
    let response = ui.interact(rect, ui.scope_id().with("plane"), Sense::drag());
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(egui::accesskit::Role::Image);
        node.set_label("Plane with both lines");
    });
    let per_point = 2.0 * lab.window.half_height / f64::from(rect.height());
    let delta = response.drag_delta();
    lab.window.center -= per_point * DVec2::new(delta.x.into(), (-delta.y).into());
    if response.contains_pointer()
        && let Some(pointer) = ui.input(|i| i.pointer.hover_pos())
    {
        let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta(), i.zoom_delta()));
        let factor = f64::from(pinch) * f64::from(scroll.y * 0.004).exp();
        let half = (lab.window.half_height / factor).clamp(0.05, 1e4);
        let away = pointer - rect.center();
        let away = DVec2::new(away.x.into(), (-away.y).into());
        let kept = lab.window.half_height - half;
        lab.window.center += 2.0 * kept / f64::from(rect.height()) * away;
        lab.window.half_height = half;
    }
}

fn handle_input(ui: &Ui, sheet: &Sheet, lab: &mut LinesLab, handle: Handle) -> Option<Response> {
    let at = sheet.place(lab.place_of(handle)?);
    if !sheet.rect.expand(GRASP).contains(at) {
        return None;
    }
    let id = ui.scope_id().with(handle.name());
    let around = Rect::from_center_size(at, Vec2::splat(2.0 * GRASP));
    let response = ui.interact(around, id, Sense::click_and_drag());
    let response = response.on_hover_cursor(CursorIcon::Grab);
    let arrows =
        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
    // Whole hundredths, or whatever is finer than a dot.
    let dots = sheet.scale * f64::from(ui.ctx().pixels_per_point());
    let fineness = 10_f64.powf(dots.log10().ceil());
    if response.drag_started() {
        response.request_focus();
        // Taken hold of beside its middle, it stays that far beside the pointer.
        let pressed = ui.input(|i| i.pointer.press_origin()).unwrap_or(at);
        ui.data_mut(|data| data.insert_temp(id, at - pressed));
    }
    if response.dragged()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let beside: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
        lab.drag(handle, sheet.point(pointer + beside), fineness);
    }
    if response.has_focus() {
        let presses = |key| ui.input(|i| i.num_presses(key) as f64);
        let right = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
        let up = presses(Key::ArrowUp) - presses(Key::ArrowDown);
        if (right, up) != (0.0, 0.0) {
            let step = if lab.snap { LinesLab::GRID } else { 0.1 };
            let to = sheet.point(at) + step * DVec2::new(right, up);
            lab.drag(handle, to, fineness);
        }
    }
    let place = lab.place_of(handle)?;
    ui.ctx().accesskit_node_builder(id, |node| {
        node.set_role(egui::accesskit::Role::Slider);
        node.set_label(handle.name());
        node.set_value(format!("({}, {})", number(place.x, 5), number(place.y, 5)));
    });
    Some(response)
}

/// Lines at round coordinates with their numbers, and the sign of f between them.
fn grid(sheet: &Sheet, line: &ImplicitLine, ink: &Ink) {
    let step = round_step(52.0 / sheet.scale);
    let (low, high) = sheet.bounds();
    let range = |low: f64, high: f64| (low / step).floor() as i64..=(high / step).ceil() as i64;
    let origin = sheet.place(DVec2::ZERO);
    let axis = Pos2::new(
        origin.x.clamp(sheet.rect.left() + 4.0, sheet.rect.right() - 36.0),
        origin.y.clamp(sheet.rect.top() + 2.0, sheet.rect.bottom() - 22.0),
    );
    for k in range(low.x, high.x) {
        let x = k as f64 * step;
        let width = if k == 0 { 2.0 } else { 1.0 };
        let color = if k == 0 { ink.text } else { ink.faint };
        let ends = (DVec2::new(x, low.y), DVec2::new(x, high.y));
        sheet.line(ends.0, ends.1, Stroke::new(width, color), 0.0);
        if k != 0 {
            let at = Pos2::new(sheet.place(ends.0).x, axis.y + 2.0);
            sheet.words(at, Align2::CENTER_TOP, &number(x, 5), (SMALL, ink.text), false);
        }
    }
    for k in range(low.y, high.y) {
        let y = k as f64 * step;
        let width = if k == 0 { 2.0 } else { 1.0 };
        let color = if k == 0 { ink.text } else { ink.faint };
        let ends = (DVec2::new(low.x, y), DVec2::new(high.x, y));
        sheet.line(ends.0, ends.1, Stroke::new(width, color), 0.0);
        if k != 0 {
            let at = Pos2::new(axis.x - 5.0, sheet.place(ends.0).y);
            sheet.words(at, Align2::RIGHT_CENTER, &number(y, 5), (SMALL, ink.text), false);
        }
    }
    let end = sheet.rect.right() - 6.0;
    sheet.words(Pos2::new(end, axis.y - 2.0), Align2::RIGHT_BOTTOM, "𝑥", (NAMES, ink.text), false);
    let end = sheet.rect.top() + 4.0;
    sheet.words(Pos2::new(axis.x + 8.0, end), Align2::LEFT_TOP, "𝑦", (NAMES, ink.text), false);
    if line.check().is_err() {
        return;
    }
    for i in range(low.x, high.x) {
        for j in range(low.y, high.y) {
            let at = step * DVec2::new(i as f64 + 0.5, j as f64 + 0.5);
            let (sign, color) = match line.side(at) {
                Ordering::Less => ("−", ink.negative),
                Ordering::Equal => continue,
                Ordering::Greater => ("+", ink.positive),
            };
            let font = egui::FontId::proportional(SMALL);
            let color = color.gamma_multiply(0.75);
            sheet.painter.text(sheet.place(at), Align2::CENTER_CENTER, sign, font, color);
        }
    }
}

fn implicit(sheet: &Sheet, line: &ImplicitLine, ink: &Ink) {
    if line.check().is_err() {
        return;
    }
    let middle = line.nearest_to(sheet.center());
    let (direction, reach) = (line.direction().normalize_or_zero(), sheet.reach());
    if middle.distance(sheet.center()) < reach {
        let ends = (middle - reach * direction, middle + reach * direction);
        sheet.line(ends.0, ends.1, Stroke::new(3.5, ink.implicit), 0.0);
    }
    // On either side of the line, well away from its middle, where the handles are.
    let normal = direction.perp();
    let gap = 34.0 / sheet.scale;
    let along = middle - 0.62 * sheet.rect.height() as f64 / 2.0 / sheet.scale * direction;
    for (sign, text, color) in [(1.0, "𝑓 > 0", ink.positive), (-1.0, "𝑓 < 0", ink.negative)] {
        let at = along + sign * gap * normal;
        if line.side(at) != Ordering::Equal {
            sheet.words(sheet.place(at), Align2::CENTER_CENTER, text, (REGIONS, color), true);
        }
    }
    let at = middle - 0.86 * sheet.rect.height() as f64 / 2.0 / sheet.scale * direction;
    let away = DVec2::new(normal.x, normal.y);
    let (at, align) = beside(sheet.place(at), vec2(away.x as f32, -away.y as f32), 8.0);
    sheet.words(at, align, "𝑓 = 0", (NAMES, ink.implicit), true);
}

/// The line behind p dashed, from p on whole; the points that t has generated; d.
fn parametric(sheet: &Sheet, lab: &LinesLab, ink: &Ink) {
    let ParametricLine { p, d } = lab.ray;
    let direction = d.normalize_or_zero();
    let middle = lab.ray.nearest_t(sheet.center());
    let reach = sheet.reach() / d.length();
    let (first, last) = (middle - reach, middle + reach);
    if first < 0.0 {
        let stroke = Stroke::new(2.0, ink.ray.gamma_multiply(0.75));
        sheet.line(lab.ray.at(last.min(0.0)), lab.ray.at(first), stroke, 9.0);
    }
    if last > 0.0 {
        let stroke = Stroke::new(3.5, ink.ray);
        sheet.line(lab.ray.at(first.max(0.0)), lab.ray.at(last), stroke, 0.0);
    }
    let side = vec2(direction.y as f32, direction.x as f32);
    for (points, text) in [(-110.0, "𝑡 < 0"), (165.0, "𝑡 > 0")] {
        let at = sheet.place(p + points / sheet.scale * direction);
        if sheet.rect.shrink(24.0).contains(at) {
            let (at, align) = beside(at, side, 10.0);
            sheet.words(at, align, text, (SMALL + 1.0, ink.ray), false);
        }
    }
    let trail = lab.trail;
    let apart = trail.step * d.length() * sheet.scale;
    for (t, at) in lab.ray.generated(trail.step, trail.first, trail.last, MOST_POINTS) {
        let at = sheet.place(at);
        sheet.painter.circle(at, 5.0, ink.ray, Stroke::new(1.5, sheet.halo));
        if apart > 46.0 || t.fract() == 0.0 && apart / trail.step > 30.0 {
            let (at, align) = beside(at, -side, 9.0);
            sheet.words(at, align, &number(t, 5), (SMALL, ink.ray), false);
        }
    }
    sheet.arrow(p, p + d, Stroke::new(6.0, ink.ray));
}

fn meeting(sheet: &Sheet, lab: &LinesLab, ink: &Ink, digits: usize) {
    let Ok(Substitution { meeting: Meeting::At(at), .. }) = Substitution::of(lab.line(), lab.ray)
    else {
        return;
    };
    let place = sheet.place(at.point);
    let arm = 9.0;
    let stroke = Stroke::new(4.0, ink.text);
    for side in [vec2(arm, arm), vec2(arm, -arm)] {
        let casing = Stroke::new(7.0, sheet.halo);
        sheet.painter.line_segment([place - side, place + side], casing);
        sheet.painter.line_segment([place - side, place + side], stroke);
    }
    let said = if at.ray_hits { "hit" } else { "ray missed" };
    let text = format!("{said}: 𝑡 = {}", number(at.t, digits));
    if sheet.rect.contains(place) {
        let at = place + vec2(0.0, 16.0);
        sheet.words(at, Align2::CENTER_TOP, &text, (NAMES, ink.text), true);
    }
}

fn handles(
    sheet: &Sheet,
    lab: &LinesLab,
    ink: &Ink,
    grabbed: &[(Handle, Response)],
    digits: usize,
) {
    for (handle, response) in grabbed {
        let Some(place) = lab.place_of(*handle) else { continue };
        let at = sheet.place(place);
        let held = response.hovered() || response.dragged() || response.has_focus();
        let larger = if held { 1.3 } else { 1.0 };
        let edge = Stroke::new(2.0, sheet.halo);
        let painter = &sheet.painter;
        match handle {
            Handle::Move => {
                let square = Rect::from_center_size(at, Vec2::splat(15.0 * larger));
                painter.rect(square, 2.0, ink.implicit, edge, egui::StrokeKind::Outside);
            }
            Handle::Turn => {
                let ring = Stroke::new(4.0, ink.implicit);
                painter.circle(at, 8.0 * larger, sheet.halo, ring);
            }
            Handle::P => {
                painter.circle(at, 8.0 * larger, ink.ray, edge);
            }
            Handle::Tip => {
                if held {
                    painter.circle_stroke(at, 12.0, Stroke::new(2.0, ink.ray));
                }
            }
            Handle::T => {
                painter.circle(at, 7.0 * larger, ink.text, Stroke::new(3.0, ink.ray));
            }
        }
        let d = lab.ray.d.normalize_or_zero();
        let side = vec2(d.y as f32, d.x as f32);
        let named = match handle {
            Handle::P => ("p".to_owned(), -side + vec2(-d.x as f32, d.y as f32), true),
            Handle::Tip => ("d".to_owned(), side, true),
            Handle::T => (format!("𝑡 = {}", number(lab.t, digits)), side, false),
            Handle::Move | Handle::Turn => continue,
        };
        let (at, align) = beside(at, named.1, 13.0);
        let color = if *handle == Handle::T { ink.text } else { ink.ray };
        sheet.words(at, align, &named.0, (NAMES, color), named.2);
    }
    for (handle, response) in grabbed {
        response.clone().on_hover_text(handle.name());
    }
}
