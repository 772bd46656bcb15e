//! World view, camera view and what the ghost sees, and both cameras in numbers.

use egui::Ui;

use super::page::{Beside, Desk, Frame, Page};
use crate::model::session::Split;
use crate::ui::scene::view_rects::{Areas, halves};
use crate::ui::scene::{compare, views};

pub(super) const COMPARE: Page = Page {
    areas: |divider| {
        let (views, rest) = divider.above(Split::Compare);
        let (left, right) = divider.across(views, Split::CompareViews, "views handle");
        let (middle, right) = halves(right);
        Areas { world: Some(left), camera: Some(middle), beside: Some(right), rest }
    },
    beside: Some(&Beside {
        name: views::GHOST,
        derive: |sizes, size| sizes.ghost = Some(size),
        show: ghost,
    }),
    rest: |ui, desk| {
        let (document, ghost) = (&desk.open.document, desk.session.ghost.as_ref());
        compare::ui(ui, desk.derived, document, ghost, desk.style, desk.actions);
    },
    ..Page::VIEWS
};

fn ghost(ui: &mut Ui, desk: &mut Desk<'_>, Frame { area, rect }: Frame) {
    let derived = desk.derived;
    compare::strip(ui, area, &mut desk.session.ghost);
    views::speak(ui, views::GHOST, &compare::spoken(derived.against_ghost.as_deref()));
    match &derived.ghost_view {
        Some(shown) => desk.picture(ui, rect, shown, false),
        None => compare::no_picture(ui, rect, desk.session.ghost.as_ref()),
    }
}
