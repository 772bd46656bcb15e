//! The bar at the top: the menus, the four workspaces, and the pages of the open workspace.

use egui::containers::menu::{MenuButton, MenuConfig, SubMenuButton, is_in_menu};
use egui::{MenuBar, PopupCloseBehavior, RichText, Ui};
use pinhole_core::Shade;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};

use crate::model::files::{OpenDocument, title_of};
use crate::model::lessons::{self, StepId, Which};
use crate::model::overlay_items::Item;
use crate::model::session::{
    DIGITS, Scheme, Settings, TOOLS, ThemeName, ViewLayout, Workspace, shade_about, shade_label,
};
use crate::ui::action::{
    Action, AnswersAction, Available, ExchangeAction, FigureAction, FileAction, GhostAction,
    HelpAction, HistoryAction, Leave, LookAction, ObjectAction, Observe, ShareAction, request,
};
use crate::ui::commands_table::shortcut;
use crate::ui::panels::play;
use crate::ui::widgets::{ResponseExt as _, button_width};
use crate::view::derivation::Markup;

/// Shows the bar, and applies or requests what the user chooses. `steps` are the names of the steps that
/// the user can undo and redo.
pub(crate) fn ui(
    ui: &mut Ui,
    open: &OpenDocument,
    recent: &[std::path::PathBuf],
    steps: [Option<&str>; 2],
    there: Available,
    settings: &mut Settings,
) {
    MenuBar::new().ui(ui, |ui| {
        let mut menus = |ui: &mut Ui| {
            // This menu stays open for several clicks.
            let stays = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
            ui.menu_button("File", |ui| file_menu(ui, recent, there));
            ui.menu_button("Edit", |ui| edit_menu(ui, steps, there));
            let view = |ui: &mut Ui| view_menu(ui, there, settings);
            match is_in_menu(ui) {
                true => drop(SubMenuButton::new("View").config(stays).ui(ui, view)),
                false => drop(MenuButton::new("View").config(stays).ui(ui, view)),
            }
            ui.menu_button("Lessons", lessons_menu);
            ui.menu_button("Play", play::menu);
            ui.menu_button("Tools", |ui| tools_menu(ui, settings));
            ui.menu_button("Help", help_menu);
        };
        if ui.available_width() < NARROW {
            ui.menu_button("Menu", menus);
        } else {
            menus(ui);
        }
        ui.separator();
        workspaces(ui, there, settings);
        pages(ui, there, settings);
        ui.separator();
        // The same text as in the window's title.
        let changed = if open.has_changes() { "*" } else { "" };
        let title = format!("{}{changed}", title_of(open.origin()));
        ui.add(egui::Label::new(RichText::new(&title).strong()).truncate()).on_hover_text(title);
    });
}

/// Width of the bar, in points, below which all menus are in one.
const NARROW: f32 = 480.0;

/// Minimum width of the scene's name, in points.
const TITLE: f32 = 64.0;

/// Shows the four workspaces side by side or, if they do not fit, in a menu. A lesson's stage has lines of the
/// derivation beside its figure; there, the whole derivation replaces the figure, and the other way round.
fn workspaces(ui: &mut Ui, there: Available, settings: &mut Settings) {
    let open = settings.layout.workspace();
    let width: f32 = Workspace::ALL.iter().map(|one| button_width(ui, one.label())).sum();
    let mut choices = |ui: &mut Ui| {
        for workspace in Workspace::ALL {
            let is_open = open == Some(workspace);
            let tab = ui.selectable_label(is_open, RichText::new(workspace.label()).strong());
            let on_stage = there.lesson && workspace == Workspace::Derivation;
            let is_whole = on_stage && settings.layout != ViewLayout::DerivationAlone;
            if tab.on_hover_text(workspace.about()).clicked() && (on_stage || !is_open) {
                let page = workspace.pages()[0];
                settings.layout = if is_whole { ViewLayout::DerivationAlone } else { page };
            }
        }
    };
    if width <= ui.available_width() {
        choices(ui);
    } else {
        ui.menu_button(open.map_or("Tools", Workspace::label), choices);
    }
}

