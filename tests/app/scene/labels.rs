//! Handles and labels in the world view: only those that are needed.

use egui::accesskit::Role;
use egui::{Key, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole_figure::concept::Concept;
use pinhole_figure::overlay::Shape;
use pinhole_figure::overlay_items::Item;

use crate::harness::window_with;

/// The number of handles that are drawn: each is a filled shape with a smaller one in its middle.
fn drawn_handles(harness: &Harness<'_, App>) -> usize {
    let marks = harness.state().derived().world_view.clone().unwrap().marks;
    let handles = marks.iter().filter(|mark| mark.item == Item::Handles);
    handles.filter(|mark| !matches!(mark.shape, Shape::Line { .. })).count() / 2
}

/// The labels of the world view, sorted.
fn labels(harness: &Harness<'_, App>) -> Vec<String> {
    let shown = harness.state().derived().world_view.clone().unwrap();
    let mut texts: Vec<String> = shown.labels.iter().map(|label| label.text.clone()).collect();
    texts.sort();
    texts
}

fn focus(harness: &mut Harness<'_, App>, handle: &str) {
    harness.get_by_role_and_label(Role::Slider, handle).focus();
    harness.run();
}

#[test]
fn only_eye_at_and_up_have_handles_until_another_is_reached_for() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    assert_eq!(drawn_handles(&harness), 3, "eye, at and the tip of up");
    // Those that are not drawn can be reached by Tab, and are drawn then.
    for (handle, count) in [
        ("viewport, top right corner handle", 8),
        ("viewport's distance handle", 8),
        ("selected pixel handle", 4),
    ] {
        focus(&mut harness, handle);
        // A handle under the hand is large, and may cover another one.
        let drawn = drawn_handles(&harness);
        assert!((count - 1..=count).contains(&drawn), "{handle}: {drawn}");
        harness.key_press(Key::Escape);
        harness.run();
    }
    assert_eq!(drawn_handles(&harness), 3);
}

#[test]
fn handles_that_a_step_speaks_of_are_drawn() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    let mut open = |lesson, step| {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        harness.run();
        drawn_handles(&harness)
    };
    assert_eq!(open(0, 0), 1, "the camera in its world: its eye");
    assert_eq!(open(2, 0), 6, "width and height: eye, corners and distance");
    assert_eq!(open(2, 1), 2, "the distance");
}

#[test]
fn only_what_the_camera_is_made_of_has_a_name_until_a_lesson_is_open() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    let named = labels(&harness);
    for name in ["at", "eye", "up", "u", "v", "w", "hit"] {
        assert!(named.iter().any(|text| text == name), "{name} in {named:?}");
    }
    for name in ["top", "(0, 0)", "n", "view"] {
        assert!(!named.iter().any(|text| text == name), "{name} in {named:?}");
    }
    assert!(!draws_normal(&harness), "an arrow without a name");
    let mut open = |lesson: usize, step: usize| {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        harness.run();
        assert!(!draws_normal(&harness), "nothing in the lesson speaks of the normal");
        labels(&harness)
    };
    assert!(open(6, 0).iter().any(|text| text == "view"));
    assert!(open(0, 3).iter().any(|text| text == "hit"));
}

#[test]
fn the_viewports_width_lies_on_no_line_of_the_camera() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.key_press(Key::F5);
    harness.run();
    // At 1024 x 768.
    harness.set_size(vec2(737.0, 553.0));
    harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(2), step: 5 }, None);
    harness.run();
    let shown = harness.state().derived().world_view.clone().unwrap();
    let label = shown.labels.iter().find(|label| label.text == "width = 1").unwrap();
    let half = Vec2::from(label.half_extent(harness.ctx.pixels_per_point()));
    let area = Rect::from_center_size(label.position.into(), 2.0 * half);
    for mark in shown.marks.iter().filter(|mark| mark.item != Item::Floor) {
        let Shape::Line { points, .. } = &mark.shape else { continue };
        for pair in points.windows(2) {
            let [from, to] = [pair[0], pair[1]].map(Pos2::from);
            let is_on = |k: u8| area.contains(from.lerp(to, f32::from(k) / 255.0));
            assert!(!(0..=255).any(is_on), "{:?} from {from} to {to}", mark.item);
        }
    }
}

#[test]
fn a_lesson_draws_where_the_camera_was() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    let mut primed = |lesson: usize, step: usize| {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        harness.run();
        let mut labels = labels(&harness);
        labels.retain(|text| text.ends_with('′'));
        labels
    };
    assert_eq!(primed(3, 0), ["eye′"], "the eye has moved");
    assert_eq!(primed(4, 0), [""; 0], "nothing has moved yet");
    assert_eq!(primed(4, 1), ["u′", "w′"], "v is the axis of the turn");
    assert_eq!(primed(4, 2), [""; 0], "no other camera");
}

/// Whether the normal is drawn at the hit.
fn draws_normal(harness: &Harness<'_, App>) -> bool {
    let drawing = harness.state().derived().world_view.clone().unwrap();
    drawing.marks.iter().any(|mark| mark.concept == Some(Concept::Normal))
}
