//! Every way in which a window ends without being asked: its unsaved changes are offered at the next start.

use std::fs::{self, File};
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

use crate::reader::{BUTTON, Node, Reader};
use crate::screen::{Running, Screen, signal, wait_for, wait_or_say};
use crate::wayland::Compositor;
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
    for command in ["count from 1", "add sphere"] {
        window.key("ctrl+p");
        window.write(command);
        screen.press("key", "Return");
    }
    wait_for("the change", || window.title().filter(|title| title.contains('*')));
    let changed = Instant::now();
    let written = folder.path().join("pinhole/unsaved/0.toml");
    if matches!(way, Way::KilledMinimised) {
        window.minimise();
    }
    if !matches!(way, Way::AtOnce(_) | Way::Together) {
        wait_for("the changes to be written aside", || written.exists().then_some(()));
        wait_for("the setting to be stored", || {
            let store = Store::at(&folder.path().join("pinhole/state.json"));
            store.load().settings.setup.count_from_one.then_some(())
        });
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

pub(crate) fn with_its_compositor() {
    println!("real window, Wayland's compositor gone");
    let folder = tempfile::tempdir().unwrap();
    let compositor = Compositor::headless();
    // What tells readers of programs itself needs an X display.
    let screen = Screen::start();
    let reader = Reader::start(&screen.bus);
    let scene = built_in(folder.path(), "look-at");
    let said = folder.path().join("said");
    let mut program = compositor
        .program(&screen.bus, &scene, folder.path())
        .stderr(File::create(&said).unwrap())
        .spawn()
        .map(Running)
        .unwrap();
    let press = || {
        let nodes = reader.nodes()?;
        let is_it = |node: &&Node| node.role == BUTTON && node.name == "Canonical camera";
        reader.press(nodes.iter().find(is_it)?)
    };
    wait_or_say("a button, pressed", press, || format!("in {:#?}", reader.nodes()));
    wait_for("the change", || {
        reader.nodes()?.iter().any(|node| node.name == "scene.toml*").then_some(())
    });
    signal(&compositor.process, "KILL");
    let status = wait_for("the program to end", || program.0.try_wait().unwrap());
    let said = fs::read_to_string(said).unwrap();
    assert_eq!(status.code(), Some(1), "{said}");
    let reason =
        "error: the window can no longer be drawn: the connection to the display was lost\n";
    assert!(said.contains(reason) && !said.contains("fault"), "{said}");
    let mut next = next_start(folder.path(), &scene);
    next.get_by_label("Restore").click();
    next.run();
    let before = scene_file::load(&scene).unwrap();
    assert!(next.state().document().camera != before.camera);
}

/// The next window, in memory.
fn next_start(state: &Path, scene: &Path) -> Harness<'static, App> {
    let source = SceneSource::File(scene.to_owned());
    let open = OpenDocument::open(source).unwrap();
    let store = Store::at(&state.join("pinhole/state.json"));
    let mut next = Harness::builder()
        .with_max_steps(30)
        .with_context_setup(|ctx| App::set_up(ctx, &Default::default()))
        .build_ui_state(whole_window::show, App::new(open, Remembered::default(), Some(store)));
    next.run();
    next
}
