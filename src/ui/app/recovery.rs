//! Writing unsaved changes aside while they are made, and offering those of a window that ended
//! without being asked.

use std::path::Path;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

use egui::Context;
use pinhole_exchange::document::Document;

use super::window::complain;
use crate::model::files::OpenDocument;
use crate::model::recovery::{Found, Slot, Unsaved, in_words};
use crate::model::store::Store;
use crate::ui::dialogs::Dialog;

/// Time after the last edit, and during a long drag, after which changes are written, in seconds.
const REST: f64 = 1.0;
const LONGEST: f64 = 4.0;

/// Time after which a disk that was busy is asked again.
const BUSY: Duration = Duration::from_millis(100);

/// This window's slot, and what was found in others.
#[derive(Default)]
pub(super) struct Recovery {
    slot: Option<Arc<Slot>>,
    found: Vec<Found>,
    /// Index of the next one to offer.
    next: usize,
    /// True if changes are written, or being written.
    is_written: bool,
    /// The document as it was seen last.
    seen: Option<Document>,
    /// Times of the last edit, and of the first one that is not written yet, in seconds.
    last_edit: f64,
    first_edit: Option<f64>,
    writing: Option<JoinHandle<()>>,
}

impl Recovery {
    /// Finds what other windows have left.
    pub(super) fn new(store: Option<&Store>) -> Recovery {
        let Some(store) = store else { return Recovery::default() };
        let (slot, found, fault) = Slot::open(&store.unsaved());
        if let Some(fault) = fault {
            complain(&format!("unsaved changes may not be written aside, or offered: {fault}"));
        }
        Recovery { slot: slot.map(Arc::new), found, ..Recovery::default() }
    }

    /// Returns the dialog that offers what was found and not offered yet, if there is any.
    pub(super) fn offer(&mut self) -> Option<Dialog> {
        let found = self.found.get(self.next)?;
        self.next += 1;
        let (title, file) = (found.title().to_owned(), found.file().map(Path::to_owned));
        Some(Dialog::Found { title, file, age: in_words(found.age) })
    }

    /// Takes the changes that were offered last.
    pub(super) fn take(&mut self) -> Option<Found> {
        self.next = self.next.checked_sub(1)?;
        (self.next < self.found.len()).then(|| self.found.remove(self.next))
    }

    /// Goes on in the slot of changes that are open now, where they stay until they are saved.
    pub(super) fn go_on_in(&mut self, slot: Slot) {
        self.clear();
        (self.slot, self.is_written) = (Some(Arc::new(slot)), true);
    }

    /// Writes changes aside, beside the frame, once the hand rests or has moved for long.
    pub(super) fn follow(&mut self, ctx: &Context, open: &OpenDocument) {
        if self.slot.is_none() {
            return;
        }
        if !open.has_changes() {
            self.clear();
            return;
        }
        let now = ctx.input(|i| i.time);
        if self.seen.as_ref() != Some(&open.document) {
            self.seen = Some(open.document.clone());
            self.last_edit = now;
            self.first_edit.get_or_insert(now);
        }
        let Some(first) = self.first_edit else { return };
        let due = (self.last_edit + REST).min(first + LONGEST);
        if now < due {
            ctx.request_repaint_after(Duration::from_secs_f64(due - now));
            return;
        }
        if self.writing.as_ref().is_some_and(|writing| !writing.is_finished()) {
            // A slow disk holds up no frame.
            ctx.request_repaint_after(BUSY);
            return;
        }
        self.first_edit = None;
        self.write(Unsaved::of(open));
    }

    /// Writes at once what waits to be written: there may be no frame for a long time.
    pub(super) fn write_now(&mut self, open: &OpenDocument) {
        if self.first_edit.is_some() {
            self.write_changes(open);
        }
    }

    /// Writes what is unsaved at once.
    pub(super) fn write_changes(&mut self, open: &OpenDocument) {
        self.first_edit = None;
        if open.has_changes() {
            self.write(Unsaved::of(open));
        }
    }

    fn write(&mut self, unsaved: Unsaved) {
        let Some(slot) = self.slot.clone() else { return };
        self.is_written = true;
        self.finish_writing();
        self.writing = Some(std::thread::spawn(move || {
            if let Err(reason) = unsaved.write(&slot) {
                complain(&format!("the unsaved changes could not be written aside: {reason}"));
            }
        }));
    }

    /// Waits until what is being written is written: what comes next must not overtake it.
    fn finish_writing(&mut self) {
        if let Some(writing) = self.writing.take() {
            // A thread that panicked has written nothing.
            let _ = writing.join();
        }
    }

    /// Removes what is written: it is saved, or not wanted.
    fn clear(&mut self) {
        self.finish_writing();
        (self.seen, self.first_edit) = (None, None);
        if let (true, Some(slot)) = (std::mem::take(&mut self.is_written), &self.slot) {
            slot.clear();
        }
    }

    /// Writes changes that nobody was asked about, because display or adapter went away; removes them
    /// if they are saved, or not wanted.
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
