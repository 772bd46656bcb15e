//! Code for the current camera: in each language a short function from a pixel to its view ray, with this
//! camera's numbers and the lecture's names, to show on a slide or to run.
//!
//! All these programs contain the same few lines:
//!
//! ```text
//! u = width  * ((j + 0.5) / columns - 0.5)
//! v = height * (0.5 - (i + 0.5) / rows)
//! origin = eye        direction = u*U + v*V - distance*W
//! ```
//!
//! with row i and column j from 0, row 0 at the top. Capital U, V, W are the basis vectors, as in
//! the lecture's formula; columns and rows are the image's W and H, which could be confused with
//! the vectors. A language is a [`Format`] in [`LANGUAGES`] without conventions of its own; the
//! lecture's conventions apply.

use std::ops::RangeInclusive;

use pinhole_core::DVec3;

use crate::format::Format;
use crate::format::{ExportScene, Unsupported};
use crate::format::{commas_of, n, point};

/// Every language.
pub static LANGUAGES: [Format; 6] = [JULIA, NUMPY, GLM, GLSL, GLAM, JAVASCRIPT];

/// Julia, without packages.
const JULIA: Format = Format {
    name: "julia",
    label: "Julia",
    short: "Julia",
    file: "camera.jl",
    conventions: None,
    write: |subject, _| {
        in_double(
            subject,
            r#"const eye = [{eye}]
const U = [{u}]  # right
const V = [{v}]  # up in the image
const W = [{w}]  # backwards
const width, height, distance = {width}, {height}, {distance}  # of the viewport
const columns, rows = {columns}, {rows}  # of the image

"Origin and direction of the view ray of row i and column j, from 0, row 0 on top."
function ray(i, j)
    u = width * ((j + 0.5) / columns - 0.5)
    v = height * (0.5 - (i + 0.5) / rows)
    return eye, u * U + v * V - distance * W
end

if abspath(PROGRAM_FILE) == @__FILE__
    println(ray(0, 0))
end
"#,
        )
    },
};

/// Python with NumPy.
const NUMPY: Format = Format {
    name: "numpy",
    label: "Python + NumPy",
    short: "Python + NumPy",
    file: "camera.py",
    conventions: None,
    write: |subject, _| {
        in_double(
            subject,
            r#"import numpy as np

eye = np.array([{eye}])
U = np.array([{u}])  # right
V = np.array([{v}])  # up in the image
W = np.array([{w}])  # backwards
width, height, distance = {width}, {height}, {distance}  # of the viewport
columns, rows = {columns}, {rows}  # of the image


def ray(i, j):
    """Origin and direction of the view ray of row i and column j, from 0, row 0 on top."""
    u = width * ((j + 0.5) / columns - 0.5)
    v = height * (0.5 - (i + 0.5) / rows)
    return eye, u * U + v * V - distance * W


if __name__ == "__main__":
    print(ray(0, 0))
"#,
        )
    },
};

/// C++ with GLM.
const GLM: Format = Format {
    name: "glm",
    label: "C++ (GLM)",
    short: "C++ (GLM)",
    file: "camera.cpp",
    conventions: None,
    write: |subject, _| {
        in_double(
            subject,
            r#"#include <cstdio>
#include <glm/glm.hpp>

const glm::dvec3 eye({eye});
const glm::dvec3 U({u}); // right
const glm::dvec3 V({v}); // up in the image
const glm::dvec3 W({w}); // backwards
const double width = {width}, height = {height}, distance = {distance}; // of the viewport
const int columns = {columns}, rows = {rows}; // of the image

struct Ray {
    glm::dvec3 origin, direction;
};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {
    double u = width * ((j + 0.5) / columns - 0.5);
    double v = height * (0.5 - (i + 0.5) / rows);
    return {eye, u * U + v * V - distance * W};
}

int main() {
    glm::dvec3 d = ray(0, 0).direction;
    std::printf("%.17g %.17g %.17g\n", d.x, d.y, d.z);
}
"#,
        )
    },
};

/// GLSL: a fragment shader that shows each pixel's direction as a colour.
const GLSL: Format = Format {
    name: "glsl",
    label: "GLSL",
    short: "GLSL",
    file: "camera.frag",
    conventions: None,
    write: |subject, _| {
        in_single(
            subject,
            r"#version 330 core
out vec4 color;

const vec3 eye = vec3({eye});
const vec3 U = vec3({u}); // right
const vec3 V = vec3({v}); // up in the image
const vec3 W = vec3({w}); // backwards
const float width = {width}, height = {height}; // of the viewport
const float d = {distance}; // its distance; the word itself is a function here
const int columns = {columns}, rows = {rows}; // of the image

struct Ray {
    vec3 origin, direction;
};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {
    float u = width * ((float(j) + 0.5) / float(columns) - 0.5);
    float v = height * (0.5 - (float(i) + 0.5) / float(rows));
    return Ray(eye, u * U + v * V - d * W);
}

void main() {
    int i = rows - 1 - int(gl_FragCoord.y); // OpenGL counts rows from below
    int j = int(gl_FragCoord.x);
    color = vec4(0.5 + 0.5 * normalize(ray(i, j).direction), 1.0);
}
",
        )
    },
};

