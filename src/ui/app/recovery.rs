//! Recovery files, to which unsaved changes are written while the user works. If a window ends without asking
//! whether to save its changes, a later start of the program offers them.

use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use egui::Context;
use pinhole_exchange::document::Document;

use super::window::complain;
use crate::model::recovery::{Found, Slot, Unsaved, in_words};
use crate::model::{OpenDocument, Store};
use crate::ui::action::{FileAction, Leave};
use crate::ui::dialogs::{Dialog, Question};

/// Time from the last edit until changes are written, in seconds.
const REST: f64 = 1.0;
/// Maximum time from the first unwritten edit until changes are written, in seconds.
const LONGEST: f64 = 4.0;

/// Time until the next attempt if the last write is still in progress.
const BUSY: Duration = Duration::from_millis(100);

/// This window's recovery slot, which is a file for its unsaved changes, and the changes found in the slots
/// of windows that have ended.
#[derive(Default)]
pub(super) struct Recovery {
    slot: Option<Arc<Slot>>,
    found: Vec<Found>,
    /// Index of the next changes to offer.
    next: usize,
    /// True if the recovery slot contains changes, or is being written to.
    is_written: bool,
    /// The document in the last pass.
    last_document: Option<Document>,
    /// Time of the last edit, in seconds.
    last_edit: f64,
    /// Time of the first edit that is not written yet, in seconds; `None` if there is none.
    first_edit: Option<f64>,
    writing: Option<JoinHandle<Result<(), String>>>,
    /// The first reason why changes could not be recorded, and whether the user has been told.
    fault: Option<(String, bool)>,
}

impl Drop for Recovery {
    /// Waits for the last write, which keeps the slot locked, so that the next window can open the slot.
    fn drop(&mut self) {
        self.finish_writing();
    }
}

impl Recovery {
    /// Opens a recovery slot for this window, and finds the changes that ended windows have left in their
    /// slots.
    pub(super) fn new(store: Option<&Store>) -> Recovery {
        let Some(store) = store else { return Recovery::default() };
        let (slot, found, fault) = Slot::open(&store.unsaved());
        let mut recovery = Recovery::default();
        recovery.note(fault.map_or(Ok(()), |fault| Err(fault.to_string())));
        (recovery.slot, recovery.found) = (slot.map(Arc::new), found);
        recovery
    }

    /// Returns a dialog that offers the next recovered changes, if there are any left.
    pub(super) fn offer(&mut self) -> Option<Dialog> {
        let found = self.found.get(self.next)?;
        self.next += 1;
        let title = format!("Restore the unsaved changes to {}?", found.title());
        let age = in_words(found.age);
        let text = format!("Pinhole ended without saving them. The last one was made {age} ago.");
        let restore = |as_new| Some(Leave::Restore { as_new }.into());
        let answers = vec![
            ("Restore", "Opens the scene with these changes", restore(false)),
            ("Open as a new scene", "Keeps the scene's file as it is", restore(true)),
            ("Discard", "Deletes these changes", Some(FileAction::DiscardRecovered.into())),
            ("Not now", "Asks again at the next start", None),
        ];
        let file = found.file().map(|file| file.display().to_string()).unwrap_or_default();
        Some(Dialog::Question(Question { title, text, file, answers }))
    }

    /// Removes and returns the changes that were offered last.
    pub(super) fn take(&mut self) -> Option<Found> {
        self.next = self.next.checked_sub(1)?;
        (self.next < self.found.len()).then(|| self.found.remove(self.next))
    }

    /// Takes over the slot of the restored changes, so that they stay there until they are saved.
    pub(super) fn go_on_in(&mut self, slot: Slot) {
        self.clear();
        (self.slot, self.is_written) = (Some(Arc::new(slot)), true);
    }

