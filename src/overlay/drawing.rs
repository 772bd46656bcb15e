//! A drawing: lines and shapes in dots, before anything is painted. Tests, the window and exported
//! figures read the same one.

use egui::Color32;
use pinhole_core::DVec2;

use crate::overlay::items::Item;
use crate::thing::Thing;

/// A shape in dots from the top left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A chain of straight lines, so many dots wide; closed if it ends where it began.
    Line {
        /// Its corners.
        points: Vec<[f32; 2]>,
        /// In dots.
        width: f32,
    },
    /// A filled polygon.
    Polygon {
        /// Its corners.
        points: Vec<[f32; 2]>,
    },
    /// A filled disc.
    Disc {
        /// Its centre.
        center: [f32; 2],
        /// In dots.
        radius: f32,
    },
}

/// One stroke of the overlay.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What it belongs to.
    pub item: Item,
    /// What is pointed at where it is pointed at.
    pub thing: Option<Thing>,
    /// Where it is.
    pub shape: Shape,
    /// Its colour.
    pub color: Color32,
    /// A casing around it, so that it stands out from what it crosses.
    pub halo: Option<Color32>,
    /// Whether it lies behind something: a hidden line is dashed.
    pub hidden: bool,
}

/// Text in the picture, drawn by whoever has fonts.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What it belongs to.
    pub item: Item,
    /// The middle of the text, in dots.
    pub position: [f32; 2],
    /// What it says.
    pub text: String,
    /// Its colour.
    pub color: Color32,
    /// The colour of a soft edge around the letters.
    pub halo: Color32,
    /// Height of the font in points.
    pub size: f32,
    /// Bold: a vector's name.
    pub bold: bool,
}

/// All marks of one picture, in the order of painting, and its labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Dots per point.
    pub scale: f32,
    /// Later ones lie over earlier ones.
    pub marks: Vec<Mark>,
    /// None overlaps another.
    pub labels: Vec<Label>,
}

impl Label {
    /// Half the width and height, in dots, of a box that the text fits into in any font of usual
    /// width.
    pub fn half_extent(&self, scale: f32) -> [f32; 2] {
        let size = self.size * scale;
        [size * (0.3 * self.text.chars().count() as f32 + 0.15), 0.62 * size]
    }
}

/// A place in dots, as the rasteriser takes it.
pub(crate) fn dot(at: DVec2) -> [f32; 2] {
    [at.x as f32, at.y as f32]
}
