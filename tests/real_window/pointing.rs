//! The mouse over the camera view: a pixel's ray comes and goes with it, and a click pins it.

use egui::{Pos2, Rect, vec2};

use crate::hearing::{Heard, numbers, says};
use crate::reader::{IMAGE, LABEL, Node};
use crate::screen::Screen;
use crate::window::built_in;

/// Row and column of the pixel under a dot, of 400 by 400, and its (u, v) by the lecture's formula.
fn pixel(view: Rect, at: Pos2) -> ([u32; 2], [f64; 2]) {
    let share = (at + vec2(0.5, 0.5) - view.min) / view.size();
    let [row, column] = [share.y, share.x].map(|share| (400.0 * share) as u32);
    let [row_share, column_share] = [row, column].map(|k| (f64::from(k) + 0.5) / 400.0);
    ([row, column], [column_share - 0.5, 0.5 - row_share])
}

/// Whether the numbers below the views are these, as far as they are written out.
fn reads(nodes: &[Node], uv: [f64; 2], t: f64) -> bool {
    let close = |start: &str, wanted: &[f64]| {
        numbers(nodes, start).is_some_and(|read| {
            read.len() == wanted.len()
                && read.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= 5.01e-5 * b.abs().max(1.0))
        })
    };
    close("(u, v) = ", &uv) && close("t = ", &[t])
}

/// The words beside the pointer, if they are there.
fn beside_the_pointer(nodes: &[Node]) -> Option<&str> {
    let mut texts = nodes.iter().filter(|node| node.role == LABEL && node.name.contains("𝑡 = "));
    texts.next().map(|node| node.name.as_str())
}

pub(crate) fn hover_and_pin() {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let screen = Screen::start();
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    let warm_up = ([0.2, -0.1], 6.0);
    heard.wait("the warm-up", |nodes| reads(nodes, warm_up.0, warm_up.1).then_some(()));
    let view = heard.rect(IMAGE, "Camera view");
    let away = view.left_bottom() + vec2(40.0, 60.0);

    // The wall z = -6 behind a viewport at distance 1, wherever it is looked at.
    let at = (view.min + vec2(0.15, 0.8) * view.size()).floor();
    let ([row, column], uv) = pixel(view, at);
    heard.window.point_at(at);
    let told = heard.wait("the pixel's numbers", |nodes| {
        let told = beside_the_pointer(nodes)?;
        reads(nodes, uv, 6.0).then(|| told.to_owned())
    });
    assert!(told.starts_with(&format!("row {row}, column {column} ")), "{told}");
    assert!(told.ends_with("𝑡 = 6"), "{told}");
    heard.window.point_at(away);
    heard.wait("the warm-up again", |nodes| {
        (reads(nodes, warm_up.0, warm_up.1) && beside_the_pointer(nodes).is_none()).then_some(())
    });

    heard.window.click(at);
    heard.window.point_at(away);
    let nodes = heard.wait("the numbers beside the pointer to go", |nodes| {
        beside_the_pointer(nodes).is_none().then(|| heard.nodes())
    });
    assert!(reads(&nodes, uv, 6.0), "the pixel is pinned: {nodes:#?}");
    assert!(says(&nodes, "hit = plane 2 “back wall”"), "{nodes:#?}");
    // A pointer over another pixel shows that one's, and gives the pinned one back.
    let other = (view.min + vec2(0.85, 0.3) * view.size()).floor();
    heard.window.point_at(other);
    heard.wait("another pixel", |nodes| reads(nodes, pixel(view, other).1, 6.0).then_some(()));
    heard.window.point_at(away);
    heard.wait("the pinned pixel", |nodes| reads(nodes, uv, 6.0).then_some(()));
    heard.window.quit();
}
