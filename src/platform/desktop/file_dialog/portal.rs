//! The file dialog of the desktop's portal: `org.freedesktop.portal.FileChooser` on the session bus.

use std::collections::HashMap;
use std::ffi::OsString;
use std::os::unix::ffi::{OsStrExt as _, OsStringExt as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use futures_lite::StreamExt as _;
use futures_lite::future::block_on;
use percent_encoding::percent_decode_str;
use winit::raw_window_handle::{HasWindowHandle as _, RawWindowHandle};
use winit::window::Window;
use zbus::connection::Builder;
use zbus::fdo::DBusProxy;
use zbus::message::Type;
use zbus::names::WellKnownName;
use zbus::zvariant::{OwnedObjectPath, OwnedValue, Value};
use zbus::{Connection, MatchRule, Message, MessageStream};

use super::AT_ONCE;
use crate::ui::widgets::path_field::{FileAnswer, FileRequest};

const PORTAL: &str = "org.freedesktop.portal.Desktop";
const OBJECT: &str = "/org/freedesktop/portal/desktop";
const FILE_CHOOSER: &str = "org.freedesktop.portal.FileChooser";
const REQUEST: &str = "org.freedesktop.portal.Request";

/// Timeout for a call to the bus or the portal, either of which may have to be started first. No
/// call waits for the user.
const PATIENCE: Duration = Duration::from_secs(5);

/// Calls `on_found` on another thread if the bus has a portal, or can start one.
pub(crate) fn detect(on_found: impl FnOnce() + Send + 'static) {
    thread::spawn(move || {
        if block_on(is_there()).unwrap_or(false) {
            on_found();
        }
    });
}

async fn connect() -> zbus::Result<Connection> {
    Builder::session()?.method_timeout(PATIENCE).build().await
}

async fn is_there() -> zbus::Result<bool> {
    let bus = DBusProxy::new(&connect().await?).await?;
    let portal = WellKnownName::from_static_str(PORTAL)?;
    if bus.name_has_owner(portal.into()).await? {
        return Ok(true);
    }
    let activatable = bus.list_activatable_names().await?;
    Ok(activatable.iter().any(|name| name.as_str() == PORTAL))
}

/// An open dialog. Dropping it closes the dialog, because the portal closes the dialogs of clients that
/// leave the bus.
pub(crate) struct FileDialog(Arc<OnceLock<Option<Connection>>>);

impl Drop for FileDialog {
    fn drop(&mut self) {
        // If there is no connection yet, this prevents one.
        if self.0.set(None).is_err()
            && let Some(connection) = self.0.get().cloned().flatten()
        {
            // Closing fails if the bus is gone, and the dialog with it.
            let _ = block_on(connection.close());
        }
    }
}

/// Opens a file dialog over the window, and passes the answer to `on_answer`.
pub(crate) fn ask(
    request: &FileRequest,
    window: &Window,
    on_answer: impl FnOnce(FileAnswer) + Send + 'static,
) -> FileDialog {
    let connected = Arc::new(OnceLock::new());
    let asked = FileDialog(Arc::clone(&connected));
    let (request, parent) = (request.clone(), name_of(window));
    thread::spawn(move || {
        let answer = block_on(answer(&request, &parent, &connected));
        on_answer(answer.unwrap_or(FileAnswer::Unavailable));
    });
    asked
}

/// Returns the window's identifier for the portal, or an empty string if the window has none. On
/// Wayland, the identifier would have to be requested from the compositor by a protocol that winit does
/// not support.
fn name_of(window: &Window) -> String {
    match window.window_handle().map(|handle| handle.as_raw()) {
        Ok(RawWindowHandle::Xlib(handle)) => format!("x11:{:x}", handle.window),
        Ok(RawWindowHandle::Xcb(handle)) => format!("x11:{:x}", handle.window),
        _ => String::new(),
    }
}

async fn answer(
    request: &FileRequest,
    parent: &str,
    connected: &OnceLock<Option<Connection>>,
) -> zbus::Result<FileAnswer> {
    let connection = connect().await?;
    if connected.set(Some(connection.clone())).is_err() {
        return Ok(FileAnswer::Cancelled);
    }
    let rule =
        MatchRule::builder().msg_type(Type::Signal).interface(REQUEST)?.member("Response")?;
    // Subscribe before asking: the answer may come at once.
    let mut responses = MessageStream::for_match_rule(rule.build(), &connection, None).await?;
    let method = if request.question.writes.is_some() { "SaveFile" } else { "OpenFile" };
    let body = (parent, request.question.title, options(request));
    let reply =
        connection.call_method(Some(PORTAL), OBJECT, Some(FILE_CHOOSER), method, &body).await?;
    let asked = Instant::now();
    let handle: OwnedObjectPath = reply.body().deserialize()?;
    while let Some(response) = responses.next().await {
        let response = response?;
        let (of_portal, header) = (reply.header(), response.header());
        if header.sender() == of_portal.sender() && header.path() == Some(&*handle) {
            return read(&response, asked.elapsed());
        }
    }
    Ok(FileAnswer::Unavailable)
}

/// Returns the options of the request, by their names in the portal's interface.
fn options(request: &FileRequest) -> HashMap<&'static str, Value<'static>> {
    const GLOB: u32 = 0;
    let question = request.question;
    let mut folder = request.folder.as_os_str().as_bytes().to_owned();
    folder.push(0);
    let mut options = HashMap::from([
        ("accept_label", Value::from(question.verb())),
        ("current_folder", Value::from(folder)),
    ]);
    if question.writes.is_some() {
        options.insert("current_name", Value::from(request.name.clone()));
    }
    if !question.endings.is_empty() {
        let globs = question.endings.iter().map(|ending| format!("*.{ending}"));
        let listed: Vec<(u32, String)> = globs.map(|glob| (GLOB, glob)).collect();
        let name = question.endings.join(", ");
        let all = ("all files".to_owned(), vec![(GLOB, "*".to_owned())]);
        options.insert("filters", Value::from(vec![(name, listed), all]));
    }
    options
}

/// Returns the answer in the portal's response. `after` is the time from the opening of the dialog to the
/// response.
fn read(response: &Message, after: Duration) -> zbus::Result<FileAnswer> {
    const CHOSEN: u32 = 0;
    const CANCELLED: u32 = 1;
    let body = response.body();
    let (code, mut results): (u32, HashMap<String, OwnedValue>) = body.deserialize()?;
    if code == CANCELLED {
        return Ok(FileAnswer::Cancelled);
    }
    if code != CHOSEN {
        // The dialog ended "in some other way", as the portal calls it: it could not be opened, or, with
        // GTK, was closed by the button of its frame.
        let was_seen = after > AT_ONCE;
        return Ok(if was_seen { FileAnswer::Cancelled } else { FileAnswer::Unavailable });
    }
    let uris: Vec<String> = match results.remove("uris") {
        Some(uris) => uris.try_into()?,
        None => Vec::new(),
    };
    let Some(uri) = uris.into_iter().next() else { return Ok(FileAnswer::Unavailable) };
    Ok(path_of(&uri).map_or(FileAnswer::Elsewhere(uri), FileAnswer::Chosen))
}

/// Returns the path that a `file:` URI names; `None` for any other URI.
fn path_of(uri: &str) -> Option<PathBuf> {
    let path = uri.strip_prefix("file://")?;
    let path = PathBuf::from(OsString::from_vec(percent_decode_str(path).collect()));
    Path::is_absolute(&path).then_some(path)
}

#[cfg(test)]
mod tests {
    use std::ffi::OsStr;

    use super::*;

    #[test]
    fn a_file_uri_names_a_path_of_any_bytes() {
        let path = path_of("file:///a%20b/50%25%C3%BC%FF.toml");
        let bytes = b"/a b/50%\xc3\xbc\xff.toml";
        assert_eq!(path.as_deref(), Some(Path::new(OsStr::from_bytes(bytes))));
        for elsewhere in ["sftp://host/a.toml", "file://host/a.toml", "/a.toml", ""] {
            assert_eq!(path_of(elsewhere), None, "{elsewhere}");
        }
    }
}
