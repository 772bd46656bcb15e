//! The functions of the page's own script, `page.js`.

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(js_namespace = pinhole)]
extern "C" {
    /// Returns the time in milliseconds since 1970.
    pub(super) fn now() -> f64;

    /// Returns the text in the browser's storage with this key.
    pub(super) fn stored(key: &str) -> Option<String>;

    /// Puts a text into the browser's storage. Returns the reason if that fails.
    pub(super) fn store(key: &str, text: &str) -> Option<String>;

    /// Removes a text from the browser's storage.
    pub(super) fn forget(key: &str);

    /// Finds the locks of other pages, and takes the first of these that is free and whose file is not stored.
    pub(super) async fn find_locks(names: Vec<String>, files: Vec<String>);

    /// Locks a name for this page. Returns false if another page holds the lock.
    pub(super) fn lock(name: &str) -> bool;

    /// Releases a lock.
    pub(super) fn unlock(name: &str);

    /// Offers a file to the user for download.
    pub(super) fn download(name: &str, content: &[u8]);

    /// Opens the browser's dialog for files with these extensions, such as `.toml,.csv`. The script passes
    /// the answer to `file_added` and then to `choice_made`.
    pub(super) fn choose(extensions: &str);

    /// Returns the scene or lesson in the page, as JSON.
    pub(super) fn part() -> String;

    /// Returns the text of the page itself, as it was opened.
    pub(super) fn source() -> String;

    /// Returns the page's address without its fragment.
    pub(super) fn address() -> String;

    /// Returns the fragment of the page's address without `#`. With the first picture, the script takes it out.
    pub(super) fn fragment() -> String;

    /// Returns true if the user has asked the system for less motion.
    pub(super) fn reduced_motion() -> bool;

    /// Sets the page's title.
    pub(super) fn set_title(title: &str);

    /// Makes the page fill the screen, or not.
    pub(super) fn fill_screen(fill: bool);

    /// Chooses the keyboard on the screen: for a number, or for any text.
    pub(super) fn type_numbers(is_number: bool);

    /// Returns true if the main pointer is a finger.
    pub(super) fn is_touched() -> bool;

    /// Tells a screen reader what the page shows.
    pub(super) fn tell(text: &str);

    /// Rests until the next event, or until this many seconds have passed.
    pub(super) fn rest(seconds: f64);

    /// Starts the page again if it has no picture yet and has not failed before; else shows a message about an
    /// error of the program. `is_kept` is true if unsaved changes are stored.
    pub(super) fn failed(message: &str, report: &str, is_kept: bool);
}
