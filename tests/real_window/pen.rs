//! The pen before an audience: a stroke is seen, and Escape takes it off without a trace.

use std::thread::sleep;
use std::time::Duration;

use egui::{Pos2, Rect, vec2};

use crate::hearing::Heard;
use crate::reader::IMAGE;
use crate::screen::{Dots, SIZE, Screen, wait_for, wait_or_say};
use crate::window::built_in;

/// Colour of the pen on light ground, which nothing else has.
const INK: [u8; 3] = [0x10, 0x10, 0x18];

/// The dots of a view, in a window that fills the screen.
fn dots_of(screen: &Screen, view: Rect) -> Dots {
    let [left, right] = [view.left(), view.right()].map(|x| x as usize);
    let rows = screen.dots().into_iter().skip(view.top() as usize);
    rows.take(view.height() as usize).map(|row| row[left..right].to_vec()).collect()
}

/// Whether all of a straight line has ink, but for its ends, where the pointer may be.
fn has_line(dots: &Dots, from: Pos2, to: Pos2) -> bool {
    (10..=90).all(|k| {
        let at = from + k as f32 / 100.0 * (to - from);
        dots[at.y as usize][at.x as usize] == INK
    })
}

fn ink(dots: &Dots) -> usize {
    dots.iter().flatten().filter(|dot| **dot == INK).count()
}

/// The world view before an audience and its dots, once neither changes any more.
fn at_rest(heard: &Heard) -> (Rect, Dots) {
    wait_for("a picture at rest", || {
        let seen = || {
            let nodes = heard.nodes();
            let is_presenting = nodes.iter().all(|node| node.name != "File");
            let view = heard.rect(IMAGE, "World view");
            is_presenting.then(|| (view, dots_of(heard.window.screen, view)))
        };
        let before = seen()?;
        sleep(Duration::from_millis(300));
        (seen()? == before).then_some(before)
    })
}

pub(crate) fn stroke() {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let screen = Screen::start();
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    heard.key("F5");
    let full = wait_for("full screen", || {
        let size = heard.window.size();
        (size == SIZE.map(|dots| dots as f32).into()).then_some(size)
    });
    // Nothing can be pointed at there.
    let away = full.to_pos2() - vec2(2.0, 2.0);
    heard.window.point_at(away);
    let (view, before) = at_rest(&heard);
    assert_eq!(ink(&before), 0);

    heard.key("p");
    heard.wait("the pen", |nodes| nodes.iter().find(|node| node.name == "Pen").map(drop));
    let [from, to] = [vec2(0.3, 0.2), vec2(0.7, 0.6)].map(|share| (share * view.size()).floor());
    let [from, to] = [from.to_pos2(), to.to_pos2()];
    let in_window = |at: Pos2| view.min + at.to_vec2();
    heard.window.point_at(in_window(from));
    screen.press("mousedown", "1");
    heard.window.point_at(in_window(to));
    let is_drawn = || has_line(&dots_of(&screen, view), from, to).then_some(());
    wait_for("the stroke", is_drawn);
    screen.press("mouseup", "1");
    heard.window.point_at(away);
    // Let go, it stays, and is no larger than a line with its casing.
    let drawn = wait_for("the stroke alone", || {
        let now = dots_of(&screen, view);
        is_drawn()?;
        (ink(&now) as f32 <= 9.0 * from.distance(to)).then_some(now)
    });
    let changed = drawn.iter().flatten().zip(before.iter().flatten()).filter(|(a, b)| a != b);
    let changed = changed.count() as f32 / from.distance(to);
    assert!((3.0..=15.0).contains(&changed), "{changed} dots wide");

    heard.key("Escape");
    wait_or_say(
        "the picture as before",
        || (dots_of(&screen, view) == before).then_some(()),
        || format!("with {} dots of ink", ink(&dots_of(&screen, view))),
    );
    assert!(heard.nodes().iter().all(|node| node.name != "File"), "still before an audience");
    heard.window.quit();
}
