//! Where up meets the view direction: a camera without a basis, reached by hand.

use egui::Pos2;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::fault::Fault;
use pinhole::model::session::Settings;
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;
use pinhole::view::overlay::world_position_of;
use pinhole_core::DVec3;

use super::camera;
use crate::harness::{drag_from, unfolded, window, window_with};

fn node_at(harness: &Harness<'_, App>, handle: &str) -> Pos2 {
    harness.get_by_role_and_label(Role::Slider, handle).rect().center()
}

/// The position of a point of the world in the window.
fn seen_at(harness: &Harness<'_, App>, point: DVec3) -> Pos2 {
    let view = harness.get_by_role_and_label(Role::Image, "World view").rect();
    let frame = harness.state().derived().world_frame.clone().unwrap();
    let [x, y] = world_position_of(&frame, point).unwrap();
    view.min + egui::vec2(x, y)
}

fn has_no_basis(harness: &Harness<'_, App>) -> bool {
    matches!(harness.state().derived().fault, Some(Fault::Camera(_)))
}

#[test]
fn up_that_is_dragged_onto_the_view_stays_there() {
    let mut harness = window("canonical");
    let (from, to) = (node_at(&harness, "up handle"), node_at(&harness, "at handle"));
    drag_from(&mut harness, from, to + egui::vec2(3.0, 2.0) - from);
    assert!(has_no_basis(&harness));
    assert_eq!(camera(&harness).up().cross(camera(&harness).view()), DVec3::ZERO);
    // And it is led out of that again.
    let from = node_at(&harness, "up handle");
    drag_from(&mut harness, from, egui::vec2(0.0, -60.0));
    assert!(!has_no_basis(&harness));
}

#[test]
fn an_eye_that_is_dragged_over_at_meets_up_only_if_up_is_kept() {
    for keep_up in [false, true] {
        let settings = Settings { keep_up, ..unfolded() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut harness = window_with("look-at", remembered, None);
        let before = camera(&harness);
        let top = before.eye + before.view() + 2.0 * before.up();
        let (from, to) = (node_at(&harness, "eye handle"), seen_at(&harness, top));
        drag_from(&mut harness, from, to - from);
        assert_eq!(has_no_basis(&harness), keep_up, "{:?}", camera(&harness));
    }
}
