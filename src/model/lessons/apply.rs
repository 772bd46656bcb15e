//! Applies a lesson's step to the document and the session: the only place where a step's fields
//! become the window's state.

use pinhole_exchange::document::Document;
use pinhole_lecture::mistakes::Mistake;

use super::lesson::{AskedExercise, Step, StepView};
use crate::model::observer::Observer;
use crate::model::overlay_items::Item;
use crate::model::practice::exercises::Exercises;
use crate::model::practice::mistakes_view::MistakesView;
use crate::model::session::{Session, Settings};

/// Sets what the step specifies. Leaves the rest unchanged, and the answers to its question too.
///
/// `seen_from` is the observer from which the step was first seen, for a step that specifies none.
pub fn apply(
    step: &Step,
    seen_from: Option<Observer>,
    document: &mut Document,
    session: &mut Session,
) {
    document.clone_from(&step.document);
    look(step, seen_from, session);
}

/// Clears the answers to the step's question.
pub fn clear_answers(step: &Step, session: &mut Session) {
    if let Some(asked) = step.looks.exercise {
        session.exercises = opened(asked);
    }
}

/// Sets the view of the step: selection, observer, settings.
fn look(step: &Step, seen_from: Option<Observer>, session: &mut Session) {
    session.selection = step.selection;
    let looks = &step.looks;
    session.observer = looks.observer.or(seen_from).or(session.observer);
    set(&mut session.sections, looks.derivation);
    set(&mut session.highlighted, looks.highlighted);
    session.ray_point_t = looks.t;
    set(&mut session.lines, looks.lines.clone());
    if let Some(chosen) = looks.mistake {
        session.mistakes_view = mistakes_view(chosen);
    }
    if let Some(asked) = looks.exercise {
        session.exercises.show(asked.exercise, asked.seed);
    }
    session.settings = settings_said(looks, session.settings);
}

/// The settings as a step says them.
fn settings_said(looks: &StepView, mut settings: Settings) -> Settings {
    set(&mut settings.layout, looks.layout);
    if let Some(items) = looks.items {
        // The pictures of steps can be dragged; the user decides about handles.
        let handles = settings.items.shows(Item::Handles) || items.shows(Item::Handles);
        settings.items = items.with(Item::Handles, handles);
    }
    set(&mut settings.shade, looks.shade);
    set(&mut settings.count_from_one, looks.count_from_one);
    set(&mut settings.digits, looks.digits);
    set(&mut settings.keep_picture, looks.keep_picture);
    set(&mut settings.teaching, looks.teaching);
    settings
}

/// Restores what lessons set: the window as it was before the first lesson. Selection and observer
/// stay with the step's scene, which stays open.
pub fn give_back(before: &Session, session: &mut Session) {
    session.sections = before.sections;
    session.highlighted = before.highlighted;
    session.ray_point_t = before.ray_point_t;
    session.lines = before.lines.clone();
    session.mistakes_view = before.mistakes_view;
    session.exercises = before.exercises.clone();
    let (before, settings) = (&before.settings, &mut session.settings);
    settings.layout = before.layout;
    settings.items = before.items;
    settings.shade = before.shade;
    settings.count_from_one = before.count_from_one;
    settings.digits = before.digits;
    settings.keep_picture = before.keep_picture;
    settings.teaching = before.teaching;
}

/// Returns true if anything differs from what the step specifies.
pub fn differs(
    step: &Step,
    seen_from: Option<Observer>,
    document: &Document,
    session: &Session,
) -> bool {
    let looks = &step.looks;
    let is_as_said = step.document == *document
        && step.selection == session.selection
        && looks.observer.or(seen_from).is_none_or(|said| session.observer == Some(said))
        && looks.derivation.is_none_or(|said| session.sections == said)
        && looks.highlighted.is_none_or(|said| session.highlighted == said)
        && looks.t == session.ray_point_t
        && looks.lines.as_ref().is_none_or(|said| session.lines == *said)
        && looks.mistake.is_none_or(|said| session.mistakes_view == mistakes_view(said))
        && looks.exercise.is_none_or(|said| session.exercises == opened(said))
        && settings_said(looks, session.settings) == session.settings;
    !is_as_said
}

fn mistakes_view(chosen: Mistake) -> MistakesView {
    MistakesView { chosen, ..MistakesView::default() }
}

fn opened(asked: AskedExercise) -> Exercises {
    Exercises::open(asked.exercise, asked.seed)
}

fn set<T>(value: &mut T, said: Option<T>) {
    if let Some(said) = said {
        *value = said;
    }
}
