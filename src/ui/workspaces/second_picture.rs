//! The pages with a second picture beside the camera's: where another method errs, what a wrong camera
//! or the ghost sees, and where a student's answers are wrong.

use egui::{Rect, Ui, pos2};

use super::page::{Desk, Page};
use crate::figures::Subject;
use crate::model::files::title_of;
use crate::model::session::Split;
use crate::ui::practice::{answers, mistakes};
use crate::ui::scene::view_rects::{Areas, STRIP, halves};
use crate::ui::scene::{compare, views};
use crate::ui::tools::accuracy;
use crate::ui::widgets::fault;
use crate::view::derive::SecondPicture;

pub(super) const ACCURACY: Page = Page {
    areas: |divider| {
        let (views, rest) = divider.above(Split::Accuracy);
        // Below both, so that they are alike, room for the map's legend.
        let bottom = (views.bottom() - accuracy::LEGEND).max(views.top() + STRIP + 1.0);
        let (left, right) = halves(Rect::from_min_max(views.min, pos2(views.right(), bottom)));
        Areas { world: None, camera: Some(left), second: Some(right), rest }
    },
    second: Some(SecondPicture::ErrorMap),
    rest: |ui, desk| {
        let (document, measuring) = (&desk.open.document, &mut desk.tools.measuring);
        measuring.step(ui.ctx(), &title_of(desk.open.origin()), &document.camera, desk.derived);
        accuracy::ui(ui, measuring, desk.derived, document, desk.session);
    },
    figure: Subject::Camera,
    ..Page::VIEWS
};

pub(super) const MISTAKES: Page = Page {
    areas: |divider| divider.three_above(Split::Mistakes),
    second: Some(SecondPicture::WrongCamera),
    rest: |ui, desk| {
        let view = &mut desk.session.mistakes_view;
        mistakes::ui(ui, desk.derived, &desk.open.document, view, desk.style);
    },
    figure: Subject::Camera,
    ..Page::VIEWS
};

pub(super) const COMPARE: Page = Page {
    areas: |divider| {
        let (views, rest) = divider.above(Split::Compare);
        let (left, right) = divider.across(views, Split::CompareViews, "views handle");
        let (middle, right) = halves(right);
        Areas { world: Some(left), camera: Some(middle), second: Some(right), rest }
    },
    second: Some(SecondPicture::Ghost),
    rest: |ui, desk| {
        let (document, ghost) = (&desk.open.document, desk.session.ghost.as_ref());
        compare::ui(ui, desk.derived, document, ghost, desk.style, desk.actions);
    },
    ..Page::VIEWS
};

pub(super) const ANSWERS: Page = Page {
    areas: |divider| divider.three_above(Split::Answers),
    second: Some(SecondPicture::Answers),
    rest: |ui, desk| answers::ui(ui, desk.derived, desk.session, desk.actions),
    figure: Subject::Camera,
    ..Page::VIEWS
};

/// Returns the picture's name, on the screen and for screen readers.
pub(crate) fn name(second: SecondPicture) -> &'static str {
    match second {
        SecondPicture::ErrorMap => views::MAP,
        SecondPicture::WrongCamera => views::WRONG,
        SecondPicture::Ghost => views::GHOST,
        SecondPicture::Answers => views::ANSWERS,
    }
}

/// Shows the picture, or the reason why there is none, in `rect`, with its title above the area.
pub(crate) fn show(
    ui: &mut Ui,
    desk: &mut Desk<'_>,
    second: SecondPicture,
    [area, rect]: [Rect; 2],
) {
    let (derived, session) = (desk.derived, &mut *desk.session);
    let view = derived.second_view();
    let (mut spoken, mut why_not) = (None, None);
    match second {
        SecondPicture::ErrorMap => {
            accuracy::strip(ui, area, &mut session.settings);
            if let (Some(compared), Some(_)) = (derived.compared(), view) {
                spoken = Some(accuracy::summary(compared));
                accuracy::legend(ui, area, compared);
            }
            why_not = derived.too_many.map(|why| format!("No error map: {why}"));
        }
        SecondPicture::WrongCamera => {
            let mistakes_view = &mut session.mistakes_view;
            mistakes::strip(ui, area, mistakes_view);
            if let Some(wrong) = derived.wrong_camera() {
                spoken = Some(mistakes::spoken(wrong, mistakes_view));
                why_not = mistakes::why_not(wrong, mistakes_view);
            }
        }
        SecondPicture::Ghost => {
            compare::strip(ui, area, &mut session.ghost);
            spoken = Some(compare::spoken(derived.against_ghost()));
            why_not = Some(compare::why_not(session.ghost.as_ref()));
        }
        SecondPicture::Answers => {
            answers::strip(ui, area, session.answers.as_ref(), view.is_some());
            spoken = Some(answers::spoken(derived, session));
            why_not = Some(answers::why_not(derived, session).to_owned());
        }
    }
    if let Some(spoken) = spoken {
        views::speak(ui, name(second), &spoken);
    }
    match (view, why_not) {
        (Some(shown), _) => {
            views::show(ui, rect, shown, &mut desk.tools.second, derived.fault.is_some());
        }
        (None, Some(why)) => fault::no_picture(ui, rect, &why),
        (None, None) => {}
    }
}
