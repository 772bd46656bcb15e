//! The state of a document's views, which a scene file does not store, and the settings.

use pinhole_core::methods::{Formula, Method, Precision};
use pinhole_core::steering::Keep;
use pinhole_core::{Camera, CameraError, ResolvedCamera, Selection, Shade};
use serde::{Deserialize, Serialize};

use crate::model::session::presenting::{Pen, Presenting, SMALLEST_TEXT};
use crate::model::{
    Concept, DerivationSections, Exercises, HandleState, HoverSource, Hovered, LinesLab,
    MistakesView, Observer, OverlayItems, StudentAnswers, Translator,
};

pub use choices::{
    Scheme, Split, Splits, TOOLS, ThemeName, ViewLayout, Workspace, shade_about, shade_label,
};

mod choices;
pub mod handles;
pub mod presenting;

/// Everything about the window that is not the document. A change to it never marks the document as
/// edited.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Session {
    /// The selected ray.
    pub selection: Selection,
    /// The ray under the pointer, which is shown in place of the selected one.
    pub pointed_ray: Option<Selection>,
    /// The observer of the world view; `None` until it is framed for the first time.
    pub observer: Option<Observer>,
    /// The t of the point p + t d that moves along the selected ray; `None` if there is none.
    pub ray_point_t: Option<f64>,
    /// Number of pixels that the camera's picture shows so far, row by row; `None` shows all.
    pub scanned_pixels: Option<u64>,
    /// The camera to compare with.
    pub ghost: Option<Ghost>,
    /// The lab of lines in two dimensions.
    pub lines: LinesLab,
    /// The concept that the mouse or the keyboard points at.
    pub hovered: Option<Hovered>,
    /// The concept that is highlighted while none is hovered.
    pub highlighted: Option<Concept>,
    /// True while Alt is held: pointing at a concept in the views dims everything else.
    pub alt_dims: bool,
    /// True while the question of a lesson's step waits for its answer: no number is shown.
    pub is_asking: bool,
    /// The concepts with handles that the lesson's step mentions; `None` while no lesson is open.
    pub spoken: Option<Vec<Concept>>,
    /// The sections of the derivation that are shown.
    pub sections: DerivationSections,
    /// The number of the derivation's lines that are shown, counted from the first one; `None`
    /// shows all. The derivation determines how many lines there are.
    pub revealed_lines: Option<usize>,
    /// The comparison of a wrong camera with the right one.
    pub mistakes_view: MistakesView,
    /// The open exercise and its answers.
    pub exercises: Exercises,
    /// A student's answers, to be graded.
    pub answers: Option<StudentAnswers>,
    /// Presenter mode, while it is on.
    pub presenting: Option<Presenting>,
    /// True if everything but the pointer's surroundings is dimmed.
    pub spotlight: bool,
    /// The pen that draws over the views while presenting; `None` while it is not in use.
    pub pen: Option<Pen>,
    /// The state of the handles.
    pub handles: HandleState,
    /// The choices in the translator.
    pub translator: Translator,
    /// The settings, which are kept across runs.
    pub settings: Settings,
}

/// Minimum and maximum number of significant digits of the readouts.
pub(crate) const DIGITS: (usize, usize) = (2, 17);

/// Minimum and maximum number of pixels that the loupe shows across and down.
pub(crate) const LOUPE_PIXELS: (u32, u32) = (3, 15);

/// Minimum and maximum zoom of the window.
pub(crate) const ZOOM: (f32, f32) = (0.5, 4.0);

/// Preferences, kept across runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// The layout of the views.
    pub layout: ViewLayout,
    /// The shading of the pictures.
    pub shade: Shade,
    /// The items of the overlay.
    pub items: OverlayItems,
    /// Number of pixels that the loupe shows across and down; odd.
    pub loupe_pixels: u32,
    /// Significant digits of the readouts.
    pub digits: usize,
    /// True if the derivation writes short exact forms, such as 1/√2, in place of decimals.
    pub exact_forms: bool,
    /// True if rows and columns are counted from 1, as in the course.
    pub count_from_one: bool,
    /// True if a change of viewport or image keeps the pixels' shape.
    pub keep_pixel_shape: bool,
    /// True if distance, width and height change together, so that the picture stays the same.
    pub keep_picture: bool,
    /// True if up stays as given while eye and at are dragged, even if the view comes near it.
    pub keep_up: bool,
    /// The quantity that stays the same when the eye is moved in the world view.
    pub eye_keeps: Keep,
    /// True if the camera panel's part for teaching is unfolded.
    pub teaching: bool,
    /// True if the side panel is hidden.
    pub hides_panel: bool,
    /// The sections of the panel that are unfolded.
    pub unfolded: Unfolded,
    /// The boundaries between the window's areas.
    pub splits: Splits,
    /// True if the plot of f(p + t d) compresses values beyond 1 unit.
    pub plot_compressed: bool,
    /// The method that draws the camera's picture: the ladder, unless the user wants to see another
    /// method's errors.
    pub method: Method,
    /// The method of the error map.
    pub compared: Method,
    /// Dark, light, or the system's choice.
    pub theme: ThemeName,
    /// The colour scheme.
    pub scheme: Scheme,
    /// True if nothing moves by itself: there are no transitions, and animations advance in steps.
    pub reduced_motion: bool,
    /// Minimum text size while presenting, in points of a window of 1024 × 768; in a larger window
    /// it is larger in proportion.
    pub smallest_text: f32,
    /// True if the numbers are shown below the views while presenting.
    pub presents_numbers: bool,
    /// Zoom of the whole window.
    pub zoom: f32,
}

