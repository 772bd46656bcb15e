//! Figures: what can be exported of what is on the screen, and writing it.

use std::io::Write as _;
use std::path::Path;

use egui::Context;

use super::App;
use crate::figures::{Content, MARGIN, Order, Subject, derivation_of};
use crate::model::session::{Session, ViewLayout};
use crate::ui::action::FigureAction;
use crate::ui::dialogs::dialog::Dialog;
use crate::ui::dialogs::export::{ExportForm, OnScreen};
use crate::ui::ray::lines;
use crate::view::overlay::Style;
use pinhole_exchange::atomic;

/// The larger side of a view that is not on the screen, and the size of what else is not, in points.
const VIEW: f32 = 960.0;
const DERIVATION: [f32; 2] = [800.0, 600.0];
const LINES: [f32; 2] = [800.0, 640.0];

impl App {
    pub(super) fn figure(&mut self, ctx: &Context, action: FigureAction) {
        match action {
            FigureAction::Ask => self.ask_export(ctx),
            FigureAction::Export { order, path } => self.export(&order, &path),
            FigureAction::AskAnimation => self.ask_export_animation(ctx),
            FigureAction::ExportAnimation { order, frames, path } => {
                self.export_animation(order, frames, path);
            }
            FigureAction::CopyDerivation(markup) => {
                let derivation = derivation_of(&self.open.document, &self.session);
                ctx.copy_text(derivation.written_in(markup));
            }
        }
    }

    /// Opens the dialog, with what the layout is about chosen.
    fn ask_export(&mut self, ctx: &Context) {
        let first = match self.session.settings.layout {
            ViewLayout::Camera
            | ViewLayout::Accuracy
            | ViewLayout::Mistakes
            | ViewLayout::Answers => Subject::Camera,
            ViewLayout::Derivation | ViewLayout::DerivationAlone => Subject::Derivation,
            ViewLayout::Lines => Subject::Lines,
            _ => Subject::World,
        };
        let mut subjects = Subject::ALL.map(|subject| self.on_screen(ctx, subject)).to_vec();
        subjects.sort_by_key(|shown| shown.subject != first);
        let dark = ctx.theme() == egui::Theme::Dark;
        let style = Style::of(self.session.settings.scheme, dark);
        self.dialog = Some(Dialog::Export(ExportForm::new(self.open.file(), subjects, style)));
    }

    pub(super) fn on_screen(&self, ctx: &Context, subject: Subject) -> OnScreen {
        let scale = ctx.pixels_per_point();
        let view = match subject {
            Subject::World => &self.derived.world_view,
            _ => &self.derived.camera_view,
        };
        let seen = view.as_ref().map(|shown| shown.image.size.map(|dots| dots as f32 / scale));
        let image = self.open.document.camera.image;
        let aspect = image.aspect() as f32;
        let points = match subject {
            Subject::World => seen.unwrap_or([VIEW, VIEW * 9.0 / 16.0]),
            Subject::Camera => seen.unwrap_or([VIEW * aspect.min(1.0), VIEW / aspect.max(1.0)]),
            Subject::Derivation => {
                let page = |width| [width + 2.0 * MARGIN, DERIVATION[1]];
                self.derivation.width().map_or(DERIVATION, page)
            }
            Subject::Lines => lines::size(ctx).unwrap_or(LINES),
        };
        OnScreen { subject, points, scale }
    }

    /// Writes a figure of what is on the screen.
    fn export(&mut self, order: &Order, path: &Path) {
        // What the mouse was at is nothing to keep.
        let session = Session { hovered: None, ..self.session.clone() };
        if let Err(problem) = self.exported(order, path, &session) {
            self.tell("The figure was not exported", problem);
        }
    }

    fn exported(&self, order: &Order, path: &Path, session: &Session) -> Result<(), String> {
        let document = &self.open.document;
        let bytes = match Content::for_path(order.subject, path)? {
            Content::Text(markup) => {
                derivation_of(document, session).written_in(markup).into_bytes()
            }
            Content::Figure(format) => {
                let is_folded = |section: &_| self.derivation.is_folded(section);
                order.figure(document, session, is_folded)?.to_file(format)?
            }
        };
        atomic::write(path, |file| file.write_all(&bytes)).map_err(|error| error.to_string())
    }
}
