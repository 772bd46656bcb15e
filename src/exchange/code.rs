//! Writes the current camera as code. In each language, it is a short function from a pixel to its view
//! ray, with this camera's numbers and the lecture's names, to be shown on a slide or run.
//!
//! All these programs contain the same few lines:
//!
//! ```text
//! u = width  * ((j + 0.5) / columns - 0.5)
//! v = height * (0.5 - (i + 0.5) / rows)
//! origin = eye        direction = u*U + v*V - distance*W
//! ```
//!
//! with row i and column j counted from 0, and row 0 at the top. Capital U, V, W are the basis vectors,
//! as in the lecture's formula. The image's size is called columns and rows rather than W and H,
//! because W is also a vector. The templates of the programs are in the folder `templates`. A language
//! is a [`Format`] without conventions of its own: it uses the lecture's.

use std::ops::RangeInclusive;

use crate::format::{ExportScene, ExtraValues, Format};
use crate::template::n;

/// All supported languages.
pub static LANGUAGES: &[Format] = &[
    language("julia", "Julia", "camera.jl", include_str!("templates/julia.txt")),
    language("numpy", "Python + NumPy", "camera.py", include_str!("templates/numpy.txt")),
    language("glm", "C++ (GLM)", "camera.cpp", include_str!("templates/glm.txt")),
    Format {
        extra: in_single,
        ..language("glsl", "GLSL", "camera.frag", include_str!("templates/glsl.txt"))
    },
    language("glam", "Rust (glam)", "camera.rs", include_str!("templates/glam.txt")),
    language("javascript", "JavaScript", "camera.js", include_str!("templates/javascript.txt")),
];

const fn language(
    name: &'static str,
    label: &'static str,
    file: &'static str,
    template: &'static str,
) -> Format {
    Format { name, label, short: label, file, template, ..Format::PLAIN }
}

/// The range of magnitudes in which `f32` has its full precision, with a safety margin.
const SINGLE: RangeInclusive<f64> = 1e-37..=1e38;

/// Checks that all numbers are within the range of `f32`, in which GLSL calculates.
fn in_single(subject: &ExportScene, _: &mut Vec<String>) -> Result<ExtraValues, String> {
    let camera = subject.resolve();
    let viewport = camera.viewport();
    // A component of the eye may be rounded to 0 if it is too small.
    let eye = camera.eye().to_array().into_iter().filter(|x| x.abs() > 1.0).map(|x| ("eye", x));
    let numbers = eye.chain([
        ("the viewport's width", viewport.width),
        ("the viewport's height", viewport.height),
        ("the viewport's distance", viewport.distance),
    ]);
    if let Some((field, x)) = numbers.into_iter().find(|(_, x)| !SINGLE.contains(&x.abs())) {
        return Err(format!(
            "{field} has the number {}, and GLSL calculates in f32: it must be between 1e-37 and 1e38 in size",
            n(x)
        ));
    }
    Ok(Vec::new())
}
