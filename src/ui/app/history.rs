//! Undo and redo: when a change of the document becomes a step, and going back and forth.

use egui::{Context, Id};

use super::App;
use super::lessons::Lessons;
use crate::model::files::{OpenDocument, title_of};
use crate::model::hand::Hand;
use crate::model::history::{History, StepName, name_of};
use crate::model::session::{Selection, Session, Settings};
use crate::view::derive::Deriver;
use pinhole_exchange::document::Document;

/// Seconds within which more of the same change goes on with a step, where no button is held.
const PAUSE: f64 = 1.0;

/// The steps so far, and what the next one is told from.
#[derive(Debug)]
pub(super) struct Changes {
    history: History<Moment>,
    /// The document when the hand last rested.
    settled: Document,
    /// What the last step was, to tell whether the next change goes on with it.
    last: Option<Last>,
}

/// How it was at a step's beginning, or end.
#[derive(Clone, Debug)]
enum Moment {
    /// The scene is the same one.
    Edited(Box<Document>),
    /// Another scene or lesson's step, and how it was looked at.
    Elsewhere(Box<Whereabouts>),
}

/// The open scene or lesson's step, with everything that it is looked at with.
#[derive(Clone, Debug)]
pub(super) struct Whereabouts {
    open: OpenDocument,
    lessons: Lessons,
    session: Session,
    chosen_object: usize,
}

#[derive(Debug)]
struct Last {
    name: String,
    focus: Option<Id>,
    time: f64,
}

impl Changes {
    pub(super) fn of(document: &Document) -> Changes {
        Changes { history: History::default(), settled: document.clone(), last: None }
    }

    /// The document after the last step.
    pub(super) fn settled(&self) -> &Document {
        &self.settled
    }

    /// What *Undo* would undo.
    pub(super) fn undo_name(&self) -> Option<&str> {
        self.history.undo_name()
    }

    /// What *Redo* would do again.
    pub(super) fn redo_name(&self) -> Option<&str> {
        self.history.redo_name()
    }
}

impl App {
    /// Whether the document is not being changed at this moment: no button is held, nothing plays.
    fn hand_rests(&self, ctx: &Context) -> bool {
        !self.plays_camera() && ctx.input(|i| !i.pointer.any_down())
    }

    /// A change of the document becomes a step of the history as soon as the hand rests: a drag is
    /// one step.
    pub(super) fn keep_history(&mut self, ctx: &Context) {
        if self.open.document != self.changes.settled && self.hand_rests(ctx) {
            self.settle(ctx);
        }
    }

    /// What has changed since the hand last rested is a step.
    pub(super) fn settle(&mut self, ctx: &Context) {
        self.settle_as(ctx, None);
    }

    /// The same, with a name that the change itself does not tell.
    pub(super) fn settle_as(&mut self, ctx: &Context, name: Option<&str>) {
        let changes = &mut self.changes;
        if self.open.document == changes.settled {
            return;
        }
        let name = match name {
            Some(name) => StepName { text: name.to_owned(), gradual: false },
            None => name_of(&changes.settled, &self.open.document),
        };
        let focus = ctx.memory(|memory| memory.focused());
        let time = ctx.input(|i| i.time);
        let scrolls = ctx.input(|i| i.smooth_scroll_delta().y != 0.0 || i.zoom_delta() != 1.0);
        let goes_on = changes.last.as_ref().is_some_and(|last| {
            let same_place = last.focus == focus && (focus.is_some() || scrolls);
            name.gradual && name.text == last.name && same_place && time - last.time < PAUSE
        });
        let settled = std::mem::replace(&mut changes.settled, self.open.document.clone());
        if goes_on {
            changes.history.extend();
        } else {
            changes.history.record(name.text.clone(), Moment::Edited(Box::new(settled)));
        }
        changes.last = Some(Last { name: name.text, focus, time });
    }

    /// How everything is before another scene or step is shown; see [`App::went_elsewhere`].
    pub(super) fn whereabouts(&mut self, ctx: &Context) -> Whereabouts {
        self.settle(ctx);
        Whereabouts {
            open: self.open.clone(),
            lessons: self.lessons.clone(),
            session: self.session.clone(),
            chosen_object: self.chosen_object,
        }
    }

    /// Another scene or step is shown since `before`, or the same one from its beginning.
    pub(super) fn went_elsewhere(&mut self, before: Whereabouts) {
        if self.open.origin() == before.open.origin()
            && self.open.document == before.open.document
            && self.lessons.open == before.lessons.open
        {
            return;
        }
        let name = format!("show {}", title_of(self.open.origin()));
        self.changes.history.record(name, Moment::Elsewhere(Box::new(before)));
        self.changes.settled = self.open.document.clone();
        self.changes.last = None;
    }

    /// What has changed in the document until now is no step: it was written to disk, or it is what
    /// a lesson begins with.
    pub(super) fn settled(&mut self) {
        self.changes.settled = self.open.document.clone();
    }

    pub(super) fn undo(&mut self, ctx: &Context) {
        self.restore(ctx, |history, now| history.undo(now));
    }

    pub(super) fn redo(&mut self, ctx: &Context) {
        self.restore(ctx, |history, now| history.redo(now));
    }

    fn restore(
        &mut self,
        ctx: &Context,
        step: impl FnOnce(&mut History<Moment>, &mut dyn FnMut(&Moment) -> Moment) -> Option<Moment>,
    ) {
        let now = self.whereabouts(ctx);
        let mut here = |moment: &Moment| match moment {
            Moment::Edited(_) => Moment::Edited(Box::new(now.open.document.clone())),
            Moment::Elsewhere(_) => Moment::Elsewhere(Box::new(now.clone())),
        };
        match step(&mut self.changes.history, &mut here) {
            None => return,
            Some(Moment::Edited(document)) => self.edit_back(*document),
            Some(Moment::Elsewhere(whereabouts)) => self.go_back(*whereabouts),
        }
        self.changes.settled = self.open.document.clone();
        self.changes.last = None;
        ctx.request_discard("undone or redone");
    }

    /// The same scene with other numbers; the selected place goes along as when they are edited.
    fn edit_back(&mut self, document: Document) {
        let (old, new) = (self.open.document.camera, document.camera);
        let selection = self.session.selection.in_another_image(old.image, new.image);
        self.session.selection = match selection {
            Selection::Uv(_) if self.session.settings.keep_picture => {
                selection.in_another_viewport(old.viewport, new.viewport)
            }
            other => other,
        };
        self.open.document = document;
    }

    /// Another scene or step, looked at as it was then. What belongs to the window stays.
    fn go_back(&mut self, whereabouts: Whereabouts) {
        let Whereabouts { open, lessons, session, chosen_object } = whereabouts;
        let now = &self.session.settings;
        let settings = Settings {
            theme: now.theme,
            scheme: now.scheme,
            reduced_motion: now.reduced_motion,
            smallest_text: now.smallest_text,
            zoom: now.zoom,
            ..session.settings
        };
        let (presenting, spotlight) = (self.session.presenting, self.session.spotlight);
        self.open = open;
        self.lessons = lessons;
        let hand = Hand::default();
        self.session = Session { settings, presenting, spotlight, hand, ..session };
        self.chosen_object = chosen_object;
        // What was good in another scene is nothing to show in this one.
        self.deriver = Deriver::default();
    }
}
