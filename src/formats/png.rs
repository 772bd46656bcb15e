//! Pictures as PNG.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use png::{BitDepth, ColorType, Encoder, EncodingError, SrgbRenderingIntent};

use super::{FileError, atomic};

/// Writes a picture of `width` x `height` opaque sRGB pixels, row by row from the top, as a whole
/// or not at all.
///
/// # Errors
/// Where the file cannot be written.
pub fn save(path: &Path, width: u32, height: u32, pixels: &[[u8; 4]]) -> Result<(), FileError> {
    atomic::write(path, |file| encode(BufWriter::new(file), width, height, pixels))
}

/// Writes the bytes of such a file.
///
/// # Errors
/// Where `out` does not take them.
pub fn encode(out: impl Write, width: u32, height: u32, pixels: &[[u8; 4]]) -> io::Result<()> {
    encode_as::<3>(ColorType::Rgb, out, width, height, pixels)
}

/// The same with the pixels' opacity; their colours are not premultiplied.
///
/// # Errors
/// Where `out` does not take them.
pub fn encode_transparent(
    out: impl Write,
    width: u32,
    height: u32,
    pixels: &[[u8; 4]],
) -> io::Result<()> {
    encode_as::<4>(ColorType::Rgba, out, width, height, pixels)
}

/// The first `CHANNELS` of each pixel.
fn encode_as<const CHANNELS: usize>(
    color: ColorType,
    out: impl Write,
    width: u32,
    height: u32,
    pixels: &[[u8; 4]],
) -> io::Result<()> {
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(color);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(to_io)?;
    let mut stream = writer.stream_writer().map_err(to_io)?;
    let mut bytes = Vec::new();
    for row in pixels.chunks(width as usize) {
        bytes.clear();
        bytes.extend(row.iter().flat_map(|pixel| &pixel[..CHANNELS]));
        stream.write_all(&bytes)?;
    }
    stream.finish().map_err(to_io)?;
    writer.finish().map_err(to_io)
}

fn to_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
