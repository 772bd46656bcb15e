//! Exporting a figure from the window, and the derivation to the clipboard.

use std::collections::HashSet;
use std::fs;

use egui::accesskit::Role;
use egui::{Color32, Key, Modifiers, OutputCommand};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::features::export::order::{FigureSubject, Order};
use pinhole::model::session::ViewLayout;
use pinhole::ui::app::App;
use pinhole_figure::export::FigureFormat;
use pinhole_figure::overlay::Style;

use crate::harness::{
    assert_says, copied_text, export_to, says, show, texts_with, type_into, window,
};

fn open_dialog(window: &mut Harness<'_, App>) {
    window.key_press_modifiers(Modifiers::COMMAND, Key::E);
    window.run();
    assert_says(window, "Export a figure");
}

/// What the window draws is what is in the file: the same dots.
#[test]
fn the_world_view_as_it_is_on_the_screen() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("world.png");
    let mut window = window("look-at");
    open_dialog(&mut window);
    export_to(&mut window, &path);
    window.run();
    assert!(!says(&window, "Export a figure"), "the dialog is closed");
    let (app, scale) = (window.state(), window.ctx.pixels_per_point());
    let shown = app.derived().world_view.clone().unwrap();
    let size = shown.image.size.map(|n| n as u32);
    let style = if window.ctx.theme() == egui::Theme::Dark { Style::Dark } else { Style::Light };
    let order = Order { subject: FigureSubject::World, size, scale, style, transparent: false };
    let figure = order.figure(app.document(), app.session()).unwrap();
    assert!(figure.to_file(FigureFormat::Png).unwrap() == fs::read(&path).unwrap());
    // But for the letters, which are painted over it, the dots are the window's.
    let pixels = figure.to_pixels();
    let same = pixels.iter().zip(&shown.image.pixels).filter(|(a, b)| a == b).count();
    assert!(same * 100 > pixels.len() * 98, "{same} of {}", pixels.len());
}

#[test]
fn the_camera_view_keeps_its_proportions() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("camera.svg");
    let mut window = window("canonical");
    open_dialog(&mut window);
    window.get_by_role_and_label(Role::RadioButton, "Camera view").click();
    window.run();
    type_into(&mut window, "figure width", "640");
    window.get_by_label("transparent").click();
    window.run();
    export_to(&mut window, &path);
    window.run();
    let svg = fs::read_to_string(&path).unwrap();
    assert!(svg.contains("width=\"640\" height=\"640\""), "{}", &svg[..300]);
    assert!(!svg.contains("<rect "), "transparent");
}

/// As a hand clicks: pressed in one frame, let go in another.
#[test]
fn the_first_number_that_is_typed_counts() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("world.svg");
    let mut window = window("canonical");
    open_dialog(&mut window);
    let field = window.get_by_role_and_label(Role::SpinButton, "figure width").rect().center();
    crate::harness::click_at(&mut window, field);
    for digit in ["3", "2", "1"] {
        window.event(egui::Event::Text(digit.to_owned()));
        window.run();
    }
    window.key_press(Key::Enter);
    window.run();
    assert_says(&window, "Export a figure");
    export_to(&mut window, &path);
    window.run();
    let svg = fs::read_to_string(&path).unwrap();
    assert!(svg.contains("width=\"321\""), "{}", &svg[..300]);
}

#[test]
fn the_layout_chooses_what_is_exported_first() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window("canonical");
    for (layout, file) in
        [(ViewLayout::Derivation, "derivation.pdf"), (ViewLayout::Lines, "lines.pdf")]
    {
        show(&mut window, layout);
        open_dialog(&mut window);
        let path = folder.path().join(file);
        export_to(&mut window, &path);
        window.run();
        assert!(fs::read(&path).unwrap().starts_with(b"%PDF-"), "{file}");
    }
}

#[test]
fn another_format_is_refused_and_an_existing_file_asked_about() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window("canonical");
    open_dialog(&mut window);
    export_to(&mut window, &folder.path().join("world.jpg"));
    window.run();
    assert!(!texts_with(&window, "Export writes SVG, PDF or PNG: not ").is_empty());
    let path = folder.path().join("there.svg");
    fs::write(&path, "mine").unwrap();
    export_to(&mut window, &path);
    window.run();
    assert!(!texts_with(&window, "exists. Export once more to replace it.").is_empty());
    assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
    window.get_by_role_and_label(Role::Button, "Export").click();
    window.run();
    assert!(fs::read_to_string(&path).unwrap().starts_with("<svg "));
}

#[test]
fn a_folder_that_is_not_there_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window("canonical");
    open_dialog(&mut window);
    export_to(&mut window, &folder.path().join("no").join("world.svg"));
    window.run();
    assert_says(&window, "The figure was not exported");
}

#[test]
fn the_layouts_figure_is_copied_as_a_picture() {
    let mut window = window("look-at");
    let shown = window.get_by_role_and_label(Role::Image, "World view").rect().size();
    window.get_by_label("File").click();
    window.run();
    window.get_by_label_contains("Copy the figure").click();
    let mut copied = None;
    for _ in 0..6 {
        window.step();
        for command in &window.output().platform_output.commands {
            if let OutputCommand::CopyImage(image) = command {
                copied = Some(image.clone());
            }
        }
    }
    assert_says(&window, "The figure is on the clipboard");
    let image = copied.expect("a picture on the clipboard");
    assert_eq!(image.size, [shown.x, shown.y].map(|points| points.round() as usize));
    let colors: HashSet<Color32> = image.pixels.iter().copied().collect();
    assert!(colors.len() > 100 && colors.iter().all(|color| color.is_opaque()), "{}", colors.len());
}

#[test]
fn the_derivation_is_copied_as_latex_and_as_markdown() {
    for (name, part) in [("LaTeX", r"\begin{align*}"), ("Markdown", "### Basis")] {
        let mut window = window("canonical");
        show(&mut window, ViewLayout::Derivation);
        window.get_by_label("File").click();
        window.run();
        window.get_by_label_contains(&format!("Copy the derivation as {name}")).click();
        let copied = copied_text(&mut window);
        assert!(copied.contains(part) && copied.contains(r"\mathbf{w}"), "{name}: {copied}");
    }
}
