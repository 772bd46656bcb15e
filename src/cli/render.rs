//! `pinhole render`: writes the picture as PNG, and the hits as OpenEXR.

use std::hint::black_box;
use std::io::{self, BufWriter, Seek, Write};
use std::path::Path;

use pinhole_core::{
    Frame, ImageSize, Level, Outputs, Paint, Raster, ResolvedCamera, Rgb, Scene, Shade, nearest_t,
    shade_part, trace_at_level,
};
use pinhole_exchange::atomic::{self, Batch, is_same_file};
use pinhole_exchange::document::Document;
#[cfg(feature = "exr")]
use pinhole_exchange::images::exr;
use pinhole_exchange::images::png;
use pinhole_exchange::{FileError, limits};
use pinhole_figure::overlay::{Style, observer_of};
use pinhole_figure::{Item, OverlayItems, ViewSize};

use super::console::{
    CommandError, is_standard, named, not_built, refused, scene_fault, to_stdout, warn,
};
use super::load::{files_of, load, pose, refuse_overwriting, size};
use super::progress::Progress;
use crate::cli::arguments::RenderArguments;
use crate::features::export::order::{FigureSubject, Order, scale_of};
use crate::model::{Session, Setup, Shown};

pub(super) fn run(arguments: &RenderArguments) -> Result<(), CommandError> {
    let output = Some(&*arguments.output).filter(|output| !is_standard(output));
    let aov = arguments.aov.as_deref();
    named(&arguments.output, "png", "-o writes PNG")?;
    if let Some(aov) = aov {
        if !cfg!(feature = "exr") {
            return Err(not_built("--aov", "exr"));
        }
        if arguments.view == FigureSubject::World {
            return refused("--aov writes what the camera's rays meet: leave out --view world");
        }
        if is_same_file(aov, &arguments.output) {
            return refused(format!("--aov and -o both write {}", aov.display()));
        }
        if is_standard(aov) {
            return refused("--aov needs a file: - is for -o");
        }
        named(aov, "exr", "--aov writes OpenEXR")?;
    }
    for file in [output, aov].into_iter().flatten() {
        atomic::check(file)?;
    }
    let document = load(&arguments.scene)?;
    pose(&arguments.scene, &document)?;
    let outputs = [output.map(|output| ("-o", output)), aov.map(|aov| ("--aov", aov))];
    let inputs = files_of(&arguments.scene, &document);
    refuse_overwriting(&inputs, outputs.into_iter().flatten())?;
    let scene_image = document.camera.image;
    let image =
        size(arguments.width, arguments.height, [scene_image.width(), scene_image.height()])?;
    warn_if_large(image, output.is_some(), aov.is_some());
    let picture = Picture::new(document, arguments, image)
        .map_err(|error| scene_fault(&arguments.scene, error))?;
    let progress = Progress::new("row", picture.passes() * image.height() as usize);
    let done = |rows| progress.add(rows);
    let mut batch = Batch::default();
    let aov = aov.map(|aov| Ok::<_, FileError>((aov, batch.create(aov)?))).transpose()?;
    match output {
        Some(output) => {
            batch.add(output, |file| picture.write(BufWriter::new(file), aov, BAND, done))?;
        }
        None => to_stdout(|out| picture.write(out, aov, BAND, done)).map_err(|error| {
            // That a reader has gone is a failure if a file is not written for it.
            if arguments.aov.is_none() { error } else { CommandError::Input(error.to_string()) }
        })?,
    }
    batch.finish().map_err(CommandError::from)
}

/// Tells before a long computation how much of the disk the files will take, if that is much.
fn warn_if_large(image: ImageSize, has_png: bool, has_aov: bool) {
    /// Bytes of a pixel in a PNG and in an OpenEXR file.
    const RAW: [u64; 2] = [3, 36];
    let of_pixel = RAW[0] * u64::from(has_png) + RAW[1] * u64::from(has_aov);
    let bytes = u64::from(image.width()) * u64::from(image.height()) * of_pixel;
    if bytes >= 1 << 30 {
        warn(&format!("the files take up to {:.1} GB of the disk", bytes as f64 / 1e9));
    }
}

/// Number of pixels that are drawn at a time, at least.
const BAND: usize = 1 << 20;

/// A picture that is about to be drawn.
pub struct Picture<'a> {
    document: Document,
    arguments: &'a RenderArguments,
    size: ImageSize,
    camera: ResolvedCamera,
    scene: Scene,
    /// The pixels of a view with marks, which are drawn all at once.
    marked: Option<Vec<[u8; 4]>>,
}

