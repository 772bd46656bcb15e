//! Measures the time per frame for growing numbers of spheres, and in scenes that are hard to draw
//! fast. It compares `pinhole-core` (called the ladder, because its decisions escalate from `f64` to
//! exact integers) with the textbook's loop over all spheres, that loop with a bounding volume
//! hierarchy, non-temporal stores of a frame's bytes and, on request, Embree. The contestants draw
//! frames in turn. A sample of the ladder's pixels is checked against exactly computed hits.
//!
//! `cargo bench -p pinhole-core --bench speed -- [WORD...] [embree] [threads=N,...] [avx2] [quick]`
//!
//! - A word selects scenes: a group (`growth`, `adversarial`, `sizes`), a scene's name (`N=1000`), or
//!   part of a name (`overdraw`). Without a word, the scenes whose speeds are published are selected.
//! - `embree` times Embree instead of the textbook's loops: once with its built-in spheres, and with
//!   user geometry whose intersection test takes 16 rays at a time. This needs the library (Debian's
//!   `libembree-dev`) and a C++ compiler.
//! - `threads=1,2` (the default) lists the numbers of threads to measure with. `avx2` limits the ladder
//!   to AVX2; `quick` times only a few frames.
//!
//! Writing a frame with non-temporal (streaming) stores, and doing nothing else, takes the least time
//! in which any program can write a frame past the caches. This program is compiled by `c++`, or by the
//! C++ compiler that `CXX` names; without a compiler, it is left out. If other processes use the
//! machine at the same time, minima are more meaningful than medians; a warning says so where the
//! system reports such use.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints and may fail")]

mod yardstick;

use std::path::Path;
use std::time::Duration;

use pinhole_core::Level;
use yardstick::contest::{self, LADDER, Limits, Outcome};
use yardstick::machine::Watch;
use yardstick::rig::{EMBREE, Program, Rig, STREAMING};
use yardstick::rounds::Times;
use yardstick::scenes::{self, Listed, STATED};
use yardstick::{Setting, check};

/// Number of spheres from which fewer pixels are checked, because each check tests all spheres.
const MANY: usize = 100_000;

/// The machine counts as shared if other processes keep this many processors busy on average.
const SHARED: f64 = 0.1;

/// The measurements of a scene.
struct Measured {
    name: &'static str,
    group: &'static str,
    spheres: usize,
    pixels: usize,
    coverage: f64,
    /// Decisions for each covered pixel.
    decided: f64,
    /// For each number of threads.
    outcomes: Vec<Outcome>,
    /// Number of processors that other processes kept busy meanwhile.
    others: f64,
}

fn main() {
    // Cargo adds --bench.
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let has = |option: &str| words.iter().any(|word| word == option);
    let threads = words.iter().find_map(|word| word.strip_prefix("threads=")).unwrap_or("1,2");
    let threads: Vec<usize> = threads.split(',').map(|number| number.parse().unwrap()).collect();
    let level = if has("avx2") { avx2() } else { Level::new() };
    let share = Duration::from_millis(if has("quick") { 150 } else { 1500 });
    let patience = Duration::from_secs(if has("embree") { 0 } else { 30 });
    let limits = Limits { level, share, patience, ..Limits::default() };
    let options = |word: &&String| {
        !["avx2", "quick", "embree"].contains(&word.as_str()) && !word.starts_with("threads=")
    };
    let wanted: Vec<&str> = words.iter().filter(options).map(String::as_str).collect();
    let chosen: Vec<Listed> =
        scenes::all().into_iter().filter(|listed| is_wanted(listed, &wanted)).collect();
    assert!(!chosen.is_empty(), "no scene is called {wanted:?}");
    let programs = programs(has("embree"));
    // Only the name of the level, without its fields.
    let level = format!("{:?}", limits.level);
    println!("{}, t as f32 and object as u32 of every pixel", level.split('(').next().unwrap());
    println!("ratio: a method's median time over the ladder's\n");
    let measured: Vec<Measured> =
        chosen.iter().map(|listed| measure(listed, &limits, &threads, &programs)).collect();
    warn(measured.iter().map(|scene| scene.others).fold(0.0, f64::max));
    show_table("medians", &measured, &threads, |times| times.median);
    show_table("minima", &measured, &threads, |times| times.min);
    show_growth(&measured);
}

fn avx2() -> Level {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return Level::Avx2(Level::new().as_avx2().expect("this processor has no AVX2"));
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    panic!("this processor has no AVX2");
}

fn is_wanted(listed: &Listed, wanted: &[&str]) -> bool {
    if wanted.is_empty() {
        return STATED.contains(&listed.name);
    }
    wanted.contains(&listed.name)
        || (listed.name != "N=1e7" && wanted.contains(&listed.group))
        || wanted.iter().any(|word| !word.starts_with("N=") && listed.name.contains(word))
}

/// Builds the C++ programs to compare with: the streaming stores, unless they fail to compile and, if
/// `with_embree` is true, Embree.
fn programs(with_embree: bool) -> Vec<Program> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("speed");
    let stores = Program::stores(&folder)
        .inspect_err(|error| println!("the limit is not known, without streaming stores: {error}"));
    let embree = with_embree.then(|| {
        Program::embree(&folder).unwrap_or_else(|error| {
            panic!("Embree is in Debian's libembree-dev, and needs a C++ compiler\n{error}")
        })
    });
    stores.into_iter().chain(embree).collect()
}

