//! The camera taken in the hand by the mouse, taken back, presented and exported. Each is judged by
//! what it leaves behind: the saved scene, the exported file, what the next run remembers.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::kittest::Queryable as _;
use pinhole::model::store::Store;
use pinhole_core::Orientation;
use pinhole_exchange::document::Document;
use pinhole_exchange::scene_file;

use crate::memory::InMemory;
use crate::screen::{SIZE, Screen, wait_for};
use crate::window::{Setting, Window, built_in};

/// The scene as Ctrl+S has written it over one that was other.
pub(crate) fn saved(window: &Window, scene: &Path, other_than: &Document) -> Document {
    window.key("ctrl+s");
    wait_for("the saved file", || {
        let saved = scene_file::load(scene).ok()?;
        (saved != *other_than).then_some(saved)
    })
}

/// Drags a handle, found by its name in the same window in memory, and saves.
fn drag(
    (window, memory): (&Window, &mut InMemory),
    handle: &str,
    by: Vec2,
    scene: &Path,
    before: &Document,
) -> Document {
    let at = memory.position(Role::Slider, handle, vec2(0.5, 0.5));
    window.drag(at, by);
    memory.drag(at, by);
    let saved = saved(window, scene, before);
    let expected = memory.0.state().document();
    assert_eq!(saved, *expected, "{handle}: by mouse as in memory");
    saved
}

/// Exports what the layout shows first; the picture's size.
fn exported(window: &Window, path: &Path) -> [u32; 2] {
    window.key("ctrl+e");
    window.key("ctrl+a");
    window.write(path.to_str().unwrap());
    window.key("Return");
    wait_for("the exported figure", || {
        let reader = png::Decoder::new(BufReader::new(File::open(path).ok()?)).read_info().ok()?;
        let info = reader.info();
        Some([info.width, info.height])
    })
}

/// How large the world view is in memory, in dots.
fn world_view(memory: &InMemory) -> Vec2 {
    memory.0.get_by_role_and_label(Role::Image, "World view").rect().size()
}

pub(crate) fn drive(setting: &Setting) {
    println!("real window, {}", setting.name);
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let before = scene_file::load(&scene).unwrap();
    let screen = Screen::start();
    let mut window = Window::open(&screen, &[scene.as_os_str()], folder.path(), setting);
    sleep(Duration::from_secs(2));
    let mut memory = InMemory::like(&window, &scene);

    let moved = drag((&window, &mut memory), "eye handle", vec2(36.0, -22.0), &scene, &before);
    let at = |document: &Document| match document.camera.orientation {
        Orientation::At { at, .. } => at,
        _ => panic!("not given by at: {:?}", document.camera),
    };
    assert!(moved.camera.eye.distance(before.camera.eye) > 0.05, "{:?}", moved.camera);
    assert_eq!((at(&moved), moved.camera.up()), (at(&before), before.camera.up()));

    let rolled = drag((&window, &mut memory), "up handle", vec2(40.0, 24.0), &scene, &moved);
    assert_eq!((rolled.camera.eye, at(&rolled)), (moved.camera.eye, at(&moved)));
    let [old, new] = [&moved, &rolled].map(|document| document.camera.basis().unwrap());
    assert!(old.w.distance(new.w) < 1e-12 && old.v.angle_between(new.v) > 0.1, "{old:?} {new:?}");

    window.key("ctrl+z");
    assert_eq!(saved(&window, &scene, &rolled), moved);
    window.key("ctrl+z");
    assert_eq!(saved(&window, &scene, &moved), before);

    // While presenting, the world view without numbers fills the screen, not the window alone, and a
    // figure is as large as it is seen.
    window.key("F5");
    window.key("2");
    window.key("n");
    let presented = exported(&window, &folder.path().join("presented.png"));
    let shares = [0, 1].map(|k| presented[k] as f32 / SIZE[k] as f32);
    assert!(shares.iter().all(|share| (0.95..=1.0).contains(share)), "{presented:?} of {SIZE:?}");
    window.key("n");
    window.key("F5");
    sleep(Duration::from_millis(500));
    let shown = world_view(&memory);
    let as_before = exported(&window, &folder.path().join("world.png"));
    assert_eq!(as_before.map(|dots| dots as f32), <[f32; 2]>::from(shown), "the window is back");

    window.quit();
    assert_eq!(scene_file::load(&scene).unwrap(), before);
    let remembered = Store::at(&folder.path().join("pinhole/state.json")).load();
    let layout = memory.0.state().session().shown.setup.layout;
    assert_eq!(remembered.settings.setup.layout, layout, "presenting leaves no trace");
    assert!(remembered.renderer.starts_with(setting.drawn_by), "{}", remembered.renderer);
}
