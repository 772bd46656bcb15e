//! Sharing what the window shows as a link, and opening links.

use std::fs;

use egui::accesskit::Role;
use egui::{Event, Key};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use pinhole::model::ViewLayout;
use pinhole::model::lessons::{StepId, Which};
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_core::{DVec2, Selection};
use pinhole_exchange::{Document, scene_file};
use pinhole_figure::export::QrCode;

use super::scene_files::drop_file;
use crate::app::presenter::{press, resize};
use crate::harness::{
    assert_says, command, copied_text, says, show, type_into, unfolded, window, window_with,
};

fn paste(window: &mut Harness<'_, App>, text: &str) {
    window.event(Event::Paste(text.to_owned()));
    window.run();
}

fn click(window: &mut Harness<'_, App>, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run();
}

/// Opens the dialog, copies the link and returns it.
fn shared(window: &mut Harness<'_, App>) -> String {
    press(window, Key::Q);
    assert_says(window, "The address must stand before the link. Without it there is no QR code.");
    window.get_by_role_and_label(Role::Button, "Copy link").click();
    copied_text(window)
}

fn type_address(window: &mut Harness<'_, App>, address: &str) {
    let name = "address of the page";
    window.get_by_role_and_label(Role::TextInput, name).focus();
    window.run();
    window.get_by_role_and_label(Role::TextInput, name).type_text(address);
    window.run();
}

fn step(window: &Harness<'_, App>) -> Option<StepId> {
    window.state().lesson().map(|open| open.id())
}

const STEP: StepId = StepId { lesson: Which::Builtin(6), step: 2 };

#[test]
fn a_copied_link_opens_the_same_scene_ray_and_page() {
    let mut from = window("canonical");
    type_into(&mut from, "eye x", "sqrt(2)/10");
    type_into(&mut from, "uv u", "0.125");
    show(&mut from, ViewLayout::Plot);
    let link = shared(&mut from);
    assert!(link.starts_with("pinhole.html#v1/Z") && link.len() < 400, "{link}");
    let mut to = window("look-at");
    paste(&mut to, &format!("\n{link} "));
    assert_eq!(to.state().document(), from.state().document());
    assert_eq!(to.state().session().shown.selection, from.state().session().shown.selection);
    assert_eq!(to.state().session().shown.selection, Selection::Uv(DVec2::new(0.125, -0.1)));
    assert_eq!(to.state().session().shown.setup.layout, ViewLayout::Plot);
    assert_says(&to, "Scene of a link");
}

#[test]
fn a_step_is_shared_by_its_number_until_its_scene_is_changed() {
    let mut window = window("canonical");
    paste(&mut window, "https://example.org/pinhole.html#7.3");
    assert_eq!(step(&window), Some(STEP));
    assert_eq!(shared(&mut window), "pinhole.html#7.3");
    let document = window.state().document().clone();
    press(&mut window, Key::PageDown);
    paste(&mut window, "#7.3");
    assert_eq!((step(&window), window.state().document()), (Some(STEP), &document));
}

#[test]
fn unsaved_changes_are_asked_about() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "0.25");
    paste(&mut window, "#7.3");
    assert_says(&window, "Save the changes to canonical?");
    click(&mut window, "Cancel");
    assert_eq!((step(&window), window.state().document().camera.eye.x), (None, 0.25));
    paste(&mut window, "#7.3");
    click(&mut window, "Discard");
    assert_eq!(step(&window), Some(STEP));
}

#[test]
fn a_wrong_link_says_why_and_loses_nothing() {
    let mut window = window("canonical");
    type_into(&mut window, "eye x", "0.25");
    let broken = [
        ("#v1/look-at/0", "link:1:13: cut off: copy it again as a whole"),
        ("#14", "link: there is no lesson 14: there are lessons 1 to 13"),
        (
            "#v3/look-at/12345678",
            "link:1:2: of version 3, and this program reads version 1: a newer Pinhole opens it",
        ),
    ];
    for (link, why) in broken {
        paste(&mut window, link);
        assert_says(&window, "This link cannot be opened");
        assert_says(&window, why);
        click(&mut window, "Close");
        assert_eq!(window.state().document().camera.eye.x, 0.25);
    }
}

