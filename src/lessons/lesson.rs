//! What a lesson's file says, read.

use pinhole_lecture::exercises::Exercise;
use pinhole_lecture::mistakes::Mistake;

use crate::document::Document;
use crate::ledger::LedgerSections;
use crate::lines::LinesLab;
use crate::observer::Observer;
use crate::overlay::OverlayItems;
use crate::play::Kind;
use crate::session::{Selection, ShadeName, ViewLayout};
use crate::thing::Thing;

/// A lesson: steps to go through.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// What it is about.
    pub title: String,
    /// At least one.
    pub steps: Vec<Step>,
}

/// One state of the window to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it is about.
    pub title: String,
    /// What to look at, or what to drag, with `*u*` for scalars and `**u**` for vectors.
    pub text: String,
    /// What is edited.
    pub document: Document,
    /// The step of the lesson that named the scene: steps of one scene are looked at from the same
    /// place, unless they say another one.
    pub scene_from: usize,
    /// The ray that is looked at closely.
    pub selection: Selection,
    /// The rest of how it is looked at.
    pub looks: Looks,
}

/// A question: the lecture's own of its kind, or the one of a seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AskedExercise {
    /// The kind.
    pub exercise: Exercise,
    /// The seed; the lecture's own numbers without one.
    pub seed: Option<u64>,
}

/// How a step is looked at; `None` is left alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Looks {
    /// Where the world view is seen from.
    pub observer: Option<Observer>,
    /// Which views are shown.
    pub layout: Option<ViewLayout>,
    /// What is drawn over the views.
    pub items: Option<OverlayItems>,
    /// How the pictures are coloured.
    pub shade: Option<ShadeName>,
    /// Rows and columns counted from 1.
    pub count_from_one: Option<bool>,
    /// Significant digits.
    pub digits: Option<usize>,
    /// Distance, width and height go together.
    pub keep_picture: Option<bool>,
    /// The camera panel's teaching part is unfolded.
    pub teaching: Option<bool>,
    /// The ledger's sections that are shown.
    pub ledger: Option<LedgerSections>,
    /// What is lit in the views and the ledger, or that nothing is.
    pub lit: Option<Option<Thing>>,
    /// The wrong camera that is shown beside the right one.
    pub mistake: Option<Mistake>,
    /// How far one has walked along the selected ray; `None` where nobody has.
    pub t: Option<f64>,
    /// The animation that is open, at its start.
    pub play: Option<Kind>,
    /// The lab of lines in two dimensions.
    pub lines: Option<LinesLab>,
    /// The question of the exercises layout.
    pub exercise: Option<AskedExercise>,
}
