//! `pinhole render`: writes the picture as PNG, and the hits as OpenEXR.

use std::io::{BufWriter, Write};

use pinhole_core::{
    Certificate, Frame, ImageSize, Level, Outputs, Raster, Scene, shade, trace_at_level,
};
use pinhole_exchange::atomic::{self, Batch, is_same_file};
use pinhole_exchange::document::Document;
use pinhole_exchange::images::png;

use super::console::{CommandError, is_standard, named, not_built, scene_fault, to_stdout};
use super::load::{files_of, load, pose, refuse_overwriting, size};
use super::progress::Progress;
use crate::cli::arguments::RenderArguments;
use crate::figures::{FigureSubject, Order, scale_of};
use crate::model::{Item, Observer, OverlayItems, Session, Settings, ViewSize};
use crate::view::overlay::Style;

pub(super) fn run(arguments: &RenderArguments) -> Result<(), CommandError> {
    if let Some(aov) = &arguments.aov {
        if !cfg!(feature = "exr") {
            return Err(not_built("--aov", "exr"));
        }
        if arguments.view == FigureSubject::World {
            let problem = "--aov writes what the camera's rays meet: leave out --view world";
            return Err(CommandError::Arguments(problem.to_owned()));
        }
        if is_same_file(aov, &arguments.output) {
            let problem = format!("--aov and -o both write {}", aov.display());
            return Err(CommandError::Arguments(problem));
        }
    }
    let output = Some(&arguments.output).filter(|output| !is_standard(output));
    if arguments.aov.as_deref().is_some_and(is_standard) {
        return Err(CommandError::Arguments("--aov needs a file: - is for -o".to_owned()));
    }
    named(&arguments.output, "png", "-o writes PNG")?;
    if let Some(aov) = &arguments.aov {
        named(aov, "exr", "--aov writes OpenEXR")?;
    }
    for file in [output, arguments.aov.as_ref()].into_iter().flatten() {
        atomic::check(file)?;
    }
    let document = load(&arguments.scene)?;
    pose(&arguments.scene, &document)?;
    let aov = arguments.aov.as_deref().map(|aov| ("--aov", aov));
    let outputs = output.map(|output| ("-o", output.as_path())).into_iter().chain(aov);
    refuse_overwriting(&files_of(&arguments.scene, &document), outputs)?;
    let scene_image = document.camera.image;
    let image =
        size(arguments.width, arguments.height, [scene_image.width(), scene_image.height()])?;
    // Each row is traced. For the OpenEXR file, the pixels' certificates are computed in a second pass.
    let passes = 1 + usize::from(arguments.aov.is_some());
    let progress = Progress::new("row", passes * image.height() as usize);
    let rendering = render_view(&document, arguments, image, |rows| progress.add(rows))
        .map_err(|error| scene_fault(&arguments.scene, error))?;
    let mut batch = Batch::default();
    let size = [image.width(), image.height()];
    let encode = |out: &mut dyn Write| png::encode(out, size, &rendering.pixels, false);
    if let Some(output) = output {
        batch.add(output, |file| encode(&mut BufWriter::new(file)))?;
    }
    #[cfg(feature = "exr")]
    if let (Some(aov), Some(frame)) = (&arguments.aov, &rendering.frame) {
        batch.add(aov, |file| {
            pinhole_exchange::images::exr::encode(file, frame, &rendering.certificates)
        })?;
    }
    batch.finish()?;
    if output.is_none() { to_stdout(encode) } else { Ok(()) }
}

/// A finished picture.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// Opaque sRGB pixels with alpha 255, row by row from the top.
    pub pixels: Vec<[u8; 4]>,
    /// Hits of the camera's rays, pixel by pixel; `None` if they were neither requested nor needed.
    pub frame: Option<Frame<f32>>,
    /// The certificate of each pixel: which arithmetic its hardest decision needed, and with which margin.
    /// Empty unless requested.
    pub certificates: Vec<Certificate>,
}

/// Draws the requested view of the document at this size. Calls `done` whenever rows are finished, with their
/// number.
///
/// If the size differs from that of the document's image, the camera view is traced with an image of this
/// size. The world view, on the other hand, shows the camera's own pixels on its viewport.
///
/// # Errors
/// Returns an error if the camera sees nothing, or an object is invalid.
pub fn render_view(
    document: &Document,
    arguments: &RenderArguments,
    size: ImageSize,
    done: impl Fn(usize) + Sync,
) -> Result<Rendering, CommandError> {
    let input = |error: &dyn std::fmt::Display| CommandError::Input(error.to_string());
    let RenderArguments { view, overlay, shade: mode, .. } = *arguments;
    let aov = arguments.aov.is_some();
    let mut document = document.clone();
    if view == FigureSubject::Camera {
        document.camera.image = size;
    }
    let camera = document.camera.resolve().map_err(|error| input(&error))?;
    let scene = document.scene().map_err(|error| input(&error))?;
    let trace = || {
        let outputs = Outputs { normal: aov, ..Outputs::default() };
        let raster = Raster::full(camera.image());
        trace_at_level(Level::new(), &scene, &camera, &raster, outputs, &done)
    };
    let certificates = || {
        let [rows, columns] = [size.height(), size.width()];
        let [rows, columns] = [rows, columns].map(|n| (0..n).collect::<Vec<_>>());
        if aov { scene.certificates(&camera, &rows, &columns, &done) } else { Vec::new() }
    };
    if view == FigureSubject::Camera && !overlay {
        let frame = trace();
        let color_of = |object| document.color_of(object);
        let pixels = shade(&frame, &scene, mode, color_of, |[r, g, b]| [r, g, b, 255]);
        return Ok(Rendering { pixels, frame: Some(frame), certificates: certificates() });
    }
    let pixels = with_overlay(&document, &scene, arguments, size).map_err(CommandError::Input)?;
    if !aov {
        done(size.height() as usize);
        return Ok(Rendering { pixels, frame: None, certificates: Vec::new() });
    }
    Ok(Rendering { pixels, frame: Some(trace()), certificates: certificates() })
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
    let session = Session {
        observer: Some(Observer::of_scene(document, scene, ViewSize::of_aspect(size.aspect()))),
        settings: Settings { shade: arguments.shade, items, ..Settings::default() },
        ..Session::default()
    };
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
