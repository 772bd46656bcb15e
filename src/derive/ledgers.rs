//! The ledger, remembered on its inputs.

use std::sync::Arc;

use super::{Derived, Fault};
use crate::document::Document;
use crate::ledger::{Ledger, LedgerSections, Sources, ledger};
use crate::session::{Selection, Session};

/// The last ledger, and what it was made of.
#[derive(Debug, Default)]
pub(super) struct Ledgers(Option<(Document, Looked, Arc<Ledger>)>);

/// What besides the document it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Looked {
    selection: Selection,
    sections: LedgerSections,
    digits: usize,
    from_one: bool,
    fault: Option<Fault>,
}

impl Ledgers {
    /// The ledger, where the layout shows it.
    pub(super) fn of(
        &mut self,
        document: &Document,
        session: &Session,
        derived: &Derived,
    ) -> Option<Arc<Ledger>> {
        if !session.settings.layout.shows_ledger() {
            return None;
        }
        let looked = Looked {
            selection: session.selection,
            sections: session.sections,
            digits: session.settings.digits,
            from_one: session.settings.count_from_one,
            fault: derived.fault,
        };
        // Compared before it is cloned: a document can be large.
        match &self.0 {
            Some((known, as_looked, made)) if *as_looked == looked && known == document => {
                Some(Arc::clone(made))
            }
            _ => {
                let made = Arc::new(ledger(&Sources {
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
