//! What a bench says: plain data, in the very shape in which `bench --json` writes it, and what its
//! other forms show beside that.

use pinhole_core::ImageSize;
use serde::{Deserialize, Serialize};

/// Times of frames, by scene and method.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bench {
    /// The processor, and which of its features were used.
    pub cpu: String,
    /// How many threads each method had.
    pub threads: usize,
    /// What each method did, scene by scene.
    pub rows: Vec<Row>,
    /// What was not run, and why, a sentence each.
    #[serde(skip)]
    pub left_out: Vec<String>,
}

/// What one method did in one scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The scene.
    pub scene: String,
    /// `ladder`, `uncertified`, `textbook`, `textbook-bvh` or `stores`.
    pub method: String,
    /// Milliseconds a frame.
    pub ms: Times,
    /// Millions of rays a second, by the median time.
    pub mrays_per_s: f64,
    /// How many objects the scene has.
    #[serde(skip)]
    pub objects: usize,
    /// How many pixels a frame has.
    #[serde(skip)]
    pub image: Option<ImageSize>,
}

/// Run times of interleaved rounds, in milliseconds a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// The middle one.
    pub median: f64,
    /// The shortest one.
    pub min: f64,
}

impl Bench {
    /// The object that `--json` writes, with a line break behind it.
    ///
    /// # Errors
    /// None: a bench holds nothing that JSON does not.
    pub fn to_json(&self) -> serde_json::Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// The median time of a method in a scene, where it was run and took any.
    pub fn median(&self, scene: &str, method: &str) -> Option<f64> {
        let row = self.rows.iter().find(|row| row.scene == scene && row.method == method)?;
        Some(row.ms.median).filter(|time| *time > 0.0)
    }
}
