//! Caches that hold one value, for the last input. Also reuses a view's image buffers, because allocating
//! new memory costs as much as painting into it.

use std::sync::Arc;

use egui::{Color32, ColorImage};

use crate::view::adaptive_resolution::Subsampling;
use crate::view::derive::{OnWork, Shown, WorkKind, watched};
use crate::view::overlay::{Drawing, Style};

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

/// Maximum number of images of a view that are in use at a time: one is being painted, one is shown by the
/// window, and one may be uploading as a texture.
const MOST: usize = 3;

/// The last images of a view, whose buffers are reused once they are no longer shown.
#[derive(Debug, Default)]
pub(super) struct SpareImages(Vec<Arc<ColorImage>>);

impl SpareImages {
    /// Returns a buffer of pixels with arbitrary contents; the caller must paint every pixel.
    fn take(&mut self, size: [u32; 2]) -> Vec<Color32> {
        let size_in_dots = size.map(|n| n as usize);
        let is_free =
            |image: &Arc<ColorImage>| image.size == size_in_dots && Arc::strong_count(image) == 1;
        let free = self.0.iter().position(is_free).map(|index| self.0.swap_remove(index));
        match free.and_then(Arc::into_inner) {
            Some(image) => image.pixels,
            None => vec![Color32::BLACK; size_in_dots.iter().product()],
        }
    }

    /// Returns an image of `size` pixels that `draw` has painted. Keeps a reference to it, so that its
    /// buffer can be reused later.
    pub(super) fn draw(
        &mut self,
        size: [u32; 2],
        style: Style,
        watch: OnWork<'_>,
        draw: impl FnOnce(&mut [Color32]) -> Drawing,
    ) -> Shown {
        watched(watch, WorkKind::Overlay, || {
            let mut pixels = self.take(size);
            let drawing = draw(&mut pixels);
            style.finish(&mut pixels);
            let shown = Shown {
                image: Arc::new(ColorImage::new(size.map(|n| n as usize), pixels)),
                labels: Arc::new(drawing.labels),
                marks: Arc::new(drawing.marks),
                spheres: Arc::new(drawing.spheres),
            };
            if self.0.len() == MOST {
                self.0.remove(0);
            }
            self.0.push(Arc::clone(&shown.image));
            shown
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_used_again_once_nobody_shows_it() {
        let mut buffers = SpareImages::default();
        let mark = Color32::from_rgb(1, 2, 3);
        let shown = buffers.draw([4, 3], Style::Light, &|_| (), |pixels| {
            pixels.fill(mark);
            Drawing::default()
        });
        assert_eq!(buffers.take([4, 3]), [Color32::BLACK; 12], "it is still shown");
        drop(shown);
        assert_eq!(buffers.take([5, 3]), [Color32::BLACK; 15], "another size");
        assert_eq!(buffers.take([4, 3]), [mark; 12]);
    }
}
