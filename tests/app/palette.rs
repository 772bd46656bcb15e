//! The command palette and the sheet of keys, by keyboard alone.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole::ui::commands_table;
use pinhole_figure::Scheme;
use pinhole_figure::overlay_items::Item;
use pinhole_lecture::exercises::Exercise;
use pinhole_lecture::mistakes::Mistake;

use crate::harness::{type_into, window};

fn press(harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    harness.key_press_modifiers(modifiers, key);
    harness.run();
}

fn is_open(harness: &Harness<'_, App>) -> bool {
    harness.query_by_role_and_label(Role::TextInput, "Command").is_some()
}

/// Opens the palette and types.
fn look_for(harness: &mut Harness<'_, App>, text: &str) {
    press(harness, Modifiers::COMMAND, Key::P);
    assert!(is_open(harness));
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text(text);
    harness.run();
}

/// Does the first command that is found by these letters.
fn command(harness: &mut Harness<'_, App>, text: &str) {
    look_for(harness, text);
    press(harness, Modifiers::NONE, Key::Enter);
    assert!(!is_open(harness));
}

/// The titles of the commands that are listed, and the chosen one's.
fn listed(harness: &Harness<'_, App>) -> (Vec<String>, Vec<String>) {
    let titles: Vec<String> =
        commands_table::all().iter().map(commands_table::UiCommand::title).collect();
    let nodes = harness.root().children_recursive().filter_map(|node| {
        let node = node.accesskit_node();
        let title = node.label().filter(|label| titles.contains(label))?;
        Some((title, node.is_selected() == Some(true)))
    });
    let nodes: Vec<(String, bool)> = nodes.collect();
    let chosen = nodes.iter().filter(|node| node.1).map(|node| node.0.clone()).collect();
    (nodes.into_iter().map(|node| node.0).collect(), chosen)
}

#[test]
fn everything_is_reached_by_a_few_letters() {
    let mut harness = window("canonical");
    command(&mut harness, "layout derivation");
    assert_eq!(harness.state().session().shown.setup.layout, ViewLayout::Derivation);
    command(&mut harness, "overlay labels");
    assert!(!harness.state().session().shown.setup.items.shows(Item::Labels));
    command(&mut harness, "shade normal");
    assert_eq!(harness.state().session().shown.setup.shade, pinhole_core::Shade::Normal);
    command(&mut harness, "blind");
    assert_eq!(harness.state().session().preferences.scheme, Scheme::ColourBlind);
    command(&mut harness, "reduced motion");
    assert!(harness.state().session().preferences.reduced_motion);
    command(&mut harness, "exercise sphere");
    let session = harness.state().session();
    assert_eq!(session.exercises.question().exercise, Exercise::Sphere);
    assert_eq!(session.shown.setup.layout, ViewLayout::Exercises);
    command(&mut harness, &format!("mistake {}", Mistake::UpAsV.name()));
    assert_eq!(harness.state().session().shown.mistakes_view.chosen, Mistake::UpAsV);
    command(&mut harness, "scene look-at");
    assert!(harness.state().document().spheres.len() > 1);
    command(&mut harness, "step lesson 7 2.");
    let id = harness.state().lesson().unwrap().id();
    assert_eq!(id.step, 1);
    command(&mut harness, "lesson previous");
    assert_eq!(harness.state().lesson().unwrap().id().step, 0);
    command(&mut harness, "close the lesson");
    assert!(harness.state().lesson().is_none());
}

#[test]
fn arrows_choose_and_escape_closes_without_doing_anything() {
    let mut harness = window("canonical");
    let before = harness.state().session().clone();
    look_for(&mut harness, "layout");
    let (titles, chosen) = listed(&harness);
    let layouts = titles.iter().take_while(|title| title.starts_with("Layout: ")).count();
    assert!(layouts > 3, "{titles:?}");
    assert_eq!(chosen, titles[..1]);
    press(&mut harness, Modifiers::NONE, Key::ArrowDown);
    press(&mut harness, Modifiers::NONE, Key::ArrowDown);
    press(&mut harness, Modifiers::NONE, Key::ArrowUp);
    assert_eq!(listed(&harness).1, titles[1..2]);
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert!(!is_open(&harness));
    assert_eq!(harness.state().session().settings(), before.settings());
    assert_eq!(harness.state().session().shown.selection, before.shown.selection);
}

