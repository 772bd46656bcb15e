//! Applies a lesson's step to what is shown.

use pinhole_exchange::document::Document;
use pinhole_figure::{Item, Observer, OverlayItems};

use super::keys::KEYS;
use super::lesson::Step;
use crate::features::exercises::Exercises;
use crate::model::{Session, Shown};

/// Shows the step. What it does not say stays unchanged, including the answers typed for its question.
pub fn apply(step: &Step, session: &mut Session) {
    session.shown.is_asking = step.question.is_some();
    session.shown = over(step, None, &session.shown);
    if let Some(asked) = step.exercise {
        session.exercises.show(asked.exercise, asked.seed);
    }
}

/// Returns what is shown when the step is shown after `before`.
///
/// `seen_from` is the step's observer as it was fitted to the view when the step was first shown; `None` if
/// the step has not been shown yet.
fn over(step: &Step, seen_from: Option<Observer>, before: &Shown) -> Shown {
    let (is_asking, revealed_lines) = (before.is_asking, before.revealed_lines);
    let mut shown = Shown { is_asking, revealed_lines, ..step.shown.clone() };
    let left_alone = KEYS.iter().filter(|key| !step.says(key.name));
    left_alone.for_each(|key| (key.set)(&mut shown, before));
    shown.observer = seen_from.or(step.shown.observer).or(before.observer);
    // An open vote (on the mistake in a picture) refers to the previous step's picture, and would cover
    // this step's text.
    if shown.mistakes_view.open_vote.is_some() {
        shown.mistakes_view.close_vote();
    }
    // Handles can be dragged in the picture of any step, so a step never hides them.
    let items = &mut shown.setup.items;
    let handles = items.shows(Item::Handles) || before.setup.items.shows(Item::Handles);
    items.set(Item::Handles, handles);
    if before.is_asking {
        *items = items.without(hidden(step));
    }
    shown
}

/// Returns the items that are hidden while the step's question is open.
fn hidden(step: &Step) -> OverlayItems {
    let question = step.question.as_ref().filter(|_| step.says("show"));
    question.map_or(OverlayItems::NONE, |question| question.hidden)
}

/// Shows the answer to the step's question, and the overlay items that were hidden while it was open.
pub fn answer(step: &Step, shown: &mut Shown) {
    shown.setup.items = items_to_frame(step, shown);
    shown.is_asking = false;
}

/// Asks the step's question again.
pub fn ask(step: &Step, shown: &mut Shown) {
    shown.setup.items = shown.setup.items.without(hidden(step));
    shown.is_asking = true;
}

/// Returns the items that will be drawn once the step's question is answered. The observer is placed so
/// that all of them are in sight from the start, so it need not move when the answer is shown.
pub fn items_to_frame(step: &Step, shown: &Shown) -> OverlayItems {
    let (mut items, hidden) = (shown.setup.items, hidden(step));
    let comes = |item: &Item| hidden.shows(*item) && step.shown.setup.items.shows(*item);
    if shown.is_asking {
        Item::ALL.into_iter().filter(comes).for_each(|item| items.set(item, true));
    }
    items
}

/// Clears the user's answers to the step's exercise.
pub fn clear_answers(step: &Step, exercises: &mut Exercises) {
    if let Some(asked) = step.exercise {
        exercises.show(asked.exercise, asked.seed);
        exercises.clear();
    }
}

/// Returns true if the document or the session differs from what the step specifies.
pub fn differs(
    step: &Step,
    seen_from: Option<Observer>,
    document: &Document,
    session: &Session,
) -> bool {
    // A camera that is frozen for comparison changes nothing of the step.
    let shown = Shown { ghost: session.shown.ghost, ..over(step, seen_from, &session.shown) };
    let mut exercises = session.exercises.clone();
    clear_answers(step, &mut exercises);
    step.document != *document || shown != session.shown || exercises != session.exercises
}
