//! `pinhole render`: the picture as PNG, and what the rays meet as OpenEXR.

use std::io::{BufWriter, Write};

use pinhole_exchange::atomic::{self, Batch, is_same_file};
use pinhole_exchange::images::png;

use super::console::{named, to_stdout};
use super::error::{CommandError, not_built, scene_fault};
use super::load::{apart, files_of, load, pose};
use super::progress::Progress;
use super::render_view::{RenderOptions, render_view};
use super::size::size;
use super::standard::is_standard;
use crate::cli::arguments::{RenderArguments, View};

pub(super) fn run(arguments: &RenderArguments) -> Result<(), CommandError> {
    if let Some(aov) = &arguments.aov {
        if !cfg!(feature = "exr") {
            return Err(not_built("--aov", "exr"));
        }
        if arguments.view == View::World {
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
    apart(&files_of(&arguments.scene, &document), outputs)?;
    let own = document.camera.image;
    let image = size(arguments.width, arguments.height, [own.width(), own.height()])?;
    let options = RenderOptions {
        size: image,
        view: arguments.view,
        overlay: arguments.overlay,
        shade: arguments.shade,
        aov: arguments.aov.is_some(),
    };
    let progress = if arguments.overlay || arguments.view == View::World {
        Progress::during("drawing")
    } else {
        // Each row is traced, and for the other file asked how surely.
        let passes = 1 + usize::from(options.aov);
        Progress::counting("row", passes * image.height() as usize)
    };
    let rendering = render_view(&document, options, |rows| progress.add(rows))
        .map_err(|error| scene_fault(&arguments.scene, error))?;
    progress.go_on("writing");
    let mut batch = Batch::default();
    let encode =
        |out: &mut dyn Write| png::encode(out, image.width(), image.height(), &rendering.pixels);
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
