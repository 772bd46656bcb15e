//! Reads and writes pictures as PNG.

use std::array;
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

/// Returns true if the bytes begin with the signature of PNG.
pub fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG\r\n\x1a\n")
}

/// Decodes any kind of PNG to the colours that it has over an opaque background, row by row from the top. Its
/// colours are assumed to be sRGB. `path` is used in messages.
///
/// # Errors
/// Returns an error if the bytes are not a PNG or are damaged, or if the picture's size is not that of `image`.
pub(crate) fn decode(
    path: &Path,
    bytes: &[u8],
    image: ImageSize,
    background: Rgb,
) -> Result<Vec<Rgb>, FileError> {
    let damaged = |error: DecodingError| {
        let problem = match &error {
            DecodingError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                "the picture ends too early: is all of the file there?".to_owned()
            }
            DecodingError::Format(_) => "the picture is damaged: it must be written again".into(),
            error => error.to_string(),
        };
        FileError::of_file(path, format!("cannot be read as PNG: {problem}"))
    };
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    // What is not used could take much more memory than the file.
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let header = decoder.read_header_info().map_err(damaged)?;
    let ([columns, rows], [width, height]) =
        ([header.width, header.height], [image.width(), image.height()]);
    if [columns, rows] != [width, height] {
        let problem = format!(
            "the picture has {columns} x {rows} pixels: it must have {width} x {height}, as the \
             scene's image has"
        );
        return Err(FileError::of_file(path, problem));
    }
    let mut reader = decoder.read_info().map_err(damaged)?;
    let mut buffer = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let info = reader.next_frame(&mut buffer).map_err(damaged)?;
    let bytes = &buffer[..info.buffer_size()];
    // The transformations leave no other kinds.
    Ok(match info.color_type {
        ColorType::Rgba => {
            bytes.chunks_exact(4).map(|p| over([p[0], p[1], p[2]], p[3], background)).collect()
        }
        _ => bytes.chunks_exact(2).map(|p| over([p[0]; 3], p[1], background)).collect(),
    })
}

/// Returns a colour with this opacity over an opaque background. It is not premultiplied.
fn over(front: Rgb, alpha: u8, back: Rgb) -> Rgb {
    let mix = |front: u8, back: u8| {
        let (front, back, alpha) = (u32::from(front), u32::from(back), u32::from(alpha));
        ((front * alpha + back * (255 - alpha) + 127) / 255) as u8
    };
    array::from_fn(|k| mix(front[k], back[k]))
}
