//! Settings that are one of several, in the form in which they are written to disk.

use pinhole_core::Shade;
use pinhole_core::methods::Method;
use pinhole_core::steering::Keep;
use serde::{Deserialize, Serialize};

/// The layouts, a row each: how a lesson's step names it, if it can, what it is called, and what it
/// shows.
macro_rules! layouts {
    ($($layout:ident: $name:expr, $label:literal, $about:literal;)*) => {
        /// What the window shows of the scene, and beside it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        pub enum ViewLayout {
            $(#[doc = concat!($about, ".")] $layout),*
        }

        impl ViewLayout {
            /// All of them.
            pub const ALL: &[ViewLayout] = &[$(ViewLayout::$layout),*];

            /// What a lesson's step calls it; none that has no place in a lesson.
            pub fn name(self) -> Option<&'static str> {
                match self {
                    $(ViewLayout::$layout => $name),*
                }
            }

            /// What it is called.
            pub fn label(self) -> &'static str {
                match self {
                    $(ViewLayout::$layout => $label),*
                }
            }

            /// What it shows.
            pub fn about(self) -> &'static str {
                match self {
                    $(ViewLayout::$layout => $about),*
                }
            }
        }
    };
}

layouts! {
    Both: Some("both"), "Both", "World view and camera view side by side";
    World: Some("world"), "World", "The world view alone";
    Camera: Some("camera"), "Camera", "The camera view alone";
    Derivation: Some("derivation"), "Derivation", "Every number's derivation, line by line";
    Plot: Some("plot"), "Plot", "Every object's f(p + t d) against t";
    Lines: Some("lines"), "Lines", "Implicit and parametric lines in two dimensions";
    Mistakes: Some("mistakes"), "Mistakes", "The classic wrong cameras beside the right one";
    Compare: Some("compare"), "Compare", "The camera against the one that was frozen by G";
    Translator: Some("translator"), "Translator", "The camera in other programs’ terms";
    Exercises: Some("exercises"), "Exercises", "Questions, and what is wrong with an answer";
    Accuracy: None, "Accuracy", "How right each method is here, and how fast";
    Frame: None, "Frame", "What the pictures left out, and what was left to do";
    DerivationAlone: None, "Derivation alone", "Every number's derivation, without the views";
    Answers: None, "Answers", "A student’s answers, and the mistake that explains them";
}

impl ViewLayout {
    /// Those that one chooses from; the derivation alone is for presenting, and answers are there only
    /// once there are some.
    pub fn listed() -> impl Iterator<Item = ViewLayout> {
        let is_listed = |layout: &ViewLayout| {
            !matches!(layout, ViewLayout::DerivationAlone | ViewLayout::Answers)
        };
        ViewLayout::ALL.iter().copied().filter(is_listed)
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
