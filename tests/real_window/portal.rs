//! The desktop's file dialog: a portal on the screen's bus, which answers as told, and the window that
//! asks it.

use std::collections::{HashMap, VecDeque};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::thread::sleep;
use std::time::Duration;

use pinhole_exchange::scene_file;
use pinhole_exchange::scenes::BuiltinScene;
use pollster::block_on;
use zbus::connection::Builder;
use zbus::fdo::{self, DBusProxy};
use zbus::message::Header;
use zbus::names::{OwnedUniqueName, UniqueName};
use zbus::zvariant::{OwnedObjectPath, OwnedValue, Value};
use zbus::{Connection, interface};

use crate::bus::Bus;
use crate::hearing::{Heard, says};
use crate::reader::BUTTON;
use crate::screen::{Screen, wait_for};
use crate::window::built_in;

const LET_GO: Duration = Duration::from_millis(500);

/// The path of a question on the bus, and its interface.
const HANDLE: &str = "/org/freedesktop/portal/desktop/request/1_1/a";
const REQUEST: &str = "org.freedesktop.portal.Request";

/// What the window says meanwhile.
const WAITS: &str = "Choose the file in the dialog of your desktop.";

/// What the user does with the dialog, or the portal instead.
enum Reply {
    Choose(PathBuf),
    ChooseUri(&'static str),
    Cancel,
    /// The dialog stays open.
    Nothing,
    /// The portal cannot open one, and says so at once.
    End,
    Error,
}

/// A dialog that was asked for.
#[derive(Clone)]
struct Request {
    method: &'static str,
    parent: String,
    title: String,
    options: HashMap<String, OwnedValue>,
    sender: OwnedUniqueName,
}

impl Request {
    fn folder(&self) -> PathBuf {
        let bytes: Vec<u8> = self.option("current_folder");
        String::from_utf8(bytes).unwrap().trim_end_matches('\0').into()
    }

    fn option<T: TryFrom<OwnedValue, Error: std::fmt::Debug>>(&self, name: &str) -> T {
        self.options[name].try_clone().unwrap().try_into().unwrap()
    }
}

#[derive(Default)]
struct Told {
    replies: VecDeque<Reply>,
    requests: Vec<Request>,
}

struct FileChooser(Arc<Mutex<Told>>);

impl FileChooser {
    async fn answer(
        &self,
        connection: &Connection,
        request: Request,
    ) -> fdo::Result<OwnedObjectPath> {
        let sender = request.sender.clone();
        let reply = {
            let mut told = self.0.lock().unwrap();
            told.requests.push(request);
            told.replies.pop_front().unwrap()
        };
        match reply {
            Reply::Error => return Err(fdo::Error::Failed("no backend".to_owned())),
            reply => respond(connection, sender, reply).await?,
        }
        Ok(HANDLE.try_into().unwrap())
    }
}

/// Sends the response to whoever asked, if there is one.
async fn respond(connection: &Connection, to: OwnedUniqueName, reply: Reply) -> zbus::Result<()> {
    let (code, uris) = match reply {
        Reply::Choose(path) => (0, vec![uri(&path)]),
        Reply::ChooseUri(uri) => (0, vec![uri.to_owned()]),
        Reply::Cancel => (1, Vec::new()),
        Reply::End => (2, Vec::new()),
        Reply::Nothing | Reply::Error => return Ok(()),
    };
    let body = (code as u32, HashMap::from([("uris", Value::from(uris))]));
    connection.emit_signal(Some(to), HANDLE, REQUEST, "Response", &body).await
}

fn uri(path: &Path) -> String {
    let bytes = path.to_str().unwrap().bytes().map(|byte| match byte {
        b'/' | b'.' | b'-' | b'_' => char::from(byte).to_string(),
        _ if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    });
    format!("file://{}", bytes.collect::<String>())
}

#[interface(name = "org.freedesktop.portal.FileChooser")]
impl FileChooser {
    async fn open_file(
        &self,
        #[zbus(header)] header: Header<'_>,
        #[zbus(connection)] connection: &Connection,
        parent: String,
        title: String,
        options: HashMap<String, OwnedValue>,
    ) -> fdo::Result<OwnedObjectPath> {
        let sender = header.sender().unwrap().to_owned().into();
        let request = Request { method: "OpenFile", parent, title, options, sender };
        self.answer(connection, request).await
    }

