//! The window's program, driven by accessible labels: the way of an edit from field to picture,
//! every field, every readout, faults, files and keys.

mod accuracy;
mod answers;
mod by_keys;
mod compare;
mod covered;
mod derivation;
mod edits;
mod exercises;
mod export;
mod faults;
mod frame;
mod handles;
pub(crate) mod harness;
mod history;
mod labels;
mod lessons;
mod lines;
mod mistakes;
mod names;
mod objects;
mod pace;
mod palette;
mod play;
mod play_export;
mod plot;
mod presenter;
mod scene_files;
mod selection;
mod snapshots;
mod teaching;
mod translator;
