//! Tests of PNG and GIF files: what an image viewer reads from written ones, and which are refused.

use std::path::Path;

use pinhole_core::ImageSize;
use pinhole_exchange::answers;
use pinhole_exchange::images::gif;
use pinhole_exchange::images::png;

#[test]
fn a_picture_says_that_it_is_srgb() {
    let mut picture = Vec::new();
    png::encode(&mut picture, [1, 1], &[[200, 100, 50, 255]], true).unwrap();
    assert!(picture.windows(4).any(|bytes| bytes == b"sRGB"));
}

/// Returns the frames of a GIF as a viewer shows them, and their durations in hundredths of a second.
fn shown(bytes: &[u8]) -> (Vec<Vec<[u8; 3]>>, Vec<u16>) {
    let mut options = ::gif::DecodeOptions::new();
    options.set_color_output(::gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let count = usize::from(decoder.width()) * usize::from(decoder.height());
    let (mut screen, mut frames, mut delays) = (vec![[0; 3]; count], Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        for (shown, pixel) in screen.iter_mut().zip(frame.buffer.chunks_exact(4)) {
            if pixel[3] == 255 {
                *shown = [pixel[0], pixel[1], pixel[2]];
            }
        }
        frames.push(screen.clone());
        delays.push(frame.delay);
    }
    (frames, delays)
}

fn animated(frames: &[Vec<[u8; 4]>], size: [u32; 2], per_second: u16) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut animation = gif::Animated::new(&mut bytes, size, per_second, true).unwrap();
    frames.iter().for_each(|frame| animation.push(frame).unwrap());
    animation.finish().unwrap();
    bytes
}

#[test]
fn a_gif_of_few_colours_has_each_of_them_and_keeps_the_pace() {
    // 240 colours, half of which change from frame to frame; the last frame equals the one before it.
    let pixel = |k: u32, frame: u32| [(k % 120) as u8, (k % 60) as u8, frame as u8, 255];
    let frame = |frame: u32| (0..600).map(|k| pixel(k, if k < 300 { frame } else { 9 })).collect();
    let frames: Vec<Vec<[u8; 4]>> = [0, 1, 2, 2].map(frame).to_vec();
    let (shown, delays) = shown(&animated(&frames, [30, 20], 30));
    let rgb = |frame: &Vec<[u8; 4]>| frame.iter().map(|p| [p[0], p[1], p[2]]).collect();
    let expected: Vec<Vec<[u8; 3]>> = frames.iter().map(rgb).collect();
    assert!(shown == expected, "{:?}, {:?}", &shown[0][..9], &expected[0][..9]);
    assert_eq!(delays, [3, 3, 4, 3]);
}

#[test]
fn a_gif_of_many_colours_is_close_to_each_of_them() {
    let [width, height] = [160_u32, 120];
    let pixel = |k: u32| [(k % width) as u8, (2 * (k / width)) as u8, 128, 255];
    let frame: Vec<[u8; 4]> = (0..width * height).map(pixel).collect();
    let (shown, _) = shown(&animated(std::slice::from_ref(&frame), [width, height], 10));
    let off = |(a, b): (&[u8; 3], &[u8; 4])| (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap();
    let largest = shown[0].iter().zip(&frame).map(off).max().unwrap();
    assert!(largest <= 24, "{largest}");
}

#[test]
fn a_gif_that_cannot_be_is_refused() {
    for (size, per_second) in [([70_000, 1], 10), ([1, 1], 51), ([1, 1], 0)] {
        assert!(gif::Animated::new(Vec::new(), size, per_second, true).is_err());
    }
    let mut animation = gif::Animated::new(Vec::new(), [2, 2], 10, true).unwrap();
    assert!(animation.push(&[[0; 4]; 3]).is_err());
}

/// Nothing follows the heads of these pictures.
#[test]
fn a_picture_of_another_size_is_refused_by_its_head() {
    let mut picture = Vec::new();
    png::encode(&mut picture, [16_384, 1], &[[0; 4]; 16_384], true).unwrap();
    let image = ImageSize::new(40, 30).unwrap();
    let refused =
        |bytes: &[u8]| answers::parse(Path::new("in"), bytes, image, 0).unwrap_err().to_string();
    let told =
        "in: the picture has 16384 x 1 pixels: it must have 40 x 30, as the scene's image has";
    assert_eq!(refused(&picture[..33]), told);
    let told = "in: cannot be read as PNG: the picture ends too early: is all of the file there?";
    assert_eq!(refused(&picture[..30]), told);
}
