//! Putting what was derived on the screen: the views, and what the layout has beside them.

use egui::{Rect, Ui, UiBuilder};

use super::App;
use crate::model::fault::Fault;
use crate::model::letters::typeset_message;
use crate::model::session::{Session, ViewLayout};
use crate::ui::action::Observe;
use crate::ui::practice::{answers, exercises, mistakes};
use crate::ui::ray::{lines, plot};
use crate::ui::scene::places::Places;
use crate::ui::scene::readouts::NumberStyle;
use crate::ui::scene::{compare, framing, readouts, views};
use crate::ui::tools::{accuracy, frame};

impl App {
    pub(super) fn outputs(&mut self, ui: &mut Ui, places: &Places) {
        self.views(ui, places);
        ui.scope_builder(UiBuilder::new().max_rect(places.rest), |ui| {
            ui.set_clip_rect(places.rest);
            self.beside_views(ui);
        });
    }

    /// The pictures with what is written on them.
    fn views(&mut self, ui: &mut Ui, places: &Places) {
        let image = self.open.document.camera.image;
        if self.session.presenting.is_none() {
            views::strips(ui, places, &mut self.session.settings, image);
        }
        let dimmed = self.derived.fault.is_some();
        if let (Some(rect), Some(shown)) = (places.world, &self.derived.world_view) {
            let stale = matches!(self.derived.fault, Some(Fault::Scene(_)));
            views::show(ui, rect, shown, &mut self.world_texture, stale);
            views::speak(ui, views::WORLD, &views::spoken(&self.derived));
        }
        if let (Some(rect), Some(shown)) = (places.camera, &self.derived.camera_view) {
            views::show(ui, rect, shown, &mut self.camera_texture, dimmed);
            views::speak(ui, views::CAMERA, &views::spoken(&self.derived));
        }
        // One of them speaks at a time.
        let is_steered = self.navigation.has_word(ui.input(|i| i.time));
        if self.session.hand.over.is_none() && !is_steered {
            views::tell_pointed(ui, self.session.hovered, &self.open.document);
        }
        if let (Some(area), Some(rect)) = (places.beside_area, places.beside) {
            match self.session.settings.layout {
                ViewLayout::Mistakes => self.wrong_camera(ui, area, rect, dimmed),
                ViewLayout::Compare => self.ghost(ui, area, rect),
                ViewLayout::Answers => self.answers_map(ui, area, rect),
                _ => self.error_map(ui, area, rect, dimmed),
            }
        }
        let mark = accuracy::drawn_by(&self.derived, self.session.settings.method.0);
        if let (Some(rect), Some(text)) = (places.camera.or(places.world), mark) {
            views::drawn_by(ui, rect, &text);
        }
        if let (Some(rect), Some(fault)) = (places.camera.or(places.world), self.derived.fault) {
            views::reason(ui, rect, &typeset_message(fault));
        }
        let subsampling = self.derived.subsampling;
        for (place, subsampling) in [places.camera, places.world].into_iter().zip(subsampling) {
            if let (Some(rect), Some(text)) = (place, subsampling.message()) {
                views::coarse(ui, rect, &text);
            }
        }
        self.tell_hand(ui, places);
        let framing = places.world.filter(|rect| {
            framing::hint(ui, *rect, &self.derived, &self.open.document, &self.session)
        });
        if framing.is_some() {
            self.waiting.push(Observe::FrameCamera.into());
            ui.ctx().request_repaint();
        }
    }

