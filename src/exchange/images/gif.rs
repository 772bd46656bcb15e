//! Writes animations as GIF, which every presentation program can show.

use std::collections::HashMap;
use std::io::{self, Write};
use std::mem;

use color_quant::NeuQuant;
use gif::{Encoder, EncodingError, Frame, Repeat};

/// Maximum number of colours in a frame. The last of the 256 palette indices is reserved for pixels
/// that have not changed.
const COLORS: usize = 255;

/// Maximum number of frames per second, because players show each frame for at least two hundredths of
/// a second.
pub const MOST_PER_SECOND: u16 = 50;

/// Writes an animated GIF (GIF89a). It is opaque, with a palette of up to 255 colours for each frame.
pub struct Animated<W: Write> {
    encoder: Encoder<W>,
    size: [u16; 2],
    per_second: u32,
    done: u32,
    /// The previous frame; empty at the start.
    before: Vec<[u8; 4]>,
}

impl<W: Write> Animated<W> {
    /// Creates an animation of frames with this size in sRGB pixels and this number of frames per
    /// second. If `repeats` is true, the animation repeats forever; otherwise it is shown once.
    ///
    /// # Errors
    /// Returns an error if GIF does not allow the size or the number of frames per second, or if writing
    /// the header to `out` fails.
    pub fn new(out: W, size: [u32; 2], per_second: u16, repeats: bool) -> io::Result<Self> {
        let [Ok(width), Ok(height)] = size.map(u16::try_from) else {
            return Err(io::Error::other("GIF has at most 65535 columns and rows"));
        };
        if !(1..=MOST_PER_SECOND).contains(&per_second) {
            return Err(io::Error::other("GIF shows 1 to 50 frames a second"));
        }
        let mut encoder = Encoder::new(out, width, height, &[]).map_err(to_io)?;
        if repeats {
            encoder.set_repeat(Repeat::Infinite).map_err(to_io)?;
        }
        let per_second = u32::from(per_second);
        Ok(Animated { encoder, size: [width, height], per_second, done: 0, before: Vec::new() })
    }

    /// Writes the next frame. The opacity of its pixels is ignored.
    ///
    /// # Errors
    /// Returns an error if the frame has another size, or if writing fails.
    pub fn push(&mut self, pixels: &[[u8; 4]]) -> io::Result<()> {
        let [width, height] = self.size;
        if pixels.len() != usize::from(width) * usize::from(height) {
            return Err(io::Error::other("a frame of another size"));
        }
        let before = mem::replace(&mut self.before, pixels.to_vec());
        let is_same = |at: usize| before.get(at) == Some(&pixels[at]);
        let changed = (0..pixels.len()).filter(|at| !is_same(*at)).map(|at| pixels[at]);
        let FramePalette { mut colors, indices } = FramePalette::new(changed);
        let unchanged = (colors.len() / 3) as u8;
        colors.extend([0; 3]);
        let index = |at| if is_same(at) { unchanged } else { indices[&rgb(pixels[at])] };
        let frame = Frame {
            width,
            height,
            delay: self.delay(),
            transparent: Some(unchanged),
            palette: Some(colors),
            buffer: (0..pixels.len()).map(index).collect(),
            ..Frame::default()
        };
        self.done += 1;
        self.encoder.write_frame(&frame).map_err(to_io)
    }

    /// Returns the duration of the next frame, in hundredths of a second. It is rounded so that the
    /// errors do not accumulate.
    fn delay(&self) -> u16 {
        let end = |frame: u32| u64::from(frame) * 100 / u64::from(self.per_second);
        (end(self.done + 1) - end(self.done)) as u16
    }

    /// Finishes the animation and returns the underlying writer.
    ///
    /// # Errors
    /// Returns an error if writing fails.
    pub fn finish(self) -> io::Result<W> {
        self.encoder.into_inner().map_err(to_io)
    }
}

/// The palette of a frame.
struct FramePalette {
    /// Red, green and blue of each colour in the palette.
    colors: Vec<u8>,
    /// For each colour in the frame, the index of the palette's colour that replaces it.
    indices: HashMap<[u8; 3], u8>,
}

impl FramePalette {
    /// Creates the palette for a frame's pixels. It contains their own colours if these are few enough,
    /// and otherwise colours that a neural network learns from them (Dekker, *Kohonen neural networks
    /// for optimal colour quantization*, Network 5, 1994).
    fn new(pixels: impl Iterator<Item = [u8; 4]> + Clone) -> FramePalette {
        /// The network learns from one in this many pixels.
        const SAMPLED: i32 = 10;
        let mut indices = HashMap::new();
        let mut colors = Vec::new();
        for color in pixels.clone().map(rgb) {
            let next = indices.len();
            indices.entry(color).or_insert_with(|| {
                colors.extend(color);
                next.min(COLORS) as u8
            });
        }
        if indices.len() > COLORS {
            let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
            let sampled: Vec<u8> = pixels.map(rgb).flat_map(opaque).collect();
            let net = NeuQuant::new(SAMPLED, COLORS, &sampled);
            colors = net.color_map_rgb();
            indices
                .iter_mut()
                .for_each(|(color, index)| *index = net.index_of(&opaque(*color)) as u8);
        }
        FramePalette { colors, indices }
    }
}

fn rgb([r, g, b, _]: [u8; 4]) -> [u8; 3] {
    [r, g, b]
}

fn to_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}
