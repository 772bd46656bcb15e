//! A cache of the derivation, keyed by its inputs.

use std::sync::Arc;

use pinhole_exchange::document::Document;
use pinhole_lecture::numbers::Rounding;

use super::Derived;
use super::derived::Inputs;
use super::memo::Memo;
use crate::model::session::ViewLayout;
use crate::view::derivation::{Derivation, DerivationInputs, DerivationSettings, derivation};

/// Decimals of the derivation's numbers while presenting: what can be read from the back row.
const PRESENTED_DECIMALS: usize = 3;

/// The last derivation and its inputs.
#[derive(Debug, Default)]
pub(super) struct Derivations(Memo<(Document, DerivationSettings), Arc<Derivation>>);

impl Derivations {
    /// Returns the derivation, if the layout shows it.
    pub(super) fn get(
        &mut self,
        Inputs { document, session, sizes, .. }: Inputs<'_>,
        derived: &Derived,
    ) -> Option<Arc<Derivation>> {
        let layout = session.settings.layout;
        let is_solution =
            layout == ViewLayout::Exercises && sizes.world.is_some() && session.exercises.is_solved;
        if !layout.shows_derivation() && !is_solution {
            return None;
        }
        let settings = DerivationSettings {
            selection: session.shown_selection(),
            sections: session.sections,
            rounding: match session.presenting {
                Some(_) => Rounding::Decimals(PRESENTED_DECIMALS),
                None => Rounding::Significant(session.settings.digits),
            },
            exact: session.settings.exact_forms,
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
