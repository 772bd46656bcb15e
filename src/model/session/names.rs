//! Workspaces and layouts of the window, and the labels of other settings that are one of several.

use pinhole_core::Shade;
use serde::{Deserialize, Serialize};

/// A workspace, with its label and its description.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Workspace {
    /// World view and camera view.
    Scene,
    /// The derivation of every number.
    Derivation,
    /// One ray and what it meets.
    Ray,
    /// Questions, wrong cameras and answers.
    Practice,
}

impl Workspace {
    /// All of them, in order.
    pub const ALL: [Workspace; 4] =
        [Workspace::Scene, Workspace::Derivation, Workspace::Ray, Workspace::Practice];

    /// Returns the label.
    pub fn label(self) -> &'static str {
        match self {
            Workspace::Scene => "Scene",
            Workspace::Derivation => "Derivation",
            Workspace::Ray => "Ray",
            Workspace::Practice => "Practice",
        }
    }

    /// Returns the description.
    pub fn about(self) -> &'static str {
        match self {
            Workspace::Scene => "The scene, and what the camera sees of it",
            Workspace::Derivation => "Every number's derivation, line by line",
            Workspace::Ray => {
                "One ray and what it meets: a line in two dimensions, then the scene's objects"
            }
            Workspace::Practice => "Exercises, classic wrong cameras, and answers to check",
        }
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
pub const TOOLS: &[ViewLayout] = &[ViewLayout::Translator, ViewLayout::Accuracy];

/// A layout of the window, with its label, its description, and its name in lesson files, which
/// is empty if no lesson can show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ViewLayout {
    /// World view and camera view side by side.
    Both,
    /// The world view alone.
    World,
    /// The camera view alone.
    Camera,
    /// The derivation beside the views.
    #[serde(alias = "Ledger")]
    Derivation,
    /// The plot of f(p + t d).
    Plot,
    /// The lab of lines.
    Lines,
    /// A wrong camera beside the right one.
    Mistakes,
    /// The camera beside the ghost.
    Compare,
    /// The translator.
    Translator,
    /// The exercises.
    Exercises,
    /// The error map and the table of methods.
    Accuracy,
    /// The derivation alone, for presenting.
    DerivationAlone,
    /// A student's answers and their grade.
    Answers,
}

impl ViewLayout {
    /// The layouts to choose from. The derivation alone is for presenting, and answers are shown
    /// only once there are some.
    pub const LISTED: [ViewLayout; 11] = {
        use ViewLayout::*;
        [
            Both, World, Camera, Derivation, Plot, Lines, Mistakes, Compare, Translator, Exercises,
            Accuracy,
        ]
    };

    fn texts(self) -> [&'static str; 3] {
        use ViewLayout::*;
        match self {
            Both => ["Both views", "World view and camera view side by side", "both"],
            World => ["World view", "The world view alone", "world"],
            Camera => ["Camera view", "The camera view alone", "camera"],
            Derivation => ["Derivation", "Every number's derivation, line by line", "derivation"],
            Plot => ["f(p + t d)", "Every object's f(p + t d) against t", "plot"],
            Lines => ["Lines", "Implicit and parametric lines in two dimensions", "lines"],
            Mistakes => ["Mistakes", "The classic wrong cameras beside the right one", "mistakes"],
            Compare => ["Ghost", "The camera against its ghost, which G freezes", "compare"],
            Translator => ["Translator", "The camera in other programs' terms", "translator"],
            Exercises => ["Exercises", "Questions, and what is wrong with an answer", "exercises"],
            Accuracy => ["Accuracy", "How right each method is here, and how fast", ""],
            DerivationAlone => {
                ["Derivation alone", "Every number's derivation, without the views", ""]
            }
            Answers => ["Answers", "A student's answers, and the mistake that explains them", ""],
        }
    }

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

    /// Returns the workspace that it is a page of; `None` of tools, and of what only presenter mode shows.
    pub fn workspace(self) -> Option<Workspace> {
        Workspace::ALL.into_iter().find(|workspace| workspace.pages().contains(&self))
    }

    /// Returns true if the layout shows the derivation.
    pub fn shows_derivation(self) -> bool {
        matches!(self, ViewLayout::Derivation | ViewLayout::DerivationAlone)
    }
}

/// The window's colours, with their label in a menu.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ThemeName {
    /// The system's choice; dark if it has none.
    #[default]
    System,
    /// Dark.
    Dark,
    /// Light.
    Light,
}

impl ThemeName {
    /// All of them, in order.
    pub const ALL: [ThemeName; 3] = [ThemeName::System, ThemeName::Dark, ThemeName::Light];

    /// Returns the label in a menu.
    pub fn label(self) -> &'static str {
        match self {
            ThemeName::System => "Same as the system",
            ThemeName::Dark => "Dark",
            ThemeName::Light => "Light",
        }
    }
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
