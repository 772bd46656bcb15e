//! The state that the user edits and that is stored between runs: the session around a document, its
//! history and lessons.
//!
//! A document ([`pinhole_exchange::document::Document`]) holds the contents of a scene file; the
//! [`session::Session`] holds the state of its views. Nothing here draws.

/// Defines a struct whose fields stand with their default values.
macro_rules! with_defaults {
    (
        $(#[$meta:meta])*
        $visible:vis struct $name:ident {
            $($(#[$about:meta])* $accessible:vis $field:ident: $type:ty = $value:expr,)*
        }
    ) => {
        $(#[$meta])*
        $visible struct $name {
            $($(#[$about])* $accessible $field: $type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                $name { $($field: $value,)* }
            }
        }
    };
}
pub(crate) use with_defaults;

pub mod digest;
pub mod expression;
pub mod fault;
pub mod files;
pub mod history;
pub mod interaction;
pub mod lessons;
pub mod page_part;
pub mod recovery;
pub mod session;
pub mod store;

pub use files::OpenDocument;
pub use lessons::{Lesson, OpenLesson, StepId};
pub use session::{
    Ghost, Live, Preferences, Session, Settings, Setup, Shown, ThemeName, ViewLayout, Workspace,
};
pub use store::{Remembered, Store, WindowGeometry};
