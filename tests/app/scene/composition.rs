//! The window without a lesson is composed like a lesson's stage: the world view from edge to edge, the
//! picture and the numbers in one column.

use egui::accesskit::Role;
use egui::{Rect, Theme, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::{Settings, Setup, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;

use crate::harness::{type_into, window_with};

/// The numbers of the first window on the lecture's scene, from the top.
const NUMBERS: [&str; 8] = [
    "u = (1, 0, 0)",
    "v = (0, 1, 0)",
    "w = (0, 0, 1)",
    "(u, v) = (0.2, −0.1)",
    "d = (0.2, −0.1, −1)",
    "hit = plane 2 “back wall”",
    "t = 6",
    "point = (1.2, −0.6, −6)",
];

fn sized(size: Vec2, settings: Settings) -> Harness<'static, App> {
    let remembered = Remembered { settings, ..Remembered::default() };
    let mut harness = window_with("canonical", remembered, None);
    harness.set_size(size);
    harness.run();
    harness
}

fn view(harness: &Harness<'_, App>, name: &str) -> Rect {
    harness.get_by_role_and_label(Role::Image, name).rect()
}

/// Where the text that a screen reader reads as this value is.
fn number(harness: &Harness<'_, App>, text: &str) -> Rect {
    let mut all = harness.root().children_recursive();
    let found = all.find(|node| node.accesskit_node().value().as_deref() == Some(text));
    found.unwrap_or_else(|| panic!("no “{text}”")).rect()
}

#[test]
fn the_world_view_is_the_main_figure_and_nothing_is_cropped() {
    for (size, least) in [
        (vec2(1920.0, 1080.0), 0.45),
        (vec2(1280.0, 800.0), 0.42),
        (vec2(1024.0, 768.0), 0.33),
        (vec2(640.0, 480.0), 0.2),
        (vec2(390.0, 844.0), 0.3),
    ] {
        let harness = sized(size, Settings::default());
        let window = Rect::from_min_size(egui::Pos2::ZERO, size);
        let [world, picture] = ["World view", "Camera view"].map(|name| view(&harness, name));
        let share = world.area() / window.area();
        assert!(share >= least, "{share} of {size}");
        let mut parts = vec![world, picture];
        parts.extend(NUMBERS.map(|text| number(&harness, text)));
        for (k, part) in parts.iter().enumerate() {
            assert!(window.contains_rect(*part), "{part} at {size}");
            let other = parts[..k].iter().find(|other| other.shrink(0.5).intersects(*part));
            assert_eq!(other, None, "{part} at {size}");
        }
        let start = harness.get_by_role_and_label(Role::Button, "Start the lecture").rect();
        assert!(window.contains_rect(start), "{start} at {size}");
    }
}

#[test]
fn a_number_stays_where_it_is_while_numbers_change() {
    for layout in [ViewLayout::Both, ViewLayout::World] {
        let mut harness = sized(
            vec2(1280.0, 800.0),
            Settings { setup: Setup { layout, ..Setup::default() }, ..Settings::default() },
        );
        let picture = (layout == ViewLayout::Both).then(|| view(&harness, "Camera view"));
        let t_before = number(&harness, "t = 6").left_top();
        type_into(&mut harness, "eye x", "-1/3");
        type_into(&mut harness, "eye z", "1/7");
        let t = harness.state().derived().inspection.as_ref().unwrap().first_hit().unwrap().t;
        assert!(t > 6.0 && t < 6.5, "{t}");
        let t_after = number(&harness, &format!("t ≈ {t:.4}")).left_top();
        assert!((t_before - t_after).length() < 0.1, "{layout:?}: {t_before} and {t_after}");
        let after = (layout == ViewLayout::Both).then(|| view(&harness, "Camera view"));
        assert_eq!(picture, after);
    }
}

#[test]
fn a_folded_section_says_its_values() {
    let mut settings = Settings::default();
    settings.preferences.unfolded.camera = false;
    let mut harness = sized(vec2(1280.0, 800.0), settings);
    let values = |harness: &Harness<'_, App>, title: &str| {
        harness.get_by_label(title).accesskit_node().description().unwrap_or_default()
    };
    assert_eq!(values(&harness, "Camera"), "eye (0, 0, 0)");
    assert_eq!(values(&harness, "Viewport and image"), "1 × 1 at 1, 400 × 400");
    assert_eq!(values(&harness, "Selected ray"), "(0.2, −0.1)");
    assert_eq!(values(&harness, "Objects"), "3");
    harness.get_by_label("Camera").click();
    harness.run();
    assert_eq!(values(&harness, "Camera"), "", "the fields say it");
    type_into(&mut harness, "eye y", "2.5");
    harness.get_by_label("Camera").click();
    harness.run();
    assert_eq!(values(&harness, "Camera"), "eye (0, 2.5, 0)");
}

#[test]
fn the_window_is_light_where_the_system_does_not_ask_for_dark() {
    let mut harness = window_with("canonical", Remembered::default(), None);
    harness.input_mut().system_theme = None;
    harness.run();
    assert_eq!(harness.ctx.theme(), Theme::Light);
    harness.input_mut().system_theme = Some(Theme::Dark);
    harness.run();
    assert_eq!(harness.ctx.theme(), Theme::Dark);
}

#[test]
fn on_a_phone_the_fields_are_below_the_views_and_every_menu_is_whole() {
    let mut harness = sized(vec2(390.0, 844.0), Settings::default());
    let field = harness.get_by_role_and_label(Role::SpinButton, "eye x").rect();
    assert!(field.top() > view(&harness, "Camera view").bottom(), "{field}");
    for menu in ["Menu", "Scene"] {
        let rect = harness.get_by_label(menu).rect();
        assert!(rect.right() <= 390.0, "{menu}: {rect}");
    }
    harness.get_by_label("Menu").click();
    harness.run();
    for menu in ["File", "Edit", "View", "Lessons", "Play", "Tools", "Help"] {
        let mut shown = harness.query_all_by_label_contains(menu);
        assert!(shown.any(|entry| entry.rect().right() <= 390.0), "{menu}");
    }
}

#[test]
fn the_numbers_at_the_foot_of_a_large_view_are_whole() {
    for layout in [ViewLayout::World, ViewLayout::Camera] {
        let settings =
            Settings { setup: Setup { layout, ..Setup::default() }, ..Settings::default() };
        let harness = sized(vec2(1280.0, 800.0), settings);
        let number = number(&harness, "hit = plane 2 “back wall”");
        assert!(number.bottom() <= 800.0, "{layout:?}: {number}");
    }
}
