//! The types of the settings with a choice: workspaces and layouts, the boundaries between the window's
//! areas, shadings, and the colours that distinguish objects and vectors.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use pinhole_core::Shade;
use serde::{Deserialize, Serialize};

pinhole_core::texts! {
    /// A workspace, with its label and its description.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Workspace[2];
    {
        /// Returns the label.
        label,
        /// Returns the description.
        about,
    }
    /// World view and camera view.
    Scene: "Scene", "The scene, and what the camera sees of it";
    /// The derivation of every number.
    Derivation: "Derivation", "Every number's derivation, line by line";
    /// One ray and its intersections.
    Ray: "Ray", "One ray and what it meets: a line in two dimensions, then the scene's objects";
    /// Questions, wrong cameras and answers.
    Practice: "Practice", "Exercises, classic wrong cameras, and answers to check";
}

impl Workspace {
    /// Returns the layouts that are the workspace's pages. The first one is shown when the workspace opens.
    pub fn pages(self) -> &'static [ViewLayout] {
        use ViewLayout::*;
        match self {
            Workspace::Scene => &[Both, World, Camera, Compare],
            Workspace::Derivation => &[Derivation],
            Workspace::Ray => &[Lines, Plot],
            Workspace::Practice => &[Exercises, Mistakes, Class, Answers],
        }
    }
}

/// The layouts that are tools. They belong to no workspace.
pub const TOOLS: &[ViewLayout] = match cfg!(feature = "report") {
    true => &[ViewLayout::Translator, ViewLayout::Accuracy],
    false => &[ViewLayout::Translator],
};

pinhole_core::texts! {
    /// A layout of the window. Some layouts cannot be shown by lessons and have no name in lesson files.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
    pub enum ViewLayout[3];
    {
        /// Returns the layout's label.
        label,
        /// Returns a description of the layout.
        about,
        /// Returns the layout's name in lesson files; an empty text if no lesson can show it.
        lesson_name,
    }
    /// World view and camera view side by side.
    Both: "Both views", "World view and camera view side by side", "both";
    /// The world view alone.
    World: "World view", "The world view alone", "world";
    /// The camera view alone.
    Camera: "Camera view", "The camera view alone", "camera";
    /// The derivation to the right of the views.
    #[serde(alias = "Ledger")]
    Derivation: "Derivation", "Every number's derivation, line by line", "derivation";
    /// The plot of f(p + t d).
    Plot: "f(p + t d)", "Every object's f(p + t d) against t", "plot";
    /// The implicit and the parametric line in the plane.
    Lines: "Lines", "Implicit and parametric lines in two dimensions", "lines";
    /// A wrong camera and the right one, side by side.
    Mistakes: "Mistakes", "The classic wrong cameras beside the right one", "mistakes";
    /// The camera and the ghost (a frozen camera), side by side.
    Compare: "Ghost", "The camera against its ghost, which G freezes", "compare";
    /// The translator.
    Translator: "Translator", "The camera in other programs' terms", "translator";
    /// The exercises.
    Exercises: "Exercises", "Questions, and what is wrong with an answer", "exercises";
    /// The error map and the table of methods.
    Accuracy: "Accuracy", "How right each method is here, and how fast", "";
    /// The derivation alone, which only presenter mode shows.
    DerivationAlone: "Derivation alone", "Every number's derivation, without the views", "";
    /// A student's answers and their grade.
    Answers: "Answers", "A student's answers, and the mistake that explains them", "";
    /// The mistakes in a class's answers to exercises.
    Class: "Class", "How many of a class made which mistake, from the codes they send", "";
}

impl ViewLayout {
    /// The layouts that the user can choose at any time. Not among them are the derivation alone, which is
    /// for presenting, and the layout for graded answers, which needs a file of answers.
    pub const LISTED: [ViewLayout; 12] = {
        use ViewLayout::*;
        [
            Both, World, Camera, Derivation, Plot, Lines, Mistakes, Compare, Translator, Exercises,
            Class, Accuracy,
        ]
    };

