//! `pinhole figure`: writes a view, the derivation or two lines in the plane as SVG, PDF
//! or PNG. The derivation can also be LaTeX or Markdown.

use std::ffi::OsStr;
use std::path::Path;

use pinhole_core::ImageSize;
use pinhole_exchange::{Document, atomic};
use pinhole_figure::export::FigureFormat;
use pinhole_figure::overlay::observer_of;
use pinhole_figure::{Item, ViewSize};

use super::console::{CommandError, is_standard, refused, scene_fault, unmade};
use super::load::{deliver, files_of, follow, load, pose, selection_of, size};
use crate::cli::arguments::FigureArguments;
use crate::features::export::order::{Content, FigureSubject, Order, derivation_of, scale_of};
use crate::model::Session;

/// The default size of a figure of the world view, in pixels.
const WORLD: [u32; 2] = [1920, 1080];
/// The default size of a figure of two lines in the plane, in pixels.
const LINES: [u32; 2] = [1280, 960];
/// The default size of a figure of the derivation, in pixels. Its final height depends on its lines.
const DERIVATION: [u32; 2] = [1600, 1600];
/// The width, in points, for which the derivation in a figure is laid out.
const DERIVATION_POINTS: f32 = 800.0;
/// The shorter side, in points, for which two lines in the plane in a figure is laid out.
const LINES_POINTS: f32 = 640.0;

pub(super) fn run(arguments: &FigureArguments) -> Result<(), CommandError> {
    let output = Some(&arguments.output).filter(|output| !is_standard(output));
    let content = match output {
        Some(output) => Content::for_path(arguments.view, output)
            .map_err(|problem| CommandError::Arguments(format!("-o {problem}{}", hint(output))))?,
        // Standard output has no extension that could choose another format.
        None => Content::Figure(FigureFormat::Svg),
    };
    check_idle(arguments, content)?;
    if let Some(output) = output {
        atomic::check(output)?;
    }
    let document = load(&arguments.scene)?;
    let order = order_of(arguments, document.camera.image)?;
    let session = session_of(arguments, &document, order.size)?;
    let bytes = match content {
        Content::Text(markup) => derivation_of(&document, &session).written_in(markup).into_bytes(),
        Content::Figure(format) => {
            let why = |problem| scene_fault(&arguments.scene, problem);
            let figure = order.figure_as(format, &document, &session).map_err(why)?;
            figure.to_file(format).map_err(|error| unmade(&arguments.output, &error))?
        }
    };
    let inputs = files_of(&arguments.scene, &document);
    deliver(Some(&arguments.output), &inputs, |out| out.write_all(&bytes))
}

/// Returns what to add to the error for a file's extension that other arguments would allow.
fn hint(output: &Path) -> &'static str {
    match output.extension().and_then(OsStr::to_str) {
        Some("tex" | "md") => "; LaTeX and Markdown are for --view derivation",
        _ => "",
    }
}

/// Rejects options that would have no effect.
fn check_idle(arguments: &FigureArguments, content: Content) -> Result<(), CommandError> {
    let FigureArguments { view, output, width, height, transparent, .. } = arguments;
    if !matches!(content, Content::Figure(_)) {
        let given = [
            ("--width", width.is_some()),
            ("--height", height.is_some()),
            ("--transparent", *transparent),
        ];
        if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
            let output = output.display();
            return refused(format!("{name} is for pictures: leave it out, {output} is text"));
        }
    }
    if *view == FigureSubject::Derivation && height.is_some() {
        return refused("the derivation is as high as its lines: leave out --height, give --width");
    }
    Ok(())
}

fn order_of(arguments: &FigureArguments, image: ImageSize) -> Result<Order, CommandError> {
    let FigureArguments { view: subject, style, transparent, width, height, .. } = *arguments;
    let size = match subject {
        FigureSubject::World => size(width, height, WORLD)?,
        FigureSubject::Camera => in_proportion(arguments, image)?,
        FigureSubject::Lines => size(width, height, LINES)?,
        FigureSubject::Derivation => size(width, None, DERIVATION)?,
    };
    let size = [size.width(), size.height()];
    let least = size[0].min(size[1]) as f32;
    let scale = match subject {
        FigureSubject::World | FigureSubject::Camera => scale_of(size),
        FigureSubject::Derivation => least / DERIVATION_POINTS,
        FigureSubject::Lines => least / LINES_POINTS,
    };
    Ok(Order { subject, size, scale, style, transparent })
}

/// Returns the session with which the document is drawn: the session of a new window, but without a
/// ray unless a ray is requested.
fn session_of(
    arguments: &FigureArguments,
    document: &Document,
    [width, height]: [u32; 2],
) -> Result<Session, CommandError> {
    let FigureArguments { scene, view, ray, .. } = arguments;
    let mut session = Session::default();
    // A picture in a file has no handles.
    session.shown.setup.items.set(Item::Handles, false);
    let asked = ray.is_given();
    let sees = matches!(view, FigureSubject::World | FigureSubject::Camera);
    // The derivation of a camera without a basis shows where it fails.
    if asked || sees {
        let asked = selection_of(scene, &pose(scene, document)?, *ray)?;
        session.shown.selection = asked.unwrap_or(session.shown.selection);
    }
    if sees {
        let objects = document.scene().map_err(|error| scene_fault(scene, error))?;
        let size = ViewSize::of_aspect(f64::from(width) / f64::from(height));
        session.shown.observer = Some(observer_of(document, &objects, size));
    }
    if !asked {
        for item in [Item::Ray, Item::Hit] {
            session.shown.setup.items.set(item, false);
        }
    }
    Ok(session)
}

/// Returns the size of a figure of the camera view, in pixels. It has the aspect ratio of the camera's image
/// and, by default, is a whole multiple of that image's size if possible.
fn in_proportion(arguments: &FigureArguments, image: ImageSize) -> Result<ImageSize, CommandError> {
    let (columns, rows) = (image.width(), image.height());
    let times = (WORLD[1] / columns.min(rows)).max(1).min(ImageSize::MAX / columns.max(rows));
    let size = size(arguments.width, arguments.height, [columns * times, rows * times])?;
    let (width, height) = (size.width(), size.height());
    let fits = follow(width, 1.0 / image.aspect()).abs_diff(height) <= 1
        || follow(height, image.aspect()).abs_diff(width) <= 1;
    if fits {
        return Ok(size);
    }
    refused(format!(
        "{width} x {height} is not in the proportions of the camera's image, {columns} x {rows} \
         pixels: leave out --width or --height"
    ))
}
