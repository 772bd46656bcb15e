//! The bar on top: scenes and files, views, how pictures are coloured, and how numbers are written.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{MenuBar, PopupCloseBehavior, Ui};
use pinhole_core::Shade;
use pinhole_core::methods::Method;

use crate::action::Action;
use crate::files::{OpenDocument, title_of};
use crate::formats::builtin;
use crate::formats::scene_argument::SceneSource;
use crate::ledger::Markup;
use crate::lessons::{self, Place, Which};
use crate::overlay::Item;
use crate::panels::{compare, play};
use crate::session::{DIGITS, Settings, ShadeName, ThemeName, ViewLayout};

/// What the history would undo and redo.
pub(crate) struct Steps<'a> {
    /// The name of the last step.
    pub(crate) undo: Option<&'a str>,
    /// The name of the step that was undone last.
    pub(crate) redo: Option<&'a str>,
}

/// Shows the bar; what was chosen in it goes into `actions` and `settings`.
pub(crate) fn ui(
    ui: &mut Ui,
    open: &OpenDocument,
    recent: &[std::path::PathBuf],
    steps: Steps,
    has_ghost: bool,
    settings: &mut Settings,
    actions: &mut Vec<Action>,
) {
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| file_menu(ui, recent, actions));
        ui.menu_button("Edit", |ui| edit_menu(ui, steps, actions));
        ui.menu_button("Scenes", |ui| {
            for scene in builtin::all() {
                if ui.button(scene.name).on_hover_text(scene.summary()).clicked() {
                    actions.push(Action::Open(SceneSource::Builtin(scene)));
                }
            }
        });
        ui.menu_button("Lessons", |ui| lessons_menu(ui, actions));
        // Several switches in one go: these stay open while one clicks in them.
        let stays = || MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let menu = |text| MenuButton::new(text).config(stays());
        menu("Show").ui(ui, |ui| show_menu(ui, has_ghost, settings, actions));
        menu("Numbers").ui(ui, |ui| numbers_menu(ui, settings));
        ui.menu_button("Play", |ui| play::menu(ui, actions));
        ui.separator();
        layout(ui, settings);
        ui.separator();
        shade(ui, &mut settings.shade);
        ui.separator();
        let changed = if open.has_changes() { " (changed)" } else { "" };
        ui.strong(format!("{}{changed}", title_of(open.origin())));
    });
}

fn lessons_menu(ui: &mut Ui, actions: &mut Vec<Action>) {
    for (index, lesson) in lessons::builtin::all().iter().enumerate() {
        let which = Which::Builtin(index);
        if ui.button(lessons::title_of(which, lesson)).clicked() {
            actions.push(Action::GoTo(Place { lesson: which, step: 0 }));
        }
    }
}

fn file_menu(ui: &mut Ui, recent: &[std::path::PathBuf], actions: &mut Vec<Action>) {
    let mut entry = |ui: &mut Ui, text: &str, keys: &str, action: Action| {
        if ui.add(egui::Button::new(text).shortcut_text(keys)).clicked() {
            actions.push(action);
        }
    };
    entry(ui, "Open…", "Ctrl+O", Action::AskOpen);
    entry(ui, "Save", "Ctrl+S", Action::Save);
    entry(ui, "Save as…", "Ctrl+Shift+S", Action::AskSaveAs);
    ui.separator();
    entry(ui, "Export a figure…", "Ctrl+E", Action::AskExport);
    entry(ui, "Copy the ledger as LaTeX", "", Action::CopyLedger(Markup::Latex));
    entry(ui, "Copy the ledger as Markdown", "", Action::CopyLedger(Markup::Markdown));
    ui.separator();
    ui.menu_button("Recent", |ui| {
        if recent.is_empty() {
            ui.weak("no file yet");
        }
        for path in recent {
            if ui.button(path.display().to_string()).clicked() {
                actions.push(Action::Open(SceneSource::File(path.clone())));
            }
        }
    });
    ui.separator();
    if ui.add(egui::Button::new("Quit").shortcut_text("Ctrl+Q")).clicked() {
        actions.push(Action::Quit);
    }
}

