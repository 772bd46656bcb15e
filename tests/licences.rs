//! What the program is made of: its licences are allowed and listed, no crate is there in two versions for
//! no reason, and all are from crates.io. What is allowed stands in `.cargo/deny.toml`.
//! `UPDATE_EXPECT=1` writes the list anew. `.ci/licences` finds the texts of the licences.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use expect_test::expect_file;
use toml_edit::{DocumentMut, Value};

/// What the list says of a licence's name that is not plain.
const HEAD: &str = "\
# What Pinhole is made of

Every crate in the program for Linux x86-64, by licence. Where there is a choice (`OR`), each is enough.
A release has the texts of all of them in `LICENCES.txt`.

Pinhole itself is under MIT or Apache-2.0. The fonts of its figures and formulas (Noto Sans, Noto Sans
Math, in `assets/fonts`) are under the SIL Open Font License, OFL-1.1; those of its window (Hack, Noto
Emoji, emoji-icon-font, Ubuntu Light) come with `epaint_default_fonts`. The Rust standard library is
under MIT OR Apache-2.0. The colours of the elements are Jmol's, the radii Bondi's and Alvarez'.

";

/// A crate of the program.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Package {
    name: String,
    version: String,
    licence: String,
    repository: String,
}

/// The crates that are linked into the program for Linux x86-64, but for our own. Cargo has fetched them where
/// that is the system that it builds for.
fn packages() -> BTreeSet<Package> {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--locked", "-p", "pinhole", "-e", "normal"])
        .args(["--target", "x86_64-unknown-linux-gnu", "--prefix", "none", "--no-dedupe"])
        .args(["--format", "{p}|{l}|{r}"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8(output.stdout).unwrap();
    let package = |line: &str| {
        let [package, licence, repository] = line.split('|').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let mut words = package.split(' ');
        let (name, version) = (words.next().unwrap(), words.next().unwrap());
        let [name, version, licence, repository] =
            [name, version.trim_start_matches('v'), licence, repository].map(str::to_owned);
        Package { name, version, licence, repository }
    };
    tree.lines().map(package).filter(|package| !package.name.starts_with("pinhole")).collect()
}

fn toml(file: &str) -> DocumentMut {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    std::fs::read_to_string(path).unwrap().parse().unwrap()
}

/// Whether an expression of SPDX (or its forerunner, in which `/` is a choice) can be satisfied.
fn is_allowed(expression: &str) -> bool {
    let deny = toml(".cargo/deny.toml");
    let allowed = deny["licenses"]["allow"].as_array().unwrap();
    let allowed: Vec<&str> = allowed.iter().filter_map(Value::as_str).collect();
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = &words[..];
    let is_allowed = any_of(&mut rest, &allowed);
    assert!(rest.is_empty(), "{expression}");
    is_allowed
}

fn any_of(words: &mut &[&str], allowed: &[&str]) -> bool {
    let mut is_allowed = all_of(words, allowed);
    while words.first() == Some(&"OR") {
        *words = &words[1..];
        is_allowed |= all_of(words, allowed);
    }
    is_allowed
}

fn all_of(words: &mut &[&str], allowed: &[&str]) -> bool {
    let mut is_allowed = one(words, allowed);
    while words.first() == Some(&"AND") {
        *words = &words[1..];
        is_allowed &= one(words, allowed);
    }
    is_allowed
}

fn one(words: &mut &[&str], allowed: &[&str]) -> bool {
    let (first, rest) = words.split_first().unwrap_or((&"", &[]));
    *words = rest;
    if *first == "(" {
        let is_allowed = any_of(words, allowed);
        assert_eq!(words.first(), Some(&")"));
        *words = &words[1..];
        return is_allowed;
    }
    if words.first() == Some(&"WITH") {
        // An exception only ever takes demands away.
        *words = &words[2..];
    }
    allowed.contains(first)
}

#[test]
fn expressions_are_understood() {
    for allowed in
        ["MIT", "GPL-3.0-only OR MIT", "(MIT OR X) AND ISC", "MIT/X", "Apache-2.0 WITH Y"]
    {
        assert!(is_allowed(allowed), "{allowed}");
    }
    for refused in ["", "GPL-3.0-only", "MIT AND X", "(MIT OR X) AND Y", "X OR Y AND MIT"] {
        assert!(!is_allowed(refused), "{refused}");
    }
}

#[test]
#[cfg_attr(
    not(all(target_os = "linux", target_arch = "x86_64")),
    ignore = "it is about the crates for Linux x86-64, and cargo has fetched this system's"
)]
fn every_licence_is_allowed() {
    let packages = packages();
    assert!(packages.len() > 200, "{}", packages.len());
    let refused: Vec<String> = packages
        .iter()
        .filter(|package| !is_allowed(&package.licence))
        .map(|package| format!("{}: {:?}", package.name, package.licence))
        .collect();
    assert!(refused.is_empty(), "{refused:?}");
}

