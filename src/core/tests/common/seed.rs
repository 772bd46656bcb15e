<<<<<<< main
//! The seeds of tests with random numbers: fixed, so that a test does the same every time.
//!
//! `PINHOLE_TEST_SEED=random` takes fresh ones, `PINHOLE_TEST_SEED=17` this one; what is taken is
//! printed.
#![allow(clippy::print_stdout, reason = "a test tells its seed")]

use proptest::test_runner::{Config, RngSeed};

/// The seed of a test.
pub(crate) fn seed() -> u64 {
    let Ok(wanted) = std::env::var("PINHOLE_TEST_SEED") else { return 1 };
    let seed = match wanted.as_str() {
        "random" => {
            let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
            now.map_or(1, |now| now.as_nanos() as u64)
        }
        number => number.parse().unwrap_or_else(|_| {
            panic!("PINHOLE_TEST_SEED is {number:?}: it must be \"random\" or a whole number")
        }),
    };
    println!("PINHOLE_TEST_SEED={seed}");
    seed
}

/// Configuration of so many random cases of the seed; no file of failures, as the seed tells them again.
pub(crate) fn config(cases: u32) -> Config {
    let rng_seed = RngSeed::Fixed(seed());
    Config { cases, failure_persistence: None, rng_seed, ..Config::default() }
=======
//! The seed of random cases.

/// Returns the seed that is set for proptest's cases, too: 1 unless `PROPTEST_RNG_SEED` says another.
pub(crate) fn seed() -> u64 {
    let set = std::env::var("PROPTEST_RNG_SEED").ok().and_then(|number| number.parse().ok());
    set.unwrap_or(1)
>>>>>>> jt-testsb
}
