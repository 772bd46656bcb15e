//! The bar at the top: scenes and files, views, shading, and number format.

use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{Color32, MenuBar, PopupCloseBehavior, RichText, TextStyle, Ui};
use pinhole_core::Shade;
use pinhole_core::methods::Method;
use pinhole_exchange::scenes::{SceneSource, builtin};

use crate::model::color_scheme::Scheme;
use crate::model::files::{OpenDocument, title_of};
use crate::model::lessons::{self, StepId, Which};
use crate::model::overlay_items::Item;
use crate::model::session::presenting::{Range, SMALLEST_TEXT};
use crate::model::session::{DIGITS, Settings, ThemeName, ViewLayout, shade_about, shade_label};
use crate::ui::action::{
    Action, AnswersAction, Available, ExchangeAction, FigureAction, FileAction, GhostAction,
    HistoryAction, Leave, LookAction, Observe, Overlay,
};
use crate::ui::changed::Changed;
use crate::ui::commands_table::shortcut;
use crate::ui::panels::play;
use crate::ui::widgets::asking::Asking as _;
use crate::ui::widgets::spoken::Spoken as _;
use crate::view::derivation::Markup;

/// Shows the bar, and writes the user's choices to `actions` and `settings`. `steps` are the names of
/// those that can be undone and redone.
pub(crate) fn ui(
    ui: &mut Ui,
    open: &OpenDocument,
    recent: &[std::path::PathBuf],
    steps: [Option<&str>; 2],
    there: Available,
    settings: &mut Settings,
    actions: &mut Vec<Action>,
) -> Changed {
    let before = *settings;
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| file_menu(ui, recent, actions));
        ui.menu_button("Edit", |ui| edit_menu(ui, steps, there, actions));
        ui.menu_button("Scenes", |ui| {
            for scene in builtin::all() {
                ui.button(scene.name)
                    .on_hover_text(scene.summary())
                    .asks(Leave::Open(SceneSource::Builtin(scene)), actions);
            }
        });
        ui.menu_button("Lessons", |ui| lessons_menu(ui, actions));
        // These menus stay open for several clicks.
        let stays = || MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let menu = |text| MenuButton::new(text).config(stays());
        menu("Show").ui(ui, |ui| show_menu(ui, there, settings, actions));
        menu("Numbers").ui(ui, |ui| numbers_menu(ui, settings));
        ui.menu_button("Play", |ui| play::menu(ui, actions));
        ui.separator();
        // The same text as in the window's title.
        let changed = if open.has_changes() { "*" } else { "" };
        let title = format!("{}{changed}", title_of(open.origin()));
        let shading = format!("Shading: {}", shade_label(settings.shade));
        let after = [width_of(ui, &shading), width_of(ui, &title).min(TITLE)];
        layout(ui, there.answers, settings, after.into_iter().sum::<f32>() + 2.0 * SEPARATOR);
        ui.separator();
        shade(ui, &shading, &mut settings.shade);
        ui.separator();
        ui.add(egui::Label::new(RichText::new(&title).strong()).truncate()).on_hover_text(title);
    });
    Changed::SESSION.when(*settings != before)
}

/// Minimum width of the scene's name, and width of a separator, in points.
const TITLE: f32 = 64.0;
const SEPARATOR: f32 = 14.0;

/// Returns the width of a button with this text, including the space beside it.
fn width_of(ui: &Ui, text: &str) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    text.size().x + 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x
}

fn lessons_menu(ui: &mut Ui, actions: &mut Vec<Action>) {
    for (index, lesson) in lessons::builtin::all().iter().enumerate() {
        let which = Which::Builtin(index);
        ui.button(lessons::title_of(which, lesson))
            .asks(Leave::GoTo(StepId { lesson: which, step: 0 }), actions);
    }
}

fn file_menu(ui: &mut Ui, recent: &[std::path::PathBuf], actions: &mut Vec<Action>) {
    entry(ui, "Open…", FileAction::AskOpen, actions);
    entry(ui, "Save", FileAction::Save, actions);
    entry(ui, "Save as…", FileAction::AskSaveAs, actions);
    ui.separator();
    entry(ui, "Check answers…", AnswersAction::Ask, actions);
    ui.separator();
    entry(ui, "Export a figure…", FigureAction::Ask, actions);
    entry(ui, "Copy the derivation as LaTeX", FigureAction::CopyDerivation(Markup::Latex), actions);
    entry(
        ui,
        "Copy the derivation as Markdown",
        FigureAction::CopyDerivation(Markup::Markdown),
        actions,
    );
    ui.separator();
    ui.menu_button("Recent", |ui| {
        if recent.is_empty() {
            ui.weak("no file yet");
        }
        for path in recent {
            ui.button(path.display().to_string())
                .asks(Leave::Open(SceneSource::File(path.clone())), actions);
        }
    });
    ui.separator();
    entry(ui, "Quit", Leave::Quit, actions);
}

