//! The window's program, driven by accessible labels: the way of an edit from field to picture,
//! every field, every readout, faults, files and keys.

mod derivation;
mod edits;
mod every_step;
mod failure;
mod faults;
mod files;
mod fingers;
pub(crate) mod harness;
mod history;
mod lessons;
mod monkey;
mod names;
mod number_format;
mod objects;
mod pace;
mod painted_texts;
mod palette;
mod play;
mod practice;
mod presented_steps;
mod presenter;
mod ray;
mod scene;
mod selection;
mod snapshots;
mod spoken;
mod teaching;
mod tools;
