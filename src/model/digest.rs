//! A digest of a picture, by which a test holds a page against the program on the desktop.

use pinhole_core::{Outputs, Raster, trace};
use pinhole_exchange::document::Document;

/// Returns the FNV-1a digest of the object and the bits of t of every pixel of the document's picture, row by
/// row.
///
/// # Errors
/// Returns a reason if the camera or the scene is invalid.
pub fn picture_digest(document: &Document) -> Result<u64, String> {
    let scene = document.scene().map_err(|error| error.to_string())?;
    let camera = document.camera.resolve().map_err(|error| error.to_string())?;
    let frame = trace(&scene, &camera, &Raster::full(document.camera.image), Outputs::default());
    let pixels = frame.object.iter().zip(&frame.t);
    let bytes = pixels
        .flat_map(|(object, t)| object.to_le_bytes().into_iter().chain(t.to_bits().to_le_bytes()));
    let add = |digest: u64, byte| (digest ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    Ok(bytes.fold(0xcbf2_9ce4_8422_2325, add))
}
