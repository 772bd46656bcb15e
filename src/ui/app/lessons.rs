//! Opening lessons, moving through their steps, and closing them.

use std::mem;
use std::path::PathBuf;
use std::sync::Arc;

use pinhole_exchange::host::host;
use pinhole_exchange::scene_file::with_table;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};
use pinhole_figure::derivation::Derivation;
use pinhole_figure::{Formulas, Observer};

use super::scene::{OpenScene, Opened};
use crate::features::lines;
use crate::features::vote::OpenVote;
use crate::model::files::{OpenDocument, Origin, argument_of};
use crate::model::lessons::{Lesson, OpenLesson, Step, StepId, Which, apply};
use crate::model::session::presenting::{Pen, PenStroke};
use crate::model::{Session, Shown, ViewLayout};
use crate::ui::OpenStep;
use crate::ui::dialogs::Question;
use crate::ui::stage::column;

/// The open lesson, and the state to restore when it closes.
#[derive(Clone, Debug, Default)]
pub(super) struct Lessons {
    pub(super) open: Option<OpenLesson>,
    /// The lesson that was opened from a file, or to which a step was saved.
    pub(super) file: Option<Arc<Lesson>>,
    /// The observer (the world view's camera) with which the step began, fitted to the world view.
    seen_from: Option<Observer>,
    /// What was shown before each time that more of the step was revealed: whether its question was open, and how many
    /// lines of the derivation there were.
    revealed: Vec<(bool, Option<usize>)>,
    /// The pen's strokes over other steps, which are there again when their step is.
    ink: Vec<(StepId, Vec<PenStroke>)>,
    /// The session before the first step.
    pub(super) before: Option<Session>,
    /// The command-line argument that opens the scene from before the first step.
    pub(super) scene_before: Option<PathBuf>,
}

impl Lessons {
    /// Replaces the stored observer with which the step began, after the world view was framed again. Does
    /// nothing if the user had moved the observer, so that `before`, the previous one, differs from the
    /// stored one.
    pub(super) fn framed(&mut self, before: Option<Observer>, observer: Observer) {
        if self.seen_from.is_none() || self.seen_from == before {
            self.seen_from = Some(observer);
        }
    }

    /// Replaces the lesson from a file by the same one with more steps or, unless it is open, by another one.
    pub(super) fn is_longer(&mut self, lesson: Lesson) {
        let own = self.open.as_ref().filter(|open| open.id().lesson == Which::File);
        let files = own.map(|open| open.lesson().file.as_ref().zip(lesson.file.as_ref()));
        if files.is_none_or(|files| files.is_some_and(|(a, b)| host().is_same_file(a, b))) {
            let file = self.file.insert(Arc::new(lesson));
            self.open = self.open.take().and_then(|open| OpenLesson::at(open.id(), Some(file)));
        }
    }

    /// Keeps the strokes over the open step, and takes up those over the step `to`.
    fn turn_ink(&mut self, strokes: &mut Vec<PenStroke>, to: StepId) {
        let before = mem::take(strokes);
        if let Some(from) = self.open.as_ref().map(OpenLesson::id) {
            self.ink.retain(|(step, _)| *step != from);
            self.ink.push((from, before));
        }
        if let Some(at) = self.ink.iter().position(|(step, _)| *step == to) {
            *strokes = self.ink.swap_remove(at).1;
        }
    }

    /// Takes over the ink of the lessons that were open before going back to these, with the strokes of the pen.
    pub(super) fn keep_ink(&mut self, mut before: Lessons, pen: Option<&mut Pen>) {
        if let (Some(pen), Some(open)) = (pen, &self.open) {
            before.turn_ink(&mut pen.strokes, open.id());
        }
        self.ink = before.ink;
    }

