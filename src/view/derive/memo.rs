//! Caches that hold one value, for the last input, and that use the memory of older values again.

use std::sync::Arc;

use egui::{Color32, ColorImage};
use pinhole_figure::overlay::{Drawing, Style};

use crate::view::adaptive_resolution::Subsampling;
use crate::view::derive::{FinishedView, OnWork, WorkKind, watched};

/// A cache of the last value that was computed, and of the key (the inputs) from which it was computed.
#[derive(Debug)]
pub(super) struct Memo<K, V>(Option<(K, V)>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Memo(None)
    }
}

impl<K: PartialEq, V: Clone> Memo<K, V> {
    /// Returns the value for `key`. Calls `make` only if `key` differs from the last key.
    pub(super) fn get(&mut self, key: K, make: impl FnOnce(&K) -> V) -> V {
        if let Some(value) = self.known(|known| *known == key) {
            return value.clone();
        }
        let value = make(&key);
        self.0 = Some((key, value.clone()));
        value
    }

    /// Removes and returns the cached value if it belongs to another key than `key`.
    pub(super) fn take_other(&mut self, key: &K) -> Option<V> {
        self.0.take_if(|(known, _)| known != key).map(|(_, value)| value)
    }
}

impl<K, V> Memo<K, V> {
    /// Returns the cached value if `is_same` returns true for its key.
    pub(super) fn known(&self, is_same: impl FnOnce(&K) -> bool) -> Option<&V> {
        self.0.as_ref().filter(|(key, _)| is_same(key)).map(|(_, value)| value)
    }
}

impl<K: PartialEq> Memo<K, Subsampling> {
    /// Returns the subsampling to trace with: `wanted` or, if it is finer, the one last used for this key.
    /// A coarser picture thus never replaces a finer one.
    pub(super) fn at_most(&mut self, key: K, wanted: Subsampling) -> Subsampling {
        let subsampling =
            self.known(|known| *known == key).map_or(wanted, |known| wanted.min(*known));
        self.0 = Some((key, subsampling));
        subsampling
    }
}

/// The last N values of a cache. The memory of one that is no longer in use is used again, because computing
/// into newly allocated memory takes twice as long.
#[derive(Debug)]
pub(super) struct Spares<T, const N: usize>(Vec<Arc<T>>);

impl<T, const N: usize> Default for Spares<T, N> {
    fn default() -> Self {
        Spares(Vec::new())
    }
}

impl<T, const N: usize> Spares<T, N> {
    /// Takes the oldest value that only this cache still refers to, and for which `fits` returns true.
    pub(super) fn take(&mut self, fits: impl Fn(&T) -> bool) -> Option<T> {
        let free = self.0.iter().position(|kept| Arc::strong_count(kept) == 1 && fits(kept))?;
        Arc::into_inner(self.0.remove(free))
    }

    /// Keeps a value that is in use now, unless it is the one kept last.
    pub(super) fn keep(&mut self, value: &Arc<T>) {
        if !self.0.last().is_some_and(|last| Arc::ptr_eq(last, value)) {
            self.0.push(Arc::clone(value));
            self.0.drain(..self.0.len().saturating_sub(N));
        }
    }
}

/// A cache of the last finished view, and the view's last images, whose buffers are reused once they are no
/// longer shown. Three are in use at a time: one is being painted, one is shown by the window, and one may be
/// uploading as a texture.
#[derive(Debug)]
pub(super) struct LastView<V> {
    last: Memo<V, FinishedView>,
    images: Spares<ColorImage, 3>,
}

impl<V> Default for LastView<V> {
    fn default() -> Self {
        LastView { last: Memo::default(), images: Spares::default() }
    }
}

impl<V: PartialEq> LastView<V> {
    /// Returns an image of `size` pixels that `draw` has painted, with its drawing. Calls `draw`, which must
    /// paint every pixel of a buffer with arbitrary contents, only if `view` differs from the last one.
    pub(super) fn get(
        &mut self,
        view: V,
        size: [u32; 2],
        style: Style,
        watch: OnWork<'_>,
        draw: impl FnOnce(&V, &mut [Color32]) -> Drawing,
    ) -> FinishedView {
        let size = size.map(|n| n as usize);
        self.last.get(view, |view| {
            watched(watch, WorkKind::Overlay, || {
                let spare = self.images.take(|image| image.size == size);
                let mut pixels = spare.map_or(Vec::new(), |image| image.pixels);
                pixels.resize(size.iter().product(), Color32::BLACK);
                let drawing = draw(view, &mut pixels);
                style.finish(&mut pixels);
                let shown = FinishedView {
                    image: Arc::new(ColorImage::new(size, pixels)),
                    labels: Arc::new(drawing.labels),
                    marks: Arc::new(drawing.marks),
                    spheres: Arc::new(drawing.spheres),
                };
                self.images.keep(&shown.image);
                shown
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_used_again_once_nobody_shows_it() {
        let mut views = LastView::default();
        let mark = Color32::from_rgb(1, 2, 3);
        let mut found = |view: u32, size| {
            let mut before = Vec::new();
            let shown = views.get(view, size, Style::Light, &|_| (), |_, pixels| {
                before = pixels.to_vec();
                pixels.fill(mark);
                Drawing::default()
            });
            (before, shown)
        };
        let (_, shown) = found(0, [4, 3]);
        let (before, _) = found(1, [4, 3]);
        assert_eq!(before, [Color32::BLACK; 12], "it is still shown");
        drop(shown);
        assert_eq!(found(2, [5, 3]).0, [Color32::BLACK; 15], "another size");
        assert_eq!(found(3, [4, 3]).0, [mark; 12]);
    }
}
