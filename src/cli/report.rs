//! `pinhole report`: writes error against run time as a table, JSON and a plot.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use pinhole_exchange::atomic::{self, Batch, is_same_file};
use pinhole_exchange::scenes::BuiltinScene;
use pinhole_figure::export::FigureFormat;

use super::console::{
    CommandError, is_standard, named, refused, scene_fault, to_json, to_stdout, unmade,
};
use super::load::{files_of, load, pose, refuse_overwriting};
use super::progress::Progress;
use crate::cli::arguments::ReportArguments;
use crate::features::export::order::by_ending;
use crate::report::measure::Measurement;
use crate::report::model::Report;
use crate::report::plot::{self, PNG_SCALE};
use crate::report::table;

pub(super) fn run(arguments: &ReportArguments) -> Result<(), CommandError> {
    check(arguments)?;
    deliver(arguments, &measured(runs(arguments)?))
}

/// Checks the arguments before the measurements, which take minutes.
fn check(arguments: &ReportArguments) -> Result<(), CommandError> {
    if arguments.plot.as_deref().is_some_and(is_standard) {
        return refused("--plot needs a file: only --json can go to standard output");
    }
    if let Some(json) = json_file(arguments) {
        if is_scene(json) {
            return refused(format!(
                "--json takes {0} as the file to write: put scenes first, as in {0} --json",
                json.display()
            ));
        }
        named(json, "json", "--json writes JSON")?;
    }
    if let Some(plot) = &arguments.plot {
        format_of(plot)?;
    }
    if let (Some(json), Some(plot)) = (json_file(arguments), &arguments.plot)
        && is_same_file(json, plot)
    {
        return refused(format!("--json and --plot both write {}", plot.display()));
    }
    files(arguments).try_for_each(|(_, path)| Ok(atomic::check(&path)?))
}

/// Returns the files to write, each with the option that names it. The plot of several scenes has a page
/// for each, after the summary.
fn files(arguments: &ReportArguments) -> impl Iterator<Item = (&str, PathBuf)> {
    let pages = match arguments.scenes.len() {
        scenes @ 2.. => scenes + 1,
        _ => 1,
    };
    let pages_of = move |plot| (1..=pages).map(move |page| ("--plot", page_path(plot, page)));
    let json = json_file(arguments).map(|json| ("--json", json.to_owned()));
    json.into_iter().chain(arguments.plot.as_deref().into_iter().flat_map(pages_of))
}

/// Returns the measurements to make. Every scene is read before the first one is measured.
fn runs(arguments: &ReportArguments) -> Result<Vec<Measurement>, CommandError> {
    if arguments.scenes.is_empty() {
        return Ok(vec![Measurement::of_families(arguments.seed)]);
    }
    let run_of = |path: &PathBuf| {
        let document = load(path)?;
        pose(path, &document)?;
        refuse_overwriting(&files_of(path, &document), files(arguments))?;
        let scene = document.scene().map_err(|error| scene_fault(path, error))?;
        Measurement::of_scene(&path.display().to_string(), &scene, &document.camera)
            .map_err(|error| scene_fault(path, error))
    };
    arguments.scenes.iter().map(run_of).collect()
}

/// Makes the measurements one after the other; the report contains all of them.
fn measured(mut runs: Vec<Measurement>) -> Report {
    let progress = Progress::new("step", runs.iter().map(Measurement::total).sum());
    let mut all = Report::default();
    for run in &mut runs {
        while !run.is_done() {
            let done = run.done();
            run.step();
            progress.add(run.done().saturating_sub(done));
        }
        all.append(run.report());
    }
    all
}

/// Writes the requested files, and the table or the JSON to standard output. All outputs are
/// complete in memory before the first file is written.
fn deliver(arguments: &ReportArguments, report: &Report) -> Result<(), CommandError> {
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    let mut text = table::to_table(report);
    if arguments.json.is_some() {
        let json = to_json(report)?;
        match json_file(arguments) {
            Some(path) => files.push((path.to_owned(), json.into_bytes())),
            None => text = json,
        }
    }
    if let Some(path) = &arguments.plot {
        let format = format_of(path)?;
        let scale = if format == FigureFormat::Png { PNG_SCALE } else { 1.0 };
        for (page, figure) in (1..).zip(plot::pages(report, scale)) {
            let path = page_path(path, page);
            let bytes = figure.to_file(format).map_err(|error| unmade(&path, &error))?;
            files.push((path, bytes));
        }
    }
    let mut batch = Batch::default();
    for (path, bytes) in &files {
        batch.add(path, |file| file.write_all(bytes))?;
    }
    batch.finish()?;
    to_stdout(|out| out.write_all(text.as_bytes()))
}

/// Returns the file for a page of the plot: `a.png`, `a-2.png`, `a-3.png` and so on.
fn page_path(plot: &Path, page: usize) -> PathBuf {
    let (stem, ending) = (plot.file_stem(), plot.extension());
    match (page, stem, ending) {
        (2.., Some(stem), Some(ending)) => {
            let mut name = stem.to_owned();
            name.push(format!("-{page}."));
            name.push(ending);
            plot.with_file_name(name)
        }
        _ => plot.to_owned(),
    }
}

/// Returns the path of the JSON file. Returns `None` without `--json`, and also for `--json` without a
/// path or with `-`, which writes to standard output.
fn json_file(arguments: &ReportArguments) -> Option<&Path> {
    arguments.json.as_deref().filter(|path| !is_standard(path))
}

/// Returns true if a path looks like an input: a TOML file or a built-in scene.
fn is_scene(path: &Path) -> bool {
    let ends_as_one = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    ends_as_one || path.to_str().is_some_and(|name| BuiltinScene::find(name).is_some())
}

/// Returns the format of a plot's file, from its extension.
fn format_of(plot: &Path) -> Result<FigureFormat, CommandError> {
    let formats = [("svg", FigureFormat::Svg), ("png", FigureFormat::Png)];
    by_ending(plot, &formats, "SVG or PNG")
        .map_err(|problem| CommandError::Arguments(format!("--plot {problem}")))
}