    /// Returns the open step for the column of the stage.
    pub(super) fn step(&self, is_changed: bool) -> Option<OpenStep<'_>> {
        let (open, file) = (self.open.as_ref()?, self.file.as_deref());
        Some(OpenStep { open, file, is_changed })
    }

    /// Returns the numbers of the open lesson and its step, counted from 1, if the lesson is built in.
    pub(super) fn remembered(&self) -> Option<(usize, usize)> {
        let id = self.open.as_ref()?.id();
        match id.lesson {
            Which::Builtin(index) => Some((index + 1, id.step + 1)),
            Which::File => None,
        }
    }
}

/// Returns true if a step in this layout is shown line by line while presenting.
fn comes_in_lines(layout: ViewLayout) -> bool {
    layout.reveals_lines() || layout == ViewLayout::Lines
}

impl OpenScene {
    /// Opens a lesson at this step, if it exists. `file` is the lesson, if it comes from a file.
    ///
    /// # Errors
    /// Returns a message if the table of the step's scene cannot be read any more; nothing is changed then.
    pub(super) fn open_lesson(
        &mut self,
        id: StepId,
        file: Option<Arc<Lesson>>,
    ) -> Result<Opened, Question> {
        let file = file.or(self.lessons.file.clone());
        let Some(next) = OpenLesson::at(id, file.as_ref()) else { return Ok(Opened::default()) };
        let document = with_table(&next.step().document, &self.open.document)
            .map_err(|error| Question::message("This step cannot be shown", error))?;
        self.lessons.file = file;
        self.lessons.before.get_or_insert_with(|| self.session.clone());
        self.session.shown.revealed_lines = self.lines_to_begin_with(next.step());
        let lessons = &mut self.lessons;
        lessons.revealed.clear();
        let is_step = matches!(self.open.origin(), Origin::Step(_));
        let same_scene =
            is_step && lessons.open.as_ref().is_some_and(|now| now.shares_scene_with(&next));
        if !same_scene {
            self.session.shown.observer = None;
            self.chosen_object = None;
        }
        if let Some(scene) = argument_of(self.open.origin()) {
            lessons.scene_before = Some(scene);
        }
        let title = format!("{}, step {}", next.short_title(), id.step + 1);
        self.open = OpenDocument::of_step(document, title);
        apply::apply(next.step(), &mut self.session);
        lessons.seen_from = self.session.shown.observer;
        if next.step().shown.observer.is_some() {
            self.framed = None;
        }
        // The vote was on the previous step's question.
        self.session.live.vote = None;
        if let Some(pen) = &mut self.session.live.pen {
            lessons.turn_ink(&mut pen.strokes, next.id());
        }
        let play = next.step().play;
        lessons.open = Some(next);
        Ok(Opened { is_another: !same_scene, play })
    }

    /// Shows what comes next in the step, as [`OpenScene::reveal_next`] does, and notes what was shown before.
    pub(super) fn reveal(&mut self, derivation: Option<&Derivation>) -> bool {
        let before = (self.session.shown.is_asking, self.session.shown.revealed_lines);
        let is_revealed = self.reveal_next(derivation);
        if is_revealed {
            self.lessons.revealed.push(before);
        }
        is_revealed
    }

    /// Takes back what was revealed last in this step. Returns false if nothing was.
    pub(super) fn take_back(&mut self) -> bool {
        if self.session.shows_exercise() && self.session.exercises.is_solved {
            self.session.exercises.toggle_solution();
            return true;
        }
        let Some((is_asking, revealed_lines)) = self.lessons.revealed.pop() else { return false };
        let shown = &mut self.session.shown;
        shown.revealed_lines = revealed_lines;
        if let (Some(open), true) = (&self.lessons.open, is_asking) {
            apply::ask(open.step(), shown);
        }
        true
    }

