//! Going through the lessons: the strip, its keys, and carrying out what they ask for.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Context, Panel, Ui};

use super::App;
use crate::model::files::{OpenDocument, Origin, argument_of};
use crate::model::lessons::{Lesson, OpenLesson, Place, Which, apply};
use crate::model::observer::Observer;
use crate::model::session::{Session, Settings};
use crate::ui::action::{Action, PlayAction};
use crate::ui::panels::lesson_strip;
use crate::view::derive::Deriver;

/// The lesson that is open, and what is needed to leave it without a trace.
#[derive(Clone, Debug, Default)]
pub(super) struct Lessons {
    pub(super) open: Option<OpenLesson>,
    /// The lesson that was opened from a file.
    file: Option<Arc<Lesson>>,
    /// Where the step was first looked at from, if it does not say so itself.
    seen_from: Option<Observer>,
    /// As it was before the first step.
    before: Option<Session>,
    /// The scene that was open before the first step, as the command line names it.
    scene_before: Option<PathBuf>,
}

impl Lessons {
    /// The world view was framed anew.
    pub(super) fn framed(&mut self, observer: Option<Observer>) {
        self.seen_from = self.seen_from.or(observer);
    }

    /// The settings without what lessons have set.
    pub(super) fn settings_without(&self, session: &Session) -> Settings {
        let mut session = session.clone();
        if let Some(before) = &self.before {
            apply::give_back(before, &mut session);
        }
        session.settings
    }

    pub(super) fn scene_before(&self) -> Option<PathBuf> {
        self.scene_before.clone()
    }

    /// The open lesson and its step, counted from 1, if it comes with the program.
    pub(super) fn remembered(&self) -> Option<(usize, usize)> {
        let place = self.open.as_ref()?.place();
        match place.lesson {
            Which::Builtin(index) => Some((index + 1, place.step + 1)),
            Which::File => None,
        }
    }
}

impl App {
    /// Shows a lesson from this step on; `file` is the lesson if it comes from a file. Nothing happens
    /// where there is no such step.
    pub fn open_lesson(&mut self, place: Place, file: Option<Arc<Lesson>>) {
        if file.is_some() {
            self.lessons.file = file;
        }
        let Some(next) = OpenLesson::at(place, self.lessons.file.as_ref()) else { return };
        let is_step = matches!(self.open.origin(), Origin::Step(_));
        let same_scene =
            is_step && self.lessons.open.as_ref().is_some_and(|now| now.shares_scene_with(&next));
        if !same_scene {
            // What was good in another scene is nothing to show in this one.
            self.deriver = Deriver::default();
            self.session.observer = None;
            self.chosen_object = 0;
        }
        self.lessons.before.get_or_insert_with(|| self.session.clone());
        if let Some(scene) = argument_of(self.open.origin()) {
            self.lessons.scene_before = Some(scene);
        }
        self.lessons.seen_from = None;
        let title = format!("{}, step {}", next.short_title(), place.step + 1);
        self.open = OpenDocument::of_step(next.step().document.clone(), title);
        apply::apply(next.step(), None, &mut self.open.document, &mut self.session);
        self.lessons.seen_from = self.session.observer;
        // In the next pass, which knows what the step's ray hits.
        let play = next.step().looks.play;
        self.waiting.extend(play.map(|kind| PlayAction::Open(kind).into()));
        self.lessons.open = Some(next);
        self.settled();
    }

    /// The lesson that is open.
    pub fn lesson(&self) -> Option<&OpenLesson> {
        self.lessons.open.as_ref()
    }

    pub(super) fn go_to(&mut self, ctx: &Context, place: Place) {
        self.session.ghost = None;
        self.open_lesson(place, None);
        ctx.request_discard("another step of a lesson");
    }

    /// Everything as the open step says, where anything is not.
    pub(super) fn back_to_step(&mut self, ctx: &Context) {
        if let (Some(open), true) = (self.lessons.open.clone(), self.differs_from_step()) {
            let seen_from = self.lessons.seen_from;
            apply::clear_answers(open.step(), &mut self.session);
            self.open_lesson(open.place(), None);
            self.session.observer = open.step().looks.observer.or(seen_from);
            self.lessons.seen_from = seen_from;
            ctx.request_discard("back to the step");
        }
    }

    /// Closes the strip; the step's scene stays, and counts as a scene like any other.
    pub(super) fn close_lesson(&mut self, ctx: &Context) {
        self.lessons.open = None;
        if let Some(before) = self.lessons.before.take() {
            apply::give_back(&before, &mut self.session);
        }
        self.open.leave_lesson();
        ctx.request_discard("the lesson is closed");
    }

    /// Whether anything was changed since the step of the open lesson was set.
    pub(super) fn differs_from_step(&self) -> bool {
        self.lessons.open.as_ref().is_some_and(|open| {
            let seen_from = self.lessons.seen_from;
            apply::differs(open.step(), seen_from, &self.open.document, &self.session)
        })
    }

    pub(super) fn lesson_strip(&self, ui: &mut Ui, actions: &mut Vec<Action>) {
        let Some(open) = &self.lessons.open else { return };
        Panel::top("lesson").show(ui, |ui| {
            let file = self.lessons.file.as_deref();
            if self.session.presenting.is_some() {
                lesson_strip::slim(ui, open);
            } else {
                lesson_strip::ui(ui, open, file, self.differs_from_step(), actions);
            }
        });
    }
}
