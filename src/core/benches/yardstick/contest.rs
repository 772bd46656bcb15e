//! All contestants over one scene.

use std::cell::RefCell;
use std::time::Duration;

use pinhole_core::{
    Frame, Level, Outputs, Raster, ResolvedCamera, retrace_at_level, trace_at_level,
};

use rayon::ThreadPoolBuilder;

use super::bvh::Bvh;
use super::frames::Buffers;
use super::rig::Rig;
use super::rounds::{self, Times, each};
use super::scenes::Setting;
use super::textbook;

/// Name of `pinhole-core` among the contestants, after its decisions, which escalate from `f64` through
/// double-double to exact integers.
pub(crate) const LADDER: &str = "ladder";

/// Settings and time limits of a contest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The SIMD level of the ladder.
    pub(crate) level: Level,
    /// Number of threads that make a frame.
    pub(crate) threads: usize,
    /// Time after which a contestant starts no further frame. Each is timed for at least one frame.
    pub(crate) share: Duration,
    /// Maximum number of timed frames of each contestant.
    pub(crate) most: usize,
    /// One of the textbook's loops is left out if a single frame would take it longer than about this
    /// on one thread.
    pub(crate) patience: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let (share, patience) = (Duration::from_secs(1), Duration::from_secs(12));
        Limits { level: Level::new(), threads: 1, share, most: 200, patience }
    }
}

/// The results of a contest.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    /// The contestants' names and their times per frame, with [`LADDER`] first.
    pub(crate) rows: Vec<(&'static str, Times)>,
    /// The ladder's last frame.
    pub(crate) frame: Frame<f32>,
}

/// With up to this many spheres, the textbook's loop that tests every sphere takes part; with at least
/// this many, the one with a bounding volume hierarchy.
pub(crate) const TREE_FROM: usize = 100;

/// A contestant: a function that traces one frame for each camera, and returns how long each frame
/// took.
type Run<'a> = Box<dyn FnMut(&[ResolvedCamera]) -> Vec<Duration> + 'a>;

/// Times all contestants, including the running C++ programs `rigs`, on the same scene and cameras.
/// They trace frames in turn.
///
/// # Panics
/// Panics if one of the programs ends early.
pub(crate) fn run(setting: &Setting, limits: &Limits, rigs: &mut [Rig]) -> Outcome {
    let Limits { level, threads, share, most, patience } = *limits;
    let (scene, image, count) = (&setting.scene, setting.image(), setting.scene.len());
    let rigs: Vec<RefCell<&mut Rig>> = rigs.iter_mut().map(RefCell::new).collect();
    let mut frame = trace_at_level(
        level,
        scene,
        &setting.camera(0),
        &Raster::full(image),
        Outputs::default(),
        |_| (),
    );
    let mut contestants: Vec<(&str, Run)> = vec![(
        LADDER,
        Box::new(|cameras| {
            on(threads, || {
                each(cameras, |camera| retrace_at_level(level, &mut frame, scene, camera))
            })
        }),
    )];
    // Typical times: 5 ns per sphere, 100 ns per level of the tree, on one thread.
    let is_quick = |seconds: f64| setting.pixels() as f64 * seconds <= patience.as_secs_f64();
    if count <= TREE_FROM && is_quick(5e-9 * count as f64) {
        let (balls, mut buffers) = (textbook::balls(scene), Buffers::new(image));
        let mut run = move |camera: &_| textbook::trace(&balls, camera, &mut buffers);
        contestants
            .push(("textbook", Box::new(move |cameras| on(threads, || each(cameras, &mut run)))));
    }
    if count >= TREE_FROM && is_quick(1e-7 * (count as f64).log2()) {
        let (tree, mut buffers) = (Bvh::new(scene), Buffers::new(image));
        let mut run = move |camera: &_| tree.trace(camera, &mut buffers);
        contestants.push((
            "textbook-bvh",
            Box::new(move |cameras| on(threads, || each(cameras, &mut run))),
        ));
    }
    for rig in &rigs {
        for (mode, name) in rig.borrow().modes.iter().enumerate() {
            let run = move |cameras: &[_]| {
                let times = rig.borrow_mut().frames(mode, threads, cameras);
                times.unwrap_or_else(|error| panic!("{name}: {error}"))
            };
            contestants.push((name, Box::new(run)));
        }
    }
    let times = rounds::interleaved(contestants.len(), share, most, |index, frames| {
        let cameras: Vec<ResolvedCamera> = frames.map(|frame| setting.camera(frame)).collect();
        (contestants[index].1)(&cameras)
    });
    let rows = contestants.iter().map(|(name, _)| *name).zip(times).collect();
    drop(contestants);
    Outcome { rows, frame }
}

/// Runs `work` in a new thread pool. A pool that slept during the turns of other contestants is slower:
/// Linux may wake all its threads on one processor, and then take tens of milliseconds to distribute
/// them.
fn on<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(work)
}
