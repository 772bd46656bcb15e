//! The numbers of every step, as they are read on the screen and by screen readers.
//!
//! What is expected is written by hand: DESIGN's exact answers, or what follows from them in the head,
//! as the comments say.

use std::collections::BTreeSet;

use egui_kittest::kittest::NodeT as _;
use pinhole::model::lessons::builtin;

use super::{Window, at_step, go_to};

/// What is there, and how it reads.
type Reads = (&'static str, &'static str);

/// In place of a name: a text that stands for itself.
const SAYS: &str = "";

/// Lesson, step, and what is read in it.
const NUMBERS: &[(usize, usize, &[Reads])] = &[
    // The canonical camera: eye at the origin, along -z, 1 x 1 at distance 1.
    (
        1,
        1,
        &[
            ("p", "(0, 0, 0)"),
            ("d", "(0, 0, −1)"),
            ("width", "1"),
            ("height", "1"),
            ("distance", "1"),
            ("u", "(1, 0, 0)"),
            ("v", "(0, 1, 0)"),
            ("w", "(0, 0, 1)"),
        ],
    ),
    // u = 5.5/8 - 1/2 and v = 1/2 - 2.5/8.
    (1, 2, &[("pixel", "row 3, column 6 (from 1)"), ("(u, v)", "(0.1875, 0.1875)")]),
    // 199/800 and 201/800.
    (1, 3, &[("u", "0.24875"), ("v", "0.25125")]),
    (1, 4, &[("𝐩 + t 𝐝", "(0, 0, 0) + t (0.24875, 0.25125, −1)")]),
    (2, 1, &[("𝐩 + t 𝐝", "(0, 0, 0) + t (0.2, −0.1, −1)")]),
    (2, 2, &[("(u, v)", "(0.2, −0.1)"), ("pixel", "the corner of four pixels")]),
    // (0.5 + 0.2) 10 = 7 columns from the left and (0.5 + 0.1) 10 = 6 rows from the top.
    (2, 3, &[("pixel", "the corner of four pixels"), ("d", "(0.2, −0.1, −1)")]),
    (2, 4, &[("0 − t", "−6"), ("t", "6"), ("hit", "(1.2, −0.6, −6)")]),
    (2, 5, &[(SAYS, "What is the viewing ray p + t d through (u, v) = (0.3, −0.2)?")]),
    (
        2,
        6,
        &[(
            SAYS,
            "The ray through (u, v) = (0.4, −0.2), with d as the lecture builds it, meets the plane z = −4. At which t, and where?",
        )],
    ),
    // Twice those of 1.3.
    (
        3,
        1,
        &[
            ("(u, v)", "(0.4975, 0.5025)"),
            ("width", "2"),
            ("height", "2"),
            ("pixel", "row 99, column 299"),
        ],
    ),
    (3, 2, &[("d", "(0.2, −0.1, −2)"), ("t", "3"), ("point", "(0.6, −0.3, −6)")]),
    // The warm-up's point, reached in half as many steps of twice the length.
    (3, 3, &[("d", "(0.4, −0.2, −2)"), ("t", "3"), ("point", "(1.2, −0.6, −6)")]),
    // 1.5/400 over 1/400.
    (3, 4, &[(SAYS, "Pixels are 1.5 times as wide as high: spheres look stretched")]),
    (
        3,
        5,
        &[(
            SAYS,
            "With 600 × 400 pixels, each is as wide as high, and the middle ball is round. The outer two are 6% too wide, but that is perspective.",
        )],
    ),
    (
        3,
        6,
        &[
            (SAYS, "A canonical camera, but the viewport is at distance 2.5 from the eye."),
            (
                SAYS,
                "What is d through (u, v) = (0.3, 0.1), so that t = 1 is on the viewport? At which t is the plane z = −7.5?",
            ),
        ],
    ),
    (4, 1, &[("𝐩 + t 𝐝", "(2, 0.5, 1) + t (0.2, −0.1, −1)")]),
    // At - eye = (-2, -0.5, -6), so w = (4, 1, 12)/√161 and u = (3, 0, -1)/√10.
    (4, 2, &[("p", "(2, 0.5, 1)"), ("d", "(−0.12302, −0.1785, −1.0015)")]),
    // 0.2, -0.1 and -1 in three bases.
    (
        5,
        1,
        &[
            ("u 𝐮", "0.2 (1, 0, 0) = (0.2, 0, 0)"),
            ("v 𝐯", "−0.1 (0, 1, 0) = (0, −0.1, 0)"),
            ("−distance 𝐰", "−1 (0, 0, 1) = (0, 0, −1)"),
            ("𝐝", "(0.2, −0.1, −1)"),
        ],
    ),
    // With s = 1/√2: (-0.8 s, -0.1, -1.2 s).
    (5, 2, &[("d", "(−0.56569, −0.1, −0.84853)")]),
    (5, 3, &[("𝐝", "(−0.1, −1, 0.2)")]),
    (6, 1, &[("u", "(0.70711, 0, −0.70711)"), ("v", "(0, 1, 0)"), ("w", "(0.70711, 0, 0.70711)")]),
    (6, 2, &[("|𝐮|", "|𝐯| = |𝐰| = 1"), ("𝐮 · 𝐯", "𝐯 · 𝐰 = 𝐰 · 𝐮 = 0"), ("(𝐮 × 𝐯) · 𝐰", "1")]),
    (6, 3, &[("𝐝", "(−2 √2/5, −0.1, −3 √2/5)")]),
    // -w has an x, too.
    (6, 4, &[("−distance 𝐰", "(−1/√2, 0, −1/√2)"), ("d", "(−0.56569, −0.1, −0.84853)")]),
    (6, 5, &[("0 − 3 √2/5 t", "−6"), ("t", "5 √2"), ("hit", "(−4, −1/√2, −6)")]),
    (
        6,
        6,
        &[(
            SAYS,
            "What are u, v, w and d = u u + v v − w for (u, v) = (0.2, 0.1)? At which t does it meet z = 4?",
        )],
    ),
    // View is (0, -0.2, -4), of length √16.04.
    (7, 1, &[("up from view", "92.862°"), ("d", "(0, −0.049938, −0.99875)")]),
    (7, 2, &[("−view", "(0, 4, 3)"), ("𝐰", "(0, 0.8, 0.6)")]),
    (7, 3, &[("up × 𝐰", "(0.6, 0, 0)"), ("𝐮", "(1, 0, 0)")]),
    (7, 4, &[("𝐯", "(0, 0.6, −0.8)")]),
    // The cosine of the angle between up and view is -0.8, its sine 0.6, and 1/0.6 = 5/3.
    (
        7,
        5,
        &[
            ("u", "(1, 0, 0)"),
            ("v", "(0, 0.6, −0.8)"),
            ("w", "(0, 0.8, 0.6)"),
            ("angle(up, view)", "143.13°"),
            ("sensitivity", "1.6667"),
        ],
    ),
    (7, 6, &[(SAYS, "A camera looks along view = (3, 0, 0), with up = (−1, 3, 4).")]),
    (8, 1, &[("view", "(−21, −4, −15)")]),
    (8, 2, &[("up × 𝐰", "(15, 0, −21)/√682"), ("𝐮", "(5, 0, −7)/√74")]),
    // At is √682 = 26.115 away; the ball around it has radius 3.
    (8, 3, &[("(u, v)", "(0, 0)"), ("d", "(−0.80413, −0.15317, −0.57438)"), ("t", "23.115")]),
    (8, 4, &[(SAYS, "A camera has eye = (−4, 3, −3), at = (−3, 2, −5) and up = (0, 1, 0).")]),
    (
        8,
        5,
        &[
            ("𝐰", "(21, 4, 15)/√682"),
            ("𝐮", "(5, 0, −7)/√74"),
            // Right of the middle and below it: (u, v) = (0.32625, −0.05625).
            ("𝐝", "(−0.60749, −0.20875, −0.83485)"),
        ],
    ),
    // The eye is √52 from at, and 4 off the vertical through it: √52/4.
    (9, 1, &[("sensitivity", "1.8° of roll per 1° of up"), ("sensitivity", "1.8028")]),
    // √(8² + 2 · 0.05²)/(0.05 √2).
    (9, 2, &[("sensitivity", "113° of roll per 1° of up"), ("𝐮", "(1/√2, 0, −1/√2)")]),
    (
        9,
        3,
        &[
            ("up × 𝐰", "(0, 0, 0)"),
            (SAYS, "up (0, 1, 0) is parallel to the view direction (0, −8, 0): turn one of them"),
        ],
    ),
    (
        9,
        4,
        &[
            ("view", "(0, 0, 0)"),
            (SAYS, "eye and at are the same point (0, 0, 0): move one of them"),
        ],
    ),
    (9, 5, &[("up × 𝐰", "(0, 0, 0)"), (SAYS, "up is (0, 0, 0): it must point somewhere")]),
    // Normalize(view) for its opposite; u = up x w turns with it, v = w x u does not.
    (10, 1, &[("wrong w", "(0, 0, −1)"), (SAYS, "(0, 0, 1)")]),
    (
        10,
        2,
        &[
            ("wrong u", "(−1, 0, 0)"),
            ("|𝐮| = |𝐯| = |𝐰|", "1 passes"),
            ("𝐮 · 𝐯 = 𝐯 · 𝐰 = 𝐰 · 𝐮", "0 passes"),
            ("(𝐮 × 𝐯) · 𝐰", "1 passes"),
        ],
    ),
    (10, 3, &[(SAYS, "𝐰 · view / |view| = −1 < 0"), (SAYS, "𝐰 · view / |view| = 1")]),
    (11, 1, &[("implicit", "f(x, y) = a x + b y + c = 2 x + y − 2")]),
    (
        11,
        2,
        &[
            ("slide t", "(−0.5, 1.5)"),
            ("parametric", "x = px + t dx = −1 + t,  y = py + t dy = 2 − t"),
        ],
    ),
    // 2 (-1 + t) + 2 - t - 2.
    (11, 3, &[(SAYS, "added up: = t − 2"), ("zero where", "t = 2")]),
    // -1 + t + 3 (2 - t) - 7.
    (11, 4, &[(SAYS, "added up: = −2 t − 2"), ("zero where", "t = 2 / (−2) = −1")]),
    // -1 + t + 2 - t + 1.
    (11, 5, &[(SAYS, "added up: = 2"), ("zero where", "0 t = −2: for no t")]),
    (11, 6, &[(SAYS, "The line x − 3y + 11 = 0 and the ray (1, 3) + t (−3, −2).")]),
    (12, 1, &[("t (𝐧 · 𝐝)", "𝐧 · (point − 𝐩)"), ("t", "6"), ("hit", "(1.2, −0.6, −6)")]),
    (12, 2, &[("|𝐱 − centre|²", "r²"), ("a t² + 2 b t + c", "0")]),
    // The middle is (0, 0.75, -4) from the eye: 0.75² + 16 - 1.25².
    (12, 3, &[("a", "1"), ("b", "−4"), ("c", "15"), ("t² − 8 t + 15", "0")]),
    // 16 - 15.
    (12, 4, &[("D", "1")]),
    // (5 - 1)/1 and (5 + 1)/1.
    (12, 5, &[("t₁", "4"), ("hit", "(0, 0, −4)"), ("t₂", "6")]),
    // 25 - 1.05 · 24, and 25 - 25.
    (12, 6, &[("D", "−0.2")]),
    (12, 7, &[("D", "0"), ("t", "5")]),
    // 1 + 15; (1 + 4)/1.
    (12, 8, &[("D", "16"), ("t₂", "5")]),
    (
        12,
        9,
        &[(
            SAYS,
            "The ray (0, −2, 1) + t (0, 0, −2) and the sphere around (4, −2, −10) of radius 5.",
        )],
    ),
    // 10 - 2 and 10 + 2; 5 - 1 and 5 + 1; the wall.
    (
        13,
        1,
        &[
            ("World view", "u 0, v 0: hits sphere 1 “near ball” at t = 4, point = (0, 0, −4)"),
            ("t₁", "4"),
            ("t₂", "6"),
        ],
    ),
    // -5 - 1 and -5 + 1.
    (
        13,
        2,
        &[
            ("World view", "u 0, v 0: hits sphere 1 “near ball” at t = 4, point = (0, 0, −4)"),
            ("t₁", "4"),
            ("t₁", "−6"),
            ("t₂", "−4"),
        ],
    ),
    (12, 10, &[("D", "1"), ("t₁", "4"), ("hit", "(0, 0, −4)")]),
    // Half a pixel off the middle; the ball's surface is √682 - 3 away, as in 8.3.
    (13, 3, &[("(u, v)", "(0.00125, −0.00125)"), ("t", "23.115")]),
    (13, 4, &[("(u, v)", "(0.00125, −0.00125)"), ("t", "23.115")]),
];