/// Shows the pages of the open workspace or, while a tool is open, the tools. If they do not fit side by
/// side, they are in a menu.
fn pages(ui: &mut Ui, there: Available, settings: &mut Settings) {
    let pages: Vec<ViewLayout> = match settings.layout.workspace() {
        Some(Workspace::Scene) => return ghost(ui, there, settings),
        Some(workspace) => workspace.pages().to_vec(),
        None => TOOLS.to_vec(),
    };
    let is_there = |page: &ViewLayout| *page != ViewLayout::Answers || there.answers;
    let pages: Vec<ViewLayout> = pages.into_iter().filter(is_there).collect();
    if pages.len() < 2 {
        return;
    }
    ui.separator();
    let width: f32 = pages.iter().map(|page| button_width(ui, page.label())).sum();
    let open = settings.layout.label();
    let mut choices = |ui: &mut Ui| {
        for page in &pages {
            let choice = ui.selectable_value(&mut settings.layout, *page, page.label());
            choice.on_hover_text(page.about());
        }
    };
    if width + TITLE <= ui.available_width() {
        choices(ui);
    } else {
        ui.menu_button(open, choices);
    }
}

/// Shows the switch that turns on the comparison with the ghost, a frozen camera.
fn ghost(ui: &mut Ui, there: Available, settings: &mut Settings) {
    let is_on = settings.layout == ViewLayout::Compare;
    ui.separator();
    let hint = "Compare the camera with a ghost of it: G freezes one";
    if ui.selectable_label(is_on, "Ghost").on_hover_text(hint).clicked() {
        settings.layout = if is_on { ViewLayout::Both } else { ViewLayout::Compare };
        if !is_on && !there.ghost {
            request(ui.ctx(), GhostAction::Freeze);
        }
    }
}

fn lessons_menu(ui: &mut Ui) {
    for (index, lesson) in lessons::builtin::all().iter().enumerate() {
        let which = Which::Builtin(index);
        ui.button(lessons::title_of(which, lesson))
            .asks(Leave::GoTo(StepId { lesson: which, step: 0 }));
    }
}

fn file_menu(ui: &mut Ui, recent: &[std::path::PathBuf], there: Available) {
    entry(ui, "New", Leave::New);
    entry(ui, "Open…", FileAction::AskOpen);
    entry(ui, "Import a camera…", ExchangeAction::AskImport);
    entry(ui, "Save", FileAction::Save);
    entry(ui, "Save as…", FileAction::AskSaveAs { then: None });
    entry(ui, "Save as a page…", FileAction::AskSavePage);
    entry(ui, "Save this view as a step…", FileAction::AskSaveStep);
    entry(ui, "Share…", ShareAction::Show);
    ui.separator();
    entry(ui, "Check answers…", AnswersAction::Ask);
    ui.separator();
    entry(ui, "Export a figure…", FigureAction::Ask);
    entry(ui, "Copy the figure", FigureAction::Copy);
    entry(ui, "Copy the derivation as LaTeX", FigureAction::CopyDerivation(Markup::Latex));
    entry(ui, "Copy the derivation as Markdown", FigureAction::CopyDerivation(Markup::Markdown));
    ui.separator();
    ui.menu_button("Scenes", |ui| {
        for scene in BuiltinScene::all() {
            let button = ui.button(scene.name).on_hover_text(scene.summary());
            button.asks(Leave::Open(SceneSource::Builtin(scene)));
        }
    });
    ui.menu_button("Recent", |ui| {
        if recent.is_empty() {
            ui.weak("no file yet");
        }
        for path in recent {
            ui.button(path.display().to_string())
                .asks(Leave::Open(SceneSource::File(path.clone())));
        }
    });
    if Action::from(Leave::Quit).is_possible(there) {
        ui.separator();
        entry(ui, "Quit", Leave::Quit);
    }
}

