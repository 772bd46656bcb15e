//! The program in a window that is only in memory.

use std::path::Path;

use egui::accesskit::Role;
use egui::{Key, Modifiers, OutputCommand, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::files::OpenDocument;
use pinhole::model::session::{Preferences, Settings, Unfolded, ViewLayout};
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_exchange::scenes::SceneSource;

use crate::support::{self, whole_window};

/// The window is this large, in points, unless a test says otherwise.
pub(crate) const SIZE: egui::Vec2 = vec2(1280.0, 1000.0);

/// A window on a scene, by name or path, with a store that is remembered in `folder`.
pub(crate) fn window_with(
    scene: impl AsRef<Path>,
    remembered: Remembered,
    store: Option<Store>,
) -> Harness<'static, App> {
    let source = SceneSource::from_argument(scene.as_ref()).unwrap();
    let settings = remembered.settings;
    let app = App::new(OpenDocument::open(source).unwrap(), remembered, store);
    let mut harness = support::harness()
        .with_size(SIZE)
        .with_max_steps(30)
        .with_context_setup(move |ctx| App::set_up(ctx, &settings))
        .build_ui_state(whole_window::show, app);
    harness.run();
    harness
}

/// The settings of somebody who has unfolded everything.
pub(crate) fn unfolded() -> Settings {
    let unfolded = Unfolded {
        note: true,
        viewport: true,
        ray: true,
        objects: true,
        numbers: true,
        camera: true,
    };
    Settings {
        preferences: Preferences { unfolded, ..Preferences::default() },
        ..Settings::default()
    }
}

/// A window on a scene, by name or path, with everything unfolded.
pub(crate) fn window(scene: impl AsRef<Path>) -> Harness<'static, App> {
    window_with(scene, Remembered { settings: unfolded(), ..Remembered::default() }, None)
}

/// Carries out the command of this title by the command palette.
pub(crate) fn command(harness: &mut Harness<'_, App>, title: &str) {
    // Measuring never rests.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::TextInput, "Command").type_text(title);
    harness.run_steps(3);
    harness.key_press(Key::Enter);
    harness.run_ok();
}

/// Shows a layout.
pub(crate) fn show(harness: &mut Harness<'_, App>, layout: ViewLayout) {
    command(harness, &format!("Layout: {}", layout.label()));
    assert_eq!(harness.state().session().shown.setup.layout, layout);
}

/// Chooses an object in the list, as a click does.
pub(crate) fn choose_object(harness: &mut Harness<'_, App>, title: &str) {
    harness.get_by_role_and_label(Role::Button, title).click();
    harness.run();
}

/// Opens a built-in scene.
pub(crate) fn open_scene(harness: &mut Harness<'_, App>, name: &str) {
    command(harness, &format!("Scene: {name}"));
}

/// Types into the number field of this name, as a person does: click, type over, Enter.
pub(crate) fn type_into(harness: &mut Harness<'_, App>, field: &str, text: &str) {
    harness.get_by_role_and_label(Role::SpinButton, field).click();
    harness.run();
    harness.get_by_role_and_label(Role::SpinButton, field).type_text(text);
    harness.run();
    harness.key_press(egui::Key::Enter);
    harness.run();
}

/// Whether a readout with exactly this text is there.
pub(crate) fn says(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label(text).next().is_some()
}

/// Every text on the screen that contains this, for a failing test to show.
pub(crate) fn texts_with(harness: &Harness<'_, App>, part: &str) -> Vec<String> {
    let texts = harness
        .root()
        .children_recursive()
        .filter_map(|node| node.accesskit_node().label().or_else(|| node.accesskit_node().value()));
    texts.filter(|text| text.contains(part)).collect()
}

/// Fails, with what there is instead, unless the readout is there.
#[track_caller]
pub(crate) fn assert_says(harness: &Harness<'_, App>, text: &str) {
    let near = text.split(' ').next().unwrap_or_default();
    assert!(says(harness, text), "no “{text}”; there is {:?}", texts_with(harness, near));
}

/// Fails unless something is there that a screen reader reads as exactly this text.
#[track_caller]
pub(crate) fn assert_reads(harness: &Harness<'_, App>, text: &str) {
    let read = |value: Option<String>| value.is_some_and(|value| value == text);
    let found = harness.root().children_recursive().any(|n| read(n.accesskit_node().value()));
    assert!(found, "no “{text}”; there is {:?}", texts_with(harness, "t"));
}

/// Presses the mouse here and lets it go.
pub(crate) fn click_at(harness: &mut Harness<'_, App>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.run();
    harness.drag_at(at);
    harness.run();
    harness.drop_at(at);
    harness.run();
}

/// Drags the mouse from here by so much.
pub(crate) fn drag_from(harness: &mut Harness<'_, App>, from: egui::Pos2, by: egui::Vec2) {
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    harness.run();
    harness.hover_at(from + 0.5 * by);
    harness.run();
    harness.hover_at(from + by);
    harness.run();
    harness.drop_at(from + by);
    harness.run();
}

/// Returns the text that the next frames put on the clipboard.
pub(crate) fn copied_text(harness: &mut Harness<'_, App>) -> String {
    let mut copied = String::new();
    for _ in 0..4 {
        harness.step();
        for command in &harness.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied.clone_from(text);
            }
        }
    }
    copied
}

/// Types the path into the dialog that is open, and presses Enter, which is answered in the next frame.
pub(crate) fn export_to(window: &mut Harness<'_, App>, path: &Path) {
    window.get_by_role_and_label(Role::TextInput, "path").focus();
    window.run();
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    window.get_by_role_and_label(Role::TextInput, "path").type_text(path.to_str().unwrap());
    window.run();
    window.key_press(egui::Key::Enter);
}