/// The sections of the side panel that are unfolded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Unfolded {
    /// The note on what to look for in the scene.
    pub note: bool,
    /// Viewport and image.
    pub viewport: bool,
    /// The selected ray.
    pub ray: bool,
    /// The scene's objects.
    pub objects: bool,
    /// True if all numbers are shown below the views rather than one line of them.
    pub numbers: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            layout: ViewLayout::Both,
            shade: Shade::Lambert,
            items: OverlayItems::default(),
            loupe_pixels: 9,
            digits: 5,
            exact_forms: true,
            count_from_one: false,
            keep_pixel_shape: true,
            keep_picture: false,
            keep_up: false,
            eye_keeps: Keep::At,
            teaching: false,
            hides_panel: false,
            unfolded: Unfolded::default(),
            splits: Splits::default(),
            plot_compressed: false,
            method: Method::Ladder,
            compared: Method::Known(Formula::Textbook, Precision::F32),
            theme: ThemeName::System,
            scheme: Scheme::Standard,
            reduced_motion: false,
            smallest_text: SMALLEST_TEXT.usual,
            presents_numbers: true,
            zoom: 1.0,
        }
    }
}

impl Settings {
    /// Returns the settings with every value clamped to its range, because they come from a file
    /// that anyone may have edited.
    #[must_use]
    pub fn in_range(mut self) -> Settings {
        let finite = |x: f32, otherwise: f32| if x.is_finite() { x } else { otherwise };
        let default = Settings::default();
        self.digits = self.digits.clamp(DIGITS.0, DIGITS.1);
        self.loupe_pixels = self.loupe_pixels.clamp(LOUPE_PIXELS.0, LOUPE_PIXELS.1) | 1;
        self.smallest_text = finite(self.smallest_text, default.smallest_text)
            .clamp(SMALLEST_TEXT.least, SMALLEST_TEXT.most);
        self.zoom = finite(self.zoom, default.zoom).clamp(ZOOM.0, ZOOM.1);
        self
    }
}

impl Session {
    /// Returns the concept that both views and the derivation highlight.
    pub fn highlighted(&self) -> Option<Concept> {
        self.hovered.map(|hovered| hovered.concept).or(self.highlighted)
    }

    /// Returns the concepts that the step mentions or that are highlighted.
    pub fn spoken_of(&self) -> Vec<Concept> {
        let spoken = self.spoken.iter().flatten().copied();
        spoken.chain(self.highlighted()).chain(self.highlighted).collect()
    }

    /// Returns true if everything but the highlighted concept is dimmed. The derivation and a
    /// lesson's step dim everything else; pointing in a view does so only while Alt is held.
    pub fn dims(&self) -> bool {
        self.alt_dims || self.hovered.is_none_or(|hovered| hovered.by == HoverSource::Derivation)
    }

    /// Returns the ray that is shown: the one under the pointer, or else the selected one.
    pub fn shown_selection(&self) -> Selection {
        self.pointed_ray.unwrap_or(self.selection)
    }

    /// Returns true if a vote on a wrong picture is shown, or is about to be.
    pub fn shows_vote(&self) -> bool {
        let view = &self.mistakes_view;
        self.settings.layout == ViewLayout::Mistakes
            && (view.open_vote.is_some() || view.wants_vote)
    }

    /// Keeps the selected position at the same place in the picture after an edit of the camera.
    pub fn follow_camera(&mut self, before: &Camera, now: &Camera) {
        self.selection = self.selection.in_another_image(before.image, now.image);
        if self.settings.keep_picture {
            self.selection = self.selection.in_another_viewport(before.viewport, now.viewport);
        }
    }
}

/// A frozen camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// The camera as given.
    pub camera: Camera,
    /// True if the ghost's picture is replaced by the map of the pixels that see another object.
    pub shows_differences: bool,
}

/// Resolves the ghost with the current camera's image size, which the comparison needs.
///
/// # Errors
/// Returns an error if the ghost is an invalid camera.
pub fn resolve(ghost: &Camera, now: &Camera) -> Result<ResolvedCamera, CameraError> {
    Camera { image: now.image, ..*ghost }.resolve()
}
