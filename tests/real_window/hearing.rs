//! A window that is worked by mouse and keys, and known by what a screen reader hears of it.

use std::ffi::OsStr;
use std::path::Path;

use egui::{Pos2, Rect, Vec2, vec2};

use crate::reader::{LABEL, Node, Reader, Role};
use crate::screen::{Screen, wait_for, wait_or_say};
use crate::window::{NO_DRIVER, Setting, Window};

/// A window that is heard.
pub(crate) struct Heard<'a> {
    pub(crate) window: Window<'a>,
    reader: Reader,
}

impl<'a> Heard<'a> {
    /// Opens it, drawn on the CPU, and waits until it tells its views.
    pub(crate) fn open(screen: &'a Screen, arguments: &[&OsStr], state: &Path) -> Heard<'a> {
        let name = "every driver hidden, heard";
        let setting = Setting { name, arguments: &[], environment: NO_DRIVER, drawn_by: "cpu (" };
        Heard::open_as(&setting, screen, arguments, state)
    }

    /// Opens it in this way, and waits as well.
    pub(crate) fn open_as(
        setting: &Setting,
        screen: &'a Screen,
        arguments: &[&OsStr],
        state: &Path,
    ) -> Heard<'a> {
        println!("real window, {}: {arguments:?}", setting.name);
        let reader = Reader::start(&screen.bus);
        let heard = Heard { window: Window::open(screen, arguments, state, setting), reader };
        heard.wait("anything at all", |nodes| (nodes.len() > 10).then_some(()));
        heard
    }

    /// Waits until what is told gives a value.
    #[track_caller]
    pub(crate) fn wait<T>(&self, what: &str, seen: impl Fn(&[Node]) -> Option<T>) -> T {
        let told = || format!("in {:#?}", self.reader.nodes());
        wait_or_say(what, || seen(&self.reader.nodes()?), told)
    }

    /// Everything that is told now.
    pub(crate) fn nodes(&self) -> Vec<Node> {
        wait_for("the window's tree", || self.reader.nodes())
    }

    /// Waits for a text that is exactly this.
    #[track_caller]
    pub(crate) fn wait_for_text(&self, text: &str) {
        self.wait(text, |nodes| says(nodes, text).then_some(()));
    }

    /// Where something is, once it is there.
    #[track_caller]
    pub(crate) fn rect(&self, role: Role, name: &str) -> Rect {
        self.wait(name, |nodes| {
            let mut named = nodes.iter().filter(|node| node.role == role && node.name == name);
            self.reader.rect(named.next()?)
        })
    }

    /// The dot of the window that is so far to the right and down in something.
    pub(crate) fn position(&self, role: Role, name: &str, share: Vec2) -> Pos2 {
        let rect = self.rect(role, name);
        (rect.min + share * rect.size()).floor()
    }

    /// The number that a field stands at.
    pub(crate) fn number(&self, node: &Node) -> Option<f64> {
        self.reader.number(node)
    }

    /// Clicks on the middle of something.
    pub(crate) fn click(&self, role: Role, name: &str) {
        self.window.point_at(self.position(role, name, vec2(0.5, 0.5)));
        self.window.screen.press("click", "1");
    }

    /// Does what a click on an item does, once the item is there, however slow the window is.
    #[track_caller]
    pub(crate) fn press(&self, name: &str) {
        self.wait(name, |nodes| {
            nodes.iter().filter(|node| node.name == name).find_map(|node| self.reader.press(node))
        });
    }

    /// Presses a key, as xdotool calls it; what follows is to be waited for.
    pub(crate) fn key(&self, key: &str) {
        self.window.screen.press("key", key);
    }
}

/// Whether there is a text that is exactly this.
pub(crate) fn says(nodes: &[Node], text: &str) -> bool {
    nodes.iter().any(|node| node.role == LABEL && node.name == text)
}

/// The numbers of the text that begins so, in their order.
pub(crate) fn numbers(nodes: &[Node], start: &str) -> Option<Vec<f64>> {
    let mut texts = nodes.iter().filter(|node| node.role == LABEL);
    let numbers = texts.find_map(|node| node.name.strip_prefix(start))?.replace('−', "-");
    let numbers = numbers.trim_matches(['(', ')']).split(", ");
    numbers.map(|number| number.parse().ok()).collect()
}
