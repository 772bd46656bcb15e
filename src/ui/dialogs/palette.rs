//! The command palette, which finds every command by a few of its letters.

use egui::{
    Align, Button, Context, Id, Key, Label, Layout, Modal, Modifiers, RichText, ScrollArea, Ui,
};

use crate::model::session::Session;
use crate::ui::action::{Action, LookAction, request};
use crate::ui::commands_table::{UiCommand, found};
use crate::ui::widgets::{ResponseExt as _, line_field};

/// Size of the names, in points.
const TEXT: f32 = 17.0;
/// Number of commands that are visible at once.
const ROWS: f32 = 10.0;

/// The typed text, the index of the selected command among those that match it, and whether it was in sight.
#[derive(Default)]
pub(crate) struct CommandPalette {
    typed: String,
    chosen: usize,
    is_shown: bool,
}

impl CommandPalette {
    /// A palette with the steps of all lessons, at the step with this index.
    pub(crate) fn contents(chosen: usize) -> CommandPalette {
        CommandPalette { typed: "contents ".to_owned(), chosen, is_shown: false }
    }
}

/// Shows the palette with these commands, and requests the chosen one. Returns true if the palette stays
/// open.
pub(crate) fn ui(
    ctx: &Context,
    palette: &mut CommandPalette,
    commands: &[&UiCommand],
    session: &Session,
) -> bool {
    let mut is_open = true;
    let steps = moves(ctx);
    let response = Modal::new(Id::unique("palette")).show(ctx, |ui| {
        let window = ui.ctx().content_rect();
        ui.set_width((window.width() - 48.0).clamp(120.0, 760.0));
        let before = palette.typed.clone();
        field(ui, palette);
        let fitting = found(&palette.typed, commands.iter().copied());
        let last = fitting.len().saturating_sub(1);
        let is_same = palette.typed == before;
        let next = palette.chosen.saturating_add_signed(steps).min(last);
        palette.chosen = if is_same { next } else { 0 };
        let is_new = steps != 0 || !is_same || !palette.is_shown;
        palette.is_shown = true;
        let chosen = list(ui, &fitting, palette.chosen, is_new, session);
        let entered = ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Enter));
        let chosen = chosen.or(entered.then_some(palette.chosen));
        if let Some(command) = chosen.and_then(|chosen| fitting.get(chosen)) {
            request(ctx, command.action.clone());
            is_open = false;
        }
    });
    is_open && !response.should_close()
}

/// Returns by how many entries the pressed keys move the selection down. Consumes these keys, so that the
/// text field does not receive them.
fn moves(ctx: &Context) -> isize {
    let page = ROWS as isize - 1;
    let keys =
        [(Key::ArrowDown, 1), (Key::ArrowUp, -1), (Key::PageDown, page), (Key::PageUp, -page)];
    let pressed = |key| ctx.input_mut(|i| i.count_and_consume_key(Modifiers::NONE, key)) as isize;
    keys.into_iter().map(|(key, by)| by * pressed(key)).sum()
}

fn field(ui: &mut Ui, palette: &mut CommandPalette) {
    let field = line_field(&mut palette.typed)
        .hint_text("a few letters of a command, scene, lesson, exercise…")
        .font(egui::FontId::proportional(TEXT + 2.0))
        .desired_width(f32::INFINITY)
        .show(ui);
    let response = field.response.response.named("Command");
    if !response.has_focus() {
        response.request_focus();
    }
}

/// Shows the matching commands. Returns the index of the clicked one.
fn list(
    ui: &mut Ui,
    fitting: &[&UiCommand],
    chosen: usize,
    follow: bool,
    session: &Session,
) -> Option<usize> {
    let mut clicked = None;
    let row = ui.ctx().fonts_mut(|fonts| fonts.row_height(&egui::FontId::proportional(TEXT)));
    let row = row + 2.0 * ui.spacing().button_padding.y;
    let most = ROWS * (row + ui.spacing().item_spacing.y);
    let room = ui.ctx().content_rect().height() - 140.0;
    // The list's height does not depend on the number of commands, so that nothing moves while the user
    // types.
    ScrollArea::vertical().max_height(most.min(room).max(row)).auto_shrink(false).show(ui, |ui| {
        for (k, command) in fitting.iter().enumerate() {
            // Each entry is as wide as the palette, with its keys at the right edge.
            let layout = Layout::top_down_justified(Align::Min);
            let entry = entry(command, k == chosen, session, row);
            let response = ui.with_layout(layout, |ui| ui.add(entry)).inner;
            let response = response.named(command.title()).described(command.about.clone());
            let response = response.node(|node| node.set_selected(k == chosen));
            if follow && k == chosen {
                response.scroll_to_me(Some(Align::Center));
            }
            if response.clicked() {
                clicked = Some(k);
            }
        }
        if fitting.is_empty() {
            ui.label(RichText::new("No matching command").size(TEXT));
        }
    });
    ui.separator();
    let about = fitting.get(chosen).map_or("", |command| &*command.about);
    ui.add(Label::new(RichText::new(about).size(TEXT - 2.0)).truncate());
    clicked
}

fn entry<'a>(command: &UiCommand, is_chosen: bool, session: &Session, row: f32) -> Button<'a> {
    let state = match command.action {
        Action::Look(LookAction::Toggle(switch)) if switch.is_on(session) => "on",
        Action::Look(LookAction::Toggle(_)) => "off",
        _ => "",
    };
    let keys = command.keys_text();
    let gap = if state.is_empty() || keys.is_empty() { "" } else { "   " };
    Button::selectable(is_chosen, RichText::new(command.title()).size(TEXT))
        .shortcut_text(RichText::new(format!("{state}{gap}{keys}")).size(TEXT - 2.0))
        .min_size(egui::vec2(0.0, row))
        .truncate()
}
