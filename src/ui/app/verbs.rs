//! Carrying out the commands that change how things are shown, presenter mode among them, and what
//! lies over the window: the command palette and the sheet of keys.

use egui::{Context, ThemePreference, Ui};

use super::App;
use crate::model::lessons::Which;
use crate::model::mistakes_view::MistakesView;
use crate::model::presenting::{self, Presenting, SMALLEST_TEXT};
use crate::model::session::{DIGITS, Settings, ThemeName, ViewLayout};
use crate::ui::action::{Action, Available, Leave, LookAction, ObjectAction, Overlay};
use crate::ui::commands_table::{self, Group, UiCommand};
use crate::ui::dialogs::key_list;
use crate::ui::dialogs::palette::{self, Palette};
use crate::view::typesetting::theme::{self, Look};
use pinhole_exchange::document::Document;

/// What lies over the window until it is closed.
#[derive(Clone, Debug)]
pub(super) enum Sheet {
    /// The command palette.
    Palette(Palette),
    /// All keys.
    Keys,
}

/// Of more objects, the palette lists the first ones.
const LISTED_OBJECTS: usize = 200;

/// The zoom that can be set, and its step.
const ZOOM: (f32, f32, f32) = (0.5, 4.0, 0.1);

impl App {
    /// Whether something lies over the window, which takes mouse and keys.
    pub(super) fn is_covered(&self) -> bool {
        self.dialog.is_some() || self.sheet.is_some()
    }

    /// Changes how things are shown.
    pub(super) fn change_look(&mut self, ctx: &Context, action: LookAction) {
        let session = &mut self.session;
        let settings = &mut session.settings;
        match action {
            LookAction::Layout(layout) => settings.layout = layout,
            LookAction::Shade(shade) => settings.shade = shade,
            LookAction::Theme(theme) => settings.theme = theme,
            LookAction::Scheme(scheme) => settings.scheme = scheme,
            LookAction::Method(method) => settings.method = method,
            LookAction::Toggle(switch) => switch.toggle(session),
            LookAction::DigitsBy(by) => {
                let digits = settings.digits.saturating_add_signed(by as isize);
                settings.digits = digits.clamp(DIGITS.0, DIGITS.1);
            }
            LookAction::ZoomBy(by) => self.zoom_by(by),
            LookAction::Exercise(exercise) => {
                session.exercises.show(exercise, None);
                settings.layout = ViewLayout::Exercises;
            }
            LookAction::Mistake(chosen) => {
                session.mistakes_view = MistakesView { chosen, ..MistakesView::default() };
                settings.layout = ViewLayout::Mistakes;
            }
            LookAction::Present => self.present_or_end(),
            LookAction::Fill(full) => {
                let begun = Presenting::begin(session.spotlight);
                let presenting = session.presenting.get_or_insert(begun);
                presenting.fill(full, &mut settings.layout);
            }
        }
        ctx.request_discard("a command changed how things are shown");
    }

    pub(super) fn lay_over(&mut self, ctx: &Context, overlay: Overlay) {
        self.sheet = Some(match overlay {
            Overlay::Palette => Sheet::Palette(Palette::default()),
            Overlay::Keys => Sheet::Keys,
        });
        ctx.request_discard("something lies over the window");
    }

    fn zoom_by(&mut self, by: i32) {
        let settings = &mut self.session.settings;
        if self.session.presenting.is_some() {
            let next = settings.smallest_text + by as f32 * SMALLEST_TEXT.step;
            let next = if by == 0 { SMALLEST_TEXT.usual } else { next };
            settings.smallest_text = next.clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
        } else {
            let (least, most, step) = ZOOM;
            let next = ((settings.zoom / step).round() + by as f32) * step;
            settings.zoom = if by == 0 { 1.0 } else { next.clamp(least, most) };
        }
    }

    fn present_or_end(&mut self) {
        let session = &mut self.session;
        match session.presenting.take() {
            None => session.presenting = Some(Presenting::begin(session.spotlight)),
            Some(presenting) => {
                session.settings.layout = presenting.before(session.settings.layout);
                session.spotlight = presenting.spotlight_before();
            }
        }
    }

    /// The settings without what lessons and presenting have set.
    pub(super) fn settings_to_remember(&self) -> Settings {
        let mut session = self.session.clone();
        if let Some(presenting) = session.presenting {
            session.settings.layout = presenting.before(session.settings.layout);
        }
        self.lessons.settings_without(&session)
    }

