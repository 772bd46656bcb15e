//! Tests of the benchmark: its scenes, its rival ray tracers, and its time measurements in rounds.

#[allow(dead_code, reason = "benches use more of it")]
#[path = "../../benches/yardstick/mod.rs"]
pub(crate) mod bench;

mod contestants;
mod rounds;
mod scenes;
