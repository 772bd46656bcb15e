//! Figures for slides: the content of the window as SVG, PDF or PNG.
//!
//! Every figure is drawn by the window's own code, so a file shows what the screen shows. Lines and
//! shapes over a picture are those of its [`Drawing`](crate::overlay::Drawing); labels, the
//! derivation, and the exercise with lines in the plane (the lines lab) are drawn by egui without a
//! window. For a PNG, both are painted exactly as in the window. For SVG and PDF, both are converted to
//! paths and texts.
//!
//! - this file: a figure and its formats;
//! - `spheres`: curved edges of spheres;
//! - `qr`: the QR code of a link;
//! - `vector`: SVG and PDF, only with the feature `vector`.

use egui::{Color32, ColorImage, Context, Painter, Vec2};
use pinhole_core::Ellipse;
use pinhole_exchange::images::png;

use crate::export::spheres::SphereEdges;
use crate::headless::UiPass;
use crate::overlay::{Path, paint_paths};
use crate::typesetting::theme;

pub use crate::export::qr::QrCode;

mod qr;
mod spheres;
#[cfg(feature = "vector")]
mod vector;

/// The file format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureFormat {
    /// SVG. Strokes and text are not converted to outlines.
    Svg,
    /// PDF. Strokes and text are kept as such, not converted to outlines; lengths are in points of 1/72
    /// inch.
    Pdf,
    /// PNG.
    Png,
}

/// A figure to export.
#[derive(Debug)]
pub struct Figure {
    /// The title, which is also the figure's description.
    pub title: String,
    /// Width and height in dots.
    pub size: [usize; 2],
    /// The background colour; `None` if the figure is transparent.
    ground: Option<Color32>,
    /// The raster image below everything else, which fills the figure; `None` if there is none. It has the
    /// figure's size or, for a vector format, may be [finer](Figure::refine).
    picture: Option<ColorImage>,
    /// The spheres drawn over the picture.
    spheres: SphereEdges,
    /// Paths drawn over them, in dots.
    paths: Vec<Path>,
    /// Shapes and text drawn over the paths.
    drawn: UiPass,
}

impl Figure {
    /// Draws a figure on a white page of `size` points, with `scale` dots per point.
    pub fn draw(title: &str, size: Vec2, scale: f32, draw: impl Fn(&Painter)) -> Figure {
        let ctx = Context::default();
        theme::install_fonts(&ctx);
        let size = [size.x, size.y].map(|points| (points * scale).ceil() as usize);
        let drawn = UiPass::draw(&ctx, size, scale, |ui| draw(ui.painter()));
        Figure::plain(title, size, Some(Color32::WHITE), drawn)
    }

    /// Creates a figure of shapes alone on a ground, or on none.
    pub fn plain(title: &str, size: [usize; 2], ground: Option<Color32>, drawn: UiPass) -> Figure {
        let (title, spheres, paths) = (title.to_owned(), SphereEdges::default(), Vec::new());
        Figure { title, size, ground, picture: None, spheres, paths, drawn }
    }

    /// Paints the figure exactly as the window would. Returns the pixels, row by row from the top, with
    /// premultiplied alpha.
    pub fn to_pixels(&self) -> Vec<Color32> {
        let [width, height] = self.size;
        let mut pixels = vec![self.ground.unwrap_or(Color32::TRANSPARENT); width * height];
        if let Some(picture) = &self.picture {
            pixels.copy_from_slice(&picture.pixels);
        }
        paint_paths(&self.paths, width, &mut pixels);
        self.drawn.paint(&mut pixels, self.size);
        pixels
    }

    /// Adds a picture below everything else, the outlines of its spheres, and paths over it, all in dots.
    #[must_use]
    pub fn with_view(
        mut self,
        picture: Option<ColorImage>,
        outlines: Vec<Ellipse>,
        paths: Vec<Path>,
    ) -> Figure {
        self.spheres = SphereEdges { outlines, ..SphereEdges::default() };
        (self.picture, self.paths) = (picture, paths);
        self
    }

    /// Takes the picture of a figure of the same view with more dots, and separates its spheres from it: in a
    /// vector format, their edges are curves.
    pub fn refine(&mut self, finer: Figure) {
        (self.picture, self.spheres) = (finer.picture, finer.spheres);
        if let Some(picture) = &mut self.picture {
            self.spheres.cut_out_of(picture, self.size.map(|n| n as u32));
        }
    }

    /// Encodes the figure in a file format, and returns the bytes of the file.
    ///
    /// # Errors
    /// Returns an error, as a sentence, if the figure cannot be written in this format.
    pub fn to_file(&self, format: FigureFormat) -> Result<Vec<u8>, String> {
        match format {
            #[cfg(feature = "vector")]
            FigureFormat::Svg => vector::svg(self).map(String::into_bytes),
            #[cfg(feature = "vector")]
            FigureFormat::Pdf => vector::pdf(self),
            #[cfg(not(feature = "vector"))]
            FigureFormat::Svg | FigureFormat::Pdf => {
                Err("this build writes figures only as PNG: it lacks the feature `figures`"
                    .to_owned())
            }
            FigureFormat::Png => to_png(self.size, &self.to_pixels(), self.ground.is_none()),
        }
    }
}

/// Encodes pixels with premultiplied alpha as PNG, with an alpha channel if `transparent` is true.
fn to_png(size: [usize; 2], pixels: &[Color32], transparent: bool) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let size = size.map(|n| n as u32);
    png::encode(&mut bytes, size, &to_srgba(pixels), transparent)
        .map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Returns pixels as red, green, blue and opacity, not multiplied by it.
pub fn to_srgba(pixels: &[Color32]) -> Vec<[u8; 4]> {
    pixels.iter().map(Color32::to_srgba_unmultiplied).collect()
}
