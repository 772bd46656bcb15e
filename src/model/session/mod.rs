//! The state of the window other than the document: what is shown of it, what is under the hand, and the user's
//! preferences.

use pinhole_core::methods::{Formula, Method, Precision};
use pinhole_core::steering::Keep;
use pinhole_core::{Camera, CameraError, ResolvedCamera, Selection};
use pinhole_figure::concept::Directed;
use pinhole_figure::overlay::GhostCamera;
use pinhole_figure::{Concept, HoverSource, Hovered, NumberStyle, Scheme};
use serde::{Deserialize, Serialize};

use crate::features::answers::StudentAnswers;
use crate::features::class::state::ClassCodes;
use crate::features::exercises::{Exercises, Progress};
use crate::features::handles::HandleState;
use crate::features::translator::Translator;
use crate::features::vote::OpenVote;
use crate::model::session::presenting::{PRESENTED_DECIMALS, Pen, Presenting, SMALLEST_TEXT};

pub use shown::{Setup, Shown};

pub use choices::{Split, Splits, TOOLS, ThemeName, ViewLayout, Workspace, shade_texts};

mod choices;
pub mod presenting;
mod shown;

/// The state of the window other than the document. A change to it never marks the document as edited.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Session {
    /// What is shown of the document, and how.
    pub shown: Shown,
    /// What is under the hand.
    pub live: Live,
    /// The open exercise and its answers.
    pub exercises: Exercises,
    /// The exercises that are done, which are kept across runs.
    pub progress: Progress,
    /// The codes of a class's answers.
    pub class: ClassCodes,
    /// A student's answers that are graded.
    pub answers: Option<StudentAnswers>,
    /// The state of presenter mode, while it is on.
    pub presenting: Option<Presenting>,
    /// The choices in the translator.
    pub translator: Translator,
    /// The preferences, which are kept across runs.
    pub preferences: Preferences,
}

/// What is of the moment, under the hand or in a scan: only the views show it, and it is not kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Live {
    /// The ray through the position under the pointer, which is shown instead of the selected one.
    pub pointed_ray: Option<Selection>,
    /// During a scan, the number of pixels that the camera's picture shows so far, counted row by row;
    /// `None` if it shows all.
    pub scanned_pixels: Option<u64>,
    /// The concept under the pointer or with the keyboard focus.
    pub hovered: Option<Hovered>,
    /// What the newest revealed line of the derivation is about, to which the figure is directed; `None` if lines are not
    /// revealed one by one.
    pub directed: Option<Directed>,
    /// The share of the arrows and lines of the newest line's concept that is drawn while they grow; `None` once they are
    /// whole.
    pub growth: Option<f64>,
    /// True while Alt is held. Pointing at a concept in a view then also dims everything else.
    pub alt_dims: bool,
    /// The pen for drawing over the views while presenting; `None` while it is not in use.
    pub pen: Option<Pen>,
    /// The vote on the step's question while it is asked; `None` if there is none.
    pub vote: Option<OpenVote>,
    /// The state of the handles.
    pub handles: HandleState,
}

/// Minimum and maximum number of significant digits of the readouts.
pub(crate) const DIGITS: (usize, usize) = (2, 17);

/// Minimum and maximum number of pixels that the loupe (the magnifier) shows across and down.
pub(crate) const LOUPE_PIXELS: (u32, u32) = (3, 15);

/// Minimum and maximum zoom of the window.
pub(crate) const ZOOM: (f32, f32) = (0.5, 4.0);

/// All settings that are kept across runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// How a document is shown.
    #[serde(flatten)]
    pub setup: Setup,
    /// The user's preferences.
    #[serde(flatten)]
    pub preferences: Preferences,
}

with_defaults! {
    /// The user's preferences, which no lesson changes.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default)]
    pub struct Preferences {
        /// Number of pixels that the loupe shows across and down; always odd.
        pub loupe_pixels: u32 = 5,
        /// True if the derivation writes short exact forms, such as 1/√2, instead of decimals.
        pub exact_forms: bool = true,
        /// True if the pixels keep their ratio of width to height when the viewport or the image changes.
        pub keep_pixel_shape: bool = true,
        /// True if up keeps the value that the user gave while eye and at are dragged, even if the view
        /// direction comes close to it.
        pub keep_up: bool = false,
        /// The quantity that stays fixed while the eye is dragged in the world view, such as at.
        pub eye_keeps: Keep = Keep::At,
        /// True if the side panel is hidden.
        pub hides_panel: bool = false,
        /// The sections of the panel that are unfolded.
        pub unfolded: Unfolded = Unfolded::default(),
        /// The boundaries between the window's areas.
        pub splits: Splits = Splits::default(),
        /// The method whose errors the error map shows.
        pub compared: Method = Method::Known(Formula::Textbook, Precision::F32),
        /// Dark, light, or the system's choice.
        pub theme: ThemeName = ThemeName::System,
        /// The colour scheme.
        pub scheme: Scheme = Scheme::Standard,
        /// True if nothing moves by itself: there are no transitions, and animations advance in whole
        /// steps.
        pub reduced_motion: bool = false,
        /// Minimum text size while presenting, in points of a window of 1024 × 768. In a larger window, the
        /// size grows in proportion.
        pub smallest_text: f32 = SMALLEST_TEXT.usual,
        /// True if the numbers are shown below the views while presenting.
        pub presents_numbers: bool = true,
        /// Zoom of the whole window.
        pub zoom: f32 = 1.0,
    }
}

