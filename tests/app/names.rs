//! What a screen reader reads: everything that one can act on has a name of its own.

use std::collections::HashMap;

use egui::accesskit::{Action, Role};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::{Settings, Setup, ViewLayout};
use pinhole::model::store::Remembered;
use pinhole::ui::app::App;

use crate::harness::{show, texts_with, unfolded, window, window_with};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

/// Fails where something to act on has no name, or the name of its neighbour.
#[track_caller]
fn assert_all_named(harness: &Harness<'_, App>, context: &str) {
    let mut names: HashMap<(Option<_>, Role, String), usize> = HashMap::new();
    let mut nameless = Vec::new();
    let mut count = 0;
    for node in harness.root().children_recursive() {
        let node = node.accesskit_node();
        let role = node.role();
        let acts = node.data().supports_action(Action::Click)
            || node.data().supports_action(Action::Focus);
        // What is only read, and a scroll bar, which is what it is.
        let text = matches!(role, Role::Label | Role::ScrollView | Role::ScrollBar | Role::Window);
        if !acts || node.is_hidden() || text {
            continue;
        }
        count += 1;
        let name = node.label().unwrap_or_default();
        if name.trim().is_empty() {
            nameless.push((role, node.value(), node.bounding_box()));
        }
        *names.entry((node.parent().map(|parent| parent.id()), role, name)).or_default() += 1;
    }
    assert!(count > 0, "{context}");
    assert!(nameless.is_empty(), "{context}: without a name: {nameless:?}");
    let twice: Vec<_> = names.iter().filter(|(_, count)| **count > 1).map(|(key, _)| key).collect();
    assert!(twice.is_empty(), "{context}: {twice:?}");
}

#[test]
fn every_control_has_a_name_of_its_own_in_every_layout() {
    for scene in ["canonical", "look-at"] {
        let settings =
            Settings { setup: Setup { teaching: true, ..Setup::default() }, ..unfolded() };
        let remembered = Remembered { settings, ..Remembered::default() };
        let mut harness = window_with(scene, remembered, None);
        for layout in ViewLayout::LISTED {
            show(&mut harness, layout);
            // Measuring never rests.
            harness.run_steps(6);
            assert_all_named(&harness, &format!("{scene}, {layout:?}"));
        }
    }
}

#[test]
fn menus_palette_sheet_and_strip_have_names() {
    let mut harness = window("canonical");
    for menu in ["File", "Edit", "View", "Lessons", "Play", "Tools", "Help"] {
        harness.get_by_label(menu).click();
        harness.run();
        assert_all_named(&harness, menu);
        press(&mut harness, Modifiers::NONE, Key::Escape);
    }
    press(&mut harness, Modifiers::COMMAND, Key::P);
    assert_all_named(&harness, "palette");
    press(&mut harness, Modifiers::NONE, Key::Escape);
    press(&mut harness, Modifiers::NONE, Key::F1);
    assert_all_named(&harness, "keys");
    press(&mut harness, Modifiers::NONE, Key::Escape);
    press(&mut harness, Modifiers::COMMAND, Key::O);
    assert_all_named(&harness, "open");
    press(&mut harness, Modifiers::NONE, Key::Escape);
    harness.get_by_label("Lessons").click();
    harness.run();
    harness.get_by_label("Lesson 4: The eye moves").click();
    harness.run();
    assert_all_named(&harness, "lesson");
    press(&mut harness, Modifiers::NONE, Key::F5);
    assert_all_named(&harness, "presenting");
}

#[test]
fn the_views_say_the_selected_pixel_its_hit_and_t() {
    let mut harness = window("canonical");
    harness.get_by_label("Camera view").focus();
    harness.run();
    press(&mut harness, Modifiers::NONE, Key::ArrowUp);
    for view in ["World view", "Camera view"] {
        let node = harness.get_by_role_and_label(Role::Image, view);
        let said = node.accesskit_node().description().unwrap_or_default();
        assert!(said.starts_with("row ") && said.contains("column "), "{view}: {said}");
        assert!(said.contains("hits"), "{view}: {said}");
    }
    press(&mut harness, Modifiers::NONE, Key::F5);
    let node = harness.get_by_role_and_label(Role::Image, "Camera view");
    assert!(node.accesskit_node().description().is_some());
}

#[test]
fn tab_goes_everywhere_and_shows_where_it_is() {
    let mut harness = window("canonical");
    let ringed = |harness: &Harness<'_, App>| {
        let focused = harness.ctx.memory(|memory| memory.focused())?;
        let rect = harness.ctx.read_response(focused)?.interact_rect;
        let rings = harness.output().shapes.iter().filter(|clipped| {
            matches!(&clipped.shape, egui::Shape::Rect(ring)
                if ring.stroke.width >= 2.0 && ring.rect.expand(1.5).contains_rect(rect.intersect(harness.ctx.content_rect().shrink(1.0))))
        });
        Some((focused, rings.count()))
    };
    let mut seen = std::collections::HashSet::new();
    for _ in 0..40 {
        press(&mut harness, Modifiers::NONE, Key::Tab);
        if let Some((focused, rings)) = ringed(&harness) {
            assert!(rings >= 1, "no ring after {} stops", seen.len());
            seen.insert(focused);
        }
    }
    assert!(seen.len() >= 30, "{}", seen.len());
    // A click shows for itself where it was.
    harness.get_by_label("Camera view").click();
    harness.run();
    assert_eq!(ringed(&harness).map(|(_, rings)| rings), Some(0));
}

#[test]
fn words_that_are_not_everybodys_have_a_sentence() {
    let mut harness = window("canonical");
    for (word, sentence) in [
        ("Hit or miss: ", "double-double 32"),
        ("seed", "The number that the question's numbers are drawn from"),
    ] {
        if word == "seed" {
            show(&mut harness, ViewLayout::Exercises);
            harness.get_by_label("New numbers").click();
            harness.run();
        }
        let node = harness
            .query_all_by(|node| {
                let text = node.value().or_else(|| node.label()).unwrap_or_default();
                node.role() == Role::Label && text.contains(word)
            })
            .next();
        let rect = node.unwrap_or_else(|| panic!("no {word}")).rect();
        harness.hover_at(rect.center());
        harness.run_steps(8);
        assert!(!texts_with(&harness, sentence).is_empty(), "{word}");
    }
}
