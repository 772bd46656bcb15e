//! A cache of the derivation, keyed by its inputs.

use std::sync::Arc;

use pinhole_exchange::document::Document;

use super::Derived;
use super::derived::Inputs;
use super::memo::Memo;
use crate::view::derivation::{Derivation, Sources, View, derivation};

/// The last derivation and its inputs.
#[derive(Debug, Default)]
pub(super) struct Derivations(Memo<(Document, View), Arc<Derivation>>);

impl Derivations {
    /// Returns the derivation, if the layout shows it.
    pub(super) fn get(
        &mut self,
        Inputs { document, session, .. }: Inputs<'_>,
        derived: &Derived,
    ) -> Option<Arc<Derivation>> {
        if !session.settings.layout.shows_derivation() {
            return None;
        }
        let view = View {
            selection: session.selection,
            sections: session.sections,
            digits: session.settings.digits,
            from_one: session.settings.count_from_one,
            fault: derived.fault,
        };
        // The document is compared before it is cloned, because it can be large.
        let is_same =
            |(known, as_viewed): &(Document, View)| *as_viewed == view && known == document;
        if let Some(made) = self.0.known(is_same) {
            return Some(Arc::clone(made));
        }
        Some(self.0.get((document.clone(), view), |_| {
            Arc::new(derivation(&Sources {
                document,
                resolved: derived.resolved.as_ref(),
                scene: derived.scene.as_deref(),
                inspection: derived.inspection.as_deref(),
                view,
            }))
        }))
    }
}
