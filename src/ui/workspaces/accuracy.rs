//! The camera's picture, where another method errs in it, and error against run time.

use egui::{Rect, Ui, pos2};

use super::page::{Beside, Desk, Frame, Page};
use crate::figures::Subject;
use crate::model::files::title_of;
use crate::model::session::Split;
use crate::ui::scene::view_rects::{Areas, STRIP, halves};
use crate::ui::scene::views;
use crate::ui::tools::accuracy;

pub(super) const ACCURACY: Page = Page {
    areas: |divider| {
        let (views, rest) = divider.above(Split::Accuracy);
        // Below both, so that they are alike, room for the map's legend.
        let bottom = (views.bottom() - accuracy::LEGEND).max(views.top() + STRIP + 1.0);
        let (left, right) = halves(Rect::from_min_max(views.min, pos2(views.right(), bottom)));
        Areas { world: None, camera: Some(left), beside: Some(right), rest }
    },
    beside: Some(&Beside {
        name: views::MAP,
        derive: |sizes, size| sizes.map = Some(size),
        show: error_map,
    }),
    rest: |ui, desk| {
        let (document, measuring) = (&desk.open.document, &mut desk.tools.measuring);
        measuring.step(ui.ctx(), &title_of(desk.open.origin()), &document.camera, desk.derived);
        accuracy::ui(ui, measuring, desk.derived, document, desk.session);
    },
    figure: Subject::Camera,
    ..Page::VIEWS
};

fn error_map(ui: &mut Ui, desk: &mut Desk<'_>, Frame { area, rect }: Frame) {
    let derived = desk.derived;
    accuracy::strip(ui, area, &mut desk.session.settings);
    let is_dimmed = derived.fault.is_some();
    match (&derived.error_map, &derived.compared) {
        (Some(shown), Some(compared)) => {
            desk.picture(ui, rect, shown, is_dimmed);
            views::speak(ui, views::MAP, &accuracy::summary(compared));
            accuracy::legend(ui, area, compared);
        }
        _ => {
            if let Some(why) = derived.too_many {
                accuracy::no_map(ui, rect, why);
            }
        }
    }
}
