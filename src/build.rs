//! The text of `--version`: version, commit, profile and target; on Windows, also the program's icon and version.
//!
//! Only release builds include the commit. To keep it current, this script must run again after every
//! edit and every commit, which would slow down the builds used for testing.

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
    if of_cargo("TARGET").ends_with("-windows-gnu") {
        add_resources(&of_cargo("CARGO_CFG_TARGET_ARCH"), &of_cargo("OUT_DIR"));
    }
}

/// Links icon, version and manifest into the program, with the tool that comes with the linker.
fn add_resources(arch: &str, out: &str) {
    println!("cargo:rerun-if-changed=assets/windows");
    let parts = ["MAJOR", "MINOR", "PATCH"].map(|part| {
        let number = std::env::var(format!("CARGO_PKG_VERSION_{part}")).unwrap_or_default();
        format!("-D{part}={number}")
    });
    let object = format!("{out}/resources.o");
    let compiled =
        [&*format!("{arch}-w64-mingw32-windres"), "windres"].into_iter().any(|windres| {
            let mut command = Command::new(windres);
            command.args(&parts).args(["assets/windows/pinhole.rc", &object]);
            command.status().is_ok_and(|status| status.success())
        });
    match compiled {
        true => println!("cargo:rustc-link-arg-bins={object}"),
        false => println!("cargo:warning=no windres: the program has no icon and no version"),
    }
}

/// Returns the commit of these sources, followed by `+` if they have changed since. Returns `None` if
/// they are not at the root of a git repository.
fn commit(root: &Path) -> Option<String> {
    let git = |arguments: &[&str]| {
        // Without the option, git writes its index anew, for which cargo would build all of the program again.
        let mut git = Command::new("git");
        git.arg("--no-optional-locks").arg("-C").arg(root);
        let output = git.args(arguments).output().ok()?;
        let text = output.status.success().then(|| String::from_utf8(output.stdout).ok())??;
        Some(text.trim().to_owned())
    };
    // Sources unpacked inside another repository belong to none of its commits.
    let top = PathBuf::from(git(&["rev-parse", "--show-toplevel"])?);
    if top.canonicalize().ok()? != root.canonicalize().ok()? {
        return None;
    }
    // A change of any of these files may change the commit or its `+`.
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
