//! What a test asks of the page, to hold it against the program on the desktop.

use std::path::Path;

use pinhole_exchange::scene_file;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::digest;

/// Returns the digest of a scene's picture, in hexadecimal digits.
///
/// # Errors
/// Returns a reason if the scene cannot be read or traced.
#[wasm_bindgen]
pub fn picture_digest(scene: &str) -> Result<String, String> {
    let document = scene_file::parse(scene, Path::new("scene.toml"), Path::new(""));
    let digest = digest::picture_digest(&document.map_err(|error| error.to_string())?)?;
    Ok(format!("{digest:016x}"))
}
