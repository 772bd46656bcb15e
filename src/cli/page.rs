//! `pinhole page`: writes the page that shows the program in a browser, with a scene or a lesson in it.

use pinhole_exchange::host::host;
use pinhole_exchange::{FileError, limits};

use super::console::{CommandError, refused, warn};
use super::load::{deliver, files_of, load};
use crate::cli::arguments::PageArguments;
use crate::model::lessons::{LessonArgument, OpenLesson, is_lesson};
use crate::model::page_part;

pub(super) fn run(arguments: &PageArguments) -> Result<(), CommandError> {
    let PageArguments { scene, lesson, step, output, page } = arguments;
    let file = scene.as_ref().filter(|path| is_lesson(path));
    let file = file.map(|path| LessonArgument::File(path.clone()));
    let (part, read) = match (lesson.as_ref().or(file.as_ref()), scene) {
        (Some(lesson), _) => {
            let (mut id, file) = lesson.load()?;
            if let Some(step) = step {
                id.step = usize::from(*step) - 1;
            }
            let open = OpenLesson::at(id, file.as_ref()).ok_or_else(|| {
                CommandError::Arguments(format!("the lesson has no step {}", id.step + 1))
            })?;
            (page_part::of_step(&open)?, page_part::files_of(&open)?)
        }
        (None, Some(_)) if step.is_some() => {
            return refused("--step is for a lesson: name a lesson, or leave it out");
        }
        (None, Some(scene)) => {
            let document = load(scene)?;
            (page_part::of_scene(&document)?, files_of(scene, &document))
        }
        (None, None) => Default::default(),
    };
    let of_program = match page {
        Some(page) => limits::read_text_of(page, limits::FOREIGN)?,
        None => host().page().map_err(CommandError::Input)?,
    };
    let text = part.in_page(&of_program).map_err(|problem| match page {
        Some(page) => FileError::of_file(page, problem).into(),
        None => CommandError::Input(problem),
    })?;
    let notes = page_part::notes(&read);
    let read: Vec<_> = read.into_iter().chain(page.clone()).collect();
    deliver(Some(output), &read, |out| out.write_all(text.as_bytes()))?;
    notes.iter().for_each(|note| warn(note));
    Ok(())
}
