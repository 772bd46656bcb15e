//! The scene of the open exercise, which the views show in place of the open scene.

use pinhole_core::Selection;
use pinhole_figure::Formulas;

use super::scene::OpenScene;
use crate::model::{Live, OpenDocument, OpenLesson, Session, Setup, Shown, ViewLayout};

impl OpenScene {
    /// Returns the lesson whose step asks the open exercise, be it with other numbers; `None` if no step does.
    pub(super) fn step_of_exercise(&self) -> Option<&OpenLesson> {
        let shown = self.session.exercises.question().exercise;
        let is_of_step = |open: &&OpenLesson| {
            let step = open.step();
            step.layout() == Some(ViewLayout::Exercises)
                && step.exercise.is_some_and(|own| own.exercise == shown)
        };
        self.lessons.open.as_ref().filter(is_of_step)
    }

    /// Returns the scene of the exercise on the stage, as seen in `before`, the last frame's; `None` if there is
    /// no exercise on the stage, or if it has no camera.
    pub(super) fn question(&self, before: Option<OpenScene>) -> Option<OpenScene> {
        let Session { shown: Shown { setup, .. }, exercises, preferences, .. } = &self.session;
        if !self.session.shows_exercise() {
            return None;
        }
        let (question, document) = (exercises.question(), exercises.document()?);
        // The observer of a lesson's step suits only the step's own numbers.
        let step = self.step_of_exercise().cloned().filter(|open| {
            let step = open.step();
            let last = open.id().step.checked_sub(1).and_then(|k| open.lesson().steps.get(k));
            let is_inherited = last.is_some_and(|last| last.shown.observer == step.shown.observer);
            step.exercise.is_some_and(|own| own.seed == exercises.seed()) && !is_inherited
        });
        let is_same =
            |scene: &OpenScene| scene.open.document == document && scene.lessons.open == step;
        let mut scene = before.filter(is_same).unwrap_or_else(|| {
            let open = OpenDocument::made_up(document.clone(), String::new());
            let mut scene = OpenScene::new(open, Session::default());
            scene.session.shown.observer =
                step.as_ref().and_then(|open| open.step().shown.observer);
            scene.lessons.open = step.clone();
            scene
        });
        let Session { shown: Shown { observer, .. }, live: Live { hovered, .. }, .. } =
            scene.session;
        let concepts = exercises.concepts().into_iter().map(|(_, concept)| concept);
        let pixel = question.pixel();
        let uv = || question.uv().map_or(Selection::default(), Selection::Uv);
        let shown = Shown {
            selection: pixel.map_or_else(uv, |(pixel, _)| Selection::Pixel(pixel)),
            observer,
            formulas: Some(Formulas::Solution(concepts.collect())),
            setup: Setup {
                items: exercises.items(setup.items),
                count_from_one: pixel.is_some_and(|(_, from_one)| from_one),
                ..*setup
            },
            // As in a lesson's step, everything that is drawn has its label.
            spoken: Some(Vec::new()),
            ..Shown::default()
        };
        scene.session = Session {
            shown,
            live: Live { hovered, ..Live::default() },
            presenting: self.session.presenting,
            preferences: *preferences,
            exercises: exercises.clone(),
            ..Session::default()
        };
        Some(scene)
    }
}
