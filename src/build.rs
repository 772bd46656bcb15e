//! Text of `--version`: version, commit, profile and target.
//!
//! The commit is told of release builds alone: those that are tested are rebuilt with every edit, and
//! would be with every commit.

use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    let of_cargo = |name: &str| std::env::var(name).unwrap_or_default();
    println!("cargo:rerun-if-changed=src/build.rs");
    let profile = of_cargo("PROFILE");
    let commit = if profile == "release" {
        commit(Path::new(&of_cargo("CARGO_MANIFEST_DIR")))
    } else {
        None
    };
    let parts = [commit, Some(profile), Some(of_cargo("TARGET"))];
    let build = parts.into_iter().flatten().collect::<Vec<_>>().join(", ");
    println!("cargo:rustc-env=PINHOLE_VERSION={} ({build})", of_cargo("CARGO_PKG_VERSION"));
}

/// The commit that these sources are of, with a `+` where they have been changed since; `None` where
/// they are not in a repository of their own.
fn commit(root: &Path) -> Option<String> {
    let git = |arguments: &[&str]| {
        let output = Command::new("git").arg("-C").arg(root).args(arguments).output().ok()?;
        let text = output.status.success().then(|| String::from_utf8(output.stdout).ok())??;
        Some(text.trim().to_owned())
    };
    // Sources that lie unpacked in somebody else's repository are of none of its commits.
    let top = PathBuf::from(git(&["rev-parse", "--show-toplevel"])?);
    if top.canonicalize().ok()? != root.canonicalize().ok()? {
        return None;
    }
    // Whether they have been changed is another answer after every edit.
    let git_files =
        [git(&["rev-parse", "--git-path", "HEAD"]), git(&["rev-parse", "--git-path", "index"])];
    for file in git_files.into_iter().flatten() {
        println!("cargo:rerun-if-changed={file}");
    }
    for sources in ["src", "assets", "Cargo.toml", "Cargo.lock"] {
        println!("cargo:rerun-if-changed={sources}");
    }
    let changed = git(&["status", "--porcelain", "--untracked-files=no"])?;
    let commit = git(&["rev-parse", "--short=10", "HEAD"])?;
    Some(format!("commit {commit}{}", if changed.is_empty() { "" } else { "+" }))
}