/// Rust with glam.
const GLAM: Format = Format {
    name: "glam",
    label: "Rust (glam)",
    short: "Rust (glam)",
    file: "camera.rs",
    conventions: None,
    write: |subject, _| {
        in_double(
            subject,
            r#"use glam::DVec3;

const EYE: DVec3 = DVec3::new({eye});
const U: DVec3 = DVec3::new({u}); // right
const V: DVec3 = DVec3::new({v}); // up in the image
const W: DVec3 = DVec3::new({w}); // backwards
const WIDTH: f64 = {width}; // of the viewport
const HEIGHT: f64 = {height};
const DISTANCE: f64 = {distance};
const COLUMNS: u32 = {columns}; // of the image
const ROWS: u32 = {rows};

/// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
fn ray(i: u32, j: u32) -> (DVec3, DVec3) {
    let u = WIDTH * ((f64::from(j) + 0.5) / f64::from(COLUMNS) - 0.5);
    let v = HEIGHT * (0.5 - (f64::from(i) + 0.5) / f64::from(ROWS));
    (EYE, u * U + v * V - DISTANCE * W)
}

fn main() {
    println!("{:?}", ray(0, 0));
}
"#,
        )
    },
};

/// JavaScript, without packages: in a page or in Node.
const JAVASCRIPT: Format = Format {
    name: "javascript",
    label: "JavaScript",
    short: "JavaScript",
    file: "camera.js",
    conventions: None,
    write: |subject, _| {
        in_double(
            subject,
            r"const eye = [{eye}];
const U = [{u}]; // right
const V = [{v}]; // up in the image
const W = [{w}]; // backwards
const [width, height, distance] = [{width}, {height}, {distance}]; // of the viewport
const [columns, rows] = [{columns}, {rows}]; // of the image

// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
function ray(i, j) {
  const u = width * ((j + 0.5) / columns - 0.5);
  const v = height * (0.5 - (i + 0.5) / rows);
  const direction = [0, 1, 2].map((k) => u * U[k] + v * V[k] - distance * W[k]);
  return [eye, direction];
}

console.log(ray(0, 0));
",
        )
    },
};

/// The range in which `f32` has its full precision, with a margin.
const SINGLE: RangeInclusive<f64> = 1e-37..=1e38;

/// Inserts a camera's numbers into a program, with the fewest decimals that read back to the same
/// `f64`.
fn in_double(subject: &ExportScene, program: &str) -> Result<String, Unsupported> {
    Ok(filled(subject, program, |x| point(n(x))))
}

/// Like [`in_double`], for GLSL, which calculates in `f32`.
///
/// # Errors
/// Returns an error if a number is outside the range of `f32`.
fn in_single(subject: &ExportScene, program: &str) -> Result<String, Unsupported> {
    let camera = subject.resolve();
    let viewport = camera.viewport();
    // A component of the eye that is too small may become 0.
    let eye = camera.eye().to_array().into_iter().filter(|x| x.abs() > 1.0).map(|x| ("eye", x));
    let numbers = eye.chain([
        ("the viewport's width", viewport.width),
        ("the viewport's height", viewport.height),
        ("the viewport's distance", viewport.distance),
    ]);
    if let Some((field, x)) = numbers.into_iter().find(|(_, x)| !SINGLE.contains(&x.abs())) {
        return Err(Unsupported(format!(
            "{field} has the number {}, and GLSL calculates in f32: it must be between 1e-37 and 1e38 in size",
            n(x)
        )));
    }
    // No reader needs to know of a negative zero.
    Ok(filled(subject, program, |x| point(format!("{:?}", x as f32 + 0.0))))
}

/// Replaces each placeholder with the camera's number. Real numbers get a point or an exponent, so that no
/// language parses them as integers; the image's columns and rows stay integers.
fn filled(subject: &ExportScene, program: &str, real: fn(f64) -> String) -> String {
    let camera = subject.resolve();
    let (basis, viewport, image) = (camera.basis(), camera.viewport(), camera.image());
    let three = |v: DVec3| commas_of(v, real);
    let numbers = [
        ("{eye}", three(camera.eye())),
        ("{u}", three(basis.u)),
        ("{v}", three(basis.v)),
        ("{w}", three(basis.w)),
        ("{width}", real(viewport.width)),
        ("{height}", real(viewport.height)),
        ("{distance}", real(viewport.distance)),
        ("{columns}", image.width().to_string()),
        ("{rows}", image.height().to_string()),
    ];
    let put = |program: String, (name, number): (&str, String)| program.replace(name, &number);
    numbers.into_iter().fold(program.to_owned(), put)
}
