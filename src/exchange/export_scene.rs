//! A scene to export to other programs and languages: the camera with its basis, and the objects.

use pinhole_core::arithmetic::{length, unit};
use pinhole_core::{
    Basis, Camera, DVec3, Object, Orientation, OrientationKind, Plane, ResolvedCamera, Rgb, Scene,
};

use crate::document::Document;

/// The objects to export with the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Include {
    /// No objects.
    CameraAlone,
    /// The objects that the format supports.
    #[default]
    Objects,
    /// The objects that the format supports, and meshes in place of the others.
    Meshes,
}

/// A scene to export.
#[derive(Clone, Debug)]
pub struct ExportScene<'a> {
    /// The scene.
    pub document: &'a Document,
    /// The objects to export with the camera.
    pub include: Include,
    /// The objects, spheres first; empty if no objects were requested.
    pub(crate) objects: Vec<ExportObject>,
    resolved: ResolvedCamera,
}

/// A sphere or plane with its title and colour.
#[derive(Clone, Debug)]
pub(crate) struct ExportObject {
    pub(crate) shape: Object,
    pub(crate) color: Rgb,
    pub(crate) title: String,
}

/// Maximum difference from 1 of the aspect ratio of a pixel that counts as square: a few rounding
/// errors.
const SQUARE: f64 = 1e-14;

impl<'a> ExportScene<'a> {
    /// Creates the scene from a document. Its camera must have a basis.
    ///
    /// # Errors
    /// Returns an error if the camera, or a requested object, is invalid.
    pub fn new(document: &'a Document, include: Include) -> Result<ExportScene<'a>, String> {
        let resolved = document.camera.resolve().map_err(|error| error.to_string())?;
        let scene = match include {
            Include::CameraAlone => Scene::default(),
            _ => document.scene().map_err(|error| error.to_string())?,
        };
        let object = |(k, shape): (usize, Object)| ExportObject {
            shape,
            color: document.color_of(k as u32),
            title: document.title_of(k),
        };
        let objects = scene.objects().enumerate().map(object).collect();
        Ok(ExportScene { document, include, objects, resolved })
    }

    /// Returns the camera with its basis.
    pub fn resolve(&self) -> &ResolvedCamera {
        &self.resolved
    }

    /// Returns the planes with their titles.
    pub(crate) fn planes(&self) -> impl Iterator<Item = (&Plane, &str)> {
        self.objects.iter().filter_map(|object| match &object.shape {
            Object::Plane(plane) => Some((plane, &*object.title)),
            Object::Sphere(_) => None,
        })
    }

    /// Returns vectors at and up that describe the camera, even if its orientation is given in another
    /// way.
    pub(crate) fn look_at(&self) -> Result<[DVec3; 2], String> {
        let camera = self.document.camera.given_by(OrientationKind::At);
        let Basis { u, v, .. } = *self.resolved.basis();
        let keeps_u = |camera: &Camera| {
            camera.resolve().is_ok_and(|other| (other.basis().u - u).abs().max_element() < 1e-12)
        };
        match camera.map(|camera| (camera.orientation, keeps_u(&camera))) {
            // Where up is nearly parallel to the view, the rounding of at would roll the camera.
            Ok((Orientation::At { at, up }, keeps_u)) => Ok([at, if keeps_u { up } else { v }]),
            _ => Err(
                "eye is so far out that no point ahead of it keeps the direction: move the scene \
                      nearer to the origin"
                    .to_owned(),
            ),
        }
    }

    /// Returns the ratio of a pixel's width to its height in world units. It is exactly 1 if it differs
    /// from 1 only by rounding errors.
    pub(crate) fn pixel_shape(&self) -> f64 {
        let (viewport, image) = (self.resolved.viewport(), self.resolved.image());
        let shape = (viewport.width / f64::from(image.width()))
            / (viewport.height / f64::from(image.height()));
        if (shape - 1.0).abs() <= SQUARE { 1.0 } else { shape }
    }

    /// Returns the near and far clipping distances, for programs that clip.
    pub(crate) fn clip(&self) -> (f64, f64) {
        let spheres = self.objects.iter().filter_map(|object| match object.shape {
            Object::Sphere(sphere) => {
                Some((length(sphere.center - self.resolved.eye()), sphere.radius))
            }
            Object::Plane(_) => None,
        });
        let far = spheres.clone().map(|(away, radius)| away + radius).fold(1e4, f64::max);
        let gaps = spheres.map(|(away, radius)| (away - radius).abs()).filter(|gap| *gap > 0.0);
        let near = gaps.map(|gap| 0.25 * gap).fold(0.01, f64::min).max(1e-6 * far.min(1e4));
        (near, if far > 1e4 { 2.0 * far } else { far })
    }

    /// Returns the square that represents a plane in programs without infinite planes: its centre, half
    /// its side length, and two unit vectors along its sides.
    pub(crate) fn square_of(&self, plane: &Plane) -> (DVec3, f64, [DVec3; 2]) {
        let normal = unit(plane.normal);
        let height = (self.resolved.eye() - plane.point).dot(normal);
        let middle = self.resolved.eye() - height * normal;
        let basis = normal.any_orthonormal_pair();
        let reach = length(self.resolved.eye() - plane.point).max(1.0);
        // Half the side is a power of ten, and at least a thousand times the distance from the eye to
        // the plane's point.
        (middle, 10_f64.powf((1e3 * reach).log10().ceil()), [basis.0, basis.1])
    }
}
