//! Links to what is shown, with their QR codes.

pub mod link;
pub mod ui;
