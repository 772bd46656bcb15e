//! Settings that are one of several, in the form in which they are written to disk.

use pinhole_core::Shade;
use pinhole_core::methods::Method;
use pinhole_core::steering::Keep;
use serde::{Deserialize, Serialize};

use crate::model::named_enum::named_enum;

named_enum! {
    /// A workspace, with its label and its description.
    pub enum Workspace {
        /// World view and camera view.
        Scene: "Scene", "The scene, and what the camera sees of it";
        /// The derivation of every number.
        Derivation: "Derivation", "Every number's derivation, line by line";
        /// One ray and what it meets.
        Ray: "Ray", "One ray and what it meets: a line in two dimensions, then the scene's objects";
        /// Questions, wrong cameras and answers.
        Practice: "Practice", "Exercises, classic wrong cameras, and answers to check";
    }
}

impl Workspace {
    /// Returns the label.
    pub fn label(self) -> &'static str {
        self.texts()[0]
    }

    /// Returns the description.
    pub fn about(self) -> &'static str {
        self.texts()[1]
    }

    /// Returns its pages; the first one is shown when it is opened.
    pub fn pages(self) -> &'static [ViewLayout] {
        match self {
            Workspace::Scene => {
                &[ViewLayout::Both, ViewLayout::World, ViewLayout::Camera, ViewLayout::Compare]
            }
            Workspace::Derivation => &[ViewLayout::Derivation],
            Workspace::Ray => &[ViewLayout::Lines, ViewLayout::Plot],
            Workspace::Practice => {
                &[ViewLayout::Exercises, ViewLayout::Mistakes, ViewLayout::Answers]
            }
        }
    }
}

/// The layouts that are tools, apart from the workspaces.
pub const TOOLS: &[ViewLayout] = &[ViewLayout::Translator, ViewLayout::Accuracy, ViewLayout::Frame];

named_enum! {
    /// A layout of the window, with its label, its description, and its name in lesson files, which
    /// is empty if no lesson can show it.
    #[derive(Serialize, Deserialize)]
    pub enum ViewLayout {
        /// World view and camera view side by side.
        Both: "Both views", "World view and camera view side by side", "both";
        /// The world view alone.
        World: "World view", "The world view alone", "world";
        /// The camera view alone.
        Camera: "Camera view", "The camera view alone", "camera";
        /// The derivation beside the views.
        #[serde(alias = "Ledger")]
        Derivation: "Derivation", "Every number's derivation, line by line", "derivation";
        /// The plot of f(p + t d).
        Plot: "f(p + t d)", "Every object's f(p + t d) against t", "plot";
        /// The lab of lines.
        Lines: "Lines", "Implicit and parametric lines in two dimensions", "lines";
        /// A wrong camera beside the right one.
        Mistakes: "Mistakes", "The classic wrong cameras beside the right one", "mistakes";
        /// The camera beside the ghost.
        Compare: "Ghost", "The camera against its ghost, which G freezes", "compare";
        /// The translator.
        Translator: "Translator", "The camera in other programs' terms", "translator";
        /// The exercises.
        Exercises: "Exercises", "Questions, and what is wrong with an answer", "exercises";
        /// The error map and the table of methods.
        Accuracy: "Accuracy", "How right each method is here, and how fast", "";
        /// The counts of a frame.
        Frame: "Skipped work", "What work the renderer skipped for these pictures, and what it did", "";
        /// The derivation alone, for presenting.
        DerivationAlone: "Derivation alone", "Every number's derivation, without the views", "";
        /// A student's answers and their grade.
        Answers: "Answers", "A student's answers, and the mistake that explains them", "";
    }
}

impl ViewLayout {
    /// Returns the layout's label.
    pub fn label(self) -> &'static str {
        self.texts()[0]
    }

    /// Returns a description of the layout.
    pub fn about(self) -> &'static str {
        self.texts()[1]
    }

    /// Returns the layout's name in lesson files; `None` if no lesson can show it.
    pub fn name(self) -> Option<&'static str> {
        Some(self.texts()[2]).filter(|name| !name.is_empty())
    }

    /// Returns the layouts to choose from. The derivation alone is for presenting, and answers are
    /// shown only once there are some.
    pub fn listed() -> impl Iterator<Item = ViewLayout> {
        let is_listed = |layout: &ViewLayout| {
            !matches!(layout, ViewLayout::DerivationAlone | ViewLayout::Answers)
        };
        ViewLayout::ALL.into_iter().filter(is_listed)
    }

    /// Returns the workspace that it is a page of; `None` of tools, and of what only presenter mode shows.
    pub fn workspace(self) -> Option<Workspace> {
        Workspace::ALL.into_iter().find(|workspace| workspace.pages().contains(&self))
    }

    /// Returns true if the layout shows the derivation.
    pub fn shows_derivation(self) -> bool {
        matches!(self, ViewLayout::Derivation | ViewLayout::DerivationAlone)
    }
}

named_enum! {
    /// The window's colours, with their label in a menu.
    #[derive(Default, Serialize, Deserialize)]
    pub enum ThemeName {
        /// The system's choice; dark if it has none.
        #[default]
        System: "Same as the system";
        /// Dark.
        Dark: "Dark";
        /// Light.
        Light: "Light";
    }
}

impl ThemeName {
    /// Returns the label in a menu.
    pub fn label(self) -> &'static str {
        self.texts()[0]
    }
}

/// [`Method`] in the form that is written to disk: its name. The ladder stands for unknown names.
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

/// [`Shade`] in the form that is written to disk.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Shade")]
pub(super) enum StoredShade {
    Lambert,
    Normal,
    T,
    Object,
}

/// Returns a shading's label.
pub fn shade_label(shade: Shade) -> &'static str {
    match shade {
        Shade::Lambert => "diffuse",
        Shade::Normal => "normals",
        Shade::T => "t",
        Shade::Object => "flat",
    }
}

/// Returns a description of a shading's colours.
pub fn shade_about(shade: Shade) -> &'static str {
    match shade {
        Shade::Lambert => "Lit from the eye",
        Shade::Normal => "The normal's x, y, z as red, green, blue",
        Shade::T => "Nearest t white, farther darker",
        Shade::Object => "Each object's own colour, flat",
    }
}

/// [`Keep`] in the form that is written to disk.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the same names as pinhole_core::steering::Keep, explained there")]
pub enum EyeKeeps {
    #[default]
    At,
    View,
}

impl EyeKeeps {
    /// Returns the other one.
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
