//! The workspaces' pages, a file each, and the table of them: what a layout of the window shows and where. A
//! new one is a file here, a line in [`page`], and a row in the model's table of layouts.

mod derivation;
mod exercises;
mod lines;
mod page;
mod plot;
pub(crate) mod second_picture;
mod translator;
mod views;

pub(crate) use self::page::{Desk, Page, Tools};

use crate::model::session::ViewLayout;

/// Returns the page of a layout.
pub(crate) fn page(layout: ViewLayout) -> &'static Page {
    match layout {
        ViewLayout::Both => &views::BOTH,
        ViewLayout::World => &views::WORLD,
        ViewLayout::Camera => &views::CAMERA,
        ViewLayout::Derivation => &derivation::DERIVATION,
        ViewLayout::DerivationAlone => &derivation::ALONE,
        ViewLayout::Plot => &plot::PLOT,
        ViewLayout::Lines => &lines::LINES,
        ViewLayout::Mistakes => &second_picture::MISTAKES,
        ViewLayout::Compare => &second_picture::COMPARE,
        ViewLayout::Translator => &translator::TRANSLATOR,
        ViewLayout::Exercises => &exercises::EXERCISES,
        ViewLayout::Answers => &second_picture::ANSWERS,
        ViewLayout::Accuracy => &second_picture::ACCURACY,
    }
}