    /// Shows the answer to the step's question, and the lines of the derivation that lead to it. If no
    /// question is open, shows the next line of the derivation while presenting. Returns false if everything
    /// was already shown.
    fn reveal_next(&mut self, derivation: Option<&Derivation>) -> bool {
        let is_asking = self.session.shown.is_asking;
        if is_asking {
            self.answer();
        }
        let shown = &mut self.session.shown;
        let Some(count) = shown.revealed_lines else { return is_asking };
        let layout = shown.setup.layout;
        let (all, next) = match derivation {
            _ if layout == ViewLayout::Lines => (lines::view::line_count(&shown.lines), count + 1),
            Some(derivation) => {
                let all = derivation.lines_through(shown.highlighted);
                (all, derivation.lines_after(count, all))
            }
            None => return is_asking,
        };
        let is_left = count < all;
        if is_left {
            // The answer says what comes out, and the lines how: beside the graph and the plane, and where a vector
            // grows out of others.
            let is_by_line = matches!(layout, ViewLayout::Plot | ViewLayout::Lines)
                || derivation.is_some_and(Derivation::makes_vectors);
            shown.revealed_lines = Some(if is_asking && !is_by_line { all } else { next });
        }
        is_asking || is_left
    }

    /// Returns how many lines of the derivation are visible when a lesson's step opens while presenting: those that the
    /// step before has shown, if the derivation stays the same, otherwise none. Returns `None` if lines are not
    /// revealed one by one.
    fn lines_to_begin_with(&self, step: &Step) -> Option<usize> {
        let shown = &self.session.shown;
        self.session.presenting?;
        let layout = step.layout().unwrap_or(shown.setup.layout);
        if !comes_in_lines(layout) {
            return None;
        }
        let is_same = self.open.document == step.document
            && shown.selection == step.shown.selection
            // Beside the graph, each step has lines of its own.
            && (layout != ViewLayout::Plot || step.shown.formulas == shown.formulas)
            && (layout != ViewLayout::Lines || step.shown.lines == shown.lines)
            && (!step.says("derivation") || step.shown.sections == shown.sections);
        let was_derived = comes_in_lines(shown.setup.layout);
        if !is_same || !was_derived || shown.is_asking {
            return Some(0);
        }
        let known = match (&shown.formulas, &step.shown.formulas) {
            (Some(Formulas::About(before)), Some(Formulas::About(now))) if before != now => {
                now.iter().take_while(|concept| before.contains(concept)).count()
            }
            _ => usize::MAX,
        };
        shown.revealed_lines.map(|count| count.min(known))
    }

    /// Keeps back the lines of a step when presenting begins, so that they come one by one, unless its question is answered.
    /// When it ends, forgets the ink.
    pub(super) fn presenting_changed(&mut self) {
        self.lessons.revealed.clear();
        let step = self.lessons.open.as_ref().map(OpenLesson::step);
        if self.session.presenting.is_none() {
            self.lessons.ink.clear();
            return;
        }
        let is_answered = step.is_none_or(|step| step.question.is_some());
        let shown = &mut self.session.shown;
        if (shown.is_asking || !is_answered) && comes_in_lines(shown.setup.layout) {
            shown.revealed_lines = Some(0);
        }
    }