/// What a text says of what: `𝐮 = normalize(…) = (1, 0, 0)/1 = (1, 0, 0); a remark` reads
/// `(1, 0, 0)` for 𝐮, and so does all that stands between; `|𝐮|: 1 passes` reads `1 passes`.
fn reads(text: &str, (name, reading): Reads) -> bool {
    if name == SAYS {
        return text == reading;
    }
    let text = text.split("; ").next().unwrap_or_default();
    let Some(rest) = text.strip_prefix(name) else { return false };
    if rest.strip_prefix(": ") == Some(reading) {
        return true;
    }
    let related = rest.strip_prefix(" = ").or_else(|| rest.strip_prefix(" ≈ "));
    let Some(rest) = related else { return false };
    // What follows is rounded, or a note.
    let rest = rest.split("; ").next().unwrap_or_default();
    let exact = |text: &str| text.split(" ≈ ").next() == Some(reading);
    exact(rest)
        || rest.rsplit(" = ").next().is_some_and(exact)
        || rest.rsplit(" ≈ ").next() == Some(reading)
}

/// Every text on the screen, and every value or description with its label.
fn texts(window: &Window) -> Vec<(String, Option<String>)> {
    let nodes = window.root().children_recursive();
    // A space that breaks no line reads like any other.
    let plain = |text: Option<String>| text.map(|text| text.replace('\u{a0}', " "));
    let texts = nodes
        .map(|node| node.accesskit_node())
        .map(|n| (plain(n.label()), plain(n.value().or(n.description()))));
    texts
        .filter_map(|texts| match texts {
            (Some(label), value) => Some((label, value)),
            (None, value) => Some((value?, None)),
        })
        .collect()
}

