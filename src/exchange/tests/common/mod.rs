//! What several tests of readers need.

pub(crate) mod mutants;
