//! The look of the window: carrying out its commands, presenter mode among them, and giving the window
//! its colours and sizes.

use egui::{Context, ThemePreference};

use crate::model::practice::mistakes_view::MistakesView;
use crate::model::session::presenting::{self, Presenting, SMALLEST_TEXT};
use crate::model::session::{DIGITS, Session, ThemeName, ViewLayout, Workspace, ZOOM};
use crate::ui::action::LookAction;
use crate::view::typesetting::theme::{self, Look};

/// A step of the window's zoom.
const ZOOM_STEP: f32 = 0.1;

/// Changes how the scene is shown.
pub(super) fn apply(session: &mut Session, action: LookAction) {
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
        LookAction::ZoomBy(by) => zoom_by(session, by),
        LookAction::Exercise(exercise) => {
            session.exercises.show(exercise, None);
            settings.layout = ViewLayout::Exercises;
        }
        LookAction::Mistake(chosen) => {
            session.mistakes_view = MistakesView { chosen, ..MistakesView::default() };
            settings.layout = ViewLayout::Mistakes;
        }
        LookAction::Vote => {
            session.mistakes_view.wants_vote = true;
            settings.layout = ViewLayout::Mistakes;
        }
        LookAction::Present => present_or_end(session),
        LookAction::Fill(full) => {
            let begun = Presenting::begin(session.spotlight);
            let presenting = session.presenting.get_or_insert(begun);
            presenting.fill(full, &mut settings.layout);
        }
    }
}

fn zoom_by(session: &mut Session, by: i32) {
    let settings = &mut session.settings;
    if session.presenting.is_some() {
        let next = settings.smallest_text + by as f32 * SMALLEST_TEXT.step;
        let next = if by == 0 { SMALLEST_TEXT.usual } else { next };
        settings.smallest_text = next.clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
    } else {
        let next = ((settings.zoom / ZOOM_STEP).round() + by as f32) * ZOOM_STEP;
        settings.zoom = if by == 0 { 1.0 } else { next.clamp(ZOOM.0, ZOOM.1) };
    }
}

fn present_or_end(session: &mut Session) {
    match session.presenting.take() {
        None => {
            session.presenting = Some(Presenting::begin(session.spotlight));
            // What the open question is about is derived line by line.
            let derives = session.settings.layout.workspace() == Some(Workspace::Derivation);
            session.revealed_lines = (session.is_asking && derives).then_some(0);
        }
        Some(presenting) => {
            session.settings.layout = presenting.before(session.settings.layout);
            session.spotlight = presenting.spotlight_before();
            session.pen = None;
            session.revealed_lines = None;
        }
    }
}

/// Gives the window the colours and sizes that are set.
pub(super) fn follow(ctx: &Context, session: &Session) {
    let settings = &session.settings;
    ctx.set_theme(match settings.theme {
        ThemeName::System => ThemePreference::System,
        ThemeName::Dark => ThemePreference::Dark,
        ThemeName::Light => ThemePreference::Light,
    });
    let presenting = session.presenting.is_some();
    theme::install(ctx, Look::new(settings, presenting));
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

/// The window's size in points without zoom.
fn window_size(ctx: &Context) -> [f32; 2] {
    let size = ctx.content_rect().size() * ctx.zoom_factor();
    // A window that is only in memory does not know its size in pixels: its points do not change.
    let is_real = ctx.input(|input| input.viewport().inner_rect.is_some());
    if is_real { size.into() } else { [0.0; 2] }
}
