//! The scene that is exported: the camera, and the scene's objects if they are requested.

use std::fmt;

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{
    Camera, DVec3, Intrinsics, Orientation, OrientationKind, Plane, ResolvedCamera, Rgb, Scene,
    Sphere, Viewport,
};

use crate::document::Document;
use crate::format::n;

/// The reason why a format cannot express a scene, and what would have to change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Unsupported {}

/// Objects that go with the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Include {
    /// None.
    CameraAlone,
    /// The objects that the format has.
    #[default]
    Objects,
    /// Objects that the format has, and meshes instead of the others.
    Meshes,
}

/// A scene that is exported.
#[derive(Clone, Debug)]
pub struct ExportScene<'a> {
    /// The scene.
    pub document: &'a Document,
    /// Objects that go with the camera.
    pub include: Include,
    /// The spheres, where objects are asked for.
    pub(crate) spheres: Vec<ExportObject<Sphere>>,
    /// The planes, where objects are asked for.
    pub(crate) planes: Vec<ExportObject<Plane>>,
    resolved: ResolvedCamera,
}

/// A sphere or plane with its looks.
#[derive(Clone, Debug)]
pub(crate) struct ExportObject<S> {
    pub(crate) shape: S,
    pub(crate) color: Rgb,
    pub(crate) title: String,
}

/// Largest difference from 1 of an aspect ratio that counts as square: a few rounding errors.
const SQUARE: f64 = 1e-14;

impl<'a> ExportScene<'a> {
    /// Creates the scene from a document whose camera has a basis.
    ///
    /// # Errors
    /// Returns the fault of the camera, or of an object that is asked for.
    pub fn new(document: &'a Document, include: Include) -> Result<ExportScene<'a>, Unsupported> {
        let resolved = document.camera.resolve().map_err(|error| Unsupported(error.to_string()))?;
        let scene = match include {
            Include::CameraAlone => Scene::default(),
            _ => document.scene().map_err(|error| Unsupported(error.to_string()))?,
        };
        let spheres = export_objects(document, 0, scene.spheres());
        let planes = export_objects(document, scene.spheres().len(), scene.planes());
        Ok(ExportScene { document, include, spheres, planes, resolved })
    }

    /// The camera with its basis.
    pub fn resolve(&self) -> &ResolvedCamera {
        &self.resolved
    }

    pub(crate) fn camera(&self) -> &Camera {
        &self.document.camera
    }

    pub(crate) fn viewport(&self) -> &Viewport {
        self.resolved.viewport()
    }

    /// W and H.
    pub(crate) fn size(&self) -> [u32; 2] {
        [self.resolved.image().width(), self.resolved.image().height()]
    }

    pub(crate) fn intrinsics(&self) -> Intrinsics {
        Intrinsics::from_viewport(self.viewport(), self.resolved.image())
    }

    /// The vertical field of view in degrees.
    pub(crate) fn vertical_degrees(&self) -> f64 {
        self.viewport().vertical_fov().to_degrees()
    }

    /// Eye, at and up.
    pub(crate) fn look_at(&self) -> Result<[DVec3; 3], Unsupported> {
        let camera = self.camera().given_by(OrientationKind::At);
        match camera.map(|camera| (camera.eye, camera.orientation)) {
            Ok((eye, Orientation::At { at, up })) => Ok([eye, at, up]),
            _ => Err(Unsupported(
                "eye is so far out that no point ahead of it keeps the direction: move the scene \
                 nearer to the origin"
                    .to_owned(),
            )),
        }
    }

    /// Returns a pixel's width divided by its height in the world; exactly 1 if it differs only by rounding.
    pub(crate) fn pixel_shape(&self) -> f64 {
        let [width, height] = self.size().map(f64::from);
        let viewport = self.viewport();
        let shape = (viewport.width / width) / (viewport.height / height);
        if (shape - 1.0).abs() <= SQUARE { 1.0 } else { shape }
    }

    /// Refuses pixels that are not square.
    pub(crate) fn square_pixels(&self, program: &str) -> Result<(), Unsupported> {
        let shape = self.pixel_shape();
        if shape == 1.0 {
            return Ok(());
        }
        let [width, height] = self.size();
        let viewport = self.viewport();
        Err(Unsupported(format!(
            "pixels are {} times as wide as high, and {program} has square ones only: make the \
             viewport's width / height, {} / {}, the image's {width} / {height}",
            n((shape * 1e6).round() / 1e6),
            n(viewport.width),
            n(viewport.height),
        )))
    }

    /// Returns the note about objects that a format cannot contain, if there are any.
    pub(crate) fn objects_left_out(&self, why: &str) -> Option<String> {
        let is_empty = self.spheres.is_empty() && self.planes.is_empty();
        (!is_empty).then(|| format!("objects are left out: {why}"))
    }

    /// Returns the near and far distances for programs that clip.
    pub(crate) fn clip(&self) -> (f64, f64) {
        let eye = self.resolved.eye();
        let spheres = &self.spheres;
        let reach = |s: &ExportObject<Sphere>| length(s.shape.center - eye) + s.shape.radius;
        let far = spheres.iter().map(reach).fold(1e4, f64::max);
        let gap = |s: &ExportObject<Sphere>| (length(s.shape.center - eye) - s.shape.radius).abs();
        let gaps = spheres.iter().map(gap).filter(|gap| *gap > 0.0);
        let near = gaps.map(|gap| 0.25 * gap).fold(0.01, f64::min).max(1e-6 * far.min(1e4));
        (near, if far > 1e4 { 2.0 * far } else { far })
    }

    /// Returns a square that replaces the plane in programs without infinite planes: its centre, half its side,
    /// and two unit vectors along its sides.
    pub(crate) fn square_of(&self, plane: &Plane) -> (DVec3, f64, [DVec3; 2]) {
        let normal = unit(plane.normal);
        let height = (self.resolved.eye() - plane.point).dot(normal);
        let middle = self.resolved.eye() - height * normal;
        let basis = normal.any_orthonormal_pair();
        let reach = length(self.resolved.eye() - plane.point).max(1.0);
        // A power of ten, at least a thousand times as far as anything visible.
        (middle, 10_f64.powf((1e3 * reach).log10().ceil()), [basis.0, basis.1])
    }
}

/// Returns the objects with their colours and titles; the first one has the index `first`.
fn export_objects<S: Copy>(
    document: &Document,
    first: usize,
    shapes: &[S],
) -> Vec<ExportObject<S>> {
    let object = |(k, shape): (usize, &S)| ExportObject {
        shape: *shape,
        color: document.color_of((first + k) as u32),
        title: document.title_of(first + k),
    };
    shapes.iter().enumerate().map(object).collect()
}

/// Returns the note about a square that replaces a plane.
pub(crate) fn square_note(title: &str, program: &str, half: f64) -> String {
    format!(
        "{title} is infinite, and {program} has no infinite plane: written as a square that reaches {} \
         to each side, so that the horizon is a little lower",
        n(half)
    )
}
