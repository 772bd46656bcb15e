//! The size of a picture that is asked for.

use pinhole_core::ImageSize;

use super::error::CommandError;

/// Returns the size of a picture; a width or height alone takes the other along, in the ratio of the
/// `usual` size.
///
/// # Errors
/// Returns an error if no image has this size.
pub(super) fn size(
    width: Option<u32>,
    height: Option<u32>,
    usual: [u32; 2],
) -> Result<ImageSize, CommandError> {
    let ratio = f64::from(usual[0]) / f64::from(usual[1]);
    let [width, height] = match (width, height) {
        (None, None) => usual,
        (Some(width), Some(height)) => [width, height],
        (Some(width), None) => [width, follow(width, 1.0 / ratio)],
        (None, Some(height)) => [follow(height, ratio), height],
    };
    ImageSize::new(width, height).map_err(|error| {
        CommandError::Arguments(format!("{error}; give both --width and --height"))
    })
}

/// Returns the other side of a picture, in pixels.
pub(super) fn follow(pixels: u32, ratio: f64) -> u32 {
    (f64::from(pixels) * ratio).round().max(1.0) as u32
}
