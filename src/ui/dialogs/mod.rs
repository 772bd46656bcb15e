//! Overlays over the window: dialogs about files, figures and unsaved changes, the command palette,
//! the list of keys and the texts of the Help menu.

pub mod dialog;
pub mod export;
pub mod help;
pub mod key_list;
pub mod palette;
pub mod path_field;
