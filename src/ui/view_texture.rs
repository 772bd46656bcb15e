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
    pub(crate) fn upload(&mut self, ctx: &Context, image: &Arc<ColorImage>) -> TextureId {
        // Nearest: one texel is one physical pixel, and a picture's pixels keep sharp edges.
        let options = TextureOptions::NEAREST;
        if self.uploaded.as_ref().is_none_or(|uploaded| !Arc::ptr_eq(uploaded, image)) {
            self.uploaded = Some(Arc::clone(image));
            match &mut self.texture {
                // A partial update of the same size avoids a reallocation.
                Some(texture) if texture.size() == image.size => {
                    texture.set_partial([0, 0], Arc::clone(image), options);
                }
                Some(texture) => texture.set(Arc::clone(image), options),
                None => self.texture = Some(ctx.load_texture("view", Arc::clone(image), options)),
            }
        }
        self.texture.as_ref().map(TextureHandle::id).unwrap_or_default()
    }
}