    /// What the layout has beside the views, or below them.
    fn beside_views(&mut self, ui: &mut Ui) {
        let highlighted = self.session.highlighted();
        let settings = &self.session.settings;
        let style = NumberStyle {
            digits: settings.digits,
            count_from_one: settings.count_from_one,
            exact: false,
        };
        let document = &self.open.document;
        match settings.layout {
            ViewLayout::Accuracy => {
                accuracy::ui(ui, &self.measuring, &self.derived, document, &mut self.session);
            }
            ViewLayout::Frame => frame::ui(ui, &self.derived),
            ViewLayout::Lines => lines::ui(ui, &mut self.session.lines, style.digits),
            ViewLayout::Plot => {
                plot::ui(ui, &mut self.session, &self.derived, style.digits);
            }
            ViewLayout::Derivation | ViewLayout::DerivationAlone => {
                let Session { sections, hovered, .. } = &mut self.session;
                if let Some(derivation) = &self.derived.derivation {
                    self.derivation.ui(ui, derivation, sections, *hovered, highlighted);
                }
            }
            ViewLayout::Mistakes => {
                mistakes::ui(ui, &self.derived, document, &mut self.session, style);
            }
            ViewLayout::Compare => {
                let (ghost, actions) = (self.session.ghost.as_ref(), &mut self.waiting);
                compare::ui(ui, &self.derived, document, ghost, style, actions);
            }
            ViewLayout::Translator => {
                self.translator.ui(ui, document, &mut self.session, &mut self.waiting);
            }
            ViewLayout::Answers => {
                answers::ui(ui, &self.derived, &mut self.session, &mut self.waiting);
            }
            ViewLayout::Exercises => {
                let exercises = &mut self.session.exercises;
                exercises::ui(ui, exercises, style, &mut self.waiting);
            }
            _ if self.session.presenting.is_some() => (),
            _ => readouts::ui(ui, &self.derived, document, style),
        }
    }

    /// Beside the right picture, where another method errs in it.
    fn error_map(&mut self, ui: &mut Ui, area: Rect, rect: Rect, dimmed: bool) {
        accuracy::strip(ui, area, &mut self.session.settings);
        if let (Some(shown), Some(compared)) = (&self.derived.error_map, &self.derived.compared) {
            views::show(ui, rect, shown, &mut self.beside_texture, dimmed);
            views::speak(ui, views::MAP, &accuracy::summary(compared));
            accuracy::legend(ui, area, compared);
        } else if let Some(why) = self.derived.too_many {
            accuracy::no_map(ui, rect, why);
        }
    }

    /// Beside the camera's picture, what the ghost sees.
    fn ghost(&mut self, ui: &mut Ui, area: Rect, rect: Rect) {
        compare::strip(ui, area, &mut self.session.ghost);
        let spoken = compare::spoken(self.derived.against_ghost.as_deref());
        views::speak(ui, views::GHOST, &spoken);
        match &self.derived.ghost_view {
            Some(shown) => views::show(ui, rect, shown, &mut self.beside_texture, false),
            None => compare::no_picture(ui, rect, self.session.ghost.as_ref()),
        }
    }

    /// Beside the camera's picture, where a student's answers are wrong.
    fn answers_map(&mut self, ui: &mut Ui, area: Rect, rect: Rect) {
        let has_map = self.derived.answers_view.is_some();
        answers::strip(ui, area, self.session.answers.as_ref(), has_map);
        views::speak(ui, views::ANSWERS, &answers::spoken(&self.derived, &self.session));
        match &self.derived.answers_view {
            Some(shown) => views::show(ui, rect, shown, &mut self.beside_texture, false),
            None => answers::no_map(ui, rect, &self.derived, &self.session),
        }
    }

    /// Beside the right picture, what a wrong camera sees.
    fn wrong_camera(&mut self, ui: &mut Ui, area: Rect, rect: Rect, dimmed: bool) {
        mistakes::strip(ui, area, &self.session.mistakes_view);
        let Some(wrong) = &self.derived.wrong else { return };
        views::speak(ui, views::WRONG, &mistakes::spoken(wrong, &self.session.mistakes_view));
        match &self.derived.wrong_view {
            Some(shown) => views::show(ui, rect, shown, &mut self.beside_texture, dimmed),
            None => mistakes::no_picture(ui, rect, wrong, &self.session.mistakes_view),
        }
    }
}
