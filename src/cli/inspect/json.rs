//! The readout as one JSON object.

use pinhole_core::{DVec3, Root};
use serde::Serialize;

use super::Readout;

/// Numbers read back to the same `f64`. One beyond its range, such as the distance between two
/// points at its ends, is `null`: JSON has no infinity. The conditioning never is, as the core caps
/// it at the largest `f64`.
#[derive(Serialize)]
pub(super) struct Inspect<'a> {
    camera: Camera,
    pixel: Option<Pixel>,
    uv: [f64; 2],
    ray: Ray,
    hits: Vec<Hit<'a>>,
    first: Option<usize>,
}

#[derive(Serialize)]
struct Camera {
    eye: [f64; 3],
    u: [f64; 3],
    v: [f64; 3],
    w: [f64; 3],
    up_view_angle_deg: f64,
    conditioning: f64,
}

#[derive(Serialize)]
struct Pixel {
    row: u32,
    column: u32,
}

#[derive(Serialize)]
struct Ray {
    origin: [f64; 3],
    direction: [f64; 3],
}

#[derive(Serialize)]
struct Hit<'a> {
    object: &'static str,
    index: u32,
    name: Option<&'a str>,
    t: f64,
    distance: f64,
    point: [f64; 3],
    normal: [f64; 3],
}

impl Readout<'_> {
    pub(super) fn json(&self) -> Inspect<'_> {
        let Readout { camera, up_angle, inspection, .. } = self;
        let basis = camera.basis();
        let hits = inspection.roots.iter().zip(&inspection.distances);
        Inspect {
            camera: Camera {
                eye: array(camera.eye()),
                u: array(basis.u),
                v: array(basis.v),
                w: array(basis.w),
                up_view_angle_deg: up_angle.angle.to_degrees(),
                conditioning: up_angle.conditioning,
            },
            pixel: inspection.pixel().map(|p| Pixel { row: p.row, column: p.column }),
            uv: inspection.uv.to_array(),
            ray: Ray {
                origin: array(inspection.ray.origin),
                direction: array(inspection.ray.direction),
            },
            hits: hits.map(|(root, distance)| self.hit(root, *distance)).collect(),
            first: inspection.first,
        }
    }

    fn hit(&self, root: &Root, distance: f64) -> Hit<'_> {
        Hit {
            object: self.kind_of(root.object),
            index: root.object,
            name: self.document.name_of(root.object),
            t: root.t,
            distance,
            point: array(root.point),
            normal: array(root.normal),
        }
    }
}

/// Readers expect no negative zero.
fn array(v: DVec3) -> [f64; 3] {
    (v + DVec3::ZERO).to_array()
}