#[test]
fn the_palette_stays_where_it_is_while_somebody_types() {
    let mut harness = window("canonical");
    press(&mut harness, Modifiers::COMMAND, Key::P);
    let position = |harness: &Harness<'_, App>| {
        harness.get_by_role_and_label(Role::TextInput, "Command").rect().min
    };
    let before = position(&harness);
    for text in ["lay", "out d", "qqqq"] {
        harness.get_by_role_and_label(Role::TextInput, "Command").type_text(text);
        harness.run();
        assert_eq!(position(&harness), before, "{text}");
    }
}

#[test]
fn a_letter_that_nothing_has_finds_nothing() {
    let mut harness = window("canonical");
    let before = harness.state().session().settings();
    look_for(&mut harness, "qqqq");
    assert_eq!(listed(&harness).0, Vec::<String>::new());
    press(&mut harness, Modifiers::NONE, Key::Enter);
    assert!(is_open(&harness));
    assert_eq!(harness.state().session().settings(), before);
}

#[test]
fn a_slash_opens_it_too_but_not_while_a_number_is_typed() {
    let mut harness = window("canonical");
    press(&mut harness, Modifiers::NONE, Key::Slash);
    assert!(is_open(&harness));
    press(&mut harness, Modifiers::NONE, Key::Escape);
    let field = || "eye x";
    harness.get_by_role_and_label(Role::SpinButton, field()).click();
    harness.run();
    press(&mut harness, Modifiers::NONE, Key::Slash);
    assert!(!is_open(&harness));
    press(&mut harness, Modifiers::SHIFT, Key::Questionmark);
    assert!(harness.query_by_label("Close (Escape)").is_none());
    harness.get_by_role_and_label(Role::SpinButton, field()).type_text("1/4");
    harness.run();
    // What was typed is taken over first.
    press(&mut harness, Modifiers::COMMAND, Key::P);
    assert!(is_open(&harness));
    assert_eq!(harness.state().document().camera.eye.x, 0.25);
}

#[test]
fn the_sheet_has_every_key_and_escape_closes_it() {
    let mut harness = window("canonical");
    press(&mut harness, Modifiers::SHIFT, Key::Questionmark);
    for (_, rows) in commands_table::sheet() {
        for (keys, name) in rows {
            assert!(harness.query_all_by_label(&keys).next().is_some(), "{keys}");
            assert!(harness.query_all_by_label(&name).next().is_some(), "{name}");
        }
    }
    // No key gets through it.
    press(&mut harness, Modifiers::NONE, Key::F5);
    assert!(harness.state().session().presenting.is_none());
    press(&mut harness, Modifiers::NONE, Key::Escape);
    assert!(harness.query_by_label("Close (Escape)").is_none());
    press(&mut harness, Modifiers::SHIFT, Key::Questionmark);
    press(&mut harness, Modifiers::SHIFT, Key::Questionmark);
    assert!(harness.query_by_label("Close (Escape)").is_none());
}

#[test]
fn keys_do_what_the_table_says() {
    let mut harness = window("canonical");
    type_into(&mut harness, "eye x", "2");
    press(&mut harness, Modifiers::COMMAND, Key::Z);
    assert_eq!(harness.state().document().camera.eye.x, 0.0);
    press(&mut harness, Modifiers::COMMAND, Key::Y);
    assert_eq!(harness.state().document().camera.eye.x, 2.0);
    let zoom = harness.ctx.zoom_factor();
    press(&mut harness, Modifiers::COMMAND, Key::Plus);
    assert!(harness.ctx.zoom_factor() > zoom);
    press(&mut harness, Modifiers::COMMAND, Key::Num0);
    assert_eq!(harness.ctx.zoom_factor(), 1.0);
}

#[test]
fn what_has_nothing_to_be_done_to_is_not_offered() {
    let mut harness = window("canonical");
    let offered = |harness: &mut Harness<'_, App>, text: &str| {
        look_for(harness, text);
        let (titles, _) = listed(harness);
        press(harness, Modifiers::NONE, Key::Escape);
        titles
    };
    let ghost = "Play and compare: Remove the ghost".to_owned();
    let undo = "Edit: Undo".to_owned();
    assert!(!offered(&mut harness, "remove ghost").contains(&ghost));
    assert!(!offered(&mut harness, "undo").contains(&undo));
    command(&mut harness, "freeze ghost");
    assert!(offered(&mut harness, "remove ghost").contains(&ghost));
    command(&mut harness, "look left");
    assert!(offered(&mut harness, "undo").contains(&undo));
    command(&mut harness, "undo");
    assert!(!offered(&mut harness, "undo").contains(&undo));
}
