//! The spheres that nothing covers or cuts: in a figure, their edges are curves rather than pixels.

use pinhole_core::{Ellipse, Scene, Sphere};

use crate::overlay::{ASKED_SPHERES, Layers, WorldView, silhouette};

/// Minimum length of the shorter semi-axis of such a sphere's outline, in pixels.
const LEAST: f64 = 8.0;

impl WorldView {
    /// Returns the outlines of these spheres.
    pub(super) fn uncovered(&self, scene: &Scene, layers: &Layers<'_>) -> Vec<Ellipse> {
        let spheres = (0..).zip(scene.spheres()).take(ASKED_SPHERES);
        spheres.filter_map(|(index, sphere)| self.outline_of(index, sphere, layers)).collect()
    }

    fn outline_of(&self, index: u32, sphere: &Sphere, layers: &Layers<'_>) -> Option<Ellipse> {
        let (camera, screen) = (self.frame.camera(), self.screen());
        let size = [camera.image().width() as usize, camera.image().height() as usize];
        let outline = Ellipse::outline_of(camera, sphere)?;
        let is_large = outline.axes.iter().all(|axis| axis.length() >= LEAST);
        let shows =
            |(pixel, at)| outline.distance(at).0 > -1.0 || self.frame.object[pixel] == index;
        let rim = silhouette(sphere, camera.eye())?;
        let mut spots = rim.into_iter().filter_map(|point| screen.spot(point));
        let is_uncovered = is_large
            && outline.pixels(size, 0.0).all(shows)
            && spots.all(|spot| !layers.is_behind_layer(spot.at, 1.0 / spot.inverse_t, false));
        is_uncovered.then_some(outline)
    }
}