    /// Returns the layout's name in lesson files; `None` if no lesson can show it.
    pub fn name(self) -> Option<&'static str> {
        Some(self.lesson_name()).filter(|name| !name.is_empty())
    }

    /// Returns the workspace that has the layout as a page; `None` for tools and for layouts that only
    /// presenter mode shows.
    pub fn workspace(self) -> Option<Workspace> {
        Workspace::ALL.into_iter().find(|workspace| workspace.pages().contains(&self))
    }

    /// Returns true if the lines of the derivation are revealed one by one while presenting.
    pub fn reveals_lines(self) -> bool {
        self == ViewLayout::Plot || self.workspace() == Some(Workspace::Derivation)
    }

    /// Returns true if the layout shows the derivation.
    pub fn shows_derivation(self) -> bool {
        matches!(self, ViewLayout::Derivation | ViewLayout::DerivationAlone)
    }
}

pinhole_core::texts! {
    /// The brightness of the window's colours, with its label in a menu.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
    pub enum ThemeName[1];
    {
        /// Returns the label in a menu.
        label,
    }
    /// The system's choice; light if it has none.
    #[default]
    System: "Same as the system";
    /// Dark.
    Dark: "Dark";
    /// Light.
    Light: "Light";
}

/// Returns a shading's label and a description of its colours.
pub fn shade_texts(shade: Shade) -> [&'static str; 2] {
    match shade {
        Shade::Lambert => ["diffuse", "Lit from the eye"],
        Shade::Normal => ["normals", "The normal's x, y, z as red, green, blue"],
        Shade::T => ["t", "Nearest t white, farther darker"],
        Shade::Object => ["flat", "Each object's own colour, flat"],
    }
}

/// A movable boundary between two areas of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Split {
    /// Boundary between the world view and the camera view when they are side by side: the world view's
    /// fraction of the width.
    Views,
    /// Boundary between the world view and the camera view when they are stacked: the world view's fraction
    /// of the height.
    Stack,
    /// The world view's fraction of the width when a second picture is shown beside the camera view.
    PracticeViews,
    /// The views' fraction of the width when the derivation or the translator is to their right.
    Derivation,
    /// The readouts' height in points. All variants from here on are heights in points.
    Readouts,
    /// The plot and the table of the accuracy view.
    Accuracy,
    /// The plot of f(p + t d).
    Plot,
    /// The text about the wrong camera.
    Mistakes,
    /// The numbers of both compared cameras.
    Compare,
    /// The text about the student's answers.
    Answers,
}

const SHARE: RangeInclusive<f32> = 0.0..=1.0;
const HEIGHT: RangeInclusive<f32> = 0.0..=10_000.0;

/// Default position and range of each boundary, in the order of [`Split`].
const TABLE: [(Split, f32, RangeInclusive<f32>); 10] = [
    (Split::Views, 0.62, SHARE),
    (Split::Stack, 0.55, SHARE),
    (Split::PracticeViews, 0.38, SHARE),
    (Split::Derivation, 0.5, SHARE),
    (Split::Readouts, 200.0, HEIGHT),
    (Split::Accuracy, 370.0, HEIGHT),
    (Split::Plot, 300.0, HEIGHT),
    (Split::Mistakes, 480.0, HEIGHT),
    (Split::Compare, 230.0, HEIGHT),
    (Split::Answers, 480.0, HEIGHT),
];

/// The positions of all boundaries, each within its range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "BTreeMap<Split, f32>", into = "BTreeMap<Split, f32>")]
pub struct Splits([f32; TABLE.len()]);

impl Splits {
    /// Returns the position of a boundary.
    pub fn get(&self, split: Split) -> f32 {
        self.0[split as usize]
    }

    /// Moves a boundary to `to`, clamped to its range, or to its default if `to` is not finite.
    pub fn set(&mut self, split: Split, to: f32) {
        let (_, first, range) = &TABLE[split as usize];
        let to = if to.is_finite() { to } else { *first };
        self.0[split as usize] = to.clamp(*range.start(), *range.end());
    }
}

impl Default for Splits {
    fn default() -> Splits {
        Splits(TABLE.map(|(_, first, _)| first))
    }
}

impl From<BTreeMap<Split, f32>> for Splits {
    fn from(known: BTreeMap<Split, f32>) -> Splits {
        let mut splits = Splits::default();
        for (split, to) in known {
            splits.set(split, to);
        }
        splits
    }
}

impl From<Splits> for BTreeMap<Split, f32> {
    fn from(splits: Splits) -> BTreeMap<Split, f32> {
        TABLE.iter().map(|(split, ..)| (*split, splits.get(*split))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_enums_order_and_its_values_are_in_range() {
        for (k, (split, first, range)) in TABLE.iter().enumerate() {
            assert_eq!(*split as usize, k);
            assert!(range.contains(first), "{split:?}");
        }
    }
}