    async fn save_file(
        &self,
        #[zbus(header)] header: Header<'_>,
        #[zbus(connection)] connection: &Connection,
        parent: String,
        title: String,
        options: HashMap<String, OwnedValue>,
    ) -> fdo::Result<OwnedObjectPath> {
        let sender = header.sender().unwrap().to_owned().into();
        let request = Request { method: "SaveFile", parent, title, options, sender };
        self.answer(connection, request).await
    }
}

/// The portal.
struct Portal {
    told: Arc<Mutex<Told>>,
    connection: Connection,
}

impl Portal {
    fn start(bus: &Bus) -> Portal {
        let told = Arc::default();
        let chooser = FileChooser(Arc::clone(&told));
        let connection = block_on(async {
            Builder::address(bus.address.as_str())?
                .serve_at("/org/freedesktop/portal/desktop", chooser)?
                .name("org.freedesktop.portal.Desktop")?
                .build()
                .await
        });
        Portal { told, connection: connection.unwrap() }
    }

    /// Number of dialogs that were asked for.
    fn count(&self) -> usize {
        self.told.lock().unwrap().requests.len()
    }

    /// Presses these keys, which ask for a file; what the portal, which will answer so, is asked.
    fn asked(&self, reply: Reply, ask: impl FnOnce()) -> Request {
        let before = self.count();
        self.told.lock().unwrap().replies.push_back(reply);
        ask();
        wait_for("the question", || self.told.lock().unwrap().requests.get(before).cloned())
    }

    /// Clicks the window's button until it asks, and replies. Another click asks nothing.
    fn asked_by(&self, heard: &Heard, button: &str, reply: Reply) -> Request {
        let before = self.count();
        self.told.lock().unwrap().replies.push_back(Reply::Nothing);
        // A dialog that is just opening may be told of before it has its size, and so its place.
        let place = || heard.rect(BUTTON, button);
        wait_for("the button to rest", || {
            let seen = place();
            sleep(LET_GO);
            (place() == seen).then_some(())
        });
        let request = wait_for("the question", || {
            heard.click(BUTTON, button);
            sleep(LET_GO);
            self.told.lock().unwrap().requests.get(before).cloned()
        });
        heard.click(BUTTON, button);
        sleep(LET_GO);
        assert_eq!(self.count(), before + 1);
        self.reply(heard, &request, reply);
        request
    }

    /// Replies when the window waits, and waits until it has heard.
    fn reply(&self, heard: &Heard, request: &Request, reply: Reply) {
        heard.wait_for_text(WAITS);
        block_on(respond(&self.connection, request.sender.clone(), reply)).unwrap();
        wait_until_alone(heard);
    }

    /// Waits until whoever asked has left the bus.
    fn wait_for_end(&self, request: &Request) {
        wait_for("the end of the dialog", || {
            block_on(async {
                let bus = DBusProxy::new(&self.connection).await.unwrap();
                let sender: UniqueName<'_> = request.sender.as_ref();
                (!bus.name_has_owner(sender.into()).await.unwrap()).then_some(())
            })
        });
    }
}

fn write_scene(path: &Path, name: &str) {
    fs::write(path, BuiltinScene::find(name).unwrap().text).unwrap();
}

fn wait_for_title(heard: &Heard, begins: &str) {
    let title = || heard.window.title().filter(|title| title.starts_with(begins));
    wait_for(begins, title);
}

/// Waits until the desktop's dialog is closed.
fn wait_until_alone(heard: &Heard) {
    heard.wait("the window alone", |nodes| (!says(nodes, WAITS)).then_some(()));
}

/// Returns whether the window asks for a file by itself.
fn lists_files(heard: &Heard) -> bool {
    let nodes = heard.nodes();
    nodes.iter().any(|node| node.role == BUTTON && node.name == "Up")
}

/// Waits until the window's own dialog takes keys.
fn wait_for_field(heard: &Heard) {
    heard.wait("the field to take keys", |nodes| {
        nodes.iter().find(|node| node.has_focus && node.name == "path").map(drop)
    });
}

/// Types a path into the window's own dialog.
fn type_path(heard: &Heard, path: &Path) {
    wait_for_field(heard);
    heard.window.key("ctrl+a");
    heard.window.write(path.to_str().unwrap());
    heard.key("Return");
}

pub(crate) fn opens_saves_and_exports() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = built_in(folder.path(), "canonical");
    let other = at("50% größer.toml");
    write_scene(&other, "look-at");
    let screen = Screen::start();
    let portal = Portal::start(&screen.bus);
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    let key = |key| heard.key(key);

    let request = portal.asked(Reply::Choose(other), || key("ctrl+o"));
    assert_eq!((request.method, &*request.title), ("OpenFile", "Open a scene"));
    assert_eq!(request.folder(), folder.path());
    assert!(request.parent.starts_with("x11:"), "{}", request.parent);
    let filters: Vec<(String, Vec<(u32, String)>)> = request.option("filters");
    assert_eq!(filters[0], ("toml".to_owned(), vec![(0, "*.toml".to_owned())]));
    wait_for_title(&heard, "50% größer.toml - ");
    portal.wait_for_end(&request);

