//! From a step to what is edited and how it is looked at: the one place where a step's fields become
//! the window's.

use pinhole_core::lecture::mistakes::Mistake;

use super::lesson::{AskedExercise, Looks, Step};
use crate::document::Document;
use crate::exercises::Exercises;
use crate::mistakes::Gallery;
use crate::model::observer::Observer;
use crate::model::overlay_items::Item;
use crate::model::session::{Session, Settings};

/// Sets what the step says and leaves alone what it does not, and what was typed in answer to its
/// question.
///
/// `seen_from` is the observer that the step was first looked at from, where it says none.
pub fn apply(
    step: &Step,
    seen_from: Option<Observer>,
    document: &mut Document,
    session: &mut Session,
) {
    document.clone_from(&step.document);
    look(step, seen_from, session);
}

/// Takes away what was typed in answer to the step's question.
pub fn clear_answers(step: &Step, session: &mut Session) {
    if let Some(asked) = step.looks.exercise {
        session.exercises = opened(asked);
    }
}

/// Sets how the step is looked at.
fn look(step: &Step, seen_from: Option<Observer>, session: &mut Session) {
    session.selection = step.selection;
    let looks = &step.looks;
    session.observer = looks.observer.or(seen_from).or(session.observer);
    set(&mut session.sections, looks.ledger);
    set(&mut session.lit, looks.lit);
    session.walked = looks.t;
    set(&mut session.lines, looks.lines.clone());
    if let Some(chosen) = looks.mistake {
        session.gallery = gallery(chosen);
    }
    if let Some(asked) = looks.exercise {
        session.exercises.show(asked.exercise, asked.seed);
    }
    session.settings = settings_said(looks, session.settings);
}

/// The settings as a step says them.
fn settings_said(looks: &Looks, mut settings: Settings) -> Settings {
    set(&mut settings.layout, looks.layout);
    if let Some(items) = looks.items {
        // Steps are there to be dragged; whether by handles is the user's to say.
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

/// Gives back what lessons set: the window as it was before the first of them. Selection and
/// observer stay with the step's scene, which stays open.
pub fn give_back(before: &Session, session: &mut Session) {
    session.sections = before.sections;
    session.lit = before.lit;
    session.walked = before.walked;
    session.lines = before.lines.clone();
    session.gallery = before.gallery;
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

/// Whether anything is not as the step says.
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
        && looks.ledger.is_none_or(|said| session.sections == said)
        && looks.lit.is_none_or(|said| session.lit == said)
        && looks.t == session.walked
        && looks.lines.as_ref().is_none_or(|said| session.lines == *said)
        && looks.mistake.is_none_or(|said| session.gallery == gallery(said))
        && looks.exercise.is_none_or(|said| session.exercises == opened(said))
        && settings_said(looks, session.settings) == session.settings;
    !is_as_said
}

fn gallery(chosen: Mistake) -> Gallery {
    Gallery { chosen, ..Gallery::default() }
}

fn opened(asked: AskedExercise) -> Exercises {
    Exercises::open(asked.exercise, asked.seed)
}

fn set<T>(value: &mut T, said: Option<T>) {
    if let Some(said) = said {
        *value = said;
    }
}
