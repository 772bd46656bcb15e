//! The archive's installer, on an archive whose program is a script.
#![cfg(target_os = "linux")]

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use super::entries;

/// An archive, and a home that is empty.
struct Unpacked {
    folder: tempfile::TempDir,
}

impl Unpacked {
    fn new() -> Unpacked {
        let folder = tempfile::tempdir().unwrap();
        let archive = folder.path().join("archive");
        let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
        for part in ["linux", "man", "completions"] {
            let to = if part == "linux" { archive.clone() } else { archive.join(part) };
            fs::create_dir_all(&to).unwrap();
            for name in entries(&assets.join(part)) {
                fs::copy(assets.join(part).join(&name), to.join(&name)).unwrap();
            }
        }
        fs::copy(assets.join("icon.png"), archive.join("icon.png")).unwrap();
        let program = archive.join("pinhole");
        fs::write(&program, "#!/bin/sh\necho started\n").unwrap();
        fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
        Unpacked { folder }
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn install(&self, arguments: &[&str]) -> Output {
        Command::new("sh")
            .arg("archive/install.sh")
            .args(arguments)
            .current_dir(self.folder.path())
            .env("HOME", self.at("home"))
            .env_remove("XDG_DATA_HOME")
            .env_remove("XDG_DATA_DIRS")
            .output()
            .unwrap()
    }

    #[track_caller]
    fn done(&self, arguments: &[&str]) -> String {
        let Output { status, stdout, stderr } = self.install(arguments);
        assert!(status.success(), "{}", String::from_utf8_lossy(&stderr));
        String::from_utf8(stdout).unwrap()
    }
}

/// The value of a key of the installed desktop entry.
fn value(prefix: &Path, key: &str) -> String {
    let entry = fs::read_to_string(prefix.join("share/applications/pinhole.desktop")).unwrap();
    let line = entry.lines().find_map(|line| line.strip_prefix(&format!("{key}=")));
    line.unwrap().to_owned()
}

#[test]
fn what_is_installed_is_found_by_its_path_and_goes_without_a_trace() {
    let unpacked = Unpacked::new();
    for (name, quoted) in [
        ("plain", "plain"),
        ("a place", "a place"),
        ("50% of $x", "50%% of \\\\$x"),
        ("`a\\b\"", "\\\\`a\\\\\\\\b\\\\\""),
    ] {
        let prefix = unpacked.at(name);
        let folder = unpacked.folder.path().display();
        assert!(unpacked.done(&[name]).contains("installed to"));
        let start = format!("{folder}/{quoted}/bin/pinhole");
        let start = if name == "plain" { start } else { format!("\"{start}\"") };
        assert_eq!(value(&prefix, "Exec"), format!("{start} %f"));
        let plain = prefix.display().to_string().replace('\\', "\\\\");
        assert_eq!(value(&prefix, "TryExec"), format!("{plain}/bin/pinhole"));
        let icon = format!("{plain}/share/icons/hicolor/256x256/apps/pinhole.png");
        assert_eq!(value(&prefix, "Icon"), icon);
        let started = Command::new(prefix.join("bin/pinhole")).output().unwrap();
        assert_eq!(started.stdout, b"started\n");
        unpacked.done(&[name, "--remove"]);
        assert!(!prefix.exists(), "{name}");
    }
}

#[test]
fn without_a_prefix_it_is_the_users_own_and_others_files_stay() {
    let unpacked = Unpacked::new();
    let prefix = unpacked.at("home/.local");
    let other = prefix.join("share/applications/other.desktop");
    fs::create_dir_all(other.parent().unwrap()).unwrap();
    fs::write(&other, "[Desktop Entry]\n").unwrap();
    unpacked.done(&[]);
    assert!(prefix.join("bin/pinhole").exists());
    assert_eq!(value(&prefix, "Icon"), "pinhole");
    unpacked.done(&["--remove"]);
    assert!(other.exists() && !prefix.join("bin").exists());
}

#[test]
fn arguments_that_it_does_not_know_install_nothing() {
    let unpacked = Unpacked::new();
    for arguments in [&["--uninstall"][..], &["-r", "there"], &["there", "here"], &[""], &["a=b"]] {
        let Output { status, stderr, .. } = unpacked.install(arguments);
        let stderr = String::from_utf8(stderr).unwrap();
        assert_eq!(status.code(), Some(2), "{arguments:?}");
        assert!(stderr.contains("usage: install.sh [--remove] [PREFIX]"), "{stderr}");
    }
    assert!(unpacked.done(&["there", "--help"]).starts_with("usage: install.sh"));
    assert_eq!(entries(unpacked.folder.path()), ["archive"]);
}
