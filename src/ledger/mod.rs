//! The ledger: how every number comes about, line by line in the lecture's order.

mod sections;

pub use sections::{LedgerSection, LedgerSections};
