//! Time against the number of spheres, and in scenes that are hard to be fast in: the ladder, the
//! textbook's loop, the same with a tree, and nothing but stores, frame by frame in turn. A sample
//! of the ladder's pixels is checked against their exact rays.
//!
//! `cargo bench -p pinhole-core --bench speed -- [WORD...] [avx2] [threads=N] [quick]`
//!
//! A word chooses scenes: `growth`, `adversarial`, `sizes`, a name (`N=1000`), or part of one
//! (`overdraw`). Without one, all but `N=1e7`. `avx2` holds the ladder and the stores to AVX2; `quick`
//! takes few frames.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints and may fail")]

use std::time::Duration;

use pinhole_core::Level;
use pinhole_yardstick::contest::{self, Limits, Outcome};
use pinhole_yardstick::scenes::{self, Listed};
use pinhole_yardstick::{Setting, check};

/// Scenes of at least so many spheres have fewer pixels checked, as each ray is asked of all.
const MANY: usize = 100_000;

fn main() {
    // Cargo adds --bench.
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let has = |option: &str| words.iter().any(|word| word == option);
    let threads = words.iter().find_map(|word| word.strip_prefix("threads="));
    let threads = threads.map_or(0, |number| number.parse().unwrap());
    let level = if has("avx2") { avx2() } else { Level::new() };
    let share = Duration::from_millis(if has("quick") { 150 } else { 1500 });
    let limits = Limits { level, share, patience: Duration::from_secs(30), ..Limits::default() };
    let options = |word: &&String| {
        !["avx2", "quick"].contains(&word.as_str()) && !word.starts_with("threads=")
    };
    let wanted: Vec<&str> = words.iter().filter(options).map(String::as_str).collect();
    let chosen: Vec<Listed> =
        scenes::all().into_iter().filter(|listed| is_wanted(listed, &wanted)).collect();
    assert!(!chosen.is_empty(), "no scene is called {wanted:?}");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| run(&chosen, &limits));
}

fn avx2() -> Level {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return Level::Avx2(Level::new().as_avx2().expect("this processor has no AVX2"));
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    panic!("this processor has no AVX2");
}

fn is_wanted(listed: &Listed, wanted: &[&str]) -> bool {
    let is_huge = listed.name == "N=1e7";
    wanted.contains(&listed.name)
        || (!is_huge && (wanted.is_empty() || wanted.contains(&listed.group)))
        || wanted.iter().any(|word| !word.starts_with("N=") && listed.name.contains(word))
}

fn run(chosen: &[Listed], limits: &Limits) {
    let threads = rayon::current_num_threads();
    // Only the name of the level, not what is in it.
    let level = format!("{:?}", limits.level);
    let level = level.split('(').next().unwrap();
    println!("{level}, {threads} threads, t as f32 and object as u32 of every pixel");
    println!("ratio: a method's median time over the ladder's\n");
    let mut growth = Vec::new();
    for listed in chosen {
        let setting = (listed.make)();
        let outcome = contest::run(&setting, limits);
        show(listed.name, &setting, &outcome);
        let time = outcome.rows[0].1.median;
        if listed.group == "growth" {
            growth.push((setting.scene.len(), time));
        }
    }
    show_growth(&growth);
}

fn show(name: &str, setting: &Setting, outcome: &Outcome) {
    let (image, objects) = (setting.image(), setting.scene.len());
    let sample = if objects >= MANY { 100 } else { 500 };
    if let Err(fault) = check::sample(&setting.scene, &outcome.frame, sample, 1) {
        panic!("{name} is wrong: {fault}");
    }
    println!(
        "{name}: {objects} spheres, {} x {}, {:.1} % covered, {sample} pixels checked",
        image.width(),
        image.height(),
        100.0 * check::coverage(&outcome.frame.object),
    );
    let ladder = outcome.rows[0].1.median;
    println!("  {:16} {:>10} {:>10} {:>10} {:>9}", "", "median ms", "min ms", "Mrays/s", "ratio");
    for (name, times) in &outcome.rows {
        println!(
            "  {:16} {:10.4} {:10.4} {:10.1} {:9.3}  {} frames",
            name,
            1e3 * times.median,
            1e3 * times.min,
            1e-6 * setting.pixels() as f64 / times.median,
            times.median / ladder,
            times.count,
        );
    }
    println!("  {:?}\n", outcome.frame.steps);
}

/// The slope of time against number, both logarithmic, from each scene to the next.
fn show_growth(points: &[(usize, f64)]) {
    if points.len() < 2 {
        return;
    }
    println!("growth of the ladder's time: log(time) / log(N)");
    for pair in points.windows(2) {
        let [(few, short), (many, long)] = [pair[0], pair[1]];
        let slope = (long / short).ln() / (many as f64 / few as f64).ln();
        println!("  N = {few} to {many}: {slope:.3}, {:.2} times as long", long / short);
    }
}
