//! What a window remembers, whichever windows are open besides it and however it ends.

use std::time::{Duration, Instant};

use egui_kittest::Harness;
use pinhole::model::session::ViewLayout;
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;

use crate::harness::{command, show, window_with};

fn opened(store: &Store) -> Harness<'static, App> {
    window_with("canonical", store.load(), Some(store.clone()))
}

fn store() -> (tempfile::TempDir, Store) {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.json"));
    (folder, store)
}

/// Lets a window's time pass until this is stored, at most the time that may pass until it is.
fn wait(window: &mut Harness<'_, App>, store: &Store, is_stored: impl Fn(&Remembered) -> bool) {
    let begin = window.ctx.input(|i| i.time);
    while window.ctx.input(|i| i.time) < begin + 2.0 {
        window.step();
    }
    let begin = Instant::now();
    while !is_stored(&store.load()) {
        assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", store.load());
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_window_that_is_killed_has_stored_its_settings() {
    let (_folder, store) = store();
    let mut window = opened(&store);
    command(&mut window, "Count from 1");
    wait(&mut window, &store, |state| state.settings.setup.count_from_one);
    show(&mut window, ViewLayout::Plot);
    wait(&mut window, &store, |state| state.settings.setup.layout == ViewLayout::Plot);
    // Nothing is written, and no frame asked for, while nothing changes.
    let stamp = || std::fs::metadata(store.unsaved().with_file_name("state.json")).unwrap();
    let before = stamp().modified().unwrap();
    wait(&mut window, &store, |_| true);
    assert_eq!(stamp().modified().unwrap(), before);
    assert!(
        window.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay
            > Duration::from_secs(60)
    );
    // A killed one calls nothing.
    std::mem::forget(window);
    assert!(opened(&store).state().session().shown.setup.count_from_one);
}

#[test]
fn a_window_that_is_hidden_stores_its_settings_at_once() {
    let (_folder, store) = store();
    let mut window = opened(&store);
    command(&mut window, "Count from 1");
    window.state_mut().rest();
    drop(window);
    assert!(store.load().settings.setup.count_from_one);
}

#[test]
fn the_window_that_ends_last_keeps_what_the_others_have_changed() {
    let (_folder, store) = store();
    let (mut first, mut second) = (opened(&store), opened(&store));
    command(&mut first, "Count from 1");
    first.state_mut().on_exit();
    show(&mut second, ViewLayout::Plot);
    second.state_mut().on_exit();
    let settings = store.load().settings;
    assert_eq!((settings.setup.count_from_one, settings.setup.layout), (true, ViewLayout::Plot));
}
