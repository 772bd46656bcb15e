//! The state that the user edits and that is stored between runs: the session around a document, its
//! history, lessons and animations.
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

pub mod concept;
pub mod derivation_sections;
pub mod digest;
pub mod expression;
pub mod fault;
pub mod files;
pub mod given;
pub mod history;
pub mod inspection;
pub mod interaction;
pub mod lessons;
pub mod lines;
pub mod link;
pub mod observer;
pub mod overlay_items;
pub mod page_part;
pub mod play;
pub mod practice;
pub mod readings;
pub mod recovery;
pub mod session;
pub mod store;
pub mod symbols;
pub mod translator;

pub use concept::{Concept, EquationStep, HoverSource, Hovered};
pub use derivation_sections::{DerivationSection, DerivationSections, Formulas};
pub use fault::Fault;
pub use files::OpenDocument;
pub use given::{Given, GivenVector, Givens};
pub use inspection::Inspection;
pub use lessons::{Lesson, OpenLesson, StepId};
pub use lines::LinesLab;
pub use observer::{Observer, ViewSize};
pub use overlay_items::{Item, OverlayItems};
pub use play::Player;
pub use practice::answer_marks::{AnswerMark, MarkShape};
pub use practice::exercises::Exercises;
pub(crate) use practice::exercises::{Feedback, TypedAnswer};
pub use practice::progress::Progress;
pub use practice::{AnswersFile, MistakesView, StudentAnswers};
pub use readings::NumberStyle;
pub use session::handles::HandleState;
pub use session::{
    Ghost, Live, Preferences, Scheme, Session, Settings, Setup, Shown, ThemeName, ViewLayout,
    Workspace,
};
pub use store::{Remembered, Store, WindowGeometry};
pub use translator::Translator;
