//! Recovery files, to which unsaved changes are written while the user works. If a window ends without asking
//! whether to save its changes, a later start of the program offers them.

use std::sync::Arc;

use egui::Context;
use pinhole_exchange::document::Document;

use super::window::complain;
use super::writing::Writing;
use crate::model::recovery::{Found, Slot, Unsaved, in_words};
use crate::model::{OpenDocument, Store};
use crate::ui::action::{FileAction, Leave};
use crate::ui::dialogs::{Dialog, Question};

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
    writing: Writing,
    /// True if the user has been told why changes cannot be recorded.
    is_told: bool,
}

impl Recovery {
    /// Opens a recovery slot for this window, and finds the changes that ended windows have left in their
    /// slots.
    pub(super) fn new(store: Option<&Store>) -> Recovery {
        let Some(store) = store else { return Recovery::default() };
        let (slot, found, fault) = Slot::open(&store.unsaved());
        let writing = Writing::new("the recovery file could not be written");
        let mut recovery = Recovery { writing, ..Recovery::default() };
        recovery.writing.tell(fault.map_or(Ok(()), |fault| Err(fault.to_string())));
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

    /// Writes unsaved changes to the slot, some time after an edit.
    pub(super) fn follow(&mut self, ctx: &Context, open: &OpenDocument) {
        if self.slot.is_none() {
            return;
        }
        if !open.has_changes() {
            self.clear();
            return;
        }
        let own = open.own();
        if self.last_document.as_ref() != Some(&*own) {
            self.last_document = Some(own.into_owned());
            self.writing.note(ctx);
        }
        if self.writing.is_due(ctx) {
            self.write_changes(open);
        }
    }

    /// Writes pending changes at once, because it may be a long time until the next frame.
    pub(super) fn write_now(&mut self, open: &OpenDocument) {
        if self.writing.first_change.is_some() {
            self.write_changes(open);
        }
    }

    /// Writes all unsaved changes at once.
    pub(super) fn write_changes(&mut self, open: &OpenDocument) {
        let Some((unsaved, slot)) = self.unsaved(open) else { return };
        self.is_written = true;
        self.writing.start(move || unsaved.write(&slot));
    }

    /// Returns the unsaved changes, and the slot that they belong to.
    pub(super) fn unsaved(&self, open: &OpenDocument) -> Option<(Unsaved, Arc<Slot>)> {
        let slot = self.slot.clone().filter(|_| open.has_changes())?;
        Some((Unsaved::of(open), slot))
    }

    /// Returns, once, the reason why unsaved changes cannot be recorded.
    pub(super) fn take_fault(&mut self) -> Option<String> {
        let reason = self.writing.fault.as_ref()?;
        (!std::mem::replace(&mut self.is_told, true)).then(|| reason.clone())
    }

    /// Clears the recovery slot, because its changes are saved or no longer wanted.
    fn clear(&mut self) {
        self.writing.finish();
        (self.last_document, self.writing.first_change) = (None, None);
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
        self.writing.finish();
        if let Some(slot) = &self.slot {
            match Unsaved::of(open).write(slot) {
                Ok(()) => complain("the next start offers the unsaved changes"),
                Err(reason) => complain(&format!("the unsaved changes are lost: {reason}")),
            }
        }
    }
}
