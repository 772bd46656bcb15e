//! The ladder, and the same without it, to measure what certainty costs.

use std::marker::PhantomData;

/// Whether decisions are made with bounds, and those in doubt left to the ladder.
pub(crate) trait Certainty {
    /// If not, every decision is what the first arithmetic says.
    const IS_CERTAIN: bool;
}

/// Every decision is right.
pub(crate) struct Certain;

/// No end has a margin, no order is in doubt.
pub(crate) struct Uncertain;

impl Certainty for Certain {
    const IS_CERTAIN: bool = true;
}

impl Certainty for Uncertain {
    const IS_CERTAIN: bool = false;
}

/// What carries a [`Certainty`].
pub(crate) type Carries<C> = PhantomData<C>;
