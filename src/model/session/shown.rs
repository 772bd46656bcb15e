//! What is shown of a document, and how: all that a lesson's step sets.

use pinhole_core::{Selection, Shade};
use pinhole_figure::typesetting::theme;
use pinhole_figure::{Concept, DerivationSections, Formulas, NumberStyle, Observer, OverlayItems};
use serde::{Deserialize, Serialize};

use crate::features::lines::LinesLab;
use crate::features::mistakes::MistakesView;
use crate::model::Ghost;
use crate::model::session::ViewLayout;

/// What is shown of a document, and how. A lesson's step is one, restoring it is an assignment, and a change of it
/// is a difference.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shown {
    /// The selected ray.
    pub selection: Selection,
    /// The observer of the world view; `None` until it is placed for the first time.
    pub observer: Option<Observer>,
    /// How it is shown.
    pub setup: Setup,
    /// The t of the movable point p + t d on the selected ray; `None` if no point is shown.
    pub ray_point_t: Option<f64>,
    /// The frozen camera with which the current one is compared.
    pub ghost: Option<Ghost>,
    /// The concept that is highlighted while the pointer is over no other one.
    pub highlighted: Option<Concept>,
    /// What the figure is directed to while presenting, before a line of the derivation is revealed; empty for the whole
    /// figure.
    pub subject: Vec<Concept>,
    /// The sections of the derivation that are shown.
    pub sections: DerivationSections,
    /// The lines to which the derivation is reduced; `None` for all lines of the shown sections.
    pub formulas: Option<Formulas>,
    /// What the recap has replaced, and replaces again when it ends; `None` if it was not asked for.
    pub before_recap: Option<BeforeRecap>,
    /// How many lines of the derivation are shown, from the first one; `None` if all are. The total number
    /// depends on the derivation.
    pub revealed_lines: Option<usize>,
    /// The state of the page *Lines*.
    pub lines: LinesLab,
    /// The comparison of a wrong camera with the right one.
    pub mistakes_view: MistakesView,
    /// True while the question of a lesson's step is not answered yet. No number is shown then.
    pub is_asking: bool,
    /// The concepts that the lesson's step mentions and whose handles or arrows are therefore shown; `None` if
    /// no lesson is open.
    pub spoken: Option<Vec<Concept>>,
}

with_defaults! {
    /// How a document is shown: the part of [`Shown`] that is kept across runs.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default)]
    pub struct Setup {
        /// The layout of the views.
        pub layout: ViewLayout = ViewLayout::Both,
        /// The items of the overlay.
        #[serde(rename = "shown")]
        pub items: OverlayItems = OverlayItems::default(),
        /// The shading of the pictures.
        pub shade: Shade = Shade::Lambert,
        /// True if rows and columns are counted from 1, as in the course.
        pub count_from_one: bool = false,
        /// Number of significant digits of the readouts.
        pub digits: usize = theme::DIGITS,
        /// True if distance, width and height of the viewport change together, so that the picture stays the
        /// same.
        pub keep_picture: bool = false,
        /// True if the teaching part of the camera panel is unfolded.
        pub teaching: bool = false,
    }
}

impl Setup {
    /// Returns the format in which numbers are written.
    pub fn number_style(&self) -> NumberStyle {
        NumberStyle { digits: self.digits, decimals: None, count_from_one: self.count_from_one }
    }
}

/// What is shown instead of the recap.
#[derive(Clone, Debug, PartialEq)]
pub struct BeforeRecap {
    layout: ViewLayout,
    formulas: Option<Formulas>,
    revealed_lines: Option<usize>,
}

impl Shown {
    /// Shows the recap from view to the ray, beside the picture; again, shows what it replaced.
    pub fn toggle_recap(&mut self) {
        let layout = &mut self.setup.layout;
        if let Some(before) = self.before_recap.take() {
            *layout = before.layout;
            (self.formulas, self.revealed_lines) = (before.formulas, before.revealed_lines);
            return;
        }
        let before = std::mem::replace(layout, ViewLayout::Derivation);
        self.before_recap = Some(BeforeRecap {
            layout: before,
            formulas: self.formulas.replace(Formulas::Recap),
            revealed_lines: self.revealed_lines.take(),
        });
    }

    /// Shows all lines of the derivation instead of the recap.
    pub fn end_recap(&mut self) {
        if let Some(before) = self.before_recap.take() {
            self.formulas = before.formulas;
        }
    }
}
