//! The remembered place and size of the window.

/// The position and size of the window.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct WindowGeometry {
    /// Size of the window's content.
    pub inner_size: [f32; 2],
    /// Top left corner of the window's frame; `None` lets the desktop choose.
    pub position: Option<[f32; 2]>,
    /// True if the window is maximised.
    pub maximized: bool,
    /// Pixels per point of the screen that the window was on.
    pub scale: f32,
}

impl Default for WindowGeometry {
    fn default() -> Self {
        Self { inner_size: [1280.0, 800.0], position: None, maximized: false, scale: 1.0 }
    }
}

impl WindowGeometry {
    /// Returns the scale of the screen, within what screens have.
    pub fn screen_scale(&self) -> f32 {
        self.scale.clamp(0.5, 8.0)
    }

    /// Takes over the window's present place and size. Called each frame, so that it holds the
    /// geometry to save on exit. Ignores the size and place of a maximised, minimised or
    /// full-screen window, so that the normal ones are kept.
    pub fn update(&mut self, ctx: &egui::Context) {
        let zoom = ctx.zoom_factor();
        ctx.input(|input| {
            let viewport = input.viewport();
            if viewport.minimized == Some(true) || viewport.fullscreen == Some(true) {
                return;
            }
            self.maximized = viewport.maximized == Some(true);
            self.scale = viewport.native_pixels_per_point.unwrap_or(self.scale);
            if self.maximized {
                return;
            }
            // Wayland reports no position, and then neither rectangle.
            let size = viewport.inner_rect.map_or(input.viewport_rect().size(), |r| r.size());
            if size.x >= 1.0 && size.y >= 1.0 {
                self.inner_size = [size.x * zoom, size.y * zoom];
            }
            self.position = viewport.outer_rect.map(|r| [r.min.x * zoom, r.min.y * zoom]);
        });
    }
}
