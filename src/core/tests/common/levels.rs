//! The SIMD levels that tests run on.
#![allow(clippy::print_stdout, reason = "a test tells which levels it ran on")]

use fearless_simd::Level;

/// Returns the SIMD levels that this machine supports, the lowest first, and prints them. On x86-64,
/// asserts that SSE2 is among them, and AVX2 if the processor has it.
pub(crate) fn levels() -> Vec<(&'static str, Level)> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let levels = {
        let all = [
            ("SSE2", best.as_sse2().map(Level::Sse2)),
            ("SSE4.2", best.as_sse4_2().map(Level::Sse4_2)),
            ("AVX2", best.as_avx2().map(Level::Avx2)),
            ("AVX-512", best.as_avx512().map(Level::Avx512)),
        ];
        let levels: Vec<_> =
            all.into_iter().filter_map(|(name, level)| Some((name, level?))).collect();
        let has = |name| levels.iter().any(|(level, _)| *level == name);
        assert!(has("SSE2"));
        let has_avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        assert!(has("AVX2") || !has_avx2);
        levels
    };
    #[cfg(not(target_arch = "x86_64"))]
    let levels = vec![("the best there is", best)];
    println!("levels: {}", levels.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", "));
    levels
}
