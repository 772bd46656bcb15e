//! Reads and writes pictures as PNG.

use std::cell::RefCell;
use std::io::{self, Cursor, Write};
use std::path::Path;

use pinhole_core::{ImageSize, Rgb};
use png::{
    BitDepth, ColorType, Decoder, DecodingError, Encoder, SrgbRenderingIntent, Transformations,
};

use crate::FileError;

/// Writes a picture of sRGB pixels, row by row from the top. If `transparent` is true, their opacity is
/// included; otherwise the picture is opaque. Colours are not premultiplied.
///
/// # Errors
/// Returns an error if writing to `out` fails.
pub fn encode(
    out: impl Write,
    size: [u32; 2],
    pixels: &[[u8; 4]],
    transparent: bool,
) -> io::Result<()> {
    encode_rows(out, size, transparent, |write| write(pixels))
}

/// Writes a picture like [`encode`]. `draw` is called with a function that writes the next rows.
///
/// # Errors
/// Returns an error if writing to `out` fails, or the error of `draw`.
pub fn encode_rows(
    out: impl Write,
    [width, height]: [u32; 2],
    transparent: bool,
    draw: impl FnOnce(&mut dyn FnMut(&[[u8; 4]]) -> io::Result<()>) -> io::Result<()>,
) -> io::Result<()> {
    // The encoder passes on the text of an error alone.
    let kept = RefCell::new(None);
    let of_writer = |error| kept.take().unwrap_or_else(|| io::Error::other(error));
    let mut encoder = Encoder::new(KeepsError { out, kept: &kept }, width, height);
    encoder.set_color(if transparent { ColorType::Rgba } else { ColorType::Rgb });
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(of_writer)?;
    let mut stream = writer.stream_writer().map_err(of_writer)?;
    let channels = if transparent { 4 } else { 3 };
    draw(&mut |pixels| {
        pixels.chunks(width as usize).try_for_each(|row| {
            let bytes: Vec<u8> = row.iter().flat_map(|pixel| &pixel[..channels]).copied().collect();
            stream.write_all(&bytes).map_err(|error| of_writer(error.into()))
        })
    })?;
    stream.finish().map_err(of_writer)?;
    writer.finish().map_err(of_writer)
}

/// A writer that keeps its last error.
struct KeepsError<'a, W> {
    out: W,
    kept: &'a RefCell<Option<io::Error>>,
}

impl<W> KeepsError<'_, W> {
    fn keep(&self, error: io::Error) -> io::Error {
        let kind = error.kind();
        self.kept.replace(Some(error));
        kind.into()
    }
}

impl<W: Write> Write for KeepsError<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes).map_err(|error| self.keep(error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush().map_err(|error| self.keep(error))
    }
}

/// A decoded picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// Columns and rows.
    pub size: [u32; 2],
    /// The pixels, row by row from the top, with opacity. Colours are not premultiplied.
    pub pixels: Vec<[u8; 4]>,
}

impl Decoded {
    /// Returns the colours of the picture when it is drawn over an opaque background.
    pub fn over(&self, background: Rgb) -> Vec<Rgb> {
        let mix = |front: u8, back: u8, alpha: u8| {
            let (front, back, alpha) = (u32::from(front), u32::from(back), u32::from(alpha));
            ((front * alpha + back * (255 - alpha) + 127) / 255) as u8
        };
        let over = |[r, g, b, alpha]: &[u8; 4]| {
            let [back_r, back_g, back_b] = background;
            [mix(*r, back_r, *alpha), mix(*g, back_g, *alpha), mix(*b, back_b, *alpha)]
        };
        self.pixels.iter().map(over).collect()
    }
}

/// Returns true if the bytes begin with the signature of PNG.
pub fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG\r\n\x1a\n")
}

/// Decodes any kind of PNG to eight bits per channel. `path` is used in messages. Colours are assumed
/// to be sRGB.
///
/// # Errors
/// Returns an error if the bytes are not a PNG or are damaged, or if the picture is larger than the
/// maximum image size.
pub fn decode(path: &Path, bytes: &[u8]) -> Result<Decoded, FileError> {
    let at_fault = |error: &dyn std::fmt::Display| {
        FileError::of_file(path, format!("cannot be read as PNG: {error}"))
    };
    let damaged = |error: &DecodingError| match error {
        DecodingError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            at_fault(&"the picture ends too early: is all of the file there?")
        }
        DecodingError::Format(_) => at_fault(&"the picture is damaged: it must be written again"),
        error => at_fault(error),
    };
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    let mut reader = decoder.read_info().map_err(|error| damaged(&error))?;
    let size = [reader.info().width, reader.info().height];
    ImageSize::new(size[0], size[1]).map_err(|error| at_fault(&error))?;
    let length = reader.output_buffer_size().ok_or_else(|| at_fault(&"it is too large"))?;
    let mut buffer = vec![0; length];
    let info = reader.next_frame(&mut buffer).map_err(|error| damaged(&error))?;
    let bytes = &buffer[..info.buffer_size()];
    let pixels = match info.color_type {
        ColorType::Rgba => bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect(),
        ColorType::Rgb => bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2], 255]).collect(),
        ColorType::GrayscaleAlpha => {
            bytes.chunks_exact(2).map(|p| [p[0], p[0], p[0], p[1]]).collect()
        }
        _ => bytes.iter().map(|grey| [*grey, *grey, *grey, 255]).collect(),
    };
    Ok(Decoded { size, pixels })
}
