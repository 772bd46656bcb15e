//! A camera's numbers as they stand in code.

use pinhole_core::{DVec3, ResolvedCamera, shortest};

/// A language's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`: the numbers read back to the same ones.
    Double,
    /// `f32`, as shaders have them: rounded, the shortest decimals that read back to the same `f32`.
    Single,
}

/// The sizes of numbers that `f32` has with all its digits, with some room.
const SINGLE: std::ops::RangeInclusive<f64> = 1e-37..=1e38;

/// Every number of a camera by its name, as text: with a point or an exponent, so that no language takes
/// it for a whole one, but for the image's columns and rows, which are whole.
///
/// # Errors
/// Returns the field and the number that is out of range in this precision.
pub(super) fn numbers(
    camera: &ResolvedCamera,
    precision: Precision,
) -> Result<[(&'static str, String); 9], (&'static str, f64)> {
    let (basis, viewport, image) = (camera.basis(), camera.viewport(), camera.image());
    let fits = |x: f64| precision == Precision::Double || SINGLE.contains(&x.abs());
    let one = |field, x: f64| if fits(x) { Ok(real(x, precision)) } else { Err((field, x)) };
    let three = |v: DVec3| v.to_array().map(|x| real(x, precision)).join(", ");
    let eye = camera.eye();
    // A part of it that is too small is as good as 0.
    if let Some(x) = eye.to_array().into_iter().find(|x| x.abs() > 1.0 && !fits(*x)) {
        return Err(("eye", x));
    }
    Ok([
        ("eye", three(eye)),
        ("u", three(basis.u)),
        ("v", three(basis.v)),
        ("w", three(basis.w)),
        ("width", one("the viewport's width", viewport.width)?),
        ("height", one("the viewport's height", viewport.height)?),
        ("distance", one("the viewport's distance", viewport.distance)?),
        ("columns", image.width().to_string()),
        ("rows", image.height().to_string()),
    ])
}

fn real(x: f64, precision: Precision) -> String {
    let text = match precision {
        Precision::Double => shortest(x),
        // No reader needs to know of a negative zero.
        Precision::Single => format!("{:?}", x as f32 + 0.0),
    };
    if text.contains(['.', 'e']) { text } else { format!("{text}.0") }
}
