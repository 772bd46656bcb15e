//! The bar at the top: the menus, the four workspaces, and the pages of the open workspace.

use std::path::PathBuf;

use egui::containers::menu::{MenuButton, MenuConfig, SubMenuButton, is_in_menu};
use egui::{MenuBar, PopupCloseBehavior, RichText, Ui};
use pinhole_core::Shade;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};
use pinhole_figure::Scheme;
use pinhole_figure::derivation::Markup;
use pinhole_figure::overlay_items::Item;

use crate::features::play::state::Kind;
use crate::model::files::{OpenDocument, title_of};
use crate::model::lessons::{self, StepId, Which};
use crate::model::session::{DIGITS, TOOLS, ThemeName, ViewLayout, Workspace, shade_texts};
use crate::ui::action::{
    Action, Available, FigureAction, FileAction, FileUse, Leave, LookAction, ObjectAction, Observe,
    PlayAction, ShareAction, Switch, request,
};
use crate::ui::commands_table::{command_of, hint, shortcut};
use crate::ui::widgets::{ResponseExt as _, button_width};

/// Shows the menu entries of these commands, with their names. A semicolon stands for a line between them.
macro_rules! entries {
    ($ui:ident, $there:ident: $($action:expr),+ $(; $($rest:expr),+)*) => {
        for action in [$(Action::from($action)),+] {
            named_entry($ui, $there, name_of(&action), action);
        }
        $(entries!($ui, $there; $($rest),+);)*
    };
    ($ui:ident, $there:ident; $($action:expr),+) => {
        $ui.separator();
        entries!($ui, $there: $($action),+);
    };
}