    /// Gives the window the colours and sizes that are set.
    pub(super) fn follow_look(&mut self, ctx: &Context) {
        let settings = &self.session.settings;
        ctx.set_theme(match settings.theme {
            ThemeName::System => ThemePreference::System,
            ThemeName::Dark => ThemePreference::Dark,
            ThemeName::Light => ThemePreference::Light,
        });
        let presenting = self.session.presenting.is_some();
        theme::install(ctx, Look::of(settings, presenting));
        let zoom = if presenting {
            presenting::zoom(window_size(ctx), settings.smallest_text)
        } else {
            settings.zoom
        };
        // Reckoned from points, which are rounded, it would never rest.
        if (ctx.zoom_factor() / zoom - 1.0).abs() > 0.004 {
            ctx.set_zoom_factor(zoom);
            ctx.request_repaint();
        }
    }

    /// Shows what lies over the window; what was chosen in it goes into `actions`.
    pub(super) fn sheets(&mut self, ctx: &Context, actions: &mut Vec<Action>) {
        let is_open = match self.sheet.take() {
            None => return,
            Some(Sheet::Keys) => {
                self.sheet = Some(Sheet::Keys);
                key_list::ui(ctx)
            }
            Some(Sheet::Palette(mut palette)) => {
                let extra = self.commands_of_what_is_open();
                let commands = commands_table::all().iter().chain(&extra);
                let there = self.available();
                let commands: Vec<&UiCommand> =
                    commands.filter(|verb| verb.action.is_possible(there)).collect();
                let is_open = palette::ui(ctx, &mut palette, &commands, &self.session, actions);
                self.sheet = Some(Sheet::Palette(palette));
                is_open
            }
        };
        if !is_open {
            self.sheet = None;
        }
    }

    /// Commands for the steps of a lesson from a file, recent files and the scene's objects.
    fn commands_of_what_is_open(&self) -> Vec<UiCommand> {
        let open = self.lessons.open.as_ref();
        let own = open.filter(|open| open.place().lesson == Which::File);
        let mut commands =
            own.map_or_else(Vec::new, |own| commands_table::of_lesson(Which::File, own.lesson()));
        commands.extend(self.recent.iter().map(|path| recent(path)));
        let document = &self.open.document;
        let count = document.object_count().min(LISTED_OBJECTS);
        commands.extend((0..count).map(|index| object(document, index)));
        commands
    }

    /// What there is for commands to be done to.
    pub(super) fn available(&self) -> Available {
        Available {
            undo: self.changes.undo_name().is_some(),
            redo: self.changes.redo_name().is_some(),
            lesson: self.lessons.open.is_some(),
            animation: self.player.is_some(),
            ghost: self.session.ghost.is_some(),
            answers: self.session.answers.is_some(),
        }
    }

    /// The ring round what has the focus, and the spotlight.
    pub(super) fn over_all(&mut self, ui: &Ui) {
        let (pressed, moved) = ui.input(|i| {
            let moves = [egui::Key::Tab, egui::Key::ArrowDown, egui::Key::ArrowUp];
            (i.pointer.any_pressed(), moves.iter().any(|key| i.key_pressed(*key)))
        });
        self.by_keyboard = (self.by_keyboard || moved) && !pressed;
        if self.by_keyboard {
            theme::focus_ring(ui);
        }
        if self.session.spotlight {
            theme::spotlight(ui.ctx());
        }
    }
}

/// An object to choose.
fn object(document: &Document, index: usize) -> UiCommand {
    UiCommand {
        group: Group::Objects,
        name: format!("choose {}", document.title_of(index)).into(),
        about: "Shows its fields, and its handles in the world view.".into(),
        keys: &[],
        action: ObjectAction::Choose(index).into(),
    }
}

/// A file that was opened lately.
fn recent(path: &std::path::Path) -> UiCommand {
    use pinhole_exchange::scenes::SceneSource;
    UiCommand {
        group: Group::File,
        name: format!("open {}", path.display()).into(),
        about: "Opens it again.".into(),
        keys: &[],
        action: Leave::Open(SceneSource::File(path.to_owned())).into(),
    }
}

/// The window's size in points without zoom.
fn window_size(ctx: &Context) -> [f32; 2] {
    let size = ctx.content_rect().size() * ctx.zoom_factor();
    // A window that is only in memory does not know its size in pixels: its points do not change.
    let is_real = ctx.input(|input| input.viewport().inner_rect.is_some());
    if is_real { size.into() } else { [0.0; 2] }
}