/// Also those of other systems and of the tests.
#[test]
fn no_crate_is_there_in_two_versions_for_no_reason() {
    let (lock, deny) = (toml("Cargo.lock"), toml(".cargo/deny.toml"));
    let mut versions: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for package in lock["package"].as_array_of_tables().unwrap() {
        let [name, version] = ["name", "version"].map(|key| package[key].as_str().unwrap());
        versions.entry(name).or_default().insert(version);
    }
    let mut needless = Vec::new();
    for skipped in deny["bans"]["skip"].as_array().unwrap() {
        let [skipped, reason] = ["crate", "reason"].map(|key| {
            skipped.as_inline_table().and_then(|entry| entry.get(key)?.as_str()).unwrap()
        });
        assert!(!reason.is_empty(), "{skipped}");
        let (name, begin) = skipped.split_once('@').unwrap();
        let known = versions.get_mut(name).filter(|known| known.len() > 1);
        let begin = format!("{begin}.");
        let found = known.as_ref().and_then(|known| known.iter().find(|v| v.starts_with(&begin)));
        match found.copied() {
            Some(version) => drop(known.unwrap().remove(version)),
            None => needless.push(skipped),
        }
    }
    assert!(needless.is_empty(), "deny.toml skips what is not there twice: {needless:?}");
    versions.retain(|_, versions| versions.len() > 1);
    assert!(versions.is_empty(), "in several versions, and not in deny.toml: {versions:?}");
}

#[test]
fn everything_is_from_crates_io() {
    let lock = toml("Cargo.lock");
    let own = ["pinhole", "core", "exchange", "figure", "lecture", "page", "reference"];
    for package in lock["package"].as_array_of_tables().unwrap() {
        let name = package["name"].as_str().unwrap();
        match package.get("source").map(|source| source.as_str().unwrap()) {
            None => assert!(own.contains(&name.trim_start_matches("pinhole-")), "{name}"),
            Some(source) => {
                assert_eq!(
                    source, "registry+https://github.com/rust-lang/crates.io-index",
                    "{name}"
                );
            }
        }
    }
}

#[test]
#[cfg_attr(
    not(all(target_os = "linux", target_arch = "x86_64")),
    ignore = "it is about the crates for Linux x86-64, and cargo has fetched this system's"
)]
fn the_list_is_current() {
    let packages = packages();
    let mut by_licence: BTreeMap<&str, Vec<&Package>> = BTreeMap::new();
    for package in &packages {
        by_licence.entry(&package.licence).or_default().push(package);
    }
    let mut list = HEAD.to_owned();
    for (licence, packages) in by_licence {
        list += &format!("## {licence}\n\n");
        for Package { name, version, repository, .. } in packages {
            let from =
                if repository.is_empty() { String::new() } else { format!(", <{repository}>") };
            list += &format!("- {name} {version}{from}\n");
        }
        list.push('\n');
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/licences/THIRD_PARTY.md");
    expect_file![path].assert_eq(&format!("{}\n", list.trim_end()));
}

#[test]
fn the_crates_that_can_be_used_alone_have_their_licences() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in ["LICENSE-APACHE", "LICENSE-MIT"] {
        let ours = std::fs::read(root.join(name)).unwrap();
        for folder in ["src/core", "src/lecture", "src/exchange"] {
            let own = std::fs::read(root.join(folder).join(name)).unwrap();
            assert_eq!(own, ours, "{folder}/{name}");
        }
    }
}
