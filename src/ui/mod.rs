//! The window's contents: the order of a frame ([`app`]), the views ([`scene`]), the [`derivation`], the panels
//! around them, dialogs, widgets, and the table of commands. What a feature shows is in [`crate::features`].

pub mod action;
pub mod app;
pub mod commands_table;
pub mod derivation;
pub mod dialogs;
pub mod frame_times;
pub mod panels;
pub mod scene;
pub(crate) mod second_picture;
pub(crate) mod stage;
pub mod widgets;
pub(crate) mod workspaces;
