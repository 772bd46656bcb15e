//! Tests of other programs' cameras: of writing and reading them, of messages for invalid texts, and of
//! the exports with the other programs themselves.

mod faults;
mod gltf;
mod literal;
mod other_programs;
mod round_trip;
mod writers;

use std::path::Path;

use pinhole_core::{Camera, DVec3, ImageSize, Orientation, Sphere, Viewport};
use pinhole_exchange::FileError;
use pinhole_exchange::document::{Document, Item};
use pinhole_exchange::format::{ExportScene, Include};
use pinhole_exchange::format::{Exported, Format, Imported, Input};
use pinhole_exchange::programs::Importer;

fn format(name: &str) -> &'static Format {
    Format::named(name).unwrap()
}

fn written(name: &str, document: &Document, with: Include) -> Exported {
    format(name).write(&ExportScene::new(document, with).unwrap()).unwrap()
}

fn text_of(name: &str, document: &Document) -> String {
    written(name, document, Include::Objects).text.text
}

fn read(importer: Importer, text: &str) -> Result<Imported, FileError> {
    importer.read(&Input { path: Path::new("in"), text }, &Camera::CANONICAL)
}

fn scene_of(camera: Camera) -> Document {
    Document { camera, ..Document::default() }
}

fn sphere(center: [f64; 3], radius: f64, color: [u8; 3]) -> Item<Sphere> {
    let shape = Sphere { center: DVec3::from_array(center), radius };
    Item { name: None, color: Some(color), shape }
}

/// Returns four spheres of different sizes and colours whose picture changes if it is mirrored or
/// turned: a large one in the middle, a medium one to its upper right, a small one to its left and
/// nearer, and one to its lower right.
fn marker() -> Vec<Item<Sphere>> {
    vec![
        sphere([0.0, 0.0, 0.0], 1.0, [255, 0, 0]),
        sphere([1.5, 1.1, -0.4], 0.6, [0, 255, 0]),
        sphere([-1.3, 0.3, 0.9], 0.35, [0, 0, 255]),
        sphere([2.2, -1.6, -1.0], 0.5, [255, 255, 0]),
    ]
}

fn camera(eye: [f64; 3], at: [f64; 3], up: [f64; 3], size: [f64; 3], image: [u32; 2]) -> Camera {
    let [width, height, distance] = size;
    Camera {
        eye: eye.into(),
        orientation: Orientation::At { at: at.into(), up: up.into() },
        viewport: Viewport { width, height, distance },
        image: ImageSize::new(image[0], image[1]).unwrap(),
    }
}

/// Returns scenes to export: with a wide image, with a tall one, with a rolled camera in a general
/// position, and with pixels that are not square.
fn proofs() -> Vec<(&'static str, Document)> {
    let cameras = [
        (
            "wide",
            camera([1.0, 2.0, 7.0], [0.2, 0.1, 0.0], [0.0, 1.0, 0.0], [1.6, 0.9, 1.5], [160, 90]),
        ),
        (
            "high",
            camera([-6.0, 1.0, 3.0], [0.0, 0.0, 0.2], [0.1, 1.0, 0.3], [0.6, 0.9, 1.2], [80, 120]),
        ),
        (
            "rolled",
            camera([3.0, -5.0, 4.0], [0.3, 0.0, 0.0], [1.0, 0.2, 0.4], [1.0, 1.0, 1.2], [100, 100]),
        ),
        (
            "not-square",
            camera([0.5, 1.5, -8.0], [0.3, 0.0, 0.0], [0.2, 1.0, 0.0], [0.9, 0.9, 1.4], [140, 70]),
        ),
    ];
    let scene = |camera| Document { camera, spheres: marker().into(), ..Document::default() };
    cameras.into_iter().map(|(name, camera)| (name, scene(camera))).collect()
}
