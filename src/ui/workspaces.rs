//! The pages of the workspaces: what the window shows in each layout, and where. A new layout needs a
//! [`Page`] here, a line in [`page`], and a row in the model's table of layouts.

use egui::{Align, Layout, RichText, TextWrapMode, Ui, UiBuilder, vec2};
use pinhole_figure::HoverSource;
use pinhole_figure::typesetting::theme::{self, STACKED};

use crate::features::export::order::FigureSubject;
use crate::features::{accuracy, answers, class, lines, mistakes, plot, translator};
use crate::model::session::{Split, ViewLayout};
use crate::ui::scene::view_rects::{
    Areas, Divider, STRIP, figure_and_column, figure_and_numbers, halves, no_views, stack_beside,
};
use crate::ui::scene::{compare, readouts};
use crate::ui::widgets::{clipped, inside};
use crate::ui::{PageContext, derivation};
use crate::view::derive::SecondPicture;

/// A page of a workspace.
pub(crate) struct Page {
    /// True if the side panel with camera and objects is shown.
    pub(crate) has_panel: bool,
    /// True if the page is about the ray under the pointer rather than the selected ray.
    pub(crate) follows_pointer: bool,
    /// Lays out the page's parts.
    pub(crate) areas: fn(&mut Divider<'_>) -> Areas,
    /// The second picture, if the page has one.
    pub(crate) second: Option<SecondPicture>,
    /// Shows the rest of the page, which is below the views, next to them or in their place.
    pub(crate) rest: fn(&mut Ui, &mut PageContext<'_>),
    /// What in `rest` lights its concept, such as a vector or an object, in the views while the pointer or the
    /// keyboard focus is on it.
    pub(crate) lights: Option<HoverSource>,
    /// The subject of the page's figure.
    pub(crate) figure: FigureSubject,
}

/// Size of the text that replaces hidden content, in points.
const HIDDEN: f32 = 16.0;

impl Page {
    /// The default page: both views and nothing else.
    pub(crate) const VIEWS: Page = Page {
        has_panel: true,
        follows_pointer: false,
        areas: figure_and_column,
        second: None,
        rest: |_, _| (),
        lights: None,
        figure: FigureSubject::World,
    };

    /// Both views and a few numbers, or all of them.
    const BOTH: Page = Page {
        follows_pointer: true,
        areas: figure_and_numbers,
        rest: numbers,
        lights: Some(HoverSource::Numbers),
        ..Page::VIEWS
    };

    /// The derivation beside both views.
    const DERIVATION: Page = Page {
        follows_pointer: true,
        areas: stack_beside,
        rest: derivation::ui,
        lights: Some(HoverSource::Derivation),
        figure: FigureSubject::Derivation,
        ..Page::VIEWS
    };

    /// A page that is not about the scene: without views and side panel.
    const ALONE: Page = Page { has_panel: false, areas: no_views, ..Page::VIEWS };
}

/// Returns the page of a layout.
pub(crate) fn page(layout: ViewLayout) -> Page {
    match layout {
        ViewLayout::Both => Page::BOTH,
        ViewLayout::World => {
            Page { areas: |divider| divider.figure_and_foot(true), rest: foot, ..Page::BOTH }
        }
        ViewLayout::Camera => Page {
            areas: |divider| divider.figure_and_foot(false),
            rest: foot,
            figure: FigureSubject::Camera,
            ..Page::BOTH
        },
        ViewLayout::Derivation => Page::DERIVATION,
        ViewLayout::DerivationAlone => Page { areas: no_views, ..Page::DERIVATION },
        ViewLayout::Plot => Page {
            follows_pointer: true,
            areas: above_graph,
            rest: plot::ui::ui,
            lights: Some(HoverSource::Derivation),
            ..Page::VIEWS
        },
        ViewLayout::Lines => {
            Page { rest: lines::ui::ui, figure: FigureSubject::Lines, ..Page::ALONE }
        }
        ViewLayout::Mistakes => Page {
            areas: |divider| divider.three_above(Split::Mistakes),
            second: Some(SecondPicture::WrongCamera),
            rest: mistakes::ui::ui,
            figure: FigureSubject::Camera,
            ..Page::VIEWS
        },
        ViewLayout::Compare => Page {
            areas: |divider| divider.three_above(Split::Compare),
            second: Some(SecondPicture::Ghost),
            rest: compare::ui,
            ..Page::VIEWS
        },
        ViewLayout::Translator => {
            Page { areas: stack_beside, rest: translator::ui::ui, ..Page::VIEWS }
        }
        ViewLayout::Exercises => Page { lights: Some(HoverSource::Derivation), ..Page::ALONE },
        ViewLayout::Answers => Page {
            areas: |divider| divider.three_above(Split::Answers),
            second: Some(SecondPicture::Answers),
            rest: answers::ui::ui,
            figure: FigureSubject::Camera,
            ..Page::VIEWS
        },
        ViewLayout::Class => Page { rest: class::ui::ui, ..Page::ALONE },
        ViewLayout::Accuracy => Page {
            areas: above_methods,
            second: Some(SecondPicture::ErrorMap),
            rest: accuracy::ui::ui,
            figure: FigureSubject::Camera,
            ..Page::VIEWS
        },
    }
}

/// Puts both views side by side above the graph.
fn above_graph(divider: &mut Divider<'_>) -> Areas {
    if divider.whole.width() < STACKED {
        return stack_beside(divider);
    }
    let (views, rest) = divider.above(Split::Plot);
    let (left, right) = divider.across(views, Split::Views, "views handle");
    Areas { world: Some(left), camera: Some(right), second: None, rest }
}

/// Puts the camera view and the error map above the methods. Both leave space for the map's legend, so that they
/// have the same size.
fn above_methods(divider: &mut Divider<'_>) -> Areas {
    let (views, rest) = divider.above(Split::Accuracy);
    let bottom = (views.bottom() - accuracy::ui::LEGEND).max(views.top() + STRIP + 1.0);
    let (left, right) = halves(views.with_max_y(bottom));
    Areas { world: None, camera: Some(left), second: Some(right), rest }
}

/// Shows, in place of a page, a message that the answer is hidden, if there is room. Shows nothing while
/// presenting, when a dot tells the lecturer.
pub(crate) fn hidden(ui: &mut Ui) {
    if theme::installed(ui.ctx()).presenting {
        return;
    }
    let room = ui.available_height();
    if room > ui.spacing().interact_size.y {
        ui.centered_and_justified(|ui| {
            ui.label(RichText::new("Hidden until you show the answer").size(HIDDEN).weak())
        });
    }
}

/// Distance of the numbers at a figure's foot from its left and right edges, in points.
const BESIDE_NUMBERS: f32 = 8.0;
/// Height of the row below the numbers of the column, in points.
const BELOW_NUMBERS: f32 = 26.0;

/// Shows the numbers of the page with both views: in the column, one per line, or all of them.
fn numbers(ui: &mut Ui, context: &mut PageContext<'_>) {
    if context.session.presenting.is_some() {
        if context.session.preferences.presents_numbers {
            readouts::column(ui, context);
        }
        return;
    }
    if context.session.preferences.unfolded.numbers {
        ui.horizontal_wrapped(|ui| {
            fewer(ui, context);
            readouts::work(ui, context.derived);
        });
        return readouts::ui(ui, context);
    }
    let whole = ui.available_rect_before_wrap();
    let (above, below) = whole.split_top_bottom_at_y(whole.bottom() - BELOW_NUMBERS);
    clipped(ui, above, |ui| readouts::column(ui, context));
    inside(ui, below, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        few(ui, context, |ui, context| readouts::left_out(ui, context.derived));
    });
}

/// Shows a few numbers, with the button for all of them on their right.
fn few(ui: &mut Ui, context: &mut PageContext<'_>, numbers: fn(&mut Ui, &PageContext<'_>)) {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let button = ui.small_button("All numbers");
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| numbers(ui, context));
        context.session.preferences.unfolded.numbers |= button.clicked();
    });
}

/// Shows the button that leaves only a few of all numbers.
fn fewer(ui: &mut Ui, context: &mut PageContext<'_>) {
    context.session.preferences.unfolded.numbers = !ui.small_button("Fewer numbers").clicked();
}

/// Shows the numbers at the foot of the main figure: one line of them, or all.
pub(crate) fn foot(ui: &mut Ui, context: &mut PageContext<'_>) {
    let area = ui.available_rect_before_wrap();
    let inner = UiBuilder::new().max_rect(area.shrink2(vec2(BESIDE_NUMBERS, 0.0)));
    let ui = &mut ui.new_child(inner);
    let shows_all = context.session.preferences.unfolded.numbers;
    if context.session.presenting.is_some() || area.width() <= readouts::LEAST {
        readouts::band(ui, context);
    } else if shows_all && area.height() > readouts::BAND {
        fewer(ui, context);
        readouts::ui(ui, context);
    } else {
        few(ui, context, readouts::band);
    }
}
