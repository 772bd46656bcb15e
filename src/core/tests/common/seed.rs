//! The seed of tests with random numbers: fixed, so that a test does the same every time.

use proptest::test_runner::{Config, RngSeed};

/// Returns the seed of random cases: 1 unless `PROPTEST_RNG_SEED` is another number.
pub(crate) fn seed() -> u64 {
    let set = std::env::var("PROPTEST_RNG_SEED").ok().and_then(|number| number.parse().ok());
    set.unwrap_or(1)
}

/// Configuration of `cases` random cases of the seed; no file of failures, as the seed tells them again.
pub(crate) fn config(cases: u32) -> Config {
    let rng_seed = RngSeed::Fixed(seed());
    Config { cases, failure_persistence: None, rng_seed, ..Config::default() }
}
