//! All contestants over one scene.

use std::time::Duration;

use pinhole_core::{Frame, Level};

use crate::bvh::Bvh;
use crate::frames::Buffers;
use crate::ladder;
use crate::rounds::{self, Times};
use crate::scenes::Setting;
use crate::stores::Stores;
use crate::textbook::TextbookScene;

/// A contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// `pinhole-core`, every decision certified.
    Ladder,
    /// [`crate::textbook`].
    Textbook,
    /// [`crate::bvh`].
    TextbookBvh,
    /// [`Stores::again`].
    Stores,
    /// [`Stores::to_memory`].
    StoresToMemory,
}

impl Method {
    /// All contestants, in the order in which they are shown.
    pub const ALL: [Method; 5] = [
        Method::Ladder,
        Method::Textbook,
        Method::TextbookBvh,
        Method::Stores,
        Method::StoresToMemory,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Method::Ladder => "ladder",
            Method::Textbook => "textbook",
            Method::TextbookBvh => "textbook-bvh",
            Method::Stores => "stores",
            Method::StoresToMemory => "stores to memory",
        }
    }
}

/// Limits of the time to spend.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The instructions of the ladder and of the stores.
    pub level: Level,
    /// Maximum time that each method spends on frames, if one frame does not take longer.
    pub share: Duration,
    /// Maximum number of frames of each that are timed.
    pub most: usize,
    /// A rival is left out where a frame of it would take longer, roughly, on one thread.
    pub patience: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let (share, patience) = (Duration::from_secs(1), Duration::from_secs(12));
        Limits { level: Level::new(), share, most: 41, patience }
    }
}

/// The result of one method.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The method.
    pub method: Method,
    /// Seconds a frame.
    pub times: Times,
}

/// The results of a contest.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The methods that took part, in the order asked for.
    pub rows: Vec<Row>,
    /// The methods that did not, and why.
    pub left_out: Vec<(Method, &'static str)>,
    /// The ladder's last frame.
    pub frame: Frame<f32>,
}

impl Outcome {
    /// The times of a method that took part.
    pub fn times(&self, method: Method) -> Option<Times> {
        self.rows.iter().find(|row| row.method == method).map(|row| row.times)
    }
}

/// Number of spheres up to which the textbook asks all of them, and from which on it has a tree.
pub const TREE_FROM: usize = 100;

/// Lets the methods trace a setting frame by frame, in turn, on the threads of the current pool.
pub fn run(setting: &Setting, methods: &[Method], limits: &Limits) -> Outcome {
    let (mut rows, mut left_out) = (Vec::new(), Vec::new());
    for &method in methods {
        match why_not(setting, method, limits) {
            Some(why) => left_out.push((method, why)),
            None => rows.push(method),
        }
    }
    let mut field = Field::new(setting, &rows, limits.level);
    let times = rounds::interleaved(rows.len(), limits.share, limits.most, |index, frame| {
        field.run(rows[index], frame);
    });
    let rows = rows.into_iter().zip(times).map(|(method, times)| Row { method, times }).collect();
    Outcome { rows, left_out, frame: field.frame }
}

fn why_not(setting: &Setting, method: Method, limits: &Limits) -> Option<&'static str> {
    let objects = setting.scene.len();
    // Of the usual size of things: 5 ns a sphere, 100 ns a level of the tree, on one thread.
    let seconds = setting.pixels() as f64
        * match method {
            Method::Textbook => 5e-9 * objects as f64,
            Method::TextbookBvh => 1e-7 * (objects.max(1) as f64).log2(),
            _ => 0.0,
        };
    match method {
        Method::Textbook if objects > TREE_FROM => Some("asks all spheres: too many of them"),
        Method::TextbookBvh if objects < TREE_FROM => Some("too few spheres for a tree"),
        _ if seconds > limits.patience.as_secs_f64() => Some("a frame takes too long"),
        _ => None,
    }
}

/// The contestants, ready to run.
struct Field<'a> {
    setting: &'a Setting,
    level: Level,
    frame: Frame<f32>,
    textbook: Option<TextbookScene>,
    tree: Option<Bvh>,
    buffers: Option<Buffers>,
    stores: Option<Stores>,
    to_memory: Option<Stores>,
}

impl<'a> Field<'a> {
    fn new(setting: &'a Setting, methods: &[Method], level: Level) -> Field<'a> {
        let takes_part = |method: Method| methods.contains(&method);
        let (scene, image) = (&setting.scene, setting.image());
        let (plain, tree) = (takes_part(Method::Textbook), takes_part(Method::TextbookBvh));
        let frame = ladder::first_frame(level, scene, &setting.camera(0));
        Field {
            setting,
            level,
            frame,
            textbook: plain.then(|| TextbookScene::new(scene)),
            tree: tree.then(|| Bvh::new(scene)),
            buffers: (plain || tree).then(|| Buffers::new(image)),
            stores: takes_part(Method::Stores).then(|| Stores::again(image, level)),
            to_memory: takes_part(Method::StoresToMemory).then(|| Stores::to_memory(image, level)),
        }
    }

    /// One frame of a method.
    fn run(&mut self, method: Method, frame: usize) {
        let camera = self.setting.camera(frame);
        let scene = &self.setting.scene;
        match (method, &mut self.buffers) {
            (Method::Ladder, _) => ladder::trace(&mut self.frame, self.level, scene, &camera),
            (Method::Textbook, Some(buffers)) => {
                if let Some(textbook) = &self.textbook {
                    textbook.trace(&camera, buffers);
                }
            }
            (Method::TextbookBvh, Some(buffers)) => {
                if let Some(tree) = &self.tree {
                    tree.trace(&camera, buffers);
                }
            }
            (Method::Stores, _) => self.stores.iter_mut().for_each(Stores::run),
            (Method::StoresToMemory, _) => self.to_memory.iter_mut().for_each(Stores::run),
            (Method::Textbook | Method::TextbookBvh, None) => {}
        }
    }
}
