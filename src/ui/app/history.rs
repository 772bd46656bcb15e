//! Undo and redo: when a change of the document becomes a step, and going back and forth.

use egui::{Context, Id};
use pinhole_exchange::document::Document;

use super::scene::{OpenScene, Opened};
use crate::model::files::title_of;
use crate::model::history::{History, StepName, name_of};
use crate::ui::action::HistoryAction;

/// Seconds within which more of the same change goes on with a step, where no button is held.
const PAUSE: f64 = 1.0;

/// The steps so far, and what the next one is told from.
#[derive(Debug)]
pub(super) struct SceneHistory {
    pub(super) steps: History<Moment>,
    /// The document when the hand last rested.
    settled: Document,
    /// The last step, to tell whether the next change goes on with it.
    last: Option<Last>,
}

/// The state at a step's beginning, or end.
#[derive(Clone, Debug)]
pub(super) enum Moment {
    /// The scene is the same one.
    Edited(Box<Document>),
    /// Another scene or lesson's step, and how it was looked at.
    Elsewhere(Box<OpenScene>),
}

#[derive(Debug)]
struct Last {
    name: String,
    focus: Option<Id>,
    time: f64,
}

impl SceneHistory {
    pub(super) fn new(document: &Document) -> SceneHistory {
        SceneHistory { steps: History::default(), settled: document.clone(), last: None }
    }

    /// The document after the last step.
    pub(super) fn settled(&self) -> &Document {
        &self.settled
    }

    /// Makes a step of what has changed since the hand last rested.
    pub(super) fn settle(&mut self, ctx: &Context, document: &Document) {
        self.settle_as(ctx, document, None);
    }

    /// The same, with a name that the change itself does not tell.
    pub(super) fn settle_as(&mut self, ctx: &Context, document: &Document, name: Option<&str>) {
        if *document == self.settled {
            return;
        }
        let name = match name {
            Some(name) => StepName { text: name.to_owned(), gradual: false },
            None => name_of(&self.settled, document),
        };
        let focus = ctx.memory(|memory| memory.focused());
        let time = ctx.input(|i| i.time);
        let scrolls = ctx.input(|i| i.smooth_scroll_delta().y != 0.0 || i.zoom_delta() != 1.0);
        let goes_on = self.last.as_ref().is_some_and(|last| {
            let same_field = last.focus == focus && (focus.is_some() || scrolls);
            name.gradual && name.text == last.name && same_field && time - last.time < PAUSE
        });
        let settled = std::mem::replace(&mut self.settled, document.clone());
        if goes_on {
            self.steps.extend();
        } else {
            self.steps.record(name.text.clone(), Moment::Edited(Box::new(settled)));
        }
        self.last = Some(Last { name: name.text, focus, time });
    }

    /// Takes note of another scene or step that is shown since `before`, or the same one from its
    /// beginning.
    pub(super) fn went_elsewhere(&mut self, before: OpenScene, now: &OpenScene) {
        if now.open.origin() == before.open.origin()
            && now.open.document == before.open.document
            && now.lessons.open == before.lessons.open
        {
            return;
        }
        let name = format!("show {}", title_of(now.open.origin()));
        self.steps.record(name, Moment::Elsewhere(Box::new(before)));
        self.take_as_settled(&now.open.document);
        self.last = None;
    }

    /// Takes the changes until now for no step: they were written to disk, or a lesson begins with them.
    pub(super) fn take_as_settled(&mut self, document: &Document) {
        self.settled = document.clone();
    }

    /// Goes a step back, or forth again.
    pub(super) fn apply(
        &mut self,
        ctx: &Context,
        action: HistoryAction,
        scene: &mut OpenScene,
    ) -> Opened {
        self.settle(ctx, &scene.open.document);
        let here = |moment: &Moment| match moment {
            Moment::Edited(_) => Moment::Edited(Box::new(scene.open.document.clone())),
            Moment::Elsewhere(_) => Moment::Elsewhere(Box::new(scene.clone())),
        };
        let moment = match action {
            HistoryAction::Undo => self.steps.undo(here),
            HistoryAction::Redo => self.steps.redo(here),
        };
        let Some(moment) = moment else { return Opened::default() };
        let is_another = matches!(moment, Moment::Elsewhere(_));
        match moment {
            Moment::Edited(document) => scene.edit_back(*document),
            Moment::Elsewhere(before) => scene.go_back(*before),
        }
        self.take_as_settled(&scene.open.document);
        self.last = None;
        Opened { is_another, play: None }
    }
}
