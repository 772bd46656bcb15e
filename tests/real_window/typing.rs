//! A given number typed over where it stands in the derivation: the camera follows, and undo takes it
//! back.

use crate::hearing::{Heard, says};
use crate::reader::{NUMBER, TOGGLE};
use crate::screen::Screen;
use crate::window::built_in;

/// Waits until the derivation has the eye at this x, and so has everything that follows from it.
fn wait_for_eye(heard: &Heard, x: f64, lines: [&str; 3]) {
    for name in ["derivation eye x", "eye x"] {
        heard.wait(name, |nodes| {
            let field = nodes.iter().find(|node| node.role == NUMBER && node.name == name)?;
            (heard.number(field)? == x).then_some(())
        });
    }
    for line in lines {
        heard.wait_for_text(line);
    }
}

pub(crate) fn a_given_number() {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let screen = Screen::start();
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    heard.click(TOGGLE, "Derivation");
    let before = [
        "eye = (0, 0, 0)",
        "view = at − eye = (0, 0, −5) − (0, 0, 0) = (0, 0, −5)",
        "𝐰 = normalize(−view) = (0, 0, 5)/5 = (0, 0, 1)",
    ];
    wait_for_eye(&heard, 0.0, before);
    heard.click(NUMBER, "derivation eye x");
    heard.wait("the field to take keys", |nodes| {
        nodes.iter().find(|node| node.has_focus && node.name == "derivation eye x").map(drop)
    });
    heard.key("5");
    heard.key("Return");
    let after = [
        "eye = (5, 0, 0)",
        "view = at − eye = (0, 0, −5) − (5, 0, 0) = (−5, 0, −5)",
        "𝐰 = normalize(−view) = (5, 0, 5)/(5 √2) = (1/√2, 0, 1/√2)",
    ];
    wait_for_eye(&heard, 5.0, after);
    assert!(!says(&heard.nodes(), before[0]));
    heard.key("ctrl+z");
    wait_for_eye(&heard, 0.0, before);
    heard.key("ctrl+shift+z");
    wait_for_eye(&heard, 5.0, after);
    heard.key("ctrl+z");
    wait_for_eye(&heard, 0.0, before);
    heard.window.quit();
}