impl Picture<'_> {
    /// Prepares the requested view of the document at this size.
    ///
    /// If the size differs from that of the document's image, the camera view is traced with an image of this
    /// size. The world view, on the other hand, shows the camera's own pixels on its viewport.
    ///
    /// # Errors
    /// Returns an error if the camera sees nothing, or an object is invalid.
    pub fn new(
        mut document: Document,
        arguments: &RenderArguments,
        size: ImageSize,
    ) -> Result<Picture<'_>, String> {
        if arguments.view == FigureSubject::Camera {
            document.camera.image = size;
        }
        let camera = document.camera.resolve().map_err(|error| error.to_string())?;
        let scene = document.scene().map_err(|error| error.to_string())?;
        let has_marks = arguments.overlay || arguments.view == FigureSubject::World;
        let marked = has_marks.then(|| with_overlay(&document, &scene, arguments, size));
        Ok(Picture { marked: marked.transpose()?, document, arguments, size, camera, scene })
    }

    /// Returns how often [`Picture::write`] counts each row as done.
    pub fn passes(&self) -> usize {
        1 + usize::from(self.is_by_nearest()) + usize::from(self.arguments.aov.is_some())
    }

    /// Returns whether the colours depend on the smallest `t` of the whole picture, which is traced first.
    fn is_by_nearest(&self) -> bool {
        self.marked.is_none() && self.arguments.shade == Shade::T
    }

    /// Writes the picture as PNG, and what the camera's rays meet to an OpenEXR file, by bands of at least `band`
    /// pixels. Calls `done` whenever rows are finished, with their number.
    ///
    /// # Errors
    /// Returns an error if a file cannot be written.
    pub fn write(
        &self,
        png: impl Write,
        aov: Option<(&Path, impl Write + Seek)>,
        band: usize,
        done: impl Fn(usize) + Sync,
    ) -> io::Result<()> {
        /// Bands consist of whole tiles of an OpenEXR file.
        const TILE: usize = 64;
        let [width, height] = [self.size.width(), self.size.height()];
        let mut rows = TILE * band.div_ceil(TILE * width as usize);
        /// Bytes of memory for a pixel of a band: its hit and colour, and its certificate and tiles. Half as
        /// much again as they take, because what is asked for in one piece is given out in many, with gaps.
        const PIXEL: [usize; 2] = [24, 168];
        let row = PIXEL[usize::from(aov.is_some())] * width as usize;
        let room = |rows: usize| {
            limits::memory("a band of the picture", (rows.min(height as usize) * row) as u64)
        };
        // Each thread reserves much memory with its first allocation, if there is much: before the rest is measured.
        rayon::broadcast(|_| drop(black_box(Vec::<u8>::with_capacity(1 << 12))));
        while rows > TILE && room(rows).is_err() {
            rows = (rows / 2).next_multiple_of(TILE);
        }
        room(rows).map_err(io::Error::other)?;
        let mut bands = (0..height)
            .step_by(rows)
            .map(|first| Raster::part(first..height.min(first + rows as u32), 0..width));
        let nearest = if self.is_by_nearest() {
            let of_band = |raster| nearest_t(&self.trace(&raster, false, &done));
            bands.clone().map(of_band).fold(f64::INFINITY, f64::min)
        } else {
            f64::INFINITY
        };
        let has_aov = aov.is_some();
        png::encode_rows(png, [width, height], false, |write| {
            if let (Some(marked), None) = (&self.marked, &aov) {
                done(height as usize);
                return write(marked);
            }
            #[cfg(feature = "exr")]
            if let Some((path, file)) = aov {
                let mut written = Ok(());
                let bands = bands.map(|raster| {
                    let frame = self.trace(&raster, has_aov, &done);
                    written = write(&self.pixels_of(&frame, nearest));
                    // What is reported is `written`.
                    written.as_ref().map_err(|error| error.kind())?;
                    let (rows, columns) = (raster.rows(), raster.columns());
                    Ok((frame, self.scene.certificates(&self.camera, rows, columns, &done)))
                });
                let encoded = exr::encode(file, &self.camera, bands);
                written?;
                let of_aov = |error| io::Error::other(FileError::unwritable(path, &error));
                return encoded.map_err(of_aov);
            }
            bands.try_for_each(|raster| {
                write(&self.pixels_of(&self.trace(&raster, has_aov, &done), nearest))
            })
        })
    }

    fn trace(&self, raster: &Raster, normal: bool, done: impl Fn(usize) + Sync) -> Frame<f32> {
        let outputs = Outputs { normal, ..Outputs::default() };
        trace_at_level(Level::new(), &self.scene, &self.camera, raster, outputs, done)
    }

    /// Returns the pixels of a band, with alpha 255, given its hits and the smallest `t` of the picture.
    fn pixels_of(&self, frame: &Frame<f32>, nearest: f64) -> Vec<[u8; 4]> {
        let raster = frame.raster();
        if let Some(marked) = &self.marked {
            let start = raster.rows()[0] as usize * raster.columns().len();
            return marked[start..start + raster.len()].to_vec();
        }
        let color_of = |object| self.document.color_of(object);
        let to_pixel = |[r, g, b]: Rgb| [r, g, b, 255];
        let paint = Paint { shade: self.arguments.shade, color_of, to_pixel };
        let mut pixels = vec![[0; 4]; raster.len()];
        shade_part(Level::new(), frame, &self.scene, &paint, nearest, &mut pixels);
        pixels
    }
}

/// Draws the view as the window does, with labels. No ray is drawn, because none is selected.
fn with_overlay(
    document: &Document,
    scene: &Scene,
    arguments: &RenderArguments,
    size: ImageSize,
) -> Result<Vec<[u8; 4]>, String> {
    let items = if arguments.overlay {
        let items = OverlayItems::default().with(Item::Ray, false).with(Item::Hit, false);
        // A picture in a file has no handles.
        items.with(Item::Handles, false)
    } else {
        // Planes are infinite: the world view draws a finite part of each.
        OverlayItems::NONE.with(Item::Planes, true)
    };
    let shown = Shown {
        observer: Some(observer_of(document, scene, ViewSize::of_aspect(size.aspect()))),
        setup: Setup { shade: arguments.shade, items, ..Setup::default() },
        ..Shown::default()
    };
    let session = Session { shown, ..Session::default() };
    let size = [size.width(), size.height()];
    // On large pictures, strokes and text grow in proportion.
    let order = Order {
        subject: arguments.view,
        size,
        scale: scale_of(size),
        style: Style::Light,
        transparent: false,
    };
    let figure = order.figure(document, &session)?;
    Ok(figure.to_pixels().into_iter().map(|pixel| pixel.to_array()).collect())
}
