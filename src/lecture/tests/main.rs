//! Everything that is taught, against the lecture's own numbers, the reference, and what students do.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../core/tests/common/mod.rs"]
mod common;
mod derivation;
mod exercises;
mod forms;
mod grading;
mod lines;
mod mistakes;

use proptest::prelude::ProptestConfig;

/// No file of failures: the seeds are in the message.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}
