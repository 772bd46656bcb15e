//! What lies over the window: dialogs about files, figures and unsaved changes, the palette of
//! commands and the list of keys.

pub mod dialog;
pub mod export;
pub mod key_list;
pub mod palette;
