//! Where a command that measures puts what it found: a table on standard output, or JSON there, and
//! files.

use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};

use super::CommandError;
use super::named;
use super::to_stdout;
use crate::chart::{Figure, PNG_SCALE};
use pinhole_exchange::images::png;
use pinhole_exchange::scenes::builtin;
use pinhole_exchange::{FileError, atomic};

/// The outputs that were asked for.
#[derive(Clone, Copy, Default)]
pub(super) struct Outputs<'a> {
    pub(super) json: Option<&'a Path>,
    pub(super) csv: Option<&'a Path>,
    pub(super) plot: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// What can be told to be wrong before minutes of work.
    pub(super) fn check(&self) -> Result<(), CommandError> {
        let Outputs { csv, plot, .. } = *self;
        for (name, path) in [("--csv", csv), ("--plot", plot)] {
            if path.is_some_and(is_stdout) {
                let problem = format!("{name} needs a file: only --json can go to standard output");
                return Err(CommandError::Arguments(problem));
            }
        }
        if let Some(json) = self.json_file() {
            if is_scene(json) {
                let problem = format!(
                    "--json takes {0} as the file to write: put scenes first, as in {0} --json",
                    json.display()
                );
                return Err(CommandError::Arguments(problem));
            }
            named(json, "json", "--json writes JSON")?;
        }
        if let Some(csv) = csv {
            named(csv, "csv", "--csv writes CSV")?;
        }
        if let Some(plot) = plot {
            format_of(plot)?;
        }
        let files = [("--json", self.json_file()), ("--csv", csv), ("--plot", plot)];
        let files: Vec<(&str, &Path)> =
            files.into_iter().filter_map(|(name, path)| Some((name, path?))).collect();
        for (index, (name, path)) in files.iter().enumerate() {
            if let Some((other, _)) = files[..index].iter().find(|(_, earlier)| earlier == path) {
                let problem = format!("{other} and {name} both write {}", path.display());
                return Err(CommandError::Arguments(problem));
            }
            atomic::check(path)?;
        }
        Ok(())
    }

    /// Writes what was made. All of it is whole in memory before the first file is written.
    pub(super) fn deliver(
        &self,
        json: impl FnOnce() -> serde_json::Result<String>,
        csv: Option<Vec<u8>>,
        figure: impl FnOnce() -> Figure,
        table: impl FnOnce() -> String,
    ) -> Result<(), CommandError> {
        let json = self.json.map(|_| json()).transpose();
        let json = json.map_err(|error| CommandError::Input(error.to_string()))?;
        let plot = match self.plot {
            Some(path) => Some((path, plotted(path, &figure())?)),
            None => None,
        };
        let bytes = json.as_ref().map(|json| json.clone().into_bytes());
        write_all([self.json_file().zip(bytes), self.csv.zip(csv), plot].into_iter().flatten())?;
        let text = match json {
            Some(json) if self.json_file().is_none() => json,
            _ => table(),
        };
        to_stdout(|out| out.write_all(text.as_bytes()))
    }

    fn json_file(&self) -> Option<&'a Path> {
        self.json.filter(|path| !is_stdout(path))
    }
}

/// `--json` without a path, or with the sign for standard output.
fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// A path that is meant to be read, not written.
fn is_scene(path: &Path) -> bool {
    let ends_as_one = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    ends_as_one || path.to_str().is_some_and(|name| builtin::find(name).is_some())
}

/// What a plot is written as.
#[derive(Clone, Copy)]
enum PlotFormat {
    Svg,
    Png,
}

fn format_of(plot: &Path) -> Result<PlotFormat, CommandError> {
    match plot.extension() {
        Some(ending) if ending.eq_ignore_ascii_case("svg") => Ok(PlotFormat::Svg),
        Some(ending) if ending.eq_ignore_ascii_case("png") => Ok(PlotFormat::Png),
        _ => {
            let (svg, png) = (plot.with_extension("svg"), plot.with_extension("png"));
            Err(CommandError::Arguments(format!(
                "--plot writes SVG or PNG: not {} but {} or {}",
                plot.display(),
                svg.display(),
                png.display()
            )))
        }
    }
}

/// The bytes of the plot's file.
fn plotted(path: &Path, figure: &Figure) -> Result<Vec<u8>, CommandError> {
    match format_of(path)? {
        PlotFormat::Svg => Ok(figure.to_svg().into_bytes()),
        PlotFormat::Png => {
            let raster = figure.to_pixels(PNG_SCALE);
            let mut bytes = Vec::new();
            png::encode(&mut bytes, raster.width, raster.height, &raster.pixels)
                .map_err(|error| unmade(path, &error))?;
            Ok(bytes)
        }
    }
}

/// A file whose bytes could not be made.
pub(super) fn unmade(path: &Path, error: &dyn std::fmt::Display) -> CommandError {
    FileError::of_file(path, format!("cannot be made: {error}")).into()
}

/// Writes the files, each as a whole. Ctrl-C waits for that moment, so that no temporary file stays
/// behind either.
fn write_all<'a>(files: impl Iterator<Item = (&'a Path, Vec<u8>)>) -> Result<(), CommandError> {
    let held = Held::new();
    for (path, bytes) in files {
        atomic::write(path, |file| file.write_all(&bytes))?;
    }
    drop(held);
    Ok(())
}

/// While it lives, the signals that end a program are not followed.
struct Held {
    over: Arc<AtomicBool>,
}

impl Held {
    fn new() -> Held {
        let over = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            // Where a signal cannot be held, it ends the program as ever.
            let _ = signal_hook::flag::register_conditional_default(signal, Arc::clone(&over));
        }
        Held { over }
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.over.store(true, Ordering::SeqCst);
    }
}
