//! The window's contents: the order of a frame ([`app`]), the workspaces' pages and their parts ([`scene`],
//! [`derivation`], [`ray`], [`practice`], [`tools`]), the panels around them, dialogs, widgets, and the table
//! of commands.

pub mod action;
pub mod app;
pub mod commands_table;
pub mod derivation;
pub mod dialogs;
pub mod frame_times;
pub mod panels;
pub mod practice;
pub mod ray;
pub mod scene;
pub(crate) mod second_picture;
pub(crate) mod stage;
pub mod tools;
pub mod widgets;
pub(crate) mod workspaces;
