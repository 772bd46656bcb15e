//! Caches that hold the value of the last input.

use std::sync::Arc;

use crate::view::adaptive_resolution::Subsampling;

/// A value with the key it was made from.
#[derive(Debug)]
pub(super) struct Memo<K, V>(Option<(K, V)>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Memo(None)
    }
}

impl<K: PartialEq, V: Clone> Memo<K, V> {
    /// Returns the value made from `key`; it is made again only if the key differs from the last
    /// one.
    pub(super) fn get(&mut self, key: K, make: impl FnOnce(&K) -> V) -> V {
        if let Some(value) = self.known(|known| *known == key) {
            return value.clone();
        }
        let value = make(&key);
        self.0 = Some((key, value.clone()));
        value
    }
}

impl<K: PartialEq, V> Memo<K, V> {
    /// Takes the cached value out, unless it was made from `key`.
    pub(super) fn take_other(&mut self, key: &K) -> Option<V> {
        self.0.take_if(|(known, _)| known != key).map(|(_, value)| value)
    }
}

impl<K, V> Memo<K, V> {
    /// Returns the cached value if it was made from a key that `is_same`.
    pub(super) fn known(&self, is_same: impl FnOnce(&K) -> bool) -> Option<&V> {
        self.0.as_ref().filter(|(key, _)| is_same(key)).map(|(_, value)| value)
    }
}

/// A part of a key that compares by identity: it equals only the very same value.
#[derive(Debug)]
pub(super) struct Same<T>(pub(super) Arc<T>);

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Same<T>) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// The subsampling of a picture of something: a coarser picture never replaces a finer one.
#[derive(Debug)]
pub(super) struct Fineness<K>(Option<(K, Subsampling)>);

impl<K> Default for Fineness<K> {
    fn default() -> Self {
        Fineness(None)
    }
}

impl<K: PartialEq> Fineness<K> {
    /// Returns the subsampling to use: the wanted one, or a finer one if there already was one.
    pub(super) fn at_most(&mut self, key: K, wanted: Subsampling) -> Subsampling {
        let known = self.0.as_ref().filter(|(known, _)| *known == key);
        let subsampling = known.map_or(wanted, |(_, known)| wanted.min(*known));
        self.0 = Some((key, subsampling));
        subsampling
    }
}
