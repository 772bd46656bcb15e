//! `pinhole report`: error against run time, as a table, JSON, CSV and a plot.

use std::path::PathBuf;

use super::error::{CommandError, scene_fault, unmade};
use super::load::{load, pose};
use super::outputs::Outputs;
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
        |scale| plot::figure(&report, scale),
        || table::to_table(&report),
    )
}

/// The runs to measure. Every scene is read before the first is measured.
fn runs(arguments: &ReportArguments) -> Result<Vec<Run>, CommandError> {
    if arguments.scenes.is_empty() {
        return Ok(vec![Run::of_families(arguments.seed)]);
    }
    let run_of = |path: &PathBuf| {
        let document = load(path)?;
        pose(path, &document)?;
        let scene = document.scene().map_err(|error| scene_fault(path, error))?;
        Run::of_scene(&path.display().to_string(), &scene, &document.camera)
            .map_err(|error| scene_fault(path, error))
    };
    arguments.scenes.iter().map(run_of).collect()
}

/// Measures them one after the other; the report is about all of them.
fn measured(mut runs: Vec<Run>) -> Report {
    let progress = Progress::counting("step", runs.iter().map(Run::total).sum());
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
