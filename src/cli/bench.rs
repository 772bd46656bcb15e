//! `pinhole bench`: this machine's speed, as a table, JSON and a plot.

use std::path::Path;

use pinhole_yardstick::{Setting, scenes};

use super::CommandError;
use super::load;
use super::of_scene;
use super::outputs::Outputs;
use super::pose;
use super::progress::Progress;
use crate::bench::model::Bench;
use crate::bench::{measure, plot, table};
use crate::cli::arguments::BenchArguments;

pub(super) fn run(arguments: &BenchArguments) -> Result<(), CommandError> {
    let BenchArguments { scene, json, plot } = arguments;
    let outputs = Outputs { json: json.as_deref(), plot: plot.as_deref(), ..Outputs::default() };
    outputs.check()?;
    let bench = match scene {
        Some(path) => of_one(&setting(path)?),
        None => of_series(),
    };
    outputs.deliver(|| bench.to_json(), None, || plot::figure(&bench), || table::to_table(&bench))
}

fn setting(path: &Path) -> Result<Setting, CommandError> {
    let document = load(path)?;
    pose(path, &document)?;
    let scene = document.scene().map_err(|error| of_scene(path, error))?;
    Setting::new(&path.display().to_string(), scene, document.camera)
        .map_err(|error| of_scene(path, error))
}

fn of_one(setting: &Setting) -> Bench {
    let _progress = Progress::of("measuring");
    let mut bench = measure::begun();
    bench.measure(setting);
    bench
}

fn of_series() -> Bench {
    let series = scenes::growth(measure::MOST);
    let progress = Progress::of_parts(series.len());
    let mut bench = measure::begun();
    for (done, listed) in series.iter().enumerate() {
        progress.reach(done);
        bench.measure(&listed.make());
    }
    bench
}
