//! The window's overlays: dialogs, the command palette, the list of keys and the focus ring.

use std::path::PathBuf;

use egui::{Area, Color32, Context, CursorIcon, Event, Id, Order, Sense, Ui};
use pinhole_exchange::scenes::SceneSource;
use pinhole_figure::typesetting::theme;

use super::App;
use super::scene::OpenScene;
use crate::features::share::ui::ShownCode;
use crate::model::lessons::Which;
use crate::ui::action::Leave;
use crate::ui::commands_table::{self, Group, UiCommand};
use crate::ui::dialogs::palette::{self, CommandPalette};
use crate::ui::dialogs::{self, Dialog, Question, help};
use crate::ui::widgets::ResponseExt as _;
use crate::ui::widgets::path_field::FileAnswer;

/// The overlays that are open.
#[derive(Default)]
pub(super) struct Overlays {
    pub(super) dialog: Option<Dialog>,
    /// True if the desktop has a working file dialog.
    pub(super) has_desktop: bool,
    /// The code that is shown over the figure while presenting.
    pub(super) code: Option<ShownCode>,
    pub(super) palette: Option<CommandPalette>,
    pub(super) shows_keys: bool,
    /// True if the focus was last moved by the keyboard. A ring then shows the focus.
    by_keyboard: bool,
}

impl Overlays {
    /// Returns true if an overlay is open that receives all mouse and key input.
    pub(super) fn covers(&self) -> bool {
        self.dialog.is_some() || self.palette.is_some() || self.shows_keys
    }

    /// Returns true if the open dialog has this title.
    pub(super) fn says(&self, title: &str) -> bool {
        matches!(&self.dialog, Some(Dialog::Question(question)) if question.title == title)
    }

    /// Opens a dialog. If the dialog asks for a file and the desktop has its own file dialog, the user
    /// chooses the file there.
    pub(super) fn open(&mut self, mut dialog: Dialog) {
        if self.has_desktop {
            dialog.leave_to_desktop();
        }
        self.dialog = Some(dialog);
    }

    /// Asks a question, or shows a message.
    pub(super) fn ask(&mut self, question: Question) {
        self.open(Dialog::Question(question));
    }

    /// Passes on the answer of the desktop's file dialog, and stops using that dialog if it does not
    /// work.
    pub(super) fn answer(&mut self, answer: FileAnswer) {
        self.has_desktop &= answer != FileAnswer::Unavailable;
        dialogs::answer(&mut self.dialog, answer);
    }

    /// Draws the focus ring.
    pub(super) fn marks(&mut self, ui: &Ui) {
        let (pressed, moved) = ui.input(|i| {
            let moves = [egui::Key::Tab, egui::Key::ArrowDown, egui::Key::ArrowUp];
            (i.pointer.any_pressed(), moves.iter().any(|key| i.key_pressed(*key)))
        });
        self.by_keyboard = (self.by_keyboard || moved) && !pressed;
        if self.by_keyboard {
            theme::focus_ring(ui);
        }
    }
}

/// Takes all input of keys and of the clipboard, so that none of it does something unseen while the screen is
/// blank. Returns true if a key was pressed; a key that is still held does not count.
pub(super) fn took_key(ctx: &Context) -> bool {
    let is_pressed =
        |event: &Event| matches!(event, Event::Key { pressed: true, repeat: false, .. });
    let is_taken = |event: &Event| {
        use Event::{Copy, Cut, Key, Paste, Text};
        matches!(event, Key { pressed: true, .. } | Text(_) | Paste(_) | Copy | Cut)
    };
    ctx.input_mut(|input| {
        let was_pressed = input.events.iter().any(is_pressed);
        input.events.retain(|event| !is_taken(event));
        was_pressed
    })
}

/// Covers the window with black. Returns true if it was clicked.
pub(super) fn blank(ctx: &Context) -> bool {
    let window = ctx.content_rect();
    let area = Area::new(Id::unique("blank")).order(Order::Tooltip).fixed_pos(window.min);
    let shown = area.constrain(false).show(ctx, |ui| {
        let (rect, response) = ui.allocate_exact_size(window.size(), Sense::click_and_drag());
        ui.painter().rect_filled(rect, 0.0, Color32::BLACK);
        response.on_hover_cursor(CursorIcon::None).named("Blank screen").clicked()
    });
    shown.inner
}

impl App {
    /// Shows the open overlays, and requests the commands that the user chooses in them.
    pub(super) fn overlays(&mut self, ctx: &Context) {
        let over = &mut self.over;
        dialogs::ui(ctx, &mut over.dialog);
        if let Some(Dialog::Share(form)) = &over.dialog {
            self.window.kept.address.clone_from(&form.address);
        }
        over.shows_keys = over.shows_keys && help::ui(ctx);
        if let Some(mut palette) = over.palette.take() {
            let (extra, there) =
                (commands_of_what_is_open(&self.scene, &self.window.kept.recent), self.available());
            let commands = commands_table::all().iter().chain(&extra);
            let commands: Vec<&UiCommand> =
                commands.filter(|command| command.action.is_possible(there)).collect();
            let stays = palette::ui(ctx, &mut palette, &commands, &self.scene.session);
            self.over.palette = stays.then_some(palette);
        }
    }
}

/// Returns commands for the steps of a lesson from a file, and for recent files.
fn commands_of_what_is_open(scene: &OpenScene, recent: &[PathBuf]) -> Vec<UiCommand> {
    let open = scene.lessons.open.as_ref();
    let own = open.filter(|open| open.id().lesson == Which::File);
    let mut commands =
        own.map_or_else(Vec::new, |own| commands_table::of_lesson(Which::File, own.lesson()));
    commands.extend(recent.iter().map(|path| {
        let name = format!("open {}", path.display());
        let open = Leave::Open(SceneSource::File(path.to_owned()));
        commands_table::command(Group::File, &name, "Opens this recent file.", open)
    }));
    commands
}
