//! A figure: what it looks like, and the files that it can be written to.

use egui::{Color32, ColorImage, Context, Painter, Vec2};
use pinhole_exchange::images::png;

#[cfg(feature = "figures")]
use super::vector;
use crate::view::headless::UiPass;
use crate::view::overlay::{Path, paint_paths};
use crate::view::typesetting::fonts;

/// The formats of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Strokes as strokes, text as text.
    Svg,
    /// Strokes as strokes, text as text, in points.
    Pdf,
    /// Pixels.
    Png,
}

impl Format {
    /// All of them.
    pub const ALL: [Format; 3] = [Format::Svg, Format::Pdf, Format::Png];

    /// Returns the ending of its files' names.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Pdf => "pdf",
            Format::Png => "png",
        }
    }
}

/// A figure to export.
#[derive(Debug)]
pub struct Figure {
    /// The title: what it shows, in words.
    pub(super) title: String,
    /// Width and height in dots.
    pub(super) size: [usize; 2],
    /// The background, unless it is transparent.
    pub(super) ground: Option<Color32>,
    /// A picture as large as the figure.
    pub(super) picture: Option<ColorImage>,
    /// Paths over the picture, in dots.
    pub(super) paths: Vec<Path<'static>>,
    /// Shapes and text over the paths.
    pub(super) drawn: UiPass,
}

impl Figure {
    /// Creates a figure of what is drawn on a white page, `size` points large.
    pub(crate) fn drawn(title: &str, size: Vec2, scale: f32, draw: impl Fn(&Painter)) -> Figure {
        let ctx = Context::default();
        fonts::install(&ctx);
        let size = [size.x, size.y].map(|points| (points * scale).ceil() as usize);
        let drawn = UiPass::draw(&ctx, size, scale, |ui| draw(ui.painter()));
        let (title, ground) = (title.to_owned(), Some(Color32::WHITE));
        Figure { title, size, ground, picture: None, paths: Vec::new(), drawn }
    }

    /// Returns width and height in dots.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Returns the pixels, premultiplied, row by row from the top: painted as the window is.
    pub fn to_pixels(&self) -> Vec<Color32> {
        let [width, height] = self.size;
        let mut pixels = vec![self.ground.unwrap_or(Color32::TRANSPARENT); width * height];
        if let Some(picture) = &self.picture {
            pixels.copy_from_slice(&picture.pixels);
        }
        paint_paths(self.paths.iter(), width, &mut pixels);
        self.drawn.paint(&mut pixels, self.size);
        pixels
    }

    /// Returns the bytes of a file.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the format cannot hold the figure.
    pub fn to_file(&self, format: Format) -> Result<Vec<u8>, String> {
        match format {
            #[cfg(feature = "figures")]
            Format::Svg => vector::svg(self).map(String::into_bytes),
            #[cfg(feature = "figures")]
            Format::Pdf => vector::pdf(self),
            #[cfg(not(feature = "figures"))]
            Format::Svg | Format::Pdf => {
                Err("this build writes figures as PNG alone: it has no feature `figures`"
                    .to_owned())
            }
            Format::Png => to_png(self.size, &self.to_pixels(), self.ground.is_none()),
        }
    }
}

/// Returns a PNG of premultiplied pixels, with their opacity or without.
pub(super) fn to_png(
    size: [usize; 2],
    pixels: &[Color32],
    transparent: bool,
) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let [width, height] = size.map(|n| n as u32);
    let encode = if transparent { png::encode_transparent } else { png::encode };
    encode(&mut bytes, width, height, &to_srgba(pixels)).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Returns pixels that are not premultiplied.
pub(super) fn to_srgba(pixels: &[Color32]) -> Vec<[u8; 4]> {
    pixels.iter().map(Color32::to_srgba_unmultiplied).collect()
}
