//! `pinhole report`: error against run time, as a table, JSON, CSV and a plot.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};

use super::progress::Progress;
use super::{CommandError, load, named, of_scene, pose, to_stdout};
use crate::arguments::ReportArguments;
use crate::formats::{FileError, atomic, builtin, png};
use crate::report::measure::Run;
use crate::report::model::Report;
use crate::report::{csv, json, plot, table};

pub(super) fn run(arguments: &ReportArguments) -> Result<(), CommandError> {
    check(arguments)?;
    let report = measured(runs(arguments)?);
    // All of them are whole in memory before the first is written.
    let json = arguments.json.as_ref().map(|_| json::to_json(&report)).transpose();
    let json = json.map_err(|error| CommandError::Input(error.to_string()))?;
    let csv = match &arguments.csv {
        Some(path) => Some((path, csv::to_csv(&report).map_err(|error| unmade(path, &error))?)),
        None => None,
    };
    let plot = match &arguments.plot {
        Some(path) => Some((path, plotted(path, &report)?)),
        None => None,
    };
    let file_of_json = arguments.json.as_ref().filter(|path| !is_stdout(path));
    let json_to_file = file_of_json.zip(json.as_ref().map(|json| json.clone().into_bytes()));
    write_all([json_to_file, csv, plot].into_iter().flatten())?;
    let text = match json {
        Some(json) if file_of_json.is_none() => json,
        _ => table::to_table(&report),
    };
    to_stdout(|out| out.write_all(text.as_bytes()))
}

/// What can be told to be wrong before minutes of work.
fn check(arguments: &ReportArguments) -> Result<(), CommandError> {
    let ReportArguments { json, csv, plot, .. } = arguments;
    for (name, path) in [("--csv", csv), ("--plot", plot)] {
        if path.as_deref().is_some_and(is_stdout) {
            let problem = format!("{name} needs a file: only --json can go to standard output");
            return Err(CommandError::Arguments(problem));
        }
    }
    if let Some(json) = json.as_deref().filter(|json| !is_stdout(json)) {
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
    let outputs = [("--json", json), ("--csv", csv), ("--plot", plot)];
    let outputs = outputs.map(|(name, path)| Some((name, path.as_ref()?)));
    let outputs: Vec<_> =
        outputs.into_iter().flatten().filter(|(_, path)| !is_stdout(path)).collect();
    for (index, (name, path)) in outputs.iter().enumerate() {
        if let Some((other, _)) = outputs[..index].iter().find(|(_, earlier)| earlier == path) {
            let problem = format!("{other} and {name} both write {}", path.display());
            return Err(CommandError::Arguments(problem));
        }
        atomic::check(path)?;
    }
    Ok(())
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

/// What is to be measured. Every scene is read before the first is measured.
fn runs(arguments: &ReportArguments) -> Result<Vec<Run>, CommandError> {
    if arguments.scenes.is_empty() {
        return Ok(vec![Run::of_families(arguments.seed)]);
    }
    let run_of = |path: &PathBuf| {
        let document = load(path)?;
        pose(path, &document)?;
        let scene = document.scene().map_err(|error| of_scene(path, error))?;
        Run::of_scene(&path.display().to_string(), &scene, &document.camera)
            .map_err(|error| of_scene(path, error))
    };
    arguments.scenes.iter().map(run_of).collect()
}

/// Measures them one after the other; the report is about all of them.
fn measured(mut runs: Vec<Run>) -> Report {
    let progress = Progress::of_parts(runs.iter().map(Run::total).sum());
    let (mut done, mut all) = (0, Report::default());
    for run in &mut runs {
        while !run.is_done() {
            run.step();
            progress.reach(done + run.done());
        }
        done += run.total();
        all.append(run.report());
    }
    all
}

/// The bytes of the plot's file.
fn plotted(path: &Path, report: &Report) -> Result<Vec<u8>, CommandError> {
    let figure = plot::figure(report);
    match format_of(path)? {
        PlotFormat::Svg => Ok(figure.to_svg().into_bytes()),
        PlotFormat::Png => {
            let raster = figure.to_pixels(plot::PNG_SCALE);
            let mut bytes = Vec::new();
            png::encode(&mut bytes, raster.width, raster.height, &raster.pixels)
                .map_err(|error| unmade(path, &error))?;
            Ok(bytes)
        }
    }
}

fn unmade(path: &Path, error: &dyn std::fmt::Display) -> CommandError {
    FileError::of_file(path, format!("cannot be made: {error}")).into()
}

/// Writes the files, each as a whole. Ctrl-C waits for that moment, so that no temporary file stays
/// behind either.
fn write_all<'a>(files: impl Iterator<Item = (&'a PathBuf, Vec<u8>)>) -> Result<(), CommandError> {
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
