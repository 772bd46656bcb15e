//! Both views, and what a frame takes and leaves out.

use super::page::Page;
use crate::model::session::Split;
use crate::ui::tools::frame;

pub(super) const FRAME: Page = Page {
    areas: |divider| divider.both_above(Split::Frame),
    rest: |ui, desk| frame::ui(ui, desk.derived),
    ..Page::VIEWS
};
