//! The way through the lessons.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Panel, Ui};

use super::scene::{OpenScene, Opened};
use crate::model::files::{OpenDocument, Origin, argument_of};
use crate::model::lessons::{Lesson, OpenLesson, StepId, Which, apply};
use crate::model::observer::Observer;
use crate::model::session::pen::Pen;
use crate::model::session::{Session, Settings};
use crate::ui::action::Action;
use crate::ui::panels::lesson_strip;

/// The lesson that is open, and what is needed to leave it without a trace.
#[derive(Clone, Debug, Default)]
pub(super) struct Lessons {
    pub(super) open: Option<OpenLesson>,
    /// The lesson that was opened from a file.
    file: Option<Arc<Lesson>>,
    /// The first observer of the step, if it does not name one itself.
    seen_from: Option<Observer>,
    /// The session before the first step.
    before: Option<Session>,
    /// The scene that was open before the first step, as the command line names it.
    pub(super) scene_before: Option<PathBuf>,
}

impl Lessons {
    /// Takes note that the world view was framed anew.
    pub(super) fn framed(&mut self, observer: Observer) {
        self.seen_from = self.seen_from.or(Some(observer));
    }

    /// The settings without what lessons have set.
    pub(super) fn settings_without(&self, session: &Session) -> Settings {
        let mut session = session.clone();
        if let Some(before) = &self.before {
            apply::restore(before, &mut session);
        }
        session.settings
    }

    /// The open lesson and its step, counted from 1, if it comes with the program.
    pub(super) fn remembered(&self) -> Option<(usize, usize)> {
        let id = self.open.as_ref()?.id();
        match id.lesson {
            Which::Builtin(index) => Some((index + 1, id.step + 1)),
            Which::File => None,
        }
    }
}

impl OpenScene {
    /// Shows a lesson from this step on; `file` is the lesson if it comes from a file. Nothing happens
    /// where there is no such step.
    pub(super) fn open_lesson(&mut self, id: StepId, file: Option<Arc<Lesson>>) -> Option<Opened> {
        let lessons = &mut self.lessons;
        lessons.file = file.or(lessons.file.take());
        let next = OpenLesson::at(id, lessons.file.as_ref())?;
        let is_step = matches!(self.open.origin(), Origin::Step(_));
        let same_scene =
            is_step && lessons.open.as_ref().is_some_and(|now| now.shares_scene_with(&next));
        if !same_scene {
            self.session.observer = None;
            self.chosen_object = None;
        }
        lessons.before.get_or_insert_with(|| self.session.clone());
        if let Some(scene) = argument_of(self.open.origin()) {
            lessons.scene_before = Some(scene);
        }
        let title = format!("{}, step {}", next.short_title(), id.step + 1);
        self.open = OpenDocument::of_step(next.step().document.clone(), title);
        apply::apply(next.step(), None, &mut self.open.document, &mut self.session);
        lessons.seen_from = self.session.observer;
        // What was drawn was about the step before.
        if let Some(pen) = &mut self.session.pen {
            *pen = Pen::default();
        }
        let play = next.step().view.play;
        lessons.open = Some(next);
        Some(Opened { is_another: !same_scene, play })
    }

    /// Shows another step.
    pub(super) fn go_to(&mut self, id: StepId) -> Opened {
        self.session.ghost = None;
        self.open_lesson(id, None).unwrap_or_default()
    }

    /// Shows the answer to the step's question.
    pub(super) fn answer(&mut self) {
        if let Some(open) = &self.lessons.open {
            apply::answer(open.step(), &mut self.session);
        }
    }

    /// Sets everything as the open step says, where anything is not.
    pub(super) fn back_to_step(&mut self) -> Opened {
        let (Some(open), true) = (self.lessons.open.clone(), self.differs_from_step()) else {
            return Opened::default();
        };
        let (seen_from, is_asking) = (self.lessons.seen_from, self.session.is_asking);
        apply::clear_answers(open.step(), &mut self.session);
        let opened = self.open_lesson(open.id(), None).unwrap_or_default();
        if !is_asking {
            self.answer();
        }
        self.session.observer = open.step().view.observer.or(seen_from);
        self.lessons.seen_from = seen_from;
        opened
    }

    /// Closes the strip; the step's scene stays, and counts as a scene like any other.
    pub(super) fn close_lesson(&mut self) {
        self.lessons.open = None;
        if let Some(before) = self.lessons.before.take() {
            apply::restore(&before, &mut self.session);
        }
        self.open.leave_lesson();
    }

    /// Returns true if anything was changed since the step of the open lesson was set.
    pub(super) fn differs_from_step(&self) -> bool {
        self.lessons.open.as_ref().is_some_and(|open| {
            let seen_from = self.lessons.seen_from;
            apply::differs(open.step(), seen_from, &self.open.document, &self.session)
        })
    }

    /// Shows the lesson's strip; `differs`: the window is not as the step says.
    pub(super) fn lesson_strip(&self, ui: &mut Ui, differs: bool, actions: &mut Vec<Action>) {
        let Some(open) = &self.lessons.open else { return };
        Panel::top("lesson").show(ui, |ui| {
            if self.session.presenting.is_some() {
                lesson_strip::slim(ui, open, self.session.is_asking);
            } else {
                let (file, is_asking) = (self.lessons.file.as_deref(), self.session.is_asking);
                lesson_strip::ui(ui, open, file, is_asking, differs, actions);
            }
        });
    }
}
