//! stub
pub mod fonts;
