//! What is generated from the command line's definition: man pages and shell completions.
//! `UPDATE_EXPECT=1` writes them anew.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::CommandFactory as _;
use clap_complete::Shell;
use clap_mangen::roff::{Roff, bold, roman};
use expect_test::expect_file;
use pinhole::cli::arguments::Arguments;
use pinhole::ui::commands_table;
use pinhole_exchange::scenes::BuiltinScene;

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

/// As clap has it, but for the synopsis, which is that of `--help` with the values' names, and for the
/// status, which a section of its own tells.
fn man_page(command: &clap::Command, name: &str) -> String {
    const STATUS: &str = "0: done; 1: the input is at fault; 2: the arguments are wrong.";
    let own = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let (status, notes) = match own.strip_prefix("Status ") {
        Some(status) => (status, ""),
        None => (STATUS, &own[..]),
    };
    let has_commands = command.has_subcommands();
    let man = clap_mangen::Man::new(command.clone()).title(name).manual("Pinhole").date("");
    let mut page = Vec::new();
    man.render_title(&mut page).unwrap();
    man.render_name_section(&mut page).unwrap();
    section(&mut page, "SYNOPSIS", &usage(command));
    man.render_description_section(&mut page).unwrap();
    man.render_options_section(&mut page).unwrap();
    if has_commands {
        man.render_subcommands_section(&mut page).unwrap();
    }
    if !notes.is_empty() {
        section(&mut page, "NOTES", notes);
    }
    if has_commands {
        keys_section(&mut page);
    }
    section(&mut page, "EXIT STATUS", status);
    if !has_commands {
        section(&mut page, "SEE ALSO", "pinhole(1)");
    }
    String::from_utf8(page).unwrap()
}

/// `pinhole check [OPTIONS] --answers <IN.csv|IN.png> <SCENE>`, a line a way to call it.
fn usage(command: &clap::Command) -> String {
    let usage = command.clone().render_usage().to_string();
    let lines = usage.trim_start_matches("Usage:").lines().map(str::trim);
    lines.collect::<Vec<_>>().join("\n")
}

fn section(page: &mut Vec<u8>, title: &str, text: &str) {
    let mut section = Roff::new();
    section.control("SH", [title]);
    for (index, line) in text.lines().enumerate() {
        if index > 0 {
            section.control("br", []);
        }
        section.text([roman(line)]);
    }
    section.to_writer(page).unwrap();
}

/// The window's keys, as its own list of keys has them.
fn keys_section(page: &mut Vec<u8>) {
    let mut section = Roff::new();
    section.control("SH", ["KEYS"]);
    for (group, rows) in commands_table::sheet() {
        section.control("SS", [group.label()]);
        for (keys, what) in rows {
            section.control("TP", []).text([bold(keys)]).text([roman(what)]);
        }
    }
    section.to_writer(page).unwrap();
}

#[test]
fn the_man_pages_are_current() {
    let definition = definition();
    let pages: Vec<(String, String)> = [&definition]
        .into_iter()
        .chain(definition.get_subcommands())
        .map(|command| {
            let name = command.get_display_name().unwrap_or(command.get_name()).to_owned();
            (format!("{name}.1"), man_page(command, &name))
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
        (name.to_owned(), with_scenes(shell, String::from_utf8(text).unwrap()))
    });
    assert_files("completions", &files);
}

/// With the built-in scenes where one may stand, for which clap offers files alone.
fn with_scenes(shell: Shell, mut text: String) -> String {
    let scenes: Vec<&str> = BuiltinScene::all().iter().map(|scene| scene.name).collect();
    let scenes = scenes.join(" ");
    let definition = definition();
    let commands = definition.get_subcommands().filter(|command| takes_scene(command));
    let commands = commands.map(clap::Command::get_name);
    match shell {
        Shell::Bash => {
            let subcommands = commands.map(|name| format!("pinhole__subcmd__{name}"));
            for case in subcommands.chain(["pinhole".to_owned()]) {
                let options = format!(" {case})\n            opts=\"");
                assert_eq!(text.matches(&options).count(), 1, "{case}");
                text = text.replace(&options, &format!("{options}{scenes} "));
            }
        }
        Shell::Zsh => {
            let count = text.matches(":scene -- ").count() + text.matches(":scenes -- ").count();
            assert_eq!(count, commands.count() + 1);
            let lines = text.lines().map(|line| match line.split_once(":scene") {
                Some(_) => line.replace(":_files'", ":_pinhole_scenes'") + "\n",
                None => format!("{line}\n"),
            });
            let start = "if [ \"$funcstack[1]\"";
            let own = format!(
                "_pinhole_scenes() {{\n    _alternative 'scenes:built-in scene:({scenes})' \
                 'files:scene file:_files'\n}}\n\n{start}"
            );
            text = lines.collect::<String>().replace(start, &own);
        }
        Shell::Fish => {
            let conditions = commands.map(|name| format!("using_subcommand {name}"));
            for condition in conditions.chain(["needs_command".to_owned()]) {
                text += &format!(
                    "complete -c pinhole -n \"__fish_pinhole_{condition}\" -a \"{scenes}\" \
                     -d 'Built-in scene'\n"
                );
            }
        }
        other => panic!("{other} is not written"),
    }
    text
}

fn takes_scene(command: &clap::Command) -> bool {
    command
        .get_positionals()
        .any(|argument| ["scene", "scenes"].contains(&argument.get_id().as_str()))
}

#[test]
#[cfg(unix)]
#[expect(clippy::print_stdout, reason = "says that it was left out")]
fn bash_offers_the_built_in_scenes() {
    if std::process::Command::new("bash").arg("--version").output().is_err() {
        println!("left out: bash is not there");
        return;
    }
    let offered = |words: &str| {
        let script = format!(
            "source '{}'; COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); \
             _pinhole pinhole \"${{COMP_WORDS[-1]}}\" \"${{COMP_WORDS[-2]}}\"; \
             echo \"${{COMPREPLY[@]}}\"",
            assets().join("completions/pinhole.bash").display()
        );
        let output = std::process::Command::new("bash").args(["-c", &script]).output().unwrap();
        String::from_utf8(output.stdout).unwrap().trim_end().to_owned()
    };
    for words in ["render can", "trace --rays in.csv can", "report can", "can"] {
        assert_eq!(offered(&format!("pinhole {words}")), "canonical", "{words}");
    }
    assert_eq!(offered("pinhole import can"), "", "that is another program's file");
    assert_eq!(offered("pinhole render no-such-scene"), "", "which is completed as a file");
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
