//! The changes that the panels made in a pass, as far as they matter to what is drawn above them.

use std::ops::{BitOr, BitOrAssign};

use pinhole_core::Camera;

/// Changes of the document and of how it is looked at.
///
/// Derived values show them in the same pass. Whatever was drawn before them does not: the pass is run
/// again before anything is presented.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[must_use]
pub(crate) struct Changed(u8);

impl Changed {
    /// No change.
    pub(crate) const NOTHING: Changed = Changed(0);
    /// The eye, or the orientation within its kind: only their own fields and the views show them.
    pub(crate) const POSE: Changed = Changed(1);
    /// The camera in another way.
    pub(crate) const CAMERA: Changed = Changed(2);
    /// The scene's objects.
    pub(crate) const OBJECTS: Changed = Changed(4);
    /// Selection, settings and all else that says how the document is looked at.
    pub(crate) const SESSION: Changed = Changed(8);

    /// Returns this change, if the condition holds.
    pub(crate) fn when(self, is_so: bool) -> Changed {
        if is_so { self } else { Changed::NOTHING }
    }

    /// Edits a value of the session, and returns the change.
    pub(crate) fn edited<T: Clone + PartialEq>(
        value: &mut T,
        edit: impl FnOnce(&mut T),
    ) -> Changed {
        let before = value.clone();
        edit(value);
        Changed::SESSION.when(*value != before)
    }

    /// Returns the change from one camera to another.
    pub(crate) fn between_cameras(before: &Camera, now: &Camera) -> Changed {
        if before == now {
            return Changed::NOTHING;
        }
        let moved = Camera { eye: now.eye, orientation: now.orientation, ..*before };
        let same_kind = before.orientation.kind() == now.orientation.kind();
        let can_see = before.resolve().is_ok() && now.resolve().is_ok();
        if moved == *now && same_kind && can_see { Changed::POSE } else { Changed::CAMERA }
    }

    /// Returns true if something that is drawn above the panels shows it.
    pub(crate) fn is_shown_above(self) -> bool {
        self.0 & !Changed::POSE.0 != 0
    }
}

impl BitOr for Changed {
    type Output = Changed;

    fn bitor(self, other: Changed) -> Changed {
        Changed(self.0 | other.0)
    }
}

impl BitOrAssign for Changed {
    fn bitor_assign(&mut self, other: Changed) {
        *self = *self | other;
    }
}
