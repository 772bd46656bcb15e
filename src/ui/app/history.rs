//! Undo and redo: records changes of the document as undo steps, and moves back and forth between them.

use std::collections::BTreeMap;
use std::sync::Arc;

use egui::{Context, Id};
use pinhole_exchange::document::Document;
use pinhole_exchange::limits;

use super::App;
use super::scene::{OpenScene, Opened};
use crate::model::files::title_of;
use crate::model::history::{History, StepName, name_of};

/// Maximum time, in seconds, after which another change of the same kind, made without a mouse button (such
/// as by scrolling), still extends the last undo step.
const PAUSE: f64 = 1.0;

/// The undo steps, and the document as it was after the last of them. The next step is what has changed
/// since.
#[derive(Debug)]
pub(super) struct SceneHistory {
    pub(super) steps: History<Moment>,
    /// The document after the last step.
    pub(super) settled: Document,
    /// The focus and the time of the last step, which the next change may extend.
    last: Option<(Option<Id>, f64)>,
}

/// The state before or after a step.
#[derive(Clone, Debug)]
pub(super) enum Moment {
    /// The same scene was edited.
    Edited(Box<Document>),
    /// Another scene or lesson step was open, with its view.
    Elsewhere(Box<OpenScene>),
}

impl SceneHistory {
    pub(super) fn new(document: &Document) -> SceneHistory {
        SceneHistory { steps: History::default(), settled: document.clone(), last: None }
    }

    /// Records what has changed in the document since the last undo step, if anything, as a new step or as
    /// part of the last one. Without a `name`, the step is named after the changes.
    fn settle(&mut self, ctx: &Context, document: &Document, name: Option<&str>) {
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
        let goes_on = self.last.is_some_and(|(last_focus, then)| {
            let same_field = last_focus == focus && (focus.is_some() || scrolls);
            let same_name = self.steps.undo_name() == Some(&name.text);
            name.gradual && same_name && same_field && time - then < PAUSE
        });
        let settled = std::mem::replace(&mut self.settled, document.clone());
        if goes_on {
            self.steps.extend();
        } else {
            self.steps.record(name.text, Moment::Edited(Box::new(settled)));
        }
        self.last = Some((focus, time));
    }

    /// Records, as an undo step, that another scene or lesson step was opened, or that the open one was
    /// reset.
    pub(super) fn went_elsewhere(&mut self, before: OpenScene, now: &OpenScene) {
        if now.open.origin() == before.open.origin()
            && now.open.document == before.open.document
            && now.lessons.open == before.lessons.open
        {
            return;
        }
        let name = format!("show {}", title_of(now.open.origin()));
        self.steps.record(name, Moment::Elsewhere(Box::new(before)));
        self.forget_tables();
        self.take_as_settled(&now.open.document);
        self.last = None;
    }

    /// Drops the oldest steps until those that are left have no more spheres of tables in memory than one scene may.
    fn forget_tables(&mut self) {
        let mut tables = BTreeMap::new();
        self.steps.keep_newest(|moment| {
            let document = match moment {
                Moment::Edited(document) => document,
                Moment::Elsewhere(scene) => &scene.open.document,
            };
            let table = document.csv_spheres.as_ref();
            tables.extend(table.map(|csv| (Arc::as_ptr(&csv.items), csv.count)));
            tables.values().sum::<usize>() <= limits::ROWS
        });
    }

    /// Excludes the changes so far from the next undo step, because they were saved or belong to a lesson's
    /// step.
    pub(super) fn take_as_settled(&mut self, document: &Document) {
        self.settled = document.clone();
    }
}

impl App {
    /// Records what has changed in the document since the last undo step, if anything, as a new step or as
    /// part of the last one. Without a `name`, the step is named after the changes.
    pub(super) fn settle(&mut self, ctx: &Context, name: Option<&str>) {
        self.history.settle(ctx, &self.scene.open.document, name);
    }

    /// Undoes a step, or redoes one.
    pub(super) fn undo_or_redo(&mut self, ctx: &Context, is_redo: bool) {
        self.settle(ctx, None);
        let scene = &mut self.scene;
        let here = |moment: &Moment| match moment {
            Moment::Edited(_) => Moment::Edited(Box::new(scene.open.document.clone())),
            Moment::Elsewhere(_) => Moment::Elsewhere(Box::new(scene.clone())),
        };
        let moment = self.history.steps.step(is_redo, here);
        let is_another = matches!(moment, Some(Moment::Elsewhere(_)));
        match moment {
            None => return,
            Some(Moment::Edited(document)) => {
                scene.session.follow_camera(&scene.open.document.camera, &document.camera);
                scene.open.document = *document;
            }
            Some(Moment::Elsewhere(before)) => scene.go_back(*before),
        }
        self.history.take_as_settled(&scene.open.document);
        self.history.last = None;
        self.show_opened(Opened { is_another, play: None });
    }
}

#[cfg(test)]
mod tests {
    use pinhole_exchange::document::CsvSpheres;

    use super::*;
    use crate::model::{OpenDocument, Session};

    /// Paging through a lesson would fill the memory, a table for each step.
    #[test]
    fn undo_keeps_no_more_spheres_of_tables_than_a_scene_may_have() {
        let scene = |name: &str| {
            let csv = CsvSpheres {
                path: name.to_owned(),
                file: name.into(),
                stamp: None,
                count: limits::ROWS / 2,
                items: Arc::default(),
            };
            let document = Document { csv_spheres: Some(csv), ..Document::default() };
            let open = OpenDocument::made_up(document, name.to_owned());
            OpenScene::new(open, Session::default())
        };
        let steps = ["a", "b", "c", "d"].map(scene);
        let mut history = SceneHistory::new(&steps[0].open.document);
        for pair in steps.windows(2) {
            history.went_elsewhere(pair[0].clone(), &pair[1]);
        }
        let undone = std::iter::from_fn(|| history.steps.step(false, Clone::clone));
        assert_eq!(undone.count(), 2);
    }
}
