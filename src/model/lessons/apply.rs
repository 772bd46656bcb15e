//! Applies a lesson's step to the document and the session. This is the only place where the fields of a
//! step change the window's state.

use pinhole_exchange::document::Document;

use super::lesson::Step;
use crate::model::{Concept, Item, MistakesView, Observer, OverlayItems, Session, Settings};

/// Sets everything in the session that the step specifies. Everything else stays unchanged, including the answers
/// typed for its question.
///
/// `seen_from` is the step's observer as it was fitted to the view when the step was first shown; `None` if
/// the step has not been shown yet.
pub fn apply(step: &Step, seen_from: Option<Observer>, session: &mut Session) {
    session.is_asking = step.question.is_some();
    set_view(step, seen_from, session);
}

/// Shows the answer to the step's question, and the overlay items that were hidden while it was open.
pub fn answer(step: &Step, session: &mut Session) {
    session.settings.items = items_to_frame(step, session);
    session.is_asking = false;
}

/// Returns the items that will be drawn once the step's question is answered. The observer is placed so
/// that all of them are in sight from the start, so it need not move when the answer is shown.
pub fn items_to_frame(step: &Step, session: &Session) -> OverlayItems {
    let mut shown = session.settings.items;
    if let (true, Some(question), Some(items)) =
        (session.is_asking, &step.question, step.view.items)
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
    session.selection = step.selection;
    let view = &step.view;
    session.observer = seen_from.or(view.observer).or(session.observer);
    set(&mut session.sections, view.derivation);
    (session.formulas, session.before_recap) = (view.formulas.clone(), None);
    set(&mut session.highlighted, view.highlighted);
    (session.ray_point_t, session.ghost) = (view.t, view.ghost);
    session.spoken = Some(spoken_of(step));
    set(&mut session.lines, view.lines.clone());
    if let Some(chosen) = view.mistake {
        session.mistakes_view = MistakesView { chosen, ..MistakesView::default() };
    }
    // An open vote (on the mistake in a picture) refers to the previous step's picture, and would cover
    // this step's text.
    if session.mistakes_view.open_vote.is_some() {
        session.mistakes_view.close_vote();
    }
    if let Some(asked) = view.exercise {
        session.exercises.show(asked.exercise, asked.seed);
    }
    let settings = &mut session.settings;
    set(&mut settings.layout, view.layout);
    if let Some(items) = view.items {
        // Handles can be dragged in the picture of any step, so a step never hides them.
        let handles = settings.items.shows(Item::Handles) || items.shows(Item::Handles);
        settings.items = items.with(Item::Handles, handles);
        if let Some(question) = step.question.as_ref().filter(|_| session.is_asking) {
            settings.items = settings.items.without(question.hidden);
        }
    }
    set(&mut settings.shade, view.shade);
    set(&mut settings.count_from_one, view.count_from_one);
    set(&mut settings.digits, view.digits);
    set(&mut settings.keep_picture, view.keep_picture);
    set(&mut settings.teaching, view.teaching);
}

/// Restores the window's state from before the first lesson, except the selection and the observer: they
/// belong to the step's scene, which stays open.
pub fn restore(before: &Session, session: &mut Session) {
    session.is_asking = false;
    session.revealed_lines = None;
    session.sections = before.sections;
    session.formulas = before.formulas.clone();
    session.before_recap = before.before_recap.clone();
    session.highlighted = before.highlighted;
    session.spoken = before.spoken.clone();
    session.ray_point_t = before.ray_point_t;
    session.ghost = before.ghost;
    session.lines = before.lines.clone();
    session.mistakes_view = before.mistakes_view.clone();
    // The answers typed in a step's exercise are kept.
    let exercises = &before.exercises;
    session.exercises.show(exercises.question().exercise, exercises.seed());
    restore_settings(&before.settings, &mut session.settings);
}

/// Restores the settings from before the first lesson, except those that lessons do not change.
pub fn restore_settings(before: &Settings, settings: &mut Settings) {
    settings.layout = before.layout;
    settings.items = before.items;
    settings.shade = before.shade;
    settings.count_from_one = before.count_from_one;
    settings.digits = before.digits;
    settings.keep_picture = before.keep_picture;
    settings.teaching = before.teaching;
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
    as_step.ghost = session.ghost;
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