/// Shows the bar, and requests what the user chooses.
pub(crate) fn ui(ui: &mut Ui, open: &OpenDocument, recent: &[PathBuf], there: Available<'_>) {
    MenuBar::new().ui(ui, |ui| {
        let menus = |ui: &mut Ui| {
            // This menu stays open for several clicks.
            let stays = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
            ui.menu_button("File", |ui| file_menu(ui, recent, there));
            ui.menu_button("Edit", |ui| edit_menu(ui, there));
            let view = |ui: &mut Ui| view_menu(ui, there);
            match is_in_menu(ui) {
                true => drop(SubMenuButton::new("View").config(stays).ui(ui, view)),
                false => drop(MenuButton::new("View").config(stays).ui(ui, view)),
            }
            ui.menu_button("Lessons", |ui| {
                for (index, lesson) in lessons::builtin::all().iter().enumerate() {
                    let which = Which::Builtin(index);
                    let first = StepId { lesson: which, step: 0 };
                    ui.button(lessons::title_of(which, lesson)).asks(Leave::GoTo(first));
                }
            });
            ui.menu_button("Play", |ui| {
                for kind in Kind::ALL {
                    ui.button(kind.label()).asks(PlayAction::Open(kind));
                }
            });
            ui.menu_button("Tools", |ui| choices(ui, there, TOOLS, LookAction::Layout));
            ui.menu_button("Help", |ui| {
                entries!(ui, there: Action::ShowKeys, Action::OpenPalette;
                    Action::ShowConventions, Action::ShowAbout);
            });
        };
        if ui.available_width() < NARROW {
            ui.menu_button("Menu", menus);
        } else {
            menus(ui);
        }
        ui.separator();
        workspaces(ui, there);
        pages(ui, there);
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
fn workspaces(ui: &mut Ui, there: Available<'_>) {
    let layout = there.session.shown.setup.layout;
    let open = layout.workspace();
    let width: f32 = Workspace::ALL.iter().map(|one| button_width(ui, one.label())).sum();
    let choices = |ui: &mut Ui| {
        for workspace in Workspace::ALL {
            let is_open = open == Some(workspace);
            let tab = ui.selectable_label(is_open, RichText::new(workspace.label()).strong());
            let on_stage = there.lesson && workspace == Workspace::Derivation;
            let is_whole = on_stage && layout != ViewLayout::DerivationAlone;
            if tab.on_hover_text(workspace.about()).clicked() && (on_stage || !is_open) {
                let page = workspace.pages()[0];
                let page = if is_whole { ViewLayout::DerivationAlone } else { page };
                request(ui.ctx(), LookAction::Layout(page));
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
fn pages(ui: &mut Ui, there: Available<'_>) {
    let layout = there.session.shown.setup.layout;
    let pages = match layout.workspace() {
        Some(Workspace::Scene) => return ghost(ui, there),
        Some(workspace) => workspace.pages(),
        None => TOOLS,
    };
    let is_there = |page: &ViewLayout| Action::from(LookAction::Layout(*page)).is_possible(there);
    let pages: Vec<ViewLayout> = pages.iter().copied().filter(is_there).collect();
    if pages.len() < 2 {
        return;
    }
    ui.separator();
    let width: f32 = pages.iter().map(|page| button_width(ui, page.label())).sum();
    if width + TITLE <= ui.available_width() {
        choices(ui, there, &pages, LookAction::Layout);
    } else {
        ui.menu_button(layout.label(), |ui| choices(ui, there, &pages, LookAction::Layout));
    }
}

/// Shows the switch that turns on the comparison with the ghost, a frozen camera.
fn ghost(ui: &mut Ui, there: Available<'_>) {
    let is_on = LookAction::Layout(ViewLayout::Compare).is_on(there.session);
    ui.separator();
    let hint = "Compare the camera with a ghost of it: G freezes one";
    if ui.selectable_label(is_on, "Ghost").on_hover_text(hint).clicked() {
        let layout = if is_on { ViewLayout::Both } else { ViewLayout::Compare };
        request(ui.ctx(), LookAction::Layout(layout));
        if !is_on && there.session.shown.ghost.is_none() {
            request(ui.ctx(), Action::FreezeGhost);
        }
    }
}

/// Shows a menu entry with this text, and with the key of its command. It is disabled while its action is not
/// possible.
fn named_entry(ui: &mut Ui, there: Available<'_>, text: &str, action: impl Into<Action>) {
    let action = action.into();
    let stays = matches!(action, Action::Look(LookAction::ZoomBy(_)));
    let button = egui::Button::new(text).shortcut_text(shortcut(action.clone()));
    let response = ui.add_enabled(action.is_possible(there), button);
    if response.clicked() && !stays {
        ui.close();
    }
    response.asks(action);
}

/// Returns the name of an action's command.
fn name_of(action: &Action) -> &'static str {
    command_of(action).map_or("", |command| &command.name)
}

/// Shows choices or switches with the names of their commands.
fn choices<T: Copy>(ui: &mut Ui, there: Available<'_>, all: &[T], action: fn(T) -> LookAction) {
    for action in all.iter().copied().map(action) {
        choice(ui, there, name_of(&action.into()), action);
    }
}

/// Shows a choice or a switch, marked while it is on, with the description of its command.
fn choice(ui: &mut Ui, there: Available<'_>, text: &str, action: LookAction) {
    let mut is_on = action.is_on(there.session);
    let response = match action {
        LookAction::Toggle(_) => ui.checkbox(&mut is_on, text),
        LookAction::Layout(_) => ui.selectable_label(is_on, text),
        _ => ui.radio(is_on, text),
    };
    response.on_hover_text(hint(action)).asks(action);
}

fn file_menu(ui: &mut Ui, recent: &[PathBuf], there: Available<'_>) {
    entries!(ui, there:
        Leave::New, FileUse::Open, FileUse::Import, FileAction::Save(None),
        FileUse::SaveAs(None), FileUse::SavePage, FileUse::SaveStep,
        ShareAction::Show;
        FileUse::CheckAnswers;
        FigureAction::Ask, FigureAction::Copy, FigureAction::CopyDerivation(Markup::Latex),
        FigureAction::CopyDerivation(Markup::Markdown)
    );
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
            let open = Leave::Open(SceneSource::File(path.clone()));
            ui.button(path.display().to_string()).asks(open);
        }
    });
    if Action::from(Leave::Quit).is_possible(there) {
        entries!(ui, there; Leave::Quit);
    }
}

fn edit_menu(ui: &mut Ui, there: Available<'_>) {
    for (verb, step, action) in
        [("Undo", there.undo, Action::Undo), ("Redo", there.redo, Action::Redo)]
    {
        named_entry(ui, there, format!("{verb} {}", step.unwrap_or_default()).trim(), action);
    }
    entries!(ui, there: Action::AskPaste; ObjectAction::Duplicate, ObjectAction::Delete);
}

fn view_menu(ui: &mut Ui, there: Available<'_>) {
    entries!(ui, there: LookAction::Present);
    named_entry(ui, there, "Vote: guess which mistake", LookAction::Vote);
    entries!(ui, there:
        LookAction::Recap, Observe::FrameAll, Observe::FrameCamera, FileAction::KeepView;
        Action::FreezeGhost, Action::DropGhost
    );
    ui.separator();
    ui.menu_button("Drawn over the views", |ui| {
        choices(ui, there, &Item::ALL, |item| LookAction::Toggle(Switch::Item(item)));
    });
    ui.menu_button("Shading", |ui| {
        for shade in Shade::ALL {
            choice(ui, there, shade_texts(shade)[0], LookAction::Shade(shade));
        }
    });
    ui.menu_button("Colours", |ui| {
        choices(ui, there, &ThemeName::ALL, LookAction::Theme);
        ui.separator();
        choices(ui, there, &Scheme::ALL, LookAction::Scheme);
    });
    ui.menu_button("Numbers", |ui| numbers_menu(ui, there));
    ui.separator();
    choices(ui, there, &[Switch::ReducedMotion], LookAction::Toggle);
    entries!(ui, there: LookAction::ZoomBy(1), LookAction::ZoomBy(-1), LookAction::ZoomBy(0));
}

fn numbers_menu(ui: &mut Ui, there: Available<'_>) {
    ui.horizontal(|ui| {
        ui.label("Significant digits");
        let mut digits = there.session.shown.setup.digits;
        let field = egui::DragValue::new(&mut digits).range(DIGITS.0..=DIGITS.1).speed(0.05);
        if ui.add(field).named("significant digits").changed() {
            request(ui.ctx(), LookAction::Digits(digits));
        }
    });
    let from_one = LookAction::Toggle(Switch::CountFromOne);
    choice(ui, there, "Count rows and columns from 1", from_one);
}
