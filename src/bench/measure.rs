//! Measures settings one after the other.

use std::time::Duration;

use pinhole_yardstick::Setting;
use pinhole_yardstick::contest::{self, Limits, Method};

use super::model::{Bench, Row, Times};
use crate::machine;

/// The most spheres of the built-in series.
pub const MOST: usize = 1_000_000;

/// What is compared.
const METHODS: [Method; 4] =
    [Method::Ladder, Method::Textbook, Method::TextbookBvh, Method::Stores];

/// What each method may spend on a scene, so that the built-in series takes less than a minute.
const SHARE: Duration = Duration::from_millis(600);

/// A bench before anything is measured.
pub fn begun() -> Bench {
    let (cpu, threads) = (machine::describe("the ladder"), rayon::current_num_threads());
    Bench { cpu, threads, ..Bench::default() }
}

impl Bench {
    /// Measures all methods in one more scene.
    pub fn measure(&mut self, setting: &Setting) {
        let limits = Limits { share: SHARE, ..Limits::default() };
        let outcome = contest::run(setting, &METHODS, &limits);
        for row in &outcome.rows {
            self.rows.push(Row {
                scene: setting.name.clone(),
                method: row.method.name().to_owned(),
                ms: Times { median: 1e3 * row.times.median, min: 1e3 * row.times.min },
                mrays_per_s: 1e-6 * setting.pixels() as f64 / row.times.median,
                objects: setting.scene.len(),
                image: Some(setting.image()),
            });
        }
        for (method, why) in &outcome.left_out {
            self.leave_out(method.name(), why, &setting.name);
        }
    }

    /// One sentence for all scenes in which a method was left out for one reason.
    fn leave_out(&mut self, method: &str, why: &str, scene: &str) {
        let head = format!("{method} ({why}): ");
        match self.left_out.iter_mut().find(|line| line.starts_with(&head)) {
            Some(line) => *line += &format!(", {scene}"),
            None => self.left_out.push(head + scene),
        }
    }
}
