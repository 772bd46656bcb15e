//! Links: what a link opens in this program, and the link to what the window shows.

use std::path::Path;

use pinhole_core::Selection;
use pinhole_exchange::link::{Link, Linked, is_meant};
use pinhole_exchange::{Document, FileError, scene_file};

use crate::model::lessons::{LessonArgument, OpenLesson, StepId, Which};
use crate::model::session::{Session, ViewLayout};

/// Reads a link, and checks that there are its step and its page.
///
/// # Errors
/// Returns the errors of [`Link::parse`], and an error if there is no such step or page.
pub fn read(text: &str) -> Result<Link, FileError> {
    let link = Link::parse(text)?;
    let fault = |problem: String| FileError::of_file(Path::new("link"), problem);
    if let Linked::Step { lesson, step } = link.shown {
        LessonArgument::parse(&format!("{lesson}.{step}")).map_err(fault)?;
    }
    if let Some(page) = link.page.as_ref().filter(|_| layout_of(&link).is_none()) {
        return Err(fault(format!("this program has no page {page:?}")));
    }
    Ok(link)
}

/// Reads the link that an argument of the command line is; `None` if it is none, or the name of a file.
pub fn of_argument(argument: &Path) -> Option<Result<Link, FileError>> {
    let text = argument.to_str().filter(|text| is_meant(text) && !argument.exists())?;
    Some(read(text))
}

/// Returns the layout that a link names.
pub fn layout_of(link: &Link) -> Option<ViewLayout> {
    let named =
        |layout: &ViewLayout| layout.name().is_some() && layout.name() == link.page.as_deref();
    ViewLayout::LISTED.into_iter().find(named)
}

/// Returns the link to a step of a built-in lesson.
pub fn of_step(id: StepId) -> Option<Linked> {
    let Which::Builtin(index) = id.lesson else { return None };
    Some(Linked::Step { lesson: index + 1, step: id.step + 1 })
}

/// Returns the link to what the window shows: the open step, unless its scene has been changed, or the scene.
pub fn to_window(document: &Document, session: &Session, lesson: Option<&OpenLesson>) -> Link {
    let text = |document: &Document| scene_file::to_text(document, None);
    let open = lesson.filter(|open| text(&open.step().document) == text(document));
    let step = open.and_then(|open| Some((of_step(open.id())?, open.step())));
    let layout = session.shown.setup.layout;
    let layout = session.presenting.map_or(layout, |presenting| presenting.before(layout));
    let (shown, ray, usual) = match step {
        Some((shown, step)) => (shown, step.shown.selection, step.layout().unwrap_or(layout)),
        None => (Linked::scene(document), Selection::default(), ViewLayout::Both),
    };
    let ray = Some(session.shown.selection).filter(|selected| *selected != ray);
    let page = layout.name().filter(|_| layout != usual).map(str::to_owned);
    Link { shown, ray, page }
}
