//! The memory of a view's pictures, used again: new memory costs as much as painting it.

use std::sync::Arc;

use egui::{Color32, ColorImage};

use super::blank;
use super::derived::Shown;
use crate::view::overlay::Drawing;

/// Most pictures of a view that are in use at a time: one is painted while the window still shows
/// the last, and its texture may be on the way.
const MOST: usize = 3;

/// The last pictures of a view, of which those that nobody shows any more lend their memory.
#[derive(Debug, Default)]
pub(super) struct Buffers(Vec<Arc<ColorImage>>);

impl Buffers {
    /// Returns pixels for a picture; all of them are still to be painted.
    pub(super) fn take(&mut self, size: [u32; 2]) -> Vec<Color32> {
        let size_in_dots = size.map(|n| n as usize);
        let is_free =
            |image: &Arc<ColorImage>| image.size == size_in_dots && Arc::strong_count(image) == 1;
        let free = self.0.iter().position(is_free).map(|index| self.0.swap_remove(index));
        match free.and_then(Arc::into_inner) {
            Some(image) => image.pixels,
            None => blank(size),
        }
    }

    /// Returns a view of `size` pixels, and remembers its memory.
    pub(super) fn shown(
        &mut self,
        size: [u32; 2],
        pixels: Vec<Color32>,
        drawing: Drawing,
    ) -> Shown {
        let shown = Shown::new(size, pixels, drawing);
        if self.0.len() == MOST {
            self.0.remove(0);
        }
        self.0.push(Arc::clone(&shown.image));
        shown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_used_again_once_nobody_shows_it() {
        let mut buffers = Buffers::default();
        let mark = Color32::from_rgb(1, 2, 3);
        let shown = buffers.shown([4, 3], vec![mark; 12], Drawing::default());
        assert_eq!(buffers.take([4, 3]), [Color32::BLACK; 12], "it is still shown");
        drop(shown);
        assert_eq!(buffers.take([5, 3]), [Color32::BLACK; 15], "another size");
        assert_eq!(buffers.take([4, 3]), [mark; 12]);
    }
}
