//! Overlays over the window: dialogs about files, figures and unsaved changes, the command palette
//! and the list of keys.

pub mod dialog;
pub mod export;
pub mod key_list;
pub mod palette;
