//! Writes the hits of the camera's rays, pixel by pixel, as OpenEXR.

use std::io::{self, BufWriter, Seek, Write};

use exr::prelude::*;
use pinhole_core::{Certificate, DVec3, Frame, Step};

/// Writes a frame that was traced with normals, and for each pixel a certificate, which says how its
/// hit was decided. The float channels are `t`, `N.X`, `N.Y`, `N.Z`, `u`, `v` and `margin`; the uint
/// channels are `object` and `step`.
///
/// (u, v) is the pixel's centre. If nothing is hit, `t` is infinite, the normal is zero, and `object`
/// is [`pinhole_core::NO_OBJECT`], 4294967295. `step` and `margin` are those of the [`Certificate`].
/// The step, the arithmetic that was needed to decide the hit, is 0 for `f64`, 1 for double-double and
/// 2 for exact integers; the margin is in bits.
///
/// # Errors
/// Returns an error if writing to `out` fails.
pub fn encode(
    out: impl Write + Seek,
    frame: &Frame<f32>,
    certificates: &[Certificate],
) -> io::Result<()> {
    let (rows, columns) = (frame.raster().rows(), frame.raster().columns());
    let camera = frame.camera();
    let floats = |name: &str, samples: Vec<f32>| AnyChannel::new(name, FlatSamples::F32(samples));
    let normals = |part: fn(&DVec3) -> f64| frame.normal.iter().map(|n| part(n) as f32).collect();
    let u: Vec<f32> = columns.iter().map(|column| camera.u_of_column(*column) as f32).collect();
    let v = rows.iter().map(|row| camera.v_of_row(*row) as f32);
    let channels = AnyChannels::sort(
        [
            floats("t", frame.t.clone()),
            floats("N.X", normals(|n| n.x)),
            floats("N.Y", normals(|n| n.y)),
            floats("N.Z", normals(|n| n.z)),
            floats("u", rows.iter().flat_map(|_| u.iter().copied()).collect()),
            floats("v", v.flat_map(|v| std::iter::repeat_n(v, columns.len())).collect()),
            floats("margin", certificates.iter().map(|pixel| pixel.margin as f32).collect()),
            AnyChannel::new("object", FlatSamples::U32(frame.object.clone())),
            AnyChannel::new("step", FlatSamples::U32(certificates.iter().map(number_of).collect())),
        ]
        .into_iter()
        .collect(),
    );
    let layer = Layer::new(
        (columns.len(), rows.len()),
        LayerAttributes::default(),
        // Rows are written in order, so that the file does not depend on the threads.
        Encoding { line_order: LineOrder::Increasing, ..Encoding::FAST_LOSSLESS },
        channels,
    );
    Image::from_layer(layer).write().to_buffered(BufWriter::new(out)).map_err(to_io)
}

/// Returns the number by which the file represents a certificate's step.
fn number_of(certificate: &Certificate) -> u32 {
    match certificate.step {
        Step::F64 => 0,
        Step::DoubleDouble => 1,
        _ => 2,
    }
}

fn to_io(error: Error) -> io::Error {
    match error {
        Error::Io(error) => error,
        other => io::Error::other(other),
    }
}
