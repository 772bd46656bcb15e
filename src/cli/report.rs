//! `pinhole report`: error against run time, as a table, JSON, CSV and a plot.

use std::path::PathBuf;

use super::CommandError;
use super::load;
use super::of_scene;
use super::outputs::{Outputs, unmade};
use super::pose;
use super::progress::Progress;
use crate::cli::arguments::ReportArguments;
use crate::report::measure::Run;
use crate::report::model::Report;
use crate::report::{csv, json, plot, table};

pub(super) fn run(arguments: &ReportArguments) -> Result<(), CommandError> {
    let ReportArguments { json, csv, plot, .. } = arguments;
    let outputs = Outputs { json: json.as_deref(), csv: csv.as_deref(), plot: plot.as_deref() };
    outputs.check()?;
    let report = measured(runs(arguments)?);
    let csv = match csv {
        Some(path) => Some(csv::to_csv(&report).map_err(|error| unmade(path, &error))?),
        None => None,
    };
    outputs.deliver(
        || json::to_json(&report),
        csv,
        || plot::figure(&report),
        || table::to_table(&report),
    )
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
