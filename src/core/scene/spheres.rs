//! A scene's spheres with the index over them.

use std::fmt;
use std::sync::OnceLock;

use crate::scene::sphere::Sphere;
use crate::scene::sphere_index::SphereIndex;

/// Number of spheres from which on there is an index over them: a look at each of fewer is as fast.
pub(crate) const INDEX_FROM: usize = 256;

/// Checked spheres, with an index that is made at the first demand and kept; it says nothing that
/// the spheres do not.
#[derive(Clone, Default)]
pub(crate) struct Spheres {
    list: Vec<Sphere>,
    index: OnceLock<SphereIndex>,
}

impl Spheres {
    pub(crate) fn new(list: Vec<Sphere>) -> Spheres {
        Spheres { list, index: OnceLock::new() }
    }

    pub(crate) fn list(&self) -> &[Sphere] {
        &self.list
    }

    /// The index; `None` of fewer than [`INDEX_FROM`].
    pub(crate) fn index(&self) -> Option<&SphereIndex> {
        if self.list.len() < INDEX_FROM {
            return None;
        }
        // Made before the cell is entered: who waited for a cell while its index is made by the same
        // threads that wait could wait for ever. At worst two are made, and one is used.
        if self.index.get().is_none() {
            let _ = self.index.set(SphereIndex::new(&self.list));
        }
        self.index.get()
    }

    /// Puts a checked sphere in place of another one.
    pub(crate) fn replace(&mut self, index: u32, sphere: Sphere) {
        self.list[index as usize] = sphere;
        if let Some(known) = self.index.get_mut() {
            known.replace(index, &sphere);
        }
    }
}

impl PartialEq for Spheres {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}

impl fmt::Debug for Spheres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.list.fmt(f)
    }
}
