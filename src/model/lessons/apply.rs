//! Applies a lesson's step to the document and the session. This is the only place where the fields of a
//! step change the window's state.

use pinhole_exchange::document::Document;

use super::lesson::Step;
use crate::model::{Concept, Item, MistakesView, Observer, OverlayItems, Session};

/// Sets everything in the session that the step specifies. Everything else stays unchanged, including the answers
/// typed for its question.
///
/// `seen_from` is the step's observer as it was fitted to the view when the step was first shown; `None` if
/// the step has not been shown yet.
pub fn apply(step: &Step, seen_from: Option<Observer>, session: &mut Session) {
    session.shown.is_asking = step.question.is_some();
    set_view(step, seen_from, session);
}

/// Shows the answer to the step's question, and the overlay items that were hidden while it was open.
pub fn answer(step: &Step, session: &mut Session) {
    session.shown.setup.items = items_to_frame(step, session);
    session.shown.is_asking = false;
}

/// Returns the items that will be drawn once the step's question is answered. The observer is placed so
/// that all of them are in sight from the start, so it need not move when the answer is shown.
pub fn items_to_frame(step: &Step, session: &Session) -> OverlayItems {
    let mut shown = session.shown.setup.items;
    if let (true, Some(question), Some(items)) =
        (session.shown.is_asking, &step.question, step.view.items)
    {
        for item in Item::ALL {
            if question.hidden.shows(item) && items.shows(item) {
                shown.set(item, true);
            }
        }
    }
    shown
}

/// Clears the user's answers to the step's exercise.
pub fn clear_answers(step: &Step, session: &mut Session) {
    if let Some(asked) = step.view.exercise {
        session.exercises.show(asked.exercise, asked.seed);
        session.exercises.clear();
    }
}

/// Sets the step's selection, observer and settings.
fn set_view(step: &Step, seen_from: Option<Observer>, session: &mut Session) {
    session.shown.selection = step.selection;
    let view = &step.view;
    session.shown.observer = seen_from.or(view.observer).or(session.shown.observer);
    set(&mut session.shown.sections, view.derivation);
    (session.shown.formulas, session.shown.before_recap) = (view.formulas.clone(), None);
    set(&mut session.shown.highlighted, view.highlighted);
    (session.shown.ray_point_t, session.shown.ghost) = (view.t, view.ghost);
    session.shown.spoken = Some(spoken_of(step));
    set(&mut session.shown.lines, view.lines.clone());
    if let Some(chosen) = view.mistake {
        session.shown.mistakes_view = MistakesView { chosen, ..MistakesView::default() };
    }
    // An open vote (on the mistake in a picture) refers to the previous step's picture, and would cover
    // this step's text.
    if session.shown.mistakes_view.open_vote.is_some() {
        session.shown.mistakes_view.close_vote();
    }
    if let Some(asked) = view.exercise {
        session.exercises.show(asked.exercise, asked.seed);
    }
    let settings = &mut session.shown.setup;
    set(&mut settings.layout, view.layout);
    if let Some(items) = view.items {
        // Handles can be dragged in the picture of any step, so a step never hides them.
        let handles = settings.items.shows(Item::Handles) || items.shows(Item::Handles);
        settings.items = items.with(Item::Handles, handles);
        if let Some(question) = step.question.as_ref().filter(|_| session.shown.is_asking) {
            settings.items = settings.items.without(question.hidden);
        }
    }
    set(&mut settings.shade, view.shade);
    set(&mut settings.count_from_one, view.count_from_one);
    set(&mut settings.digits, view.digits);
    set(&mut settings.keep_picture, view.keep_picture);
    set(&mut settings.teaching, view.teaching);
}

/// Returns true if the document or the session differs from what the step specifies.
pub fn differs(
    step: &Step,
    seen_from: Option<Observer>,
    document: &Document,
    session: &Session,
) -> bool {
    let mut as_step = session.clone();
    set_view(step, seen_from, &mut as_step);
    clear_answers(step, &mut as_step);
    // A camera that is frozen for comparison changes nothing of the step.
    as_step.shown.ghost = session.shown.ghost;
    step.document != *document || as_step != *session
}

/// Returns which of the viewport's concepts (such as the distance) and the normal the step's title or text
/// names.
fn spoken_of(step: &Step) -> Vec<Concept> {
    const NAMES: [(&str, Concept); 5] = [
        ("width", Concept::Viewport),
        ("height", Concept::Viewport),
        ("distance", Concept::Distance),
        ("the normal", Concept::Normal),
        ("**n**", Concept::Normal),
    ];
    let text = format!("{} {}", step.title, step.text).to_lowercase();
    let named = NAMES.into_iter().filter(|(name, _)| text.contains(name));
    named.map(|(_, concept)| concept).collect()
}

fn set<T>(value: &mut T, chosen: Option<T>) {
    if let Some(chosen) = chosen {
        *value = chosen;
    }
}