    /// Returns why the step has no derivation that could fill the window; `None` if it has one or no lesson is open.
    pub(super) fn why_no_derivation(&self) -> Option<&'static str> {
        let (shown, presenting) = (&self.session.shown, self.session.presenting?);
        self.lessons.open.as_ref()?;
        let is_empty =
            matches!(&shown.formulas, Some(Formulas::About(concepts)) if concepts.is_empty());
        if is_empty || !column::has_card(presenting.before(shown.setup.layout)) {
            return Some("This step has no derivation.");
        }
        shown.is_asking.then_some("The derivation comes with the answer.")
    }

    /// Shows the step's answer and all lines of its derivation.
    pub(super) fn show_all(&mut self) {
        self.answer();
        self.session.shown.revealed_lines = None;
        self.lessons.revealed.clear();
    }

    /// Opens a vote on the step's question while it is asked. Returns false if the step has no answers to vote on.
    pub(super) fn open_vote(&mut self) -> bool {
        let question = self.lessons.open.as_ref().and_then(|open| open.step().question.as_ref());
        let Some(question) = question.filter(|_| self.session.can_vote()) else { return true };
        let has_choices = !question.choices.is_empty();
        self.session.live.vote = has_choices.then(|| OpenVote::on_choices(&question.choices));
        has_choices
    }

    /// Shows the exercise's solution. Returns false if there is none, or if it is shown already.
    pub(super) fn solve(&mut self) -> bool {
        let is_new = self.session.shows_exercise() && !self.session.exercises.is_solved;
        if is_new {
            self.session.exercises.toggle_solution();
        }
        is_new
    }

    /// Shows the answer to the step's question.
    pub(super) fn answer(&mut self) {
        self.session.live.vote = None;
        if let Some(open) = &self.lessons.open {
            apply::answer(open.step(), &mut self.session.shown);
        }
    }

    /// Resets everything to the state that the open lesson's step specifies, if anything differs from it.
    pub(super) fn back_to_step(&mut self) -> Result<Opened, Question> {
        let open = self.lessons.open.clone().filter(|_| self.differs_from_step());
        let Some(open) = open else { return Ok(Opened::default()) };
        let (seen_from, is_asking) = (self.lessons.seen_from, self.session.shown.is_asking);
        let (revealed_lines, framed) = (self.session.shown.revealed_lines, self.framed);
        let revealed = mem::take(&mut self.lessons.revealed);
        let opened = self.open_lesson(open.id(), None)?;
        self.lessons.revealed = revealed;
        apply::clear_answers(open.step(), &mut self.session.exercises);
        self.session.shown.revealed_lines = revealed_lines;
        if !is_asking {
            self.answer();
        }
        // The step's own observer is fitted again the next time the world view is shown, unless it was directed to a line.
        let is_directed = self.session.live.directed.is_some();
        let own = open.step().shown.observer.filter(|_| !is_directed);
        let observer = own.or(seen_from);
        if is_directed {
            self.framed = framed;
        }
        (self.session.shown.observer, self.lessons.seen_from) = (observer, observer);
        Ok(opened)
    }

    /// Closes the lesson; its scene stays open as an ordinary scene. An observer that the user has moved
    /// stays; otherwise the observer is fitted to the layout from before the lesson.
    pub(super) fn close_lesson(&mut self) {
        let (shown, lessons) = (&mut self.session.shown, &mut self.lessons);
        if lessons.open.take().is_some() && shown.observer == lessons.seen_from {
            shown.observer = None;
        }
        lessons.ink.clear();
        self.session.live.vote = None;
        if let Some(before) = lessons.before.take() {
            let Shown { selection, observer, .. } = *shown;
            *shown = Shown { selection, observer, ..before.shown };
            // The answers typed in a step's exercise are kept.
            let exercises = &before.exercises;
            self.session.exercises.show(exercises.question().exercise, exercises.seed());
        }
        let before = self.lessons.scene_before.iter();
        let before = before.filter_map(|path| SceneSource::from_argument(path).ok());
        self.open.leave_lesson(before.chain(BuiltinScene::all().iter().map(SceneSource::Builtin)));
    }

    /// Returns true if anything differs from the open lesson's step.
    pub(super) fn differs_from_step(&self) -> bool {
        self.lessons.open.as_ref().is_some_and(|open| {
            let seen_from = self.lessons.seen_from;
            apply::differs(open.step(), seen_from, &self.open.document, &self.session)
        })
    }

    /// Returns true if a lesson's step, a vote or an exercise fills the window.
    pub(super) fn has_stage(&self) -> bool {
        let is_exercise = self.session.shown.setup.layout == ViewLayout::Exercises;
        self.lessons.open.is_some() || self.session.shows_vote() || is_exercise
    }
}
