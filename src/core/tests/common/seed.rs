//! The seed of tests with random numbers, which is fixed, so that a test does the same in every run.

use proptest::test_runner::{Config, RngSeed};

/// Returns the seed of random cases: 1 unless `PROPTEST_RNG_SEED` is another number.
pub(crate) fn seed() -> u64 {
    let set = std::env::var("PROPTEST_RNG_SEED").ok().and_then(|number| number.parse().ok());
    set.unwrap_or(1)
}

/// Returns a proptest configuration for `cases` random cases from [`seed`]. Failures are not recorded
/// in a file, because the seed reproduces them.
pub(crate) fn config(cases: u32) -> Config {
    let rng_seed = RngSeed::Fixed(seed());
    Config { cases, failure_persistence: None, rng_seed, ..Config::default() }
}
