//! The second picture of a page, next to the camera's: the error map, the picture of a wrong camera or of the
//! ghost (a frozen copy of the camera), or the map of a student's right and wrong answers.

use egui::{Rect, Ui};

use crate::ui::PageContext;
use crate::ui::practice::{answers, mistakes};
use crate::ui::scene::{compare, views};
use crate::ui::tools::accuracy;
use crate::ui::widgets::no_picture;
use crate::view::derive::SecondPicture;

/// Returns the picture's name for screen readers. While a question is open, it does not say which camera is
/// wrong.
pub(crate) fn name(second: SecondPicture, is_asking: bool) -> &'static str {
    match second {
        SecondPicture::WrongCamera if is_asking => mistakes::HEADINGS[1],
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
    let (mut spoken, mut why_not) = (None, None);
    match second {
        SecondPicture::ErrorMap => {
            accuracy::strip(ui, area, &mut session.preferences.compared);
            if let (Some(compared), Some(_)) = (derived.compared.as_deref(), view) {
                spoken = Some(accuracy::summary(compared));
                accuracy::legend(ui, area, compared);
            }
            why_not = derived.too_many.map(|why| format!("No error map: {why}"));
        }
        SecondPicture::WrongCamera => {
            let mistakes_view = &mut session.shown.mistakes_view;
            match on_stage {
                Some(camera) => mistakes::headings(ui, [camera, area], session.shown.is_asking),
                None => mistakes::strip(ui, area, mistakes_view),
            }
            if let Some(wrong) = derived.wrong_camera.as_deref() {
                spoken = Some(mistakes::spoken(wrong, mistakes_view, session.shown.is_asking));
                why_not = mistakes::why_not(wrong, mistakes_view);
            }
        }
        SecondPicture::Ghost => {
            compare::strip(ui, area, &mut session.shown.ghost);
            spoken = Some(compare::spoken(derived.against_ghost.as_deref()));
            why_not = Some(compare::why_not(session.shown.ghost.as_ref()));
        }
        SecondPicture::Answers => {
            let graded = derived.grading.as_ref().and_then(|graded| graded.as_ref().ok());
            let map = graded.map(|graded| &**graded).filter(|_| view.is_some());
            answers::strip(ui, area, session, map);
            spoken = Some(answers::spoken(derived, session));
            why_not = Some(answers::why_not(derived, session).to_owned());
        }
    }
    if let Some(spoken) = spoken {
        views::speak(ui, name(second, session.shown.is_asking), &spoken);
    }
    match (view, why_not) {
        (Some(shown), _) => {
            views::show(ui, rect, shown, &mut context.tools.second, derived.fault.is_some());
        }
        (None, Some(why)) => no_picture(ui, rect, &why),
        (None, None) => {}
    }
}
