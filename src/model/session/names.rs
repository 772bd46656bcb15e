//! Settings that are one of several, in the form in which they are written to disk.

use pinhole_core::Shade;
use pinhole_core::methods::Method;
use pinhole_core::steering::Keep;
use serde::{Deserialize, Serialize};

/// Which of the two views are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum ViewLayout {
    /// Side by side.
    #[default]
    Both,
    /// The world view alone.
    World,
    /// The camera view alone.
    Camera,
    /// The camera view, where another method errs in it, and error against run time.
    Accuracy,
    /// Both views, and what a frame takes and leaves out.
    Frame,
    /// Both views, one above the other, and the derivation of every number beside them.
    Derivation,
    /// The derivation of every number alone.
    DerivationAlone,
    /// Both views, and every object's f(p + t d) against t below them.
    Plot,
    /// Lines in two dimensions, implicit and parametric.
    Lines,
    /// The right picture beside that of a classic wrong camera.
    Mistakes,
    /// World view, camera view and what the ghost sees, and both cameras in numbers.
    Compare,
    /// The camera in other programs' terms, beside both views.
    Translator,
    /// Questions with fields for the answers.
    Exercises,
    /// The camera's picture, and where a student's answers are wrong in it.
    Answers,
}

impl ViewLayout {
    /// Those that one chooses from; the derivation alone is for presenting, and answers are there only
    /// once there are some.
    pub const LISTED: [ViewLayout; 12] = [
        ViewLayout::Both,
        ViewLayout::World,
        ViewLayout::Camera,
        ViewLayout::Derivation,
        ViewLayout::Plot,
        ViewLayout::Lines,
        ViewLayout::Mistakes,
        ViewLayout::Compare,
        ViewLayout::Translator,
        ViewLayout::Exercises,
        ViewLayout::Accuracy,
        ViewLayout::Frame,
    ];

    /// Whether it is about the camera and what it looks at, so that both can be edited beside it.
    pub fn shows_the_scene(self) -> bool {
        !matches!(self, ViewLayout::Lines | ViewLayout::Exercises)
    }

    /// What it is called.
    pub fn label(self) -> &'static str {
        match self {
            ViewLayout::Both => "Both views",
            ViewLayout::World => "World",
            ViewLayout::Camera => "Camera",
            ViewLayout::Derivation => "Derivation",
            ViewLayout::DerivationAlone => "Derivation alone",
            ViewLayout::Plot => "Plot",
            ViewLayout::Lines => "Lines",
            ViewLayout::Mistakes => "Mistakes",
            ViewLayout::Compare => "Compare",
            ViewLayout::Translator => "Translator",
            ViewLayout::Exercises => "Exercises",
            ViewLayout::Answers => "Answers",
            ViewLayout::Accuracy => "Accuracy",
            ViewLayout::Frame => "Frame",
        }
    }

    /// What it shows.
    pub fn about(self) -> &'static str {
        match self {
            ViewLayout::Both => "World view and camera view side by side",
            ViewLayout::World => "The world view alone",
            ViewLayout::Camera => "The camera view alone",
            ViewLayout::Derivation => "Every number's derivation, line by line",
            ViewLayout::DerivationAlone => "Every number's derivation, without the views",
            ViewLayout::Plot => "Every object's f(p + t d) against t",
            ViewLayout::Lines => "Implicit and parametric lines in two dimensions",
            ViewLayout::Mistakes => "The classic wrong cameras beside the right one",
            ViewLayout::Compare => "The camera against the one that was frozen by G",
            ViewLayout::Translator => "The camera in other programs’ terms",
            ViewLayout::Exercises => "Questions, and what is wrong with an answer",
            ViewLayout::Answers => "A student’s answers, and the mistake that explains them",
            ViewLayout::Accuracy => "How right each method is here, and how fast",
            ViewLayout::Frame => "What the pictures left out, and what was left to do",
        }
    }

    /// Whether the derivation is on the screen.
    pub fn shows_derivation(self) -> bool {
        matches!(self, ViewLayout::Derivation | ViewLayout::DerivationAlone)
    }
}

impl ShadeName {
    /// All of them.
    pub const ALL: [ShadeName; 4] =
        [ShadeName::Lambert, ShadeName::Normal, ShadeName::T, ShadeName::Object];

    /// What its colours mean.
    pub fn about(self) -> &'static str {
        match self {
            ShadeName::Lambert => "Lit from the eye",
            ShadeName::Normal => "The normal's x, y, z as red, green, blue",
            ShadeName::T => "Nearest t white, farther darker",
            ShadeName::Object => "Each object's own colour, flat",
        }
    }
}

impl ThemeName {
    /// All of them.
    pub const ALL: [ThemeName; 3] = [ThemeName::System, ThemeName::Dark, ThemeName::Light];

    /// What a menu calls it.
    pub fn label(self) -> &'static str {
        match self {
            ThemeName::System => "As the system",
            ThemeName::Dark => "Dark",
            ThemeName::Light => "Light",
        }
    }
}

/// [`Method`], in a form that is written to disk: its name. One that no method has any more is the
/// ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "String", into = "&'static str")]
pub struct MethodName(pub Method);

impl From<String> for MethodName {
    fn from(name: String) -> MethodName {
        MethodName(Method::from_name(&name).unwrap_or(Method::Ladder))
    }
}

impl From<MethodName> for &'static str {
    fn from(name: MethodName) -> &'static str {
        name.0.name()
    }
}

/// [`Shade`], in a form that is written to disk.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the same names as pinhole_core::Shade, explained there")]
pub enum ShadeName {
    #[default]
    Lambert,
    Normal,
    T,
    Object,
}

/// [`Keep`], in a form that is written to disk.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the same names as pinhole_core::steering::Keep, explained there")]
pub enum EyeKeeps {
    #[default]
    At,
    View,
}

impl EyeKeeps {
    /// The other one.
    #[must_use]
    pub fn other(self) -> EyeKeeps {
        match self {
            EyeKeeps::At => EyeKeeps::View,
            EyeKeeps::View => EyeKeeps::At,
        }
    }
}

impl From<EyeKeeps> for Keep {
    fn from(keeps: EyeKeeps) -> Keep {
        match keeps {
            EyeKeeps::At => Keep::At,
            EyeKeeps::View => Keep::View,
        }
    }
}

/// The window's colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum ThemeName {
    /// As the system says; dark where it says nothing.
    #[default]
    System,
    /// Dark.
    Dark,
    /// Light.
    Light,
}

impl From<ShadeName> for Shade {
    fn from(name: ShadeName) -> Shade {
        match name {
            ShadeName::Lambert => Shade::Lambert,
            ShadeName::Normal => Shade::Normal,
            ShadeName::T => Shade::T,
            ShadeName::Object => Shade::Object,
        }
    }
}

impl From<Shade> for ShadeName {
    fn from(shade: Shade) -> ShadeName {
        match shade {
            Shade::Lambert => ShadeName::Lambert,
            Shade::Normal => ShadeName::Normal,
            Shade::T => ShadeName::T,
            Shade::Object => ShadeName::Object,
        }
    }
}
