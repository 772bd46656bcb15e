//! The window's contents: the order of a frame ([`app`]), one folder per workspace ([`scene`],
//! [`derivation`], [`ray`], [`practice`], [`tools`]), the panels around them, dialogs, widgets, and
//! the table of commands.

pub mod action;
pub mod app;
pub mod commands_table;
pub mod derivation;
pub mod dialogs;
pub mod frame_times;
pub mod motion;
pub mod panels;
pub mod practice;
pub mod program;
pub mod ray;
pub mod scene;
pub mod tools;
pub mod view_texture;
pub mod widgets;
