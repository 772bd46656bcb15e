//! The languages, each with its program. In the braces stand a camera's numbers.

use super::language::Language;
use super::numbers::Precision;

/// Every language.
pub static LANGUAGES: [Language; 6] = [JULIA, NUMPY, GLM, GLSL, GLAM, JAVASCRIPT];

/// Julia, without packages.
const JULIA: Language = Language {
    name: "julia",
    label: "Julia",
    file: "camera.jl",
    precision: Precision::Double,
    program: r#"const eye = [{eye}]
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
};

/// Python with NumPy.
const NUMPY: Language = Language {
    name: "numpy",
    label: "Python + NumPy",
    file: "camera.py",
    precision: Precision::Double,
    program: r#"import numpy as np

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
};

/// C++ with GLM.
const GLM: Language = Language {
    name: "glm",
    label: "C++ (GLM)",
    file: "camera.cpp",
    precision: Precision::Double,
    program: r#"#include <cstdio>
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
};

/// GLSL: a fragment shader that shows each pixel's direction as a colour.
const GLSL: Language = Language {
    name: "glsl",
    label: "GLSL",
    file: "camera.frag",
    precision: Precision::Single,
    program: r"#version 330 core
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
};

/// Rust with glam.
const GLAM: Language = Language {
    name: "glam",
    label: "Rust (glam)",
    file: "camera.rs",
    precision: Precision::Double,
    program: r#"use glam::DVec3;

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
};

/// JavaScript, without packages: in a page or in Node.
const JAVASCRIPT: Language = Language {
    name: "javascript",
    label: "JavaScript",
    file: "camera.js",
    precision: Precision::Double,
    program: r"const eye = [{eye}];
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
};
