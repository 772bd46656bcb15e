//! A view's pixels on their way to the screen.

use std::sync::Arc;

use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

/// The texture of one view, uploaded only when its image is another one.
#[derive(Default)]
pub(crate) struct ViewTexture {
    texture: Option<TextureHandle>,
    uploaded: Option<Arc<ColorImage>>,
}

impl ViewTexture {
    /// The texture that holds `image`.
    pub(crate) fn of(&mut self, ctx: &Context, image: &Arc<ColorImage>) -> TextureId {
        // Nearest: one texel is one physical pixel, and a picture's pixels stay pixels.
        let options = TextureOptions::NEAREST;
        let known = self.uploaded.as_ref().is_some_and(|known| Arc::ptr_eq(known, image));
        match &mut self.texture {
            Some(texture) if known => texture.id(),
            Some(texture) => {
                // While the size holds, a part update spares the reallocation.
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
