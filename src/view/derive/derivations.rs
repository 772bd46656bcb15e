//! A cache of the derivation, keyed by its inputs.

use std::sync::Arc;

use pinhole_exchange::document::Document;

use super::Derived;
use super::derived::Inputs;
use super::memo::Memo;
use crate::view::derivation::{Derivation, DerivationInputs, DerivationSettings, derivation};

/// The last derivation and its inputs.
#[derive(Debug, Default)]
pub(super) struct Derivations(Memo<(Document, DerivationSettings), Arc<Derivation>>);

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
        let settings = DerivationSettings {
            selection: session.shown_selection(),
            sections: session.sections,
            digits: session.settings.digits,
            from_one: session.settings.count_from_one,
            fault: derived.fault,
        };
        // The document is compared before it is cloned, because it can be large.
        let is_same = |(known, chosen): &(Document, DerivationSettings)| {
            *chosen == settings && known == document
        };
        if let Some(made) = self.0.known(is_same) {
            return Some(Arc::clone(made));
        }
        Some(self.0.get((document.clone(), settings), |_| {
            Arc::new(derivation(&DerivationInputs {
                document,
                resolved: derived.resolved.as_ref(),
                scene: derived.scene.as_deref(),
                inspection: derived.inspection.as_deref(),
                settings,
            }))
        }))
    }
}
