//! A check of every pixel of a frame, and scenes of many spheres to be checked.
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod crowds;
pub(crate) mod every_pixel;
pub(crate) mod meeting;
