//! The bench rig: its scenes, its rivals and its rounds.

#[allow(dead_code, reason = "benches use more of it")]
#[path = "../../benches/yardstick/mod.rs"]
pub(crate) mod bench;

mod contestants;
mod rounds;
mod scenes;