with_defaults! {
    /// The collapsible parts of the window: each field is true if that part is unfolded.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(default)]
    pub struct Unfolded {
        /// *Eye*, orientation and experiments.
        pub camera: bool = true,
        /// The note on what to look for in the scene.
        pub note: bool = false,
        /// Viewport and image.
        pub viewport: bool = false,
        /// The selected ray.
        pub ray: bool = false,
        /// The scene's objects.
        pub objects: bool = false,
        /// True if all numbers are shown; otherwise only the most important ones are.
        pub numbers: bool = false,
    }
}

impl Settings {
    /// Returns the settings with every value clamped to its range. The settings come from a file that
    /// anyone may have edited.
    #[must_use]
    pub fn in_range(mut self) -> Settings {
        let finite = |x: f32, otherwise: f32| if x.is_finite() { x } else { otherwise };
        let Settings { setup, preferences: now } = &mut self;
        let default = Preferences::default();
        setup.digits = setup.digits.clamp(DIGITS.0, DIGITS.1);
        now.loupe_pixels = now.loupe_pixels.clamp(LOUPE_PIXELS.0, LOUPE_PIXELS.1) | 1;
        now.smallest_text = finite(now.smallest_text, default.smallest_text)
            .clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
        now.zoom = finite(now.zoom, default.zoom).clamp(ZOOM.0, ZOOM.1);
        self
    }
}

impl Session {
    /// Returns all settings that are kept across runs.
    pub fn settings(&self) -> Settings {
        Settings { setup: self.shown.setup, preferences: self.preferences }
    }

    /// Returns the concept that both views and the derivation highlight: the one under the pointer, that of the newest
    /// revealed line, or that of the lesson's step.
    pub fn highlighted(&self) -> Option<Concept> {
        let directed = self.live.directed.map(|directed| directed.concept);
        let hovered = self.live.hovered.map(|hovered| hovered.concept);
        hovered.or(directed).or(self.shown.highlighted)
    }

    /// Returns the concepts that the lesson's step mentions, and those that are highlighted.
    pub fn spoken_of(&self) -> Vec<Concept> {
        let spoken = self.shown.spoken.iter().flatten().copied();
        spoken.chain(self.highlighted()).chain(self.shown.highlighted).collect()
    }

    /// Returns true if everything except the highlighted concept is dimmed. It always is if the derivation
    /// or a lesson's step highlights the concept; if the user points at the concept in a view, only while
    /// Alt is held.
    pub fn dims(&self) -> bool {
        self.live.alt_dims
            || self.live.hovered.is_none_or(|hovered| hovered.by == HoverSource::Derivation)
    }

    /// Returns the ray that is shown: the one under the pointer, or else the selected one.
    pub fn shown_selection(&self) -> Selection {
        self.live.pointed_ray.unwrap_or(self.shown.selection)
    }

    /// Returns the format in which numbers are written.
    pub fn number_style(&self) -> NumberStyle {
        let decimals = self.presenting.map(|_| PRESENTED_DECIMALS);
        NumberStyle { decimals, ..self.shown.setup.number_style() }
    }

    /// Returns the ghost that is drawn beside the camera `now`; `None` if no camera is frozen, or if it is invalid.
    pub fn frozen_ghost(&self, now: &Camera) -> Option<GhostCamera> {
        resolve(&self.shown.ghost?.camera, now).ok().as_ref().map(GhostCamera::frozen)
    }

    /// Returns true if an exercise is on the stage. While a lesson asks its own question, none is.
    pub fn shows_exercise(&self) -> bool {
        self.shown.setup.layout == ViewLayout::Exercises && !self.shown.is_asking
    }

    /// Checks the answers to the open exercise.
    pub(crate) fn check_exercise(&mut self) {
        self.exercises.check();
        self.progress.note(&self.exercises);
    }

    /// Returns true if a vote (on the mistake in a picture) is open or is about to open.
    pub fn shows_vote(&self) -> bool {
        let view = &self.shown.mistakes_view;
        self.shown.setup.layout == ViewLayout::Mistakes
            && (view.open_vote.is_some() || view.wants_vote)
    }

    /// Returns true if a vote is open whose right option is not shown yet.
    pub fn is_voting(&self) -> bool {
        let is_open = self.live.vote.as_ref().is_some_and(|open| !open.is_revealed);
        is_open || (self.shows_vote() && !self.shown.mistakes_view.is_revealed())
    }

    /// Returns true if a step's question is open, on which no vote was opened yet.
    pub fn can_vote(&self) -> bool {
        self.shown.is_asking && self.live.vote.is_none() && !self.is_voting()
    }

    /// Adapts the selection to an edited camera, so that it stays at the same place in the picture.
    pub fn follow_camera(&mut self, before: &Camera, now: &Camera) {
        let selection = &mut self.shown.selection;
        *selection = selection.in_another_image(before.image, now.image);
        if self.shown.setup.keep_picture {
            *selection = selection.in_another_viewport(before.viewport, now.viewport);
        }
    }
}

/// A frozen camera, with which the current one is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// The camera as given.
    pub camera: Camera,
    /// True if a map of the pixels in which the two cameras see different objects is shown instead of the
    /// ghost's picture.
    pub shows_differences: bool,
}

/// Resolves the ghost (the frozen camera) with the image size of the camera `now`: the comparison, pixel by
/// pixel, requires equal sizes.
///
/// # Errors
/// Returns an error if the ghost is an invalid camera.
pub fn resolve(ghost: &Camera, now: &Camera) -> Result<ResolvedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.resolve()
}