/// Returns what is missing, and what there is instead.
fn missing(window: &Window, (lesson, step): (usize, usize), wanted: Reads) -> Option<String> {
    let texts = texts(window);
    let found = texts.iter().any(|(text, value)| match value {
        Some(value) => text == wanted.0 && value == wanted.1 || reads(value, wanted),
        None => reads(text, wanted),
    });
    let alike = || -> Vec<_> {
        texts.iter().filter(|(text, _)| wanted.0 != SAYS && text.starts_with(wanted.0)).collect()
    };
    (!found).then(|| format!("{lesson}.{step}: no {wanted:?}; there is {:?}", alike()))
}

#[test]
fn every_step_reads_what_it_is_about() {
    let mut window = at_step(1, 1);
    let mut all_missing = Vec::new();
    for &(lesson, step, wanted) in NUMBERS {
        go_to(&mut window, lesson, step);
        all_missing.extend(wanted.iter().filter_map(|it| missing(&window, (lesson, step), *it)));
    }
    assert!(all_missing.is_empty(), "{}", all_missing.join("\n"));
}

#[test]
fn no_step_is_without_a_number() {
    let steps = |(index, lesson): (usize, &std::sync::Arc<pinhole::model::lessons::Lesson>)| {
        (1..=lesson.steps.len()).map(move |step| (index + 1, step)).collect::<Vec<_>>()
    };
    let all: BTreeSet<_> = builtin::all().iter().enumerate().flat_map(steps).collect();
    let known: BTreeSet<_> =
        NUMBERS.iter().filter(|row| !row.2.is_empty()).map(|row| (row.0, row.1)).collect();
    assert_eq!(known, all);
}

#[test]
fn a_text_reads_its_first_name_and_its_last_value() {
    let line = "𝐮 = normalize(up × 𝐰) = (0.57, 0)/0.98 = (5, 0, −7)/√74 ≈ (0.58, 0, −0.81); a, b";
    assert!(reads(line, ("𝐮", "(5, 0, −7)/√74")));
    assert!(reads("row i = 100, column j = 200; from 1", ("row i", "100, column j = 200")));
    assert!(reads("|𝐮|: 1 passes", ("|𝐮|", "1 passes")));
    for wrong in [("𝐮", "(5, 0, −7)/√7"), ("𝐯", "(5, 0, −7)/√74"), ("𝐮", "(0.57, 0)/0.98")]
    {
        assert!(!reads(line, wrong), "{wrong:?}");
    }
}
