//! Labels in the world view: beside what they name, and over no handle.

use egui::{Key, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::lessons::{StepId, Which};
use pinhole::ui::app::App;

use crate::harness::window;

/// Where the handles' middles are.
fn handles(harness: &Harness<'_, App>) -> Vec<(String, Pos2)> {
    let nodes = harness.root().children_recursive();
    let handles = nodes.filter_map(|node| {
        let name = node.accesskit_node().label().filter(|label| label.ends_with(" handle"))?;
        // Not those between two views.
        let is_splitter = node.accesskit_node().role() == egui::accesskit::Role::Splitter;
        (!is_splitter).then(|| (name, node.rect().center()))
    });
    handles.collect()
}

/// What each label covers.
fn labels(harness: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let rect = harness.get_by_role_and_label(egui::accesskit::Role::Image, "World view").rect();
    let scale = harness.ctx.pixels_per_point();
    let shown = harness.state().derived().world_view.clone().unwrap();
    let area = |label: &pinhole::view::overlay::Label| {
        let center = rect.min + Vec2::from(label.position) / scale;
        let size = 2.0 * Vec2::from(label.half_extent(scale)) / scale;
        (label.text.clone(), Rect::from_center_size(center, size))
    };
    shown.labels.iter().map(area).collect()
}

#[track_caller]
fn assert_apart(harness: &Harness<'_, App>, what: &str) {
    let labels = labels(harness);
    assert!(labels.len() >= 3, "{what}: {labels:?}");
    for (text, area) in &labels {
        for (name, spot) in handles(harness) {
            assert!(!area.contains(spot), "{what}: “{text}” lies over the {name}");
        }
        for (other, beside) in labels.iter().filter(|other| other.0 != *text) {
            assert!(!area.shrink(1.0).intersects(*beside), "{what}: “{text}” and “{other}”");
        }
    }
}

#[test]
fn no_label_lies_over_a_handle_or_another_label() {
    for scene in ["canonical", "look-at"] {
        let mut harness = window(scene);
        assert_apart(&harness, scene);
        harness.key_press(Key::F5);
        harness.run();
        assert_apart(&harness, scene);
    }
    let mut harness = window("canonical");
    // As many points as a projector's window of 1024 x 768 has while presenting.
    harness.set_size(vec2(683.0, 512.0));
    harness.key_press(Key::F5);
    for (lesson, step) in [(6, 1), (6, 2), (6, 4), (8, 0)] {
        harness.state_mut().open_lesson(StepId { lesson: Which::Builtin(lesson), step }, None);
        harness.run();
        if harness.state().session().is_asking {
            // All labels are shown with the answer.
            harness.key_press(Key::PageDown);
            harness.run();
        }
        assert_apart(&harness, &format!("lesson {}.{}", lesson + 1, step + 1));
    }
}
