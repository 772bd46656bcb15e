//! The views: handles, labels, what covers what, and the camera beside its ghost.

mod by_keys;
mod compare;
mod covered;
mod handles;
mod labels;
