//! Every way in which a window ends without being asked: its unsaved changes are offered at the next start.

use std::os::unix::process::ExitStatusExt as _;
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use pinhole::model::files::OpenDocument;
use pinhole::model::store::{Remembered, Store};
use pinhole::ui::app::App;
use pinhole_exchange::scene_file;
use pinhole_exchange::scenes::SceneSource;

use crate::screen::{Screen, wait_for};
use crate::whole_window;
use crate::window::{NO_DRIVER, Setting, Window, built_in};

/// No way of dying may cost more work than that of this time.
const MOST: Duration = Duration::from_secs(5);

#[derive(Clone, Copy, Debug)]
enum Way {
    /// The signal comes as soon as the change is on the screen.
    AtOnce(&'static str),
    /// Two signals come at once, as when a session ends.
    Together,
    /// It is killed when the change has been written aside.
    Killed,
    /// The same, while it is minimised since a moment after the change.
    KilledMinimised,
    XKillClient,
    XServerGone,
}

pub(crate) fn in_every_way() {
    for way in [
        Way::AtOnce("TERM"),
        Way::AtOnce("HUP"),
        Way::Together,
        Way::Killed,
        Way::KilledMinimised,
        Way::XKillClient,
        Way::XServerGone,
    ] {
        println!("real window, {way:?}");
        let screen = Screen::start();
        die(&screen, way);
    }
}

fn die(screen: &Screen, way: Way) {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "look-at");
    let setting =
        Setting { name: "dying", arguments: &[], environment: NO_DRIVER, drawn_by: "cpu (" };
    let mut window = Window::open(screen, &[scene.as_os_str()], folder.path(), &setting);
    sleep(Duration::from_secs(1));
    window.key("ctrl+p");
    window.write("add sphere");
    screen.press("key", "Return");
    wait_for("the change", || window.title().filter(|title| title.contains('*')));
    let changed = Instant::now();
    let written = folder.path().join("pinhole/unsaved/0.toml");
    if matches!(way, Way::KilledMinimised) {
        window.minimise();
    }
    if !matches!(way, Way::AtOnce(_) | Way::Together) {
        wait_for("the changes to be written aside", || written.exists().then_some(()));
        assert!(changed.elapsed() < MOST, "{:?}", changed.elapsed());
    }
    match way {
        Way::AtOnce(signal) => window.signal(signal),
        Way::Together => ["TERM", "HUP"].into_iter().for_each(|signal| window.signal(signal)),
        Way::Killed | Way::KilledMinimised => window.signal("KILL"),
        Way::XKillClient => window.kill_client(),
        Way::XServerGone => screen.kill_server(),
    }
    let status = window.wait();
    if let Way::AtOnce(signal) = way {
        assert_eq!(status.signal(), Some(if signal == "HUP" { 1 } else { 15 }), "as by {signal}");
    }
    let document = scene_file::load(&scene).unwrap();
    let mut next = next_start(folder.path(), &scene);
    next.get_by_label("Restore the unsaved changes to scene.toml?");
    next.get_by_label("Restore").click();
    next.run();
    let restored = next.state().document();
    assert_eq!(restored.spheres.len(), document.spheres.len() + 1);
}

/// The next window, in memory.
fn next_start(state: &Path, scene: &Path) -> Harness<'static, App> {
    let source = SceneSource::File(scene.to_owned());
    let open = OpenDocument::new(source.load().unwrap(), source);
    let store = Store::at(&state.join("pinhole/state.json"));
    let mut next = Harness::builder()
        .with_max_steps(30)
        .with_context_setup(|ctx| App::set_up(ctx, &Default::default()))
        .build_ui_state(whole_window::show, App::new(open, Remembered::default(), Some(store)));
    next.run();
    next
}
