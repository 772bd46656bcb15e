//! *Guess which*: four mistakes, of which one made the wrong picture; a key tells.

use crate::hearing::Heard;
use crate::reader::{BUTTON, IMAGE, LABEL, Node, TOGGLE};
use crate::screen::Screen;
use crate::window::built_in;

const QUESTION: &str = "Which mistake made the wrong picture?";

/// The four options, as A to D.
fn options(nodes: &[Node]) -> Option<[String; 4]> {
    let named = |letter: &str| {
        let mut names = nodes.iter().filter(|node| node.role == BUTTON).map(|node| &node.name);
        names.find(|name| name.starts_with(&format!("{letter}: "))).cloned()
    };
    Some([named("A")?, named("B")?, named("C")?, named("D")?])
}

/// The option that the window says is right, if it does.
fn told(nodes: &[Node], options: &[String; 4]) -> Option<usize> {
    let texts = || nodes.iter().filter(|node| node.role == LABEL);
    options
        .iter()
        .position(|option| texts().any(|node| node.name.starts_with(&format!("{option}. "))))
}

/// What is said of the wrong camera's picture.
fn picture(nodes: &[Node]) -> &str {
    &nodes
        .iter()
        .find(|node| node.role == IMAGE && node.name == "Wrong camera")
        .unwrap()
        .description
}

pub(crate) fn guess_which() {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "look-at");
    let screen = Screen::start();
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    heard.click(TOGGLE, "Practice");
    heard.click(TOGGLE, "Mistakes");
    heard.click(BUTTON, "Guess which");
    heard.wait_for_text(QUESTION);
    let options = heard.wait("four options", options);
    let names = options.clone().map(|option| option[3..].to_owned());
    assert!((0..4).all(|k| !names[..k].contains(&names[k])), "{names:?}");
    heard.click(BUTTON, &options[1]);
    let nodes = heard.nodes();
    assert_eq!(told(&nodes, &options), None, "a vote is no answer yet");
    assert!(names.iter().all(|name| !picture(&nodes).contains(name)), "{}", picture(&nodes));
    heard.key("Next");
    let right = heard.wait("the answer", |nodes| told(nodes, &options));
    let nodes = heard.nodes();
    assert!(picture(&nodes).starts_with(&names[right]), "{}", picture(&nodes));
    assert_eq!(self::options(&nodes).as_ref(), Some(&options), "nothing else has changed");
    heard.window.quit();
}
