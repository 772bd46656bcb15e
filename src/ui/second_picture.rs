//! The second picture of a page, next to the camera's: the error map, the picture of a wrong camera or of the
//! ghost (a frozen copy of the camera), or the map of a student's right and wrong answers.

use egui::{Rect, Ui};

use crate::features::{accuracy, answers, mistakes};
use crate::ui::PageContext;
use crate::ui::scene::{compare, views};
use crate::ui::widgets::{Words, no_picture};
use crate::view::derive::SecondPicture;

/// Returns the picture's name for screen readers. While a question is open, it does not say which camera is
/// wrong.
pub(crate) fn name(second: SecondPicture, is_asking: bool) -> &'static str {
    match second {
        SecondPicture::WrongCamera if is_asking => mistakes::ui::HEADINGS[1],
        named => named.name(),
    }
}

/// Shows the second picture in `rect`, or the reason why there is none. Shows the picture's title above
/// `area`. `on_stage` is the area of the camera view on a lesson's stage, where it has no title of its own.
pub(crate) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    second: SecondPicture,
    [area, rect]: [Rect; 2],
    on_stage: Option<Rect>,
) {
    let (derived, session) = (context.derived, &mut *context.session);
    let view = derived.second_view.as_ref();
    let words: Option<Words> = match second {
        SecondPicture::ErrorMap => {
            accuracy::ui::strip(ui, area, &mut session.preferences.compared);
            let compared = derived.compared.as_deref().filter(|_| view.is_some());
            compared.inspect(|compared| accuracy::ui::legend(ui, area, compared));
            let why_not = derived.too_many.map(|why| format!("No error map: {why}"));
            let spoken = compared.map(accuracy::ui::summary).or_else(|| why_not.clone());
            spoken.map(|spoken| (spoken, why_not))
        }
        SecondPicture::WrongCamera => {
            let (is_asking, mistakes_view) =
                (session.shown.is_asking, &mut session.shown.mistakes_view);
            match on_stage {
                Some(camera) => mistakes::ui::headings(ui, [camera, area], is_asking),
                None => mistakes::ui::strip(ui, area, mistakes_view),
            }
            let wrong = derived.wrong_camera.as_deref();
            wrong.map(|wrong| mistakes::ui::words(wrong, mistakes_view, is_asking))
        }
        SecondPicture::Ghost => {
            match on_stage {
                Some(camera) => compare::headings(ui, [camera, area]),
                None => compare::strip(ui, area, &mut session.shown.ghost),
            }
            let ghost = session.shown.ghost.as_ref();
            Some(compare::words(derived.against_ghost.as_deref(), ghost))
        }
        SecondPicture::Answers => {
            let graded = derived.grading.as_ref().and_then(|graded| graded.as_deref().ok());
            answers::ui::strip(ui, area, session, graded.filter(|_| view.is_some()));
            let why_not = answers::ui::why_not(derived, session).to_owned();
            Some((answers::ui::spoken(derived, session), Some(why_not)))
        }
    };
    let Some((spoken, why_not)) = words else { return };
    views::speak(ui, name(second, session.shown.is_asking), &spoken);
    match (view, why_not) {
        (Some(shown), _) => {
            views::show(ui, rect, shown, &mut context.tools.second, derived.fault.is_some());
        }
        (None, Some(why)) => no_picture(ui, rect, &why),
        (None, None) => {}
    }
}