fn edit_menu(ui: &mut Ui, steps: Steps, actions: &mut Vec<Action>) {
    let mut entry = |verb: &str, step: Option<&str>, keys: &str, action: Action| {
        let text = step.map_or(verb.to_owned(), |step| format!("{verb} {step}"));
        let button = egui::Button::new(text).shortcut_text(keys);
        if ui.add_enabled(step.is_some(), button).clicked() {
            actions.push(action);
        }
    };
    entry("Undo", steps.undo, "Ctrl+Z", Action::Undo);
    entry("Redo", steps.redo, "Ctrl+Shift+Z", Action::Redo);
}

fn show_menu(ui: &mut Ui, has_ghost: bool, settings: &mut Settings, actions: &mut Vec<Action>) {
    if ui.add(egui::Button::new("Frame all").shortcut_text("F")).clicked() {
        actions.push(Action::FrameAll);
    }
    ui.separator();
    compare::menu(ui, has_ghost, actions);
    ui.separator();
    ui.label("Drawn over the views");
    for item in Item::ALL {
        let mut shown = settings.items.shows(item);
        if ui.checkbox(&mut shown, item.label()).changed() {
            settings.items.set(item, shown);
        }
    }
    ui.separator();
    ui.menu_button("Picture drawn by", |ui| {
        for method in Method::ALL {
            let hint = format!("{}\n{}", method.about(), method.source());
            ui.radio_value(&mut settings.method.0, method, method.name()).on_hover_text(hint);
        }
    });
    ui.separator();
    ui.label("Colours");
    for (theme, text) in [
        (ThemeName::System, "As the system"),
        (ThemeName::Dark, "Dark"),
        (ThemeName::Light, "Light"),
    ] {
        ui.radio_value(&mut settings.theme, theme, text);
    }
    ui.separator();
    ui.weak("Zoom: Ctrl + and Ctrl −");
}

fn numbers_menu(ui: &mut Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        ui.label("Significant digits");
        let response = ui
            .add(egui::DragValue::new(&mut settings.digits).range(DIGITS.0..=DIGITS.1).speed(0.05));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("significant digits"));
    });
    ui.checkbox(&mut settings.count_from_one, "Count rows and columns from 1");
}

fn layout(ui: &mut Ui, settings: &mut Settings) {
    for (layout, text, hint) in [
        (ViewLayout::Both, "Both views", "World view and camera view side by side"),
        (ViewLayout::World, "World", "The world view alone"),
        (ViewLayout::Camera, "Camera", "The camera view alone"),
        (ViewLayout::Ledger, "Ledger", "Every number's derivation, line by line"),
        (ViewLayout::Plot, "Plot", "Every object's f(p + t d) against t"),
        (ViewLayout::Lines, "Lines", "Implicit and parametric lines in two dimensions"),
        (ViewLayout::Mistakes, "Mistakes", "The classic wrong cameras beside the right one"),
        (ViewLayout::Compare, "Compare", "The camera against the one that was frozen by G"),
        (ViewLayout::Exercises, "Exercises", "Questions, and what is wrong with an answer"),
        (ViewLayout::Accuracy, "Accuracy", "How right each method is here, and how fast"),
        (ViewLayout::Frame, "Frame", "What a frame takes, and what it leaves out"),
    ] {
        ui.selectable_value(&mut settings.layout, layout, text).on_hover_text(hint);
    }
}

fn shade(ui: &mut Ui, chosen: &mut ShadeName) {
    let names = [
        (ShadeName::Lambert, "Lit from the eye"),
        (ShadeName::Normal, "The normal's x, y, z as red, green, blue"),
        (ShadeName::T, "Nearest t white, farther darker"),
        (ShadeName::Object, "Each object's own colour, flat"),
    ];
    let text = format!("Shade: {}", Shade::from(*chosen).name());
    ui.menu_button(text, |ui| {
        for (name, hint) in names {
            ui.radio_value(chosen, name, Shade::from(name).name()).on_hover_text(hint);
        }
    });
}
