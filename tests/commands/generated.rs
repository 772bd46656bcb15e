//! What is generated from the command line's definition: man pages and shell completions.
//! `UPDATE_EXPECT=1` writes them anew.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::CommandFactory as _;
use clap_complete::Shell;
use expect_test::expect_file;
use pinhole::arguments::Arguments;

use super::{entries, run};

fn assets() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets")
}

/// Without the commit that this was built from, and with the names of the commands in full.
fn definition() -> clap::Command {
    let mut definition =
        Arguments::command().long_version(None::<&str>).disable_help_subcommand(true);
    definition.build();
    definition
}

fn assert_files(folder: &str, files: &[(String, String)]) {
    for (name, text) in files {
        expect_file![assets().join(folder).join(name)].assert_eq(text);
    }
    let expected: BTreeSet<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let found = entries(&assets().join(folder));
    assert_eq!(found.iter().map(String::as_str).collect::<BTreeSet<_>>(), expected, "{folder}");
}

#[test]
fn the_man_pages_are_current() {
    let definition = definition();
    let pages: Vec<(String, String)> = [&definition]
        .into_iter()
        .chain(definition.get_subcommands())
        .map(|command| {
            let name = command.get_display_name().unwrap_or(command.get_name()).to_owned();
            let mut page = Vec::new();
            let man = clap_mangen::Man::new(command.clone()).title(name.clone());
            man.manual("Pinhole").date("").render(&mut page).unwrap();
            (format!("{name}.1"), String::from_utf8(page).unwrap())
        })
        .collect();
    assert!(pages[0].1.contains("pinhole") && pages.len() > 7);
    assert_files("man", &pages);
}

#[test]
fn the_completions_are_current() {
    let completions =
        [(Shell::Bash, "pinhole.bash"), (Shell::Zsh, "_pinhole"), (Shell::Fish, "pinhole.fish")];
    let files = completions.map(|(shell, name)| {
        let mut text = Vec::new();
        clap_complete::generate(shell, &mut definition(), "pinhole", &mut text);
        (name.to_owned(), String::from_utf8(text).unwrap())
    });
    assert_files("completions", &files);
}

#[test]
fn the_version_tells_what_was_built_and_nothing_of_the_machine() {
    let number = env!("CARGO_PKG_VERSION");
    assert_eq!(run("-V").done(), format!("pinhole {number}\n"));
    let version = run("--version").done();
    let build = version.strip_prefix(&format!("pinhole {number} (")).unwrap();
    let build = build.strip_suffix(")\n").unwrap();
    let parts: Vec<&str> = build.split(", ").collect();
    let (target, profile) = (parts[parts.len() - 1], parts[parts.len() - 2]);
    assert!(target.contains(std::env::consts::ARCH), "{version}");
    assert_eq!(profile, if cfg!(debug_assertions) { "debug" } else { "release" });
    let home = env!("CARGO_MANIFEST_DIR").split('/').nth(1).unwrap();
    assert!(!version.contains('/') && !version.contains(&format!("{home}/")), "{version}");
    for commit in &parts[..parts.len() - 2] {
        assert!(commit.starts_with("commit "), "{version}");
    }
}
