//! Pictures as PNG: what a viewer is told of their colours.

use pinhole_exchange::images::png::{Animated, encode_transparent};

/// Returns true where the file has a chunk of this name.
fn has_chunk(png: &[u8], name: &[u8; 4]) -> bool {
    png.windows(4).any(|bytes| bytes == name)
}

#[test]
fn a_picture_and_an_animation_say_that_they_are_srgb() {
    let pixel = [[200, 100, 50, 255]];
    let mut picture = Vec::new();
    encode_transparent(&mut picture, 1, 1, &pixel).unwrap();
    let mut animation = Vec::new();
    let mut frames = Animated::new(&mut animation, [1, 1], (1, 24), true, true).unwrap();
    frames.push(&pixel).unwrap();
    frames.finish().unwrap();
    assert!(has_chunk(&picture, b"sRGB"));
    assert!(has_chunk(&animation, b"sRGB") && has_chunk(&animation, b"acTL"));
}
