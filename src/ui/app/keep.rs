//! Keeps what is shown: the observer in the scene, which opens with it, and the whole view as a step of a
//! lesson's file.

use std::path::Path;

use pinhole_exchange::host::host;
use pinhole_exchange::limits;

use super::App;
use super::scene::OpenScene;
use crate::model::lessons::{Lesson, with_step};

/// Why the view of an exercise is not kept.
const OF_EXERCISE: &str = "An exercise has a scene of its own: close it first.";

impl App {
    /// Keeps the observer in the scene, if that is possible.
    pub(super) fn keep_view(&mut self) {
        if self.question.is_some() {
            return self.tell("This view was not kept", OF_EXERCISE);
        }
        let Some(observer) = self.scene.session.shown.observer else { return };
        self.scene.open.document.observer = Some(observer.stored());
        self.say("The scene opens with this view once it is saved".to_owned(), Vec::new());
    }

    /// Adds what is shown to a lesson file, as its last step.
    pub(super) fn save_step(&mut self, path: &Path) {
        let lesson = self.write_step(path);
        let count = lesson.as_ref().map_or(0, |lesson| lesson.steps.len());
        let ghost = self.scene.session.shown.ghost.map_or("", |_| ", without the ghost,");
        let verb = format!("Saved step {count}{ghost} to");
        let written = lesson.map(|lesson| {
            self.scene.lessons.is_longer(lesson);
            self.window.remember(path);
            Vec::new()
        });
        self.say_written(written, &verb, path, "This view was not saved");
    }

    fn write_step(&self, path: &Path) -> Result<Lesson, String> {
        let OpenScene { open, session, .. } = &self.scene;
        if self.question.is_some() {
            return Err(OF_EXERCISE.to_owned());
        }
        open.check_output(path)?;
        let text = host().stamp(path).map(|_| limits::read_text(path)).transpose();
        let text = text.map_err(|error| error.to_string())?;
        let (text, lesson) = with_step(text.as_deref(), path, open, &session.shown)?;
        host().write(path, text.as_bytes()).map_err(|error| error.to_string())?;
        Ok(lesson)
    }
}
