//! Animations as files: what is in them, and what a cancelled one leaves.

use std::fs::{self, File};
use std::io::BufReader;

use egui::Color32;
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::figures::{Figure, Format, Look, View, of_view};
use pinhole::model::play::Kind;
use pinhole::ui::app::App;
use pinhole::view::overlay::Style;
use pinhole_core::ImageSize;

use crate::harness::{SIZE, assert_says, export_to, says, texts_with, type_into, window};

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
    session.hovered = None;
    // Nor is the handle under it: where a dialog was, the mouse may be on one.
    session.handles.over = None;
    let still = app.player().unwrap().start.at(kind, phase).unwrap();
    still.show(kind, &mut document, &mut session);
    let style = if window.ctx.theme() == egui::Theme::Dark { Style::Dark } else { Style::Light };
    let per_point = window.ctx.pixels_per_point();
    let seen = app.derived().world_view.as_ref().unwrap().image.size;
    let points = seen.map(|n| n as f32 / per_point);
    let scale = (size as f32 / points[0]).min(per_point);
    let look = Look { scale, style, transparent: false };
    let size = ImageSize::new(size, seen[1] as u32).unwrap();
    of_view(&document, &session, View::World, size, look).unwrap()
}

/// As a file has it.
fn rgb(dot: &Color32) -> [u8; 3] {
    let [r, g, b, _] = dot.to_srgba_unmultiplied();
    [r, g, b]
}

#[test]
fn an_animated_png_has_the_figures_of_its_phases() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("swing.png");
    let mut window = asked("Roll: up turns around view", 4, 200);
    export_to(&mut window, &path);
    window.run();
    assert!(!says(&window, "Export the animation") && !says(&window, "Exporting the animation"));
    let decoder = png::Decoder::new(BufReader::new(File::open(&path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let control = *reader.info().animation_control().unwrap();
    assert_eq!((control.num_frames, control.num_plays), (4, 0), "it is repeated for ever");
    let delay = *reader.info().frame_control().unwrap();
    assert_eq!((delay.delay_num, delay.delay_den), (1, 20));
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    for k in 0..4 {
        reader.next_frame(&mut bytes).unwrap();
        let figure = figure(&window, Kind::SwingUp, 0.25 * f64::from(k), 200);
        let pixels: Vec<u8> = figure.to_pixels().iter().flat_map(rgb).collect();
        let same = bytes.iter().zip(&pixels).filter(|(a, b)| a == b).count();
        assert!(bytes == pixels, "frame {k}: {same} of {} and {}", bytes.len(), pixels.len());
    }
    assert!(reader.next_frame(&mut bytes).is_err(), "no more");
}

#[test]
fn numbered_pngs_are_the_figures_of_their_phases() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = asked("Scan the pixels row by row", 3, 160);
    window.get_by_label("numbered PNGs").click();
    window.run();
    export_to(&mut window, &folder.path().join("scan.png"));
    window.run();
    let mut names: Vec<String> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["scan-0001.png", "scan-0002.png", "scan-0003.png"]);
    for (name, phase) in names.iter().zip([0.0, 0.5, 1.0]) {
        let figure = figure(&window, Kind::Scan, phase, 160);
        let written = fs::read(folder.path().join(name)).unwrap();
        assert!(figure.to_file(Format::Png).unwrap() == written, "{name}");
    }
    // None of them is written over.
    window.get_by_role_and_label(Role::Button, "Export…").click();
    window.run();
    type_into(&mut window, "frames", "2");
    window.get_by_label("numbered PNGs").click();
    window.run();
    export_to(&mut window, &folder.path().join("scan.png"));
    window.run();
    assert!(!texts_with(&window, "scan-0001.png exists").is_empty());
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
    export_to(&mut window, &folder.path().join("first.png"));
    window.run();
    // The dialog of this export was another one, and smaller.
    window.get_by_role_and_label(Role::Button, "Export…").click();
    window.run();
    let field = window.get_by_role_and_label(Role::TextInput, "path");
    let (path, rect) = (field.value(), field.rect());
    assert_eq!(path.as_deref(), long.join("scan.png").to_str());
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
    for numbered in [false, true] {
        let folder = tempfile::tempdir().unwrap();
        let mut window = asked("Orbit the camera around at", 500, 120);
        if numbered {
            window.get_by_label("numbered PNGs").click();
            window.run();
        }
        export_to(&mut window, &folder.path().join("orbit.png"));
        window.run_steps(5);
        assert_says(&window, "Exporting the animation");
        assert!(!texts_with(&window, " of 500 frames").is_empty());
        assert!(fs::read_dir(folder.path()).unwrap().count() > 0, "it is being written");
        window.get_by_role_and_label(Role::Button, "Cancel").click();
        window.run();
        assert!(!says(&window, "Exporting the animation"));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
