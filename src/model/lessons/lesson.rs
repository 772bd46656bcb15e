//! The contents of a lesson file.

use pinhole_core::{Selection, Shade};
use pinhole_exchange::document::Document;
use pinhole_lecture::exercises::Exercise;
use pinhole_lecture::mistakes::Mistake;

use crate::model::concept::Concept;
use crate::model::derivation_sections::DerivationSections;
use crate::model::lines::LinesLab;
use crate::model::observer::Observer;
use crate::model::overlay_items::OverlayItems;
use crate::model::play::Kind;
use crate::model::session::ViewLayout;

/// A lesson: a list of steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The lesson's title.
    pub title: String,
    /// The steps; at least one.
    pub steps: Vec<Step>,
}

/// A state of the window to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The step's title.
    pub title: String,
    /// The instructions to look at or drag something, with `*u*` for scalars and `**u**` for
    /// vectors.
    pub text: String,
    /// The question that the class thinks about before anything is printed.
    pub question: Option<Question>,
    /// The document that the step opens.
    pub document: Document,
    /// Index of the step that named the scene: all steps of one scene share an observer unless they
    /// specify another.
    pub scene_from: usize,
    /// The selected ray.
    pub selection: Selection,
    /// The rest of the step's view.
    pub view: StepView,
}

/// A question to the class, and its answer, with the same marks as a step's text.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The question.
    pub ask: String,
    /// The answer, which takes the question's position.
    pub answer: String,
    /// The items of the overlay that would give the answer away.
    pub hidden: OverlayItems,
}

/// An exercise: the lecture's own question of its kind, or one with random numbers from a seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AskedExercise {
    /// The kind of question.
    pub exercise: Exercise,
    /// The seed of the numbers; `None` for the lecture's own numbers.
    pub seed: Option<u64>,
}

/// The view of a step; `None` leaves a field of the window unchanged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StepView {
    /// The observer of the world view.
    pub observer: Option<Observer>,
    /// The layout of the views.
    pub layout: Option<ViewLayout>,
    /// The items of the overlay.
    pub items: Option<OverlayItems>,
    /// The shading of the pictures.
    pub shade: Option<Shade>,
    /// True if rows and columns are counted from 1.
    pub count_from_one: Option<bool>,
    /// Number of significant digits.
    pub digits: Option<usize>,
    /// True if distance, width and height change together.
    pub keep_picture: Option<bool>,
    /// True if the teaching part of the camera panel is unfolded.
    pub teaching: Option<bool>,
    /// The sections of the derivation that are shown.
    pub derivation: Option<DerivationSections>,
    /// The concept that is highlighted in the views and the derivation; `Some(None)` highlights
    /// nothing.
    pub highlighted: Option<Option<Concept>>,
    /// The wrong camera beside the right one.
    pub mistake: Option<Mistake>,
    /// The parameter t of the point on the selected ray; `None` if there is no such point.
    pub t: Option<f64>,
    /// The animation that is open, at its start.
    pub play: Option<Kind>,
    /// The lab of lines in two dimensions.
    pub lines: Option<LinesLab>,
    /// The question of the exercises layout.
    pub exercise: Option<AskedExercise>,
}
