//! The processor of this machine.

use std::fs;

use pinhole_core::Level;

/// The processor's name, where it can be had, its vector instructions that programs choose by, and
/// those that `what` was compiled for.
pub(crate) fn describe(what: &str) -> String {
    let name = name().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let features = features();
    let features = if features.is_empty() {
        "no vector instructions asked for".to_owned()
    } else {
        features.join(", ")
    };
    format!("{name} ({}; {features}; {what} compiled for {})", std::env::consts::ARCH, level())
}

/// The instructions that core chose.
fn level() -> &'static str {
    match Level::new() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(_) => "avx512",
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) => "avx2 and fma",
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Sse4_2(_) => "sse4.2",
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => "neon",
        _ => "the architecture's least",
    }
}

fn name() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    let name = line.split_once(':')?.1.trim();
    (!name.is_empty()).then(|| name.to_owned())
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn features() -> Vec<&'static str> {
    let found = [
        ("sse2", std::is_x86_feature_detected!("sse2")),
        ("sse4.2", std::is_x86_feature_detected!("sse4.2")),
        ("avx2", std::is_x86_feature_detected!("avx2")),
        ("fma", std::is_x86_feature_detected!("fma")),
        ("avx512f", std::is_x86_feature_detected!("avx512f")),
    ];
    found.into_iter().filter_map(|(name, is_there)| is_there.then_some(name)).collect()
}

#[cfg(target_arch = "aarch64")]
fn features() -> Vec<&'static str> {
    vec!["neon"]
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
fn features() -> Vec<&'static str> {
    Vec::new()
}
