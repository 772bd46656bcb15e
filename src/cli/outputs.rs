//! The outputs of a command that measures: a table on standard output, or JSON there, and files.

use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use pinhole_exchange::{atomic, scenes::builtin};
use signal_hook::consts::{SIGINT, SIGTERM};

use super::console::{named, to_stdout};
use super::error::{CommandError, unmade};
use crate::figures::{Figure, Format};
use crate::report::plot::PNG_SCALE;

/// The outputs that were asked for.
#[derive(Clone, Copy, Default)]
pub(super) struct Outputs<'a> {
    pub(super) json: Option<&'a Path>,
    pub(super) csv: Option<&'a Path>,
    pub(super) plot: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// Checks what can be told to be wrong before minutes of work.
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
        plot: impl FnOnce(f32) -> Figure,
        table: impl FnOnce() -> String,
    ) -> Result<(), CommandError> {
        let json = self.json.map(|_| json()).transpose();
        let json = json.map_err(|error| CommandError::Input(error.to_string()))?;
        let plot = match self.plot {
            Some(path) => Some((path, plotted(path, plot)?)),
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

/// The format of a plot's file, by the ending of its name.
fn format_of(plot: &Path) -> Result<Format, CommandError> {
    let is = |format: &Format| {
        plot.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(format.ending()))
    };
    [Format::Svg, Format::Png].into_iter().find(is).ok_or_else(|| {
        let (svg, png) = (plot.with_extension("svg"), plot.with_extension("png"));
        CommandError::Arguments(format!(
            "--plot writes SVG or PNG: not {} but {} or {}",
            plot.display(),
            svg.display(),
            png.display()
        ))
    })
}

/// The bytes of the plot's file; it is drawn with so many dots to a point.
fn plotted(path: &Path, plot: impl FnOnce(f32) -> Figure) -> Result<Vec<u8>, CommandError> {
    let format = format_of(path)?;
    let scale = if format == Format::Png { PNG_SCALE } else { 1.0 };
    plot(scale).to_file(format).map_err(|error| unmade(path, &error))
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
