//! A cache of the derivation, keyed by its inputs.

use std::sync::Arc;

use pinhole_exchange::document::Document;

use super::Derived;
use crate::model::derivation_sections::DerivationSections;
use crate::model::fault::Fault;
use crate::model::session::{Selection, Session};
use crate::view::derivation::{Derivation, Sources, derivation};

/// The last derivation and its inputs.
#[derive(Debug, Default)]
pub(super) struct Derivations(Option<(Document, Looked, Arc<Derivation>)>);

/// The inputs of the derivation besides the document.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Looked {
    selection: Selection,
    sections: DerivationSections,
    digits: usize,
    from_one: bool,
    fault: Option<Fault>,
}

impl Derivations {
    /// Returns the derivation, if the layout shows it.
    pub(super) fn get(
        &mut self,
        document: &Document,
        session: &Session,
        derived: &Derived,
    ) -> Option<Arc<Derivation>> {
        if !session.settings.layout.shows_derivation() {
            return None;
        }
        let looked = Looked {
            selection: session.selection,
            sections: session.sections,
            digits: session.settings.digits,
            from_one: session.settings.count_from_one,
            fault: derived.fault,
        };
        // The document is compared before it is cloned, because it can be large.
        match &self.0 {
            Some((known, as_looked, made)) if *as_looked == looked && known == document => {
                Some(Arc::clone(made))
            }
            _ => {
                let made = Arc::new(derivation(&Sources {
                    document,
                    resolved: derived.resolved.as_ref(),
                    scene: derived.scene.as_deref(),
                    inspection: derived.inspection.as_deref(),
                    fault: looked.fault,
                    selection: looked.selection,
                    sections: looked.sections,
                    digits: looked.digits,
                    from_one: looked.from_one,
                }));
                self.0 = Some((document.clone(), looked, Arc::clone(&made)));
                Some(made)
            }
        }
    }
}
