//! Figures for slides: what the window shows, as SVG, PDF and PNG.
//!
//! Nothing is drawn a second time. The overlay's marks come from its [`Drawing`], and labels, the
//! derivation and the lab of lines are drawn by the window's own code into an egui pass without a window.
//! PNG is painted from both as the window is. For SVG and PDF, both become the same `Part`s: paths,
//! text and one picture. So what is on the screen is what is in the file.
//!
//! - `order`: what is asked for;
//! - `animation`: many figures, one for each phase of what plays;
//! - `views`: figures of the two views; `sheets`: of the derivation and the lab of lines;
//! - `shapes`: what egui was told to draw, as parts; `text`: its text, glyph by glyph;
//! - `typeface`: the fonts that the letters come from; `subset`: those letters alone, as a font;
//! - `svg`, `pdf`: parts as files.

mod animation;
mod order;
mod part;
mod pdf;
mod shapes;
mod sheets;
mod subset;
mod svg;
mod text;
mod typeface;
mod views;

use egui::{Color32, ColorImage};

use self::part::{Part, Picture};
use crate::view::headless::Sheet;
use crate::view::overlay::{Drawing, Style};
use pinhole_exchange::images::png;

pub use self::animation::{Animation, Frames, Recorder, Reel, check_name};
pub use self::order::{Content, Order, Subject, derivation_of};
pub use self::sheets::MARGIN;
pub use self::views::{View, of_view, scale_of};

/// The formats of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Strokes as strokes, text as text.
    Svg,
    /// The same.
    Pdf,
    /// Pixels.
    Png,
}

impl Format {
    /// All of them.
    pub const ALL: [Format; 3] = [Format::Svg, Format::Pdf, Format::Png];

    /// The ending of its files' names.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Pdf => "pdf",
            Format::Png => "png",
        }
    }
}

/// How a figure looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Dots per point: how large strokes and letters are.
    pub scale: f32,
    /// The colours.
    pub style: Style,
    /// Nothing is painted where there is nothing.
    pub transparent: bool,
}

/// Something to export.
#[derive(Debug)]
pub struct Figure {
    /// What it shows, in words.
    title: String,
    /// Width and height in dots.
    size: [usize; 2],
    /// Behind everything, unless it is transparent.
    ground: Option<Color32>,
    /// A picture as large as the figure.
    picture: Option<ColorImage>,
    /// Over the picture.
    drawing: Drawing,
    /// Over the drawing.
    sheet: Sheet,
}

impl Figure {
    /// Width and height in dots.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The pixels, premultiplied, row by row from the top: painted as the window is.
    pub fn to_pixels(&self) -> Vec<Color32> {
        let [width, height] = self.size;
        let mut pixels = vec![self.ground.unwrap_or(Color32::TRANSPARENT); width * height];
        if let Some(picture) = &self.picture {
            pixels.copy_from_slice(&picture.pixels);
        }
        self.drawing.paint(width, &mut pixels);
        self.sheet.paint(&mut pixels, self.size);
        pixels
    }

    /// The pixels, not premultiplied.
    fn to_srgba(&self) -> Vec<[u8; 4]> {
        self.to_pixels().iter().map(Color32::to_srgba_unmultiplied).collect()
    }

    /// All that is drawn, from the back to the front; lengths in dots.
    fn parts(&self) -> Vec<Part<'_>> {
        let mut parts: Vec<Part> = self
            .picture
            .as_ref()
            .map(|picture| Part::Picture(Picture::of(picture)))
            .into_iter()
            .collect();
        parts.extend(self.drawing.paths().map(Part::Path));
        parts.extend(shapes::parts(self.sheet.shapes(), self.drawing.scale));
        parts
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// In words, what the format cannot hold.
    pub fn to_file(&self, format: Format) -> Result<Vec<u8>, String> {
        match format {
            Format::Svg => svg::write(self).map(String::into_bytes),
            Format::Pdf => pdf::write(self),
            Format::Png => {
                let mut bytes = Vec::new();
                let [width, height] = self.size.map(|n| n as u32);
                let pixels = self.to_srgba();
                let written = if self.ground.is_none() {
                    png::encode_transparent(&mut bytes, width, height, &pixels)
                } else {
                    png::encode(&mut bytes, width, height, &pixels)
                };
                written.map_err(|error| error.to_string())?;
                Ok(bytes)
            }
        }
    }
}