/// Shows a menu entry with its key.
fn entry(ui: &mut Ui, text: &str, action: impl Into<Action>) {
    let action = action.into();
    let stays = matches!(action, Action::Look(LookAction::ZoomBy(_)));
    let response = ui.add(egui::Button::new(text).shortcut_text(shortcut(action.clone())));
    if response.clicked() && !stays {
        ui.close();
    }
    response.asks(action);
}

/// Shows a menu entry that is disabled while its action is not possible.
fn possible_entry(ui: &mut Ui, text: &str, action: impl Into<Action>, there: Available) {
    let action = action.into();
    ui.add_enabled_ui(action.is_possible(there), |ui| entry(ui, text, action));
}

fn edit_menu(ui: &mut Ui, steps: [Option<&str>; 2], there: Available) {
    let verbs = [("Undo", HistoryAction::Undo), ("Redo", HistoryAction::Redo)];
    for ((verb, action), step) in verbs.into_iter().zip(steps) {
        let text = step.map_or(verb.to_owned(), |step| format!("{verb} {step}"));
        possible_entry(ui, &text, action, there);
    }
    entry(ui, "Paste a camera", ExchangeAction::AskPaste);
    ui.separator();
    possible_entry(ui, "Duplicate the chosen object", ObjectAction::Duplicate, there);
    possible_entry(ui, "Delete the chosen object", ObjectAction::Delete, there);
}

fn view_menu(ui: &mut Ui, there: Available, settings: &mut Settings) {
    entry(ui, "Present", LookAction::Present);
    entry(ui, "Vote: guess which mistake", LookAction::Vote);
    entry(ui, "Recap: from view to the ray", LookAction::Recap);
    entry(ui, "Frame all", Observe::FrameAll);
    entry(ui, "Frame the camera", Observe::FrameCamera);
    entry(ui, "Keep this view in the scene", FileAction::KeepView);
    ui.separator();
    possible_entry(ui, "Freeze the camera as a ghost", GhostAction::Freeze, there);
    possible_entry(ui, "Remove the ghost", GhostAction::Drop, there);
    ui.separator();
    ui.menu_button("Drawn over the views", |ui| {
        for item in Item::ALL {
            let mut shown = settings.items.shows(item);
            if ui.checkbox(&mut shown, item.label()).changed() {
                settings.items.set(item, shown);
            }
        }
    });
    ui.menu_button("Shading", |ui| {
        for shade in Shade::ALL {
            let radio = ui.radio_value(&mut settings.shade, shade, shade_label(shade));
            radio.on_hover_text(shade_about(shade));
        }
    });
    ui.menu_button("Colours", |ui| {
        for theme in ThemeName::ALL {
            ui.radio_value(&mut settings.theme, theme, theme.label());
        }
        ui.separator();
        for scheme in Scheme::ALL {
            let radio = ui.radio_value(&mut settings.scheme, scheme, scheme.label());
            radio.on_hover_text(scheme.about());
        }
    });
    ui.menu_button("Numbers", |ui| numbers_menu(ui, settings));
    ui.separator();
    ui.checkbox(&mut settings.reduced_motion, "Reduced motion");
    entry(ui, "Larger", LookAction::ZoomBy(1));
    entry(ui, "Smaller", LookAction::ZoomBy(-1));
    entry(ui, "Reset zoom", LookAction::ZoomBy(0));
}

fn tools_menu(ui: &mut Ui, settings: &mut Settings) {
    for tool in TOOLS {
        let choice = ui.selectable_value(&mut settings.layout, *tool, tool.label());
        choice.on_hover_text(tool.about());
    }
}

fn help_menu(ui: &mut Ui) {
    entry(ui, "Keys", HelpAction::Keys);
    entry(ui, "Command palette", HelpAction::Palette);
    ui.separator();
    entry(ui, "The lecture's conventions", HelpAction::Conventions);
    entry(ui, "About Pinhole", HelpAction::About);
}

fn numbers_menu(ui: &mut Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        ui.label("Significant digits");
        ui.add(egui::DragValue::new(&mut settings.digits).range(DIGITS.0..=DIGITS.1).speed(0.05))
            .named("significant digits");
    });
    ui.checkbox(&mut settings.count_from_one, "Count rows and columns from 1");
}