    /// Writes unsaved changes to the slot, on another thread, once the user pauses or [`LONGEST`] has passed.
    pub(super) fn follow(&mut self, ctx: &Context, open: &OpenDocument) {
        if self.writing.as_ref().is_some_and(JoinHandle::is_finished) {
            self.finish_writing();
        }
        if self.slot.is_none() {
            return;
        }
        if !open.has_changes() {
            self.clear();
            return;
        }
        let now = ctx.input(|i| i.time);
        let own = open.own();
        if self.last_document.as_ref() != Some(&*own) {
            self.last_document = Some(own.into_owned());
            self.last_edit = now;
            self.first_edit.get_or_insert(now);
        }
        let Some(first) = self.first_edit else { return };
        let due = (self.last_edit + REST).min(first + LONGEST);
        if now < due {
            ctx.request_repaint_after(Duration::from_secs_f64(due - now));
            return;
        }
        if self.writing.is_some() {
            // A slow disk must not delay a frame.
            ctx.request_repaint_after(BUSY);
            return;
        }
        self.write_changes(open);
    }

    /// Writes pending changes at once, because it may be a long time until the next frame.
    pub(super) fn write_now(&mut self, open: &OpenDocument) {
        if self.first_edit.is_some() {
            self.write_changes(open);
        }
    }

    /// Writes all unsaved changes at once.
    pub(super) fn write_changes(&mut self, open: &OpenDocument) {
        self.first_edit = None;
        let Some((unsaved, slot)) = self.unsaved(open) else { return };
        let unsaved = Arc::new(unsaved);
        self.is_written = true;
        self.finish_writing();
        let (on_thread, its_slot) = (Arc::clone(&unsaved), Arc::clone(&slot));
        let write = thread::Builder::new().spawn(move || on_thread.write(&its_slot));
        // There may be no thread to have: a browser has none.
        match write {
            Ok(writing) => self.writing = Some(writing),
            Err(_) => self.note(unsaved.write(&slot)),
        }
    }

    /// Returns the unsaved changes, and the slot that they belong to.
    pub(super) fn unsaved(&self, open: &OpenDocument) -> Option<(Unsaved, Arc<Slot>)> {
        let slot = self.slot.clone().filter(|_| open.has_changes())?;
        Some((Unsaved::of(open), slot))
    }

    /// Waits until the last write is finished, so that it cannot overwrite a later one.
    fn finish_writing(&mut self) {
        if let Some(writing) = self.writing.take() {
            // A thread that panicked has written nothing.
            self.note(writing.join().unwrap_or_else(|_| Err("it failed".to_owned())));
        }
    }

    /// Notes the result of a write. The first failure is told in the window.
    fn note(&mut self, written: Result<(), String>) {
        if let Err(reason) = written {
            complain(&format!("the recovery file could not be written: {reason}"));
            self.fault.get_or_insert((reason, false));
        }
    }

    /// Returns, once, the reason why unsaved changes cannot be recorded.
    pub(super) fn take_fault(&mut self) -> Option<String> {
        let (reason, is_told) = self.fault.as_mut()?;
        (!std::mem::replace(is_told, true)).then(|| reason.clone())
    }

    /// Clears the recovery slot, because its changes are saved or no longer wanted.
    fn clear(&mut self) {
        self.finish_writing();
        (self.last_document, self.first_edit) = (None, None);
        if let (true, Some(slot)) = (std::mem::take(&mut self.is_written), &self.slot) {
            slot.clear();
        }
    }

    /// Writes unsaved changes to the recovery slot when the window ends without asking, for example because
    /// the display is lost. Clears the slot if the changes are saved or discarded.
    pub(super) fn end(&mut self, open: &OpenDocument, discarded: bool) {
        if discarded || !open.has_changes() {
            self.clear();
            return;
        }
        self.finish_writing();
        if let Some(slot) = &self.slot {
            match Unsaved::of(open).write(slot) {
                Ok(()) => complain("the next start offers the unsaved changes"),
                Err(reason) => complain(&format!("the unsaved changes are lost: {reason}")),
            }
        }
    }
}
