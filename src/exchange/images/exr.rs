//! Writes the hits of the camera's rays, pixel by pixel, as OpenEXR.

use std::io::{self, BufWriter, Seek, Write};

use exr::block::lines::LineRefMut;
use exr::block::writer::ChunksWriter as _;
use exr::block::{UncompressedBlock, enumerate_ordered_header_block_indices};
use exr::meta::header::Header;
use exr::prelude::*;
use pinhole_core::{Certificate, Frame, ResolvedCamera, Step};
use rayon::prelude::*;

/// The channels in the file's order, which is that of their names.
const CHANNELS: [&str; 9] = ["N.X", "N.Y", "N.Z", "margin", "object", "step", "t", "u", "v"];

/// Writes the camera's picture. `bands` are its rows, traced with normals, and for each pixel a certificate,
/// which says how its hit was decided; each but the last consists of a multiple of 64 rows. The float channels
/// are `t`, `N.X`, `N.Y`, `N.Z`, `u`, `v` and `margin`; the uint channels are `object` and `step`.
///
/// (u, v) is the pixel's centre. If nothing is hit, `t` is infinite, the normal is zero, and `object`
/// is [`pinhole_core::NO_OBJECT`], 4294967295. `step` and `margin` are those of the [`Certificate`].
/// The step, the arithmetic that was needed to decide the hit, is 0 for `f64`, 1 for double-double and
/// 2 for exact integers; the margin is in bits.
///
/// # Errors
/// Returns an error if writing to `out` fails, or the error of a band.
pub fn encode(
    out: impl Write + Seek,
    camera: &ResolvedCamera,
    bands: impl Iterator<Item = io::Result<(Frame<f32>, Vec<Certificate>)>>,
) -> io::Result<()> {
    let [width, height] = [camera.image().width(), camera.image().height()];
    let u: Vec<f32> = (0..width).map(|column| camera.u_of_column(column) as f32).collect();
    let channels = CHANNELS.map(|name| {
        let is_uint = matches!(name, "object" | "step");
        ChannelDescription::named(name, if is_uint { SampleType::U32 } else { SampleType::F32 })
    });
    // By default, tiles of 64 x 64 pixels with run-length encoding.
    let size = Vec2(width as usize, height as usize);
    let mut header = Header::new("".into(), size, channels.into_iter().collect())
        .with_attributes(LayerAttributes::default());
    // Tiles are written in order, so that the file does not depend on the threads.
    header.line_order = LineOrder::Increasing;
    let headers = [header].into_iter().collect();
    let out = BufWriter::new(out);
    let written = exr::block::write(out, headers, true, |MetaData { headers, .. }, out| {
        let tiles: Vec<_> = enumerate_ordered_header_block_indices(&headers).collect();
        let mut left = &tiles[..];
        for band in bands {
            let (frame, certificates) = band?;
            let rows = frame.raster().rows();
            let end = rows.last().map_or(0, |row| *row as usize);
            let count = left.partition_point(|(_, at)| at.pixel_position.y() <= end);
            let fill = |line: LineRefMut<'_>| {
                let Vec2(x, y) = line.location.position;
                let at = (y - rows[0] as usize) * size.width() + x;
                let v = camera.v_of_row(y as u32) as f32;
                let filled = match line.location.channel {
                    axis @ 0..=2 => line.write_samples(|k| frame.normal[at + k][axis] as f32),
                    3 => line.write_samples(|k| certificates[at + k].margin as f32),
                    4 => line.write_samples(|k| frame.object[at + k]),
                    5 => line.write_samples(|k| number_of(&certificates[at + k])),
                    6 => line.write_samples(|k| frame.t[at + k]),
                    7 => line.write_samples(|k| u[x + k]),
                    _ => line.write_samples(|_| v),
                };
                debug_assert!(filled.is_ok(), "memory can be written");
            };
            let compressed = left[..count].par_iter().map(|(index, at)| {
                let tile = UncompressedBlock::from_lines(&headers[0].channels, *at, fill);
                Ok((*index, tile.compress_to_chunk(&headers)?))
            });
            for (index, chunk) in compressed.collect::<Result<Vec<_>>>()? {
                out.write_chunk(index, chunk)?;
            }
            left = &left[count..];
        }
        Ok(())
    });
    written.map_err(|error| match error {
        Error::Io(error) => error,
        other => io::Error::other(other),
    })
}

/// Returns the number by which the file represents a certificate's step.
fn number_of(certificate: &Certificate) -> u32 {
    match certificate.step {
        Step::F64 => 0,
        Step::DoubleDouble => 1,
        _ => 2,
    }
}
