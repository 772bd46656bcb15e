//! A step that asks before an audience: its answer comes by a key, with the lines of the derivation
//! that it is about; the next step goes on line by line.

use std::fs;

use crate::hearing::{Heard, says};
use crate::screen::Screen;

const LESSON: &str = r#"
pinhole_lesson = 1
title = "Mine"

[[step]]
title = "One"
text = "Look."
scene = "canonical"
layout = "derivation"
derivation = ["basis"]
highlight = "w"
ask = "Where does **w** point?"
answer = "Backwards."

[[step]]
title = "Two"
text = "Go on."
highlight = "nothing"
"#;

const QUESTION: &str = "Where does w point?";
const ANSWER: &str = "Backwards.";
const NEXT: &str = "Go on.";

/// The derivation of the canonical camera's basis.
const LINES: [&str; 10] = [
    "eye = (0, 0, 0)",
    "at = (0, 0, −5)",
    "up = (0, 1, 0)",
    "view = at − eye = (0, 0, −5) − (0, 0, 0) = (0, 0, −5)",
    "−view = (0, 0, 5)",
    "𝐰 = normalize(−view) = (0, 0, 5)/5 = (0, 0, 1)",
    "up × 𝐰 = (0, 1, 0) × (0, 0, 1) = (1, 0, 0)",
    "|up × 𝐰| = |up| sin(angle) = 1 · sin(90°) = 1",
    "𝐮 = normalize(up × 𝐰) = (1, 0, 0)/1 = (1, 0, 0)",
    "𝐯 = 𝐰 × 𝐮 = (0, 0, 1) × (1, 0, 0) = (0, 1, 0)",
];

/// Waits until so many lines are shown, which are the first ones, and of question, answer and the next
/// step's text these alone.
fn wait_for_lines(heard: &Heard, count: usize, texts: &[&str]) {
    let what = format!("{count} lines beside {texts:?}");
    let nodes = heard.wait(&what, |nodes| {
        let mut all = [QUESTION, ANSWER, NEXT].into_iter();
        let is_so = all.all(|text| says(nodes, text) == texts.contains(&text));
        let shown = LINES.iter().filter(|line| says(nodes, line)).count();
        (is_so && shown == count).then(|| heard.nodes())
    });
    for (k, line) in LINES.iter().enumerate() {
        assert_eq!(says(&nodes, line), k < count, "{line}, with {count} lines shown");
    }
}

pub(crate) fn key_by_key() {
    let folder = tempfile::tempdir().unwrap();
    let lesson = folder.path().join("mine.toml");
    fs::write(&lesson, LESSON).unwrap();
    let screen = Screen::start();
    let arguments = ["--lesson".as_ref(), lesson.as_os_str()];
    let mut heard = Heard::open(&screen, &arguments, folder.path());
    heard.key("F5");
    wait_for_lines(&heard, 0, &[QUESTION]);
    // The given numbers come with view.
    for count in 4..=6 {
        heard.key("Next");
        wait_for_lines(&heard, count, &[QUESTION, ANSWER]);
    }
    for count in 6..=8 {
        heard.key("Next");
        wait_for_lines(&heard, count, &[NEXT]);
    }
    heard.key("End");
    wait_for_lines(&heard, LINES.len(), &[NEXT]);
    heard.window.quit();
}