#[test]
fn a_dropped_shortcut_or_text_opens_the_link_in_it() {
    let folder = tempfile::tempdir().unwrap();
    let shortcut = folder.path().join("step.url");
    fs::write(&shortcut, "[InternetShortcut]\r\nURL=https://a.b/pinhole.html#7.3\r\n").unwrap();
    let text = folder.path().join("step.txt");
    fs::write(&text, "https://a.b/pinhole.html#7.3\n").unwrap();
    for file in [shortcut, text] {
        let mut window = window("canonical");
        drop_file(&mut window, &file);
        assert_eq!(step(&window), Some(STEP), "{}", file.display());
    }
}

#[test]
fn a_scene_with_a_table_has_no_link() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("many.csv"), "x,y,z,r\n0,0,-5,1\n").unwrap();
    let scene = scene_file::to_text(&Document::default(), None);
    let path = folder.path().join("many.toml");
    fs::write(&path, scene.replace("[camera]", "spheres = \"many.csv\"\n[camera]")).unwrap();
    let mut window = window(&path);
    command(&mut window, "File: Share…");
    assert_says(&window, "This scene has no link");
    assert_says(
        &window,
        "link: the scene's spheres are in many.csv, which a link cannot have: write them into the \
         scene, or save it as a page",
    );
}

/// The code that is drawn is compared module by module with the code of the link.
#[track_caller]
fn assert_drawn(window: &mut Harness<'_, App>, url: &str) {
    let node = window.get_by_label("QR code");
    assert_eq!(node.accesskit_node().description().as_deref(), Some(url));
    let (rect, scale) = (node.rect(), window.ctx.pixels_per_point());
    let picture = window.render().unwrap();
    let code = QrCode::of(url).unwrap().image(1);
    let side = code.size[0];
    for (k, expected) in code.pixels.iter().enumerate() {
        let part = |k: usize| (k as f32 + 0.5) / side as f32;
        let at = scale * rect.lerp_inside(egui::vec2(part(k % side), part(k / side)));
        let [r, g, b, _] = picture.get_pixel(at.x as u32, at.y as u32).0;
        assert_eq!([r, g, b], [expected.r(), expected.g(), expected.b()], "module {k} of {side}");
    }
}

#[test]
fn with_an_address_the_dialog_draws_the_code_and_the_next_run_knows_it() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let mut window = window_with("canonical", Remembered::default(), Some(store.clone()));
    press(&mut window, Key::Q);
    type_address(&mut window, "example.org/p.html");
    assert!(!says(
        &window,
        "The address must stand before the link. Without it there is no QR code."
    ));
    let url = window.get_by_label("QR code").accesskit_node().description().unwrap();
    assert!(url.starts_with("https://example.org/p.html#v1/canonical/"), "{url}");
    assert_drawn(&mut window, &url);
    click(&mut window, "Close");
    window.state_mut().on_exit();
    assert_eq!(store.load().address, "example.org/p.html");
}

#[test]
fn while_presenting_the_code_fills_the_figure_and_the_step_goes_on() {
    let address = "https://example.org/pinhole.html".to_owned();
    let remembered = Remembered { address, settings: unfolded(), ..Remembered::default() };
    let mut window = window_with("canonical", remembered, None);
    paste(&mut window, "#7.3");
    press(&mut window, Key::F5);
    for pixels in [[1024.0, 768.0], [1920.0, 1080.0]] {
        resize(&mut window, pixels);
        press(&mut window, Key::Q);
        let url = "https://example.org/pinhole.html#7.3";
        assert_drawn(&mut window, url);
        assert_says(&window, url);
        let code = window.get_by_label("QR code").rect();
        let content = window.ctx.content_rect();
        // As much of the figure as its shorter side has beside the words.
        let least = (0.58 * content.width()).min(content.height());
        assert!(code.width() > 0.8 * least, "{code} in {content}");
        press(&mut window, Key::Q);
        assert!(!says(&window, "QR code"));
    }
    press(&mut window, Key::Q);
    let before = window.state().session().shown.clone();
    press(&mut window, Key::PageDown);
    assert!(says(&window, "QR code"));
    assert!(step(&window) != Some(STEP) || before != window.state().session().shown);
    press(&mut window, Key::Escape);
    assert!(!says(&window, "QR code"));
    assert!(window.state().session().presenting.is_some());
    press(&mut window, Key::Q);
    press(&mut window, Key::F5);
    assert!(!says(&window, "QR code"), "it belongs to presenting");
}

#[test]
fn what_is_no_address_has_no_code() {
    let mut window = window("canonical");
    press(&mut window, Key::Q);
    type_address(&mut window, "not a url");
    assert_says(&window, "This is not the address of a page. It begins with https://");
}
