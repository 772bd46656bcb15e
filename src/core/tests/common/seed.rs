//! The seed of random cases.

/// Returns the seed that is set for proptest's cases, too: 1 unless `PROPTEST_RNG_SEED` says another.
pub(crate) fn seed() -> u64 {
    let set = std::env::var("PROPTEST_RNG_SEED").ok().and_then(|number| number.parse().ok());
    set.unwrap_or(1)
}
