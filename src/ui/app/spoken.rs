//! The window's contents in words, for a host that shows screen readers no widgets.

use std::sync::Arc;

use pinhole_figure::readings::{Reading, of_basis};
use pinhole_figure::typesetting::notation::without_marks;
use pinhole_figure::{Fault, Inspection};
use pinhole_lecture::exercises;

use crate::features::exercises::Exercises;
use crate::features::mistakes::{self, MistakesView};
use crate::features::vote::{self, OpenVote};
use crate::features::{answers, class};
use crate::model::files::title_of;
use crate::model::{Settings, ViewLayout, Workspace};
use crate::ui::app::App;
use crate::ui::dialogs::Dialog;
use crate::ui::scene::views;

/// What the contents in words depend on: the words without the numbers, and what the numbers are of.
#[derive(PartialEq)]
pub struct SpokenAbout {
    words: String,
    settings: Settings,
    fault: Option<Fault>,
    inspection: Option<Arc<Inspection>>,
}

impl App {
    /// Returns what [`spoken`](App::spoken) depends on.
    pub fn spoken_about(&self) -> SpokenAbout {
        let derived = &self.views.derived;
        SpokenAbout {
            // An object's name changes without the ray.
            words: self.words().join("\n") + &self.hit(),
            settings: self.scene.session.settings(),
            fault: derived.fault,
            inspection: derived.inspection.clone(),
        }
    }

    /// Returns the window's title, the open dialog, the last notice, the text of the lesson's step, and the
    /// contents of the page, a line each. While a question is open, nothing of the page is told, because it may
    /// answer the question.
    pub fn spoken(&self) -> String {
        let shown = &self.scene.session.shown;
        let mut lines = self.words();
        if !shown.is_asking && shown.setup.layout.workspace() != Some(Workspace::Practice) {
            self.numbers(&mut lines);
        }
        lines.join("\n")
    }

    /// Returns what is told but for the numbers of the selected ray.
    fn words(&self) -> Vec<String> {
        let (open, session) = (&self.scene.open, &self.scene.session);
        let mut lines = vec![title_of(open.origin())];
        lines.extend(self.over.dialog.as_ref().map(Dialog::spoken));
        if let Some(notice) = &session.translator.notice {
            lines.push(notice.title.clone());
            lines.extend(notice.notes.iter().cloned());
        }
        if let Some(step) = self.lesson().map(|lesson| lesson.step()) {
            lines.push(without_marks(&step.text));
            if let Some(question) = &step.question {
                let said = if session.shown.is_asking { &question.ask } else { &question.answer };
                lines.push(without_marks(said));
            }
            lines.extend(session.live.vote.iter().flat_map(options));
        }
        if !session.shown.is_asking {
            match session.shown.setup.layout {
                ViewLayout::Exercises => exercise(&session.exercises, &mut lines),
                ViewLayout::Mistakes => self.mistake(&session.shown.mistakes_view, &mut lines),
                ViewLayout::Answers => {
                    lines.push(answers::ui::spoken(&self.views.derived, session))
                }
                ViewLayout::Class => lines.extend(class::ui::spoken(&session.class.answers)),
                _ => {}
            }
        }
        lines
    }

    /// Returns what the selected ray hits.
    pub(super) fn hit(&self) -> String {
        let style = self.scene.session.shown.setup.number_style();
        views::spoken(&self.views.derived, &self.scene.open.document, style)
    }

    /// Tells the numbers of the selected ray and of its camera.
    fn numbers(&self, lines: &mut Vec<String>) {
        let derived = &self.views.derived;
        let style = self.scene.session.shown.setup.number_style();
        lines.push(self.hit());
        let line = |reading: &Reading| {
            format!("{} {}", without_marks(reading.long_name), style.equated_value(&reading.value))
        };
        if let Some(resolved) = &derived.resolved {
            lines.extend(of_basis(resolved, None).iter().map(line));
            let inspection = derived.inspection.iter();
            lines.extend(
                inspection.flat_map(|seen| seen.ray_readings(resolved.image())).map(|r| line(&r)),
            );
        }
    }

    /// Tells the comparison with a wrong camera, or the vote on it.
    fn mistake(&self, view: &MistakesView, lines: &mut Vec<String>) {
        if let Some(open) = &view.open_vote {
            lines.push(vote::ui::ASKED.to_owned());
            lines.extend(options(open));
        }
        let wrong = self.views.derived.wrong_camera.as_deref();
        lines.extend(wrong.map(|wrong| mistakes::ui::words(wrong, view, false).0));
    }
}

/// Tells the options of a vote.
fn options(open: &OpenVote) -> impl Iterator<Item = String> {
    (0..open.options.len()).map(|index| open.named(index))
}

/// Tells an exercise, what was typed and what was said about it.
fn exercise(open: &Exercises, lines: &mut Vec<String>) {
    let question = open.question();
    lines.push(question.exercise.title().to_owned());
    lines.extend(exercises::question(&question.given).iter().map(|text| without_marks(text)));
    for (part, typed) in question.parts.iter().zip(&open.answers) {
        let texts = typed.texts();
        let answer = Some(texts.join(", ")).filter(|_| texts.iter().any(|text| !text.is_empty()));
        let said = typed.feedback.as_ref().map(|said| said.sentence(part));
        let told: Vec<String> = answer.into_iter().chain(said).collect();
        lines.push(format!("{}: {}", part.asked.id(), told.join(". ")));
    }
}
