//! A fault of the program itself in the middle of a frame.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::files::OpenDocument;
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_exchange::scene_file;
use pinhole_exchange::scenes::{BuiltinScene, SceneSource};

use super::harness::{assert_says, copied_text, says, texts_with, type_into, unfolded};
use crate::support::{self, whole_window};

const HEADING: &str = "Pinhole ran into an internal error";

/// A window in which the next frame that asks for another one panics, once it is told to.
fn window(store: &Store, panics: &Arc<AtomicBool>) -> Harness<'static, App> {
    let source = SceneSource::Builtin(BuiltinScene::find("look-at").unwrap());
    let settings = unfolded();
    let remembered = Remembered { settings, ..Remembered::default() };
    let open = OpenDocument::open(source).unwrap();
    let app = App::new(open, remembered, Some(store.clone()));
    let is_frame = Arc::new(AtomicBool::new(false));
    let (panics, is_inside) = (Arc::clone(panics), Arc::clone(&is_frame));
    let mut window = support::harness()
        .with_size(super::harness::SIZE)
        .with_max_steps(120)
        // An edit asks for the frame in which it is written aside, a second later.
        .with_step_dt(1.0 / 60.0)
        .with_context_setup(move |ctx| {
            App::set_up(ctx, &settings);
            ctx.set_request_repaint_callback(move |_| {
                if is_inside.load(Ordering::SeqCst) && panics.swap(false, Ordering::SeqCst) {
                    panic!("a planted fault");
                }
            });
        })
        .build_ui_state(
            move |ui, app| {
                is_frame.store(true, Ordering::SeqCst);
                whole_window::show(ui, app);
                is_frame.store(false, Ordering::SeqCst);
            },
            app,
        );
    window.run();
    window
}

fn press(window: &mut Harness<'_, App>, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run();
}

#[test]
fn the_scene_is_kept_the_reason_is_shown_and_the_window_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    let panics = Arc::new(AtomicBool::new(false));
    let mut window = window(&store, &panics);
    type_into(&mut window, "eye x", "0.375");
    let spheres = window.state().document().spheres.len();
    panics.store(true, Ordering::SeqCst);
    press(&mut window, "+ Sphere");
    assert_says(&window, HEADING);
    assert!(!texts_with(&window, "a planted fault").is_empty());
    assert!(!says(&window, "eye x"));
    let kept = window.state().document().clone();
    assert_eq!((kept.camera.eye.x, kept.spheres.len()), (0.375, spheres + 1));
    // The change that met the fault is written aside, too.
    let aside = || scene_file::load(&store.unsaved().join("0.toml")).ok();
    let is_there = || aside().is_some_and(|aside| aside.spheres.len() == spheres + 1);
    let start = Instant::now();
    while !is_there() && start.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(is_there());

    window.get_by_role_and_label(Role::Button, "Copy a report").click();
    let copied = copied_text(&mut window);
    assert!(copied.contains("a planted fault") && copied.contains("eye = [0.375"), "{copied}");

    press(&mut window, "Go on");
    assert!(!says(&window, HEADING));
    assert_eq!(*window.state().document(), kept);
    type_into(&mut window, "eye y", "2");
    assert_eq!(window.state().document().camera.eye.y, 2.0);

    panics.store(true, Ordering::SeqCst);
    press(&mut window, "+ Sphere");
    press(&mut window, "Undo and go on");
    assert_eq!(window.state().document().spheres.len(), spheres + 1);
    assert_eq!(window.state().document().camera.eye.y, 2.0);
}