/// Shows a menu entry with its key.
fn entry(ui: &mut Ui, text: &str, action: impl Into<Action>, actions: &mut Vec<Action>) {
    let action = action.into();
    ui.add(egui::Button::new(text).shortcut_text(shortcut(action.clone()))).asks(action, actions);
}

/// Shows a menu entry that is disabled while there is nothing to do it to.
fn possible_entry(
    ui: &mut Ui,
    text: &str,
    action: impl Into<Action>,
    there: Available,
    actions: &mut Vec<Action>,
) {
    let action = action.into();
    ui.add_enabled_ui(action.is_possible(there), |ui| entry(ui, text, action, actions));
}

fn edit_menu(ui: &mut Ui, steps: [Option<&str>; 2], there: Available, actions: &mut Vec<Action>) {
    let verbs = [("Undo", HistoryAction::Undo), ("Redo", HistoryAction::Redo)];
    for ((verb, action), step) in verbs.into_iter().zip(steps) {
        let text = step.map_or(verb.to_owned(), |step| format!("{verb} {step}"));
        possible_entry(ui, &text, action, there, actions);
    }
    entry(ui, "Paste a camera", ExchangeAction::AskPaste, actions);
}

fn show_menu(ui: &mut Ui, there: Available, settings: &mut Settings, actions: &mut Vec<Action>) {
    entry(ui, "Presenter mode", LookAction::Present, actions);
    entry(ui, "Frame all", Observe::FrameAll, actions);
    entry(ui, "Frame the camera", Observe::FrameCamera, actions);
    entry(ui, "Command palette", Overlay::Palette, actions);
    entry(ui, "Keys", Overlay::Keys, actions);
    ui.separator();
    possible_entry(ui, "Freeze the camera as ghost", GhostAction::Freeze, there, actions);
    possible_entry(ui, "Swap camera and ghost", GhostAction::Swap, there, actions);
    possible_entry(ui, "Drop the ghost", GhostAction::Drop, there, actions);
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
        for &method in Method::ALL {
            let hint = format!("{}\n{}", method.about(), method.source());
            ui.radio_value(&mut settings.method.0, method, method.name()).on_hover_text(hint);
        }
    });
    ui.separator();
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
    ui.checkbox(&mut settings.reduced_motion, "Reduced motion");
    ui.horizontal(|ui| {
        ui.label("Smallest text while presenting");
        let Range { least, most, .. } = SMALLEST_TEXT;
        let field = egui::DragValue::new(&mut settings.smallest_text).range(least..=most);
        let hint = "Points in a window of 1024 × 768; in a larger one it grows with the window";
        let response = ui.add(field.speed(0.1).max_decimals(0)).on_hover_text(hint);
        response.named("smallest text while presenting");
    });
    ui.separator();
    let zoom = |by| shortcut(LookAction::ZoomBy(by));
    ui.weak(format!("Zoom: {} and {}", zoom(1), zoom(-1)));
}

fn numbers_menu(ui: &mut Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        ui.label("Significant digits");
        ui.add(egui::DragValue::new(&mut settings.digits).range(DIGITS.0..=DIGITS.1).speed(0.05))
            .named("significant digits");
    });
    ui.checkbox(&mut settings.count_from_one, "Count rows and columns from 1");
}

/// Shows the layouts side by side. Layouts without room move into a menu; `after` is the width
/// reserved for what follows.
fn layout(ui: &mut Ui, has_answers: bool, settings: &mut Settings, after: f32) {
    let answers = has_answers.then_some(ViewLayout::Answers);
    let layouts: Vec<ViewLayout> = ViewLayout::listed().chain(answers).collect();
    let widths: Vec<f32> = layouts.iter().map(|layout| width_of(ui, layout.label())).collect();
    let room = ui.available_width() - after;
    let fits = |room: f32| {
        let ends = widths.iter().scan(0.0, |end, width| {
            *end += width;
            Some(*end)
        });
        ends.take_while(|end| *end <= room).count()
    };
    let chosen = settings.layout;
    let more = |hidden: &[ViewLayout]| match hidden.contains(&chosen) {
        true => format!("More: {}", chosen.label()),
        false => "More".to_owned(),
    };
    let shown = match fits(room) {
        all if all == layouts.len() => all,
        // The longest label that the menu can have.
        _ => fits(room - width_of(ui, &format!("More: {}", ViewLayout::Translator.label()))),
    };
    let (shown, hidden) = layouts.split_at(shown);
    let mut choices = |ui: &mut Ui, layouts: &[ViewLayout]| {
        for layout in layouts {
            let value = ui.selectable_value(&mut settings.layout, *layout, layout.label());
            value.on_hover_text(layout.about());
        }
    };
    choices(ui, shown);
    if !hidden.is_empty() {
        ui.menu_button(more(hidden), |ui| choices(ui, hidden));
    }
}

fn shade(ui: &mut Ui, text: &str, chosen: &mut Shade) {
    ui.menu_button(text, |ui| {
        for one in Shade::ALL {
            let radio = ui.radio_value(chosen, one, shade_label(one));
            radio.on_hover_text(shade_about(one));
        }
    });
}
