//! The stage: in every step, the figure fills the window, nothing moves when the answer comes, and every
//! line that the step names is there.

use egui::accesskit::Role;
use egui::{Key, Rect, Vec2, vec2};
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which, builtin};
use pinhole::model::session::ViewLayout;

use super::{Window, key};
use crate::harness::window;

/// The steps that have a figure of their own, which an exercise has not.
fn steps() -> impl Iterator<Item = (StepId, ViewLayout)> {
    builtin::all().iter().enumerate().flat_map(|(index, lesson)| {
        let id = move |step| StepId { lesson: Which::Builtin(index), step };
        let layouts = lesson.steps.iter().map(|step| step.view.layout.unwrap_or(ViewLayout::Both));
        let all = layouts.enumerate().map(move |(step, layout)| (id(step), layout));
        all.filter(|(_, layout)| *layout != ViewLayout::Exercises)
    })
}

/// The names of the pictures that form a layout's main figure.
fn names(layout: ViewLayout) -> &'static [&'static str] {
    match layout {
        ViewLayout::Camera => &["Camera view"],
        ViewLayout::Lines => &["Plane with both lines"],
        ViewLayout::Plot => &["World view", "Plot of f(p + t d)"],
        ViewLayout::Mistakes => &["World view", "Camera view", "Wrong camera"],
        _ => &["World view"],
    }
}

/// The rectangles of the main figure's pictures; `None` for one that gives the answer away.
fn figure(window: &Window, layout: ViewLayout) -> Vec<Option<Rect>> {
    let rect = |name: &&str| {
        let rect = window.query_by_role_and_label(Role::Image, name)?.rect();
        // The numbers at the axes and the title belong to the graph.
        let is_graph = name.starts_with("Plot");
        let numbers = if is_graph { [vec2(44.0, 28.0), vec2(8.0, 26.0)] } else { [Vec2::ZERO; 2] };
        Some(Rect::from_min_max(rect.min - numbers[0], rect.max + numbers[1]))
    };
    names(layout).iter().map(rect).collect()
}

fn open(window: &mut Window, id: StepId) {
    window.state_mut().open_lesson(id, None);
    window.run();
}

/// Gives the window this size, and presents unless it is a phone's.
fn present_in(window: &mut Window, size: Vec2) {
    let is_phone = size.x < size.y;
    if window.state().session().presenting.is_some() == is_phone {
        key(window, Key::F5);
    }
    window.set_size(size);
    window.run();
}

/// Sizes of the window, in points, and the least share of it that the main figure takes: 1920 x 1080,
/// 1280 x 800 and 1024 x 768 pixels while presenting, and a phone of 390 x 844.
const SIZES: [(Vec2, f32); 4] = [
    (vec2(820.0, 461.0), 0.45),
    (vec2(737.0, 461.0), 0.45),
    (vec2(737.0, 553.0), 0.4),
    (vec2(390.0, 844.0), 0.4),
];

#[test]
fn the_figure_fills_the_window_and_stays_when_the_answer_comes() {
    let mut window = window("canonical");
    for (size, least) in SIZES {
        present_in(&mut window, size);
        for (id, layout) in steps() {
            open(&mut window, id);
            let before = figure(&window, layout);
            key(&mut window, Key::End);
            assert!(!window.state().session().is_asking);
            let after = figure(&window, layout);
            for (before, after) in before.iter().zip(&after) {
                assert!(before.is_none() || before == after, "{id:?} at {size}");
            }
            let area: f32 = after.iter().map(|rect| rect.map_or(0.0, |rect| rect.area())).sum();
            let share = area / (size.x * size.y);
            // A square picture of pixels cannot fill an area that is not square.
            let is_square = matches!(layout, ViewLayout::Camera | ViewLayout::Mistakes);
            let least = if is_square { 0.8 * least } else { least };
            assert!(share >= least, "{id:?} at {size}: {share}");
        }
    }
}

#[test]
fn every_line_on_the_card_is_whole() {
    let mut window = window("canonical");
    let mut cut = Vec::new();
    for (size, _) in SIZES {
        present_in(&mut window, size);
        for (id, layout) in steps() {
            open(&mut window, id);
            key(&mut window, Key::End);
            let Some(derivation) = window.state().derived().derivation.clone() else { continue };
            if layout == ViewLayout::Mistakes || layout == ViewLayout::Lines {
                continue;
            }
            let lines = derivation.sections.iter().flat_map(|section| &section.lines);
            let inside = window.ctx.content_rect().shrink(1.0);
            let is_whole = |text: &String| {
                let mut nodes = window.query_all_by_label(text);
                nodes.next().is_some_and(|node| inside.contains_rect(node.rect()))
            };
            let texts = lines.map(ToString::to_string).filter(|text| !is_whole(text));
            cut.extend(texts.map(|text| format!("{id:?} at {size}: {text}")));
        }
    }
    assert!(cut.is_empty(), "{}", cut.join("\n"));
}

#[test]
fn the_observer_glides_to_the_next_step_unless_motion_is_reduced() {
    for reduced_motion in [false, true] {
        let mut window = window("canonical");
        if reduced_motion {
            crate::harness::command(&mut window, "Reduced motion");
        }
        let id = |step| StepId { lesson: Which::Builtin(6), step };
        open(&mut window, id(1));
        window.state_mut().open_lesson(id(2), None);
        window.set_size(vec2(1280.0, 800.0));
        let eye =
            |window: &Window| window.state().derived().world_frame.clone().unwrap().camera().eye();
        let from = eye(&window);
        window.step();
        let between = eye(&window);
        window.run();
        let to = eye(&window);
        assert!(from != to);
        assert_eq!(between == to, reduced_motion, "{from} {between} {to}");
    }
}

#[test]
fn the_buttons_stand_beside_the_figure() {
    let mut window = window("canonical");
    for size in [vec2(1280.0, 800.0), vec2(1366.0, 768.0), vec2(1920.0, 1080.0)] {
        window.set_size(size);
        for (id, layout) in steps().filter(|(_, layout)| *layout != ViewLayout::Exercises) {
            open(&mut window, id);
            let right = figure(&window, layout).into_iter().flatten().map(|rect| rect.right());
            let right = right.fold(0.0, f32::max);
            let next = if window.state().session().is_asking { "Show the answer" } else { "Next" };
            for name in ["Contents", "Previous", next, "Back to the step", "Close the lesson"] {
                let button = window.get_by_role_and_label(Role::Button, name).rect();
                assert!(
                    button.left() >= right,
                    "{name} in {id:?} at {size}: {button} from {right}"
                );
            }
        }
    }
}
