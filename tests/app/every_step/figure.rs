//! The figure and the card of formulas on the stage.

use egui::accesskit::Role;
use egui::{Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;

use super::Seen;

/// The names of the pictures that form a layout's main figure.
fn names(layout: ViewLayout) -> &'static [&'static str] {
    match layout {
        ViewLayout::Camera => &["Camera view"],
        ViewLayout::Lines => &["Plane with both lines"],
        ViewLayout::Plot => &["World view", "Plot of f(p + t d)"],
        ViewLayout::Mistakes => &["World view", "Camera view", "Wrong camera"],
        ViewLayout::Compare => &["World view", "Camera view", "Ghost"],
        ViewLayout::Exercises => &["World view", "Lines in the plane"],
        _ => &["World view"],
    }
}

/// The rectangles of the main figure's pictures; `None` for one that gives the answer away.
pub(super) fn pictures(window: &Harness<'_, App>, layout: ViewLayout) -> Vec<Option<Rect>> {
    let rect = |name: &&str| {
        // While a question is open, the wrong camera has another name.
        let asked = if *name == "Wrong camera" { "Camera 2" } else { name };
        let named = [*name, asked].map(|name| window.query_by_role_and_label(Role::Image, name));
        let rect = named.into_iter().flatten().next()?.rect();
        // The numbers at the axes and the title belong to the graph.
        let is_graph = name.starts_with("Plot");
        let numbers = if is_graph { [vec2(44.0, 28.0), vec2(8.0, 26.0)] } else { [Vec2::ZERO; 2] };
        Some(Rect::from_min_max(rect.min - numbers[0], rect.max + numbers[1]))
    };
    names(layout).iter().map(rect).collect()
}

/// What moves when the answer comes.
pub(super) fn moved(seen: &Seen<'_>) -> Vec<String> {
    let now = pictures(seen.window, seen.layout);
    let pairs = seen.opened.iter().zip(&now).filter(|(opened, _)| opened.is_some());
    pairs.filter(|(a, b)| a != b).map(|(a, b)| format!("from {a:?} to {b:?}")).collect()
}

/// The share of the window that the figure takes, if that is less than 45 % of a wide window, or 40 % of
/// another.
pub(super) fn too_small(seen: &Seen<'_>) -> Vec<String> {
    if !seen.is_answered {
        return Vec::new();
    }
    let areas = pictures(seen.window, seen.layout).into_iter().flatten().map(|rect| rect.area());
    let window = seen.window.ctx.content_rect();
    let share = areas.sum::<f32>() / window.area();
    let least = if window.aspect_ratio() > 1.5 { 0.45 } else { 0.4 };
    // A square picture of pixels cannot fill an area that is not square.
    use ViewLayout::{Camera, Compare, Mistakes};
    let is_square = matches!(seen.layout, Camera | Compare | Mistakes);
    let least = if is_square { 0.8 * least } else { least };
    (share < least).then(|| format!("{share} of it")).into_iter().collect()
}

/// The share of the window that is empty ground of the texts.
pub(super) fn ground(window: &mut Harness<'_, App>) -> f32 {
    let ground = window.ctx.global_style().visuals.panel_fill.to_array();
    let picture = window.render().unwrap();
    let count = picture.pixels().filter(|pixel| pixel.0 == ground).count();
    count as f32 / picture.pixels().len() as f32
}

/// The lines of the derivation that are not whole in the window.
pub(super) fn cut_lines(seen: &Seen<'_>) -> Vec<String> {
    use ViewLayout::{Lines, Mistakes};
    let derivation = seen.app().derived().derivation.clone();
    let Some(derivation) = derivation.filter(|_| seen.is_answered) else { return Vec::new() };
    if matches!(seen.layout, Mistakes | Lines) {
        return Vec::new();
    }
    let lines = derivation.sections.iter().flat_map(|section| &section.lines);
    let inside = seen.window.ctx.content_rect().shrink(1.0);
    let is_whole = |text: &String| {
        let mut nodes = seen.window.query_all_by_label(text);
        nodes.next().is_some_and(|node| inside.contains_rect(node.rect()))
    };
    lines.map(ToString::to_string).filter(|text| !is_whole(text)).collect()
}

/// What an exercise's question has in the column that is not whole in the window, or lies on one another.
pub(super) fn cut_widgets(seen: &Seen<'_>) -> Vec<String> {
    let column = ["Check", "Show the solution", "Hide the solution", "New numbers"];
    let nodes = seen.window.root().children_recursive();
    let all: Vec<(String, Rect)> = nodes
        .map(|node| (node.accesskit_node().label().unwrap_or_default(), node))
        .filter(|(label, node)| match node.accesskit_node().role() {
            Role::TextInput | Role::RadioButton => true,
            _ => column.contains(&label.as_str()),
        })
        .map(|(label, node)| (label, node.rect()))
        .collect();
    let is_wrong = |k: usize| {
        let others = (0..k).filter(|other| all[*other].1.shrink(1.0).intersects(all[k].1));
        !seen.window.ctx.content_rect().contains_rect(all[k].1) || others.count() > 0
    };
    let wrong = (0..all.len()).filter(|k| is_wrong(*k));
    wrong.map(|k| format!("{} at {}", all[k].0, all[k].1)).collect()
}

/// The buttons that lie over the figure of a wide window.
pub(super) fn buttons_over_it(seen: &Seen<'_>) -> Vec<String> {
    if seen.window.ctx.content_rect().aspect_ratio() < 1.5 {
        return Vec::new();
    }
    let rects = pictures(seen.window, seen.layout).into_iter().flatten();
    let right = rects.map(|rect| rect.right()).fold(0.0, f32::max);
    let next = if seen.app().session().shown.is_asking { "Show the answer" } else { "Next" };
    let names = ["Contents", "Previous", next, "Back to the step", "Close the lesson"];
    let left = |name| seen.window.get_by_role_and_label(Role::Button, name).rect().left();
    let over = names.into_iter().filter(|name| left(name) < right);
    over.map(|name| format!("{name} is at {}, left of {right}", left(name))).collect()
}
