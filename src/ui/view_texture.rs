//! The texture that shows a view's pixels on the screen.

use std::sync::Arc;

use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

/// The texture of one view, uploaded only when its image changes.
#[derive(Default)]
pub(crate) struct ViewTexture {
    texture: Option<TextureHandle>,
    uploaded: Option<Arc<ColorImage>>,
}

impl ViewTexture {
    /// Returns the texture that holds `image`.
    pub(crate) fn of(&mut self, ctx: &Context, image: &Arc<ColorImage>) -> TextureId {
        // Nearest: one texel is one physical pixel, and a picture's pixels keep sharp edges.
        let options = TextureOptions::NEAREST;
        let known = self.uploaded.as_ref().is_some_and(|known| Arc::ptr_eq(known, image));
        match &mut self.texture {
            Some(texture) if known => texture.id(),
            Some(texture) => {
                // A partial update of the same size avoids a reallocation.
                if texture.size() == image.size {
                    texture.set_partial([0, 0], Arc::clone(image), options);
                } else {
                    texture.set(Arc::clone(image), options);
                }
                self.uploaded = Some(Arc::clone(image));
                texture.id()
            }
            None => {
                let texture = ctx.load_texture("view", Arc::clone(image), options);
                self.uploaded = Some(Arc::clone(image));
                self.texture.insert(texture).id()
            }
        }
    }
}
