//! Figures: what can be exported of what is on the screen, and writing it.

use std::io::Write as _;
use std::path::Path;

use egui::{ColorImage, Context};
use pinhole_exchange::atomic;

use super::scene::OpenScene;
use crate::figures::{Content, Figure, MARGIN, Order, Subject, derivation_of};
use crate::model::play::Kind;
use crate::model::session::Session;
use crate::ui::derivation::DerivationPanel;
use crate::ui::dialogs::dialog::Dialog;
use crate::ui::dialogs::export::{ExportForm, OnScreen};
use crate::ui::ray::lines;
use crate::ui::workspaces::page;
use crate::view::derive::Derived;
use crate::view::overlay::Style;

/// The larger side of a view that is not on the screen, and the size of what else is not, in points.
const VIEW: f32 = 960.0;
const DERIVATION: [f32; 2] = [800.0, 600.0];
const LINES: [f32; 2] = [800.0, 640.0];

/// The screen as it was derived last.
pub(super) struct Screen<'a> {
    pub(super) ctx: &'a Context,
    pub(super) scene: &'a OpenScene,
    pub(super) derived: &'a Derived,
    pub(super) derivation: &'a DerivationPanel,
}

impl Screen<'_> {
    /// The dialog with what the layout is about chosen.
    pub(super) fn ask_export(&self) -> Dialog {
        let first = self.layout_subject();
        let mut subjects = Subject::ALL.map(|subject| self.on_screen(subject)).to_vec();
        subjects.sort_by_key(|shown| shown.subject != first);
        Dialog::Export(ExportForm::new(self.scene.open.file(), subjects, self.style()))
    }

    /// The subject of the layout.
    fn layout_subject(&self) -> Subject {
        page(self.scene.session.settings.layout).figure
    }

    fn style(&self) -> Style {
        Style::new(self.scene.session.settings.scheme, self.is_dark())
    }

    /// Puts a figure of what the layout is about on the clipboard, as large as it is on the screen; what
    /// there is to tell if that fails.
    pub(super) fn copy(&self) -> Option<Dialog> {
        let shown = self.on_screen(self.layout_subject());
        let order = shown.order(shown.dots(), self.style(), false);
        match self.figure(&order) {
            Ok(figure) => {
                self.ctx.copy_image(ColorImage::new(figure.size(), figure.to_pixels()));
                None
            }
            Err(problem) => Some(Dialog::message("The figure was not copied", problem)),
        }
    }

    fn figure(&self, order: &Order) -> Result<Figure, String> {
        let is_folded = |section: &_| self.derivation.is_folded(section);
        order.figure(&self.scene.open.document, &self.session(), is_folded)
    }

    /// The session without what the mouse is at, which is nothing to keep.
    fn session(&self) -> Session {
        Session { hovered: None, ..self.scene.session.clone() }
    }

    /// The dialog of an animation, with the world view chosen.
    pub(super) fn ask_export_animation(&self, kind: Kind) -> Dialog {
        let subjects = [Subject::World, Subject::Camera].map(|subject| self.on_screen(subject));
        let style = if self.is_dark() { Style::Dark } else { Style::Light };
        let form = ExportForm::new(self.scene.open.file(), subjects.to_vec(), style);
        Dialog::Export(form.animated(kind))
    }

    fn is_dark(&self) -> bool {
        self.ctx.theme() == egui::Theme::Dark
    }

    fn on_screen(&self, subject: Subject) -> OnScreen {
        let scale = self.ctx.pixels_per_point();
        let view = match subject {
            Subject::World => &self.derived.world_view,
            _ => &self.derived.camera_view,
        };
        let seen = view.as_ref().map(|shown| shown.image.size.map(|dots| dots as f32 / scale));
        let aspect = self.scene.open.document.camera.image.aspect() as f32;
        let points = match subject {
            Subject::World => seen.unwrap_or([VIEW, VIEW * 9.0 / 16.0]),
            Subject::Camera => seen.unwrap_or([VIEW * aspect.min(1.0), VIEW / aspect.max(1.0)]),
            Subject::Derivation => {
                let page = |width| [width + 2.0 * MARGIN, DERIVATION[1]];
                self.derivation.width().map_or(DERIVATION, page)
            }
            Subject::Lines => lines::size(self.ctx).unwrap_or(LINES),
        };
        OnScreen { subject, points, scale }
    }

    /// Writes a figure of it; what there is to tell if that fails.
    pub(super) fn export(&self, order: &Order, path: &Path) -> Option<Dialog> {
        let exported = self.exported(order, path);
        exported.err().map(|problem| Dialog::message("The figure was not exported", problem))
    }

    fn exported(&self, order: &Order, path: &Path) -> Result<(), String> {
        self.scene.open.check_output(path)?;
        let bytes = match Content::for_path(order.subject, path)? {
            Content::Text(markup) => {
                let document = &self.scene.open.document;
                derivation_of(document, &self.session()).written_in(markup).into_bytes()
            }
            Content::Figure(format) => self.figure(order)?.to_file(format)?,
        };
        atomic::write(path, |file| file.write_all(&bytes)).map_err(|error| error.to_string())
    }
}
