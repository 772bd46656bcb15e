//! Scenes, figures and animations from files and into them.

mod changed_file;
mod desktop_dialog;
mod export;
mod play_export;
mod recovery;
mod remembering;
pub(crate) mod scene_files;
mod share;
