//! The edited and remembered state: the session around a document, its history, lessons and play.
//!
//! A document ([`pinhole_exchange::document::Document`]) holds the contents of a scene file; the
//! [`session::Session`] holds the state of its views. Nothing here draws.

pub mod concept;
pub mod derivation_sections;
pub mod expression;
pub mod fault;
pub mod files;
pub mod given;
pub mod history;
pub mod inspection;
pub mod interaction;
pub mod lessons;
pub mod lines;
pub mod observer;
pub mod overlay_items;
pub mod play;
pub mod practice;
pub mod readings;
pub mod recovery;
pub mod session;
pub mod store;
pub mod symbols;
pub mod translator;