fn measure(listed: &Listed, limits: &Limits, threads: &[usize], programs: &[Program]) -> Measured {
    let watch = Watch::start();
    let setting = (listed.make)();
    let mut rigs: Vec<Rig> =
        programs.iter().map(|program| program.start(&setting).unwrap()).collect();
    let run = |threads: &usize| {
        contest::run(&setting, &Limits { threads: *threads, ..*limits }, &mut rigs)
    };
    let outcomes: Vec<Outcome> = threads.iter().map(run).collect();
    let frame = &outcomes[0].frame;
    let coverage = check::coverage(&frame.object);
    let decided = frame.steps.total() as f64 / (coverage * setting.pixels() as f64).max(1.0);
    let mut measured = Measured {
        name: listed.name,
        group: listed.group,
        spheres: setting.scene.len(),
        pixels: setting.pixels(),
        coverage,
        decided,
        outcomes,
        others: 0.0,
    };
    show(&measured, &setting, threads, &mut rigs);
    drop(rigs);
    measured.others = watch.others().unwrap_or(0.0);
    warn(measured.others);
    println!();
    measured
}

fn warn(others: f64) {
    if others > SHARED {
        println!("WARNING: the machine is shared: others kept {others:.1} processors busy");
    }
}

fn show(measured: &Measured, setting: &Setting, threads: &[usize], rigs: &mut [Rig]) {
    let Measured { name, spheres, coverage, decided, outcomes, .. } = measured;
    let (image, sample) = (setting.image(), if *spheres >= MANY { 100 } else { 500 });
    println!(
        "{name}: {spheres} spheres, {} x {}, {:.1} % covered, {decided:.2} decisions a covered pixel, \
         {sample} pixels checked",
        image.width(),
        image.height(),
        100.0 * coverage,
    );
    println!("  {:18} {:>10} {:>10} {:>10} {:>9}", "", "median ms", "min ms", "Mrays/s", "ratio");
    for (outcome, threads) in outcomes.iter().zip(threads) {
        if let Err(fault) = check::sample(&setting.scene, &outcome.frame, sample, 1) {
            panic!("{name} is wrong: {fault}");
        }
        for (name, times) in &outcome.rows {
            println!(
                "  {:18} {:10.4} {:10.4} {:10.1} {:9.3}  {} frames, {} threads",
                name,
                1e3 * times.median,
                1e3 * times.min,
                1e-6 * setting.pixels() as f64 / times.median,
                times.median / outcome.rows[0].1.median,
                times.count,
                threads,
            );
        }
    }
    println!("  {:?}", outcomes[0].frame.steps);
    let (frame, threads) = (&outcomes[0].frame, threads[0]);
    for rig in rigs.iter_mut().filter(|rig| rig.modes == EMBREE) {
        for (mode, name) in rig.modes.iter().enumerate() {
            rig.frames(mode, threads, &[*frame.camera()]).unwrap();
            let same = check::alike(&frame.object, &rig.objects().unwrap());
            println!("  {name}: another object in {:.4} % of the pixels", 100.0 * (1.0 - same));
        }
    }
}

/// Prints a table of speeds and ratios for each number of threads. `picked` selects the median or the
/// minimum of the measured times.
fn show_table(title: &str, measured: &[Measured], threads: &[usize], picked: fn(&Times) -> f64) {
    let threads: Vec<String> = threads.iter().map(|threads| format!("{threads}t")).collect();
    let threads = threads.join(" / ");
    println!("Mrays/s of {title}; best: the fastest of Embree's ways; {threads}\n");
    println!(
        "| scene | ours | best | ours / best | % of streaming stores | % covered | decided / covered |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for scene in measured {
        let time = |outcome: &Outcome, names: &[&str]| {
            let rows = outcome.rows.iter().filter(|(name, _)| names.contains(name));
            rows.map(|(_, times)| picked(times)).reduce(f64::min)
        };
        let cells = |number: &dyn Fn(&Outcome) -> Option<f64>, digits: usize| {
            let cell = |number: Option<f64>| {
                number.map_or("-".to_owned(), |number| format!("{number:.digits$}"))
            };
            let cells: Vec<String> =
                scene.outcomes.iter().map(|outcome| cell(number(outcome))).collect();
            cells.join(" / ")
        };
        let speed = |time: f64| 1e-6 * scene.pixels as f64 / time;
        let over_ours = |outcome: &Outcome, names: &[&str]| {
            Some(time(outcome, names)? / time(outcome, &[LADDER])?)
        };
        println!(
            "| {} | {} | {} | {} | {} | {:.1} | {:.2} |",
            scene.name,
            cells(&|outcome| time(outcome, &[LADDER]).map(speed), 1),
            cells(&|outcome| time(outcome, &EMBREE).map(speed), 1),
            cells(&|outcome| over_ours(outcome, &EMBREE), 1),
            cells(&|outcome| Some(100.0 * over_ours(outcome, &[STREAMING])?), 1),
            100.0 * scene.coverage,
            scene.decided,
        );
    }
    println!();
}

/// Prints by which factor the ladder's median time grows when the number of spheres grows tenfold.
fn show_growth(measured: &[Measured]) {
    println!("growth of the ladder's median time with the number of spheres\n");
    let growth = || measured.iter().filter(|scene| scene.group == "growth");
    for few in growth() {
        for many in growth().filter(|many| many.spheres == 10 * few.spheres) {
            let pairs = few.outcomes.iter().zip(&many.outcomes);
            let factor = |(few, many): (&Outcome, &Outcome)| {
                format!("{:.2}", many.rows[0].1.median / few.rows[0].1.median)
            };
            let factors: Vec<String> = pairs.map(factor).collect();
            println!("{} to {}: {} times as long", few.name, many.name, factors.join(" / "));
        }
    }
}
