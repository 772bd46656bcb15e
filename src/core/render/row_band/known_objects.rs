//! Objects as the eye sees them, and pairs of planes, kept from pixel to pixel.

use std::collections::HashMap;

use crate::scene::object_from_origin::ObjectFromOrigin;
use crate::scene::plane_order::PlaneOrder;
use crate::scene::plane_predicates::PlaneFromOrigin;

/// Objects as the eye sees them, by the last digits of their index, and pairs of planes.
#[derive(Debug, Default)]
pub(crate) struct KnownObjects {
    objects: Vec<Option<(u32, ObjectFromOrigin)>>,
    plane_orders: HashMap<[u32; 2], PlaneOrder>,
}

impl KnownObjects {
    /// Number of objects that are kept; a power of two.
    const OBJECTS: usize = 64;

    /// Maximum number of pairs of planes that are kept.
    const PAIRS: usize = 4096;

    /// Returns an object as the eye sees it, which is made if it is not at hand.
    pub(crate) fn get(
        &mut self,
        index: u32,
        make: impl FnOnce() -> ObjectFromOrigin,
    ) -> &ObjectFromOrigin {
        self.objects.resize(KnownObjects::OBJECTS, None);
        let slot = &mut self.objects[index as usize % KnownObjects::OBJECTS];
        if slot.as_ref().is_none_or(|(known, _)| *known != index) {
            *slot = None;
        }
        &slot.get_or_insert_with(|| (index, make())).1
    }

    /// Returns the order of two planes, which is made if it is not at hand.
    pub(crate) fn plane_order(
        &mut self,
        indices: [u32; 2],
        [one, other]: [&PlaneFromOrigin; 2],
    ) -> PlaneOrder {
        if self.plane_orders.len() > KnownObjects::PAIRS {
            self.plane_orders.clear();
        }
        *self.plane_orders.entry(indices).or_insert_with(|| PlaneOrder::new(one, other))
    }
}
