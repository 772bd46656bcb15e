//! Figures read back by other programs, and compared with the PNG: SVG by resvg, with no fonts but
//! those in the file; PDF by poppler's pdftoppm and pdftotext, where they are installed.

#![allow(clippy::print_stdout, reason = "CI shows how far the pictures are apart, and what ran")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

use super::figure::{decode, figure};

/// A name, the command's arguments, and how far its picture by another program may be from the PNG.
///
/// Letters stand on whole dots in the window, and elsewhere where they stand; edges cover other parts
/// of a dot; poppler enlarges pictures by a dot; the grid's lines are thinner in a finer picture. That differs most where all is text, or fine lines.
struct Case(&'static str, &'static str, Tolerance);

/// The mean difference of a channel, of 255; how many of a hundred dots may differ by a third.
struct Tolerance(f64, f64);

/// Every kind of figure: with text alone, with pixels, with both, dark and light.
const FIGURES: [Case; 6] = [
    Case("world", "look-at --view world --width 900 --uv 0.2,-0.1", Tolerance(4.0, 0.4)),
    Case("dark", "canonical --view world --width 900 --uv 0,0 --theme dark", Tolerance(3.0, 0.3)),
    Case("camera", "canonical --view camera --pixel 99,199", Tolerance(0.6, 0.25)),
    Case("grid", "non-square --view camera --width 600", Tolerance(0.8, 0.2)),
    Case("derivation", "look-at --view derivation --width 900 --uv 0.2,-0.1", Tolerance(8.0, 4.0)),
    Case("lines", "canonical --view lines --width 900", Tolerance(3.2, 1.5)),
];

/// What a string in base 64 stands for.
pub(crate) fn decoded(text: &str) -> Vec<u8> {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let values: BTreeMap<u8, u32> = digits.iter().copied().zip(0..).collect();
    let text = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::new();
    for four in text.chunks(4) {
        let bits = four.iter().fold(0, |bits, digit| bits << 6 | values[digit]);
        let bits = bits << (6 * (4 - four.len()));
        bytes.extend(&bits.to_be_bytes()[1..four.len()]);
    }
    bytes
}

/// Fails unless both are the same picture, but for the edges of strokes and letters.
#[track_caller]
fn compare(Case(name, _, within): &Case, folder: &Path, other: (u32, u32, Vec<[u8; 4]>)) {
    let (width, height, own, _) = decode(&folder.join(format!("{name}.png")));
    assert_eq!((width, height), (other.0, other.1), "{name}");
    let (mut sum, mut far) = (0_u64, 0);
    for (a, b) in own.iter().zip(&other.2) {
        let differs = [0, 1, 2].map(|k| u64::from(a[k].abs_diff(b[k])));
        sum += differs.iter().sum::<u64>();
        far += usize::from(differs.iter().any(|d| *d > 85));
    }
    let mean = sum as f64 / (3 * own.len()) as f64;
    let share = 100.0 * far as f64 / own.len() as f64;
    println!(
        "{name}: mean difference {mean:.3} of 255, {share:.3} % of the dots differ by a third"
    );
    assert!(mean < within.0 && share < within.1, "{name}: {mean} {share}");
}

#[test]
fn resvg_draws_the_same() {
    let folder = tempfile::tempdir().unwrap();
    for case in &FIGURES {
        let Case(name, line, _) = case;
        for ending in ["svg", "png"] {
            figure(folder.path(), &format!("{line} -o {name}.{ending}")).done();
        }
        let svg = fs::read_to_string(folder.path().join(format!("{name}.svg"))).unwrap();
        let mut fonts = Database::new();
        for part in svg.split("data:font/ttf;base64,").skip(1) {
            fonts.load_font_data(decoded(part.split(')').next().unwrap()));
        }
        assert_eq!(fonts.len(), svg.matches("@font-face").count(), "every font can be read");
        let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
        let tree = Tree::from_str(&svg, &options).unwrap();
        let size = tree.size().to_int_size();
        let mut pixmap = Pixmap::new(size.width(), size.height()).unwrap();
        resvg::render(&tree, Transform::identity(), &mut pixmap.as_mut());
        let pixels = pixmap.data().chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect();
        compare(case, folder.path(), (size.width(), size.height(), pixels));
    }
}

/// Whether a program of poppler's is there. Where it must be, as the environment says, its absence
/// fails the test.
fn is_there(program: &str) -> bool {
    let there = Command::new(program).arg("-v").output().is_ok();
    let word = if there { "ran" } else { "is not installed: PDF is not read back" };
    println!("{program} {word}");
    let required = std::env::var_os("PINHOLE_TEST_POPPLER").is_some();
    assert!(there || !required, "{program} must be installed for this test");
    there
}

#[test]
fn pdftoppm_draws_the_same() {
    if !is_there("pdftoppm") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for case in &FIGURES {
        let Case(name, line, _) = case;
        for ending in ["pdf", "png"] {
            figure(folder.path(), &format!("{line} -o {name}.{ending}")).done();
        }
        let drawn = Command::new("pdftoppm")
            .args(["-r", "96", "-png", "-singlefile"])
            .arg(format!("{name}.pdf"))
            .arg(format!("{name}-drawn"))
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(drawn.status.success() && drawn.stderr.is_empty(), "{drawn:?}");
        let (width, height, pixels, _) = decode(&folder.path().join(format!("{name}-drawn.png")));
        compare(case, folder.path(), (width, height, pixels));
    }
}

#[test]
fn pdftotext_finds_the_labels() {
    if !is_there("pdftotext") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let text_of = |line: &str| {
        figure(folder.path(), &format!("{line} -o out.pdf")).done();
        let mut command = Command::new("pdftotext");
        let command = command.args(["-raw", "out.pdf", "-"]).current_dir(folder.path());
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    let world = text_of(FIGURES[0].1);
    let mut words: Vec<&str> = world.split_whitespace().collect();
    words.sort_unstable();
    assert_eq!(words, ["at", "eye", "hit", "n", "u", "up", "v", "view", "w", "x", "y", "z"]);
    let derivation = text_of(FIGURES[4].1);
    for part in ["Basis", "normalize(−view)", "(−0.12464, 0.9882, −0.089027)", "target"] {
        assert!(derivation.contains(part), "no {part} in {derivation}");
    }
    let lines = text_of(FIGURES[5].1);
    for part in ["𝑓 > 0", "ray hits: 𝑡 = 1", "𝑡 = 0.5", "sorted by 𝑡", "They meet at"] {
        assert!(lines.contains(part), "no {part} in {lines}");
    }
}