    // It has asked about the file that is there. The ending is the window's, and so is the question then.
    let copy = at("copy.toml");
    write_scene(&copy, "canonical");
    let request = portal.asked(Reply::Choose(copy.clone()), || key("ctrl+shift+s"));
    assert_eq!((request.method, &*request.title), ("SaveFile", "Save the scene as"));
    assert_eq!(request.option::<String>("current_name"), "50% größer.toml");
    wait_for_title(&heard, "copy.toml - ");
    let look_at = BuiltinScene::find("look-at").unwrap().load().unwrap();
    assert_eq!(scene_file::load(&copy).unwrap(), look_at);
    let third = at("third.toml");
    write_scene(&third, "canonical");
    portal.asked(Reply::Choose(at("third")), || key("ctrl+shift+s"));
    heard.wait_for_text(&format!("{} exists. Save once more to replace it.", third.display()));
    assert_eq!(fs::read_to_string(&third).unwrap(), BuiltinScene::find("canonical").unwrap().text);
    wait_for_field(&heard);
    heard.key("Return");
    wait_for_title(&heard, "third.toml - ");
    assert_eq!(scene_file::load(&third).unwrap(), look_at);

    // A figure is described in the window. Nothing is written over the scene.
    heard.key("ctrl+e");
    portal.asked_by(&heard, "Export…", Reply::Cancel);
    let request = portal.asked_by(&heard, "Export…", Reply::Choose(third.clone()));
    assert_eq!(request.option::<String>("current_name"), "world.svg");
    heard.wait("the reason", |nodes| {
        let reason = |name: &str| name.starts_with("Export writes SVG, PDF or PNG: not ");
        nodes.iter().any(|node| reason(&node.name)).then_some(())
    });
    let figure = at("figure.png");
    portal.asked_by(&heard, "Export…", Reply::Choose(figure.clone()));
    wait_for("the figure", || figure.exists().then_some(()));
    assert_eq!(scene_file::load(&third).unwrap(), look_at);
    heard.window.quit();
}

pub(crate) fn is_open_once_and_may_be_closed() {
    let folder = tempfile::tempdir().unwrap();
    let scene = built_in(folder.path(), "canonical");
    let screen = Screen::start();
    let portal = Portal::start(&screen.bus);
    let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
    let key = |key| heard.key(key);

    let request = portal.asked(Reply::Nothing, || key("ctrl+o"));
    heard.wait_for_text(WAITS);
    for again in ["ctrl+o", "ctrl+shift+s"] {
        heard.key(again);
        sleep(LET_GO);
    }
    assert_eq!(portal.count(), 1);
    // The window lives, and closes the dialog.
    heard.click(BUTTON, "Cancel");
    portal.wait_for_end(&request);
    wait_until_alone(&heard);

    let request = portal.asked(Reply::Nothing, || key("ctrl+o"));
    portal.reply(&heard, &request, Reply::Cancel);
    assert!(!lists_files(&heard));
    portal.asked(Reply::ChooseUri("sftp://host/scene.toml"), || key("ctrl+o"));
    heard.wait_for_text(
        "sftp://host/scene.toml is not on this computer. Choose a file in a local folder.",
    );
    heard.click(BUTTON, "Close");
    heard.wait("the window alone", |nodes| {
        (!nodes.iter().any(|node| node.role == BUTTON && node.name == "Close")).then_some(())
    });

    // A window that ends takes its dialog along, and saves nothing.
    heard.window.key("ctrl+p");
    heard.window.write("add sphere");
    heard.key("Return");
    wait_for_title(&heard, "scene.toml* - ");
    let request = portal.asked(Reply::Nothing, || key("ctrl+shift+s"));
    heard.window.signal("TERM");
    portal.wait_for_end(&request);
    heard.window.wait();
    assert_eq!(fs::read_to_string(&scene).unwrap(), BuiltinScene::find("canonical").unwrap().text);
}

pub(crate) fn is_missing_or_does_not_work() {
    for reply in [None, Some(Reply::Error), Some(Reply::End)] {
        let folder = tempfile::tempdir().unwrap();
        let scene = built_in(folder.path(), "canonical");
        let [other, third] = ["other.toml", "third.toml"].map(|name| folder.path().join(name));
        write_scene(&other, "look-at");
        write_scene(&third, "forty-five");
        let screen = Screen::start();
        let portal = reply.is_some().then(|| Portal::start(&screen.bus));
        let mut heard = Heard::open(&screen, &[scene.as_os_str()], folder.path());
        match (&portal, reply) {
            (Some(portal), Some(reply)) => drop(portal.asked(reply, || heard.key("ctrl+o"))),
            _ => heard.key("ctrl+o"),
        }
        type_path(&heard, &other);
        wait_for_title(&heard, "other.toml - ");
        // It is not tried again.
        heard.key("ctrl+o");
        type_path(&heard, &third);
        wait_for_title(&heard, "third.toml - ");
        assert_eq!(portal.map_or(1, |portal| portal.count()), 1);
        heard.window.quit();
    }
}
