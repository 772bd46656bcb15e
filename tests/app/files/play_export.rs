//! Animations as files: what is in them, and what a cancelled one leaves.

use std::fs;

use egui::Color32;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::features::export::order::{FigureSubject, Order};
use pinhole::features::play::state::Kind;
use pinhole::ui::app::App;
use pinhole_figure::export::Figure;
use pinhole_figure::overlay::Style;

use crate::harness::{SIZE, assert_says, export_to, says, texts_with, type_into, window};
use crate::support::Gif;

/// A window that asks how to export so many frames of this animation, `size` dots wide.
fn asked(animation: &str, frames: u32, size: u32) -> Harness<'static, App> {
    let mut window = window("canonical");
    window.get_by_role_and_label(Role::Button, "Play").click();
    window.run();
    window.get_by_role_and_label(Role::Button, animation).click();
    window.run();
    window.get_by_role_and_label(Role::Button, "Export…").click();
    window.run();
    assert_says(&window, "Export the animation");
    window.get_by_role_and_label(Role::RadioButton, "World view").click();
    window.run();
    for (field, number) in [("figure width", size), ("frames", frames)] {
        type_into(&mut window, field, &number.to_string());
    }
    window
}

/// The figure of the world view at a phase of what plays.
fn figure(window: &Harness<'_, App>, kind: Kind, phase: f64, size: u32) -> Figure {
    let app = window.state();
    let (mut document, mut session) = (app.document().clone(), app.session().clone());
    // What the mouse was at is nothing to keep.
    session.live.hovered = None;
    // Nor is the handle under it: where a dialog was, the mouse may be on one.
    session.live.handles.over = None;
    let still = app.player().unwrap().start.at(kind, phase).unwrap();
    still.show(kind, &mut document, &mut session);
    let style = if window.ctx.theme() == egui::Theme::Dark { Style::Dark } else { Style::Light };
    let per_point = window.ctx.pixels_per_point();
    let seen = app.derived().world_view.as_ref().unwrap().image.size;
    let points = seen.map(|n| n as f32 / per_point);
    let scale = (size as f32 / points[0]).min(per_point);
    let size = [size, seen[1] as u32];
    let order = Order { subject: FigureSubject::World, size, scale, style, transparent: false };
    order.figure(&document, &session).unwrap()
}

/// As a file has it.
fn rgb(dot: &Color32) -> [u8; 3] {
    let [r, g, b, _] = dot.to_srgba_unmultiplied();
    [r, g, b]
}

#[test]
fn an_animation_has_the_figures_of_its_phases() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("swing.gif");
    let mut window = asked("Roll: up turns around view", 4, 200);
    export_to(&mut window, &path);
    window.run();
    assert!(!says(&window, "Export the animation") && !says(&window, "Exporting the animation"));
    let gif = Gif::read(&path);
    assert_eq!(gif.repeats, gif::Repeat::Infinite);
    assert_eq!(gif.delays, [5; 4]);
    let figure = |k: u8| figure(&window, Kind::SwingUp, 0.25 * f64::from(k), 200).to_pixels();
    let figures: Vec<Vec<[u8; 3]>> = (0..4).map(|k| figure(k).iter().map(rgb).collect()).collect();
    for (k, frame) in gif.frames.iter().enumerate() {
        let apart: Vec<f64> = figures.iter().map(|f| Gif::difference(frame, f)).collect();
        // A frame has 255 colours.
        assert!(apart[k] < 2.0, "frame {k}: {apart:?}");
        let others = (0..4).filter(|other| *other != k);
        assert!(others.clone().all(|other| apart[other] > 2.0 * apart[k]), "frame {k}: {apart:?}");
    }
}

#[test]
fn a_number_typed_as_soon_as_the_dialog_is_open_is_no_part_of_the_path() {
    let folder = tempfile::tempdir().unwrap();
    let long = folder.path().join(format!("Übung {:094}", 0));
    fs::create_dir(&long).unwrap();
    let scene = long.join("scene.toml");
    fs::write(&scene, "pinhole = 1\n[camera]\neye = [0, 0, 0]\nat = [0, 0, -1]\nup = [0, 1, 0]\n")
        .unwrap();
    let mut window = window(&scene);
    window.get_by_role_and_label(Role::Button, "Play").click();
    window.run();
    window.get_by_role_and_label(Role::Button, "Scan the pixels row by row").click();
    window.run();
    window.get_by_role_and_label(Role::Button, "Export…").click();
    window.run();
    type_into(&mut window, "frames", "2");
    export_to(&mut window, &folder.path().join("first.gif"));
    window.run();
    // The dialog of this export was another one, and smaller.
    window.get_by_role_and_label(Role::Button, "Export…").click();
    window.run();
    let field = window.get_by_role_and_label(Role::TextInput, "path");
    let (path, rect) = (field.value(), field.rect());
    assert_eq!(path.as_deref(), long.join("scan.gif").to_str());
    assert_eq!(rect.center().x, 0.5 * SIZE.x, "however long the folder's name is");
    type_into(&mut window, "frames", "3");
    assert_says(&window, "Export the animation");
    let field = window.get_by_role_and_label(Role::TextInput, "path");
    assert_eq!((field.value(), field.rect()), (path, rect));
    let frames = window.get_by_role_and_label(Role::SpinButton, "frames").value();
    assert_eq!(frames.as_deref(), Some("3"));
    let there = fs::read_dir(&long).unwrap().count();
    assert_eq!(there, 1, "nothing was exported");
}

#[test]
fn cancelled_it_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asked("Orbit the camera around at", 500, 120);
    export_to(&mut window, &folder.path().join("orbit.gif"));
    window.run_steps(5);
    assert_says(&window, "Exporting the animation");
    assert!(!texts_with(&window, " of 500 frames").is_empty());
    window.get_by_role_and_label(Role::Button, "Cancel").click();
    window.run();
    assert!(!says(&window, "Exporting the animation"));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}
